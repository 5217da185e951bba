// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/built_in_domains.hpp"

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "asterism/core/random.hpp"
#include "asterism/mesh/domain/point_in_domain.hpp"
#include "asterism/mesh/search/hilbert_order.hpp"

namespace asterism {
using namespace internal;

namespace {

// Returns half the thickness of a NACA 0012 section at x in [0,1], x the square of `root`.
double half_thickness(double root) {
  const double x = root * root;
  const double series = 0.2969 * root + x * (-0.1260 + x * (-0.3516 + x * (0.2843 + x * -0.1036)));
  return 5 * 0.12 * series;
}

// Appends the ring through the vertices from `first` to the last one.
void close_ring(domain& d, std::size_t first, int marker) {
  const std::size_t end = d.vertices.size();
  for (std::size_t i = first; i < end; ++i)
    d.segments.push_back({static_cast<vertex_index>(i),
                          static_cast<vertex_index>(i + 1 < end ? i + 1 : first), marker});
}

// A set of points by their numbers in a list, in one array that is never more than half full: for
// millions of points, mostly found in one access.
class known_points {
 public:
  explicit known_points(std::size_t most) : places_(std::bit_ceil(2 * most + 1), none) {}

  // Adds points[v]; returns false if a point at that place is in the set.
  bool add(const std::vector<point>& points, vertex_index v) {
    const std::size_t mask = places_.size() - 1;
    std::size_t at = mixed_bits(bits_of(points[v].x) + mixed_bits(bits_of(points[v].y))) & mask;
    for (; places_[at] != none; at = (at + 1) & mask)
      if (points[places_[at]] == points[v]) return false;
    places_[at] = v;
    return true;
  }

 private:
  static constexpr vertex_index none = std::numeric_limits<vertex_index>::max();
  // Returns the bits of a coordinate; -0.0 has those of 0.0, so that equal points are found.
  static std::uint64_t bits_of(double x) { return std::bit_cast<std::uint64_t>(x + 0.0); }

  std::vector<vertex_index> places_;
};

bounding_box shrunk(const bounding_box& box) {
  // Computes the box from its corners rather than from its extent, which may overflow.
  return {{0.95 * box.low.x + 0.05 * box.high.x, 0.95 * box.low.y + 0.05 * box.high.y},
          {0.05 * box.low.x + 0.95 * box.high.x, 0.05 * box.low.y + 0.95 * box.high.y}};
}

}  // namespace

domain square() {
  domain d;
  d.name = "square";
  d.vertices = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  d.segments = {{0, 1, 1}, {1, 2, 2}, {2, 3, 3}, {3, 0, 4}};
  return d;
}

result<domain> airfoil(const airfoil_options& options) {
  const std::size_t n = options.points_per_side;
  const bounding_box& box = options.box;
  if (n < 2 || n > 1000000)
    return error{"airfoil: " + std::to_string(n) + " intervals a side; 2 to 1000000 are possible",
                 error_code::bad_option};
  const bool surrounds = box.low.x < 0 && box.low.y < -0.06 && box.high.x > 1 && box.high.y > 0.06;
  if (!surrounds || !std::isfinite(box.low.x) || !std::isfinite(box.low.y) ||
      !std::isfinite(box.high.x) || !std::isfinite(box.high.y))
    return error{"airfoil: the box must contain [0,1] x [-0.06,0.06] and be finite",
                 error_code::bad_option};

  domain d;
  d.name = "airfoil";
  d.vertices = {box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}};
  close_ring(d, 0, 1);
  // Goes along the lower side from the trailing to the leading edge, back along the upper one. The
  // square root of x is a cubic of the parameter, which makes points denser at both edges. Unlike
  // the customary cosine the cubic needs no function of the C library, whose last bit may differ
  // between machines.
  const auto root_at = [n](std::size_t i) {
    const double t = static_cast<double>(i) / static_cast<double>(n);
    return t * (1.5 - 0.5 * t * t);
  };
  d.vertices.push_back({1, 0});
  for (std::size_t i = n - 1; i > 0; --i)
    d.vertices.push_back({root_at(i) * root_at(i), -half_thickness(root_at(i))});
  d.vertices.push_back({0, 0});
  for (std::size_t i = 1; i < n; ++i)
    d.vertices.push_back({root_at(i) * root_at(i), half_thickness(root_at(i))});
  close_ring(d, 4, 2);
  d.holes = {{0.5, 0}};
  return d;
}

// Numbers many points along a Hilbert curve: with consecutive numbers far apart in the plane,
// meshing would read memory in random order.
result<domain> add_random_points(domain d, std::size_t count, std::uint64_t seed) {
  constexpr std::size_t draws_per_point = 1000, many = 5000;
  const std::size_t given = d.vertices.size();
  d.vertices.reserve(d.vertices.size() + count);
  known_points taken(d.vertices.size() + count);
  for (vertex_index v = 0; v < d.vertices.size(); ++v) taken.add(d.vertices, v);
  const bounding_box box = shrunk(d.box());
  splitmix64 random(seed);
  for (std::size_t added = 0; added < count; ++added) {
    std::size_t draws = 0;
    for (bool accepted = false; !accepted; ++draws) {
      if (draws == draws_per_point)
        return error{"random points: " + std::to_string(added) + " of " + std::to_string(count) +
                         " found; " + std::to_string(draws) +
                         " draws in a row missed the inside of " + d.name,
                     error_code::bad_option};
      const double u = random.real(), v = random.real();
      const point q{(1 - u) * box.low.x + u * box.high.x, (1 - v) * box.low.y + v * box.high.y};
      if (!contains(d, q)) continue;
      d.vertices.push_back(q);
      accepted = taken.add(d.vertices, static_cast<vertex_index>(d.vertices.size() - 1));
      if (!accepted) d.vertices.pop_back();
    }
  }
  if (count >= many) sort_along_curve(std::span(d.vertices).subspan(given), d.box());
  return d;
}

}  // namespace asterism
