// SPDX-License-Identifier: MIT
#include "asterism/mesh/numerics/arc_length.hpp"

#include <algorithm>

namespace asterism::internal {

result<arc_length> arc_length::measure(const speed_function& speed, double fine) {
  arc_length measured(fine);
  const double first = measured.speed(speed, 0), last = measured.speed(speed, 1);
  measured.parameters_.push_back(0);
  measured.lengths_.push_back(0);
  measured.add(speed, 0, first, 1, last, 0);
  if (measured.failure_) return *measured.failure_;
  return measured;
}

double arc_length::speed(const speed_function& at, double t) {
  if (failure_) return 0;
  const auto found = at(t);
  if (found) return found.value();
  failure_ = found.failure();
  return 0;
}

void arc_length::add(const speed_function& at, double t0, double v0, double t1, double v1,
                     int depth) {
  const double t = (t0 + t1) / 2, v = speed(at, t);
  if (failure_) return;
  const double length = (t1 - t0) * (v0 + 4 * v + v1) / 6;
  const bool even = std::max({v0, v, v1}) <= (1 + agreement) * std::min({v0, v, v1});
  if (depth < least_depth || (depth < most_depth && !even && length > fine_)) {
    add(at, t0, v0, t, v, depth + 1);
    add(at, t, v, t1, v1, depth + 1);
    return;
  }
  parameters_.push_back(t1);
  lengths_.push_back(lengths_.back() + length);
}

double arc_length::interpolate(const std::vector<double>& from, const std::vector<double>& to,
                               double x) {
  const auto above = std::upper_bound(from.begin() + 1, from.end() - 1, x);
  const auto i = static_cast<std::size_t>(above - from.begin());
  const double part = (x - from[i - 1]) / (from[i] - from[i - 1]);
  return to[i - 1] + std::clamp(part, 0.0, 1.0) * (to[i] - to[i - 1]);
}

}  // namespace asterism::internal
