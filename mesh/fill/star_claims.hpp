// SPDX-License-Identifier: MIT
//
// Lists which sites may change which stars, in compact form: a fill of a million sites lists
// several millions of such claims at its peak of memory.
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

  // Returns the sites that claim the star with this number in `stars`.
  std::span<const vertex_index> of(std::size_t nth) const {
    return std::span(by).subspan(starts[nth], starts[nth + 1] - starts[nth]);
  }
};

// Lists claims in the order in which they are made, those of one site together.
class claim_list {
 public:
  // Bound of the numbers of sites and stars; the bit above is used as a mark.
  static constexpr std::size_t most_sites = std::size_t{1} << 31;

  // Adds a claim of the site to the star.
  void add(vertex_index star, vertex_index by) {
    if (size_ == 0 || by != last_) entries_.push_back(by | marks_a_site);
    last_ = by;
    entries_.push_back(star);
    ++size_;
  }
  // Adds all claims of the other list.
  void append(const claim_list& other);
  void reserve(std::size_t entries) { entries_.reserve(entries); }

  // Returns the number of claims.
  std::size_t size() const { return size_; }
  // Returns the number of entries that hold the claims: one for each claim, and one for each site
  // that makes any.
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

// Returns the claims to the stars of a range, sorted by star; claims to one star keep the order of
// the list.
claims_by_star sort_by_star(const claim_list& claims, std::size_t first, std::size_t last);

}  // namespace asterism::internal
