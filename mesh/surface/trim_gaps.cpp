// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface/trim_gaps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "asterism/mesh/io/text_scanner.hpp"
#include "asterism/mesh/surface_audit/trim_distance.hpp"

namespace asterism::internal {

std::optional<error> fault_of_gaps(const side_graph& graph, const std::vector<face_border>& borders,
                                   const std::vector<bezier_piece>& pieces,
                                   const std::vector<patch_spans>& spans, double chord) {
  constexpr double enough = 0.1;  // of the distance asked
  for (const side_curve& c : graph.curves) {
    if (!c.is_trim || c.is_point || c.sides.size() < 2) continue;
    const auto on = [&](const patch_side& side) {
      return curve_on_patch{pieces, spans[side.patch],
                            borders[side.patch].curve(static_cast<std::size_t>(side.side))};
    };
    const double gap = trim_gap_above(on(c.sides[0]), on(c.sides[1]),
                                      c.sides[0].backward != c.sides[1].backward, enough * chord);
    if (gap <= chord) continue;
    return error{fmt::format("patches {} and {}: the two curves of edge \"{}\" are up to {:.6g} "
                             "from each other, and {:.6g} is asked of the mesh; ask for more than "
                             "the gap, or close it",
                             std::min(c.sides[0].patch, c.sides[1].patch) + 1,
                             std::max(c.sides[0].patch, c.sides[1].patch) + 1,
                             without_controls(on(c.sides[0]).curve.edge), gap, chord),
                 error_code::invalid_input};
  }
  return {};
}

}  // namespace asterism::internal
