// SPDX-License-Identifier: MIT
//
// Finds, before a mesh is made, the reasons why no guarantee can be given (docs/math/guarantee.md):
// corners that bring sites together whatever the size, and fields that jump.
#pragma once

#include <optional>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/data/options.hpp"

namespace asterism::internal {

// Least angle between segments at a vertex, in degrees, in the vertex's own metric. The first sites
// on the two segments are then apart by at least 2 sin(18 degrees) = 0.618 of the shorter of their
// distances from the vertex. With the lengths of guaranteed_mesh.cpp the covering radius is below
// 1.3 times that; up to 1.35 times the theorem proves 20.25 degrees at small variation.
inline constexpr double least_guaranteed_corner = 36;
// Least angle, in degrees, with which segments are divided into parts as long as the covering
// radius: the first sites on two of them are then apart by at least 2 sin(27.5 degrees) = 0.923 of
// that radius.
inline constexpr double least_plain_corner = 55;
// Greatest angle bound, in degrees. At small variation the theorem proves 26.75 up to the ratio 1.1
// of the covering radius to the spacing; 20 up to a variation of 0.04.
inline constexpr double greatest_guaranteed_bound = 20;

// Rates at which a field varies: the greatest one sampled, and an upper bound where one is known;
// and the narrowest corner of the domain in the field's metric.
struct field_steepness {
  double sampled = 0;
  std::optional<double> bound = {};
  double narrowest_corner = 360;  // degrees between two segments at a vertex, in its metric
};

// Returns the first hypothesis that fails, by name, with vertex and angle or with the place; those
// on options come first. Sets `steepness` to the rates found of the field. Fails where the field
// does.
std::optional<error> refused_guarantee(const domain& d, const metric_field& field,
                                       const mesh_options& options, field_steepness& steepness);

}  // namespace asterism::internal
