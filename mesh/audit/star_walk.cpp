// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/star_walk.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "asterism/kernels/star_gap.hpp"
#include "asterism/mesh/audit/audit_work.hpp"
#include "asterism/mesh/audit/gap_reach.hpp"
#include "asterism/mesh/audit/metric_ball.hpp"
#include "asterism/mesh/audit/site_tree.hpp"
#include "asterism/mesh/audit/star_filter.hpp"
#include "asterism/mesh/audit/triangle_walk.hpp"

namespace asterism::internal::audit_detail {
namespace {

constexpr std::size_t chunk = 1024;
// Beyond these a walk is slower than the descents of a tree.
constexpr std::size_t most_listed = 40, most_met = 400;

// The gap at the corner i of the triangle t has the number 3 t + i.
struct gap_of_triangle {
  vertex_index v = 0, x = 0, y = 0;  // from x counter-clockwise to y
};

// A gap that is listed with a triangle behind its own.
struct listing {
  vertex_index triangle = 0;
  std::size_t gap = 0;
};

// All gaps of a mesh, and how far they reach.
struct gap_table {
  const audit_context& context;
  const std::vector<site>& at;
  // By number, from above: 0 where nothing is seen beyond the edge. Negative, until gaps are
  // listed, where points of the meeting lemma may be behind the triangle.
  std::vector<float> reaches;
  std::vector<char> has_listings;  // one flag a triangle
  std::vector<listing> listings;   // sorted by triangle
  std::vector<char> is_left;       // one flag a site
  float radius = 0;                // the greatest reach of a gap that is not left

  gap_of_triangle gap(std::size_t number) const {
    const triangle& t = context.subject.triangles[number / 3];
    const std::size_t i = number % 3;
    return {t[i], t[(i + 1) % 3], t[(i + 2) % 3]};
  }
};

// Returns an upper bound in less memory; no smaller than what balls are measured by.
float rounded_up(double reach) {
  constexpr double smallest = 0x1p-100, greatest = 0x1p100;
  if (!(reach < greatest)) return std::numeric_limits<float>::infinity();
  return static_cast<float>(std::max(reach, smallest) * (1 + 0x1p-21));
}

// True if nothing is seen beyond the edge from a to b. Most edges have an end that no boundary edge
// leaves.
bool is_subsegment(const audit_context& context, vertex_index a, vertex_index b) {
  return context.side_start[a] != context.side_start[a + 1] &&
         find_subsegment(context, a, b) != context.subject.boundary.size();
}

// Measures one gap, and lists it with the triangle behind where that is enough.
void measure_gap(gap_table& gaps, std::size_t number, const gap_extent& extent,
                 std::vector<listing>& listings) {
  const gap_of_triangle g = gaps.gap(number);
  float& reach = gaps.reaches[number];
  if (is_subsegment(gaps.context, g.x, g.y)) return;
  reach = rounded_up(extent.reach);
  if (extent.stays_inside) return;
  const auto& edges = gaps.context.edges;
  const std::size_t behind = find_edge(gaps.context, g.y, g.x);
  if (behind != edges.size() && is_in_triangle_behind(extent, gaps.at[g.v], gaps.at[g.x],
                                                      gaps.at[g.y], gaps.at[edges[behind].apex]))
    listings.push_back({edges[behind].triangle, number});
  else
    reach = -reach;
}

void measure_gaps(audit_context& context, gap_table& gaps) {
  const auto& triangles = context.subject.triangles;
  gaps.reaches.resize(3 * triangles.size());
  gaps.listings = collect_chunks<listing>(
      triangles.size(), chunk, [&](std::size_t begin, std::size_t end, std::vector<listing>& out) {
        for (std::size_t t = begin; t < end; ++t) {
          context.prefetch_corners(t + triangles_ahead);
          const triangle& c = triangles[t];
          const auto extents = extents_of({&gaps.at[c[0]], &gaps.at[c[1]], &gaps.at[c[2]]});
          for (std::size_t i = 0; i < 3; ++i) measure_gap(gaps, 3 * t + i, extents[i], out);
        }
      });
}

// Returns the radius of the balls: the greatest reach, unless some are far beyond all others, for
// which every ball would be large. Any choice is right. Those of few gaps tell it.
float choose_radius(const std::vector<float>& reaches) {
  constexpr std::size_t asked = 1024;
  constexpr float most_beyond = 1.5;
  constexpr float infinity = std::numeric_limits<float>::infinity();
  std::vector<float> some;
  for (std::size_t i = 0; i < reaches.size(); i += 1 + reaches.size() / asked)
    if (reaches[i] != 0 && std::abs(reaches[i]) < infinity) some.push_back(std::abs(reaches[i]));
  if (some.empty()) return 0;
  const auto high = some.begin() + static_cast<std::ptrdiff_t>(some.size() - 1 - some.size() / 100);
  std::nth_element(some.begin(), high, some.end());
  const float most = most_beyond * *high;
  float greatest = 0;
  for (const float reach : reaches)
    if (std::abs(reach) <= most) greatest = std::max(greatest, std::abs(reach));
  return greatest;
}

// Returns how far nearly all gaps of some triangles reach.
double common_reach(const audit_context& context, const std::vector<site>& at, std::size_t step) {
  std::vector<double> reaches;
  for (std::size_t t = 0; t < context.subject.triangles.size(); t += step) {
    const triangle& c = context.subject.triangles[t];
    for (const gap_extent& gap : extents_of({&at[c[0]], &at[c[1]], &at[c[2]]}))
      reaches.push_back(gap.reach);
  }
  const auto high =
      reaches.begin() + static_cast<std::ptrdiff_t>(reaches.size() - 1 - reaches.size() / 100);
  std::nth_element(reaches.begin(), high, reaches.end());
  return *high;
}

// True if balls as large as nearly all gaps need meet few triangles, as they do where edges are
// about alike, or if the mesh is small. Looks at some of both. Any answer is right: a walk takes as
// long as the tree where a ball meets about 25 triangles besides those at its site. It was 6 on
// meshes filled in swirl:24 with 10,000 triangles, 12 with 1,000, and 100 among random sites with
// angles mended, where a walk took four times as long.
bool is_worth_walking(const audit_context& context, const std::vector<site>& at) {
  constexpr std::size_t most_asked = 128, part = 8, worth_asking = 200, most_on_average = 20;
  const std::size_t triangles = context.subject.triangles.size();
  if (at.size() < worth_asking) return true;
  const std::size_t asked = std::min(most_asked, at.size() / part);
  const double radius = common_reach(context, at, 1 + triangles / asked);
  if (!(radius < std::numeric_limits<double>::infinity())) return false;
  triangle_walk walk(context, at);
  const std::size_t step = 1 + at.size() / asked;
  const std::size_t most = most_on_average * (1 + at.size() / step);
  std::size_t met = 0;
  for (std::size_t w = 0; w < at.size() && met <= most; w += step) {
    const metric_ball ball(at[w]);
    if (!ball.is_usable()) return false;
    const std::size_t first = context.edge_start[w], last = context.edge_start[w + 1];
    walk.begin(ball, radius, most_met);
    for (std::size_t i = first; i < last; ++i) walk.take(context.edges[i].triangle);
    for (std::size_t i = first; i < last; ++i)
      walk.cross(context.edges[i].b, context.edges[i].apex);
    if (!walk.go([](const directed_edge&) {})) return false;
    met += walk.met().size() - (last - first);
  }
  return met <= most;
}

// Returns the best bound of a reach that is known, for gaps whose first one is of no use.
double better_reach(const gap_table& gaps, const gap_of_triangle& g) {
  const double reach = star_gap(gaps.at[g.v], gaps.at[g.x], gaps.at[g.y]).reach();
  if (reach < std::numeric_limits<double>::infinity()) return reach;
  return star_gap_filter(gaps.at[g.v], gaps.at[g.x], gaps.at[g.y]).reach();
}

// Holds what was found out about some gaps.
struct listed_part {
  std::vector<listing> listings;
  std::vector<vertex_index> left;
  std::size_t listed_gaps = 0;
};

// Lists the gap with the triangles beyond x-y that its points may be in: no farther from v than it
// reaches. Left where these points may be outside the domain.
void list_gap(gap_table& gaps, std::size_t number, triangle_walk& walk, listed_part& part) {
  float& reach = gaps.reaches[number];
  const gap_of_triangle g = gaps.gap(number);
  reach = std::abs(reach);
  if (reach > gaps.radius) reach = std::min(reach, rounded_up(better_reach(gaps, g)));
  const metric_ball ball(gaps.at[g.v]);
  if (!(reach <= gaps.radius) || !ball.is_usable()) return part.left.push_back(g.v);
  const std::size_t before = part.listings.size();
  walk.begin(ball, reach, most_listed);
  walk.take(static_cast<vertex_index>(number / 3));
  walk.cross(g.x, g.y);
  const auto list = [&](const directed_edge& e) { part.listings.push_back({e.triangle, number}); };
  if (!walk.go(list) || walk.meets_boundary()) {
    part.listings.resize(before);
    return part.left.push_back(g.v);
  }
  ++part.listed_gaps;
}

void list_gaps(audit_context& context, gap_table& gaps, walk_outcome& outcome) {
  const std::size_t triangles = context.subject.triangles.size();
  gaps.has_listings.assign(triangles, 0);
  gaps.is_left.assign(gaps.at.size(), 0);
  std::vector<listed_part> parts(chunk_count(triangles, chunk));
  parallel_chunks(triangles, chunk, [&](std::size_t nth, std::size_t begin, std::size_t end) {
    triangle_walk walk(context, gaps.at);
    for (std::size_t i = 3 * begin; i < 3 * end; ++i)
      if (gaps.reaches[i] < 0 || gaps.reaches[i] > gaps.radius) list_gap(gaps, i, walk, parts[nth]);
  });
  for (const listed_part& part : parts) {
    gaps.listings.insert(gaps.listings.end(), part.listings.begin(), part.listings.end());
    for (const vertex_index v : part.left) gaps.is_left[v] = 1;
    outcome.listed_gaps += part.listed_gaps;
    outcome.left_gaps += part.left.size();
  }
  std::sort(gaps.listings.begin(), gaps.listings.end(), [](const listing& a, const listing& b) {
    return a.triangle < b.triangle || (a.triangle == b.triangle && a.gap < b.gap);
  });
  for (const listing& l : gaps.listings) gaps.has_listings[l.triangle] = 1;
}

// Walks from sites, and asks each of the gaps on its way. For one thread.
class site_walk {
 public:
  site_walk(const gap_table& gaps, const star_surroundings& around, audit_tally& tally)
      : gaps_(gaps),
        context_(gaps.context),
        around_(around),
        tally_(tally),
        walk_(gaps.context, gaps.at) {}

  // False if w could not be asked of all gaps.
  bool run(vertex_index w) {
    const metric_ball ball(at(w));
    if (!ball.is_usable()) return false;
    w_ = w;
    ball_ = &ball;
    walk_.begin(ball, gaps_.radius, most_met);
    const std::size_t first = context_.edge_start[w], last = context_.edge_start[w + 1];
    for (std::size_t i = first; i < last; ++i) take_own(context_.edges[i].triangle);
    for (std::size_t i = first; i < last; ++i) look_behind(context_.edges[i]);
    const auto look = [this](const directed_edge& e) { look_at(e.triangle); };
    bool is_done = walk_.go(look);
    const bool is_on_boundary = context_.side_start[w] != context_.side_start[w + 1];
    if (is_done && (is_on_boundary || walk_.meets_boundary())) {
      start_at_boundary();
      is_done = walk_.go(look);
    }
    met += walk_.met().size() - (last - first);
    tally_.looked_units +=
        unit_of_site + unit_of_triangle * static_cast<double>(walk_.met().size());
    return is_done;
  }

  std::vector<vertex_index> left;  // vertices whose stars may accept another site
  std::size_t met = 0;

 private:
  const site& at(vertex_index v) const { return gaps_.at[v]; }

  void take_own(vertex_index t) {
    walk_.take(t);
    if (gaps_.has_listings[t] != 0) ask_listed(t);
  }

  // Looks at the triangle behind one of w's own. Its far corner and w are opposite from each other,
  // and ask the same question: the lesser of both does, unless nothing is to be known of it.
  void look_behind(const directed_edge& own) {
    const std::size_t behind = walk_.across(own.b, own.apex);
    if (behind == context_.edges.size()) return;
    const directed_edge& e = context_.edges[behind];
    if (walk_.is_met(e.triangle)) return;
    walk_.take(e.triangle);
    if (w_ < e.apex || gaps_.is_left[w_] != 0) {
      const std::size_t number = number_of(e.triangle, e.apex);
      if (is_between(number)) ask(number);
    }
    if (gaps_.has_listings[e.triangle] != 0) ask_listed(e.triangle);
    walk_.cross_others(e);
  }

  void look_at(vertex_index t) {
    const std::size_t first = std::size_t{3} * t;
    for (std::size_t number = first; number < first + 3; ++number)
      if (is_between(number)) ask(number);
    if (gaps_.has_listings[t] != 0) ask_listed(t);
  }

  void ask_listed(vertex_index t) {
    const auto begin = std::lower_bound(
        gaps_.listings.begin(), gaps_.listings.end(), t,
        [](const listing& l, vertex_index triangle) { return l.triangle < triangle; });
    for (auto l = begin; l != gaps_.listings.end() && l->triangle == t; ++l)
      if (is_between(l->gap)) ask(l->gap);
  }

  // Goes on from all pieces of the boundary that the ball meets.
  void start_at_boundary() {
    around_.subsegments.visit(
        {ball_->low(gaps_.radius), ball_->high(gaps_.radius)}, [&](vertex_index subsegment) {
          const boundary_edge& piece = context_.subject.boundary[subsegment];
          if (piece.internal) return true;
          if (metric_ball::misses(place(piece.a), place(piece.b), gaps_.radius)) return true;
          const directed_edge& e = context_.edges[find_edge(context_, piece.a, piece.b)];
          if (walk_.is_met(e.triangle)) return true;
          walk_.take(e.triangle);
          look_at(e.triangle);
          walk_.cross_others(e);
          return true;
        });
  }

  point place(vertex_index v) const { return ball_->in_frame(context_.at(v)); }

  std::size_t number_of(vertex_index t, vertex_index corner) const {
    const triangle& c = context_.subject.triangles[t];
    return std::size_t{3} * t + (c[0] == corner ? 0 : c[1] == corner ? 1 : 2);
  }

  // True if w is beyond the gap's edge and strictly between its rays. The area is off by at most
  // four roundings, 2^-50, of its magnitude; in the range asked for underflow takes less than the
  // rest of 2^-49.
  bool is_between(std::size_t number) const {
    const gap_of_triangle g = gaps_.gap(number);
    if (g.v == w_ || g.x == w_ || g.y == w_) return false;
    return turn(g.v, g.x) == sign::positive && turn(g.v, g.y) == sign::negative &&
           turn(g.x, g.y) == sign::negative;
  }
  sign turn(vertex_index a, vertex_index b) const {
    const point &p = context_.at(a), &q = context_.at(b), &r = context_.at(w_);
    const double to_left = (q.x - p.x) * (r.y - p.y), to_right = (q.y - p.y) * (r.x - p.x);
    const double turned = to_left - to_right, size = std::abs(to_left) + std::abs(to_right);
    if (std::abs(turned) > 0x1p-49 * size && size > 0x1p-900 && size < 0x1p1000)
      return turned > 0 ? sign::positive : sign::negative;
    return tally_.kernel().orientation(p, q, r);
  }

  // Asks w of a gap that it is between the rays of, which is left if it may accept w. So is w where
  // it is opposite from the gap: its own gap there is not asked about that.
  void ask(std::size_t number) {
    if (is_settled(number)) return;
    const gap_of_triangle g = gaps_.gap(number);
    left.push_back(g.v);
    const std::size_t behind = find_edge(context_, g.y, g.x);
    if (behind != context_.edges.size() && context_.edges[behind].apex == w_) left.push_back(w_);
  }

  // True if the gap, between whose rays w is, certainly does not accept it, or is left anyway.
  bool is_settled(std::size_t number) {
    const gap_of_triangle g = gaps_.gap(number);
    const double reach = gaps_.reaches[number];
    if (reach == 0 || gaps_.is_left[g.v] != 0) return true;
    if (site_tree::is_too_far(at(g.v), reach, at(w_))) return true;
    ++tally_.part.star_pairs;
    return is_refused(g);
  }

  bool is_refused(const gap_of_triangle& g) const {
    const uncertain_bool by_v = star_gap(at(g.v), at(g.x), at(g.y)).accepts(at(w_));
    if (by_v.certain()) return !by_v.value();
    const uncertain_bool by_w = star_gap(at(w_), at(g.y), at(g.x)).accepts(at(g.v));
    return by_w.certain() && !by_w.value();
  }

  // Work of a site and of a triangle met, as they take 150 and 30 nanoseconds.
  static constexpr double unit_of_site = 0.015, unit_of_triangle = 0.003;

  const gap_table& gaps_;
  const audit_context& context_;
  const star_surroundings& around_;
  audit_tally& tally_;
  triangle_walk walk_;
  vertex_index w_ = 0;
  const metric_ball* ball_ = nullptr;
};

// Holds what was found out about some sites.
struct walked_part {
  std::vector<vertex_index> left;
  std::size_t met = 0;
  bool has_failed = false;
};

}  // namespace

walk_outcome walk_stars(audit_context& context, const star_surroundings& around) {
  walk_outcome outcome;
  outcome.has_failed = !is_worth_walking(context, around.at);
  if (outcome.has_failed) return outcome;
  gap_table gaps{context, around.at, {}, {}, {}, {}};
  measure_gaps(context, gaps);
  gaps.radius = choose_radius(gaps.reaches);
  outcome.has_failed = gaps.radius == 0;
  if (outcome.has_failed) return outcome;
  list_gaps(context, gaps, outcome);
  std::vector<walked_part> parts(chunk_count(around.at.size(), chunk));
  const auto walk = [&](audit_tally& tally, std::size_t begin, std::size_t end) {
    walked_part& part = parts[begin / chunk];
    audit_patience patience(context, tally);
    site_walk walker(gaps, around, tally);
    for (std::size_t w = begin; w < end && !part.has_failed; ++w) {
      context.prefetch_around(w + sites_ahead);
      part.has_failed = patience.is_over() || !walker.run(static_cast<vertex_index>(w));
    }
    part.left = std::move(walker.left);
    part.met = walker.met;
  };
  check_in_parallel(context, around.at.size(), walk, chunk, units_left(context));
  outcome.is_left = std::move(gaps.is_left);
  for (const walked_part& part : parts) {
    outcome.has_failed = outcome.has_failed || part.has_failed;
    outcome.triangles_met += part.met;
    for (const vertex_index v : part.left) outcome.is_left[v] = 1;
  }
  return outcome;
}

}  // namespace asterism::internal::audit_detail
