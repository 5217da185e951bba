// SPDX-License-Identifier: MIT
//
// Defines the energies that mesh optimisation minimises: the shape of a triangle, and what the
// stars say of an edge. In plain doubles: they order proposals, and decide nothing.
//
// The energy of a triangle (shape_energy) is
//   sum over c > t of (c - t)^2 + 4 (c - t)^4, plus 0.05 log^2(area / area wanted).
// Here c runs over its nine cotangents, three corners as three vertices measure them; t is the
// cotangent of the angle aimed at, and the area is as the mean of the metrics sees it. The fourth
// power makes the worst angle count most; the area keeps the number of triangles. At a corner of
// the domain that is sharper than the bound angles count for little, and triangles smaller than
// wanted are welcome.
//
// The energy of an edge from either side (far_site_energy) is a weight times h^2 + h, or 0 if h is
// negative, with h = (margin - g) / margin. Here g = d(x)^2 / r^2 - 1, with x the Voronoi vertex of
// the triangle on that side, r its distance and d the distance that the site across measures. Stars
// disagree about the edge where g < 0. The energy of a subsegment (subsegment_energy) is the same,
// with g how far x is on the inner side, as a part of the height of the triangle: a subsegment
// whose triangle has its x behind it is encroached.
#pragma once

#include <cstdint>

#include "asterism/core/site.hpp"

namespace asterism::internal::fitting {

// Cotangents of the angle aimed at, and of one a little above the bound (`greatest`). The energy is
// steeper for angles below the latter.
struct angle_targets {
  double cotangent = 0, greatest = 0;
};

// Site with its metric as F^T F, F = [f11 f12; 0 f22], in which thin metrics lose little, and the
// logarithm of the metric area that triangles around it should have.
struct fit_site {
  point position;
  metric_tensor metric;
  double f11 = 0, f12 = 0, f22 = 0;
  double log_area = 0;

  // Returns the displacement (x, y) in coordinates in which the metric is round.
  point seen(double x, double y) const { return {f11 * x + f12 * y, f22 * y}; }
  double root_of_determinant() const { return f11 * f22; }
  double squared_distance(const point& q) const;
};

fit_site make_fit_site(const point& q, const metric_tensor& m, double log_area);

// True if doubles are sure that the three turn counter-clockwise.
bool surely_turns_left(const point& a, const point& b, const point& c);

// Returns the energy of a triangle's shape; infinite unless the three surely turn left. `sharp`
// means that the triangle is at a corner of the domain below the bound.
double shape_energy(const fit_site& a, const fit_site& b, const fit_site& c,
                    const angle_targets& wanted, bool sharp);

// Returns the area in the mean of the three metrics; negative where they turn right.
double metric_area(const fit_site& a, const fit_site& b, const fit_site& c);

// Point near a triangle that is equally far from its three sites, each in its own metric. A
// negative squared_radius (the default) says that none was found.
struct voronoi_centre {
  point position;
  double squared_radius = -1;
};
voronoi_centre find_centre(const fit_site& a, const fit_site& b, const fit_site& c);

// Returns the energy of an edge between two triangles from the side of `centre`; `far` is the site
// across the edge.
double far_site_energy(const voronoi_centre& centre, const fit_site& far);
// Returns the energy of the subsegment a b; c is the third vertex of its triangle, on the left.
double subsegment_energy(const voronoi_centre& centre, const point& a, const point& b,
                         const point& c);

}  // namespace asterism::internal::fitting
