// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/plain_form.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/mesh/domain/face_map.hpp"
#include "asterism/mesh/domain/planar_graph.hpp"
#include "asterism/mesh/domain/point_beside.hpp"

namespace asterism::internal {
namespace {

// A side of a segment with a known face, and the region of that face.
struct known_side {
  std::size_t segment = 0;
  bool to_left = true;
  std::optional<int> region;  // none: outside of the domain
};

// Faces without a hole or region point, each as the sides of the segments around it.
class faces_without_point {
 public:
  explicit faces_without_point(const domain& d) : edges_(edges_of(d)), faces_(d.vertices, edges_) {
    for (std::size_t i = 0; i < d.segments.size(); ++i) {
      const segment& s = d.segments[i];
      add(2 * i, {i, true, s.left_region});
      add(2 * i + 1, {i, false, s.internal ? std::optional<int>(s.right_region) : std::nullopt});
    }
    std::vector<point> named = d.holes;
    for (const region_point& r : d.regions) named.push_back(r.at);
    for (const std::size_t face : faces_.faces_around(named))
      if (face < sides_.size()) sides_[face].clear();
  }

  // Returns the sides of each face that needs a point: of each except those of the region
  // `unnamed`, the number of parts without a point.
  std::vector<std::vector<known_side>> to_be_named(int unnamed) const {
    std::vector<std::vector<known_side>> all;
    for (const auto& face : sides_)
      if (!face.empty() && face.front().region != unnamed) all.push_back(face);
    return all;
  }

 private:
  static std::vector<covered_edge> edges_of(const domain& d) {
    std::vector<covered_edge> edges;
    for (const segment& s : d.segments) edges.push_back({s.a, s.b, edges.size(), s.marker});
    return edges;
  }
  void add(std::size_t half, const known_side& side) {
    const std::size_t face = faces_.left_of(half);
    if (face == face_map::outside) return;
    if (face >= sides_.size()) sides_.resize(face + 1);
    sides_[face].push_back(side);
  }

  std::vector<covered_edge> edges_;
  face_map faces_;
  std::vector<std::vector<known_side>> sides_;
};

std::optional<point> point_in_face(const domain& d, const std::vector<known_side>& sides) {
  for (const known_side& side : sides)
    if (const auto found = point_beside(d, side.segment, side.to_left)) return found;
  return std::nullopt;
}

// Returns the region number of parts without a region point: 1 where all parts have it, else 0.
int number_without_point(const domain& d) {
  const bool has_one =
      d.regions.empty() && std::none_of(d.segments.begin(), d.segments.end(), [](const segment& s) {
        return s.left_region != 1 || (s.internal && s.right_region != 1);
      });
  return has_one ? 1 : 0;
}

}  // namespace

result<domain> plain_form(domain accepted) {
  domain plain = std::move(accepted);
  plain.polygons.clear();
  const auto unnamed = faces_without_point(plain).to_be_named(number_without_point(plain));
  constexpr double most_work = 1e10;  // orientation tests: minutes
  if (static_cast<double>(unnamed.size()) * static_cast<double>(plain.segments.size()) > most_work)
    return error{plain.name + ": there are so many faces that no point is looked for in each",
                 error_code::invalid_domain};
  for (const auto& face : unnamed) {
    const auto inside = point_in_face(plain, face);
    if (!inside)
      return error{plain.name + ": no point was found in a face that one is to tell of",
                   error_code::invalid_domain};
    if (face.front().region)
      plain.regions.push_back({*inside, *face.front().region});
    else
      plain.holes.push_back(*inside);
  }
  return plain;
}

}  // namespace asterism::internal
