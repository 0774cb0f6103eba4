#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace drape {

// Numbers 0 to count - 1 in sets that can be joined; a set is named by its smallest member.
struct DisjointSets {
  explicit DisjointSets(int count) : parent(count) { std::iota(parent.begin(), parent.end(), 0); }

  int find(int member) {
    while (parent[member] != member) member = parent[member] = parent[parent[member]];
    return member;
  }

  void join(int a, int b) {
    const auto [low, high] = std::minmax({find(a), find(b)});
    parent[high] = low;
  }

  std::vector<int> parent;
};

}  // namespace drape
