// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/edges_domain.hpp"

#include <fmt/format.h>

#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "asterism/mesh/data/site_box.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/domain/face_map.hpp"
#include "asterism/mesh/domain/planar_graph.hpp"
#include "asterism/mesh/domain/point_beside.hpp"

namespace asterism::internal {
namespace {

error no_point(const domain& d, std::size_t edge) {
  return {fmt::format("{}: no point was found beside edge {}, which a sub-domain is given by",
                      d.name, edge + 1),
          error_code::invalid_domain};
}

// Puts a region point into each part that the file names, and a hole point into each other part.
std::optional<error> number_parts(domain& d, const std::vector<side_of_edge>& parts) {
  std::vector<covered_edge> edges;
  for (const segment& s : d.segments) edges.push_back({s.a, s.b, edges.size(), s.marker});
  const face_map faces(d.vertices, edges);
  std::set<std::size_t> known = {face_map::outside};
  constexpr double most_work = 1e9;
  const auto put = [&](const side_of_edge& part) -> std::optional<point> {
    known.insert(faces.left_of(2 * part.edge + (part.left ? 0 : 1)));
    if (static_cast<double>(known.size()) * static_cast<double>(edges.size()) > most_work)
      return std::nullopt;
    return point_beside(d, part.edge, part.left);
  };
  for (const side_of_edge& part : parts) {
    if (faces.left_of(2 * part.edge + (part.left ? 0 : 1)) == face_map::outside)
      return error{
          fmt::format("{}: the side of edge {} that a sub-domain is given by is outside of "
                      "all edges",
                      d.name, part.edge + 1),
          error_code::invalid_domain};
    const auto inside = put(part);
    if (!inside) return no_point(d, part.edge);
    d.regions.push_back({*inside, part.region});
  }
  for (std::size_t half = 0; half < 2 * edges.size(); ++half) {
    if (known.count(faces.left_of(half)) != 0) continue;
    const auto inside = put({half / 2, half % 2 == 0, 0});
    if (!inside) return no_point(d, half / 2);
    d.holes.push_back(*inside);
  }
  return std::nullopt;
}

}  // namespace

bool has_edges_alone(const mesh_file& file) {
  return file.content.triangles.empty() && file.content.disagreeing.empty() &&
         !file.content.boundary.empty();
}

result<domain> domain_of_edges(mesh_file file, const std::string& name) {
  domain d;
  d.name = name;
  d.origin.file = d.origin.vertex_file = name;
  d.origin.notes = std::move(file.content.notes);
  d.vertices = positions_of(file.content.sites);
  for (const boundary_edge& e : file.content.boundary) d.segments.push_back({e.a, e.b, e.marker});
  // Accepts any polygon: check_domain refuses invalid ones, and names the places.
  domain_repairs repairs;
  if (file.parts.empty() || !check_domain(d, &repairs)) return d;
  if (!repairs.messages.empty())
    return error{d.name + ": sub-domains are given by edges that are no domain's as they stand: " +
                     repairs.messages.front(),
                 error_code::invalid_domain};
  if (auto failed = number_parts(d, file.parts)) return *failed;
  return d;
}

}  // namespace asterism::internal
