// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface/size_limits.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "asterism/mesh/support/infinity.hpp"
#include "asterism/mesh/surface_audit/number_ranges.hpp"

namespace asterism::internal {

double least_chord(const surface& s) {
  space_point low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
  for (const surface_patch& patch : s.patches)
    for (const control_point& c : patch.control) {
      low = {std::min(low.x, c.at.x), std::min(low.y, c.at.y), std::min(low.z, c.at.z)};
      high = {std::max(high.x, c.at.x), std::max(high.y, c.at.y), std::max(high.z, c.at.z)};
    }
  const double modulus = std::max({-low.x, -low.y, -low.z, high.x, high.y, high.z});
  const double extent = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  return std::max(0x1p-52 * modulus, negligible_share * extent);
}

std::optional<error> fault_of_chord(const surface& s, double chord) {
  const double least = least_chord(s);
  if (chord >= least) return {};
  return error{fmt::format("the distance {:g} is below {:.3g}, the least that doubles can prove of "
                           "a surface of this extent: ask for a greater one",
                           chord, least),
               error_code::invalid_input};
}

std::optional<error> fault_of_count(double expected, std::size_t most, double chord) {
  if (expected <= static_cast<double>(most)) return {};
  return error{fmt::format("the sizes wanted take about {:.3g} vertices, and at most {} are made: "
                           "ask for a greater distance than {:g} (or edge, or angle), or for a "
                           "number of vertices",
                           expected, most, chord),
               error_code::invalid_input};
}

}  // namespace asterism::internal
