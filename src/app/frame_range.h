#pragma once

#include <string>
#include <vector>

#include "app/options.h"

namespace drape::app {

// The frames that a text like "1-100", "1-100x5" or "1,5,9-12" names: ascending, each once. Throws InputError
// where the text is no such list, or names a frame outside [first, last].
std::vector<int> parse_frames(const std::string& text, int first, int last);

// All frames of [first, last].
std::vector<int> all_frames(int first, int last);

// "2/8" -> {2, 8}. Throws InputError.
Chunk parse_chunk(const std::string& text);

// The chunk's run of neighbouring frames; the chunks of a job share out all frames, none twice.
std::vector<int> frames_of_chunk(const std::vector<int>& frames, const Chunk& chunk);

// "1280x720" -> "[1280, 720]". Throws InputError.
std::string resolution_as_yaml(const std::string& text);

}  // namespace drape::app
