// SPDX-License-Identifier: MIT
#include "asterism/mesh/refine/curved_splits.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace asterism::internal {

curved_splits::curved_splits(const domain& d) {
  if (d.curves.empty()) return;
  std::map<std::pair<vertex_index, vertex_index>, chord> chords;
  for (const domain_curve& c : d.curves) {
    for (std::size_t i = 0; i + 1 < c.vertices.size(); ++i)
      chords[std::minmax(c.vertices[i], c.vertices[i + 1])] = {paths_.size(), c.parameters[i],
                                                               c.parameters[i + 1]};
    paths_.emplace_back(c, d.vertices[c.vertices.front()], d.vertices[c.vertices.back()]);
  }
  for (const segment& s : d.segments) {
    const auto found = chords.find(std::minmax(s.a, s.b));
    chord_of_segment_.push_back(found == chords.end() ? std::nullopt
                                                      : std::optional<chord>(found->second));
  }
}

std::optional<point> curved_splits::place(const boundary_edge& subsegment, const point& q) const {
  if (subsegment.segment >= chord_of_segment_.size()) return std::nullopt;
  const auto& on = chord_of_segment_[subsegment.segment];
  if (!on) return std::nullopt;
  for (const vertex_index v : {subsegment.a, subsegment.b})
    if (v < off_curve_.size() && off_curve_[v] != 0) return std::nullopt;
  const curve_path& path = paths_[on->curve];
  const auto t = path.nearest(q, on->t0, on->t1);
  if (!t) return std::nullopt;
  return path.at(*t);
}

void curved_splits::note_split(vertex_index v, bool on_curve) {
  if (on_curve || chord_of_segment_.empty()) return;
  if (off_curve_.size() <= v) off_curve_.resize(std::size_t{v} + 1, 0);
  off_curve_[v] = 1;
}

}  // namespace asterism::internal
