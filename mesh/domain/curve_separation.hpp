// SPDX-License-Identifier: MIT
//
// Divides curves until nothing is between their pieces and the chords, or finds the curves with an
// obstacle between these.
#pragma once

#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/domain/curve_path.hpp"

namespace asterism::internal {

// Halves pieces of the curves, which start divided at `parameters`, until the hull of each has no
// point in common with that of another piece, with a straight segment or with a vertex on no
// segment, common ends left out. Returns the parameters after all halvings. Fails, naming both,
// where pieces of `finest_part` of their curve still meet something.
result<std::vector<std::vector<double>>> separate_curves(
    const domain& d, const std::vector<curve_path>& paths,
    std::vector<std::vector<double>> parameters, double finest_part);

// Returns a flag for each curve, undivided and going forward along its chord: whether its hull has
// a point in common with another one, a straight segment or a vertex on no segment, common ends
// left out.
std::vector<char> curves_in_contact(const domain& d, const std::vector<curve_path>& paths);

}  // namespace asterism::internal
