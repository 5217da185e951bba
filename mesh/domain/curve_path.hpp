// SPDX-License-Identifier: MIT
//
// Evaluates the curves of a domain in doubles, to propose where they are divided. The auditor
// bounds a point's distance from its curve by itself, exactly.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "asterism/mesh/data/domain_curve.hpp"

namespace asterism::internal {

// A curve of the domain, with the places of its ends.
class curve_path {
 public:
  // Requires ends that are not at the centre of an arc.
  curve_path(const domain_curve& curve, const point& start, const point& end);

  // Returns the point at a parameter from 0 to 1, rounded; the ends as they were given.
  point at(double t) const;
  point derivative(double t) const;
  // Returns the parameter of about the nearest point to q strictly between t0 and t1, of a piece
  // that goes forward along its chord; none if an end is nearest.
  std::optional<double> nearest(const point& q, double t0, double t1) const;
  // Returns points whose convex hull holds the piece from t0 to t1, up to rounding, and its chord:
  // three for an arc, four for a cubic, the ends first and last. An arc's piece must be below half
  // a turn.
  std::vector<point> control_points(double t0, double t1) const;
  // Returns about the greatest distance of the piece from its chord.
  double height(double t0, double t1) const;
  // True if the piece goes forward along its chord all the way: an arc by at most an eighth of a
  // turn, a cubic with every leg of its control polygon.
  bool is_straightforward(double t0, double t1) const;

  // Returns an arc's radius, and the angle that it turns by, negative if clockwise.
  double radius() const { return radius_; }
  double sweep() const { return sweep_; }

 private:
  point on_circle(double t, double reach) const;

  curve_kind kind_;
  point start_, end_;
  std::array<point, 2> control_;  // cubic
  point centre_;                  // arc, and so on
  double radius_ = 0, first_angle_ = 0, sweep_ = 0;
};

}  // namespace asterism::internal
