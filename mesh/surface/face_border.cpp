// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface/face_border.hpp"

#include <algorithm>
#include <cmath>

namespace asterism::internal {

face_border::face_border(const surface_patch& patch, const surface_chart& chart)
    : chart_(&chart), trims_(trims_of(patch)) {}

std::array<std::size_t, 2> face_border::ends_of(std::size_t side) const {
  if (runs_around(side)) return {side, next(side)};
  return {next(side), side};
}

point face_border::corner(std::size_t k) const { return at(k, runs_around(k) ? 0 : 1); }

point face_border::at(std::size_t side, double place) const {
  const point low = chart_->low(), high = chart_->high();
  if (is_trimmed()) {
    const auto [u, v] = trim_at(curve(side), place);
    return chart_->in_patch({std::ldexp(u, chart_->scale_u()), std::ldexp(v, chart_->scale_v())});
  }
  const double x = low.x + place * (high.x - low.x), y = low.y + place * (high.y - low.y);
  const bool at_start = place == 0, at_end = place == 1;
  const double along_x = at_start ? low.x
                         : at_end ? high.x
                                  : x,
               along_y = at_start ? low.y
                         : at_end ? high.y
                                  : y;
  return side == 0   ? point{along_x, low.y}
         : side == 1 ? point{high.x, along_y}
         : side == 2 ? point{along_x, high.y}
                     : point{low.x, along_y};
}

std::size_t face_border::curves_in_loop(std::size_t side) const {
  std::size_t count = 1;
  for (std::size_t k = next(side); k != side; k = next(k)) ++count;
  return count;
}

}  // namespace asterism::internal
