// SPDX-License-Identifier: MIT
//
// Proves the claims of a surface's mesh, from the surface, the plane meshes and the shell alone.
//
// A certified shell is proven to
//  1. have a certified plane mesh of each patch's whole square of parameters (audit/audit.hpp);
//  2. be within D: every point of the surface within D of the mesh and of the mesh within D of the
//     surface;
//  3. be nowhere folded: (r_u x r_v).n_T > 0 on each triangle's whole piece; at a side of a patch
//     that is one point, where r_u x r_v is zero, its limit direction is tested instead;
//  4. have the greatest normal deviation that is given, or less;
//  5. have its vertices on the surface up to the rounding that is given;
//  6. have every edge once each way, but those of open sides, which are counted; vertices that are
//     shared are one vertex;
//  7. if that is asked: have no two triangles that cross or touch except in common vertices and
//     edges.
// docs/math/surfaces.md has the proofs. Angles in space are reported, not certified.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/surface.hpp"
#include "asterism/mesh/data/surface_shell.hpp"
#include "asterism/mesh/surface_audit/shell_report.hpp"

namespace asterism::internal {

// Audits a shell. Fails if the surface is refused, or an index or a number of the shell is out of
// range.
result<shell_report> audit_shell(const surface& s, const surface_shell& shell,
                                 const shell_question& asked);

// Measures for the maker of a shell, made only for the `wanted` plane triangles, numbered face by
// face. `distance` is an upper bound of the distances between a triangle in space and its piece of
// the surface, either no more than 5 % above the distance of some point or below `enough`.
// `is_unfolded` states whether the surface is not folded over the triangle, by tests in doubles at
// a few places. `fold` is a place, u and v of the patch, where the surface itself is folded: no
// finer mesh unfolds it.
struct shell_measure {
  double distance = 0;
  bool is_unfolded = false;
  std::optional<std::array<double, 2>> fold = {};
};
result<std::vector<shell_measure>> shell_measures(const surface& s, const surface_shell& shell,
                                                  double enough,
                                                  const std::vector<unsigned char>& wanted);

}  // namespace asterism::internal
