// SPDX-License-Identifier: MIT
#include "asterism/mesh/adapt/curve_parts.hpp"

#include <algorithm>

#include "asterism/mesh/search/hilbert_order.hpp"
#include "asterism/mesh/support/parallel.hpp"

namespace asterism::internal::adapting {

curve_parts::curve_parts(const std::vector<node>& nodes, const std::vector<face>& faces,
                         const bounding_box& box, std::size_t parts)
    : box_(box), part_(faces.size(), 0) {
  if (parts < 2) return;
  constexpr std::size_t faces_at_once = 4096;  // for a thread
  std::vector<std::uint64_t> places(faces.size());
  parallel_chunks(
      faces.size(), faces_at_once, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
          if (!faces[t].exists()) continue;
          const point &a = nodes[faces[t].v[0]].position, &b = nodes[faces[t].v[1]].position,
                      &c = nodes[faces[t].v[2]].position;
          places[t] = place_on_curve({(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3}, box_);
        }
      });
  constexpr std::size_t sampled = 16;  // one face in this number
  std::vector<std::uint64_t> sample;
  for (std::size_t t = 0; t < faces.size(); t += sampled)
    if (faces[t].exists()) sample.push_back(places[t]);
  std::sort(sample.begin(), sample.end());
  for (std::size_t part = 1; part < parts && !sample.empty(); ++part)
    bounds_.push_back(sample[part * sample.size() / parts]);
  // Tries the part of the face before first, which is nearly always the part of the next one, too.
  parallel_chunks(faces.size(), faces_at_once,
                  [&](std::size_t, std::size_t begin, std::size_t end) {
                    std::uint32_t last = 0;
                    for (std::size_t t = begin; t < end; ++t)
                      part_[t] = last = is_in(places[t], last) ? last : at(places[t]);
                  });
}

bool curve_parts::is_in(std::uint64_t place, std::uint32_t part) const {
  return (part == 0 || bounds_[part - 1] <= place) &&
         (part == bounds_.size() || place < bounds_[part]);
}

std::uint32_t curve_parts::at(std::uint64_t place) const {
  return static_cast<std::uint32_t>(std::upper_bound(bounds_.begin(), bounds_.end(), place) -
                                    bounds_.begin());
}

std::uint32_t curve_parts::near(const point& q) const { return at(place_on_curve(q, box_)); }

}  // namespace asterism::internal::adapting
