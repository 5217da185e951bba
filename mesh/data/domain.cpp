// SPDX-License-Identifier: MIT
#include "asterism/mesh/data/domain.hpp"

namespace asterism {

bounding_box domain::box() const {
  if (vertices.empty()) return {};
  bounding_box b{vertices.front(), vertices.front()};
  for (const point& p : vertices) b.include(p);
  return b;
}

}  // namespace asterism
