// SPDX-License-Identifier: MIT
#include "asterism/mesh/fill/segment_intervals.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "asterism/mesh/numerics/constructions.hpp"
#include "asterism/mesh/numerics/metric_box.hpp"

namespace asterism::internal {
namespace {

constexpr vertex_index no_site = std::numeric_limits<vertex_index>::max();

}  // namespace

segment_intervals::segment_intervals(const domain& d, std::vector<division> divisions,
                                     const placed_sites& sites)
    : domain_(&d),
      sites_(&sites),
      divisions_(std::move(divisions)),
      index_(d.box()),
      at_division_(divisions_.size()) {}

void segment_intervals::start() {
  for (std::size_t s = 0; s < divisions_.size(); ++s) {
    const std::size_t points = divisions_[s].points.size();
    at_division_[s].assign(points, no_site);
    const segment& whole = domain_->segments[s];
    insert({s, 0, points - 1, whole.a, whole.b});
  }
}

bounding_box segment_intervals::box_of_interval(const interval& one) const {
  return box_of((*sites_)[one.a].position, (*sites_)[one.b].position);
}

void segment_intervals::index(std::size_t i) {
  index_.insert(static_cast<std::uint32_t>(i), box_of_interval(intervals_[i]));
}

void segment_intervals::insert(const interval& one) {
  intervals_.push_back(one);
  index(intervals_.size() - 1);
}

void segment_intervals::halve(double longest, placed_sites& sites, field_sampler& sampler) {
  for (std::size_t i = 0; i < intervals_.size();) {
    const interval now = intervals_[i];
    const division& d = divisions_[now.segment];
    if (now.last == now.first + 1 || d.lengths[now.last] - d.lengths[now.first] <= longest) {
      ++i;
      continue;
    }
    if (!sites.admits_another()) return;
    const std::size_t middle = now.first + (now.last - now.first) / 2;
    const auto s = sampler.at(d.points[middle]);
    if (!s) return;
    const vertex_index m = sites.place(*s, true);
    at_division_[now.segment][middle] = m;
    index_.remove(static_cast<std::uint32_t>(i), box_of_interval(now));
    intervals_[i] = {now.segment, now.first, middle, now.a, m};
    index(i);
    insert({now.segment, middle, now.last, m, now.b});
  }
}

bool segment_intervals::stays_clear(const site& s, double distance,
                                    std::uint64_t& looked_at) const {
  return index_.visit(box_around(s, distance), [&](std::uint32_t i) {
    ++looked_at;
    const site &a = (*sites_)[intervals_[i].a], &b = (*sites_)[intervals_[i].b];
    const point m = bisector_point(a, b);
    return squared_distance(s, m) > squared_distance(a, m);
  });
}

double segment_intervals::longest_segment() const {
  double longest = 0;
  for (const division& d : divisions_) longest = std::max(longest, d.lengths.back());
  return longest;
}

std::vector<std::vector<vertex_index>> segment_intervals::dividing_sites() const {
  std::vector<std::vector<vertex_index>> found(divisions_.size());
  for (std::size_t s = 0; s < divisions_.size(); ++s)
    for (const vertex_index m : at_division_[s])
      if (m != no_site) found[s].push_back(m);
  return found;
}

}  // namespace asterism::internal
