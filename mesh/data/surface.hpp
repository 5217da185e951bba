// SPDX-License-Identifier: MIT
//
// Holds surfaces in space: tensor patches of polynomials and of quotients of polynomials.
//
// A patch maps (u, v) to sum N_i(u) N_j(v) w_ij P_ij / sum N_i(u) N_j(v) w_ij, with the B-splines N
// of its knots. Without knots it is a Bezier patch over the unit square.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "asterism/mesh/data/trim_curve.hpp"

namespace asterism::internal {

struct space_point {
  double x = 0, y = 0, z = 0;
  friend bool operator==(const space_point&, const space_point&) = default;
};

struct control_point {
  space_point at;
  double weight = 1;
  friend bool operator==(const control_point&, const control_point&) = default;
};

// A tensor patch. `control` holds rows of constant i, each of `count_v` points. The knots are
// ascending, the first and last of each direction repeated degree + 1 times. With loops it is the
// part on the left of them; curves are numbered through all loops in order.
struct surface_patch {
  std::string name;
  int degree_u = 0, degree_v = 0;
  std::size_t count_u = 0, count_v = 0;
  std::vector<double> knots_u, knots_v;
  std::vector<control_point> control;
  std::vector<trim_loop> loops = {};

  const control_point& at(std::size_t i, std::size_t j) const { return control[i * count_v + j]; }
};

struct surface {
  std::string name;
  std::vector<surface_patch> patches;
  // Notes on what the reader changed or left out, a sentence each.
  std::vector<std::string> notes = {};
};

}  // namespace asterism::internal
