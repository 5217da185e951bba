// SPDX-License-Identifier: MIT
//
// Recovers the second derivatives of a field from its values at the vertices of a mesh.
//
//   l2_projection  the gradients of the triangles at a vertex, averaged by area; then the same for
//                  the gradient's components (Clement's operator, twice; refine's default). Exact
//                  to rounding for linear fields, and for quadratic ones at vertices inside a patch
//                  that is its own image under a half turn, as in a grid.
//   green          the weak form: -sum |T| d_i u d_j phi / (sum |T| / 3), that is, the jumps of the
//                  gradient across the edges at a vertex. Exact to rounding for linear fields, and
//                  for quadratic ones in a grid whose diagonals are parallel. At the boundary:
//                  least_squares. The default.
//   least_squares  a quadratic fitted to two rings of neighbours, in coordinates in which their
//                  covariance is the identity: else thin patches are singular. Near neighbours have
//                  larger weights. Exact to rounding for linear and quadratic fields, everywhere.
//
// l2_projection averages over the widest patch: waves of a few edges are averaged out, so that an
// adaptation loop never resolves them. least_squares keeps them, but flattens a front that is as
// wide as an edge; green, which uses one ring alone, does not (docs/results/adaptation.md).
//
// At the boundary l2_projection takes the mean of the neighbours inside, as one-sided patches do
// not determine second derivatives; gradients there, which it needs, come from least_squares.
// Second differences that may be due to rounding of the values alone are set to zero.
// Neighbours are those by edges of the mesh, so no value is read across a gap.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/core/site.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism {

// Second derivatives of a field at the vertices of a mesh, of either sign, from another source.
struct nodal_hessian {
  std::string name;
  std::vector<metric_tensor> at;  // m11 = xx, m12 = xy, m22 = yy
};

// Methods of recovering second derivatives.
enum class hessian_method { l2_projection, green, least_squares };

// Second derivatives at the vertices of a mesh, as m11 = xx, m12 = xy, m22 = yy, of either sign.
struct recovered_hessian {
  std::vector<metric_tensor> at;
  std::size_t at_boundary = 0;      // vertices whose tensor is the mean of neighbours
  std::vector<vertex_index> means;  // these vertices
  std::size_t noise = 0;            // vertices with nothing but rounding: their tensor is zero
};

// Returns the Hessian of the field. Requires a triangulation. Fails if the numbers of values and of
// vertices differ, or a derivative overflows, naming the vertex. Linear in time and memory,
// parallel, the same for any number of threads.
ASTERISM_EXPORT result<recovered_hessian> recover_hessian(
    const mesh& m, const std::vector<double>& values,
    hessian_method method = hessian_method::green);

}  // namespace asterism
