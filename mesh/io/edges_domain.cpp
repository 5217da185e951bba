// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/edges_domain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/mesh/data/site_box.hpp"
#include "asterism/mesh/domain/point_beside.hpp"

namespace asterism::internal {
namespace {

// Returns how many parts of the plane segments enclose that meet in their ends alone: by Euler's
// formula, edges less vertices plus components.
std::size_t enclosed_parts(const domain& d) {
  std::vector<vertex_index> above(d.vertices.size());
  std::iota(above.begin(), above.end(), vertex_index{0});
  const auto root = [&above](vertex_index v) {
    while (above[v] != v) v = above[v] = above[above[v]];
    return v;
  };
  // Each segment that joins two components leaves one less; the others close a part each.
  std::size_t parts = 0;
  for (const segment& s : d.segments) {
    const vertex_index a = root(s.a), b = root(s.b);
    if (a == b)
      ++parts;
    else
      above[std::max(a, b)] = std::min(a, b);
  }
  return parts;
}

std::optional<error> number_parts(domain& d, const std::vector<side_of_edge>& parts) {
  const std::size_t enclosed = enclosed_parts(d);
  if (parts.size() != enclosed)
    return error{fmt::format("{}: sub-domains are given for {} of the {} parts that the edges "
                             "enclose: the others would be holes; give the domain as a .poly file "
                             "with hole points",
                             d.name, parts.size(), enclosed),
                 error_code::invalid_domain};
  constexpr double most_work = 1e9;
  if (static_cast<double>(parts.size()) * static_cast<double>(d.segments.size()) > most_work)
    return error{d.name +
                     ": so many sub-domains on so many edges cannot be found; give the domain "
                     "as a .poly file with region points",
                 error_code::invalid_domain};
  for (const side_of_edge& part : parts) {
    const auto inside = point_beside(d, part.edge, part.left);
    if (!inside)
      return error{fmt::format("{}: no point was found beside edge {}, which a sub-domain is "
                               "given by",
                               d.name, part.edge + 1),
                   error_code::invalid_domain};
    d.regions.push_back({*inside, part.region});
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
  if (file.parts.empty()) return d;
  if (auto failed = number_parts(d, file.parts)) return *failed;
  return d;
}

}  // namespace asterism::internal
