// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface/unit_patches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "asterism/mesh/surface_audit/bezier_pieces.hpp"

namespace asterism::internal {
namespace {

void take_unit_knots(std::vector<double>& knots, std::size_t count, const std::string& direction,
                     std::vector<std::string>& notes) {
  if (knots.size() != 2 * count) return;  // none: 0 to 1 already
  const double low = knots.front(), high = knots.back();
  if (low == 0 && high == 1) return;
  std::fill_n(knots.begin(), count, 0.0);
  std::fill(knots.begin() + static_cast<std::ptrdiff_t>(count), knots.end(), 1.0);
  notes.push_back(
      fmt::format("{}, from {:g} to {:g} without knots between, is taken from 0 to 1: the points "
                  "are the same",
                  direction, low, high));
}

}  // namespace

surface with_unit_patches(surface s) {
  if (!bezier_pieces(s)) return s;
  for (std::size_t k = 0; k < s.patches.size(); ++k) {
    surface_patch& p = s.patches[k];
    if (!p.loops.empty()) continue;  // loops are in units of the parameters
    take_unit_knots(p.knots_u, p.count_u, fmt::format("patch {}: u", k + 1), s.notes);
    take_unit_knots(p.knots_v, p.count_v, fmt::format("patch {}: v", k + 1), s.notes);
  }
  return s;
}

}  // namespace asterism::internal
