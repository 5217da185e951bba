// SPDX-License-Identifier: MIT
#include "asterism/mesh/numerics/target_search.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asterism::internal {

double target_search::width() const {
  return below_ && above_ ? std::abs(above_->at - below_->at)
                          : std::numeric_limits<double>::infinity();
}

bool target_search::is_saturated() const {
  constexpr int enough = 6;
  return !(below_ && above_) && alike_ >= enough;
}

bool target_search::take(double off, std::optional<double> slope) {
  constexpr double same = 1e-9;
  constexpr double greatest = 1500;  // above the logarithm of the ratio of any two doubles
  if (std::isnan(off)) return false;
  const bool is_nearest = std::abs(off) < least_;
  if (is_nearest) least_ = std::abs(off);
  const place now{at_, std::clamp(off, -greatest, greatest)};
  alike_ = last_ && std::abs(off - last_->off) <= same ? alike_ + 1 : 0;
  const bool is_above = off > 0, was_above = last_ && last_->off > 0;
  std::optional<place>& other = is_above ? below_ : above_;
  if (last_ && is_above == was_above && other) other->off /= 2;
  const double growth = slope.value_or(slope_after(now));
  (is_above ? above_ : below_) = last_ = now;
  if (below_ && above_)
    step_between();
  else
    step_outward(off, growth);
  return is_nearest;
}

double target_search::slope_after(const place& now) const {
  if (!last_) return 1;
  return now.at == last_->at ? 0 : (now.off - last_->off) / (now.at - last_->at);
}

void target_search::step_outward(double off, double slope) {
  constexpr double longest = 4 * std::numbers::ln2;  // a factor of 16
  if (std::isinf(off)) {
    at_ -= std::copysign(longest, off);
    return;
  }
  const double growth = std::clamp(slope, slowest_, 1.0);
  constexpr double unbounded = std::numeric_limits<double>::infinity();
  const double step = growth > 0 ? off / growth : std::copysign(unbounded, off);
  at_ -= std::clamp(step, -std::abs(off) - longest, std::abs(off) + longest);
}

void target_search::step_between() {
  constexpr double nearest_to_end = 0.1;
  const double part =
      std::clamp(-below_->off / (above_->off - below_->off), nearest_to_end, 1 - nearest_to_end);
  at_ = below_->at + part * (above_->at - below_->at);
}

}  // namespace asterism::internal
