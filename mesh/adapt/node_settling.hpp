// SPDX-License-Identifier: MIT
//
// Moves one node to a place with better angles in the wanted metric. Internal to mesh/adapt.
#pragma once

#include <functional>
#include <vector>

#include "asterism/mesh/adapt/edges_around.hpp"
#include "asterism/mesh/adapt/editable_mesh.hpp"
#include "asterism/mesh/adapt/local_tests.hpp"
#include "asterism/mesh/adapt/node_ring.hpp"
#include "asterism/mesh/adapt/ring_defect.hpp"

namespace asterism::internal::adapting {

// A mesh whose nodes are moved, with what is known of its nodes and faces.
struct mesh_to_smooth {
  // Function that returns the metric wanted at a place; `hint` speeds up the next look-up near it
  // (background_metric.hpp).
  using wanted_at = std::function<metric_tensor(const point& q, vertex_index& hint)>;

  // The mesh must outlive the object.
  mesh_to_smooth(editable_mesh& mesh, double angle_bound, double unit_length, wanted_at field);
  // The centres refer to the tests.
  mesh_to_smooth(const mesh_to_smooth&) = delete;
  mesh_to_smooth& operator=(const mesh_to_smooth&) = delete;

  wanted_tensor look_up(const point& q, vertex_index& hint) const;

  editable_mesh& m;
  local_tests tests;
  present_centres present;
  double unit;  // wanted length of an edge
  wanted_at wanted_field;
  std::vector<wanted_tensor> wanted;  // of each node
  std::vector<char> is_awake;         // by node: whether something around it has changed
  std::vector<char> is_defect_free;   // by node, in the present mesh
};

// One thread's means of moving nodes. Reads only the faces that touch a neighbour of the node, and
// their nodes. Changes the node, the Voronoi vertices of these faces, the marks of the node and its
// neighbours, and clears is_defect_free of the nodes across, where it is set.
class node_settling {
 public:
  // The mesh must outlive the object. Takes the cotangent of the least angle without defect.
  node_settling(mesh_to_smooth& whole, double cotangent)
      : whole_(whole), m_(whole.m), edges_(m_, whole.tests, whole.present), ring_(cotangent) {}

  // True if the node has a defect in the present mesh. False where there are too many faces: such a
  // node stays.
  bool has_defect(vertex_index v);
  // Moves v to a better place, if one is found, and returns whether it was.
  bool settle(vertex_index v);

 private:
  // A place of a node with a smaller defect.
  struct place {
    point at;
    wanted_tensor wanted;
    vertex_index hint;
    double defect;
  };

  bool collect(vertex_index v);
  double present_defect(vertex_index v);
  double energy_of(const node& there);
  void find_better_places(vertex_index v, double step, double now, double energy_now);
  bool stretches_edge(vertex_index v, const point& here, const place& there) const;
  bool may_be_at(vertex_index v, const place& there);
  bool take_place(vertex_index v);
  void note_move(vertex_index v);

  mesh_to_smooth& whole_;
  editable_mesh& m_;
  edges_around edges_;
  ring_defect ring_;  // of the node at hand
  node_ring shapes_;  // of its faces
  node_ring::energies energies_;
  std::vector<place> better_;  // of the node at hand
};

}  // namespace asterism::internal::adapting
