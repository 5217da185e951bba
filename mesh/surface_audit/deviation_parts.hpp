// SPDX-License-Identifier: MIT
//
// Declares the two directions of a deviation, and the proofs of their witnesses.
#pragma once

#include <optional>
#include <vector>

#include "asterism/mesh/surface_audit/box_tree.hpp"
#include "asterism/mesh/surface_audit/deviation_report.hpp"
#include "asterism/mesh/surface_audit/hull_bounds.hpp"
#include "asterism/mesh/surface_audit/narrowing.hpp"
#include "asterism/mesh/surface_audit/surface_locator.hpp"
#include "asterism/mesh/surface_audit/triangle_distance.hpp"

namespace asterism::internal {

// What both directions look at. All must outlive it.
struct deviation_scene {
  const space_mesh& mesh;
  const surface& of;
  const std::vector<bezier_piece>& pieces;
  const box_tree& triangles;
  const surface_locator& locator;
  // A place of the surface near the middle of each triangle, where one is known; else null.
  const std::vector<surface_place>* places = nullptr;

  plain_triangle triangle(std::size_t t) const {
    const space_triangle& c = mesh.triangles[t];
    return {mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]]};
  }
};

std::vector<space_box> boxes_of_triangles(const space_mesh& mesh);

// About the nearest triangle to a point, in doubles; `hint` is a triangle to begin with.
struct nearest_triangle {
  std::uint32_t triangle = 0;
  double squared_distance = 0;
};
nearest_triangle nearest_triangle_to(const deviation_scene& scene, const plain_vector& p,
                                     std::uint32_t hint);

// Returns two triangles of the mesh as a pair if two of their corners are at the same points.
std::optional<two_triangles> joined_triangles(const deviation_scene& scene, std::uint32_t a,
                                              std::uint32_t b);

one_sided_distance from_mesh(const deviation_scene& scene, const narrowing_limits& limits);
// An upper bound of the distance of the points of one triangle from the surface.
double distance_of_triangle(const deviation_scene& scene, std::uint32_t triangle,
                            const narrowing_limits& limits);
one_sided_distance from_surface(const deviation_scene& scene, const narrowing_limits& limits);

// Returns a distance, `proposed` or little less, that the point of the mesh provably has from all
// of the surface, else 0.
double proved_distance_of_mesh_point(const deviation_scene& scene, const deviation_witness& at,
                                     double proposed);
// The same for a point of the surface and all of the mesh. Exact where intervals do not decide and
// the patch is a Bezier patch, whose control points are doubles.
double proved_distance_of_surface_point(const deviation_scene& scene, const surface_place& at,
                                        double proposed);

}  // namespace asterism::internal
