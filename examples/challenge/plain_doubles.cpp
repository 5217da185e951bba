// SPDX-License-Identifier: MIT
//
// Textbook formulas in doubles, as most programs use them.
#include "record_reader.hpp"

namespace {

using challenge_adapter::sign_of;

int orient2d(const double* p) {
  return sign_of((p[2] - p[0]) * (p[5] - p[1]) - (p[3] - p[1]) * (p[4] - p[0]));
}

// Squared length of (x, y) in the metric m.
double squared_length(const double* m, double x, double y) {
  return m[0] * x * x + 2 * m[1] * x * y + m[2] * y * y;
}

// Returns the determinant of three points, relative to the fourth, lifted to the paraboloid of the
// metric.
int in_circle(const double* m, const double* p) {
  const double ax = p[0] - p[6], ay = p[1] - p[7], bx = p[2] - p[6], by = p[3] - p[7];
  const double cx = p[4] - p[6], cy = p[5] - p[7];
  return sign_of(squared_length(m, ax, ay) * (bx * cy - by * cx) -
                 squared_length(m, bx, by) * (ax * cy - ay * cx) +
                 squared_length(m, cx, cy) * (ax * by - ay * bx));
}

// Two sites x y m11 m12 m22, and a point.
int compare_distance(const double* n) {
  return sign_of(squared_length(n + 2, n[10] - n[0], n[11] - n[1]) -
                 squared_length(n + 7, n[10] - n[5], n[11] - n[6]));
}

bool answer(const std::string& name, const std::vector<double>& n, int& given) {
  constexpr double plane[3] = {1, 0, 1};
  const double* const first = n.data();
  if ((name == "orient2d" || name == "orientation") && n.size() == 6)
    given = orient2d(first);
  else if (name == "incircle" && n.size() == 8)
    given = in_circle(plane, first);
  else if (name == "in_circle" && n.size() == 11)
    given = in_circle(first, first + 3);
  else if (name == "is_spd" && n.size() == 3)
    given = n[0] > 0 && n[0] * n[2] - n[1] * n[1] > 0 ? 1 : 0;
  else if (name == "compare_distance" && n.size() == 12)
    given = compare_distance(first);
  else
    return false;
  return true;
}

}  // namespace

int main() { return challenge_adapter::answer_records(answer); }
