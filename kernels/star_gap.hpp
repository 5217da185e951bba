// SPDX-License-Identifier: MIT
//
// Prepares one gap of v's star for many tests of edge_test: whether w may stand between the
// neighbours y and x. The first tier of edge_test; plain doubles with error bounds that hold in
// every floating-point environment.
//
// Method: in coordinates in which v's metric is the identity (kernels/normal_frame.hpp) find the
// direction u of the gap's Voronoi vertex by Newton's method, and enclose the first meetings of
// that ray with the bisectors of v, x and v, y. If the ray meets w's bisector first, that meeting
// is a witness, provided that w sees it and dominates it over x and y. If it certainly meets w's
// bisector last, w is refused: a convex upper bound of s_w is compared with concave lower bounds of
// s_x and s_y, s being the inverse of the parameter of the first meeting, at the ends of one cone
// for each neighbour. Beyond some direction on the far side of a neighbour the triangle of v, w and
// the point contains the neighbour instead. Any choice of these directions is valid. Statement,
// proof and constants: docs/math/star-gap.md, star-gap-proof.md, star-gap-errors.md.
#pragma once

#include <optional>

#include "asterism/core/sign.hpp"
#include "asterism/core/site.hpp"
#include "asterism/kernels/normal_frame.hpp"
#include "asterism/kernels/star_gap_formulas.hpp"

namespace asterism::internal {

class star_gap {
 public:
  // Takes y, then x, counter-clockwise around v; for gaps of less than half a turn, otherwise all
  // is undecided. Requires distinct sites with positive definite metrics.
  star_gap(const site& v, const site& y, const site& x);

  // Decides edge_test(v, w, x, y), for w strictly between the rays from v through y and x;
  // undecided when it is not certain, or w not certainly between. A certain answer never depends on
  // how ties are broken.
  uncertain_bool accepts(const site& w) const;

  // True if the gap's Voronoi vertex, with f_v = f_x = f_y, was found, by Newton's method to about
  // ten digits and without an error bound. If false, vertex() and vertex_distance_squared() are
  // meaningless.
  bool has_vertex() const { return has_vertex_; }
  point vertex() const { return frame_.original(u_); }
  double vertex_distance_squared() const { return frame_.scale() * u_squared_; }  // f_v there

  // Returns R of lemma 4.3 of docs/math/certificate.md, in v's metric and infinite when not known:
  // with |w|_v above (1 + sigma) R, sigma^2 the largest eigenvalue of M_w^-1 M_v or 1 if that is
  // more, no w is accepted.
  double reach() const;

 private:
  // A neighbour x or y in v's frame.
  struct neighbour {
    star_gap_detail::framed_site site;
    displacement<double> dual;    // N d
    displacement<double> seen_u;  // N u
    double c = 0, a = 0;          // of the ray equation along u
    // Bounds of s along u at the first meeting of the ray with the neighbour's bisector. `lowest`
    // is also at most the concave lower bound of s at u, and 0 if no such bound is known.
    double lowest = 0, highest = 0;
    // Linear part of the lower bound of s in other directions e: the bound is at least slope . e
    // where |e|^2 >= bend (e x d)^2.
    displacement<double> slope;
    double slope_magnitude = 0, bend = 0;
    // Inverse root of the ray equation's discriminant, if the bound is the tangent at u (bend is
    // 0); else 0.
    double inverse_root = 0;
  };
  struct candidate;
  struct upper_bound;
  // A value that is known to within a tolerance of `size`.
  struct estimate {
    double value, size;
  };
  // The direction z + step n, where n is the vector at a right angle to w on z's side (`side` is 1
  // for x, -1 for y). `turn` is the area spanned by w and z.
  struct direction_beyond {
    double turn, side, step;
  };

  bool find_vertex();
  void aim_between();
  bool never_met(neighbour& z, const star_gap_detail::ray_equation<double>& ray,
                 double discriminant) const;
  bool enclose_meeting(neighbour& z) const;
  bool bound_below(neighbour& z, double discriminant, double inverse_root, bool convex) const;
  uncertain_bool witness(const candidate& w) const;
  bool allows(const neighbour& z, double turn, const candidate& w, double s, double side) const;
  std::optional<upper_bound> bound_above(const candidate& w) const;
  double reach_along_edge(const neighbour& z) const;
  double reach_in_frame() const;
  bool far_away(const star_gap_detail::framed_site& w) const;
  bool refuted(const candidate& w, double at_lowest) const;
  bool closed_towards(const neighbour& z, const candidate& w, const upper_bound& top, double turn,
                      double side) const;
  estimate top_at(const neighbour& z, const candidate& w, const upper_bound& top, double turn,
                  double side) const;
  bool met_first_at(const neighbour& z, const candidate& w, const direction_beyond& e,
                    const estimate& top) const;

  star_gap_detail::normal_frame frame_;
  neighbour x_, y_;
  displacement<double> u_{0, 0};  // of the vertex, from v, in the frame; exact as a direction
  double u_squared_ = 0, u_extent_ = 0;
  double lowest_ = 0, highest_ = 0;  // of both neighbours
  double ingredient_ = 0, tolerance_ = 0, enclosure_ = 0;
  bool has_vertex_ = false;
  bool can_accept_ = false;  // the meetings are enclosed
  bool can_refuse_ = false;  // and u certainly has positive products with x and y
};

}  // namespace asterism::internal
