// SPDX-License-Identifier: MIT
//
// Tests, in doubles, whether the four sites around each edge agree about it, and whether angles
// meet the bound.
//
// An edge agrees if from the Voronoi vertex of either face beside it, to which the face's three
// sites are equally far, the site across the edge is farther. Other sites are not tested, so stars
// may still disagree; the auditor decides. Internal to mesh/adapt.
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "asterism/mesh/adapt/editable_mesh.hpp"

namespace asterism::internal::adapting {

// Least clearance with which an edge agrees, as a part of the squared radius: far above rounding
// errors, unless a face is nearly flat. It selects what is mended before the auditor, which is
// exact, decides.
inline constexpr double least_clearance = 1e-3;

// Clearance that an edge is to keep where tensors are restored or nodes moved. With a small one
// farther sites violate stars, which only the auditor detects; with a large one few tensors can be
// restored (docs/design/adaptation.md).
inline constexpr double clearance_kept = 0.15;

// Edge from a to b with c on its left, d on its right.
struct edge_quad {
  vertex_index a, b, c, d;
};

// Voronoi vertex of a face, and its squared distance from the face's sites; not positive where
// there is none.
struct face_centre {
  point at;
  double squared_radius = -1;
};

// Returns the clearance of a site from a face's Voronoi vertex: how much farther it is than the
// face's own sites, as a part of the squared radius; minus infinity where there is no Voronoi
// vertex.
inline double clearance(const face_centre& c, const node& d) {
  if (!(c.squared_radius > 0)) return -std::numeric_limits<double>::infinity();
  return squared(d.metric, c.at.x - d.position.x, c.at.y - d.position.y) / c.squared_radius - 1;
}

// Returns the greatest cotangent of the three angles in the metric; `root` is the root of the
// metric's determinant.
double greatest_cotangent(const metric_tensor& m, double root, const node& a, const node& b,
                          const node& c);
// Returns the cotangent of an angle in degrees. Angles below a thousandth of a degree count as a
// thousandth, so that the result is finite.
double cotangent_of(double degrees);

// Refers to the mesh, which must outlive it, and tests its present state.
class local_tests {
 public:
  local_tests(const editable_mesh& m, double angle_bound);

  // Returns edge i of face t with its four nodes. Requires a face beyond the edge.
  edge_quad quad_at(vertex_index t, std::size_t i) const;
  face_centre centre_of(vertex_index t) const;
  // Returns the Voronoi vertex of a face with these nodes, counter-clockwise, in the mesh or not.
  face_centre centre_of(const std::array<vertex_index, 3>& v) const;
  // Returns the lesser of the clearances that both faces of an edge have from the site across: a
  // part of the squared radius, minus infinity where a face has no Voronoi vertex.
  double worst_clearance(const edge_quad& q) const;
  // True if an angle of the face is below the bound in the metric of one of its nodes.
  bool is_low(vertex_index t) const;
  // True if the face is at a corner of the domain that is below the bound in the metric of its
  // vertex. False if that corner meets the bound in the Euclidean metric while the face has other
  // low angles: nothing exempts these, so the tensor at the corner must change.
  bool is_exempt(vertex_index t) const;

 private:
  bool has_low_angle_beside(vertex_index t, vertex_index v) const;

  const editable_mesh& m_;
  double angle_bound_, cotangent_;  // the latter of the least angle allowed
};

}  // namespace asterism::internal::adapting
