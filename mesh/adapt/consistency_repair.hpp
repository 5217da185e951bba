// SPDX-License-Identifier: MIT
//
// Makes the metric delivered: changes tensors of the nodes of a triangulation as little as is
// needed for their stars to agree with it, by tests in doubles.
//
// Checks at a triangle's Voronoi vertex, from which its three sites are equally far, that the site
// across each edge is farther, and that no angle is below the bound in the metric of any of its
// three sites. Where that fails, edges are flipped, tensors of the nodes around it are clipped
// (nodal_gradation.hpp), nodes are moved, and the faces are checked again. Equal tensors give the
// edges of one Delaunay triangulation, so the clipping ends: docs/math/delivered-metric.md. The
// number of rounds is bounded as well. Internal to mesh/adapt.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "asterism/mesh/adapt/editable_mesh.hpp"
#include "asterism/mesh/adapt/local_tests.hpp"
#include "asterism/mesh/gradation/nodal_gradation.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal::adapting {

struct repair_options {
  double angle_bound = 20;
  double unit = 1;  // length wanted of an edge
  std::size_t most_rounds = 60;
  // Function that returns the metric wanted at a place, for a node that has moved.
  std::function<std::optional<metric_tensor>(const point&)> wanted;
  cancellation stop;
};

struct repair_report {
  std::size_t rounds = 0, flips = 0, alike = 0, moves = 0, merges = 0;  // alike: pairs
  std::size_t disagreeing = 0, low = 0;                                 // edges and triangles left
};

class consistency_repair {
 public:
  // Starts from the tensors of the nodes as the ones wanted; they are changed to the ones
  // delivered. Both references must outlive the object.
  consistency_repair(editable_mesh& m, const repair_options& options);

  // Begins anew, with the tensors that the nodes have now, in the memory of what was done before.
  // `others_pass` tells that all edges and angles pass their tests, but for those at nodes given to
  // disagreed_at(): the first round then tests these alone.
  void restart(bool others_pass);
  // Mends in rounds until no changed node has a defect, or the limit on rounds is reached.
  void run();
  // Clips the tensors of these nodes, whose stars disagree in a way that run() does not detect.
  void disagreed_at(const std::vector<vertex_index>& nodes);
  // Leaves edges out of the next round: they all agree, as another repair of the mesh found, since
  // when nothing has changed.
  void edges_agree() { edges_agree_ = true; }
  // Tells whether run() may move or merge nodes on segments; it may by default. An audit of a mesh
  // whose boundary is as before takes a tenth of the time of a whole audit.
  void hold_boundary(bool holds) { holds_boundary_ = holds; }
  // Adds the triangles of these nodes, new or changed, to those that run() examines.
  void changed_at(const std::vector<vertex_index>& nodes);
  // Adds a node to each triangle with a low angle, equally far from the ends of its shortest edge,
  // for run() to fit in. Returns the number of nodes added.
  std::size_t add_at_low_faces();
  // Returns the nodes touched since the last start or forget_touched(), some of them several times:
  // among them all nodes that have changed and are left, and all nodes of new faces.
  const std::vector<vertex_index>& touched() const { return touched_; }
  void forget_touched() { touched_.clear(); }
  // Returns the report of all rounds since the last start.
  const repair_report& report() const { return report_; }

 private:
  bool round();
  void mend_edges();
  bool is_active(vertex_index t) const;
  // True if the node, or a neighbour of it, was changed in this round.
  bool is_touched(vertex_index v) const { return next_[v] != 0; }
  void find_due_faces();
  void add_due_face(vertex_index t);
  void question(vertex_index t);
  void touch(vertex_index v);
  template <class Act>
  void visit(const std::vector<char>& flags, std::size_t begin, std::size_t end, const Act& act);
  bool is_to_test(vertex_index t, std::size_t i) const;
  void find_clear_edges();
  void find_clear_edges(std::size_t begin, std::size_t end);
  void find_low_faces();
  void check_edge(vertex_index t, std::size_t i);
  bool move_off_circle(vertex_index d, vertex_index a, vertex_index b, vertex_index c);
  void check_angles(vertex_index t);
  double excess(const node& a, const node& b, const node& c) const;
  bool merge_away(vertex_index t);
  void follow_shape(vertex_index t);
  double defect_at(const face_list& at, double most) const;
  double longest_around(vertex_index v) const;
  bool may_move(vertex_index v) const;
  void move_away(vertex_index v);
  std::optional<vertex_index> add_at_shortest_edge(vertex_index t);
  void clip_distortion_at(const std::vector<vertex_index>& nodes, double part);

  editable_mesh& m_;
  const repair_options& options_;
  local_tests tests_;
  double aim_;                // cotangent of the angle aimed at
  bool edges_agree_ = false;  // until the next round
  bool holds_boundary_ = false;
  std::vector<char> active_, next_;
  std::vector<vertex_index> touched_;
  // Flags of the faces to be tested: faces with an active node, and the neighbours of these, those
  // that the round has made included.
  std::vector<char> is_due_;
  // Flags of those of them that have an edge or an angle in question: one that failed its test when
  // the round began, or whose nodes have been touched since.
  std::vector<char> in_question_;
  // Voronoi vertices of the due faces of a stretch, while its edges are tested.
  std::vector<face_centre> centres_;
  // One bit for each edge of a face that agreed before the round changed it.
  std::vector<unsigned char> clear_edges_;
  repair_report report_;
};

}  // namespace asterism::internal::adapting
