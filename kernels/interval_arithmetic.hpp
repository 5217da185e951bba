// SPDX-License-Identifier: MIT
//
// Gives certified answers by intervals: roots of quartics isolated by subdivision, existence on a
// segment shown by one verified witness or refuted by covering it with boxes on each of which a
// condition certainly fails (existence on an arc: kernels/arc_search.hpp). Else undecided.
//
// All functions require a floating_point_scope(rounding::upward). Source of the scheme: Moore's
// interval branch and prune; bounds on the number of boxes are budgets, not tolerances: running out
// of one means "undecided".
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "asterism/core/interval.hpp"
#include "asterism/predicates/encroachment.hpp"
#include "asterism/predicates/visible_arc.hpp"

namespace asterism::internal::certified {

// A box of homogeneous parameters m = mu / lambda, lambda >= 0.
struct parameter_box {
  interval lambda, mu;
};

// Returns the box of turn parameters [low, high] within [-1, 1]: lambda = 1 - |t|, mu = t.
inline parameter_box at_turn(double low, double high) {
  const interval t(low, high);
  if (low >= 0) return {interval(1) - t, t};
  if (high <= 0) return {interval(1) + t, t};
  return {interval(0, 1), t};
}

// One real root: the only one of its polynomial with turn parameter in [low, high].
struct enclosed_root {
  parameter_box box;
};

// Returns the distinct real roots of a polynomial that does not vanish, or nothing when undecided.
std::optional<std::vector<enclosed_root>> isolate(const std::array<interval, 5>& coefficients,
                                                  int degree);

template <std::size_t Degree>
std::optional<std::vector<enclosed_root>> real_roots(const polynomial<interval, Degree>& p) {
  std::array<interval, 5> c;
  c.fill(interval(0));
  for (std::size_t k = 0; k <= Degree; ++k) c[k] = p.coefficient[k];
  return isolate(c, static_cast<int>(Degree));
}

// True if a point with the property exists. `witness` is a parameter to try first, from any source.
uncertain_bool exists(const encroachment_question<interval>& question,
                      std::optional<double> witness);

}  // namespace asterism::internal::certified
