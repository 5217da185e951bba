// SPDX-License-Identifier: MIT
//
// Holds faces of a triangulation that are to be mended, those with the shortest edges first.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

struct bad_face {
  std::uint64_t rank;
  triangle where;
  std::uint32_t face;
  // Orders the heap so that the least rank comes first.
  bool operator<(const bad_face& other) const {
    return std::tie(rank, where) > std::tie(other.rank, other.where);
  }
};

// Ranks faces by the class of their shortest edge, within a class as if at random. Starting at
// short edges lets sizes grow from these: with the smallest angle first a noisy ring of 10,000
// vertices took 17,206 sites in place of 16,069. The random order is for boundaries whose edges
// grow steadily. In the order of lengths alone each new site would be put beside a site that nearly
// all vertices have as a neighbour, and take over nearly all of its edges: a circle of 30,000 such
// edges takes 6.9 seconds, in classes 0.9. The source of the random order is that of triangulate()
// (stars/site_triangulation.cpp).
class bad_face_queue {
 public:
  bool empty() const { return heap_.empty(); }

  // Adds a face by the square of its shortest edge. Removes the faces for which has_gone() is true,
  // once such faces may be more than half of the queue.
  template <class HasGone>
  void push(const triangle& where, std::uint32_t face, double squared_shortest_edge,
            const HasGone& has_gone) {
    heap_.push_back({rank_of(where, squared_shortest_edge), where, face});
    std::push_heap(heap_.begin(), heap_.end());
    if (heap_.size() < room_) return;
    std::erase_if(heap_, has_gone);
    std::make_heap(heap_.begin(), heap_.end());
    room_ = std::max(room_, 2 * heap_.size());
  }

  bad_face pop() {
    std::pop_heap(heap_.begin(), heap_.end());
    const bad_face first = heap_.back();
    heap_.pop_back();
    return first;
  }

 private:
  // Returns a rank: the class of a length, and below it 32 bits as if at random. There are eight
  // classes to a factor of two of the squared length: the exponent of the double and three bits of
  // its mantissa are the class. From 10,000 random sites in swirl:12 with 30 degrees, one class to
  // a factor of two makes 32,124 sites, two make 31,738, eight 31,770 and sixteen 31,772.
  static std::uint64_t rank_of(const triangle& where, double squared_length) {
    constexpr int mantissa_bits = 52, bits_of_class = 3, shift_for_random = 32;
    const std::uint64_t length_class =
        std::bit_cast<std::uint64_t>(squared_length) >> (mantissa_bits - bits_of_class);
    std::uint64_t bits = 0;
    for (const vertex_index v : where) {
      bits = (bits ^ (v + std::uint64_t{1})) * 0x9e3779b97f4a7c15U;
      bits ^= bits >> 29;
    }
    return length_class << shift_for_random | bits >> shift_for_random;
  }

  std::vector<bad_face> heap_;
  std::size_t room_ = 4096;  // entries, from which on it is looked for those that have gone
};

}  // namespace asterism::internal
