// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric/plane_expression.hpp"

#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "asterism/core/elementary.hpp"

namespace asterism::internal {

namespace {

// Sign that replaces ^ in expressions given to muparser, and may not be used in them: muparser's
// own operator ^ is the C library's function, and cannot be replaced.
constexpr char power_sign = '#';

std::string with_sign_replaced(std::string text, char from, char to) {
  std::replace(text.begin(), text.end(), from, to);
  return text;
}

error parser_failure(const std::string& text, const mu::ParserError& e) {
  std::string what = "'" + text + "': " + with_sign_replaced(e.GetMsg(), power_sign, '^');
  while (!what.empty() && (what.back() == '\n' || what.back() == '.')) what.pop_back();
  return {what + " (position " + std::to_string(e.GetPos() + 1) + ")"};
}

// Returns the position of an `=` that is no part of a comparison: muparser would change x or y
// there.
std::size_t find_assignment(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '=') continue;
    if (i + 1 < text.size() && text[i + 1] == '=') {
      ++i;
    } else if (i == 0 || (text[i - 1] != '<' && text[i - 1] != '>' && text[i - 1] != '!')) {
      return i;
    }
  }
  return std::string::npos;
}

// Replaces muparser's functions, which are the C library's and differ in the last place between
// libraries.
double arc_tangent(double x) { return elementary::atan2(x, 1); }
double arc_sine(double x) { return elementary::atan2(x, std::sqrt((1 - x) * (1 + x))); }
double arc_cosine(double x) { return elementary::atan2(std::sqrt((1 - x) * (1 + x)), x); }
double hyperbolic_cosine(double x) { return (elementary::exp(x) + elementary::exp(-x)) / 2; }
double hyperbolic_sine(double x) {
  if (std::abs(x) > 1) return (elementary::exp(x) - elementary::exp(-x)) / 2;
  const double t = elementary::tanh(x);
  return t / std::sqrt((1 - t) * (1 + t));
}

void define_functions(mu::Parser& parser) {
  parser.DefineFun("sin", &elementary::sin);
  parser.DefineFun("cos", &elementary::cos);
  parser.DefineFun("tan", &elementary::tan);
  parser.DefineFun("asin", &arc_sine);
  parser.DefineFun("acos", &arc_cosine);
  parser.DefineFun("atan", &arc_tangent);
  parser.DefineFun("atan2", &elementary::atan2);
  parser.DefineFun("sinh", &hyperbolic_sine);
  parser.DefineFun("cosh", &hyperbolic_cosine);
  parser.DefineFun("tanh", &elementary::tanh);
  parser.DefineFun("log2", &elementary::log2);
  parser.DefineFun("log10", &elementary::log10);
  parser.DefineFun("log", &elementary::log);
  parser.DefineFun("ln", &elementary::log);
  parser.DefineFun("exp", &elementary::exp);
  parser.DefineOprt(std::string(1, power_sign), &elementary::pow, mu::prPOW, mu::oaRIGHT);
}

}  // namespace

// Keeps the state at one address, since the parser holds the addresses of x and y.
struct plane_expression::state {
  std::string text;
  double x = 0, y = 0;
  mu::Parser parser;
};

plane_expression::plane_expression(std::unique_ptr<state> s) : state_(std::move(s)) {}
plane_expression::plane_expression(plane_expression&&) noexcept = default;
plane_expression& plane_expression::operator=(plane_expression&&) noexcept = default;
plane_expression::~plane_expression() = default;

result<plane_expression> plane_expression::parse(const std::string& text) {
  if (text.find_first_not_of(" \t") == std::string::npos) return error{"an expression is empty"};
  if (const std::size_t at = find_assignment(text); at != std::string::npos)
    return error{"'" + text + "': assignments are not allowed (position " + std::to_string(at + 1) +
                 ")"};
  if (const std::size_t at = text.find(power_sign); at != std::string::npos)
    return error{"'" + text + "': unexpected '#' (position " + std::to_string(at + 1) + ")"};
  auto s = std::make_unique<state>();
  s->text = text;
  try {
    s->parser.DefineVar("x", &s->x);
    s->parser.DefineVar("y", &s->y);
    define_functions(s->parser);
    s->parser.DefineConst("pi", std::numbers::pi);
    s->parser.DefineConst("e", std::numbers::e);
    s->parser.SetExpr(with_sign_replaced(text, '^', power_sign));
    int values = 0;
    // Evaluates once: muparser finds errors at the first evaluation.
    s->parser.Eval(values);
    if (values != 1)
      return error{"'" + text + "': one value is wanted, not " + std::to_string(values)};
  } catch (const mu::ParserError& e) {
    return parser_failure(text, e);
  }
  return plane_expression(std::move(s));
}

result<double> plane_expression::operator()(const point& q) const {
  state_->x = q.x;
  state_->y = q.y;
  try {
    return state_->parser.Eval();
  } catch (const mu::ParserError& e) {
    return parser_failure(state_->text, e);
  }
}

}  // namespace asterism::internal
