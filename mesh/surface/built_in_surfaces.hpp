// SPDX-License-Identifier: MIT
//
// Makes built-in surfaces by name. Numbers that are no doubles, as of circles, are rounded: the
// surface is exactly that of the rounded control points.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "asterism/mesh/data/surface.hpp"

namespace asterism::internal {

// Returns the surface of this name. torus: a quarter of a torus of radii 1 and 0.3, its tube open
// by a fiftieth at the hole. octant: an eighth of the unit sphere; one side is the pole. saddle: z
// = (x^2 - y^2) / 2 over [-1, 1]^2. teapot: Newell's 32 patches, as the Utah teapot is known; open
// where it always was. wing: the upper side of a tapered, swept and twisted wing with the section
// NACA 0012.
std::optional<surface> built_in_surface(std::string_view name);

std::vector<std::string> built_in_surface_names();

}  // namespace asterism::internal
