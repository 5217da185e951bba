// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/domain_values.hpp"

#include <cmath>
#include <cstddef>
#include <limits>

#include "asterism/mesh/domain/message_names.hpp"
#include "asterism/mesh/domain/point_algebra.hpp"

namespace asterism::internal {

std::optional<error> check_domain_values(const domain& d) {
  const domain_names names(d);
  if (d.vertices.size() > std::numeric_limits<vertex_index>::max() / 4)
    return error{names.at_start() + "more vertices than 32-bit numbers can name"};
  for (std::size_t v = 0; v < d.vertices.size(); ++v)
    if (!is_finite(d.vertices[v]))
      return error{names.at_vertex(v) + names.vertex(v) + " is not finite"};
  for (std::size_t s = 0; s < d.segments.size(); ++s)
    if (d.segments[s].a >= d.vertices.size() || d.segments[s].b >= d.vertices.size())
      return error{names.at_segment(s) + names.segment(s) + " uses a vertex that does not exist"};
  for (std::size_t p = 0; p < d.polygons.size(); ++p)
    for (std::size_t r = 0; r < d.polygons[p].rings.size(); ++r)
      for (const std::uint32_t s : d.polygons[p].rings[r])
        if (s >= d.segments.size())
          return error{names.at_start() + names.ring(p, r) + " has a segment that does not exist"};
  for (std::size_t h = 0; h < d.holes.size(); ++h)
    if (!is_finite(d.holes[h])) return error{names.at_hole(h) + names.hole(h) + " is not finite"};
  for (std::size_t r = 0; r < d.regions.size(); ++r)
    if (!is_finite(d.regions[r].at))
      return error{names.at_region(r) + names.region(r) + " is not finite"};
  if (d.segments.empty())
    return error{names.at_start() + "the domain is empty: it has no segments"};
  return {};
}

}  // namespace asterism::internal
