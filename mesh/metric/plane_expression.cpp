// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric/plane_expression.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "asterism/core/elementary.hpp"

namespace asterism::internal {

namespace {

using operation = formula::operation;
using step = formula::step;

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
    case 0:
      if (s.what == operation::constant) return s.constant;
      return s.what == operation::x ? q.x : q.y;
    case 1:
      return function_of(s, made[s.first]);
    case 2:
      return combined(s.what, made[s.first], made[s.second]);
    default:
      return made[s.first] != 0 ? made[s.second] : made[s.third];
  }
}

}  // namespace

result<plane_expression> plane_expression::parse(const std::string& text) {
  auto read = formula::read(text);
  if (!read) return read.failure();
  plane_expression made;
  made.steps_ = std::move(read).value().steps;
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
