#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace drape {

struct EncodingFault {
  int line = 1;  // both count from 1
  int column = 1;
  std::string message;
};

// The first byte of a text that is not UTF-8 (RFC 3629), or is a control character other than tab and line
// ends.
std::optional<EncodingFault> find_encoding_fault(std::string_view text);

}  // namespace drape
