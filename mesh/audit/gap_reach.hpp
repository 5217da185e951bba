// SPDX-License-Identifier: MIT
//
// Bounds how far from v sites matter to one gap of its star, in few operations: most gaps need no
// test of any site beyond that.
#pragma once

#include "asterism/core/site.hpp"

namespace asterism::internal::audit_detail {

// Measurements of the displacement from v to a neighbour, used by the gaps on both sides of it.
struct measured_ray {
  const site* end = nullptr;
  point way, dual;       // the dual by v's metric
  double extent = 0;     // |x| + |y| of the way
  double length = 0;     // as v measures
  double inverse_c = 0;  // 1 over the square of the length as the neighbour measures
  double inverse_root_c = 0;
  double bend = 0;     // of the bound of 4.2
  double on_edge = 0;  // how far the bisector on the way is at most, and half the way
  bool is_known = false;
};

// Bounds the reaches of the gaps of v's star, which must outlive it.
class quick_reaches {
 public:
  explicit quick_reaches(const site& v);

  measured_ray ray_to(const site& neighbour) const;
  // Returns R of lemma 4.3 (docs/math/certificate.md) for the gap from x counter-clockwise to y, in
  // v's metric, with the lower bounds of 4.2; infinite where plain doubles prove none. Requires
  // distinct sites with positive definite metrics.
  double between(const measured_ray& x, const measured_ray& y) const;

 private:
  const site& v_;
  double determinant_;
  bool is_known_;
};

// Returns the reach of one gap alone.
inline double quick_reach(const site& v, const site& x, const site& y) {
  const quick_reaches reaches(v);
  return reaches.between(reaches.ray_to(x), reaches.ray_to(y));
}

}  // namespace asterism::internal::audit_detail
