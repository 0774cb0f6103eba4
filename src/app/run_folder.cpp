#include "app/run_folder.h"

#include <fmt/format.h>

namespace drape::app {

std::string frame_file_name(int frame, const std::string& ending) {
  return fmt::format("frame_{:04}{}", frame, ending);
}

}  // namespace drape::app
