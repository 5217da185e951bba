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

// Least angle between segments at a vertex, in degrees, as its own metric measures it: the first
// sites on the two are at least 2 sin(27.5 degrees) = 0.923 of the shorter distance apart then.
inline constexpr double least_guaranteed_corner = 55;
// Greatest angle bound, in degrees. At small variation the theorem proves 26.75 up to the ratio 1.1
// of the covering radius to the spacing; 20 up to a variation of 0.04.
inline constexpr double greatest_guaranteed_bound = 20;

// Rates at which a field varies: the greatest sampled, and an upper bound where one is known.
struct field_steepness {
  double sampled = 0;
  std::optional<double> bound = {};
};

// Returns the first hypothesis that fails, by name, with vertex and angle or with the place; those
// on options come first. Sets `steepness` to the rates found of the field. Fails where the field
// does.
std::optional<error> refused_guarantee(const domain& d, const metric_field& field,
                                       const mesh_options& options, field_steepness& steepness);

}  // namespace asterism::internal
