// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/clockwise_triangles.hpp"

#include <utility>

#include "asterism/kernels/filtered_kernel.hpp"

namespace asterism::internal {

turned_triangles turn_over_clockwise(mesh& m) {
  turned_triangles turned;
  const filtered_kernel kernel;
  for (std::size_t t = 0; t < m.triangles.size(); ++t) {
    triangle& c = m.triangles[t];
    if (kernel.orientation(m.sites[c[0]].position, m.sites[c[1]].position,
                           m.sites[c[2]].position) != sign::negative)
      continue;
    std::swap(c[1], c[2]);
    if (turned.count++ == 0) turned.first = t;
  }
  return turned;
}

}  // namespace asterism::internal
