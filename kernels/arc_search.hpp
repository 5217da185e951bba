// SPDX-License-Identifier: MIT
//
// Decides whether an insertion question has a good point, by finitely many parameters: one verified
// witness says yes; a cover of the arc by ranges, in each of which one reason to fail provably
// lasts (kernels/lasting_reasons.hpp), says no.
//
// Runs on intervals and on exact numbers by the same code. Neither answer is reached when good and
// bad meet in a point (a tie, a tangency): the search then stops at its budget, or where a range
// around a proposed cut has become narrow, and is undecided.
// Parameters are doubles, exact as such in both number types.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "asterism/core/sign.hpp"
#include "asterism/kernels/double_arithmetic.hpp"
#include "asterism/kernels/lasting_reasons.hpp"
#include "asterism/kernels/proposal.hpp"
#include "asterism/predicates/insertion_test.hpp"

namespace asterism::internal {

// Searches a visible arc for a good point. PointOnArc makes the point p(m) by its weighted
// displacement, in a type that holds sqrt E; Source is the number type of the coefficients.
template <class Number, class PointOnArc, class Source = Number>
class arc_search {
 public:
  // `source` is the same question, whose polynomials are used. Hints may have any values: they
  // affect how long the search takes, never its result.
  arc_search(const insertion_question<Number>& question, const insertion_question<Source>& source,
             const numeric::search_hints& hints, int budget)
      : question_(question),
        e_(polynomial_as<Number>(source.arc.e)),
        a_(polynomial_as<Number>(source.arc.a)),
        h_(polynomial_as<Number>(source.arc.h)),
        hints_(hints.samples.data(), hints.count),
        cuts_(hints.cuts.data(), hints.cut_count),
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

  // True if no good point has a parameter in (low, high). Also false if a witness was found.
  bool refute(double low, double high) {
    if (--budget_ < 0 || witness_) return false;
    const double middle = proposal([&] { return sample(low, high); });
    if (!(middle > low && middle < high)) return false;
    const parameter_range over{low, high};
    const uncertain_bool inside = on_arc(middle);
    if (inside.certainly(true)) {
      if (refutes_from(middle, over)) return true;
      if (witness_) return false;
    } else if (inside.certain() && off_arc_throughout(over)) {
      return true;
    }
    return refute(low, middle) && refute(middle, high);
  }

  // True if the condition of one neighbour, which fails at the point `middle` of the arc, fails on
  // the whole range. Begins with the neighbour that refuted the range before. Notes a witness where
  // both conditions hold.
  bool refutes_from(double middle, const parameter_range& over) {
    const PointOnArc p(question_.arc, Number(middle));
    bool holds = true;
    for (const bool other : {false, true}) {
      const bool of_y = begins_with_y_ != other;
      const auto verdict = (of_y ? question_.at_y : question_.at_x).examine(p.from_v, p.weight);
      if ((of_y ? at_y_ : at_x_).fail_throughout(verdict, over)) {
        begins_with_y_ = of_y;
        return true;
      }
      holds = holds && verdict.holds().certainly(true);
    }
    witness_ = holds;
    return false;
  }

  double sample(double low, double high) const {
    std::size_t first = 0, last = hints_.size();
    while (first < last && !(hints_[first] > low)) ++first;
    while (last > first && !(hints_[last - 1] < high)) --last;
    if (first < last) return hints_[(first + last) / 2];
    if (std::isinf(low) && std::isinf(high)) return 0;
    // Cuts an infinite range at a point that grows as the square of its finite end, and a long one
    // at about the geometric mean of its ends.
    if (std::isinf(low)) return high < 0 ? -(high * high + 1 - high) : -1 - high;
    if (std::isinf(high)) return low > 0 ? low * low + 1 + low : 1 - low;
    if (const auto beside = beside_cut(low, high)) return *beside;
    constexpr double long_range = 16;
    if (high > long_range * (1 + std::abs(low)))
      return std::sqrt(high) * std::sqrt(1 + std::abs(low));
    if (-low > long_range * (1 + std::abs(high)))
      return -std::sqrt(-low) * std::sqrt(1 + std::abs(high));
    return 0.5 * low + 0.5 * high;
  }

  // Returns a parameter close to the equidistance cut in the range, on the longer side, as reasons
  // to fail change at cuts: the rest of that side is likely to have one reason. Returns an end of
  // the range, which ends the search, if the range is so narrow that good and bad are likely to
  // meet in the cut. Returns nothing if there is no cut.
  std::optional<double> beside_cut(double low, double high) const {
    constexpr double part = 0x1p-8, narrowest = 0x1p-20;
    for (const double c : cuts_) {
      if (!(low < c && c < high)) continue;
      if (high - low < narrowest * (1 + std::abs(c))) return low;
      return c - low >= high - c ? c - part * (c - low) : c + part * (high - c);
    }
    return std::nullopt;
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
  std::span<const double> cuts_;
  std::optional<double> witness_hint_;
  numeric::arc_extent extent_;
  int budget_;
  bool witness_ = false, begins_with_y_ = false;
  lasting_reasons<Number, Source> at_x_, at_y_;
};

}  // namespace asterism::internal
