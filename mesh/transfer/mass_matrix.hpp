// SPDX-License-Identifier: MIT
//
// Applies the mass matrix of linear elements, triangle by triangle, and solves with it.
//
// It is not assembled, and not handed to a library: with the diagonal as preconditioner its
// eigenvalues lie between 1/2 and 2 whatever the triangles (Wathen, "Realistic eigenvalue bounds
// for the Galerkin mass matrix", 1987). Conjugate gradients then lose a factor of (sqrt 4 + 1) /
// (sqrt 4 - 1) = 3 of the error with each step: 36 steps are enough for doubles, in parallel and
// with the same bits for any number of threads.
#pragma once

#include <vector>

#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/search/mesh_links.hpp"
#include "asterism/mesh/transfer/supermesh.hpp"

namespace asterism::internal {

class mass_matrix {
 public:
  mass_matrix(const mesh& m, const mesh_links& links, const std::vector<local_mass>& local);

  // Returns the sums of the rows: the integral of each hat function.
  const std::vector<double>& row_sums() const { return row_sums_; }
  std::vector<double> times(const std::vector<double>& x) const;
  // Returns the solution of M x = b, from a first guess. A constant is added in the end so that the
  // integral is that of b to rounding.
  std::vector<double> solve(const std::vector<double>& b, std::vector<double> x) const;

  // Returns the entry of a triangle's own matrix for two of its corners.
  double entry(vertex_index t, std::size_t i, std::size_t j) const {
    return i == j ? local_[t][i] : local_[t][3 + (3 - i - j)];
  }

 private:
  const mesh& mesh_;
  const mesh_links& links_;
  const std::vector<local_mass>& local_;
  std::vector<double> diagonal_, row_sums_;
};

}  // namespace asterism::internal
