// SPDX-License-Identifier: MIT
//
// Measures the defect of a node at several places: how far angles of its faces are below an aim in
// the wanted tensors, and by how much the node is too near to the Voronoi vertices of the faces
// across from it. Values that do not depend on the place are collected once. Internal to
// mesh/adapt.
#pragma once

#include <cstddef>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/adapt/local_tests.hpp"

namespace asterism::internal::adapting {

// The wanted tensor of a node.
struct wanted_tensor {
  metric_tensor metric;
  double root = 0;  // of its determinant
};

class ring_defect {
 public:
  // Takes the cotangent of the least angle without defect.
  explicit ring_defect(double cotangent) : cotangent_(cotangent) {}

  // Begins with a node of no faces.
  void clear();
  // Adds a neighbour, counter-clockwise: one face lies between each two in a row. The first one is
  // added again at the end where the faces close.
  void add_neighbour(const point& at, const wanted_tensor& wanted);
  // Adds the Voronoi vertex of a face across from the node.
  void add_centre(const face_centre& c) { centres_.push_back(c); }

  // Returns the defect of the faces in the wanted tensors of the neighbours, with the node at this
  // place. Ends once the sum reaches `most`.
  double of_others(const point& at, double most);
  // Returns the defect of the faces in the wanted tensor of the node, plus that of the faces across
  // towards it, at the place of the last call of of_others(), which must not have ended early. Ends
  // once the sum reaches `most`.
  double of_own(const wanted_tensor& wanted, double most) const;

 private:
  // Squares and product of the two coordinates of a vector, or products of those of two; the
  // product of different coordinates is doubled.
  struct products {
    double xx, xy, yy;
  };
  // A neighbour, and its displacement from the node at the place that is tried.
  struct spoke {
    point at;
    wanted_tensor wanted;
    point from_node;
    products squares;
    double own_squared;  // length in its wanted tensor
  };
  // Determines the angles of the face between two spokes: products of their coordinates, and twice
  // its area.
  struct face_products {
    products inner;
    double twice;
  };

  static double measured(const metric_tensor& m, const products& p) {
    return m.m11 * p.xx + m.m12 * p.xy + m.m22 * p.yy;
  }
  static void measure_from(const point& at, spoke& s);
  static face_products between(const spoke& p, const spoke& q);
  double of_angles(double uu, double ww, double uw, double area) const;

  double cotangent_;
  point place_;
  std::vector<spoke> spokes_;
  std::vector<face_centre> centres_;
};

}  // namespace asterism::internal::adapting
