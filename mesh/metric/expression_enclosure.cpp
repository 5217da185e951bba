// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric/expression_enclosure.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "asterism/mesh/metric/interval_functions.hpp"

namespace asterism::internal {

namespace {

// Truth of a condition over a box: true everywhere in it, nowhere, or undecided.
enum class truth { no, yes, unknown };

truth decided(bool is_true, bool is_false) {
  if (is_true) return truth::yes;
  return is_false ? truth::no : truth::unknown;
}

truth truth_of(const interval_jet& condition) {
  const rounded_interval& v = condition.value;
  return decided(v.inf() > 0 || v.sup() < 0, v.inf() == 0 && v.sup() == 0);
}

interval_jet number_of(truth t) {
  if (t == truth::unknown) return either(0.0, 1.0);
  return {t == truth::yes ? 1.0 : 0.0};
}

}  // namespace

std::optional<expression_enclosure> expression_enclosure::parse(const std::string& text) {
  auto read = formula::read(text);
  if (!read) return std::nullopt;
  expression_enclosure made;
  made.steps_ = std::move(read).value().steps;
  const auto is_enclosed = [](const step& s) { return is_bounded_operation(s.what); };
  if (!std::all_of(made.steps_.begin(), made.steps_.end(), is_enclosed)) return std::nullopt;
  return made;
}

interval_jet expression_enclosure::over(const plane_jet& at) const {
  // Reads step 0, a number, in the place of each operand that an operation does not have.
  std::vector<evaluation> made(steps_.size());
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const step& s = steps_[i];
    const bool of_nan =
        made[s.first].may_be_nan || made[s.second].may_be_nan || made[s.third].may_be_nan;
    const interval_jet value =
        of_nan && hides_nan(s.what) ? any_outcome(s, made) : value_of(s, made, at);
    made[i] = {value, of_nan || makes_nan(s.what, made[s.first].jet, value)};
  }
  return made.back().jet;
}

bool expression_enclosure::is_bounded_operation(operation what) {
  switch (what) {
    case operation::arc_sine:
    case operation::arc_cosine:
    case operation::angle:
    case operation::area_sine:
    case operation::area_cosine:
    case operation::area_tangent:
    case operation::sign:
    case operation::whole:
      return false;
    default:
      return true;
  }
}

bool expression_enclosure::hides_nan(operation what) {
  return is_condition(what) || what == operation::choice || what == operation::lesser ||
         what == operation::greater;
}

bool expression_enclosure::is_condition(operation what) {
  return what == operation::less || what == operation::less_or_equal || what == operation::equal ||
         what == operation::conjunction || what == operation::disjunction;
}

interval_jet expression_enclosure::any_outcome(const step& s, const std::vector<evaluation>& made) {
  if (is_condition(s.what)) return number_of(truth::unknown);
  if (s.what == operation::choice) return either(made[s.second].jet, made[s.third].jet);
  return either(made[s.first].jet, made[s.second].jet);
}

bool expression_enclosure::makes_nan(operation what, const interval_jet& operand,
                                     const interval_jet& value) {
  switch (what) {
    case operation::root:
    case operation::logarithm:
    case operation::scaled_logarithm:
      return operand.value.inf() < 0;
    case operation::lesser:
    case operation::greater:
      return false;
    case operation::power:
      return operand.value.inf() < 0 || !is_bounded(value.value);
    default:
      return !is_bounded(value.value);
  }
}

interval_jet expression_enclosure::value_of(const step& s, const std::vector<evaluation>& made,
                                            const plane_jet& at) {
  const interval_jet &first = made[s.first].jet, &second = made[s.second].jet;
  switch (s.what) {
    case operation::constant:
      return {s.constant};
    case operation::x:
      return at.x;
    case operation::y:
      return at.y;
    case operation::add:
    case operation::total:
      return first + second;
    case operation::subtract:
      return first - second;
    case operation::multiply:
      return s.first == s.second ? square(first) : first * second;
    case operation::divide:
      return first / second;
    case operation::power:
      return power_of(first, second);
    case operation::negate:
      return -first;
    case operation::choice:
      return chosen(first, second, made[s.third].jet);
    case operation::lesser:
      return lesser(first, second);
    case operation::greater:
      return greater(first, second);
    case operation::scaled_logarithm:
      return natural_logarithm(first) / natural_logarithm(s.constant);
    default:
      return is_condition(s.what) ? condition_of(s.what, first, second)
                                  : function_of(s.what, first);
  }
}

interval_jet expression_enclosure::condition_of(operation what, const interval_jet& a,
                                                const interval_jet& b) {
  const double low = a.value.inf(), high = a.value.sup();
  const double other_low = b.value.inf(), other_high = b.value.sup();
  const truth first = truth_of(a), second = truth_of(b);
  switch (what) {
    case operation::less:
      return number_of(decided(high < other_low, low >= other_high));
    case operation::less_or_equal:
      return number_of(decided(high <= other_low, low > other_high));
    case operation::equal:
      return number_of(
          decided(low == other_high && high == other_low, high < other_low || other_high < low));
    case operation::conjunction:
      return number_of(decided(first == truth::yes && second == truth::yes,
                               first == truth::no || second == truth::no));
    default:  // a disjunction
      return number_of(decided(first == truth::yes || second == truth::yes,
                               first == truth::no && second == truth::no));
  }
}

interval_jet expression_enclosure::chosen(const interval_jet& condition, const interval_jet& yes,
                                          const interval_jet& no) {
  const truth holds = truth_of(condition);
  if (holds == truth::unknown) return either(yes, no);
  return holds == truth::yes ? yes : no;
}

interval_jet expression_enclosure::function_of(operation what, const interval_jet& a) {
  switch (what) {
    case operation::sine:
      return sine(a);
    case operation::cosine:
      return cosine(a);
    case operation::tangent:
      return sine(a) / cosine(a);
    case operation::arc_tangent:
      return arc_tangent(a);
    case operation::hyperbolic_sine:
      return (exponential(a) - exponential(-a)) / 2;
    case operation::hyperbolic_cosine:
      return (exponential(a) + exponential(-a)) / 2;
    case operation::hyperbolic_tangent:
      return hyperbolic_tangent(a);
    case operation::exponential:
      return exponential(a);
    case operation::logarithm:
      return natural_logarithm(a);
    case operation::root:
      return square_root(a);
    case operation::absolute:
      return absolute(a);
    default:
      return {everything(), everything(), everything()};
  }
}

interval_jet expression_enclosure::power_of(const interval_jet& base,
                                            const interval_jet& exponent) {
  // Largest power that is multiplied out; larger ones are enclosed by logarithms, less tightly.
  constexpr double most_multiplied = 64;
  const double n = exponent.value.inf();
  const bool is_constant = n == exponent.value.sup() && exponent.x.inf() == 0 &&
                           exponent.x.sup() == 0 && exponent.y.inf() == 0 && exponent.y.sup() == 0;
  if (is_constant && n == std::floor(n) && std::abs(n) <= most_multiplied)
    return whole_power(base, static_cast<int>(n));
  if (is_constant && n == 0.5) return square_root(base);
  // Returns everything for powers of negative numbers: they have either sign, or no value.
  if (base.value.inf() < 0) return {everything(), everything(), everything()};
  return exponential(exponent * natural_logarithm(base));
}

}  // namespace asterism::internal
