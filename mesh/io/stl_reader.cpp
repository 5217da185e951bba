// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/mesh/io/listed_readers.hpp"
#include "asterism/mesh/io/stl_facets.hpp"

namespace asterism::internal {
namespace {

using failure = std::optional<error>;

// True if one corner has the same place in the plane as the other.
bool is_above(const stl_corner& a, const stl_corner& b) { return a.x == b.x && a.y == b.y; }

// Makes corners at one place one vertex, numbered in the order in which they first occur.
failure join_corners(const std::vector<stl_corner>& corners, listed_mesh& made) {
  mesh& m = made.content;
  std::vector<std::size_t> order(corners.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto before = [&](std::size_t i, std::size_t j) {
    const stl_corner &p = corners[i], &q = corners[j];
    return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : i < j;
  };
  std::sort(order.begin(), order.end(), before);
  std::vector<std::size_t> first(corners.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    first[order[k]] = k > 0 && is_above(corners[order[k]], corners[order[k - 1]])
                          ? first[order[k - 1]]
                          : order[k];
  const double extent = corners[order.back()].x - corners[order.front()].x;
  std::vector<vertex_index> number(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const stl_corner& c = corners[i];
    if (first[i] == i) {
      number[i] = static_cast<vertex_index>(m.sites.size());
      m.sites.push_back({{c.x, c.y}, {1, 0, 1}});
    }
    number[i] = number[first[i]];
    if (first[i] == i && c.z != 0) made.heights.push_back({number[i], c.line, c.z});
    // Accepts corners at one vertex whose heights differ by rounding: put_in_order judges them.
    if (!(std::abs(c.z - corners[first[i]].z) <= rounding_of_heights * extent))
      return text_scanner(made.file, "")
          .failure(c.line,
                   "two corners are above each other: only plane meshes can be "
                   "read, parallel to x and y");
  }
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
    m.triangles.push_back({number[i], number[i + 1], number[i + 2]});
  return {};
}

}  // namespace

result<listed_mesh> read_stl(std::string_view text, const std::string& file) {
  auto facets = read_stl_facets(text, file);
  if (!facets) return facets.failure();
  listed_mesh made;
  made.file = file;
  made.names.regions = std::move(facets.value().names);
  if (auto failed = join_corners(facets.value().corners, made)) return std::move(*failed);
  std::vector<int>& solids = facets.value().solids;
  if (!solids.empty() && solids.back() > 1) made.content.regions = std::move(solids);
  if (auto failed = put_in_order(made, listed_order::put_right)) return std::move(*failed);
  return made;
}

}  // namespace asterism::internal
