// SPDX-License-Identifier: MIT
//
// Lists which sites lay claim to which stars, in little room: a fill of a million sites lists
// several millions at the moment when it holds most.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

// Lists, for each star, the sites that claim to be among its neighbours.
struct claims_by_star {
  std::vector<vertex_index> stars;    // ascending, each once
  std::vector<std::uint32_t> starts;  // of each star's claims in `by`, and the end
  std::vector<vertex_index> by;

  // Returns the sites that lay claim to the star with this number in `stars`.
  std::span<const vertex_index> of(std::size_t nth) const {
    return std::span(by).subspan(starts[nth], starts[nth + 1] - starts[nth]);
  }
};

// Lists claims in the order in which they are laid, those of one site together.
class claim_list {
 public:
  // Sites and stars have numbers below this.
  static constexpr std::size_t most_sites = std::size_t{1} << 31;

  // Adds that the site lays claim to the star.
  void add(vertex_index star, vertex_index by) {
    if (size_ == 0 || by != last_) entries_.push_back(by | marks_a_site);
    last_ = by;
    entries_.push_back(star);
    ++size_;
  }
  // Adds what the other list holds.
  void append(const claim_list& other);
  void reserve(std::size_t entries) { entries_.reserve(entries); }

  // Returns how many claims there are.
  std::size_t size() const { return size_; }
  // Returns how many numbers hold them: one for each claim, and one for each site that lays some.
  std::size_t entries() const { return entries_.size(); }

  // Calls visit(star, by) for each claim, in their order.
  template <class Visit>
  void for_each(const Visit& visit) const {
    vertex_index by = 0;
    for (const vertex_index entry : entries_) {
      if ((entry & marks_a_site) != 0)
        by = entry & ~marks_a_site;
      else
        visit(entry, by);
    }
  }

 private:
  static constexpr vertex_index marks_a_site = vertex_index{1} << 31;
  std::vector<vertex_index> entries_;  // a site, marked, and then the stars that it lays claim to
  std::size_t size_ = 0;
  vertex_index last_ = 0;
};

// Returns the claims to stars from `first` to before `last` by their stars, and those to one star
// in the order of the list.
claims_by_star sort_by_star(const claim_list& claims, std::size_t first, std::size_t last);

}  // namespace asterism::internal
