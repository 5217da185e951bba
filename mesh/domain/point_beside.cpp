// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/point_beside.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "asterism/kernels/filtered_kernel.hpp"

namespace asterism::internal {
namespace {

// True if the interiors of two segments cross.
bool cross(const point& a, const point& b, const point& p, const point& q) {
  const filtered_kernel kernel;
  const sign ap = kernel.orientation(a, b, p), aq = kernel.orientation(a, b, q),
             pa = kernel.orientation(p, q, a), pb = kernel.orientation(p, q, b);
  return ap != sign::zero && ap == -aq && pa != sign::zero && pa == -pb;
}

// True if the triangle of the segment and the point has no vertex and no part of a segment of the
// domain in it.
bool is_free(const domain& d, const segment& s, const point& p) {
  const filtered_kernel kernel;
  const point &a = d.vertices[s.a], &b = d.vertices[s.b];
  const sign side = kernel.orientation(a, b, p);
  if (side == sign::zero) return false;
  for (vertex_index v = 0; v < d.vertices.size(); ++v) {
    const point& q = d.vertices[v];
    if (v == s.a || v == s.b || q == a || q == b) continue;
    if (kernel.orientation(a, b, q) != -side && kernel.orientation(b, p, q) != -side &&
        kernel.orientation(p, a, q) != -side)
      return false;
  }
  return std::none_of(d.segments.begin(), d.segments.end(), [&](const segment& t) {
    const point &x = d.vertices[t.a], &y = d.vertices[t.b];
    return cross(a, p, x, y) || cross(b, p, x, y);
  });
}

// Returns the approximate distance from a point to the nearest other vertex or segment.
double room(const domain& d, std::size_t but, const point& p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < d.segments.size(); ++i) {
    if (i == but) continue;
    const point &a = d.vertices[d.segments[i].a], &b = d.vertices[d.segments[i].b];
    const double x = b.x - a.x, y = b.y - a.y, u = p.x - a.x, w = p.y - a.y;
    const double square = x * x + y * y;
    const double t = square > 0 ? std::clamp((u * x + w * y) / square, 0.0, 1.0) : 0.0;
    const double off = std::sqrt((u - t * x) * (u - t * x) + (w - t * y) * (w - t * y));
    if (off > 0) least = std::min(least, off);
  }
  return least;
}

}  // namespace

std::optional<point> point_beside(const domain& d, std::size_t segment, bool to_left) {
  const auto& s = d.segments[segment];
  const point &a = d.vertices[s.a], &b = d.vertices[s.b];
  const double x = b.x - a.x, y = b.y - a.y, length = std::sqrt(x * x + y * y);
  if (!(length > 0) || !std::isfinite(length)) return std::nullopt;
  const point middle{a.x + x / 2, a.y + y / 2};
  double off = std::min(room(d, segment, middle), length) / 4;
  constexpr int most_tries = 40;
  for (int k = 0; k < most_tries; ++k, off /= 2) {
    const double part = (to_left ? off : -off) / length;
    const point p{middle.x - part * y, middle.y + part * x};
    const sign side = filtered_kernel().orientation(a, b, p);
    if (side == (to_left ? sign::positive : sign::negative) && is_free(d, s, p)) return p;
  }
  return std::nullopt;
}

}  // namespace asterism::internal
