// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface_audit/trim_region.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "asterism/core/rounded_interval.hpp"

namespace asterism::internal {
namespace {

// Returns twice the area of a, b, p: positive if p is on the left of the line from a to b.
rounded_interval turn(const parameter_point& a, const parameter_point& b,
                      const parameter_point& p) {
  const auto difference = [](double x, double y) {
    return rounded_interval(x) - rounded_interval(y);
  };
  return difference(b[0], a[0]) * difference(p[1], a[1]) -
         difference(b[1], a[1]) * difference(p[0], a[0]);
}

// True unless the segment certainly has no point in the box.
bool may_meet(const parameter_segment& s, const parameter_box& box) {
  for (std::size_t k = 0; k < 2; ++k)
    if (std::max(s.from[k], s.to[k]) < box.low[k] || std::min(s.from[k], s.to[k]) > box.high[k])
      return false;
  int left = 0, right = 0;
  for (const double u : {box.low[0], box.high[0]})
    for (const double v : {box.low[1], box.high[1]}) {
      const rounded_interval side = turn(s.from, s.to, {u, v});
      left += side.inf() > 0 ? 1 : 0;
      right += side.sup() < 0 ? 1 : 0;
    }
  return left < 4 && right < 4;
}

}  // namespace

trim_region::trim_region(std::vector<parameter_segment> border) : border_(std::move(border)) {
  if (border_.empty()) return;
  double low = border_[0].from[1], high = low;
  for (const parameter_segment& s : border_)
    low = std::min(low, s.from[1]), high = std::max(high, s.from[1]);
  low_ = low;
  const auto count = std::max<std::size_t>(1, border_.size() / 2);
  height_ = (high - low) / static_cast<double>(count);
  rows_.resize(height_ > 0 ? count : 1);
  for (std::uint32_t k = 0; k < border_.size(); ++k) {
    const parameter_segment& s = border_[k];
    // Adds a row at either end: a later search for a row may be rounded differently.
    const std::size_t first = row_of(std::min(s.from[1], s.to[1])),
                      last = row_of(std::max(s.from[1], s.to[1]));
    for (std::size_t row = first > 0 ? first - 1 : 0; row <= last + 1 && row < rows_.size(); ++row)
      rows_[row].push_back(k);
  }
}

// Returns the row of v. The result is monotonic in v, whatever the rounding is.
std::size_t trim_region::row_of(double v) const {
  if (rows_.size() == 1 || !(v > low_)) return 0;
  const double row = (v - low_) / height_;
  return row >= static_cast<double>(rows_.size()) ? rows_.size() - 1
                                                  : static_cast<std::size_t>(row);
}

// Returns the winding number of the border around p, along a ray towards greater u: ends are
// compared exactly, an end on the ray's line counts as above it.
region_side trim_region::side_of_point(const parameter_point& p) const {
  int around = 0;
  for (const std::uint32_t k : rows_[row_of(p[1])]) {
    const parameter_segment& s = border_[k];
    const bool up = s.from[1] < p[1] && s.to[1] >= p[1], down = s.to[1] < p[1] && s.from[1] >= p[1];
    if (!up && !down) continue;
    const rounded_interval side = turn(s.from, s.to, p);
    if (side.inf() <= 0 && side.sup() >= 0) return region_side::undecided;
    if (up && side.inf() > 0) ++around;
    if (down && side.sup() < 0) --around;
  }
  return around > 0 ? region_side::inside : region_side::outside;
}

region_side trim_region::side_of(const parameter_box& box) const {
  if (border_.empty()) return region_side::inside;
  const std::size_t last = row_of(box.high[1]);
  for (std::size_t row = row_of(box.low[1]); row <= last; ++row)
    for (const std::uint32_t k : rows_[row])
      if (may_meet(border_[k], box)) return region_side::undecided;
  return side_of_point(box.low);
}

bool is_within(const std::array<parameter_point, 3>& triangle, const parameter_point& p) {
  int left = 0, right = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const rounded_interval side = turn(triangle[k], triangle[(k + 1) % 3], p);
    left += side.inf() >= 0 ? 1 : 0;
    right += side.sup() <= 0 ? 1 : 0;
  }
  return left == 3 || right == 3;
}

}  // namespace asterism::internal
