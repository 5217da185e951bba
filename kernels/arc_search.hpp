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
#include "asterism/predicates/insertion_test.hpp"

namespace asterism {

// Signs of the coefficients of p along the cone from ray (lambda1, mu1) to (lambda2, mu2): when
// none differ, p has that sign everywhere strictly between the rays (Descartes, Bernstein), and on
// the rays too, except that p may vanish at a ray at infinity (lambda = 0). Certain only then.
template <class Number, std::size_t Degree>
uncertain_sign sign_between(const polynomial<Number, Degree>& p, const std::array<Number, 2>& ray1,
                            const std::array<Number, 2>& ray2) {
  std::array<Number, Degree + 1> form;    // of (lambda, mu) along the cone
  std::array<Number, Degree + 1> powers;  // of lambda along the cone
  form.fill(Number(0));
  powers.fill(Number(0));
  form[0] = p.coefficient[Degree];
  powers[0] = Number(1);
  for (std::size_t k = 1; k <= Degree; ++k) {
    for (std::size_t j = k + 1; j-- > 0;) {
      const bool last = j == k, first = j == 0;
      Number form_j = last ? form[j - 1] * ray2[1] : form[j] * ray1[1];
      Number power_j = last ? powers[j - 1] * ray2[0] : powers[j] * ray1[0];
      if (!last && !first) {
        form_j = form_j + form[j - 1] * ray2[1];
        power_j = power_j + powers[j - 1] * ray2[0];
      }
      form[j] = form_j;
      powers[j] = power_j;
    }
    for (std::size_t j = 0; j <= k; ++j) form[j] = form[j] + p.coefficient[Degree - k] * powers[j];
  }
  const auto finite = [](const std::array<Number, 2>& ray) {
    return !sign_of(ray[0]).certainly(sign::zero);
  };
  sign common = sign::zero;
  for (std::size_t j = 0; j <= Degree; ++j) {
    const uncertain_sign s = sign_of(form[j]);
    if (!s.certain()) return {};
    if (s.value() == sign::zero) {
      // A zero at a finite end may be the point where good and bad touch: a tie is not a "no".
      if ((j == 0 && finite(ray1)) || (j == Degree && finite(ray2))) return {};
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
  approach_from_x
};

// One neighbour's condition, with the functions it depends on made when first asked for.
template <class Number>
class lasting_reasons {
 public:
  using range = std::array<std::array<Number, 2>, 2>;
  using verdict = typename neighbour_condition<Number>::verdict;

  explicit lasting_reasons(const neighbour_condition<Number>& condition) : condition_(condition) {}

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
    std::optional<polynomial<Number, 4>> norm;
    polynomial<Number, 2> rational_part;
    polynomial<Number, 1> beta;
  };

  // Site i does not dominate p over x at `at`. Does that last?
  bool undominated_throughout(std::size_t side, const basic_site<Number>& i, const verdict& at,
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
    const auto distance = [&] { return distance_difference(condition_.arc->v, condition_.x); };
    if (no_zero(equidistance_, over, distance)) {
      // Nothing but a tangency changes how often the two segments meet the bisector.
      if (farther) return no_zero_of_pair(pair_function::tangents_to_x);
      // x is nearer; i dominates only where the segment xp meets the bisector twice.
      return sign_of_pair(pair_function::approach_from_x).certainly(sign::negative) ||
             sign_of_pair(pair_function::slope_from_x).certainly(sign::positive) ||
             no_zero_of_pair(pair_function::tangents_from_x);
    }
    // x passes from farther to nearer where the ray from i crosses the bisector for the second
    // time and the ray from x for the first: i fails on both sides of that.
    return sign_of_pair(pair_function::slope_to_x).certainly(sign::negative) &&
           sign_of_pair(pair_function::slope_from_x).certainly(sign::positive) &&
           no_zero_of_pair(pair_function::tangents_to_x);
  }

  plane_quadratic<Number> quadratic(pair_function f, const basic_site<Number>& i) const {
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
      default:
        return ray_approach(origin, x, i);
    }
  }

  template <class Make>
  void fill(cached& f, const Make& make) {
    if (f.norm) return;
    const auto& arc = *condition_.arc;
    const arc_function<Number> g = arc.restrict(make());
    f = {arc.norm(g), arc.rational_part(g), g.beta};
  }
  // The function is P + beta sqrt E, its norm (P^2 - beta^2 E) / C. The norm also vanishes where
  // the conjugate does, but the function not where P and beta have one sign.
  static uncertain_sign common_sign(const cached& f, const range& over) {
    const uncertain_sign beta = sign_between(f.beta, over[0], over[1]);
    if (!beta.certain()) return {};
    const uncertain_sign p = sign_between(f.rational_part, over[0], over[1]);
    return p.certainly(beta.value()) ? p : uncertain_sign();
  }

  // Certainly no zero on the part of the arc in the range?
  template <class Make>
  bool no_zero(cached& f, const range& over, const Make& make) {
    fill(f, make);
    return sign_between(*f.norm, over[0], over[1]).certain() || common_sign(f, over).certain();
  }
  // The sign of the function on the part of the arc in the range.
  template <class Make>
  uncertain_sign sign_throughout(cached& f, const range& over, const Make& make) {
    fill(f, make);
    const uncertain_sign norm = sign_between(*f.norm, over[0], over[1]);
    if (!norm.certain()) return common_sign(f, over);
    return norm.value() == sign::positive ? sign_between(f.rational_part, over[0], over[1])
                                          : sign_between(f.beta, over[0], over[1]);
  }

  const neighbour_condition<Number>& condition_;
  cached equidistance_;
  std::array<std::array<cached, 5>, 2> pairs_;
  std::array<cached, 2> lines_;
};

// PointOnArc<Number>(arc, m): the displacement and weight of p(m) over a type that holds sqrt E.
template <class Number, class PointOnArc>
class arc_search {
 public:
  // `hints` are parameters in increasing order, ideally one in each section of the arc.
  arc_search(const insertion_question<Number>& question, std::span<const double> hints, int budget)
      : question_(question),
        hints_(hints),
        budget_(budget),
        at_x_(question.at_x),
        at_y_(question.at_y) {}

  // `witness` is a parameter to try first, from anywhere.
  uncertain_bool exists(std::optional<double> witness) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (witness && std::isfinite(*witness) && good_point(*witness)) return true;
    const double start = hints_.empty() ? 0.0 : hints_[hints_.size() / 2];
    const bool refuted = refute(-infinity, start) && refute(start, infinity);
    if (witness_) return true;
    return refuted ? uncertain_bool(false) : uncertain_bool();
  }

 private:
  using range = std::array<std::array<Number, 2>, 2>;

  static range cone(double low, double high) {
    const auto ray = [](double m) -> std::array<Number, 2> {
      if (std::isinf(m)) return {Number(0), Number(m > 0 ? 1 : -1)};
      return {Number(1), Number(m)};
    };
    return {ray(low), ray(high)};
  }

  bool good_point(double m) {
    const visible_arc<Number>& arc = question_.arc;
    if (!arc.contains(Number(1), Number(m)).certainly(true)) return false;
    const PointOnArc p(arc, Number(m));
    return (question_.at_x.holds(p.from_v, p.weight) & question_.at_y.holds(p.from_v, p.weight))
        .certainly(true);
  }

  // No good point with parameter in (low, high)? Also false when a witness was found.
  bool refute(double low, double high) {
    if (--budget_ < 0 || witness_) return false;
    const double middle = sample(low, high);
    if (!(middle > low && middle < high)) return false;
    const range over = cone(low, high);
    const uncertain_bool inside = question_.arc.contains(Number(1), Number(middle));
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
    if (std::isinf(low)) return high - 1 - std::abs(high);
    if (std::isinf(high)) return low + 1 + std::abs(low);
    return 0.5 * low + 0.5 * high;
  }

  bool off_arc_throughout(const range& over) const {
    const visible_arc<Number>& arc = question_.arc;
    if (sign_between(arc.e, over[0], over[1]).certainly(sign::negative)) return true;
    return sign_between(arc.a, over[0], over[1]).certainly(sign::negative) &&
           sign_between(arc.h, over[0], over[1]).certainly(sign::negative);
  }

  const insertion_question<Number>& question_;
  std::span<const double> hints_;
  int budget_;
  bool witness_ = false;
  lasting_reasons<Number> at_x_, at_y_;
};

}  // namespace asterism
