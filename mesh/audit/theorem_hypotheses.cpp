// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/theorem_hypotheses.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <vector>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/audit/number.hpp"
#include "asterism/mesh/audit/site_tree.hpp"
#include "asterism/mesh/audit/theorem_measures.hpp"
#include "asterism/mesh/audit/theorem_table.hpp"
#include "asterism/mesh/audit/voronoi_arc.hpp"
#include "asterism/mesh/support/parallel.hpp"

namespace asterism {
namespace {

using namespace internal;

using audit_detail::greatest_bound;
using audit_detail::site_tree;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double useless_distortion = 1.272;  // beyond it no arc is sure to be wedged
constexpr std::size_t chunk = 1024, looked_for_together = 8;

// Measures of one chunk of the sites or subsegments; `failure` is the first thing that went wrong.
struct measured_part {
  double spacing = infinity, distortion = 1, variation = 0, longest_subsegment = 0;
  std::array<vertex_index, 2> nearest{};  // the sites that the spacing is of
  std::string failure;
};

std::string vertex_name(vertex_index v) { return "vertex " + std::to_string(v + 1); }

double covering_radius(const mesh& m) {
  const auto parts = collect_chunks<double>(
      m.triangles.size(), chunk, [&](std::size_t begin, std::size_t end, std::vector<double>& out) {
        double radius = 0;
        for (std::size_t i = begin; i < end; ++i) {
          const triangle& t = m.triangles[i];
          const std::array<site, 3> corners = {m.sites[t[0]], m.sites[t[1]], m.sites[t[2]]};
          if (!(theorem::quick_covering_radius_above(corners) < radius))
            radius = greatest_bound(radius, theorem::covering_radius_above(corners));
        }
        out.push_back(radius);
      });
  double radius = 0;
  for (const double part : parts) radius = greatest_bound(radius, part);
  return radius;
}

// Returns how far sites may be from each other, as disks of that radius around them meet, to matter
// to what is measured: the covering radius, or, where all metrics are one, half the shortest edge.
// Pairs farther apart than that edge are measured in vain there: their metrics do not differ. Where
// sites are spread unevenly, as random ones are, that spares nearly all pairs.
double radius_that_matters(const mesh& m, double covering_radius) {
  const metric_tensor& one = m.sites.front().metric;
  const bool is_one = std::all_of(m.sites.begin(), m.sites.end(),
                                  [&](const site& s) { return identical(s.metric, one); });
  if (!is_one) return covering_radius;
  double shortest = infinity;
  for (const triangle& t : m.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      shortest =
          std::min(shortest, theorem::distance_above(m.sites[t[i]], m.sites[t[(i + 1) % 3]]));
  return std::min(covering_radius, 0.5 * shortest);
}

// Measures the pair of v and w.
void measure_near_pair(const mesh& m, vertex_index v, vertex_index w, double radius,
                       measured_part& part) {
  const site &centre = m.sites[v], &other = m.sites[w];
  if (theorem::certainly_apart(centre, other, radius)) return;
  const theorem::pair_measures pair = theorem::measure_pair(centre, other);
  if (pair.larger_distance_below < part.spacing) {
    part.spacing = pair.larger_distance_below;
    part.nearest = {v, w};
  }
  part.distortion = greatest_bound(part.distortion, pair.distortion_above);
  part.variation = greatest_bound(part.variation, pair.variation_above);
  if (!(pair.distortion_above < useless_distortion))
    part.failure = "the metrics of " + vertex_name(v) + " and " + vertex_name(w) +
                   ", whose disks of the covering radius meet, differ by a factor of " +
                   format_number(pair.distortion_above);
}

// Measures the pairs of some sites, near each other, with sites of greater number. What is near all
// of them is looked for once.
void measure_near_pairs(const mesh& m, const site_tree& tree,
                        std::span<const vertex_index> together, double radius,
                        measured_part& part) {
  std::vector<site_tree::reaching> centres;
  for (const vertex_index v : together) centres.push_back({m.sites[v], radius});
  std::vector<std::size_t> leaves;
  const bool gathered = tree.gather(centres, leaves);
  for (const vertex_index v : together) {
    const auto measure = [&](vertex_index w) {
      if (w > v && part.failure.empty()) measure_near_pair(m, v, w, radius, part);
    };
    if (!part.failure.empty()) return;
    if (gathered)
      tree.visit_near(leaves, m.sites[v], radius, measure);
    else
      tree.visit_near(m.sites[v], radius, measure);
  }
}

void check_subsegment(const mesh& m, const site_tree& tree, const boundary_edge& subsegment,
                      measured_part& part) {
  const site &a = m.sites[subsegment.a], &b = m.sites[subsegment.b];
  const double length =
      greatest_bound(theorem::distance_above(a, b), theorem::distance_above(b, a));
  part.longest_subsegment = greatest_bound(part.longest_subsegment, length);
  tree.visit_near(a, length, [&](vertex_index w) {
    if (w == subsegment.a || w == subsegment.b || !part.failure.empty()) return;
    if (!audit_detail::is_certainly_farther_than_nearer_end(a, b, m.sites[w]))
      part.failure = vertex_name(w) + " may be as near to a point of the boundary edge from " +
                     vertex_name(subsegment.a) + " to " + vertex_name(subsegment.b) +
                     " as its ends";
  });
}

// Measures `count` items, so many at a time, and puts them together in order.
template <class Measure>
measured_part measure_all(std::size_t count, std::size_t at_a_time, const Measure& measure) {
  const auto parts = collect_chunks<measured_part>(
      count, chunk, [&](std::size_t begin, std::size_t end, std::vector<measured_part>& out) {
        measured_part part;
        for (std::size_t i = begin; i < end && part.failure.empty(); i += at_a_time)
          measure(i, std::min(end, i + at_a_time), part);
        out.push_back(std::move(part));
      });
  measured_part all;
  for (const measured_part& part : parts) {
    if (part.spacing < all.spacing) {
      all.spacing = part.spacing;
      all.nearest = part.nearest;
    }
    all.distortion = greatest_bound(all.distortion, part.distortion);
    all.variation = greatest_bound(all.variation, part.variation);
    all.longest_subsegment = greatest_bound(all.longest_subsegment, part.longest_subsegment);
    if (all.failure.empty()) all.failure = part.failure;
  }
  return all;
}

// Returns the obstacle as a sentence; empty if there is none.
std::string obstacle(const theorem_hypotheses& h, const std::array<vertex_index, 2>& nearest,
                     double angle_bound) {
  const bool wedged = theorem::arcs_are_wedged(h.covering_radius, h.spacing, h.distortion);
  if (wedged && h.proved_angle >= angle_bound) return {};
  const std::string spacing = vertex_name(nearest[0]) + " and " + vertex_name(nearest[1]) +
                              " are " + format_number(h.spacing) +
                              " apart, where the domain is covered within " +
                              format_number(h.covering_radius);
  if (!wedged)
    return spacing + ": arcs need not be wedged where metrics differ by a factor of " +
           format_number(h.distortion);
  return "at sigma eps " + format_number(h.sigma_eps) + " no more than " +
         format_number(h.proved_angle) + " degrees are proved (" + spacing + ")";
}

}  // namespace

theorem_hypotheses measure_theorem_hypotheses(const mesh& subject, double angle_bound) {
  theorem_hypotheses h;
  h.covering_radius = covering_radius(subject);
  if (!(h.covering_radius < infinity && !subject.triangles.empty())) {
    h.reason = "no bound is known of how far points are from sites";
    return h;
  }
  const site_tree tree(subject.sites);
  const measured_part subsegments =
      measure_all(subject.boundary.size(), 1, [&](std::size_t i, std::size_t, measured_part& part) {
        check_subsegment(subject, tree, subject.boundary[i], part);
      });
  h.longest_subsegment = subsegments.longest_subsegment;
  const std::span<const vertex_index> order(tree.order());
  const double radius = radius_that_matters(subject, h.covering_radius);
  const measured_part near = measure_all(
      order.size(), looked_for_together,
      [&](std::size_t first, std::size_t last, measured_part& part) {
        measure_near_pairs(subject, tree, order.subspan(first, last - first), radius, part);
      });
  h.spacing = near.spacing;
  h.distortion = near.distortion;
  h.variation = near.variation;
  h.sigma_eps = theorem::table_variation_above(h.variation, h.covering_radius, h.distortion);
  h.proved_angle =
      theorem::proved_angle(h.sigma_eps, theorem::quotient_above(h.covering_radius, h.spacing));
  h.reason = !near.failure.empty()          ? near.failure
             : !subsegments.failure.empty() ? subsegments.failure
                                            : obstacle(h, near.nearest, angle_bound);
  h.applies = h.reason.empty();
  if (h.applies) h.reason = "all hypotheses hold";
  return h;
}

}  // namespace asterism
