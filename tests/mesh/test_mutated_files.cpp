#include <gtest/gtest.h>

#include <random>

#include "core/error.h"
#include "mesh/manifold.h"
#include "mesh/mesh_bytes.h"
#include "mesh/obj_reader.h"
#include "mesh/ply_reader.h"

namespace drape {
namespace {

// Fixed generator and arithmetic: the standard's distributions differ between libraries.
class Mutator {
 public:
  std::string operator()(std::string bytes) {
    for (std::size_t changes = 1 + below(4); changes > 0 && !bytes.empty(); --changes) change(bytes);
    return bytes;
  }

 private:
  std::size_t below(std::size_t bound) { return random_() % bound; }

  void change(std::string& bytes) {
    const std::size_t at = below(bytes.size());
    switch (below(6)) {
      case 0:
        bytes[at] = static_cast<char>(below(256));
        break;
      case 1:
        bytes[at] = static_cast<char>(bytes[at] ^ (1u << below(8)));
        break;
      case 2:
        bytes.erase(at, 1 + below(8));
        break;
      case 3:
        bytes.insert(at, bytes.substr(below(bytes.size()), below(40)));
        break;
      case 4:
        bytes.resize(at);
        break;
      default:
        bytes.insert(at, pieces_[below(pieces_.size())]);
        break;
    }
  }

  std::mt19937_64 random_{2005};
  const std::vector<std::string> pieces_ = {"-",      "9",     "999999999", " ",    "\n", "/",
                                            "nan",    "1e400", "0x",        "list", "-1", "\xff\xff",
                                            "double", "\r",    "#",         "."};
};

template <typename Read>
void expect_read_or_refused(const std::string& original, Read read) {
  Mutator mutated;
  int accepted = 0;
  for (int i = 0; i < 20000; ++i) {
    try {
      const TriangleMesh mesh = weld(read(mutated(original), "a"));
      check_manifold(mesh);
      ++accepted;
    } catch (const InputError&) {
    }
  }
  EXPECT_GT(accepted, 0);
  EXPECT_LT(accepted, 20000);
}

TEST(MutatedFiles, Obj) { expect_read_or_refused(test::square_obj, read_obj); }
TEST(MutatedFiles, AsciiPly) { expect_read_or_refused(test::square_ply, read_ply); }
TEST(MutatedFiles, LittleEndianPly) { expect_read_or_refused(test::square_binary_ply(false), read_ply); }
TEST(MutatedFiles, BigEndianPly) { expect_read_or_refused(test::square_binary_ply(true), read_ply); }

}  // namespace
}  // namespace drape
