// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/corner_angle.hpp"

#include <numbers>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/audit/rounded_rational.hpp"
#include "asterism/mesh/support/wide_range.hpp"

namespace asterism::internal::audit_detail {
namespace {

template <class Number>
struct corner_terms {
  Number left;   // a^T M b
  Number right;  // det M (a x b)^2
};

template <class Number>
corner_terms<Number> terms(const audit_context& context, const corner& c,
                           vertex_index perspective) {
  const auto a = difference<Number>(context.at(c.ahead), context.at(c.at));
  const auto b = difference<Number>(context.at(c.behind), context.at(c.at));
  const auto m = tensor_of<Number>(context.subject.sites[perspective].metric);
  const Number area = cross(a, b);
  return {dot(a, m * b), m.determinant() * area * area};
}

// A bound of the square of a cotangent, and doubles that enclose it.
struct exact_square {
  const bounded& filter;
  const rational& value;
};

// True if the corner's cotangent, as the vertex measures it, is positive and its square greater
// than the given one. Decided by doubles, or else exactly.
bool has_greater_cotangent(const audit_context& context, audit_tally& tally, const corner& c,
                           vertex_index perspective, const exact_square& square) {
  ++tally.part.decisions;
  const auto quick = terms<bounded>(context, c, perspective);
  if (quick.left.certainly_negative()) return false;
  const bounded spare = square.filter * quick.right - quick.left * quick.left;
  if (spare.certainly_positive()) return false;
  if (spare.certainly_negative() && quick.left.certainly_positive()) return true;
  ++tally.part.exact_decisions;
  const auto exact = terms<rational>(context, c, perspective);
  return exact.left > 0 && exact.left * exact.left > square.value * exact.right;
}

}  // namespace

squared_cotangent make_squared_cotangent(double degrees) {
  squared_cotangent c;
  if (degrees == 30)
    c.low = c.high = 3;
  else if (degrees == 45)
    c.low = c.high = 1;
  else if (degrees == 60)
    c.low = c.high = rational(1) / 3;
  else {
    const cotangent_bounds bounds = squared_cotangent_of(degrees);
    c.low = bounds.low;
    c.high = bounds.high;
  }
  const double value = as_double(rounded(c.low, 53, direction::down), direction::down);
  c.filter = bounded::within(value, value * 0x1p-50);
  c.root_below = root(c.filter).lower();
  return c;
}

bool is_proven_wide(const audit_context& context, audit_tally& tally, const corner& c,
                    vertex_index perspective, const squared_cotangent& bound) {
  return !has_greater_cotangent(context, tally, c, perspective, {bound.filter, bound.low});
}

bool is_proven_narrow(const audit_context& context, audit_tally& tally, const corner& c,
                      vertex_index perspective, const squared_cotangent& bound) {
  return has_greater_cotangent(context, tally, c, perspective, {bound.filter, bound.high});
}

double angle_in_degrees(const audit_context& context, const corner& c, vertex_index perspective) {
  const auto a = difference<wide_range>(context.at(c.ahead), context.at(c.at));
  const auto b = difference<wide_range>(context.at(c.behind), context.at(c.at));
  const auto m = tensor_of<wide_range>(context.subject.sites[perspective].metric);
  const wide_range height = root(m.determinant()) * cross(a, b);
  const auto [up, along] = scaled(height, dot(a, m * b));
  return elementary::atan2(up, along) * 180 / std::numbers::pi;
}

}  // namespace asterism::internal::audit_detail
