// SPDX-License-Identifier: MIT
//
// Keeps the sites of a mesh being refined, each with the field's metric, and an index of sites and
// subsegments by place.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/stars/proximity.hpp"

namespace asterism::internal {

class site_set {
 public:
  // Takes the domain's vertices as the first sites. `field` must outlive the set. Fails where the
  // field does.
  static result<site_set> start(const domain& d, const metric_field& field, std::size_t most_sites);

  const std::vector<site>& all() const { return sites_; }
  // True if all sites have the same tensor, bit for bit.
  bool has_one_metric() const { return has_one_metric_; }
  bool is_full() const { return sites_.size() >= most_sites_; }
  // Lowers the limit on sites to this number.
  void limit(std::size_t most_sites) { most_sites_ = std::min(most_sites_, most_sites); }
  // Returns the index of sites and subsegments by place. The boundary, which splits subsegments,
  // updates it.
  const proximity& near() const { return near_; }
  proximity& near() { return near_; }
  void index(const boundary& edges) { near_ = proximity(sites_, edges); }
  // Frees the index. No site may be added, and no search made, from then on.
  void forget_index() { near_ = {}; }
  // Reserves room for this number of sites, and for the few that refinement adds to them: without
  // it all sites would be held twice while the list grows.
  void reserve(std::size_t more) {
    const std::size_t expected = sites_.size() + more;
    sites_.reserve(std::min(expected + expected / 16, most_sites_));
  }

  // Returns the site at q with the field's metric; none where the field fails.
  std::optional<site> site_at(const point& q);
  // Returns the error of the field at a point that was tried, if there was one; refinement must end
  // then.
  const std::optional<error>& field_failure() const { return field_failure_; }
  // True if s is farther than this distance from every site, by the metrics of both.
  bool is_farther(const site& s, double distance) const;

  // Adds a site and returns its index.
  vertex_index add(const site& s);
  // Renumbers some of the sites among themselves, along a curve, so that near sites are near in
  // memory. Takes their numbers in ascending order; returns the new number of each site.
  std::vector<vertex_index> number_along_curve(const std::vector<vertex_index>& which);

 private:
  site_set(const metric_field& field, std::size_t most_sites)
      : field_(&field), most_sites_(most_sites) {}

  const metric_field* field_;
  std::size_t most_sites_;
  void push(const site& s) {
    sites_.push_back(s);
    has_one_metric_ = has_one_metric_ && identical(s.metric, sites_.front().metric);
  }

  std::vector<site> sites_;
  bool has_one_metric_ = true;
  proximity near_;
  std::optional<error> field_failure_;
};

}  // namespace asterism::internal
