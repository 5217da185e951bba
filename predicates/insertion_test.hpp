// SPDX-License-Identifier: MIT
//
// Question: may w stand in the star of v between its neighbours x and y?
// Computes: whether some point p of the visible arc of v, w is dominated by v and by w over x and
//   over y, with x and y outside the closed triangle v, w, p. The good points form an open subset
//   of the arc, so one exact evaluation in each open section between consecutive distinct zeros of
//   the critical functions decides; no sign is needed at an algebraic point
//   (docs/math/insertion-test.md).
// Returns: true when there is such a point. "No point" and "only a limit point" are both false.
// Laws: 1. symmetric under v <-> w; 2. symmetric under x <-> y; 3. with four equal metrics it is
//   the in-circle test. It does not hold that exactly one diagonal of a quadrilateral passes:
//   that is what edge_test adds for ties, and what dense sites give otherwise.
// Requires: finite numbers, positive definite metrics, four distinct sites; nothing else.
// Degenerate: touching is false; edge_test breaks the ties that stars must agree on.
// Source: the thesis, INSERTIONTEST, definitions 5 and 6, appendix A.
#pragma once

#include "asterism/predicates/domination.hpp"
#include "asterism/predicates/in_circle.hpp"
#include "asterism/predicates/visible_arc.hpp"

namespace asterism::internal {

// Parts of a neighbour's condition at a point, each as a yes or no.
struct neighbour_verdict {
  uncertain_sign x_farther;  // sign of f_x - f_v
  uncertain_bool v_dominates, w_dominates, contains_x;

  uncertain_bool holds() const { return v_dominates & w_dominates & !contains_x; }
};

// Evaluates the condition that one of the two neighbours puts on a point of the arc.
template <class Number>
struct neighbour_condition {
  const visible_arc<Number>* arc;
  basic_site<Number> x;
  displacement<Number> v_to_x, w_to_x;
  uncertain_sign side_of_x;      // orientation(v, w, x)
  uncertain_bool x_between_v_w;  // meaningful when x is on the line vw

  neighbour_condition(const visible_arc<Number>& a, const basic_site<Number>& neighbour)
      : arc(&a),
        x(neighbour),
        v_to_x(between(a.v.position, x.position)),
        w_to_x(between(a.w.position, x.position)),
        side_of_x(sign_of(cross(a.d, v_to_x))),
        x_between_v_w(is_negative(sign_of(dot(v_to_x, w_to_x)))) {}

  // Returns f_v - f_x or f_w - f_x, which agree on the arc: the linear one if there is one.
  plane_quadratic<Number> distance() const {
    return is_certainly_zero(arc->w.metric - x.metric)
               ? distance_difference(arc->v.position, arc->w, x)
               : distance_difference(arc->v, x);
  }
  // Returns the function whose zeros are where x becomes as near as v and w.
  arc_function<Number> equidistance() const { return arc->restrict(distance()); }

  // Calls visit for each function, other than equidistance(), whose zeros are parameters at which
  // the condition can change.
  template <class Visitor>
  void visit_other_critical_functions(Visitor&& visit) const {
    const auto &v = arc->v, &w = arc->w;
    const auto& origin = v.position;
    visit(arc->restrict(tangent_lines(origin, v, x)));
    visit(arc->restrict(tangent_lines(origin, w, x)));
    visit(arc->restrict(tangent_lines(origin, x, v)));
    visit(arc->restrict(tangent_lines(origin, x, w)));
    visit(arc->restrict(line_through(origin, v.position, x.position)));
    visit(arc->restrict(line_through(origin, w.position, x.position)));
  }

  // Returns the verdict at the point with weighted displacement from_v = weight (p - v); Surd holds
  // sqrt E.
  template <class Surd>
  neighbour_verdict examine(const displacement<Surd>& from_v, const Surd& weight) const {
    const basic_site<Surd> v = lift<Surd>(arc->v), w = lift<Surd>(arc->w), at = lift<Surd>(x);
    const displacement<Surd> from_x = from_v - weight * lift<Surd>(v_to_x);
    const displacement<Surd> from_w = from_v - weight * lift<Surd>(arc->d);
    return {sign_of(squared_length(at.metric, from_x) - squared_length(v.metric, from_v)),
            is_positive(dominates(v, at, from_v, from_x, weight)),
            is_positive(dominates(w, at, from_w, from_x, weight)), x_in_triangle(from_v, from_x)};
  }

  // Returns examine(...).holds(), evaluated no further than needed.
  template <class Surd>
  uncertain_bool holds(const displacement<Surd>& from_v, const Surd& weight) const {
    const basic_site<Surd> at = lift<Surd>(x);
    const displacement<Surd> from_x = from_v - weight * lift<Surd>(v_to_x);
    const uncertain_bool by_v =
        is_positive(dominates(lift<Surd>(arc->v), at, from_v, from_x, weight));
    if (by_v.certainly(false)) return false;
    const displacement<Surd> from_w = from_v - weight * lift<Surd>(arc->d);
    const uncertain_bool by_w =
        is_positive(dominates(lift<Surd>(arc->w), at, from_w, from_x, weight));
    if (by_w.certainly(false)) return false;
    return by_v & by_w & !x_in_triangle(from_v, from_x);
  }

 private:
  template <class Surd>
  static displacement<Surd> lift(const displacement<Number>& u) {
    return {Surd(u.x), Surd(u.y)};
  }
  template <class Surd>
  static basic_site<Surd> lift(const basic_site<Number>& s) {
    return {{Surd(s.position.x), Surd(s.position.y)},
            {Surd(s.metric.m11), Surd(s.metric.m12), Surd(s.metric.m22)}};
  }

  // True if x is in the closed triangle v, w, p.
  template <class Surd>
  uncertain_bool x_in_triangle(const displacement<Surd>& from_v,
                               const displacement<Surd>& from_x) const {
    if (!side_of_x.certain()) return {};
    if (side_of_x.value() == sign::zero) return x_between_v_w;
    const bool left = side_of_x.value() == sign::positive;
    const auto inward = [left](uncertain_sign s) { return left ? s : -s; };
    const uncertain_bool same_side =
        is_positive(inward(sign_of(cross(lift<Surd>(arc->d), from_v))));
    if (same_side.certainly(false)) return false;
    const uncertain_bool right_of_vp =  // orientation(v, x, p)
        !is_negative(inward(sign_of(cross(lift<Surd>(v_to_x), from_v))));
    if (right_of_vp.certainly(false)) return false;
    const uncertain_bool left_of_wp =  // orientation(x, w, p)
        !is_negative(inward(-sign_of(cross(lift<Surd>(w_to_x), from_x))));
    return same_side & right_of_vp & left_of_wp;
  }
};

// Poses the question as an existence problem on the parameter line, for an arithmetic to decide.
template <class Number>
struct insertion_question {
  visible_arc<Number> arc;
  neighbour_condition<Number> at_x, at_y;

  insertion_question(const basic_site<Number>& v, const basic_site<Number>& w,
                     const basic_site<Number>& x, const basic_site<Number>& y,
                     const Number& turn_scale)
      : arc(v, w, turn_scale), at_x(arc, x), at_y(arc, y) {}
  insertion_question(const insertion_question&) = delete;
  insertion_question& operator=(const insertion_question&) = delete;
};

// Four equal metrics m: the arc is a whole line and domination is being nearer, so only a pair x, y
// on different sides of the line vw, and a site on the segment vw, can block it. A zero of the
// in-circle sign is a tie: true iff `tie` says so.
template <class Number, class TieRule>
uncertain_bool insertion_test_equal_metrics(const basic_metric_tensor<Number>& m,
                                            const basic_point<Number>& v,
                                            const basic_point<Number>& w,
                                            const basic_point<Number>& x,
                                            const basic_point<Number>& y, TieRule&& tie) {
  const auto d = between(v, w);
  const Number of_x = cross(d, between(v, x)), of_y = cross(d, between(v, y));
  const auto blocks = [&](uncertain_sign s, const basic_point<Number>& q) {
    return is_zero(s) & is_negative(sign_of(dot(between(v, q), between(w, q))));
  };
  const uncertain_sign side_x = sign_of(of_x), side_y = sign_of(of_y);
  const uncertain_bool blocked = blocks(side_x, x) | blocks(side_y, y);
  if (!blocked.certain()) return {};
  if (blocked.value()) return false;
  if (!side_x.certain() || !side_y.certain()) return {};
  if (side_x.value() * side_y.value() != sign::negative) return true;
  const uncertain_sign inside = sign_of(opposite_angles_value(m, v, w, x, y, of_x, of_y));
  if (!inside.certain()) return {};
  if (inside.value() == sign::zero) return tie();
  return inside.value() != side_x.value();
}

}  // namespace asterism::internal
