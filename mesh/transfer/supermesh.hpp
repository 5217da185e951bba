// SPDX-License-Identifier: MIT
//
// Integrates over the common parts of the triangles of two meshes: the supermesh.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/solution.hpp"
#include "asterism/mesh/search/mesh_links.hpp"
#include "asterism/mesh/transfer/locate.hpp"

namespace asterism::internal {

// Integrals of l_i l_j over a triangle of the new mesh, with l_i the hat functions of its corners:
// 00, 11, 22, 12, 20, 01.
using local_mass = std::array<double, 6>;

// Part of one old field in a new triangle: the integrals of the field times each hat function, and
// its least and greatest value there.
struct local_load {
  std::array<double, 3> of_corner{};
  double least = 0, greatest = 0;
};

struct supermesh {
  std::vector<local_mass> mass;               // of each new triangle
  std::vector<std::vector<local_load>> load;  // [field][new triangle]
  double common_area = 0;
  std::size_t partly_covered = 0;  // new triangles of which more than 1e-6 is outside the old mesh
  std::size_t pieces = 0;
};

// Clips every new triangle by the old ones that it meets: those at its corners, and those joined to
// them by edges that cross it. Outside the old mesh the field is replaced by the linear one with
// the values `at_vertices` at the triangle's corners ([field][new vertex]). Time is linear in the
// pieces; parallel, the same for any number of threads.
supermesh intersect_meshes(const mesh& from, const mesh_links& links,
                           const std::vector<nodal_values>& fields, const mesh& to,
                           const located_vertices& located,
                           const std::vector<std::vector<double>>& at_vertices);

}  // namespace asterism::internal
