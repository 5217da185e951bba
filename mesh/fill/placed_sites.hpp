// SPDX-License-Identifier: MIT
//
// Keeps the sites that a fill has placed so far, and finds them by their place.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/search/site_index.hpp"
#include "asterism/mesh/support/parallel_for.hpp"

namespace asterism::internal {

class placed_sites {
 public:
  // Makes an empty list with an index for the box, for at most `most` sites.
  placed_sites(const bounding_box& box, std::size_t most)
      : index_(box, site_index::purpose::places), most_(most) {}

  // Returns the sites in the order in which they were placed, the domain's vertices first.
  const std::vector<site>& all() const { return sites_; }
  const site& operator[](vertex_index v) const { return sites_[v]; }
  std::size_t size() const { return sites_.size(); }
  const site_index& index() const { return index_; }
  // Frees the index. From then on no site may be placed, and index() not be used.
  void forget_index() { index_ = {}; }
  // True if site v divides a segment or is a vertex of the domain.
  bool is_on_segment(vertex_index v) const { return on_segment_[v] != 0; }
  std::size_t count_on_segments() const {
    return static_cast<std::size_t>(std::count(on_segment_.begin(), on_segment_.end(), 1));
  }

  // Records which of the domain's vertices are on no segment. Requires that all of them are placed.
  void mark_isolated(const domain& d) {
    isolated_.assign(d.vertices.size(), 1);
    for (const segment& one : d.segments) isolated_[one.a] = isolated_[one.b] = 0;
  }
  // True for vertices of the domain that are on no segment.
  bool is_isolated(vertex_index v) const { return v < isolated_.size() && isolated_[v] != 0; }

  // True if there is room for another site. Must be called before one is placed. Remembers a
  // refusal.
  bool admits_another() {
    exhausted_ = exhausted_ || sites_.size() >= most_;
    return !exhausted_;
  }
  // True once a site was refused for want of room.
  bool is_exhausted() const { return exhausted_; }

  // Reserves room for this number of sites: a list that grows by itself is held twice meanwhile.
  void reserve(std::size_t count) {
    sites_.reserve(std::min(count, most_));
    on_segment_.reserve(std::min(count, most_));
  }

  vertex_index place(const site& s, bool on_segment) {
    const vertex_index w = place_later(s, on_segment);
    index_.insert(sites_, w);
    return w;
  }
  // Places a site that index() finds only after the next call of find_from().
  vertex_index place_later(const site& s, bool on_segment) {
    const auto w = static_cast<vertex_index>(sites_.size());
    sites_.push_back(s);
    on_segment_.push_back(on_segment ? 1 : 0);
    return w;
  }
  // Moves a site. Requires that the index was freed.
  void move(vertex_index v, const site& to) { sites_[v] = to; }
  // Adds the sites from that number on to the index, and to a second index unless it is null.
  void find_from(vertex_index first, site_index* another) {
    const auto add_to = [this, first](site_index& to) {
      for (vertex_index w = first; w < sites_.size(); ++w) to.insert(sites_, w);
    };
    if (another == nullptr) return add_to(index_);
    parallel_for(2, [&](std::size_t i) { add_to(i == 0 ? index_ : *another); });
  }

 private:
  std::vector<site> sites_;
  std::vector<char> on_segment_;
  std::vector<char> isolated_;  // by vertex of the domain
  site_index index_;
  std::size_t most_;
  bool exhausted_ = false;
};

}  // namespace asterism::internal
