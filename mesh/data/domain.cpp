// SPDX-License-Identifier: MIT
#include "asterism/mesh/data/domain.hpp"

#include <algorithm>

namespace asterism {

bounding_box domain::box() const {
  if (vertices.empty()) return {};
  bounding_box b{vertices.front(), vertices.front()};
  for (const point& p : vertices) {
    b.low = {std::min(b.low.x, p.x), std::min(b.low.y, p.y)};
    b.high = {std::max(b.high.x, p.x), std::max(b.high.y, p.y)};
  }
  return b;
}

}  // namespace asterism
