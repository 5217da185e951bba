// SPDX-License-Identifier: MIT
//
// Finds where to split the chords of curves: at the point of the curve that is nearest to a given
// point of the chord.
//
// Once a chord was split at a point on its own line, its parts are split on that line too: there is
// no piece of the curve between a point on the curve and one on the chord.
#pragma once

#include <optional>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/domain/curve_chords.hpp"

namespace asterism::internal {

class curved_splits {
 public:
  curved_splits() = default;
  // Takes the curves of `d`, which check_domain has accepted.
  explicit curved_splits(const domain& d) : chords_(d) {}

  // Returns about the nearest point to q on the curve whose chord the subsegment is; none if the
  // subsegment is no chord, or if one of its ends or the nearest point is not on the curve between
  // the chord's ends.
  std::optional<point> place(const boundary_edge& subsegment, const point& q) const;
  // Records that site v splits a subsegment, on its curve or on its line.
  void note_split(vertex_index v, bool on_curve);

 private:
  curve_chords chords_;
  std::vector<char> off_curve_;  // by site, as far as it goes
};

}  // namespace asterism::internal
