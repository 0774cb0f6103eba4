#pragma once

#include "mesh/ply_header.h"

namespace drape {

// The values behind a PLY header, one after another.
class PlyValues {
 public:
  // `words` stands behind the header of `content`.
  PlyValues(std::string_view content, const WordReader& words, PlyFormat format,
            const std::filesystem::path& path);

  // What is being read, for messages: row `row` (from 0) of `element`.
  void set_row(const PlyElement& element, long long row);

  double next(PlyType type);
  // An integer from 0 to `most`; `what` names it in the refusal of any other value.
  long long next_integer(PlyType type, long long most, const char* what);
  // The number of values of a list, at most as many as there can be in the rest of the file.
  long long next_list_count(const PlyProperty& list);

  // Refuses an element whose rows cannot all be in the rest of the file.
  void check_fits(const PlyElement& element);

  // Throws InputError at the last value.
  [[noreturn]] void refuse_row(const std::string& message) const;

 private:
  long long remaining() const;
  long long least_size(PlyType type) const;
  double next_word();
  double next_bytes(PlyType type);

  std::string_view bytes_;  // of the binary formats: what is left
  WordReader words_;
  PlyFormat format_;
  const std::filesystem::path& path_;
  const PlyElement* element_ = nullptr;
  long long row_ = 0;
  Word last_;  // ascii: the last word
};

}  // namespace drape
