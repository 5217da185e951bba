// SPDX-License-Identifier: MIT
//
// Encloses Voronoi vertices and arcs of a mesh in doubles with error bounds, and answers whether a
// site is nearer to a point of an arc than the arc's owners. Answers are certain or missing;
// questions without one go to mesh/audit/voronoi_exact.hpp.
//
// An arc is cut into spans. Over a span from p to q the arc is p + t (q - p) + h(t) n with
// |h(t)| <= bulge t (1 - t) for a vector n across it, so f_w - f_v is at least a quadratic in t.
// Source: docs/math/voronoi-certificate.md, section 4, with proofs.
#pragma once

#include <optional>
#include <vector>

#include "asterism/core/sign.hpp"
#include "asterism/core/site.hpp"
#include "asterism/mesh/audit/number.hpp"

namespace asterism::internal::audit_detail {

// A point as its displacement from a site.
using offset = vector2<bounded>;

// Returns to - from.
offset between(const point& from, const point& to);

// Returns the point with f_a = f_b = f_c that lies in the wedges of all three pairs, as seen from
// a. Empty: not found, which proves nothing.
std::optional<offset> enclose_voronoi_vertex(const site& a, const site& b, const site& c);

// Returns the first point with f_v = f_u on the ray from v: a point of the visible arc. Empty when
// not found, or if the ray is not certainly within a right angle, in v's metric, of the direction
// to u.
std::optional<offset> enclose_bisector_point(const site& v, const site& u, const offset& direction);

// True only if at every point of the segment from a to b, w, by its own metric, is farther than the
// nearer of a and b, by theirs.
bool is_certainly_farther_than_nearer_end(const site& a, const site& b, const site& w);

class enclosed_arc {
 public:
  // Encloses the part of the visible arc of v and u from one of its points to another,
  // counter-clockwise around v. Both points are displacements from v.
  enclosed_arc(const site& v, const site& u, const offset& from, const offset& to);

  // True if the arc, or a part of it, is enclosed.
  bool usable() const { return !spans_.empty(); }
  // Returns an upper bound of the distance from v to the arc's points; infinite where the arc is
  // not enclosed.
  double reach() const { return reach_; }

  // Returns whether w is nearer to a point of the arc than v. "No" means that w is farther from
  // every point, except an end marked as tied: known to be equally near.
  uncertain_bool is_nearer(const site& w, bool tied_from, bool tied_to) const;

 private:
  // The quadratic function f_v - f_z of the displacement from v.
  struct difference_of_distances {
    difference_of_distances(const site& v, const site& z);
    bounded at(const offset& r) const;
    offset gradient(const offset& r) const;

    tensor<bounded> form;
    offset linear;
    bounded constant;
  };
  friend std::optional<offset> enclose_voronoi_vertex(const site&, const site&, const site&);

  struct span {
    offset from, to;
    vector2<double> across{};
    double bulge = 0;
  };

  std::optional<span> make_span(const offset& from, const offset& to) const;
  std::optional<offset> middle(const offset& from, const offset& to) const;
  bool add_spans(const offset& from, const offset& to, int depth);
  void extend_reach(const span& s);
  uncertain_bool is_nearer(const difference_of_distances& w, const span& s, bool tied_from,
                           bool tied_to, int depth) const;

  site v_, u_;
  difference_of_distances bisector_;
  std::vector<span> spans_;
  double reach_ = 0;
};

}  // namespace asterism::internal::audit_detail
