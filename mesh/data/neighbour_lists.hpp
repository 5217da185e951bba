// SPDX-License-Identifier: MIT
//
// Keeps a list of vertices for each of many vertices, one after the other in one array.
#pragma once

#include <cstddef>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

class neighbour_lists {
 public:
  neighbour_lists() = default;
  // Makes one list for each entry of `lengths`, of that length, filled with vertex 0.
  explicit neighbour_lists(std::vector<std::size_t> lengths) : ends_(std::move(lengths)) {
    std::partial_sum(ends_.begin(), ends_.end(), ends_.begin());
    if (!ends_.empty()) all_.resize(ends_.back());
  }

  std::size_t size() const { return ends_.size(); }
  // Returns list i; empty beyond the last.
  std::span<const vertex_index> operator[](std::size_t i) const {
    if (i >= ends_.size()) return {};
    const std::size_t begin = i == 0 ? 0 : ends_[i - 1];
    return std::span(all_).subspan(begin, ends_[i] - begin);
  }

  // Returns list i, which must exist, to be filled in.
  std::span<vertex_index> list(std::size_t i) {
    const std::size_t begin = i == 0 ? 0 : ends_[i - 1];
    return std::span(all_).subspan(begin, ends_[i] - begin);
  }

  // Reserves room for this number of lists of the average number of a site's neighbours.
  void reserve(std::size_t lists) {
    constexpr std::size_t neighbours = 6;
    ends_.reserve(lists);
    all_.reserve(neighbours * lists);
  }
  // Adds a vertex to the list that the next end_list() completes.
  void add(vertex_index v) { all_.push_back(v); }
  void end_list() { ends_.push_back(all_.size()); }
  // Removes the vertices added to the list since the last end_list().
  void clear_list() { all_.resize(ends_.empty() ? 0 : ends_.back()); }

  // Reserves room for a mark on each present list; none is marked.
  void make_room_for_marks() { marks_.assign(ends_.size(), 0); }
  // Marks list i, for which room must be reserved; several threads may mark different lists. The
  // meaning of a mark is defined by the maker of the lists.
  void mark(std::size_t i) { marks_[i] = 1; }
  bool is_marked(std::size_t i) const { return i < marks_.size() && marks_[i] != 0; }

 private:
  std::vector<std::size_t> ends_;
  std::vector<vertex_index> all_;
  std::vector<char> marks_;  // by list, or empty
};

}  // namespace asterism::internal
