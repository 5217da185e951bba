// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/star_extent.hpp"

#include <cmath>

#include "asterism/mesh/support/infinity.hpp"

namespace asterism::internal::audit_detail {
namespace {

// The range of lengths and distances for which lines are computed: no product overflows.
constexpr double most = 0x1p400, least_length = 0x1p-400;

double constant(double x, double) { return x; }
by_covector constant(double x, const by_covector&) { return all_of(x); }
double size_of(double x) { return std::abs(x); }
by_covector size_of(const by_covector& x) { return {absolute(x.axes), absolute(x.diagonals)}; }

// Holds what the lines are made of: the values of E at the lengths 0 and `own`, and its greatest
// slope.
template <class Number>
struct known_extent {
  Number none, at_own, steep;

  void include(const Number& other_none, const Number& other_at_own, const Number& other_steep) {
    none = greater_of(none, other_none);
    at_own = greater_of(at_own, other_at_own);
    steep = greater_of(steep, other_steep);
  }
  // Returns the lines of `from` + E: the chord from 0 to `own`, and a line as steep as E gets. What
  // is known has errors of a few roundings of its size and of `size`. Makes slopes positive, so
  // that an infinite length has an infinite extent.
  extent_lines<Number> lines(const Number& from, const Number& own, const Number& size) const {
    const Number more = constant(1 + 0x1p-46, own), least_slope = constant(0x1p-1000, own);
    const Number steepest = own * steep;
    const Number lost = constant(roundings::step, own) *
                        (size_of(from) + size_of(none) + size_of(at_own) + steepest + size);
    const Number rise = greater_of((at_own - none) / own, constant(0, own));
    return {from + none + lost, rise * more + least_slope, from + at_own - steepest + lost,
            steep * more + least_slope};
  }
};

template <class Number>
both_extents<Number> unbounded(const Number& like) {
  const extent_lines<Number> lines{constant(infinity, like), constant(0, like),
                                   constant(infinity, like), constant(0, like)};
  return {lines, lines};
}

// The lines of `from` + E, with E(l) = (own + max(own, l)) reach.
template <class Number>
both_extents<Number> lines_of_reach(const Number& from, const Number& own, double reach) {
  if (!(reach < most)) return unbounded(own);
  const Number twice = constant(2 * reach, own) * own;
  const known_extent<Number> known{twice, twice, constant(reach, own)};
  return {known.lines(from, own, twice), known.lines(-from, own, twice)};
}

// Returns the covector along which the metric's unit circle extends least: an eigenvector of the
// greater eigenvalue, scaled; any other does, too.
point narrowest(const metric_tensor& m) {
  const double half = 0.5 * (m.m11 - m.m22), radius = std::sqrt(half * half + m.m12 * m.m12);
  const point g = half > 0 ? point{half + radius, m.m12} : point{m.m12, radius - half};
  const double scale = 1 / (std::abs(g.x) + std::abs(g.y));
  return scale < infinity ? point{g.x * scale, g.y * scale} : point{1, 0};
}

}  // namespace

star_extent::star_extent(const site& v, double reach) : star_extent(v, reach, {}) {}

star_extent::star_extent(const site& v, std::span<const outline_point> outline)
    : star_extent(v, infinity, outline) {}

star_extent::star_extent(const site& v, double reach, std::span<const outline_point> outline)
    : v_(v), reach_(reach), outline_(outline), own_(narrowest(v.metric)) {
  const double inverse = inverse_determinant_above(v.metric);
  length_of_four_ =
      greater_of(roots_above(squared_lengths(v.metric, inverse)), all_of(least_length));
  by_four_ = along_four(length_of_four_);
  by_own_ = along(own_, inverse);
}

both_extents<by_covector> star_extent::along_four(const by_covector& own) const {
  if (any_less(both(most), own.axes) || any_less(both(most), own.diagonals)) return unbounded(own);
  const by_covector from = values_at(v_.position), none = all_of(0);
  if (outline_.empty()) return lines_of_reach(from, own, reach_);
  known_extent<by_covector> forth{none, none, none}, back{none, none, none};
  double size = std::abs(v_.position.x) + std::abs(v_.position.y), steep = 0;
  for (const auto& [at, length] : outline_) {
    const by_covector value = values_at(at), more = own * all_of(length);
    forth.none = greater_of(forth.none, value);
    back.none = greater_of(back.none, -value);
    forth.at_own = greater_of(forth.at_own, value + more);
    back.at_own = greater_of(back.at_own, more - value);
    size = greater_of(size, std::abs(at.x) + std::abs(at.y));
    steep = greater_of(steep, length);
  }
  if (!(size < most && steep < most)) return unbounded(own);
  forth.steep = back.steep = all_of(steep);
  return {forth.lines(from, own, all_of(size)), back.lines(-from, own, all_of(size))};
}

both_extents<double> star_extent::along(const point& g, double inverse_determinant) const {
  const double own = greater_of(length_above(g, v_.metric, inverse_determinant), least_length);
  if (!(own < most)) return unbounded(own);
  if (outline_.empty()) return lines_of_reach(0.0, own, reach_);
  known_extent<double> forth{0, 0, 0}, back{0, 0, 0};
  double size = 0;
  for (const auto& [at, length] : outline_) {
    const double x = g.x * at.x, y = g.y * at.y, value = x + y, more = own * length;
    forth.include(value, value + more, length);
    back.include(-value, more - value, length);
    size = greater_of(size, std::abs(x) + std::abs(y));
  }
  if (!(size < most && forth.steep < most)) return unbounded(own);
  return {forth.lines(0, own, size), back.lines(0, own, size)};
}

// The greatest of all E, relative to the first star, is convex and increasing, too.
star_extent::star_extent(std::span<const star_extent> stars) : star_extent(stars.front()) {
  if (stars.size() == 1) return;
  const by_covector none = all_of(0), least = all_of(-infinity);
  known_extent<by_covector> forth{least, least, none}, back = forth;
  known_extent<double> own_forth{0, 0, 0}, own_back = own_forth;
  const double own = length_above(own_, v_.metric, inverse_determinant_above(v_.metric));
  double size = 0;
  bool is_in_range = true;
  const auto include = [](auto& all, const auto& lines, const auto& length, const auto& shift) {
    all.include(shift + lines.none, shift + lines.at(length), greater_of(lines.rise, lines.steep));
  };
  for (const star_extent& star : stars) {
    include(forth, star.by_four_.forth, length_of_four_, none);
    include(back, star.by_four_.back, length_of_four_, none);
    const both_extents<double> along_own =
        star.along(own_, inverse_determinant_above(star.v_.metric));
    const double x = own_.x * (star.v_.position.x - v_.position.x),
                 y = own_.y * (star.v_.position.y - v_.position.y);
    include(own_forth, along_own.forth, own, x + y);
    include(own_back, along_own.back, own, -(x + y));
    is_in_range = is_in_range && std::abs(x) + std::abs(y) < most;
    size = greater_of(std::abs(x) + std::abs(y), size);
  }
  by_four_ = {forth.lines(none, length_of_four_, none), back.lines(none, length_of_four_, none)};
  by_own_ = unbounded(own);
  if (is_in_range) by_own_ = {own_forth.lines(0, own, size), own_back.lines(0, own, size)};
}

}  // namespace asterism::internal::audit_detail
