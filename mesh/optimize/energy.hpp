// SPDX-License-Identifier: MIT
//
// How far a triangle, and an edge between two, is from what fitting wants, in numbers to be made
// small. In plain doubles: it orders proposals, and decides nothing.
//
// Of a triangle (shape_energy), with c its nine cotangents, three corners as three vertices measure
// them, t the cotangent of the angle aimed at, and the area as the mean of the metrics sees it:
//   sum over c > t of (c - t)^2 + 4 (c - t)^4, plus 0.05 log^2(area / area wanted).
// The fourth power makes the worst angle count most; the area keeps the number of triangles. At a
// corner of the domain that is sharper than the bound angles count for little, and triangles
// smaller than wanted are welcome.
//
// Of an edge, from either side (far_site_energy): with x the Voronoi vertex of the triangle there,
// r its distance and g = d(x)^2 / r^2 - 1 as the site across measures: stars disagree about the
// edge where g < 0, so with h = (margin - g) / margin, if that is positive, h^2 + h times a weight.
// Of a subsegment of a segment (subsegment_energy) the same, with g how far x is on the inner side,
// as a part of the height of the triangle: a subsegment whose triangle has its x behind it is
// encroached.
#pragma once

#include <cstdint>

#include "asterism/core/site.hpp"

namespace asterism::internal::fitting {

// Cotangents of the angle aimed at, and of one a little above the bound: beyond it the energy is
// steeper.
struct angle_targets {
  double cotangent = 0, greatest = 0;
};

// A site, its metric as F^T F with F = [f11 f12; 0 f22], in which thin metrics lose little, and the
// logarithm of the metric area that triangles around it should have.
struct fit_site {
  point position;
  metric_tensor metric;
  double f11 = 0, f12 = 0, f22 = 0;
  double log_area = 0;

  // The displacement (x, y) in coordinates in which the metric is round.
  point seen(double x, double y) const { return {f11 * x + f12 * y, f22 * y}; }
  double root_of_determinant() const { return f11 * f22; }
  double squared_distance(const point& q) const;
};

fit_site make_fit_site(const point& q, const metric_tensor& m, double log_area);

// Whether doubles are sure that the three turn counter-clockwise.
bool surely_turns_left(const point& a, const point& b, const point& c);

// Not finite unless they surely turn left. `sharp`: at a corner of the domain below the bound.
double shape_energy(const fit_site& a, const fit_site& b, const fit_site& c,
                    const angle_targets& wanted, bool sharp);

// The area in the mean of the three metrics; negative where they turn right.
double metric_area(const fit_site& a, const fit_site& b, const fit_site& c);

// Where the distances of three sites meet, near their triangle. squared_radius < 0: not found.
struct voronoi_centre {
  point position;
  double squared_radius = -1;
};
voronoi_centre find_centre(const fit_site& a, const fit_site& b, const fit_site& c);

// `far` is the site across the edge.
double far_site_energy(const voronoi_centre& centre, const fit_site& far);
// The subsegment a b with the third vertex c of its triangle on the left.
double subsegment_energy(const voronoi_centre& centre, const point& a, const point& b,
                         const point& c);

}  // namespace asterism::internal::fitting
