// SPDX-License-Identifier: MIT
//
// Sets of small integers that are joined, and never divided.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace asterism::internal {

class joined_sets {
 public:
  explicit joined_sets(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  // Returns the least element of the set that this one is in.
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t i, std::size_t j) {
    const auto [low, high] = std::minmax({find(i), find(j)});
    parent_[high] = low;
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace asterism::internal
