// SPDX-License-Identifier: MIT
#include "asterism/mesh/search/triangle_locator.hpp"

#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "asterism/mesh/data/site_box.hpp"
#include "asterism/mesh/support/parallel.hpp"

namespace asterism::internal {
namespace {

// Bound of rounding errors of weights: these are below 1e-12 where a triangle is not very thin.
constexpr double roundings = 1e-9;
constexpr double no_depth = -std::numeric_limits<double>::infinity();

double doubled_area(const point& a, const point& b, const point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

std::vector<triangle> counter_clockwise(const mesh& m) {
  constexpr std::size_t chunk = 8192;
  const auto append = [&m](std::size_t begin, std::size_t end, std::vector<triangle>& kept) {
    for (std::size_t i = begin; i < end; ++i) {
      const triangle& t = m.triangles[i];
      if (doubled_area(m.sites[t[0]].position, m.sites[t[1]].position, m.sites[t[2]].position) > 0)
        kept.push_back(t);
    }
  };
  return collect_chunks<triangle>(m.triangles.size(), chunk, append);
}

// Computes the weights of the corners at q, and returns the least one. Ends early once a weight is
// below `least`, and returns that.
double find_weights(const std::vector<point>& places, const triangle& t, const point& q,
                    double least, std::array<double, 3>& weights) {
  const point &a = places[t[0]], &b = places[t[1]], &c = places[t[2]];
  const double whole = doubled_area(a, b, c);
  weights[0] = doubled_area(q, b, c) / whole;
  if (weights[0] < least) return weights[0];
  weights[1] = doubled_area(a, q, c) / whole;
  if (weights[1] < least) return weights[1];
  weights[2] = doubled_area(a, b, q) / whole;
  return std::min({weights[0], weights[1], weights[2]});
}

void raise_negative_weights(triangle_locator::located& found) {
  for (double& w : found.weights) w = std::max(0.0, w);
}

}  // namespace

triangle_locator::triangle_locator(const mesh& m) : triangle_locator(m, box_of_sites(m.sites)) {}

triangle_locator::triangle_locator(const mesh& m, const bounding_box& box)
    : places_(positions_of(m.sites)), triangles_(counter_clockwise(m)), box_(box) {
  make_bins();
  across_ = std::move(mesh_links(places_.size(), triangles_, mesh_links::lists::no_neighbours))
                .take_across();
}

triangle_locator::triangle_locator(std::vector<point> places, std::vector<triangle> triangles,
                                   corner_links across)
    : places_(std::move(places)),
      triangles_(std::move(triangles)),
      across_(std::move(across)),
      box_(box_of_places(places_)),
      first_in_bin_(1),
      last_found_(1) {}

// Makes bins over the box, one for a few triangles, each with the last triangle that has its first
// corner there.
void triangle_locator::make_bins() {
  constexpr double triangles_in_bin = 4;
  bins_in_row_ = 1 + static_cast<std::size_t>(
                         std::sqrt(static_cast<double>(triangles_.size()) / triangles_in_bin));
  first_in_bin_.assign(bins_in_row_ * bins_in_row_, 0);
  for (vertex_index t = 0; t < triangles_.size(); ++t)
    first_in_bin_[bin_of(places_[triangles_[t][0]])] = t;
  last_found_ = std::vector<std::atomic<vertex_index>>(first_in_bin_.size());
  for (std::size_t bin = 0; bin < first_in_bin_.size(); ++bin)
    last_found_[bin].store(first_in_bin_[bin], std::memory_order_relaxed);
}

// Returns the number of the bin that q is in, or of one on the border if q is outside of the box.
std::size_t triangle_locator::bin_of(const point& q) const {
  const auto place = [this](double at, double low, double high) {
    const double part = (at / 2 - low / 2) / (high / 2 - low / 2);
    return part > 0 ? static_cast<std::size_t>(std::min(part, 1.0) *
                                               static_cast<double>(bins_in_row_ - 1))
                    : 0;
  };
  return place(q.x, box_.low.x, box_.high.x) + bins_in_row_ * place(q.y, box_.low.y, box_.high.y);
}

bounding_box triangle_locator::box_around(vertex_index t) const {
  const triangle& c = triangles_[t];
  bounding_box around = box_of(places_[c[0]], places_[c[1]]);
  around.include(places_[c[2]]);
  return around;
}

const box_index& triangle_locator::boxes() const {
  std::call_once(are_indexed_, [this] {
    boxes_ = box_index(box_);
    for (vertex_index t = 0; t < triangles_.size(); ++t) boxes_.insert(t, box_around(t));
  });
  return boxes_;
}

// Doubles the search box around q until it holds triangles; the last box is thousands of times as
// wide as the mesh.
triangle_locator::located triangle_locator::deepest(const point& q) const {
  constexpr int most_doublings = 64;
  const double extent =
      std::max(box_.high.x / 2 - box_.low.x / 2, box_.high.y / 2 - box_.low.y / 2);
  located best;
  double depth = no_depth, half = 0;
  std::array<double, 3> weights{};
  for (int i = 0; i <= most_doublings && depth == no_depth; ++i) {
    best.reach = half;
    boxes().visit({{q.x - half, q.y - half}, {q.x + half, q.y + half}}, [&](std::uint32_t t) {
      ++best.looked_at;
      const double here = find_weights(places_, triangles_[t], q, depth, weights);
      if (here > depth || (here == depth && t < best.triangle)) {
        best.triangle = t;
        best.weights = weights;
        depth = here;
      }
      return true;
    });
    half = half == 0 ? std::ldexp(extent, -50) : 2 * half;
  }
  if (depth == no_depth) best.weights = {1, 0, 0};
  raise_negative_weights(best);
  return best;
}

bool triangle_locator::walk(const point& q, located& at) const {
  // Tolerance of weights: their roundings are a few 1e-16 in a triangle that is not thin. Only the
  // choice between two neighbours depends on it, and both agree at their common edge.
  constexpr double slack = 1e-12;
  for (std::size_t step = 0; step < most_steps_; ++step) {
    const triangle& t = triangles_[at.triangle];
    const point &a = places_[t[0]], &b = places_[t[1]], &c = places_[t[2]];
    const double whole = doubled_area(a, b, c), least = -slack * whole;
    const double at_a = doubled_area(q, b, c), at_b = doubled_area(a, q, c),
                 at_c = doubled_area(a, b, q);
    // Compares without branches, as a processor would predict every second one wrong.
    if ((at_a >= least) & (at_b >= least) & (at_c >= least)) {
      at.weights = {at_a / whole, at_b / whole, at_c / whole};
      return true;
    }
    const bool is_at_a = (at_a <= at_b) & (at_a <= at_c), is_before_c = at_b <= at_c;
    const std::size_t i = (is_at_a ? 0U : 1U) * (is_before_c ? 1U : 2U);
    at.triangle = across_[at.triangle][i];
    if (at.triangle == no_triangle) return false;
  }
  return false;
}

triangle_locator::located triangle_locator::nearby(const point& q, vertex_index hint) const {
  if (hint >= triangles_.size()) return deepest_by_walk(q);
  located at;
  at.triangle = hint;
  if (!walk(q, at)) at = deepest_by_walk(q);
  raise_negative_weights(at);
  return at;
}

// Returns the result of deepest(), mostly by a walk from the bin of q: the boxes, of which
// deepest() makes an index, take as long as tens of thousands of walks. No search changes where the
// walk begins, so that every run does the same.
triangle_locator::located triangle_locator::deepest_by_walk(const point& q) const {
  located at;
  at.triangle = first_in_bin_[bin_of(q)];
  if (!walk(q, at)) return deepest(q);
  if (!is_in_one(at)) {
    const auto beside = deepest_beside(q, at);
    if (!beside) return deepest(q);
    at = *beside;
  }
  raise_negative_weights(at);
  return at;
}

bool triangle_locator::is_corner(const point& q, vertex_index t) const {
  const triangle& c = triangles_[t];
  return places_[c[0]] == q || places_[c[1]] == q || places_[c[2]] == q;
}

// True if q is in no other triangle of the triangulation, not even up to roundings.
bool triangle_locator::is_in_one(const located& at) const {
  for (std::size_t i = 0; i < 3; ++i) {
    const bool is_outer = across_[at.triangle][i] == no_triangle;
    if (!(is_outer ? at.weights[i] >= 0 : at.weights[i] > roundings)) return false;
  }
  return true;
}

// Returns the result of deepest(), where `from` is a triangle that q is in up to roundings: the
// others that q is in are beyond edges on which, or at whose ends, q is. Returns nothing where
// these are many.
std::optional<triangle_locator::located> triangle_locator::deepest_beside(
    const point& q, const located& from) const {
  constexpr std::size_t most = 32;
  boost::container::static_vector<vertex_index, most> found{from.triangle};
  located best = from;
  double depth = no_depth;
  const bounding_box at_q{q, q};
  for (std::size_t k = 0; k < found.size(); ++k) {
    located here;
    here.triangle = found[k];
    const double least =
        find_weights(places_, triangles_[here.triangle], q, no_depth, here.weights);
    const bool is_better = least > depth || (least == depth && here.triangle < best.triangle);
    // Takes only triangles whose boxes have q, as deepest() does: others may contain it by
    // roundings.
    if (is_better && boxes_meet(box_around(here.triangle), at_q)) {
      best = here;
      depth = least;
    }
    for (std::size_t i = 0; i < 3 && least >= -roundings; ++i) {
      const vertex_index beyond = across_[here.triangle][i];
      if (here.weights[i] > roundings || beyond == no_triangle) continue;
      if (std::find(found.begin(), found.end(), beyond) != found.end()) continue;
      if (found.size() == most) return std::nullopt;
      found.push_back(beyond);
    }
  }
  return depth == no_depth ? std::nullopt : std::optional(best);
}

triangle_locator::located triangle_locator::find(const point& q) const {
  std::atomic<vertex_index>& last = last_found_[bin_of(q)];
  located at;
  at.triangle = last.load(std::memory_order_relaxed);
  if (!walk(q, at)) {
    at = deepest(q);
  } else if (!is_in_one(at) && !is_corner(q, at.triangle)) {
    const auto beside = deepest_beside(q, at);
    at = beside ? *beside : deepest(q);
  }
  last.store(at.triangle, std::memory_order_relaxed);
  raise_negative_weights(at);
  return at;
}

std::vector<graph_edge> triangle_locator::edges() const {
  std::vector<graph_edge> found;
  for (vertex_index t = 0; t < triangles_.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      if (across_[t][i] > t)
        found.push_back({triangles_[t][(i + 1) % 3], triangles_[t][(i + 2) % 3]});
  return found;
}

}  // namespace asterism::internal
