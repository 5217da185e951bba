// SPDX-License-Identifier: MIT
//
// Encloses how far a triangle mesh is from a surface, and the surface from the mesh: the greatest
// distance of a point of the one from the other, each way. Upper bounds hold by the hulls of
// control points, lower bounds by a witness: a point whose distance from all of the other is
// bounded from below. Numbers are those of the surface's files; docs/math/surfaces.md has the
// proofs.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/space_mesh.hpp"
#include "asterism/mesh/data/surface.hpp"
#include "asterism/mesh/surface_audit/bezier_pieces.hpp"

namespace asterism::internal {

struct deviation_options {
  double relative_width = 0.01;   // of an enclosure, at most, unless work ends before
  std::optional<double> at_most;  // a distance to decide about: enclosures are made to exclude it
  // Bounds the work: at most so many cells for each triangle, and so many more in all, are looked
  // at in each of the two directions (surface to mesh, mesh to surface).
  std::size_t cells_of_a_triangle = 200, cells_beside = 2'000'000;
};

// A point of the mesh: corner weights 1 - s - t, s and t in a triangle; or of the surface: the
// patch and its parameters. Indices from 0.
struct deviation_witness {
  bool on_mesh = true;
  std::size_t of = 0;  // triangle or patch
  double first = 0, second = 0;
  space_point at;  // rounded
};

// One direction. `low` is the distance that the witness is proved to have at least; 0 needs none.
struct one_sided_distance {
  double low = 0, high = 0;
  deviation_witness witness;
  bool narrowed = false;  // as far as asked for
  std::size_t cells = 0;
};

struct deviation_report {
  one_sided_distance from_mesh;     // the greatest distance of a point of the mesh from the surface
  one_sided_distance from_surface;  // and of a point of the surface from the mesh
};

// Fails for a mesh without triangles, or with a point that is not finite or beyond 2^300, or an
// index out of range; and where bezier_pieces does.
result<deviation_report> deviation(const space_mesh& mesh, const surface& s,
                                   const deviation_options& options = {});

}  // namespace asterism::internal
