// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric/graded_variation.hpp"

#include <algorithm>
#include <cmath>

#include "asterism/core/floating_point_environment.hpp"
#include "asterism/core/rounded_quotient.hpp"
#include "asterism/mesh/metric/interval_functions.hpp"
#include "asterism/mesh/metric/logarithm_triangle.hpp"

namespace asterism::internal {
namespace {

// Encloses A(t) = artanh(s) / s, s the root of t, and its derivative. Both have power series with
// positive coefficients, 1 / (2 k + 1) and k / (2 k + 1), so they increase.
struct area_function {
  rounded_interval value, slope;
};

area_function area_series(double t) {
  constexpr int terms = 30;
  rounded_interval value = 0.0, slope = 0.0, power = 1.0;  // power: t^k, and t^(k-1) for the slope
  for (int k = 0; k < terms; ++k) {
    const rounded_interval odd = 2.0 * k + 1;
    value = value + divided(power, odd);
    slope = slope + divided(rounded_interval(k + 1.0) * power, odd + rounded_interval(2.0));
    power = power * rounded_interval(t);
  }
  // Bounds the terms left out of each series by t^30 / (1 - t), for t up to 1/4: 2^-60 * 4/3.
  const rounded_interval rest(0, 0x1p-59);
  return {value + rest, slope + rest};
}

area_function area_function_at(double t) {
  if (!(t < 1)) return {everything(), everything()};
  if (t <= 0.25) return area_series(std::max(t, 0.0));
  const rounded_interval one = 1.0, s = root_of(rounded_interval(t));
  const rounded_interval value =
      divided(rounded_interval(0.5) * logarithm_of(divided(one + s, one - s)), s);
  const rounded_interval slope =
      divided(divided(one, one - rounded_interval(t)) - value, rounded_interval(2 * t));
  return {value, slope};
}

interval_jet area_function_of(const interval_jet& t) {
  const area_function low = area_function_at(t.value.inf()), high = area_function_at(t.value.sup());
  const rounded_interval slope = hull(low.slope, high.slope);
  return {hull(low.value, high.value), slope * t.x, slope * t.y};
}

struct logarithm_jet {
  interval_jet l11, l12, l22;
};

// Returns the logarithm of tensors: (ln(det M) / 2) I + A(|D|^2 / m^2) D / m, with m half of the
// trace and D = M - m I.
logarithm_jet logarithm_of_tensors(const tensor_jet& g) {
  const interval_jet half = 0.5, m = half * (g.m11 + g.m22), a = half * (g.m11 - g.m22);
  const interval_jet t = (square(a) + square(g.m12)) / square(m);
  const interval_jet scale = half * natural_logarithm(g.m11 * g.m22 - square(g.m12));
  const interval_jet factor = area_function_of(t) / m;
  return {scale + factor * a, factor * g.m12, scale - factor * a};
}

// Returns the range over a box of a corner's barycentric coordinate. Only points in the triangle
// matter, so that the range is clamped to [0, 1].
interval_jet weight_of(const graded_triangle& t, std::size_t corner, const plane_jet& at) {
  const point &a = t.corners[(corner + 1) % 3], &b = t.corners[(corner + 2) % 3],
              &c = t.corners[corner];
  const auto difference = [](double p, double q) {
    return interval_jet(rounded_interval(p) - rounded_interval(q), 0.0, 0.0);
  };
  const interval_jet area =
      difference(b.x, a.x) * difference(c.y, a.y) - difference(b.y, a.y) * difference(c.x, a.x);
  interval_jet w =
      (difference(b.x, a.x) * (at.y - a.y) - difference(b.y, a.y) * (at.x - a.x)) / area;
  w.value = {std::clamp(w.value.inf(), 0.0, 1.0), std::clamp(w.value.sup(), 0.0, 1.0)};
  return w;
}

point middle_of(const bounding_box& b) {
  return {b.low.x / 2 + b.high.x / 2, b.low.y / 2 + b.high.y / 2};
}

}  // namespace

graded_region::graded_region(const graded_parts& field)
    : triangles_(field.triangles()), given_(dynamic_cast<const sized_field*>(&field.given())) {}

std::vector<graded_region::part> graded_region::first_parts() const {
  std::vector<part> parts;
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    bounding_box box{triangles_[i].corners[0], triangles_[i].corners[0]};
    box.include(triangles_[i].corners[1]);
    box.include(triangles_[i].corners[2]);
    parts.push_back({box, i});
  }
  return parts;
}

bool graded_region::misses_triangle(const part& p) const {
  const floating_point_scope scope(rounding::upward);
  const plane_jet at = coordinates_over({p.box.low.x, p.box.high.x}, {p.box.low.y, p.box.high.y});
  const graded_triangle& t = triangles_[p.triangle];
  for (std::size_t k = 0; k < 3; ++k) {
    const point &a = t.corners[k], &b = t.corners[(k + 1) % 3];
    const rounded_interval dx = rounded_interval(b.x) - rounded_interval(a.x),
                           dy = rounded_interval(b.y) - rounded_interval(a.y);
    const rounded_interval left =
        dx * (at.y.value - rounded_interval(a.y)) - dy * (at.x.value - rounded_interval(a.x));
    if (left.sup() < 0) return true;
  }
  return false;
}

std::optional<tensor_jet> graded_region::over(const part& p, const bounding_box& box) const {
  const plane_jet at = coordinates_over({box.low.x, box.high.x}, {box.low.y, box.high.y});
  const graded_triangle& t = triangles_[p.triangle];
  const auto count = std::count(t.kept.begin(), t.kept.end(), true);
  std::optional<tensor_jet> given;
  if (count > 0) {
    if (given_ != nullptr) given = given_->over(at);
    if (!given || count == 3) return given;
  }
  // Computes the mean as the logarithm at one corner, plus the weighted differences of the other
  // logarithms from that one: the barycentric weights add up to 1.
  const auto first = std::find(t.kept.begin(), t.kept.end(), false) - t.kept.begin();
  const tensor_logarithm& base = t.logarithms[static_cast<std::size_t>(first)];
  const logarithm_jet from{base.l11, base.l12, base.l22};
  logarithm_jet sum = from;
  const auto add = [&](const interval_jet& w, const logarithm_jet& l) {
    sum = {sum.l11 + w * (l.l11 - from.l11), sum.l12 + w * (l.l12 - from.l12),
           sum.l22 + w * (l.l22 - from.l22)};
  };
  interval_jet weight_of_given = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const interval_jet w = weight_of(t, k, at);
    const tensor_logarithm& l = t.logarithms[k];
    if (t.kept[k])
      weight_of_given = weight_of_given + w;
    else if (static_cast<std::ptrdiff_t>(k) != first)
      add(w, {l.l11, l.l12, l.l22});
  }
  if (given) add(weight_of_given, logarithm_of_tensors(*given));
  return exponential_over({sum.l11.value, sum.l12.value, sum.l22.value},
                          {sum.l11.x, sum.l12.x, sum.l22.x}, {sum.l11.y, sum.l12.y, sum.l22.y});
}

result<variation_of_part> graded_region::bounds_of(const part& p) const {
  const floating_point_scope scope(rounding::upward);
  const point m = middle_of(p.box);
  // Sums and differences are rounded by 2^-53 of themselves.
  const small_part shape{m, std::max(p.box.high.x - m.x, m.x - p.box.low.x) * (1 + 0x1p-50),
                         std::max(p.box.high.y - m.y, m.y - p.box.low.y) * (1 + 0x1p-50)};
  const auto all = over(p, p.box), here = over(p, {m, m});
  if (!all || !here) return error{"nothing is known of the field that was graded"};
  variation_of_part found = bound_variation_of(shape, *all, *here);
  if (misses_triangle({{m, m}, p.triangle})) found.in_middle = 0;  // seen is what is there
  return found;
}

std::optional<std::array<graded_region::part, 2>> graded_region::halves(const part& p) {
  const point m = middle_of(p.box);
  const bounding_box& b = p.box;
  const bool across_x = b.high.x - b.low.x >= b.high.y - b.low.y;
  if (across_x ? !(b.low.x < m.x && m.x < b.high.x) : !(b.low.y < m.y && m.y < b.high.y))
    return std::nullopt;
  const point cut = across_x ? point{m.x, b.high.y} : point{b.high.x, m.y};
  const point other_cut = across_x ? point{m.x, b.low.y} : point{b.low.x, m.y};
  return std::array<part, 2>{{{{b.low, cut}, p.triangle}, {{other_cut, b.high}, p.triangle}}};
}

}  // namespace asterism::internal
