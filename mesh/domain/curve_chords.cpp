// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/curve_chords.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace asterism::internal {

curve_chords::curve_chords(const domain& d) {
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
    of_segment_.push_back(found == chords.end() ? std::nullopt
                                                : std::optional<chord>(found->second));
  }
}

std::optional<point> curve_chords::nearest(vertex_index segment, const point& q) const {
  const chord& on = *of_segment_[segment];
  const auto t = paths_[on.curve].nearest(q, on.t0, on.t1);
  return t ? std::optional(paths_[on.curve].at(*t)) : std::nullopt;
}

}  // namespace asterism::internal
