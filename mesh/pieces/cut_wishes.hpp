// SPDX-License-Identifier: MIT
//
// Holds the options of a cut of a domain into pieces, and the numbers of these.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal {

using piece_index = std::uint32_t;  // from 0
inline constexpr piece_index no_piece = std::numeric_limits<piece_index>::max();

// Options of a cut.
struct cut_wishes {
  std::size_t pieces = 1;
  double angle_bound = 20;  // degrees: of the corners that cuts make, as their ends measure
  cancellation stop = {};
};

}  // namespace asterism::internal
