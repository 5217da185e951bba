// SPDX-License-Identifier: MIT
#include "asterism/mesh/refine/split_boundary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/numerics/constructions.hpp"
#include "asterism/mesh/numerics/metric_box.hpp"
#include "asterism/mesh/numerics/triangle_quality.hpp"
#include "asterism/mesh/refine/encroachment_filter.hpp"
#include "asterism/mesh/stars/split_place.hpp"
#include "asterism/mesh/stars/visibility.hpp"

namespace asterism::internal {
namespace {

// Relative tolerance for equal lengths on one shell: they differ by the rounding of lengths and of
// points.
constexpr double shell_slack = 1e-6;

// Returns a bound of the change of the distance of two points when both are rounded to doubles:
// half a unit in the last place for each coordinate of each point, and so one unit of the larger
// coordinate along either axis.
double rounding_of_distance(const metric_tensor& m, const point& a, const point& b) {
  const double x = 0x1p-52 * std::max(std::abs(a.x), std::abs(b.x));
  const double y = 0x1p-52 * std::max(std::abs(a.y), std::abs(b.y));
  return std::sqrt(m.m11) * x + std::sqrt(m.m22) * y;
}

// Returns a box around the disk that has the subsegment for its diameter, with room for roundings:
// in one metric nothing outside encroaches.
bounding_box disk_box(const site& a, const site& b) {
  constexpr double room = 1 + 0x1p-20;
  const site middle{{a.position.x / 2 + b.position.x / 2, a.position.y / 2 + b.position.y / 2},
                    a.metric};
  const double radius = std::sqrt(squared_distance(a, b.position)) / 2;
  bounding_box box = box_around(middle, room * radius);
  box.include(a.position);
  box.include(b.position);
  return box;
}

// Returns an upper bound of the distance, in an encroaching site's own metric, from that site to
// the nearest point of the subsegment. Every point of the subsegment has an end within this
// distance (refine/encroachment_filter.cpp), and an encroaching site is nearer to some point than
// both ends.
double reach_of_encroachers(const site& a, const site& b) {
  constexpr double room = 1 + 0x1p-20;
  const double from_a = std::sqrt(squared_distance(a, b.position)),
               from_b = std::sqrt(squared_distance(b, a.position));
  const double reach = room * (from_a * from_b / (from_a + from_b));
  return reach > 0 ? reach : std::numeric_limits<double>::infinity();
}

bool contains(const bounding_box& box, const point& q) {
  return box.low.x <= q.x && q.x <= box.high.x && box.low.y <= q.y && q.y <= box.high.y;
}

// Returns the power of two nearest to half the length, as a ratio: within a factor sqrt(2) of it.
double shell_radius(double length) {
  return elementary::exp2(std::round(elementary::log2(length / 2)));
}

}  // namespace

result<split_boundary> split_boundary::build(const domain& d, const star_predicates& kernel,
                                             site_set& sites) {
  split_boundary made(kernel, sites);
  auto edges = boundary::build(d, kernel);
  if (!edges) return edges.failure();
  made.edges_ = std::move(edges).value();
  sites.index(made.edges_);
  made.curves_ = curved_splits(d);
  made.find_corners();
  made.note_sharp_corners();
  made.wedges_ = narrow_wedges(made.edges_);
  for (const domain_corner& c : made.corners_) {
    if (!c.is_sharp()) continue;
    const auto [leaving, entering] = made.subsegments_at(c);
    made.wedges_.add(c, made.edges_.subsegments()[leaving], made.edges_.subsegments()[entering]);
  }
  return made;
}

void split_boundary::find_corners() {
  for (vertex_index v = 0; v < sites().size(); ++v) {
    const auto& at_v = edges_.corners(v);
    for (std::size_t i = 0; i < at_v.size(); ++i) {
      const point &first = sites()[at_v[i].first].position, &last = sites()[at_v[i].last].position;
      if (kernel_->orientation(sites()[v].position, first, last) == sign::positive)
        corners_.push_back({v, i, corner_angle(sites()[v], first, last)});
    }
  }
}

std::span<const domain_corner> split_boundary::corners_at(vertex_index v) const {
  const auto [first, last] = std::equal_range(
      corners_.begin(), corners_.end(), domain_corner{v, 0, 0},
      [](const domain_corner& a, const domain_corner& b) { return a.vertex < b.vertex; });
  // Takes pointers, since libc++ 13 makes no span of its vector's iterators.
  return {corners_.data() + (first - corners_.begin()), static_cast<std::size_t>(last - first)};
}

// Finds the subsegment in the index, which must contain it.
std::size_t split_boundary::find_subsegment(vertex_index a, vertex_index b) const {
  std::size_t found = edges_.subsegments().size();
  near().subsegments().visit(box_of(sites()[a].position, sites()[b].position),
                             [&](std::uint32_t i) {
                               const boundary_edge& p = edges_.subsegments()[i];
                               if (p.a == a && p.b == b) found = i;
                               return found != i;
                             });
  return found;
}

std::array<std::size_t, 2> split_boundary::subsegments_at(const domain_corner& c) const {
  const boundary_corner ends = edges_.corners(c.vertex)[c.sector];
  return {find_subsegment(c.vertex, ends.first), find_subsegment(ends.last, c.vertex)};
}

double split_boundary::subsegment_length(std::size_t subsegment, vertex_index from) const {
  const boundary_edge& p = edges_.subsegments()[subsegment];
  const point &a = sites()[p.a].position, &b = sites()[p.b].position;
  const point d{b.x - a.x, b.y - a.y};
  return std::sqrt(squared_length(sites()[from].metric, d));
}

// Records the sharp corners by the segments beside them, before any split. A split changes the
// vertex next to a segment's end, but neither that end nor whether the segment leaves or enters it.
void split_boundary::note_sharp_corners() {
  const std::vector<boundary_edge>& all = edges_.subsegments();
  std::size_t segments = 0;
  for (const boundary_edge& p : all) segments = std::max<std::size_t>(segments, p.segment + 1);
  sharp_at_.resize(segments);
  for (const boundary_edge& p : all)
    for (const vertex_index v : {p.a, p.b}) {
      const auto& at_v = edges_.corners(v);
      for (const domain_corner& c : corners_at(v)) {
        const auto [first, last] = at_v[c.sector];
        const bool is_beside = p.a == v ? first == p.b : last == p.a;
        const auto index = static_cast<std::size_t>(&c - corners_.data());
        if (c.is_sharp() && is_beside) sharp_at_[p.segment].push_back({v, p.a == v, index});
      }
    }
}

const domain_corner* split_boundary::sharp_corner(vertex_index v,
                                                  const boundary_edge& subsegment) const {
  for (const segment_corner& c : sharp_at_[subsegment.segment])
    if (c.vertex == v && c.leaving == (subsegment.a == v)) return &corners_[c.corner];
  return nullptr;
}

// True if the angle beside the subsegment at its end v is sharp, on either side if it is internal.
bool split_boundary::has_sharp_end(const boundary_edge& subsegment, vertex_index v) const {
  if (sharp_corner(v, subsegment) != nullptr) return true;
  boundary_edge other_way = subsegment;
  std::swap(other_way.a, other_way.b);
  return subsegment.internal && sharp_corner(v, other_way) != nullptr;
}

// True if w, which encroaches, is excused: it is the far end of the subsegment across a sharp
// corner, and no nearer to the corner.
bool split_boundary::is_excused(const boundary_edge& subsegment, vertex_index w) const {
  for (const vertex_index v : {subsegment.a, subsegment.b}) {
    const domain_corner* c = sharp_corner(v, subsegment);
    if (c == nullptr) continue;
    const boundary_corner ends = edges_.corners(v)[c->sector];
    if (w != (subsegment.a == v ? ends.last : ends.first)) continue;
    const site& corner = sites()[v];
    const point& far_end = sites()[subsegment.a == v ? subsegment.b : subsegment.a].position;
    const double to_w = std::sqrt(squared_distance(corner, sites()[w].position));
    const double to_far_end = std::sqrt(squared_distance(corner, far_end));
    if (to_w + rounding_of_distance(corner.metric, sites()[w].position, far_end) >=
        (1 - shell_slack) * to_far_end)
      return true;
  }
  return false;
}

// True if the Voronoi cell of a site at this place meets the subsegment, from either side.
bool split_boundary::is_reached(const star_predicates& kernel, const boundary_edge& p,
                                const site& s) const {
  const site &a = sites()[p.a], &b = sites()[p.b];
  const uncertain_bool quickly = encroaches_quickly(a, b, s);
  if (!quickly.certain()) return kernel.encroaches(a, b, s);
  ++kernel.counters().at(predicate::encroaches, tier::semi_static);
  return quickly.value();
}

bool split_boundary::is_encroached(const star_predicates& kernel, std::size_t subsegment,
                                   const site& s, std::optional<vertex_index> self) const {
  const boundary_edge& p = edges_.subsegments()[subsegment];
  if (self && (*self == p.a || *self == p.b)) return false;
  const site &a = sites()[p.a], &b = sites()[p.b];
  if (kernel.orientation(a.position, b.position, s.position) != sign::positive) return false;
  if (self && is_excused(p, *self)) return false;
  return is_reached(kernel, p, s);
}

std::vector<std::size_t> split_boundary::encroached_by(const star_predicates& kernel,
                                                       const site& s) const {
  std::vector<std::size_t> found;
  near().influences().visit({s.position, s.position}, [&](std::uint32_t subsegment) {
    if (is_encroached(kernel, subsegment, s, std::nullopt)) found.push_back(subsegment);
    return true;
  });
  std::sort(found.begin(), found.end());
  return found;
}

// Calls visit(w) for each site of the subsegment's box that may be near enough to encroach.
template <class Visit>
void split_boundary::visit_near(const boundary_edge& p, const Visit& visit) const {
  const site &a = sites()[p.a], &b = sites()[p.b];
  if (sites_->has_one_metric()) {
    const bounding_box box = disk_box(a, b);
    near().sites().visit_box(sites(), box.low, box.high, visit);
    return;
  }
  const bounding_box box = influence_box(a, b);
  near().sites().visit_seeing(
      box_of(a.position, b.position), reach_of_encroachers(a, b),
      [&](vertex_index w) { return !contains(box, sites()[w].position) || visit(w); });
}

// Returns a site that encroaches, if there is one. In a narrow wedge it is the encroaching site
// with the least number, so that the answer does not depend on the order of the search: the
// subsegment is split at that site's distance from the corner. Elsewhere any encroaching site is
// returned, and exact tests are made only if doubles decide for no site that it encroaches.
std::optional<vertex_index> split_boundary::find_encroacher(std::size_t subsegment) const {
  const boundary_edge& p = edges_.subsegments()[subsegment];
  const bool any_will_do = !wedges_.is_mirrored(p.segment);
  std::optional<vertex_index> first;
  std::vector<vertex_index> undecided;
  visit_near(p, [&](vertex_index w) {
    if (first && w > *first) return true;
    if (any_will_do && w != p.a && w != p.b) {
      const uncertain_bool quickly = encroaches_quickly(sites()[p.a], sites()[p.b], sites()[w]);
      if (!quickly.certain()) undecided.push_back(w);
      if (!quickly.certain() || !quickly.value()) return true;
    }
    if (is_encroached(*kernel_, subsegment, sites()[w], w)) first = w;
    return !(first && any_will_do);
  });
  for (std::size_t i = 0; i < undecided.size() && !first; ++i)
    if (is_encroached(*kernel_, subsegment, sites()[undecided[i]], undecided[i]))
      first = undecided[i];
  return first;
}

void split_boundary::note_encroached_by(vertex_index w) {
  const point& q = sites()[w].position;
  std::vector<std::size_t> found;
  near().influences().visit({q, q}, [&](std::uint32_t subsegment) {
    if (is_encroached(*kernel_, subsegment, sites()[w], w)) found.push_back(subsegment);
    return true;
  });
  std::sort(found.begin(), found.end());
  suspects_.insert(suspects_.end(), found.begin(), found.end());
}

point split_boundary::split_point(const boundary_edge& subsegment) const {
  const site &a = sites()[subsegment.a], &b = sites()[subsegment.b];
  const bool sharp_a = has_sharp_end(subsegment, subsegment.a),
             sharp_b = has_sharp_end(subsegment, subsegment.b);
  if (!sharp_a && !sharp_b)
    if (const auto q = wedges_.split_point(sites(), subsegment)) return *q;
  if (sharp_a == sharp_b) return bisector_point(a, b);
  const site &corner = sharp_a ? a : b, &other = sharp_a ? b : a;
  const double length = std::sqrt(squared_distance(corner, other.position));
  return point_at_distance(corner, other.position, shell_radius(length));
}

std::optional<point> split_boundary::place_on_curve(const boundary_edge& subsegment,
                                                    const point& q) const {
  auto place = curves_.place(subsegment, q);
  if (!place || has_sharp_end(subsegment, subsegment.a) || has_sharp_end(subsegment, subsegment.b))
    return std::nullopt;
  return wedges_.split_point(sites(), subsegment) ? std::nullopt : place;
}

bool split_boundary::can_split_at(const boundary_edge& subsegment, const site& m, double shortest,
                                  bool on_curve) const {
  const site &a = sites()[subsegment.a], &b = sites()[subsegment.b];
  for (const site* end : {&a, &b}) {
    const double least =
        std::min(squared_distance(*end, m.position), squared_distance(m, end->position));
    if (!(least > shortest * shortest)) return false;
  }
  return leaves_others_in_place(*kernel_, sites(), edges_, near(), subsegment, m.position,
                                on_curve);
}

// Adds the new site, and updates the index of boundary edges once before and once after the split.
void split_boundary::put_on_subsegment(std::size_t subsegment, const site& m, bool on_curve) {
  const auto twin = edges_.twin(subsegment);
  std::size_t new_subsegment = edges_.subsegments().size();
  proximity& near = sites_->near();
  near.before_split(sites_->all(), edges_, subsegment);
  const vertex_index added = sites_->add(m);
  wedges_.note_split(added, edges_.subsegments()[subsegment].segment);
  curves_.note_split(added, on_curve);
  edges_.split(subsegment, added);
  near.after_split(sites_->all(), edges_, subsegment, twin, new_subsegment);
  ++splits_;
  suspects_.push_back(subsegment);
  if (twin) suspects_.push_back(*twin);
  for (; new_subsegment < edges_.subsegments().size(); ++new_subsegment)
    suspects_.push_back(new_subsegment);
}

void split_boundary::suspect_all() {
  for (std::size_t subsegment = 0; subsegment < edges_.subsegments().size(); ++subsegment)
    suspects_.push_back(subsegment);
}

std::optional<split_boundary::encroachment> split_boundary::next_encroachment() {
  const std::size_t subsegment = suspects_.back();
  suspects_.pop_back();
  const auto encroacher = find_encroacher(subsegment);
  if (!encroacher) return std::nullopt;
  return encroachment{
      subsegment, wedges_.mirrored_point(sites(), edges_.subsegments()[subsegment], *encroacher)};
}

std::optional<std::size_t> split_boundary::subsegment_through(const point& q) const {
  std::optional<std::size_t> first;  // of a subsegment and its twin
  near().influences().visit({q, q}, [&](std::uint32_t subsegment) {
    const boundary_edge& p = edges_.subsegments()[subsegment];
    const point &a = sites()[p.a].position, &b = sites()[p.b].position;
    if ((!first || subsegment < *first) && on_open_segment(*kernel_, a, b, q)) first = subsegment;
    return true;
  });
  return first;
}

std::optional<std::size_t> split_boundary::subsegment_before(const triangle& t,
                                                             const point& q) const {
  std::optional<std::size_t> first;
  near().influences().visit({q, q}, [&](std::uint32_t subsegment) {
    const boundary_edge& p = edges_.subsegments()[subsegment];
    const point &a = sites()[p.a].position, &b = sites()[p.b].position;
    const bool is_before = std::any_of(t.begin(), t.end(), [&](vertex_index v) {
      return properly_cross(*kernel_, sites()[v].position, q, a, b) &&
             is_reached(*kernel_, p, {q, sites()[v].metric});
    });
    if (is_before && (!first || subsegment < *first)) first = subsegment;
    return true;
  });
  return first;
}

}  // namespace asterism::internal
