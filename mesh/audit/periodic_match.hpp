// SPDX-License-Identifier: MIT
//
// Proves that two sides of the boundary of a mesh have the same points, as periodic boundary
// conditions require, from the mesh alone, with no code of the mesher.
//
// The sides are the boundary edges with one marker each. Each is a line with two ends. As the
// domain is on the left of both, the first side from its start to its end goes with the second from
// its end to its start.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/core/site.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism {

// Markers of two sides that are to have the same points.
struct periodic_pair {
  int first = 0, second = 0;

  friend bool operator==(const periodic_pair&, const periodic_pair&) = default;
};

// Kinds of maps that take the first side's vertices to the second side's.
enum class periodic_kind : std::size_t {
  translated,  // shifted by a vector of two doubles, exactly
  turned,      // by a quarter, a half or three quarters, then shifted, exactly
  matched      // one after the other, at the same parts of the lengths: equal but for rounding
};

// Names of the kinds of maps as certificates spell them, in order.
ASTERISM_EXPORT extern const std::array<std::string_view, 3> periodic_kind_names;

// Two sides that match, and the map between them.
struct periodic_match {
  periodic_pair sides;
  periodic_kind kind = periodic_kind::matched;
  // Takes the first side to the second: a turn to the left about the origin, in degrees, then a
  // shift. Exact unless the kind is `matched`.
  double turn = 0;
  point shift;
  std::size_t vertices = 0;  // of each side, both ends included
  // Upper bound of the distance of a vertex from the image of its partner, in units of the domain;
  // 0 where the map is exact.
  double greatest_offset = 0;
  // Logarithm of the greatest ratio of a displacement's lengths in the tensors of two partners,
  // after the map's turn; in floating point. 0 where all partners have the same tensor.
  double metrics_apart = 0;

  friend bool operator==(const periodic_match& a, const periodic_match& b) {
    return a.sides == b.sides && a.kind == b.kind && a.turn == b.turn && a.shift == b.shift &&
           a.vertices == b.vertices && a.greatest_offset == b.greatest_offset &&
           a.metrics_apart == b.metrics_apart;
  }
};

// Largest distance of a vertex from its partner's image, as a part of the side's length: files with
// six digits are as coarse. Sides farther apart are refused as different in shape; a smaller
// distance is reported.
inline constexpr double largest_periodic_offset = 1e-5;

// Finds the map between two sides. Fails, with a sentence that names both markers, unless each
// vertex of the first has exactly one partner on the second, in the same order.
ASTERISM_EXPORT result<periodic_match> match_periodic(const mesh& subject,
                                                      const periodic_pair& sides);

// Returns a sentence such as "4 and 2: translated exactly by (1, 0), 12 vertices each, with the
// same metric".
ASTERISM_EXPORT std::string text_of(const periodic_match& match);

}  // namespace asterism
