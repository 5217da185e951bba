// SPDX-License-Identifier: MIT
#include "asterism/mesh/stars/nearest_distances.hpp"

#include <algorithm>
#include <cmath>

#include "asterism/mesh/numerics/constructions.hpp"
#include "asterism/mesh/numerics/metric_box.hpp"
#include "asterism/mesh/support/infinity.hpp"

namespace asterism::internal {
namespace {

// Returns the squared distance from s to the segment a b, as s measures it. If s is on the segment
// but for the rounding of the nearest point, returns the squared length of that rounding.
double squared_distance_to_segment(const site& s, const point& a, const point& b) {
  const point d{b.x - a.x, b.y - a.y}, e{s.position.x - a.x, s.position.y - a.y};
  const double t =
      std::clamp(inner_product(s.metric, d, e) / squared_length(s.metric, d), 0.0, 1.0);
  const point q{a.x + t * d.x, a.y + t * d.y};
  const double x = 0x1p-52 * std::max(std::abs(a.x), std::abs(b.x));
  const double y = 0x1p-52 * std::max(std::abs(a.y), std::abs(b.y));
  const bool on_it =
      std::abs(s.position.x - q.x) <= x && std::abs(s.position.y - q.y) <= y && (x > 0 || y > 0);
  return on_it ? s.metric.m11 * x * x + s.metric.m22 * y * y : squared_distance(s, q);
}

// Returns the least squared distance of neighbours in an order along a space-filling curve. It is
// seldom much more than the least of all pairs, so that the searches that follow stay small.
double least_along(const std::vector<vertex_index>& order, const std::vector<site>& sites) {
  double least = infinity;
  for (std::size_t i = 1; i < order.size(); ++i) {
    const site &before = sites[order[i - 1]], &s = sites[order[i]];
    least = std::min(
        {least, squared_distance(s, before.position), squared_distance(before, s.position)});
  }
  return least;
}

// Returns the squared distance between v and the nearest other site, by the metric of v or of that
// site, whichever gives less; at most `most`. Both searches go twice as far as the radius within
// which they must find all sites: that covers roundings.
double nearest_other(const std::vector<site>& sites, const site_index& near, vertex_index v,
                     double most) {
  const site& s = sites[v];
  double nearest = most;
  const auto look = [&](vertex_index w) {
    if (w != v)
      nearest = std::min({nearest, squared_distance(s, sites[w].position),
                          squared_distance(sites[w], s.position)});
    return true;
  };
  double radius = near.spacing_near(s);
  if (!(radius > 0)) radius = std::sqrt(std::min(most, 1.0));
  constexpr int most_searches = 64;
  for (int search = 0; search < most_searches && radius * radius < infinity; ++search) {
    near.visit_reach(sites, s, radius, look);
    near.visit_seeing(s.position, 2 * radius, look);
    if (nearest <= radius * radius) return nearest;
    radius = nearest < infinity ? std::sqrt(nearest) * (1 + 0x1p-20) : 4 * radius;
  }
  for (vertex_index w = 0; w < sites.size(); ++w) look(w);
  return nearest;
}

// Returns the least squared distance of two sites, at most `least`, as either measures it. Searches
// a little beyond `least`, so that sites that are not found are farther, whatever the roundings of
// distances.
double least_of_pairs(const std::vector<site>& sites, const site_index& near, double least) {
  constexpr double margin = 1 + 0x1p-20;
  double look = margin * std::sqrt(least);
  near.visit_pairs(look, [&](vertex_index v, vertex_index w) {
    const double nearer = std::min(squared_distance(sites[v], sites[w].position),
                                   squared_distance(sites[w], sites[v].position));
    if (!(nearer < least)) return;
    least = nearer;
    look = margin * std::sqrt(least);
  });
  return least;
}

// Returns the least squared distance of v from a subsegment near the box that has no end at v; at
// most `most`.
double least_to_subsegments(const std::vector<site>& sites, vertex_index v, const boundary& edges,
                            const proximity& near, const bounding_box& around, double least) {
  near.subsegments().visit(around, [&](std::uint32_t i) {
    const boundary_edge& p = edges.subsegments()[i];
    if (p.a != v && p.b != v)
      least = std::min(
          least, squared_distance_to_segment(sites[v], sites[p.a].position, sites[p.b].position));
    return true;
  });
  return least;
}

// Returns the least squared distance of any site from a subsegment that does not end at the site,
// group by group: most sites are not near any subsegment.
double shortest_of_all(const std::vector<site>& sites, const boundary& edges, const proximity& near,
                       double most) {
  const double at_first = std::min(most * most, least_along(near.order(), sites));
  double least = least_of_pairs(sites, near.sites(), at_first);
  near.sites().visit_groups([&](const bounding_box& box, const point& extent, const auto& each) {
    const double look = 2 * std::sqrt(least), x = look * extent.x, y = look * extent.y;
    const bounding_box around{{box.low.x - x, box.low.y - y}, {box.high.x + x, box.high.y + y}};
    if (near.subsegments().visit(around, [](std::uint32_t) { return false; })) return;
    each([&](vertex_index v) {
      const bounding_box of_v = box_around(sites[v], 2 * std::sqrt(least));
      least = least_to_subsegments(sites, v, edges, near, of_v, least);
    });
  });
  return std::sqrt(least);
}

}  // namespace

double shortest_distance(const std::vector<site>& sites, vertex_index count, const boundary& edges,
                         const proximity& near, double most) {
  if (count == sites.size()) return shortest_of_all(sites, edges, near, most);
  // Visits sites along a space-filling curve: each search then finds in the cache what the search
  // before it read.
  std::vector<vertex_index> order = near.order();
  std::erase_if(order, [count](vertex_index v) { return v >= count; });
  double least = std::min(most * most, least_along(order, sites));
  for (const vertex_index v : order) {
    const bounding_box around = box_around(sites[v], 2 * std::sqrt(least));
    near.sites().visit_box(sites, around.low, around.high, [&](vertex_index w) {
      if (w != v) least = std::min(least, squared_distance(sites[v], sites[w].position));
      return true;
    });
    least = least_to_subsegments(sites, v, edges, near, around, least);
  }
  return std::sqrt(least);
}

double median_distance(const std::vector<site>& sites, const proximity& near, double most) {
  std::vector<double> nearest(sites.size());
  for (vertex_index v = 0; v < sites.size(); ++v)
    nearest[v] = nearest_other(sites, near.sites(), v, most * most);
  const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
  std::nth_element(nearest.begin(), middle, nearest.end());
  return std::sqrt(*middle);
}

}  // namespace asterism::internal
