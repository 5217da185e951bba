// SPDX-License-Identifier: MIT
#include "asterism/mesh/refine/curved_splits.hpp"

namespace asterism::internal {

std::optional<point> curved_splits::place(const boundary_edge& subsegment, const point& q) const {
  if (!chords_.is_chord(subsegment.segment)) return std::nullopt;
  for (const vertex_index v : {subsegment.a, subsegment.b})
    if (v < off_curve_.size() && off_curve_[v] != 0) return std::nullopt;
  return chords_.nearest(subsegment.segment, q);
}

void curved_splits::note_split(vertex_index v, bool on_curve) {
  if (on_curve || chords_.empty()) return;
  if (off_curve_.size() <= v) off_curve_.resize(std::size_t{v} + 1, 0);
  off_curve_[v] = 1;
}

}  // namespace asterism::internal
