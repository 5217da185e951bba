// SPDX-License-Identifier: MIT
//
// The half of refine_state that splits the boundary: encroachment, sharp corners, safe splits.
#include <algorithm>
#include <cmath>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/numerics/constructions.hpp"
#include "asterism/mesh/numerics/metric_box.hpp"
#include "asterism/mesh/refine/refine_state.hpp"
#include "asterism/mesh/stars/visibility.hpp"

namespace asterism::internal {
namespace {

constexpr double sharp_angle = 60;  // degrees

// Lengths on one shell agree up to rounding: that of the lengths, and that of the points.
constexpr double shell_slack = 1e-6;

// At least what the distance of two points measures more or less when both are rounded to doubles:
// with half an ulp for each coordinate of each, one ulp of the larger along both axes.
double rounding_of_distance(const metric_tensor& m, const point& a, const point& b) {
  const double x = 0x1p-52 * std::max(std::abs(a.x), std::abs(b.x));
  const double y = 0x1p-52 * std::max(std::abs(a.y), std::abs(b.y));
  return std::sqrt(m.m11) * x + std::sqrt(m.m22) * y;
}

// The power of two nearest to half the length, as a ratio: within a factor sqrt(2) of it.
double shell_radius(double length) {
  return elementary::exp2(std::round(elementary::log2(length / 2)));
}

// An upper bound on |d|_M^2, in doubles. With eps = 2^-52 and sum = m11 dx^2 + m22 dy^2 the
// absolute monomials add up to at most 2 sum (2 |m12 dx dy| <= sum), each carries at most 8 rounded
// factors: the error is below 32 eps sum, which no condition number of M enlarges.
double squared_length_above(const metric_tensor& m, const point& d) {
  return inner_product(m, d, d) + 0x1p-46 * (m.m11 * d.x * d.x + m.m22 * d.y * d.y);
}

// A certain no, cheaply. Nowhere on a b are both f_a and f_b above r^2, their value at the bisector
// point, and r grows with either length; if f_w is above it all along a b, w does not encroach.
// With S the magnitude, a bound on the monomials of f_w on the segment is 2 S, so that evaluating
// f_w at t is off by less than 40 eps S. t itself is off by at most 64 eps S / |d|_w^2, and by at
// most 1 as it is clamped, which raises f_w above its least value by less than 192 eps S whichever
// is smaller: 256 eps = 2^-44 covers both. The few roundings of r are relative. Near underflow
// these bounds do not hold, and nothing is decided.
bool surely_does_not_encroach(const site& a, const site& b, const site& w) {
  const point d{b.position.x - a.position.x, b.position.y - a.position.y};
  const point e{w.position.x - a.position.x, w.position.y - a.position.y};
  const double from_a = std::sqrt(squared_length_above(a.metric, d));
  const double from_b = std::sqrt(squared_length_above(b.metric, d));
  const double r = from_a * from_b / (from_a + from_b);
  const double t =
      std::clamp(inner_product(w.metric, d, e) / inner_product(w.metric, d, d), 0.0, 1.0);
  const point u{e.x - t * d.x, e.y - t * d.y};
  const double reach_x = std::abs(e.x) + std::abs(d.x), reach_y = std::abs(e.y) + std::abs(d.y);
  const double magnitude = w.metric.m11 * reach_x * reach_x + w.metric.m22 * reach_y * reach_y;
  constexpr double near_underflow = 0x1p-900;
  if (!(r * r > near_underflow)) return false;
  return inner_product(w.metric, u, u) - 0x1p-44 * magnitude > (1 + 0x1p-47) * r * r;
}

bool in_closed_triangle(const star_predicates& kernel, const point& a, const point& b,
                        const point& c, const point& q) {
  return kernel.orientation(a, b, q) != sign::negative &&
         kernel.orientation(b, c, q) != sign::negative &&
         kernel.orientation(c, a, q) != sign::negative;
}

bool in_box(const point& a, const point& b, const point& q) {
  return std::min(a.x, b.x) <= q.x && q.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= q.y &&
         q.y <= std::max(a.y, b.y);
}

// Whether replacing a b by a m, m b leaves every other site and subsegment where it was: on the
// same side of the boundary, uncrossed and untouched: where segments meet in a sharp corner, or a
// few ulps apart, m may be rounded onto another one. Only the sliver a, m, b changes sides.
bool sliver_is_empty(const star_predicates& kernel, const std::vector<site>& sites,
                     const boundary& edges, const neighbourhood& near,
                     const boundary_edge& subsegment, const point& m) {
  const point &a = sites[subsegment.a].position, &b = sites[subsegment.b].position;
  const sign turn = kernel.orientation(a, b, m);
  if (turn == sign::zero) return true;  // on the segment, which is already part of the boundary
  const bool left = turn == sign::positive;
  const bounding_box box = box_of(a, b);  // m is in it
  const bool no_site = near.sites().visit_box(sites, box.low, box.high, [&](vertex_index w) {
    return w == subsegment.a || w == subsegment.b ||
           !in_closed_triangle(kernel, a, left ? b : m, left ? m : b, sites[w].position);
  });
  return no_site && near.subsegments().visit(box, [&](std::uint32_t i) {
    const boundary_edge& p = edges.subsegments()[i];
    const point &r = sites[p.a].position, &s = sites[p.b].position;
    return !on_open_segment(kernel, r, s, m) && !properly_cross(kernel, a, m, r, s) &&
           !properly_cross(kernel, m, b, r, s);
  });
}

}  // namespace

const domain_corner* refine_state::sharp_corner(vertex_index v,
                                                const boundary_edge& subsegment) const {
  for (const domain_corner& c : corners_at(v)) {
    if (c.angle >= sharp_angle) continue;
    const boundary_corner ends = edges_.corners(v)[c.sector];
    if (subsegment.a == v ? ends.first == subsegment.b : ends.last == subsegment.a) return &c;
  }
  return nullptr;
}

// Whether the angle beside the subsegment at its end v is sharp, on either side if it is internal.
bool refine_state::has_sharp_end(const boundary_edge& subsegment, vertex_index v) const {
  if (sharp_corner(v, subsegment) != nullptr) return true;
  boundary_edge other_way = subsegment;
  std::swap(other_way.a, other_way.b);
  return subsegment.internal && sharp_corner(v, other_way) != nullptr;
}

// The far end of the subsegment across a sharp corner, when it is no nearer to the corner.
bool refine_state::is_excused(const boundary_edge& subsegment, vertex_index w) const {
  for (const vertex_index v : {subsegment.a, subsegment.b}) {
    const domain_corner* c = sharp_corner(v, subsegment);
    if (c == nullptr) continue;
    const boundary_corner ends = edges_.corners(v)[c->sector];
    if (w != (subsegment.a == v ? ends.last : ends.first)) continue;
    const site& corner = sites_[v];
    const point& far_end = sites_[subsegment.a == v ? subsegment.b : subsegment.a].position;
    const double to_w = std::sqrt(squared_distance(corner, sites_[w].position));
    const double to_far_end = std::sqrt(squared_distance(corner, far_end));
    if (to_w + rounding_of_distance(corner.metric, sites_[w].position, far_end) >=
        (1 - shell_slack) * to_far_end)
      return true;
  }
  return false;
}

bool refine_state::is_encroached(const star_predicates& kernel, std::size_t subsegment,
                                 const site& s, std::optional<vertex_index> self) const {
  const boundary_edge& p = edges_.subsegments()[subsegment];
  if (self && (*self == p.a || *self == p.b)) return false;
  const site &a = sites_[p.a], &b = sites_[p.b];
  if (kernel.orientation(a.position, b.position, s.position) != sign::positive) return false;
  if (self && is_excused(p, *self)) return false;
  return !surely_does_not_encroach(a, b, s) && kernel.encroaches(a, b, s);
}

std::vector<std::size_t> refine_state::encroached_by(const site& s) const {
  return encroached_by(*kernel_, s);
}

std::vector<std::size_t> refine_state::encroached_by(const star_predicates& kernel,
                                                     const site& s) const {
  std::vector<std::size_t> found;
  near_.influences().visit({s.position, s.position}, [&](std::uint32_t subsegment) {
    if (is_encroached(kernel, subsegment, s, std::nullopt)) found.push_back(subsegment);
    return true;
  });
  std::sort(found.begin(), found.end());
  return found;
}

// The first of them, so that the answer does not depend on how they were found.
std::optional<vertex_index> refine_state::find_encroacher(std::size_t subsegment) const {
  const boundary_edge& p = edges_.subsegments()[subsegment];
  const bounding_box box = influence_box(sites_[p.a], sites_[p.b]);
  std::optional<vertex_index> first;
  near_.sites().visit_box(sites_, box.low, box.high, [&](vertex_index w) {
    if ((!first || w < *first) && is_encroached(*kernel_, subsegment, sites_[w], w)) first = w;
    return true;
  });
  return first;
}

void refine_state::note_encroached_by(vertex_index w) {
  const point& q = sites_[w].position;
  std::vector<std::size_t> found;
  near_.influences().visit({q, q}, [&](std::uint32_t subsegment) {
    if (is_encroached(*kernel_, subsegment, sites_[w], w)) found.push_back(subsegment);
    return true;
  });
  std::sort(found.begin(), found.end());
  suspects_.insert(suspects_.end(), found.begin(), found.end());
}

point refine_state::split_point(const boundary_edge& subsegment) const {
  const site &a = sites_[subsegment.a], &b = sites_[subsegment.b];
  const bool sharp_a = has_sharp_end(subsegment, subsegment.a),
             sharp_b = has_sharp_end(subsegment, subsegment.b);
  if (!sharp_a && !sharp_b)
    if (const auto q = wedge_split_point(subsegment)) return *q;
  if (sharp_a == sharp_b) return bisector_point(a, b);
  const site &corner = sharp_a ? a : b, &other = sharp_a ? b : a;
  const double length = std::sqrt(squared_distance(corner, other.position));
  return point_at_distance(corner, other.position, shell_radius(length));
}

bool refine_state::can_split_at(const boundary_edge& subsegment, const site& m,
                                double shortest) const {
  const site &a = sites_[subsegment.a], &b = sites_[subsegment.b];
  if (!in_box(a.position, b.position, m.position)) return false;
  if (m.position == a.position || m.position == b.position) return false;
  for (const site* end : {&a, &b}) {
    const double least =
        std::min(squared_distance(*end, m.position), squared_distance(m, end->position));
    if (!(least > shortest * shortest)) return false;
  }
  return sliver_is_empty(*kernel_, sites_, edges_, near_, subsegment, m.position);
}

// Tells everybody but the stars.
void refine_state::put_on_subsegment(std::size_t subsegment, const site& m) {
  const auto added = static_cast<vertex_index>(sites_.size());
  const auto twin = edges_.twin(subsegment);
  std::size_t new_subsegment = edges_.subsegments().size();
  near_.before_split(sites_, edges_, subsegment);
  sites_.push_back(m);
  split_segment_.resize(sites_.size());
  split_segment_[added] = edges_.subsegments()[subsegment].segment;
  near_.add_site(sites_, added);
  edges_.split(subsegment, added);
  near_.after_split(sites_, edges_, subsegment, twin, new_subsegment);
  ++splits_;
  suspects_.push_back(subsegment);
  if (twin) suspects_.push_back(*twin);
  for (; new_subsegment < edges_.subsegments().size(); ++new_subsegment)
    suspects_.push_back(new_subsegment);
}

bool refine_state::split(std::size_t subsegment, double shortest) {
  return split_at(subsegment, split_point(edges_.subsegments()[subsegment]), shortest);
}

bool refine_state::split_at(std::size_t subsegment, const point& q, double shortest) {
  if (is_full()) return false;
  const boundary_edge whole = edges_.subsegments()[subsegment];
  const auto m = site_at(q);
  if (!m || !can_split_at(whole, *m, shortest)) return false;
  put_on_subsegment(subsegment, *m);
  const auto added = static_cast<vertex_index>(sites_.size() - 1);
  stars_.split_subsegment(oracle(), whole.a, added, whole.b);
  note_encroached_by(added);
  return true;
}

bool refine_state::split_at_place(const point& q, double shortest) {
  std::optional<std::size_t> first;  // of a subsegment and its twin
  near_.influences().visit({q, q}, [&](std::uint32_t subsegment) {
    const boundary_edge& p = edges_.subsegments()[subsegment];
    const point &a = sites_[p.a].position, &b = sites_[p.b].position;
    if ((!first || subsegment < *first) && on_open_segment(*kernel_, a, b, q)) first = subsegment;
    return true;
  });
  return first && split(*first, shortest);
}

bool refine_state::clear_encroachments(double shortest) {
  while (!suspects_.empty() && !is_full()) {
    if (is_overworked()) return false;
    const std::size_t subsegment = suspects_.back();
    suspects_.pop_back();
    const auto encroacher = find_encroacher(subsegment);
    if (!encroacher) continue;
    if (cancelled_.is_requested()) return false;
    const auto mirrored = mirrored_split_point(edges_.subsegments()[subsegment], *encroacher);
    if (!mirrored || !split_at(subsegment, *mirrored, shortest)) split(subsegment, shortest);
  }
  return true;
}

void refine_state::shorten_subsegments(double longest) {
  for (std::size_t subsegment = 0; subsegment < edges_.subsegments().size(); ++subsegment) {
    const auto too_long = [&] {
      const boundary_edge& p = edges_.subsegments()[subsegment];
      return std::max(subsegment_length(subsegment, p.a), subsegment_length(subsegment, p.b)) >
             longest;
    };
    while (too_long() && !cancelled_.is_requested() && !is_overworked() && split(subsegment, 0)) {
    }
  }
}

}  // namespace asterism::internal
