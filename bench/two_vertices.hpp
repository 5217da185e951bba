// SPDX-License-Identifier: MIT
//
// Answers the edge test by the quickest method in plain doubles, as a baseline: finds the two
// Voronoi vertices that bound v and w's common border by Newton's method, and tests one point
// between them. It has no error bound and knows no other critical points; double_kernel tests every
// section.
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
