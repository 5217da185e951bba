// SPDX-License-Identifier: MIT
//
// Measures lengths along a line in a metric, in plain doubles: they only decide where points are
// proposed.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "asterism/core/result.hpp"

namespace asterism::internal {

// The length from the start of a line as a function of its parameter, from 0 to 1, sampled more
// densely where it bends: intervals are halved until the three measurements in each agree.
class arc_length {
 public:
  // Returns the metric length of the line's derivative at a parameter.
  using speed_function = std::function<result<double>(double)>;

  // Samples the length. Lengths below `fine` are not sampled further. Fails where `speed` does.
  static result<arc_length> measure(const speed_function& speed, double fine);

  double total() const { return lengths_.back(); }
  double length_at(double t) const { return interpolate(parameters_, lengths_, t); }
  double parameter_at(double length) const { return interpolate(lengths_, parameters_, length); }

 private:
  // Bounds on the number of intervals: sixteen at least, so that a segment cannot hide a bend from
  // three samples; at most 2^18, by which an interval of even the steepest metric that is meshed is
  // far below `fine`.
  static constexpr int least_depth = 4, most_depth = 18;
  // Greatest relative difference of the speeds at the ends and in the middle: Simpson's rule then
  // has an error below a thousandth (docs/results/constants.md has others).
  static constexpr double agreement = 0.05;

  explicit arc_length(double fine) : fine_(fine) {}

  double speed(const speed_function& at, double t);
  void add(const speed_function& at, double t0, double v0, double t1, double v1, int depth);
  static double interpolate(const std::vector<double>& from, const std::vector<double>& to,
                            double x);

  double fine_;
  std::vector<double> parameters_, lengths_;
  std::optional<error> failure_;
};

}  // namespace asterism::internal
