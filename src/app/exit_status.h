#pragma once

namespace drape::app {

// What the program tells its caller; documented in the README.
enum class ExitStatus {
  done = 0,
  differs = 1,             // a comparison failed
  usage = 2,               // the command line or the scene has mistakes
  file = 3,                // a file can't be read or written
  simulation = 4,          // the simulation failed, or a frame is not certified
  limit = 5,               // memory, or what the off-screen renderer can do
  encoder = 6,             // ffmpeg is missing or failed
  internal = 70,           // a fault in Drape itself
  stopped_by_signal = 128  // plus the signal's number
};

}  // namespace drape::app
