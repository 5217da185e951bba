// SPDX-License-Identifier: MIT
//
// Decides whether a neighbour's condition that fails at one point of a visible arc fails on a whole
// range of it: a reason that holds at one point lasts over the range's part of the arc, which is
// connected, when none of the functions it depends on has a zero there
// (docs/math/insertion-test.md).
#pragma once

#include <array>
#include <optional>

#include "asterism/core/sign.hpp"
#include "asterism/kernels/range_sign.hpp"
#include "asterism/predicates/insertion_test.hpp"

namespace asterism::internal {

// Functions along the arc on which the verdict "site i (v or w) dominates p over x" depends.
enum class pair_function {
  tangents_to_x,
  tangents_from_x,
  slope_to_x,
  slope_from_x,
  approach_from_x,
  steepness_from_x
};

// Returns the number as another type, or enclosed in it. Overloaded for the pairs in use.
template <class Number>
const Number& number_as(const Number& x) {
  return x;
}

template <class Number, class Source, std::size_t Degree>
polynomial<Number, Degree> polynomial_as(const polynomial<Source, Degree>& p) {
  polynomial<Number, Degree> result;
  for (std::size_t k = 0; k <= Degree; ++k)
    result.coefficient[k] = number_as<Number>(p.coefficient[k]);
  return result;
}

// One neighbour's condition, and the functions on which it depends, each made when first needed.
// Coefficients are in Source arithmetic, signs on ranges in Number. Intervals around exact
// coefficients are a unit in the last place wide and keep exact zeros, which symmetric metric
// fields cause at the infinite ends of arcs.
template <class Number, class Source>
class lasting_reasons {
 public:
  using range = parameter_range;
  using verdict = neighbour_verdict;

  explicit lasting_reasons(const neighbour_condition<Source>& condition) : condition_(condition) {}

  // True if the condition, which fails at `at` inside the range, certainly fails on the whole range
  // of the arc.
  bool fail_throughout(const verdict& at, const range& over) {
    const auto& arc = *condition_.arc;
    if (at.v_dominates.certainly(false) && undominated_throughout(0, arc.v, at, over)) return true;
    if (at.w_dominates.certainly(false) && undominated_throughout(1, arc.w, at, over)) return true;
    if (!at.contains_x.certainly(true)) return false;
    const auto& origin = arc.v.position;
    return no_zero(lines_[0], over,
                   [&] { return line_through(origin, arc.v.position, condition_.x.position); }) &&
           no_zero(lines_[1], over,
                   [&] { return line_through(origin, arc.w.position, condition_.x.position); });
  }

 private:
  struct cached {
    std::optional<arc_function<Source>> function;
    polynomial<Number, 2> alpha, rational_part;
    polynomial<Number, 1> beta;
    std::optional<polynomial<Number, 4>> norm;
  };

  // True if site i certainly dominates no point of the range over x, given that it does not
  // dominate the point with the verdict `at`.
  bool undominated_throughout(std::size_t side, const basic_site<Source>& i, const verdict& at,
                              const range& over) {
    const auto cache = [&](pair_function f) -> cached& {
      return pairs_[side][static_cast<std::size_t>(f)];
    };
    const auto sign_of_pair = [&](pair_function f) {
      return sign_throughout(cache(f), over, [&] { return quadratic(f, i); });
    };
    const auto no_zero_of_pair = [&](pair_function f) {
      return no_zero(cache(f), over, [&] { return quadratic(f, i); });
    };
    if (!at.x_farther.certain() || at.x_farther.value() == sign::zero) return false;
    const bool farther = at.x_farther.value() == sign::positive;
    const auto distance = [&] { return condition_.distance(); };
    if (no_zero(equidistance_, over, distance)) {
      // Excludes points at which a segment touches the bisector: the number of meetings of the two
      // segments with the bisector changes at such points alone.
      if (farther) return no_zero_of_pair(pair_function::tangents_to_x);
      // Handles points nearer to x: i dominates only those p for which the segment xp meets the
      // bisector twice.
      return sign_of_pair(pair_function::steepness_from_x).certainly(sign::positive) ||
             sign_of_pair(pair_function::approach_from_x).certainly(sign::negative) ||
             sign_of_pair(pair_function::slope_from_x).certainly(sign::positive) ||
             no_zero_of_pair(pair_function::tangents_from_x);
    }
    // Handles ranges on which x changes from farther to nearer: at the change the ray from i
    // crosses the bisector for the second time and the ray from x for the first, and i dominates on
    // neither side of it.
    return sign_of_pair(pair_function::slope_to_x).certainly(sign::negative) &&
           sign_of_pair(pair_function::slope_from_x).certainly(sign::positive) &&
           no_zero_of_pair(pair_function::tangents_to_x);
  }

  plane_quadratic<Source> quadratic(pair_function f, const basic_site<Source>& i) const {
    const auto& origin = condition_.arc->v.position;
    const auto& x = condition_.x;
    switch (f) {
      case pair_function::tangents_to_x:
        return tangent_lines(origin, i, x);
      case pair_function::tangents_from_x:
        return tangent_lines(origin, x, i);
      case pair_function::slope_to_x:
        return ray_slope(origin, i, x);
      case pair_function::slope_from_x:
        return ray_slope(origin, x, i);
      case pair_function::steepness_from_x:
        return ray_steepness(origin, x, i);
      default:
        return ray_approach(origin, x, i);
    }
  }

  // Returns the sign of alpha + beta s, s > 0, on the range's part of the arc. It is certain when
  // alpha and beta have one sign, when the norm has no zero, or when P and beta have one sign. The
  // last case is needed since the norm also vanishes at zeros of the conjugate P - beta sqrt E.
  // With `any` a certain answer says only that the function has no zero.
  template <class Make>
  uncertain_sign sign_throughout(cached& f, const range& over, const Make& make, bool any = false) {
    const auto& arc = *condition_.arc;
    if (!f.function) {
      f.function = arc.restrict(make());
      f.alpha = polynomial_as<Number>(f.function->alpha);
      f.beta = polynomial_as<Number>(f.function->beta);
    }
    const uncertain_sign beta = sign_between(f.beta, over);
    if (beta.certain() && sign_between(f.alpha, over).certainly(beta.value())) return beta;
    if (!f.norm) {
      f.norm = polynomial_as<Number>(arc.norm(*f.function));
      f.rational_part = polynomial_as<Number>(arc.rational_part(*f.function));
    }
    const uncertain_sign norm = sign_between(*f.norm, over);
    if (norm.certain() && any) return sign::positive;
    if (norm.certainly(sign::negative)) return beta;
    const uncertain_sign p = sign_between(f.rational_part, over);
    return norm.certain() || (p.certain() && beta.certainly(p.value())) ? p : uncertain_sign();
  }
  template <class Make>
  bool no_zero(cached& f, const range& over, const Make& make) {
    return sign_throughout(f, over, make, true).certain();
  }

  const neighbour_condition<Source>& condition_;
  cached equidistance_;
  std::array<std::array<cached, 6>, 2> pairs_;
  std::array<cached, 2> lines_;
};
}  // namespace asterism::internal
