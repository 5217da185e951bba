// SPDX-License-Identifier: MIT
//
// Ends the making of stars early, even inside one star, when the run is cancelled or has reached
// its work limit.
//
// A star of hundreds of neighbours with different metrics can take seconds. So the guard is checked
// at every offer of a site. The cancellation, which may read a clock, is polled only after some
// work. A star that was cut short is not settled, and its run ends without it.
#pragma once

#include <cstddef>

#include "asterism/kernels/work_units.hpp"
#include "asterism/mesh/stars/star_predicates.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal {

// Work limit and cancellation for the stars that one thread makes.
class star_work_guard {
 public:
  // Takes a work limit in units. `cancelled` must outlive the guard.
  star_work_guard(const cancellation& cancelled, double most_units)
      : cancelled_(&cancelled), most_units_(most_units) {}

  // True if the kernel has done work up to the limit, or the run is cancelled; it stays true then.
  bool is_over(const star_predicates& kernel) {
    constexpr std::size_t asked_between = 4096;
    constexpr double units_between = 1000;  // about ten milliseconds
    if (over_) return true;
    const double units = work_units(kernel.counters());
    if (units > most_units_) return over_ = true;
    if (++asked_ < asked_between && units < polled_at_ + units_between) return false;
    asked_ = 0;
    polled_at_ = units;
    return over_ = cancelled_->is_requested();
  }

 private:
  const cancellation* cancelled_;
  double most_units_;
  double polled_at_ = 0;
  std::size_t asked_ = 0;
  bool over_ = false;
};

}  // namespace asterism::internal
