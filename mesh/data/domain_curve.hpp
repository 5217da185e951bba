// SPDX-License-Identifier: MIT
//
// Holds a curved line of a domain: an arc of a circle or a cubic Bezier curve, and the
// vertices of the domain on it. The domain itself has segments between those vertices: it is a
// polygon, and the certificate says how far that is from the curve.
//
// Units: coordinates are the domain's.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "asterism/core/site.hpp"

namespace asterism {
// Kinds of curves that a domain can have.
enum class curve_kind { arc, cubic };

// A curve from its first vertex to its last. An arc whose first vertex is its last is a whole
// circle. Its radius is the distance of the first vertex from the centre. The outer control points
// of a cubic are its first and last vertex.
struct domain_curve {
  curve_kind kind = curve_kind::arc;
  point centre;                              // of an arc
  bool clockwise = false;                    // an arc
  std::array<point, 2> control = {};         // the inner control points of a cubic
  std::vector<std::uint32_t> vertices = {};  // at least two, in their order along the curve
  // Parameter of each vertex: increasing, from 0 to 1; the share of an arc's angle, or the
  // parameter of a cubic.
  std::vector<double> parameters = {};
  // Index of the segment between first and last vertex that the curve replaces when it is divided
  // (domain/divide_curves.hpp); without a meaning later.
  std::uint32_t segment = 0;
};

}  // namespace asterism
