// SPDX-License-Identifier: MIT
//
// Does an insertion question have a good point? Decided by finitely many parameters: one verified
// witness says yes; a cover of the arc by ranges, in each of which one reason to fail provably
// lasts, says no. A reason that holds at one point of a range lasts over the range's part of the
// arc, which is connected, when none of the functions it depends on has a zero there
// (docs/math/insertion-test.md); that no zero is there shows in the signs of Bernstein
// coefficients.
//
// The same code runs on intervals and on exact numbers. Neither answer is reached when good and
// bad meet in a point (a tie, a tangency): the search then stops at its budget and is undecided.
// Parameters are doubles, exact as such in both number types.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "asterism/core/sign.hpp"
#include "asterism/kernels/double_arithmetic.hpp"
#include "asterism/predicates/insertion_test.hpp"

namespace asterism::internal {

// A range of parameters: the open interval (low, high), ends may be infinite, not both.
struct parameter_range {
  double low, high;
};

// p(x + shift)
template <class Number, std::size_t Degree>
polynomial<Number, Degree> taylor_shift(polynomial<Number, Degree> p, const Number& shift) {
  for (std::size_t i = 0; i < Degree; ++i)
    for (std::size_t j = Degree; j-- > i;)
      p.coefficient[j] = p.coefficient[j] + shift * p.coefficient[j + 1];
  return p;
}

// p in coordinates that are positive on the range: coefficients of the same sign then show that p
// keeps that sign on it (Descartes; up to binomial factors these are Bernstein coefficients). The
// first one is p at a finite end, the last one p at the other end or the leading coefficient.
template <class Number, std::size_t Degree>
polynomial<Number, Degree> over_range(const polynomial<Number, Degree>& p,
                                      const parameter_range& range) {
  if (std::isinf(range.low)) {
    // p(high - t), t > 0
    polynomial<Number, Degree> q = taylor_shift(p, Number(range.high));
    for (std::size_t k = 1; k <= Degree; k += 2) q.coefficient[k] = Number(0) - q.coefficient[k];
    return q;
  }
  polynomial<Number, Degree> q = taylor_shift(p, Number(range.low));
  if (std::isinf(range.high)) return q;  // p(low + t), t > 0
  // p(low + width / (1 + t)) (1 + t)^Degree, t > 0
  const Number width = Number(range.high) - Number(range.low);
  polynomial<Number, Degree> reversed;
  Number power(1);
  for (std::size_t k = 0; k <= Degree; ++k) {
    reversed.coefficient[Degree - k] = q.coefficient[k] * power;
    if (k < Degree) power = power * width;
  }
  for (std::size_t i = 0; i < Degree; ++i)
    for (std::size_t j = Degree; j-- > i;)
      reversed.coefficient[j] = reversed.coefficient[j] + reversed.coefficient[j + 1];
  return reversed;
}

// The sign of p on the range and at its finite ends; certain only when p has no zero there.
template <class Number, std::size_t Degree>
uncertain_sign sign_between(const polynomial<Number, Degree>& p, const parameter_range& range) {
  const polynomial<Number, Degree> form = over_range(p, range);
  // The last coefficient belongs to an infinite end or to the finite end `low`.
  const bool both_finite = !std::isinf(range.low) && !std::isinf(range.high);
  sign common = sign::zero;
  for (std::size_t j = 0; j <= Degree; ++j) {
    const uncertain_sign s = sign_of(form.coefficient[j]);
    if (!s.certain()) return {};
    if (s.value() == sign::zero) {
      // A zero at a finite end may be the point where good and bad touch: a tie is not a "no".
      if (j == 0 || (j == Degree && both_finite)) return {};
      continue;
    }
    if (common != sign::zero && common != s.value()) return {};
    common = s.value();
  }
  return common == sign::zero ? uncertain_sign() : uncertain_sign(common);
}

// What the verdict "site i (v or w) dominates p over x" depends on, as functions along the arc.
enum class pair_function {
  tangents_to_x,
  tangents_from_x,
  slope_to_x,
  slope_from_x,
  approach_from_x,
  steepness_from_x
};

// The same number over another type, or enclosed in it. Overloaded for the pairs in use.
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

// One neighbour's condition, with the functions it depends on made when first asked for: their
// coefficients in Source arithmetic, their signs on ranges in Number. Intervals from exact
// coefficients are a unit in the last place wide and keep exact zeros, which symmetric metric
// fields put at the infinite ends.
template <class Number, class Source>
class lasting_reasons {
 public:
  using range = parameter_range;
  using verdict = neighbour_verdict;

  explicit lasting_reasons(const neighbour_condition<Source>& condition) : condition_(condition) {}

  // Does the condition, failing at `at` inside the range, fail on the whole range of the arc?
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

  // Site i does not dominate p over x at `at`. Does that last?
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
      // Nothing but a tangency changes how often the two segments meet the bisector.
      if (farther) return no_zero_of_pair(pair_function::tangents_to_x);
      // x is nearer; i dominates only where the segment xp meets the bisector twice.
      return sign_of_pair(pair_function::steepness_from_x).certainly(sign::positive) ||
             sign_of_pair(pair_function::approach_from_x).certainly(sign::negative) ||
             sign_of_pair(pair_function::slope_from_x).certainly(sign::positive) ||
             no_zero_of_pair(pair_function::tangents_from_x);
    }
    // x passes from farther to nearer where the ray from i crosses the bisector for the second
    // time and the ray from x for the first: i fails on both sides of that.
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

  // The sign of alpha + beta s, s > 0, on the part of the arc in the range: certain when alpha and
  // beta have one sign, or when the norm shows no zero, or when P and beta have one sign (the norm
  // also vanishes where the conjugate P - beta sqrt E does, but the function not there).
  // With `any`, "no zero" alone is asked and the sign may be either.
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

// PointOnArc(arc, m): the displacement and weight of p(m) over a type that holds sqrt E.
template <class Number, class PointOnArc, class Source = Number>
class arc_search {
 public:
  // `source` is the same question, whose polynomials are used. Hints may be anything; they decide
  // how soon the search ends, never how.
  arc_search(const insertion_question<Number>& question, const insertion_question<Source>& source,
             const numeric::search_hints& hints, int budget)
      : question_(question),
        e_(polynomial_as<Number>(source.arc.e)),
        a_(polynomial_as<Number>(source.arc.a)),
        h_(polynomial_as<Number>(source.arc.h)),
        hints_(hints.samples.data(), hints.count),
        witness_hint_(hints.witness),
        extent_(hints.extent),
        budget_(budget),
        at_x_(source.at_x),
        at_y_(source.at_y) {}

  uncertain_bool exists() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (witness_hint_ && std::isfinite(*witness_hint_) && good_point(*witness_hint_)) return true;
    const double start = hints_.empty() ? 0.0 : hints_[hints_.size() / 2];
    if (!std::isfinite(start)) return {};
    const auto [low, high] = extent_;
    const bool ends_below = low > -infinity && low < start,
               ends_above = high < infinity && high > start;
    const bool refuted =
        (!ends_below || refute(-infinity, low)) && (!ends_above || refute(high, infinity)) &&
        refute(ends_below ? low : -infinity, start) && refute(start, ends_above ? high : infinity);
    if (witness_) return true;
    return refuted ? uncertain_bool(false) : uncertain_bool();
  }

 private:
  bool good_point(double m) {
    if (!on_arc(m).certainly(true)) return false;
    const PointOnArc p(question_.arc, Number(m));
    return (question_.at_x.holds(p.from_v, p.weight) & question_.at_y.holds(p.from_v, p.weight))
        .certainly(true);
  }

  // No good point with parameter in (low, high)? Also false when a witness was found.
  bool refute(double low, double high) {
    if (--budget_ < 0 || witness_) return false;
    const double middle = sample(low, high);
    if (!(middle > low && middle < high)) return false;
    const parameter_range over{low, high};
    const uncertain_bool inside = on_arc(middle);
    if (inside.certainly(true)) {
      const PointOnArc p(question_.arc, Number(middle));
      const auto at_x = question_.at_x.examine(p.from_v, p.weight);
      const auto at_y = question_.at_y.examine(p.from_v, p.weight);
      if ((at_x.holds() & at_y.holds()).certainly(true)) {
        witness_ = true;
        return false;
      }
      if (at_x_.fail_throughout(at_x, over) || at_y_.fail_throughout(at_y, over)) return true;
    } else if (inside.certain() && off_arc_throughout(over)) {
      return true;
    }
    return refute(low, middle) && refute(middle, high);
  }

  double sample(double low, double high) const {
    std::size_t first = 0, last = hints_.size();
    while (first < last && !(hints_[first] > low)) ++first;
    while (last > first && !(hints_[last - 1] < high)) --last;
    if (first < last) return hints_[(first + last) / 2];
    if (std::isinf(low) && std::isinf(high)) return 0;
    // Towards an infinite end in growing strides, and geometrically within long ranges.
    if (std::isinf(low)) return high < 0 ? -(high * high + 1 - high) : -1 - high;
    if (std::isinf(high)) return low > 0 ? low * low + 1 + low : 1 - low;
    constexpr double long_range = 16;
    if (high > long_range * (1 + std::abs(low)))
      return std::sqrt(high) * std::sqrt(1 + std::abs(low));
    if (-low > long_range * (1 + std::abs(high)))
      return -std::sqrt(-low) * std::sqrt(1 + std::abs(high));
    return 0.5 * low + 0.5 * high;
  }

  uncertain_bool on_arc(double m) const {
    const Number at(m);
    const uncertain_bool real = is_positive(sign_of(e_(at)));
    if (real.certainly(false)) return false;
    return real & (is_positive(sign_of(h_(at))) | is_positive(sign_of(a_(at))));
  }

  bool off_arc_throughout(const parameter_range& over) const {
    if (sign_between(e_, over).certainly(sign::negative)) return true;
    return sign_between(a_, over).certainly(sign::negative) &&
           sign_between(h_, over).certainly(sign::negative);
  }

  const insertion_question<Number>& question_;
  polynomial<Number, 2> e_, a_;
  polynomial<Number, 1> h_;
  std::span<const double> hints_;  // in increasing order
  std::optional<double> witness_hint_;
  numeric::arc_extent extent_;
  int budget_;
  bool witness_ = false;
  lasting_reasons<Number, Source> at_x_, at_y_;
};

}  // namespace asterism::internal
