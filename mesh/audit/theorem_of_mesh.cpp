// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/theorem_of_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/audit/audit_work.hpp"
#include "asterism/mesh/audit/metric_ball.hpp"
#include "asterism/mesh/audit/number.hpp"
#include "asterism/mesh/audit/site_tree.hpp"
#include "asterism/mesh/audit/theorem_measures.hpp"
#include "asterism/mesh/audit/theorem_table.hpp"
#include "asterism/mesh/audit/unit_subject.hpp"
#include "asterism/mesh/audit/voronoi_arc.hpp"
#include "asterism/mesh/support/infinity.hpp"
#include "asterism/mesh/support/parallel.hpp"
#include "asterism/mesh/support/work_weights.hpp"

namespace asterism::internal {
namespace {

using audit_detail::audit_context;
using audit_detail::audit_tally;
using audit_detail::audit_work_guard;
using audit_detail::greatest_bound;
using audit_detail::site_tree;

constexpr double useless_distortion = 1.272;  // beyond it no arc is sure to be wedged
constexpr std::size_t chunk = 1024, looked_for_together = 8;

// Returns the work limit for the pairs of this number of sites, in units of kernels/work_units.hpp:
// a second, and 0.2 milliseconds a site. Their subsegments have the same limit again. Meshes whose
// edges have about the wanted length have 15 near pairs a site and take less than one unit a site
// for them. If a few triangles are far larger than the others, every two sites are near.
double most_units(std::size_t sites) {
  constexpr double at_least = 1e5, for_each = 20;
  return at_least + for_each * static_cast<double>(sites);
}

// Measures of one chunk of the sites or subsegments; `failure` is the first thing that went wrong.
struct measured_part {
  theorem::pair_measures pairs{infinity, 1, 0};  // the least distance, the greatest others
  double longest_subsegment = 0;
  std::array<vertex_index, 2> nearest{};  // the sites of the least distance
  std::string failure;
};

std::string vertex_name(vertex_index v) { return "vertex " + std::to_string(v + 1); }

std::array<site, 3> corners_of(const mesh& m, std::size_t i) {
  const triangle& t = m.triangles[i];
  return {m.sites[t[0]], m.sites[t[1]], m.sites[t[2]]};
}

// Returns the triangle, among a few, that is likely to have the greatest covering radius.
std::size_t widest_of_some(const mesh& m) {
  constexpr std::size_t step = 64;
  std::size_t widest = 0;
  double greatest = 0;
  for (std::size_t i = 0; i < m.triangles.size(); i += step) {
    const double radius = theorem::quick_covering_radius_above(corners_of(m, i), 0);
    if (radius > greatest) {
      greatest = radius;
      widest = i;
    }
  }
  return widest;
}

// Measures first the triangle of each chunk that is likely to have the greatest covering
// radius: a chunk needs no exact radius where its quick bounds are below the greatest one
// known.
double covering_radius(const mesh& m) {
  if (m.triangles.empty()) return 0;
  const auto radius_of = [&](std::size_t i) {
    return theorem::covering_radius_above(corners_of(m, i));
  };
  // Skips the exact radius of triangles whose quick bound is below the exact radius of another one.
  const double enough = radius_of(widest_of_some(m));
  std::vector<double> quick(m.triangles.size());
  const auto widest = collect_chunks<double>(
      m.triangles.size(), chunk, [&](std::size_t begin, std::size_t end, std::vector<double>& out) {
        std::size_t greatest = end;
        for (std::size_t i = begin; i < end; ++i) {
          quick[i] = theorem::quick_covering_radius_above(corners_of(m, i), enough);
          if (quick[i] > 0 && (greatest == end || quick[i] > quick[greatest])) greatest = i;
        }
        out.push_back(greatest == end ? enough : radius_of(greatest));
      });
  double known = 0;
  for (const double part : widest) known = greatest_bound(known, part);
  const auto parts = collect_chunks<double>(
      m.triangles.size(), chunk, [&](std::size_t begin, std::size_t end, std::vector<double>& out) {
        double radius = known;
        for (std::size_t i = begin; i < end; ++i)
          if (!(quick[i] < radius)) radius = greatest_bound(radius, radius_of(i));
        out.push_back(radius);
      });
  double radius = known;
  for (const double part : parts) radius = greatest_bound(radius, part);
  return radius;
}

// Returns the radius of disks around sites for which a pair of sites can be left unmeasured if
// their disks are disjoint: the covering radius; or, if all sites have one metric, half the
// shortest edge, since metrics do not differ, and pairs farther apart than that edge do not reduce
// the spacing. For random sites this leaves out nearly all pairs.
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

// Returns a clause that names the bound of the ratio of lengths in two metrics, or states that no
// double holds the bound, if products of entries leave the range.
std::string difference_text(double distortion) {
  if (!(distortion < std::numeric_limits<double>::infinity()))
    return "differ by a factor that doubles do not tell";
  return "differ by a factor of " + format_number(distortion);
}

// Measures the pair of v and w, unless a quick test shows that no measure so far is exceeded.
void measure_near_pair(const mesh& m, vertex_index v, vertex_index w, double radius,
                       measured_part& part) {
  const site &centre = m.sites[v], &other = m.sites[w];
  if (theorem::is_within(part.pairs, centre, other) ||
      theorem::certainly_apart(centre, other, radius))
    return;
  const theorem::pair_measures pair = theorem::measure_pair(centre, other);
  if (pair.larger_distance_below < part.pairs.larger_distance_below) {
    part.pairs.larger_distance_below = pair.larger_distance_below;
    part.nearest = {std::min(v, w), std::max(v, w)};
  }
  part.pairs.distortion_above = greatest_bound(part.pairs.distortion_above, pair.distortion_above);
  part.pairs.variation_above = greatest_bound(part.pairs.variation_above, pair.variation_above);
  if (!(pair.distortion_above < useless_distortion))
    part.failure = "the metrics of " + vertex_name(v) + " and " + vertex_name(w) +
                   ", whose disks of the covering radius meet, " +
                   difference_text(pair.distortion_above);
}

// Sites in the order of a tree, in which near ones are near each other, and the place of each site
// in that order.
struct ordered_sites {
  explicit ordered_sites(const site_tree& of) : tree(of), rank(of.order().size()) {
    for (std::size_t i = 0; i < rank.size(); ++i) rank[of.order()[i]] = i;
  }
  const site_tree& tree;
  std::vector<std::size_t> rank;
};

// Measures the pairs of a range of sites in the order with all sites after them. Descends the tree
// once for the whole range.
void measure_near_pairs(const mesh& m, const ordered_sites& sites, std::size_t first,
                        std::size_t last, double radius, audit_work_guard& guard,
                        measured_part& part) {
  const std::vector<vertex_index>& order = sites.tree.order();
  std::vector<audit_detail::star_extent> disks;
  for (std::size_t i = first; i < last; ++i) disks.emplace_back(m.sites[order[i]], radius);
  std::vector<std::size_t> leaves;
  sites.tree.gather(disks, leaves, first);
  for (std::size_t i = first; i < last; ++i) {
    const vertex_index v = order[i];
    const auto measure = [&](vertex_index w) {
      guard.count(work_weights::theorem_pair);
      if (guard.is_over()) return false;
      if (sites.rank[w] > i) measure_near_pair(m, v, w, radius, part);
      return part.failure.empty();
    };
    if (!part.failure.empty()) return;
    sites.tree.visit_near(leaves, disks[i - first], measure, i + 1);
  }
}

// Returns an upper bound of the distance from points of a subsegment to their nearer end: with its
// length A in one end's metric and B in the other's, the point at the parameter t is t A from one
// end and (1 - t) B from the other, and the lesser of these is at most A B / (A + B).
double farthest_from_nearer_end(double by_a, double by_b) {
  constexpr double up = 1 + 0x1p-48;
  return by_a / (by_a + by_b) * by_b * up;
}

// True if w is certainly farther than the radius from all points of the subsegment.
bool is_clearly_beside(const mesh& m, const boundary_edge& subsegment, vertex_index w,
                       double farthest) {
  const audit_detail::metric_ball ball(m.sites[w]);
  return ball.is_usable() &&
         audit_detail::metric_ball::misses(ball.in_frame(m.sites[subsegment.a].position),
                                           ball.in_frame(m.sites[subsegment.b].position), farthest);
}

// Tests the site w against a subsegment.
void check_beside(const mesh& m, const boundary_edge& subsegment, vertex_index w, double farthest,
                  audit_work_guard& guard, measured_part& part) {
  guard.count(work_weights::theorem_pair);
  if (w == subsegment.a || w == subsegment.b || !part.failure.empty() || guard.is_over()) return;
  if (is_clearly_beside(m, subsegment, w, farthest)) return;
  if (!audit_detail::is_certainly_farther_than_nearer_end(m.sites[subsegment.a],
                                                          m.sites[subsegment.b], m.sites[w]))
    part.failure = vertex_name(w) + " may be as near to a point of the boundary edge from " +
                   vertex_name(subsegment.a) + " to " + vertex_name(subsegment.b) + " as its ends";
}

// Checks a range of subsegments. Neighbours in the list are often neighbours in the plane: the tree
// is descended once for the whole range.
void check_subsegments(const mesh& m, const site_tree& tree, std::size_t first, std::size_t last,
                       audit_work_guard& guard, measured_part& part) {
  std::vector<audit_detail::star_extent> starts;
  std::vector<double> farthest;
  for (std::size_t i = first; i < last; ++i) {
    const site &a = m.sites[m.boundary[i].a], &b = m.sites[m.boundary[i].b];
    const double by_a = theorem::distance_above(a, b), by_b = theorem::distance_above(b, a);
    part.longest_subsegment = greatest_bound(part.longest_subsegment, greatest_bound(by_a, by_b));
    farthest.push_back(farthest_from_nearer_end(by_a, by_b));
    // Starts from the end in whose metric the subsegment is shorter, of length s. No point of the
    // subsegment is farther than s from that end; nor is it from its nearer end, as both metrics
    // are linear along the subsegment. For a site w that is as near to such a point, g . (w - end)
    // is therefore at most (|g|_end + |g|_w) s (star_extent.hpp).
    if (by_b < by_a)
      starts.emplace_back(b, by_b);
    else
      starts.emplace_back(a, by_a);
  }
  std::vector<std::size_t> leaves;
  tree.gather(starts, leaves);
  for (std::size_t i = first; i < last; ++i)
    tree.visit_near(leaves, starts[i - first], [&](vertex_index w) {
      check_beside(m, m.boundary[i], w, farthest[i - first], guard, part);
    });
}

// Measures `count` items, `at_a_time` of them in each round, and joins the measures in order. Sets
// `unfinished` of the context where it is ended early.
template <class Measure>
measured_part measure_all(audit_context& context, std::size_t count, std::size_t at_a_time,
                          const Measure& measure) {
  std::vector<measured_part> parts(chunk_count(count, chunk));
  const auto measure_chunk = [&](audit_tally& tally, std::size_t begin, std::size_t end) {
    measured_part& part = parts[begin / chunk];
    audit_work_guard guard(context, tally);
    for (std::size_t i = begin; i < end && part.failure.empty() && !tally.unfinished;
         i += at_a_time)
      measure(i, std::min(end, i + at_a_time), guard, part);
  };
  check_in_parallel(context, count, measure_chunk, chunk, most_units(context.subject.sites.size()));
  measured_part all;
  for (const measured_part& part : parts) {
    if (part.pairs.larger_distance_below < all.pairs.larger_distance_below) {
      all.pairs.larger_distance_below = part.pairs.larger_distance_below;
      all.nearest = part.nearest;
    }
    all.pairs.distortion_above =
        greatest_bound(all.pairs.distortion_above, part.pairs.distortion_above);
    all.pairs.variation_above =
        greatest_bound(all.pairs.variation_above, part.pairs.variation_above);
    all.longest_subsegment = greatest_bound(all.longest_subsegment, part.longest_subsegment);
    if (all.failure.empty()) all.failure = part.failure;
  }
  return all;
}

// Returns the reason why the theorem does not apply, as a sentence with lengths in multiples of
// `unit`; empty if it applies.
std::string obstacle(const theorem_hypotheses& h, const std::array<vertex_index, 2>& nearest,
                     double angle_bound, double unit = 1) {
  const bool wedged = theorem::arcs_are_wedged(h.covering_radius, h.spacing, h.distortion);
  if (wedged && h.proved_angle >= angle_bound) return {};
  const std::string spacing = vertex_name(nearest[0]) + " and " + vertex_name(nearest[1]) +
                              " are " + format_number(unit * h.spacing) +
                              " apart, where the domain is covered within " +
                              format_number(unit * h.covering_radius);
  if (!wedged)
    return spacing + ": arcs need not be wedged where metrics " + difference_text(h.distortion);
  return "at sigma eps " + format_number(h.sigma_eps) + " no more than " +
         format_number(h.proved_angle) + " degrees are proved (" + spacing + ")";
}

// Enters the measures of pairs of sites, and the numbers that follow from them.
void enter_pairs(theorem_hypotheses& h, const theorem::pair_measures& pairs) {
  h.spacing = pairs.larger_distance_below;
  h.distortion = pairs.distortion_above;
  h.variation = pairs.variation_above;
  h.sigma_eps = theorem::table_variation_above(h.variation, h.covering_radius, h.distortion);
  h.proved_angle =
      theorem::proved_angle(h.sigma_eps, theorem::quotient_above(h.covering_radius, h.spacing));
}

// Measures the pairs of neighbours in every sixteenth triangle.
measured_part measure_some_neighbours(const mesh& m, double radius) {
  constexpr std::size_t step = 16;
  measured_part some;
  for (std::size_t k = 0; k < m.triangles.size() && some.failure.empty(); k += step) {
    const triangle& t = m.triangles[k];
    for (std::size_t i = 0; i < 3; ++i) measure_near_pair(m, t[i], t[(i + 1) % 3], radius, some);
  }
  return some;
}

// True if some neighbours alone prove that the theorem is far from applying: metrics differ too
// much, or the spacing would be too small even at four times the least distance between these
// neighbours. Such meshes may have very many near pairs, as among random sites, each of which is
// near hundreds.
bool is_far_from_applying(theorem_hypotheses h, const measured_part& some, double angle_bound) {
  constexpr double times = 4;
  if (!some.failure.empty()) return true;
  theorem::pair_measures pairs = some.pairs;
  pairs.larger_distance_below *= times;
  if (!(pairs.larger_distance_below < h.covering_radius)) return false;
  enter_pairs(h, pairs);
  return !obstacle(h, some.nearest, angle_bound).empty();
}

// Returns hypotheses with a reason and no numbers: incomplete measures could be mistaken for
// complete ones.
theorem_hypotheses unmeasured(const std::optional<std::string>& why) {
  theorem_hypotheses nothing;
  nothing.reason = std::string(not_all_measured) +
                   why.value_or("the most work that is done for so many sites was done");
  return nothing;
}

// Measures a mesh whose numbers are of ordinary size. Texts give lengths in multiples of `unit`.
theorem_hypotheses measure_ordinary(const mesh& subject, double angle_bound,
                                    const cancellation& stop, const site_tree* made, double unit) {
  theorem_hypotheses h;
  h.covering_radius = covering_radius(subject);
  if (!(h.covering_radius < infinity && !subject.triangles.empty())) {
    h.reason = "no bound is known of how far points are from sites";
    return h;
  }
  audit_report counted;
  audit_options asked;
  // Drops the account of the run: the measures may not depend on it, as `verify` has
  // none.
  asked.stop = [&stop] { return stop.told(); };
  audit_context context(subject, asked, counted);
  const site_tree& tree = made != nullptr ? *made : context.plant();
  const measured_part subsegments = measure_all(
      context, subject.boundary.size(), looked_for_together,
      [&](std::size_t first, std::size_t last, audit_work_guard& guard, measured_part& part) {
        check_subsegments(subject, tree, first, last, guard, part);
      });
  h.longest_subsegment = subsegments.longest_subsegment;
  const double radius = radius_that_matters(subject, h.covering_radius);
  measured_part near = measure_some_neighbours(subject, radius);
  if (!is_far_from_applying(h, near, angle_bound)) {
    const ordered_sites sites(tree);
    near = measure_all(
        context, tree.order().size(), looked_for_together,
        [&](std::size_t first, std::size_t last, audit_work_guard& guard, measured_part& part) {
          measure_near_pairs(subject, sites, first, last, radius, guard, part);
        });
  }
  stop.charge(context.looked_units);
  if (context.unfinished) return unmeasured(context.told ? context.told : stop.told());
  enter_pairs(h, near.pairs);
  h.reason = !near.failure.empty()          ? near.failure
             : !subsegments.failure.empty() ? subsegments.failure
                                            : obstacle(h, near.nearest, angle_bound, unit);
  h.applies = h.reason.empty();
  if (h.applies) h.reason = "all hypotheses hold";
  return h;
}

}  // namespace

// Measures a scaled image of a mesh whose bounds of lengths would leave the range of doubles: such
// bounds would decide nothing, and each site would be tested against all others.
theorem_hypotheses theorem_of_mesh(const mesh& subject, double angle_bound,
                                   const cancellation& stop, const site_tree* tree) {
  const auto scaled = audit_detail::unit_subject_of(subject);
  if (!scaled) return measure_ordinary(subject, angle_bound, stop, tree, 1);
  const double unit = std::ldexp(1.0, scaled->exponent);
  theorem_hypotheses h = measure_ordinary(scaled->image, angle_bound, stop, nullptr, unit);
  for (double* length : {&h.covering_radius, &h.spacing, &h.longest_subsegment}) *length *= unit;
  h.variation /= unit;
  return h;
}

}  // namespace asterism::internal
