// SPDX-License-Identifier: MIT
//
// Holds the curves that trim a patch, in its plane of parameters. A loop is a closed chain of them:
// each ends where the next one starts, the region is on the left.
//
// A curve maps t to sum N_i(t) w_i c_i / sum N_i(t) w_i, with the B-splines N of its knots; without
// knots it is a Bezier curve from 0 to 1.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace asterism::internal {

struct trim_point {
  double u = 0, v = 0;
  double weight = 1;
  friend bool operator==(const trim_point&, const trim_point&) = default;
};

// Two curves with one edge name are the same curve in space, except for the gap between them. A
// place of the edge is a share of the parameters of each curve, from 0 to 1, or from 1 to 0 for a
// curve that runs backward.
struct trim_curve {
  int degree = 1;
  std::vector<double> knots;
  std::vector<trim_point> control;
  std::string edge;       // empty: no other curve has it
  bool backward = false;  // against its edge
  bool is_point = false;  // its edge is one point in space
  friend bool operator==(const trim_curve&, const trim_curve&) = default;
};

using trim_loop = std::vector<trim_curve>;

}  // namespace asterism::internal
