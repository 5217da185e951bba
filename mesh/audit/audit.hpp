// SPDX-License-Identifier: MIT
//
// Decides whether a mesh is what it claims to be: from the mesh alone, by exact arithmetic, with no
// code of the stars or the refinement that may have made it.
//
// A certified mesh is proven to
//  0. hold finite, distinct sites with positive definite metric tensors;
//  1. have only counter-clockwise triangles;
//  2. be a triangulation of the region its boundary encloses, every site a vertex, and, when the
//     domain is given, of that domain with its segments split, those inside it being edges with a
//     triangle on each side; and every triangle has the number of its region;
//  3. have no angle below the bound, at any corner, in the metric of any of the triangle's three
//     vertices, hence of any convex combination of them, except the angles at those corners of
//     the domain whose own angle is below the bound in the same metric;
//  4. have every triangle in the star of each of its vertices: each star is a fixed point of the
//     incremental insertion among the sites visible from its centre.
// If that is asked for, it is also proven or refused that the mesh
//  5. is the dual of the anisotropic Voronoi diagram of its sites, restricted to the domain, all of
//     whose arcs are wedged. A mesh can be certified without point 5.
// docs/math/certificate.md states and proves the grounds of each point, voronoi-certificate.md
// point 5.
//
// Input: any mesh, however damaged; indices out of range or numbers that are not finite are
// findings, never undefined behaviour. Cost: O(n log n) for points 0 to 3 but for long axis-aligned
// sides, where pairs of boundary boxes are compared; points 4 and 5 likewise where the metric is
// smooth at the scale of an edge, and O(n^2) at worst. Source: the thesis, definitions 2 to 6 and
// 9, theorem 4.
#pragma once

#include "asterism/core/export.h"
#include "asterism/mesh/audit/audit_report.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism {

// Audits a mesh, however damaged it is.
ASTERISM_EXPORT audit_report audit(const mesh& subject, const audit_options& options);

}  // namespace asterism
