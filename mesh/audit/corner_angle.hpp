// SPDX-License-Identifier: MIT
//
// Decides one angle in one metric against a bound, exactly; inside the auditor alone.
//
// With edge vectors a, b from a corner, a x b > 0, the angle in the metric M is at least theta
// exactly when a^T M b <= cot(theta) sqrt(det M) (a x b). All but cot(theta) is rational; where the
// left side is positive, squares are compared against a rational C <= cot(theta)^2 (docs/math/
// certificate.md, section 3): a pass proves the bound. The set of M that pass is a convex cone.
#pragma once

#include "asterism/mesh/audit/context.hpp"

namespace asterism::internal::audit_detail {

// Rational bounds of cot(degrees)^2 from both sides, equal where the value is rational: for a
// rational number of degrees, as every double is, that is at 30, 45 and 60 only.
struct squared_cotangent {
  rational low, high;
  bounded filter;         // encloses both
  double root_below = 0;  // at most the root of `low`
};

// Requires 0 < degrees < 90.
squared_cotangent make_squared_cotangent(double degrees);

struct corner {
  vertex_index at = 0, ahead = 0, behind = 0;  // counter-clockwise from `ahead` to `behind`
};

// True if the angle is proven to be at least the bound. Requires a x b > 0.
bool is_proven_wide(const audit_context& context, audit_tally& tally, const corner& c,
                    vertex_index perspective, const squared_cotangent& bound);

// True if the angle is proven to be below the bound. Requires a x b > 0.
bool is_proven_narrow(const audit_context& context, audit_tally& tally, const corner& c,
                      vertex_index perspective, const squared_cotangent& bound);

// Returns the angle in degrees, rounded: for information alone.
double angle_in_degrees(const audit_context& context, const corner& c, vertex_index perspective);

}  // namespace asterism::internal::audit_detail
