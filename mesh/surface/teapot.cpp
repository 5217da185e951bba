// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface/teapot.hpp"

#include <array>
#include <string>
#include <utility>

namespace asterism::internal {
namespace {

// A point of a profile: distance from the axis, height, and the distance of the inner control
// points of a quarter from the axes, which for a circle would be 0.5523 of the first.
struct profile_point {
  double radius, height, inner;
};
using profile = std::array<profile_point, 4>;

// Corners of a quarter in the order of turning from x to y, by signs of the coordinates.
constexpr std::array<std::array<double, 4>, 4> quarters = {
    {{1, 0, 0, 1}, {0, -1, 1, 0}, {-1, 0, 0, -1}, {0, 1, -1, 0}}};

void add_turned(surface& s, const std::string& name, const profile& p) {
  for (std::size_t k = 0; k < 4; ++k) {
    surface_patch patch;
    patch.name = name + " " + std::to_string(k + 1);
    patch.degree_u = patch.degree_v = 3;
    patch.count_u = patch.count_v = 4;
    // Computes coordinates from the axis x' towards y': x' = (c, s), y' = (-s, c) by the quarter's
    // signs.
    const double xx = quarters[k][0], xy = quarters[k][2], yx = quarters[k][1], yy = quarters[k][3];
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        const profile_point& at = p[j];
        const std::array<double, 4> along = {at.radius, at.radius, at.inner, 0};
        const double a = along[i], b = along[3 - i];
        // Adds 0, which makes -0 a 0, so that common points have the same bits.
        patch.control.push_back({{a * xx + b * yx + 0.0, a * xy + b * yy + 0.0, at.height}, 1});
      }
    }
    s.patches.push_back(std::move(patch));
  }
}

profile with_inner(std::array<std::array<double, 2>, 4> points, double ratio) {
  profile p;
  for (std::size_t k = 0; k < 4; ++k) p[k] = {points[k][0], points[k][1], ratio * points[k][0]};
  return p;
}

// A point of half a section of handle or spout. The inner and the outer end lie in the plane of
// symmetry, the two points between them beside it.
struct section {
  double inner_x, inner_z, outer_x, outer_z, half_width;
};
using swept = std::array<section, 4>;

void add_halves(surface& s, const std::string& name, const swept& sections) {
  for (const double side : {-1.0, 1.0}) {
    surface_patch patch;
    patch.name = name + (side < 0 ? " right" : " left");
    patch.degree_u = patch.degree_v = 3;
    patch.count_u = patch.count_v = 4;
    for (const section& c : sections) {
      const double y = side * c.half_width;
      std::array<space_point, 4> row = {{{c.inner_x, 0, c.inner_z},
                                         {c.inner_x, y, c.inner_z},
                                         {c.outer_x, y, c.outer_z},
                                         {c.outer_x, 0, c.outer_z}}};
      if (side > 0) std::swap(row[0], row[3]), std::swap(row[1], row[2]);
      for (const space_point& p : row) patch.control.push_back({p, 1});
    }
    s.patches.push_back(std::move(patch));
  }
}

}  // namespace

surface teapot_surface() {
  constexpr double round = 0.56;
  surface s;
  s.name = "teapot";
  // Lists profiles downward, except for the rim, which begins with its inside.
  add_turned(s, "rim",
             with_inner({{{1.5, 2.4}, {1.4375, 2.53125}, {1.3375, 2.53125}, {1.4, 2.4}}}, round));
  add_turned(s, "body", with_inner({{{2, 0.9}, {2, 1.35}, {1.75, 1.875}, {1.5, 2.4}}}, round));
  add_turned(s, "foot", with_inner({{{1.5, 0.15}, {1.5, 0.225}, {2, 0.45}, {2, 0.9}}}, round));
  add_halves(s, "handle",
             {{{-1.6, 2.025, -1.5, 2.25, 0.3},
               {-2.3, 2.025, -2.5, 2.25, 0.3},
               {-2.7, 2.025, -3, 2.25, 0.3},
               {-2.7, 1.8, -3, 1.8, 0.3}}});
  add_halves(s, "handle below",
             {{{-2.7, 1.8, -3, 1.8, 0.3},
               {-2.7, 1.575, -3, 1.35, 0.3},
               {-2.5, 1.125, -2.65, 0.9375, 0.3},
               {-2, 0.9, -1.9, 0.6, 0.3}}});
  add_halves(s, "spout",
             {{{1.7, 1.425, 1.7, 0.6, 0.66},
               {2.6, 1.425, 3.1, 0.825, 0.66},
               {2.3, 2.1, 2.4, 2.025, 0.25},
               {2.7, 2.4, 3.3, 2.4, 0.25}}});
  add_halves(s, "spout's mouth",
             {{{2.7, 2.4, 3.3, 2.4, 0.25},
               {2.8, 2.475, 3.525, 2.49375, 0.25},
               {2.9, 2.475, 3.45, 2.5125, 0.15},
               {2.8, 2.4, 3.2, 2.4, 0.15}}});
  profile knob = with_inner({{{0.2, 2.7}, {0, 2.85}, {0.8, 3.15}, {0, 3.15}}}, round);
  knob[2].inner = 0.45;
  add_turned(s, "knob", knob);
  add_turned(s, "lid", with_inner({{{1.3, 2.4}, {1.3, 2.55}, {0.4, 2.55}, {0.2, 2.7}}}, round));
  add_turned(s, "bottom", with_inner({{{0, 0}, {1.425, 0}, {1.5, 0.075}, {1.5, 0.15}}}, round));
  return s;
}

}  // namespace asterism::internal
