// SPDX-License-Identifier: MIT
//
// Bounds how far from v sites matter to one gap of its star, in few operations: most gaps need no
// test of any site beyond that.
#pragma once

#include "asterism/core/site.hpp"
#include "asterism/mesh/audit/star_outline.hpp"

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
  double share = 0;    // of the way, up to the bisector on it, at most
  double on_way = 0;   // how far that is at most
  double on_edge = 0;  // the greater of that and half the way
  bool is_known = false;

  // Returns the point up to which the way belongs to the kites on both sides of it.
  outline_point on_bisector() const { return {{share * way.x, share * way.y}, on_way}; }
};

// Bounds the points by which a gap may accept a site: all are within `reach` of v, and in the kite
// whose corners are v, `vertex` and a point on the way to each neighbour, at measured_ray::share of
// it (docs/math/certificate.md, 4.3). If `reach` is infinite, nothing is known.
struct gap_bound {
  double reach;
  outline_point vertex;
};

// Bounds the reaches of the gaps of v's star, which must outlive it.
class quick_reaches {
 public:
  explicit quick_reaches(const site& v);

  measured_ray ray_to(const site& neighbour) const;
  // Returns R of lemma 4.3 (docs/math/certificate.md) for the gap from x counter-clockwise to y, in
  // v's metric, and the kite, with the lower bounds of 4.2; an infinite reach where plain doubles
  // prove none. Requires distinct sites with positive definite metrics.
  gap_bound between(const measured_ray& x, const measured_ray& y) const;
  // Returns the bound along a direction between x and y in which the lower bounds beside both are
  // about equal: its reach may be finite where that of between() is infinite, as where the
  // direction of the Voronoi vertex is not within a right angle of both.
  gap_bound balanced(const measured_ray& x, const measured_ray& y) const;

 private:
  // Returns the reach and kite that follow from the lower bounds of section 4.2 in the direction u.
  gap_bound along(const point& u, const measured_ray& x, const measured_ray& y) const;

  const site& v_;
  double determinant_;
  bool is_known_;
};

// Returns the reach of one gap alone.
inline double quick_reach(const site& v, const site& x, const site& y) {
  const quick_reaches reaches(v);
  return reaches.between(reaches.ray_to(x), reaches.ray_to(y)).reach;
}

// True only if quick_reach() is finite. Decides most gaps with one division and without a root.
bool has_quick_reach(const site& v, const site& x, const site& y);

}  // namespace asterism::internal::audit_detail
