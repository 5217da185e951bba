// SPDX-License-Identifier: MIT
#include "asterism/mesh/draw/space_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/draw/canvas.hpp"

namespace asterism::internal {
namespace {

constexpr double line_width = 0.5;  // pixels or points
constexpr double least_side = 2.5;  // lines are left out where sides are shorter, in the mean
constexpr double around = -0.6, down = -1.05;  // radians; space_page/turning.js has the same

using vector = std::array<double, 3>;

double dot(const vector& a, const vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Returns the rows of the rotation: about z, then about the axis across the page.
std::array<vector, 3> first_turn() {
  const double c = elementary::cos(around), s = elementary::sin(around);
  const double d = elementary::cos(down), e = elementary::sin(down);
  return {{{c, -s, 0}, {d * s, d * c, -e}, {e * s, e * c, d}}};
}

struct seen_mesh {
  std::vector<vector> points;  // across, up, towards the eye
  vector low{}, high{};
};

seen_mesh seen(const space_mesh& m) {
  const auto turn = first_turn();
  seen_mesh s;
  for (const space_point& p : m.points) {
    const vector at = {p.x, p.y, p.z};
    s.points.push_back({dot(turn[0], at), dot(turn[1], at), dot(turn[2], at)});
  }
  s.low = s.high = s.points[m.triangles[0][0]];
  for (const space_triangle& t : m.triangles)
    for (const std::uint32_t v : t)
      for (std::size_t k = 0; k < 3; ++k) {
        s.low[k] = std::min(s.low[k], s.points[v][k]);
        s.high[k] = std::max(s.high[k], s.points[v][k]);
      }
  return s;
}

// Returns one of three parts of a face's colour. Hues of faces are a golden ratio of the circle
// apart.
double part_of_hue(std::size_t face, int part) {
  const double turns = 0.58 + static_cast<double>(face) * 0.618034;
  const double k = std::fmod(part + 6 * (turns - std::floor(turns)), 6.0);
  return 0.78 - 0.30 * std::max(0.0, std::min({k, 4 - k, 1.0}));
}

// Returns a face's colour lit from above on the right; the other side is darker.
colour shade(const vector& normal, std::size_t face) {
  const double size = std::sqrt(dot(normal, normal));
  const vector light = {0.28, 0.466, 0.839};
  double share = 0.38 + (size > 0 ? 0.62 * std::abs(dot(normal, light)) / size : 0);
  if (normal[2] < 0) share *= 0.72;
  return {share * part_of_hue(face, 5), share * part_of_hue(face, 3), share * part_of_hue(face, 1)};
}

vector normal_of(const vector& a, const vector& b, const vector& c) {
  const vector p = {b[0] - a[0], b[1] - a[1], b[2] - a[2]},
               q = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

// Returns the triangles from the farthest on, equally far ones by number.
std::vector<std::size_t> from_behind(const space_mesh& m, const seen_mesh& s) {
  std::vector<double> depth;
  for (const space_triangle& t : m.triangles)
    depth.push_back(s.points[t[0]][2] + s.points[t[1]][2] + s.points[t[2]][2]);
  std::vector<std::size_t> order(m.triangles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return depth[a] < depth[b]; });
  return order;
}

struct page {
  int width = 0, height = 0;
  double margin = 0, scale = 0;
  bool lines = true;
};

result<page> lay_out(const space_mesh& m, const seen_mesh& s, int width) {
  if (auto wrong = fault_of_width(width)) return *wrong;
  page p;
  p.width = width;
  p.margin = 0.03 * width;
  const double wide = s.high[0] - s.low[0], tall = s.high[1] - s.low[1];
  // Limits the height to the width: a taller mesh is drawn smaller.
  p.scale = (width - 2 * p.margin) / std::max(wide, tall);
  if (!(p.scale > 0) || !std::isfinite(p.scale))
    return error{"the mesh has no width to draw, or too large a one"};
  p.height = std::max(1, static_cast<int>(std::ceil(tall * p.scale + 2 * p.margin)));
  const double area = wide * tall * p.scale * p.scale / static_cast<double>(m.triangles.size());
  p.lines = area > least_side * least_side;
  return p;
}

void paint_triangle(canvas& on, const page& p, const seen_mesh& s, const space_triangle& t,
                    std::size_t face) {
  const double spare = (p.width - 2 * p.margin - (s.high[0] - s.low[0]) * p.scale) / 2;
  on.begin_path();
  for (const std::uint32_t v : t)
    on.line_to({p.margin + spare + (s.points[v][0] - s.low[0]) * p.scale,
                p.margin + (s.high[1] - s.points[v][1]) * p.scale});
  on.close_path();
  const colour own = shade(normal_of(s.points[t[0]], s.points[t[1]], s.points[t[2]]), face);
  on.use(own);
  on.fill_and_keep();
  // Strokes the triangle's edges in its own colour, which covers the seams to its neighbours.
  if (p.lines) on.use({0.55 * own.red, 0.55 * own.green, 0.55 * own.blue});
  on.stroke();
}

}  // namespace

result<std::string> draw_space_picture(const space_mesh& m, picture_format format, int width) {
  if (m.triangles.empty()) return error{"there is nothing to draw: the mesh has no triangles"};
  const seen_mesh s = seen(m);
  const auto layout = lay_out(m, s, width);
  if (!layout) return layout.failure();
  const page& p = layout.value();
  const std::vector<std::size_t> order = from_behind(m, s);
  return paint_file(format, p.width, p.height, [&](canvas& on) {
    on.use(paper);
    on.paint();
    on.set_line_width(line_width);
    for (const std::size_t t : order)
      paint_triangle(on, p, s, m.triangles[t], m.faces.empty() ? 0 : m.faces[t]);
  });
}

}  // namespace asterism::internal
