// SPDX-License-Identifier: MIT
//
// Computes the energies of all faces around one node, which may be tried at several places. The
// values of the other nodes are gathered once, in arrays, for loops over all faces without
// branches. Internal to mesh/adapt.
#pragma once

#include <array>
#include <cstddef>

#include "asterism/mesh/adapt/editable_mesh.hpp"

namespace asterism::internal::adapting {

class node_ring {
 public:
  // Largest number of faces. Unit meshes have six around most nodes, and rarely more than twelve.
  static constexpr std::size_t most_faces = 32;

  struct energies {
    // Energies of the faces, of their shapes alone and with their sizes. Only those of existing
    // faces are set.
    std::array<double, most_faces> shape, whole;
    double sum = 0;  // of the whole ones
  };

  // Gathers the values of the nodes around v, whose faces are `at`. Returns false, and gathers
  // nothing, where there are too many.
  bool gather(const editable_mesh& m, vertex_index v, const face_list& at);
  // Computes the energies of the faces with this node in place of v: those of shape_energy() except
  // for rounding.
  void measure(const node& v, double unit, energies& out) const;
  // Returns the weighted mean of the places for v that are best for its faces: for each, the apex
  // of an equilateral triangle on the edge across from v. Poor triangles have more weight.
  point best_place(double unit, const energies& now) const;

 private:
  // Values of the nodes around v, counter-clockwise: face k has the nodes k and k + 1. Padded to
  // an even number of faces.
  using values = std::array<double, most_faces + 2>;

  std::size_t faces_ = 0, padded_ = 0;
  values x_, y_, root_;
  values m11_, m12_, m22_;  // tensors
  values n11_, n12_, n22_;  // of determinant 1, scaled by the energy's factor
};

}  // namespace asterism::internal::adapting
