// SPDX-License-Identifier: MIT
//
// Describes the part of the bisector Vor{v,w} that both sites see: an arc, rationally parametrised.
//
// With d = w - v and n = kappa J M_v d (J the quarter turn, kappa a power of two that brings n to
// the size of d), u(m) = d + m n sweeps the open half plane u^T M_v d > 0 once. On the ray v + t u
// the difference f_v - f_w is A t^2 + 2 H t - C with
//     A = |u|_v^2 - |u|_w^2,   H = u^T M_w d,   C = |d|_w^2 > 0,
// so with E = H^2 + A C the first bisector point on the ray is p(m) = v + u / s, where
//     s = (H + sqrt E) / C,
// and p(m) exists and is visible from both sites iff E > 0 and s > 0, that is E > 0 and (H > 0 or
// A > 0). E = 0 is a tangent ray: not visible. The point m = 0, on the segment vw, always is.
// Derivation and proof: docs/math/visible-arc.md. Source: the thesis, INSERTIONTEST, "the portion
// of the arc Vor{w,v} that is visible to both w and v"; appendix A, step 1.
//
// Parameters are homogeneous, m = mu / lambda with lambda >= 0, so that an interval can reach the
// ends of the arc at infinity.
#pragma once

#include "asterism/core/plane_algebra.hpp"
#include "asterism/core/polynomial.hpp"
#include "asterism/core/sign.hpp"

namespace asterism::internal {

// Returns the value of p at m = mu / lambda, times lambda^Degree.
template <class Number, std::size_t Degree>
Number evaluate(const polynomial<Number, Degree>& p, const Number& lambda, const Number& mu) {
  Number value = p.coefficient[Degree], power = lambda;
  for (std::size_t k = Degree; k-- > 0;) {
    value = value * mu + p.coefficient[k] * power;
    if (k > 0) power = power * lambda;
  }
  return value;
}

template <class Number>
bool is_certainly_zero(const basic_metric_tensor<Number>& m) {
  return sign_of(m.m11).certainly(sign::zero) && sign_of(m.m12).certainly(sign::zero) &&
         sign_of(m.m22).certainly(sign::zero);
}

// True if p is the zero polynomial.
template <class Number, std::size_t Degree>
uncertain_bool vanishes(const polynomial<Number, Degree>& p) {
  uncertain_bool all = true;
  for (const Number& c : p.coefficient) all = all & is_zero(sign_of(c));
  return all;
}

// A quadratic function of the displacement r = p - v: r^T form r + linear . r + constant.
template <class Number>
struct plane_quadratic {
  basic_metric_tensor<Number> form;
  displacement<Number> linear;
  Number constant;
};

// A function alpha + beta s along a visible arc: a plane quadratic on the arc, times C s^2, or a
// linear function, times s.
template <class Number>
struct arc_function {
  polynomial<Number, 2> alpha;
  polynomial<Number, 1> beta;
};

template <class Number>
struct visible_arc {
  basic_site<Number> v, w;
  displacement<Number> d, n;
  Number c;
  polynomial<Number, 2> a;
  polynomial<Number, 1> h;
  polynomial<Number, 2> e;

  // Makes the arc of v and w. turn_scale is kappa: any positive number gives the same arc.
  visible_arc(const basic_site<Number>& site_v, const basic_site<Number>& site_w,
              const Number& turn_scale)
      : v(site_v), w(site_w), d(between(v.position, w.position)) {
    const auto metric_v_d = apply(v.metric, d), metric_w_d = apply(w.metric, d);
    n = turn_scale * displacement<Number>{-metric_v_d.y, metric_v_d.x};
    c = dot(d, metric_w_d);
    a = restrict_form(v.metric - w.metric);
    h = {{c, dot(n, metric_w_d)}};
    e = h * h + c * a;
  }

  displacement<Number> direction(const Number& lambda, const Number& mu) const {
    return lambda * d + mu * n;
  }

  // Returns u^T form u as a polynomial in m.
  polynomial<Number, 2> restrict_form(const basic_metric_tensor<Number>& form) const {
    const Number mixed = dot(d, apply(form, n));
    return {{squared_length(form, d), mixed + mixed, squared_length(form, n)}};
  }

  // Returns q along the arc. A linear q is multiplied by s alone: the degrees are one less, and the
  // function has no zero where the arc runs to infinity (s = 0), unless the line q = 0 does too.
  arc_function<Number> restrict(const plane_quadratic<Number>& q) const {
    const polynomial<Number, 1> linear{{dot(q.linear, d), dot(q.linear, n)}};
    if (is_certainly_zero(q.form)) {
      const Number zero(0);
      return {{{linear.coefficient[0], linear.coefficient[1], zero}}, {{q.constant, zero}}};
    }
    return {c * restrict_form(q.form) + q.constant * a, c * linear + (q.constant + q.constant) * h};
  }

  // Returns P, the part without a square root of C (alpha + beta s) = P + beta sqrt E.
  polynomial<Number, 2> rational_part(const arc_function<Number>& f) const {
    return c * f.alpha + f.beta * h;
  }
  // Returns the norm (P^2 - beta^2 E) / C, which vanishes wherever alpha + beta s does.
  polynomial<Number, 4> norm(const arc_function<Number>& f) const {
    const auto mixed = f.alpha * (f.beta * h);
    return c * (f.alpha * f.alpha) + (mixed + mixed) - a * (f.beta * f.beta);
  }

  // True if p(mu / lambda) is a point of the arc.
  uncertain_bool contains(const Number& lambda, const Number& mu) const {
    const uncertain_bool real = is_positive(sign_of(evaluate(e, lambda, mu)));
    if (real.certainly(false)) return false;
    return real & (is_positive(sign_of(evaluate(h, lambda, mu))) |
                   is_positive(sign_of(evaluate(a, lambda, mu))));
  }
};

// Returns f_v - f_x as a quadratic about v.
template <class Number>
plane_quadratic<Number> distance_difference(const basic_site<Number>& v,
                                            const basic_site<Number>& x) {
  const auto offset = between(v.position, x.position);
  const auto metric_offset = apply(x.metric, offset);
  return {v.metric - x.metric, metric_offset + metric_offset,
          Number(0) - dot(offset, metric_offset)};
}

// Returns f_i - f_j as a quadratic about `origin`.
template <class Number>
plane_quadratic<Number> distance_difference(const basic_point<Number>& origin,
                                            const basic_site<Number>& i,
                                            const basic_site<Number>& j) {
  const auto to_i = between(origin, i.position), to_j = between(origin, j.position);
  const auto metric_i = apply(i.metric, to_i), metric_j = apply(j.metric, to_j);
  const auto half = metric_j - metric_i;
  return {i.metric - j.metric, half + half, dot(to_i, metric_i) - dot(to_j, metric_j)};
}

// Returns the two lines through site i that touch Vor{i,j}, as one quadratic about `origin`: the
// discriminant of f_i - f_j on the line from i through p. Positive: the line meets the bisector
// twice, on whichever side of i.
template <class Number>
plane_quadratic<Number> tangent_lines(const basic_point<Number>& origin,
                                      const basic_site<Number>& i, const basic_site<Number>& j) {
  const auto d = between(i.position, j.position);
  const auto t = apply(j.metric, d);
  const Number c = dot(d, t);
  const auto difference = i.metric - j.metric;
  const basic_metric_tensor<Number> form{square(t.x) + c * difference.m11,
                                         t.x * t.y + c * difference.m12,
                                         square(t.y) + c * difference.m22};
  const auto offset = between(origin, i.position);
  const auto form_offset = apply(form, offset);
  return {form, -(form_offset + form_offset), dot(offset, form_offset)};
}

// Returns half the slope of f_i - f_j along the ray from i, at the point p of the ray.
template <class Number>
plane_quadratic<Number> ray_slope(const basic_point<Number>& origin, const basic_site<Number>& i,
                                  const basic_site<Number>& j) {
  const auto to_i = between(origin, i.position), to_j = between(origin, j.position);
  const auto metric_i = apply(i.metric, to_i), metric_j_i = apply(j.metric, to_i),
             metric_j_j = apply(j.metric, to_j);
  // Expands (r - i)^T M_i (r - i) - (r - i)^T M_j (r - j)
  return {i.metric - j.metric, metric_j_i + metric_j_j - (metric_i + metric_i),
          dot(to_i, metric_i) - dot(to_i, metric_j_j)};
}

// Returns A + C of the ray from i through p: not negative where i meets the bisector Vor{i,j} at
// most once before p, since two meetings at t_1, t_2 < 1 have t_1 t_2 = -C/A.
template <class Number>
plane_quadratic<Number> ray_steepness(const basic_point<Number>& origin,
                                      const basic_site<Number>& i, const basic_site<Number>& j) {
  const auto form = i.metric - j.metric;
  const auto offset = between(origin, i.position);
  const auto form_offset = apply(form, offset);
  return {form, -(form_offset + form_offset),
          dot(offset, form_offset) + squared_length(j.metric, between(i.position, j.position))};
}

// Returns (p - i)^T M_j (j - i): not positive when i sees the bisector Vor{i,j} at most once
// towards p.
template <class Number>
plane_quadratic<Number> ray_approach(const basic_point<Number>& origin, const basic_site<Number>& i,
                                     const basic_site<Number>& j) {
  const auto t = apply(j.metric, between(i.position, j.position));
  const Number zero(0);
  return {{zero, zero, zero}, t, zero - dot(t, between(origin, i.position))};
}

// Returns the line through i and j, as orientation(i, j, p) about `origin`.
template <class Number>
plane_quadratic<Number> line_through(const basic_point<Number>& origin,
                                     const basic_point<Number>& i, const basic_point<Number>& j) {
  const auto along = between(i, j), offset = between(i, origin);
  const Number zero(0);
  return {{zero, zero, zero}, {zero - along.y, along.x}, cross(along, offset)};
}

}  // namespace asterism::internal
