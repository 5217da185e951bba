// SPDX-License-Identifier: MIT
#include "asterism/mesh/adapt/curve_parts.hpp"

#include <algorithm>

#include "asterism/mesh/search/hilbert_order.hpp"
#include "asterism/mesh/support/parallel.hpp"
#include "asterism/mesh/support/prefetch.hpp"

namespace asterism::internal::adapting {
namespace {

constexpr std::size_t faces_placed_at_once = 4096;  // for a thread

}  // namespace

curve_parts::curve_parts(const std::vector<node>& nodes, const std::vector<face>& faces,
                         const bounding_box& box, std::size_t parts)
    : box_(box), part_(faces.size(), 0) {
  const auto place_of = [&](const face& f) {
    const point &a = nodes[f.v[0]].position, &b = nodes[f.v[1]].position,
                &c = nodes[f.v[2]].position;
    return place_on_curve({(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3}, box_);
  };
  const auto prefetch_nodes = [&](const face& f) {
    if (f.exists())
      for (const vertex_index v : f.v) prefetch(&nodes[v].position);
  };
  if (parts > 1) divide_curve(faces, place_of, prefetch_nodes, parts);
  // Tries the part of the face before first, which is nearly always the part of the next one, too.
  parallel_chunks(faces.size(), faces_placed_at_once,
                  [&](std::size_t, std::size_t begin, std::size_t end) {
                    std::uint32_t last = 0;
                    for (std::size_t t = begin; t < end; ++t) {
                      if (t + triangles_ahead < end) prefetch_nodes(faces[t + triangles_ahead]);
                      if (!faces[t].exists()) {
                        part_[t] = static_cast<std::uint32_t>(count());
                      } else if (!bounds_.empty()) {
                        const std::uint64_t place = place_of(faces[t]);
                        part_[t] = last = is_in(place, last) ? last : at(place);
                      }
                    }
                  });
}

// Finds the bounds between parts: quantiles of the places of a sample.
template <class Place, class Prefetch>
void curve_parts::divide_curve(const std::vector<face>& faces, const Place& place_of,
                               const Prefetch& prefetch_nodes, std::size_t parts) {
  constexpr std::size_t sampled = 16;  // one face in this number
  const auto append = [&](std::size_t begin, std::size_t end, std::vector<std::uint64_t>& places) {
    for (std::size_t i = begin; i < end; ++i) {
      if (i + 2 * triangles_ahead < end) prefetch(&faces[sampled * (i + 2 * triangles_ahead)]);
      if (i + triangles_ahead < end) prefetch_nodes(faces[sampled * (i + triangles_ahead)]);
      if (faces[sampled * i].exists()) places.push_back(place_of(faces[sampled * i]));
    }
  };
  std::vector<std::uint64_t> sample = collect_chunks<std::uint64_t>(
      chunk_count(faces.size(), sampled), faces_placed_at_once, append);
  std::sort(sample.begin(), sample.end());
  for (std::size_t part = 1; part < parts && !sample.empty(); ++part)
    bounds_.push_back(sample[part * sample.size() / parts]);
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
