// SPDX-License-Identifier: MIT
#include "asterism/mesh/adapt/curve_parts.hpp"

#include <algorithm>

#include "asterism/mesh/search/hilbert_order.hpp"
#include "asterism/mesh/support/parallel.hpp"
#include "asterism/mesh/support/prefetch.hpp"

namespace asterism::internal::adapting {
namespace {

constexpr std::size_t faces_placed_at_once = 4096;  // for a thread
// Place of a face that does not exist: beyond the end of the curve.
constexpr std::uint64_t nowhere = ~std::uint64_t{0};
static_assert(bits_of_place_on_curve < 64);

// Returns the place of each face's centroid on the curve through the box. A cut reads the places
// twice, for its sample and for all faces: eight bytes of each, where the nodes are three lines of
// memory.
std::vector<std::uint64_t> places_of(const std::vector<node>& nodes, const std::vector<face>& faces,
                                     const bounding_box& box) {
  std::vector<std::uint64_t> places;
  resize_in_threads(places, faces.size());
  const auto place_of = [&](const face& f) {
    const point &a = nodes[f.v[0]].position, &b = nodes[f.v[1]].position,
                &c = nodes[f.v[2]].position;
    return place_on_curve({(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3}, box);
  };
  parallel_chunks(faces.size(), faces_placed_at_once,
                  [&](std::size_t, std::size_t begin, std::size_t end) {
                    for (std::size_t t = begin; t < end; ++t) {
                      if (t + triangles_ahead < end && faces[t + triangles_ahead].exists())
                        for (const vertex_index v : faces[t + triangles_ahead].v)
                          prefetch(&nodes[v].position);
                      places[t] = faces[t].exists() ? place_of(faces[t]) : nowhere;
                    }
                  });
  return places;
}

}  // namespace

curve_parts::curve_parts(const std::vector<node>& nodes, const std::vector<face>& faces,
                         const bounding_box& box, std::size_t parts)
    : box_(box), part_(faces.size(), 0) {
  if (parts <= 1) {
    for (std::size_t t = 0; t < faces.size(); ++t)
      if (!faces[t].exists()) part_[t] = 1;
    return;
  }
  const std::vector<std::uint64_t> places = places_of(nodes, faces, box);
  divide_curve(places, parts);
  // Tries the part of the face before first, which is nearly always the part of the next one, too.
  parallel_chunks(places.size(), faces_placed_at_once,
                  [&](std::size_t, std::size_t begin, std::size_t end) {
                    std::uint32_t last = 0;
                    for (std::size_t t = begin; t < end; ++t) {
                      if (places[t] == nowhere)
                        part_[t] = static_cast<std::uint32_t>(count());
                      else
                        part_[t] = last = is_in(places[t], last) ? last : at(places[t]);
                    }
                  });
}

// Finds the bounds between parts: quantiles of the places of a sample.
void curve_parts::divide_curve(const std::vector<std::uint64_t>& places, std::size_t parts) {
  constexpr std::size_t sampled = 16;  // one face in this number
  std::vector<std::uint64_t> sample;
  sample.reserve(places.size() / sampled + 1);
  for (std::size_t t = 0; t < places.size(); t += sampled)
    if (places[t] != nowhere) sample.push_back(places[t]);
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
