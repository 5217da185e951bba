// SPDX-License-Identifier: MIT
//
// Finds the piece of a curve that a segment of a divided domain is the chord of, and places on it.
// Refinement and local changes, which split segments, use it.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/domain/curve_path.hpp"

namespace asterism::internal {

class curve_chords {
 public:
  curve_chords() = default;
  // Takes the curves of `d`, which check_domain has accepted.
  explicit curve_chords(const domain& d);

  bool empty() const { return of_segment_.empty(); }
  bool is_chord(vertex_index segment) const {
    return segment < of_segment_.size() && of_segment_[segment];
  }
  // Returns about the nearest point to q on the curve, strictly between the ends of the chord; none
  // if an end is nearest. Requires a chord.
  std::optional<point> nearest(vertex_index segment, const point& q) const;

 private:
  struct chord {
    std::size_t curve = 0;
    double t0 = 0, t1 = 1;
  };

  std::vector<curve_path> paths_;
  std::vector<std::optional<chord>> of_segment_;  // empty without curves
};

}  // namespace asterism::internal
