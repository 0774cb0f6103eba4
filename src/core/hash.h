#pragma once

// The only file pair that includes xxhash.

#include <cstddef>
#include <cstdint>
#include <string>

namespace drape {

// A running 64-bit XXH3 hash of bytes. Order matters; equal bytes in equal order give equal hashes anywhere.
class Hasher {
 public:
  Hasher();
  ~Hasher();
  Hasher(const Hasher&) = delete;
  Hasher& operator=(const Hasher&) = delete;
  void add(const void* data, std::size_t size);
  std::uint64_t digest() const;

 private:
  void* state_;
};

std::uint64_t hash_bytes(const void* data, std::size_t size);

// Sixteen lower-case hexadecimal digits.
std::string to_hex(std::uint64_t hash);

}  // namespace drape
