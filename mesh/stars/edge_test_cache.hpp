// SPDX-License-Identifier: MIT
//
// Remembers answers of edge_test. Two stars pose the same question on the edge between them, and
// rebuilt stars pose it again: a third of all tests of a refinement are repeats, and exact
// arithmetic costs milliseconds.
//
// An answer depends on four sites alone, which never change, so it never goes stale. The table has
// a fixed number of places, each with the last question that was stored in it; forgetting only
// costs time. A cache must not be shared by threads.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

class edge_test_cache {
 public:
  // Makes a cache with many places for a whole refinement, or few for the stars of a chunk.
  // Allocates at the first question.
  enum class extent : unsigned { few = 1U << 10, many = 1U << 14 };
  explicit edge_test_cache(extent places = extent::many) : extent_(places) {}

  // Returns the answer for v, w, x, y; calls `ask` if it is not known. Exchanging v and w, or x and
  // y, does not change the question. Requires four distinct indices.
  template <class Ask>
  bool recall(vertex_index v, vertex_index w, vertex_index x, vertex_index y, Ask ask) {
    if (places_.empty()) places_.resize(static_cast<std::size_t>(extent_));
    if (w < v) std::swap(v, w);
    if (y < x) std::swap(x, y);
    place& p = places_[place_of(v, w, x, y)];
    const std::array<vertex_index, 4> question{v, w, x, y};
    if (p.question != question) p = {question, ask()};
    return p.answer;
  }

 private:
  struct place {
    std::array<vertex_index, 4> question{};  // four zeros: none
    bool answer = false;
  };

  std::size_t place_of(vertex_index v, vertex_index w, vertex_index x, vertex_index y) const {
    const std::uint64_t a = (std::uint64_t{v} << 32 | w) * 0x9e3779b97f4a7c15u;
    const std::uint64_t b = ((std::uint64_t{x} << 32 | y) ^ (a >> 29)) * 0xbf58476d1ce4e5b9u;
    return static_cast<std::size_t>((a ^ b) >> 40) & (places_.size() - 1);
  }

  extent extent_;
  std::vector<place> places_;
};

}  // namespace asterism::internal
