// SPDX-License-Identifier: MIT
//
// The quickest edge test that plain doubles allow, as a baseline: find by Newton's method the two
// Voronoi vertices that bound v and w's common border, and look at one point between them. It knows
// no other cuts and has no error bound; double_kernel looks at every section.
#pragma once

#include "asterism/kernels/double_kernel.hpp"
#include "asterism/kernels/turn_scale.hpp"
#include "asterism/kernels/vertex_hints.hpp"
#include "inputs.hpp"

namespace asterism::bench {
using namespace internal;

inline bool edge_test_by_two_vertices(const edge_question& sites) {
  const auto& [v, w, x, y] = sites;
  const insertion_question<double> question(v, w, x, y,
                                            std::ldexp(1.0, turn_scale_exponent(v.metric)));
  const auto hints = numeric::find_quick_hints(question);
  if (!hints) return double_kernel().edge_test(v, w, x, y);
  return hints->witness && numeric::is_good_point(question, *hints->witness);
}

}  // namespace asterism::bench
