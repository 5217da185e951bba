// SPDX-License-Identifier: MIT
//
// Measures the defect of a node at several places: how far angles of its faces are below an aim in
// the wanted tensors, and by how much the node is too near to the Voronoi vertices of the faces
// across from it. Values that do not depend on the place are collected once, in arrays, for loops
// over all faces without branches. Internal to mesh/adapt.
#pragma once

#include <array>
#include <cstddef>

#include "asterism/core/site.hpp"
#include "asterism/mesh/adapt/local_tests.hpp"
#include "asterism/mesh/adapt/node_ring.hpp"

namespace asterism::internal::adapting {

// The wanted tensor of a node.
struct wanted_tensor {
  metric_tensor metric;
  double root = 0;  // of its determinant
};

class ring_defect {
 public:
  // Largest number of faces around a node.
  static constexpr std::size_t most_faces = node_ring::most_faces;

  // Takes the cotangent of the least angle without defect.
  explicit ring_defect(double cotangent) : cotangent_(cotangent) {}

  // Begins with a node of no faces.
  void clear() { neighbours_ = centres_ = 0; }
  // Adds a neighbour, counter-clockwise: one face lies between each two in a row. The first one is
  // added again at the end where the faces close. Requires room for one more face.
  void add_neighbour(const point& at, const wanted_tensor& wanted);
  // Adds the Voronoi vertex of the face across from the node. Called once for each face around it
  // at most.
  void add_centre(const face_centre& c);

  // Returns the defect of the faces in the wanted tensors of the neighbours, with the node at this
  // place. Ends once the sum reaches `most`.
  double of_others(const point& at, double most);
  // Returns the defect of the faces in the wanted tensor of the node, plus that of the faces across
  // towards it, at the place of the last call of of_others(). Ends once the sum reaches `most`.
  double of_own(const wanted_tensor& wanted, double most);

 private:
  // One value for each neighbour, or for the face from a neighbour to the next one. Padded to an
  // even number of faces.
  using values = std::array<double, most_faces + 2>;
  // Values of each face in one tensor: its greatest cotangent times its doubled area, its doubled
  // area, and a lower bound, where positive, of how far that product is below the aim's.
  struct cotangents {
    values greatest, area, below;
  };

  void put(std::size_t k, const point& at, const wanted_tensor& wanted);
  void measure_from(point place);
  std::size_t faces() const { return neighbours_ == 0 ? 0 : neighbours_ - 1; }
  double of_angles(const cotangents& c, std::size_t k) const;
  double of_centres(metric_tensor m, double most, double sum);

  double cotangent_;
  point place_;
  std::size_t neighbours_ = 0, centres_ = 0;
  values x_, y_, m11_, m12_, m22_, root_;  // of the neighbours, with their wanted tensors
  // Displacements of the neighbours from the place, their squares, the doubled product of their
  // coordinates, and their squared lengths in the wanted tensors.
  values to_x_, to_y_, xx_, xy_, yy_, own_;
  // Products of the displacements at both ends of a face, and twice the face's area.
  values inner_xx_, inner_xy_, inner_yy_, twice_;
  cotangents by_first_, by_second_, by_node_;
  // Voronoi vertices of the faces across, their squared radii, the squared distances from which
  // they are far enough, and their squared distances from the node.
  values centre_x_, centre_y_, squared_radius_, far_, distance_;
};

}  // namespace asterism::internal::adapting
