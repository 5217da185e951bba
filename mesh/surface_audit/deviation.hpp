// SPDX-License-Identifier: MIT
//
// Encloses how far a triangle mesh is from a surface, and the surface from the mesh: the greatest
// distance of a point of the mesh from the surface, and of a point of the surface from the mesh.
// Upper bounds hold by the hulls of control points, lower bounds by a witness: a point of one of
// them whose distance from the whole other one is bounded from below. Numbers are those of the
// surface's files; docs/math/surfaces.md has the proofs.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/space_mesh.hpp"
#include "asterism/mesh/data/surface.hpp"
#include "asterism/mesh/surface_audit/bezier_pieces.hpp"
#include "asterism/mesh/surface_audit/deviation_report.hpp"

namespace asterism::internal {

struct deviation_options {
  double relative_width = 0.01;   // of an enclosure, at most, unless work ends before
  std::optional<double> at_most;  // a distance to decide about: enclosures are made to exclude it
  // Bounds the work in each of the two directions (surface to mesh, mesh to surface): at most this
  // number of cells for each triangle, and `cells_beside` further ones in all.
  std::size_t cells_of_a_triangle = 200, cells_beside = 2'000'000;
};

// Bounds the deviation. Fails for a mesh without triangles, or with a point that is not finite or
// beyond 2^300, or an index out of range; and for surfaces for which bezier_pieces fails.
result<deviation_report> deviation(const space_mesh& mesh, const surface& s,
                                   const deviation_options& options = {});

}  // namespace asterism::internal
