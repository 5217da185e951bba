// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/clockwise_triangles.hpp"

#include <fmt/format.h>

#include <utility>

#include "asterism/kernels/filtered_kernel.hpp"

namespace asterism::internal {

void turn_over_clockwise(mesh& m, std::string_view place, std::size_t from) {
  std::size_t count = 0, first = 0;
  const filtered_kernel kernel;
  for (std::size_t t = 0; t < m.triangles.size(); ++t) {
    triangle& c = m.triangles[t];
    if (kernel.orientation(m.sites[c[0]].position, m.sites[c[1]].position,
                           m.sites[c[2]].position) != sign::negative)
      continue;
    std::swap(c[1], c[2]);
    if (count++ == 0) first = t;
  }
  if (count == 0) return;
  m.notes.push_back(
      count == m.triangles.size()
          ? fmt::format("the triangles are clockwise and turned over: {}", count)
          : fmt::format("{} of {} triangles are clockwise and turned over, the first: {} {}", count,
                        m.triangles.size(), place, first + from));
}

}  // namespace asterism::internal
