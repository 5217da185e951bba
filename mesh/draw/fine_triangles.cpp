// SPDX-License-Identifier: MIT
#include "asterism/mesh/draw/fine_triangles.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include "asterism/core/elementary.hpp"

namespace asterism::internal {
namespace {

struct triangle_size {
  double twice_area = 0, perimeter = 0;
};

triangle_size size_of(const mesh& m, const triangle& t) {
  const std::array<point, 3> p = {m.sites[t[0]].position, m.sites[t[1]].position,
                                  m.sites[t[2]].position};
  triangle_size size;
  size.twice_area =
      std::fabs((p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y));
  for (std::size_t i = 0; i < 3; ++i)
    size.perimeter += elementary::hypot(p[(i + 1) % 3].x - p[i].x, p[(i + 1) % 3].y - p[i].y);
  return size;
}

}  // namespace

std::vector<bool> hidden_by_lines(const mesh& m, double line_width) {
  std::vector<bool> hidden;
  hidden.reserve(m.triangles.size());
  for (const triangle& t : m.triangles) {
    const triangle_size size = size_of(m, t);
    // The radius of the inscribed circle is twice the area over the perimeter.
    hidden.push_back(size.twice_area < line_width * size.perimeter);
  }
  return hidden;
}

bool are_most(const mesh& m, const std::vector<bool>& of_triangles) {
  double these = 0, all = 0;
  for (std::size_t t = 0; t < of_triangles.size(); ++t) {
    const double area = size_of(m, m.triangles[t]).twice_area;
    all += area;
    if (of_triangles[t]) these += area;
  }
  return these > all / 2;
}

}  // namespace asterism::internal
