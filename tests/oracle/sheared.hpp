// SPDX-License-Identifier: MIT
//
// Moves sites to other coordinates, in which curves of sites on a grid have no special position.
#pragma once

#include "exact_numbers.hpp"

namespace asterism::oracle {

// Uses the coordinates X + slope Y, Y in place of X, Y. All questions are affine, so the sites are
// moved, and everything is asked about the moved ones.
inline exact_site sheared(const exact_site& s, const rational& slope) {
  exact_site t = s;
  t.position.x -= slope * s.position.y;
  t.metric.m12 += slope * s.metric.m11;
  t.metric.m22 += slope * (rational(2) * s.metric.m12 + slope * s.metric.m11);
  return t;
}

}  // namespace asterism::oracle
