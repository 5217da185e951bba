// SPDX-License-Identifier: MIT
//
// Declares the functions with which built-in metrics are written once, for doubles and for
// enclosures (interval_jet.hpp has those of the latter).
#pragma once

#include <algorithm>
#include <cmath>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/metric/interval_jet.hpp"

namespace asterism::internal {

inline double square(double x) { return x * x; }
inline double square_root(double x) { return std::sqrt(x); }
inline double sine(double x) { return elementary::sin(x); }
inline double cosine(double x) { return elementary::cos(x); }
inline double hyperbolic_tangent(double x) { return elementary::tanh(x); }
inline double absolute(double x) { return std::abs(x); }
inline double lesser(double x, double y) { return std::min(x, y); }

}  // namespace asterism::internal
