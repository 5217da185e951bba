// SPDX-License-Identifier: MIT
//
// Halves a net of control points by de Casteljau's algorithm, in intervals.
#pragma once

#include <array>
#include <vector>

#include "asterism/mesh/surface_audit/bezier_pieces.hpp"

namespace asterism::internal {

using control_net = std::vector<weighted_point>;

// Returns the nets over the lower and the upper half of s, or of t. `row` is the number of points
// of a row of the piece.
std::array<control_net, 2> halved(const control_net& net, std::size_t row, bool by_s);

// True if the net is longer along s than along t, between the ends of its rows and columns; in
// doubles.
bool is_longer_by_s(const control_net& net, std::size_t row);

}  // namespace asterism::internal
