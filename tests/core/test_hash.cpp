#include <gtest/gtest.h>

#include "core/hash.h"

namespace drape {
namespace {

// XXH3's published value for no bytes (xxHash, doc and tests/sanity_test_vectors.h).
TEST(Hash, KnownValue) { EXPECT_EQ(hash_bytes(nullptr, 0), 0x2d06800538d394c2u); }

TEST(Hash, PiecesGiveTheHashOfTheWhole) {
  const std::string text(1000, 'x');
  Hasher hasher;
  for (std::size_t at = 0; at < text.size(); at += 125) hasher.add(text.data() + at, 125);
  EXPECT_EQ(hasher.digest(), hash_bytes(text.data(), text.size()));
  EXPECT_EQ(hasher.digest(), hasher.digest());
}

TEST(Hash, OrderMatters) { EXPECT_NE(hash_bytes("ab", 2), hash_bytes("ba", 2)); }

TEST(Hash, AsSixteenDigits) {
  EXPECT_EQ(to_hex(0), "0000000000000000");
  EXPECT_EQ(to_hex(0x1234abcd), "000000001234abcd");
  EXPECT_EQ(to_hex(~std::uint64_t{0}), "ffffffffffffffff");
}

}  // namespace
}  // namespace drape
