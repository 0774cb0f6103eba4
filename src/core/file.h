#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace drape {

// The whole content of a regular file. Throws FileError.
std::string read_file(const std::filesystem::path& path);

// Throws FileError where the path, or one that it would lie in, is there and no folder, or is a link to
// nothing.
void refuse_file_as_folder(const std::filesystem::path& folder);

// Writes aside and renames: after this call, and after any crash in it, the file is whole or as it was
// before. Makes the folders that are missing; refuses to replace a device or a pipe. Throws FileError (which
// names the path and, for example, "No space left").
void write_file(const std::filesystem::path& path, std::string_view content);

}  // namespace drape
