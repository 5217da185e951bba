// SPDX-License-Identifier: MIT
//
// Measures the quantities in the hypotheses of the theorem on nets for one triangle, of one
// boundary edge and of two sites, in doubles that carry a bound of their error (audit/number.hpp).
// Source: docs/math/angle-theorem.md.
#pragma once

#include <array>

#include "asterism/core/site.hpp"

namespace asterism::internal::theorem {

// Returns an upper bound of |q - p| as p measures it.
double distance_above(const site& p, const site& q);

// Returns a radius R such that each point of the triangle is within R of one of its corners, in
// that corner's metric; infinite when none was found. Any order of corners.
double covering_radius_above(const std::array<site, 3>& corners);

// Returns an upper bound of the covering radius as covering_radius_above() does, seldom much
// larger, for a twentieth of the work; infinite when none was found; 0 where both radii are
// certainly less than `enough`.
double quick_covering_radius_above(const std::array<site, 3>& corners, double enough = 0);

// True if the disks of this radius around p and q, each in its own metric, have certainly no point
// in common.
bool certainly_apart(const site& p, const site& q, double radius);

// Measures of two sites: a lower bound of the greater of both distances; upper bounds of tau, and
// of the least sigma for which tau <= 1 / (1 - sigma d) for the smaller distance d.
struct pair_measures {
  double larger_distance_below = 0, distortion_above = 1, variation_above = 0;
};
pair_measures measure_pair(const site& p, const site& q);

// True only if no measure of p and q is beyond the corresponding one of `known`. Takes a fraction
// of the work of measuring them.
bool is_within(const pair_measures& known, const site& p, const site& q);

// True only if radius * tau * sqrt(tau^2 - 1) < spacing.
bool arcs_are_wedged(double radius, double spacing, double distortion);

// Returns an upper bound of the greater of sigma R and 1 - 1 / sqrt(tau).
double table_variation_above(double variation, double radius, double distortion);

// Returns an upper bound of a / b; infinite unless b is positive.
double quotient_above(double a, double b);

}  // namespace asterism::internal::theorem
