#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/console.h"
#include "app/run.h"

namespace drape::app {

// Makes the video of all frames of the scene by ffmpeg. Throws FileError where a picture is missing or of
// another size than the rest, or the record is of other settings, EncoderError where ffmpeg is missing,
// fails, or drops frames; the pictures stay.
void encode(Run& run, const Console& console);

// The words of the ffmpeg call that writes the video to `target`.
std::vector<std::string> encoder_arguments(const Run& run, const std::filesystem::path& target);

}  // namespace drape::app
