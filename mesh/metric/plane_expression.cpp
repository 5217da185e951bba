// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric/plane_expression.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "asterism/core/elementary.hpp"

namespace asterism::internal {

namespace {

using operation = formula::operation;
using step = plane_expression::step;

// The functions that elementary.hpp does not have.
double arc_sine(double x) { return elementary::atan2(x, std::sqrt((1 - x) * (1 + x))); }
double arc_cosine(double x) { return elementary::atan2(std::sqrt((1 - x) * (1 + x)), x); }
double hyperbolic_cosine(double x) { return (elementary::exp(x) + elementary::exp(-x)) / 2; }
double hyperbolic_sine(double x) {
  if (std::abs(x) > 1) return (elementary::exp(x) - elementary::exp(-x)) / 2;
  const double t = elementary::tanh(x);
  return t / std::sqrt((1 - t) * (1 + t));
}
double sign(double x) { return x < 0 ? -1 : (x > 0 ? 1 : 0); }

// Returns the value of a function of one number.
double function_of(const step& s, double x) {
  switch (s.what) {
    case operation::negate:
      return -x;
    case operation::sine:
      return elementary::sin(x);
    case operation::cosine:
      return elementary::cos(x);
    case operation::tangent:
      return elementary::tan(x);
    case operation::arc_sine:
      return arc_sine(x);
    case operation::arc_cosine:
      return arc_cosine(x);
    case operation::arc_tangent:
      return elementary::atan2(x, 1);
    case operation::hyperbolic_sine:
      return hyperbolic_sine(x);
    case operation::hyperbolic_cosine:
      return hyperbolic_cosine(x);
    case operation::hyperbolic_tangent:
      return elementary::tanh(x);
    case operation::area_sine:
      return elementary::log(x + std::sqrt(x * x + 1));
    case operation::area_cosine:
      return elementary::log(x + std::sqrt(x * x - 1));
    case operation::area_tangent:
      return 0.5 * elementary::log((1 + x) / (1 - x));
    case operation::exponential:
      return elementary::exp(x);
    case operation::logarithm:
      return elementary::log(x);
    case operation::scaled_logarithm:
      return s.constant == 2 ? elementary::log2(x) : elementary::log10(x);
    case operation::root:
      return std::sqrt(x);
    case operation::absolute:
      return x >= 0 ? x : -x;
    case operation::sign:
      return sign(x);
    default:
      return std::floor(x + 0.5);  // the nearest whole number
  }
}

// Returns the value of an operation on two numbers.
double combined(operation what, double a, double b) {
  switch (what) {
    case operation::add:
    case operation::total:
      return a + b;
    case operation::subtract:
      return a - b;
    case operation::multiply:
      return a * b;
    case operation::divide:
      return a / b;
    case operation::power:
      return elementary::pow(a, b);
    case operation::less:
      return a < b ? 1 : 0;
    case operation::less_or_equal:
      return a <= b ? 1 : 0;
    case operation::equal:
      return a == b ? 1 : 0;
    case operation::conjunction:
      return a != 0 && b != 0 ? 1 : 0;
    case operation::disjunction:
      return a != 0 || b != 0 ? 1 : 0;
    case operation::angle:
      return elementary::atan2(a, b);
    case operation::lesser:
      return std::min(a, b);
    default:
      return std::max(a, b);
  }
}

bool is_coordinate(const step& s) { return s.what == operation::x || s.what == operation::y; }
bool is_constant(const step& s) { return s.what == operation::constant; }

// Returns the number of operands of an operation.
std::size_t operands_of(operation what) {
  switch (what) {
    case operation::constant:
    case operation::x:
    case operation::y:
      return 0;
    case operation::choice:
      return 3;
    case operation::add:
    case operation::subtract:
    case operation::multiply:
    case operation::divide:
    case operation::power:
    case operation::less:
    case operation::less_or_equal:
    case operation::equal:
    case operation::conjunction:
    case operation::disjunction:
    case operation::angle:
    case operation::total:
    case operation::lesser:
    case operation::greater:
      return 2;
    default:
      return 1;
  }
}

double value_of(const step& s, const point& q, const double* made) {
  switch (operands_of(s.what)) {
    case 0: {
      if (is_constant(s)) return s.constant;
      return (s.what == operation::x ? q.x : q.y) * s.factor + s.constant;
    }
    case 1:
      return function_of(s, made[s.first]);
    case 2:
      return combined(s.what, made[s.first], made[s.second]);
    default:
      return made[s.first] != 0 ? made[s.second] : made[s.third];
  }
}

step constant_step(double value) { return {{operation::constant, value}, 0}; }

// Returns a coordinate's multiple plus a constant, or a constant where the factor is that of one.
step linear_step(const step& of, double factor, double constant) {
  return {{of.what, constant + 0.0}, factor};  // the sum makes -0 a 0
}

// Returns the sum, difference, product or quotient of two steps as a multiple of a coordinate plus
// a constant, if it is one. A coordinate divided by a constant is none, since a product with the
// rounded inverse has other bits.
std::optional<step> linear(operation what, const step& a, const step& b) {
  const bool may_be_sum = (is_constant(a) || is_coordinate(a)) &&
                          (is_constant(b) || is_coordinate(b)) &&
                          (is_constant(a) || is_constant(b) || a.what == b.what);
  const step& coordinate = is_coordinate(a) ? a : b;
  if (what == operation::add && may_be_sum)
    return linear_step(coordinate, a.factor + b.factor, a.constant + b.constant);
  if (what == operation::subtract && may_be_sum)
    return linear_step(coordinate, a.factor - b.factor, a.constant - b.constant);
  const step& other = is_coordinate(a) ? b : a;
  if (!is_coordinate(coordinate) || !is_constant(other) || !std::isfinite(other.constant))
    return std::nullopt;
  const double c = other.constant;
  if (what == operation::multiply)
    return linear_step(coordinate, coordinate.factor * c, coordinate.constant * c);
  const bool is_alone = coordinate.factor == 1 && coordinate.constant == 0;
  if (what == operation::divide && is_coordinate(a) && !is_alone && c != 0)
    return linear_step(coordinate, coordinate.factor / c, coordinate.constant / c);
  return std::nullopt;
}

// True for operations on constants that are done once, before the first evaluation. The order of
// additions and products matters for the bits of the others.
bool is_done_once(operation what) {
  return what != operation::power && what != operation::total && what != operation::lesser &&
         what != operation::greater && what != operation::choice;
}

// Returns the step with its operands taken into it, where they are constants or multiples of a
// coordinate.
step shortened(const step& s, const std::vector<step>& before) {
  const std::size_t count = operands_of(s.what);
  if (count == 0 || !is_done_once(s.what)) return s;
  const step& a = before[s.first];
  if (count == 1) return is_constant(a) ? constant_step(function_of(s, a.constant)) : s;
  const step& b = before[s.second];
  if (is_constant(a) && is_constant(b))
    return constant_step(combined(s.what, a.constant, b.constant));
  return linear(s.what, a, b).value_or(s);
}

// Removes the steps that no other one takes, but for the last.
std::vector<step> without_unused(const std::vector<step>& all) {
  std::vector<char> is_used(all.size(), 0);
  is_used.back() = 1;
  for (std::size_t i = all.size(); i-- > 0;) {
    if (is_used[i] == 0) continue;
    const std::size_t count = operands_of(all[i].what);
    const std::array operands = {all[i].first, all[i].second, all[i].third};
    for (std::size_t k = 0; k < count; ++k) is_used[operands[k]] = 1;
  }
  std::vector<step> kept;
  std::vector<std::size_t> number(all.size(), 0);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (is_used[i] == 0) continue;
    number[i] = kept.size();
    step s = all[i];
    s.first = number[s.first];
    s.second = number[s.second];
    s.third = number[s.third];
    kept.push_back(s);
  }
  return kept;
}

}  // namespace

result<plane_expression> plane_expression::parse(const std::string& text) {
  const auto read = formula::read(text);
  if (!read) return read.failure();
  std::vector<step> steps;
  for (const formula::step& s : read.value().steps) {
    step made{s, 0};
    if (is_coordinate(made)) {
      made.factor = 1;
      made.constant = -0.0;  // keeps the sign of a coordinate that is zero
    }
    steps.push_back(shortened(made, steps));
  }
  plane_expression made;
  made.steps_ = without_unused(steps);
  return made;
}

double plane_expression::operator()(const point& q) const {
  constexpr std::size_t few = 64;  // values that are kept without a block of the heap
  std::array<double, few> some;
  std::vector<double> many(steps_.size() > few ? steps_.size() : 0);
  double* const made = many.empty() ? some.data() : many.data();
  for (std::size_t i = 0; i < steps_.size(); ++i) made[i] = value_of(steps_[i], q, made);
  return made[steps_.size() - 1];
}

}  // namespace asterism::internal
