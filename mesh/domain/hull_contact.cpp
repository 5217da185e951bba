// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/hull_contact.hpp"

#include <algorithm>

#include "asterism/kernels/filtered_kernel.hpp"

namespace asterism::internal {
namespace {

// Points of a polygon that are on a line, the lexicographically first and last of them.
struct contact {
  bool any = false;
  point low, high;

  void add(const point& p) {
    if (!any || lexicographically_less(p, low)) low = p;
    if (!any || lexicographically_less(high, p)) high = p;
    any = true;
  }
};

// True if `polygon` is on the side of the line from p to q that `allowed` names, or on it.
bool is_on_side(const filtered_kernel& kernel, const std::vector<point>& polygon, const point& p,
                const point& q, sign allowed, contact& on_line) {
  return std::all_of(polygon.begin(), polygon.end(), [&](const point& r) {
    const sign side = kernel.orientation(p, q, r);
    if (side == sign::zero) on_line.add(r);
    return side == sign::zero || side == allowed;
  });
}

// True if the line from p to q, an edge of `own`, shows that nothing is shared but one corner.
bool separates(const filtered_kernel& kernel, const std::vector<point>& own,
               const std::vector<point>& other, const point& p, const point& q) {
  for (const sign side : {sign::positive, sign::negative}) {
    contact of_own, of_other;
    if (!is_on_side(kernel, own, p, q, side, of_own)) continue;
    if (!is_on_side(kernel, other, p, q, -side, of_other)) continue;
    if (!of_own.any || !of_other.any) return true;
    const point& low = lexicographically_less(of_own.low, of_other.low) ? of_other.low : of_own.low;
    const point& high =
        lexicographically_less(of_own.high, of_other.high) ? of_own.high : of_other.high;
    if (lexicographically_less(high, low)) return true;
    const auto is_corner_of = [&low](const std::vector<point>& polygon) {
      return std::find(polygon.begin(), polygon.end(), low) != polygon.end();
    };
    if (low == high && is_corner_of(own) && is_corner_of(other)) return true;
  }
  return false;
}

bool an_edge_separates(const filtered_kernel& kernel, const std::vector<point>& own,
                       const std::vector<point>& other) {
  if (own.size() < 2) return false;
  for (std::size_t i = 0; i < own.size(); ++i)
    if (separates(kernel, own, other, own[i], own[(i + 1) % own.size()])) return true;
  return false;
}

}  // namespace

std::vector<point> convex_hull(std::vector<point> points) {
  const filtered_kernel kernel;
  std::sort(points.begin(), points.end(), lexicographically_less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  // Builds the lower chain from left to right, then the upper one back.
  std::vector<point> hull;
  for (const bool lower : {true, false}) {
    const std::size_t start = hull.size();
    for (const point& p : points) {
      while (hull.size() >= start + 2 &&
             kernel.orientation(hull[hull.size() - 2], hull.back(), p) != sign::positive)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();  // it starts the other chain
    if (lower) std::reverse(points.begin(), points.end());
  }
  return hull;
}

bool hulls_meet(const std::vector<point>& a, const std::vector<point>& b) {
  const filtered_kernel kernel;
  return !an_edge_separates(kernel, a, b) && !an_edge_separates(kernel, b, a);
}

}  // namespace asterism::internal
