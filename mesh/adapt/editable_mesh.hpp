// SPDX-License-Identifier: MIT
//
// Holds a triangulation that is being fitted to a metric: nodes with tensors, faces with their
// neighbours, and elementary changes.
//
// Every face certainly turns left, by an error bound in doubles: other changes are refused. Nothing
// else is certain; local_tests.hpp tests whether stars agree. Internal to mesh/adapt.
#pragma once

#include <array>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/domain/curve_chords.hpp"
#include "asterism/mesh/numerics/metric_length.hpp"
#include "asterism/mesh/support/cancellation.hpp"
#include "asterism/mesh/support/parallel.hpp"
#include "asterism/mesh/support/prefetch.hpp"
#include "asterism/mesh/support/shared_count.hpp"
#include "asterism/mesh/support/work_weights.hpp"

namespace asterism::internal::adapting {

inline constexpr vertex_index none = ~vertex_index{0};

// Kind of a node. A given node is a vertex of the domain. A sliding one divides a segment, and lies
// on it or on the curve that the segment is a chord of.
enum class node_kind : unsigned char { given, sliding, free, gone };

struct node {
  point position;
  metric_tensor metric;
  double root = 0;              // of the determinant of the metric
  vertex_index face = none;     // one of those at it
  vertex_index segment = none;  // segment that a sliding node divides
  vertex_index hint = none;     // where the field was looked up last (background_metric.hpp)
  node_kind kind = node_kind::free;
};

// Face of the mesh: its nodes counter-clockwise; edge i lies across from node i. A face that is
// gone has no nodes.
struct face {
  std::array<vertex_index, 3> v{none, none, none};
  std::array<vertex_index, 3> next{none, none, none};     // across the edge
  std::array<vertex_index, 3> segment{none, none, none};  // which the edge is a subsegment of

  bool exists() const { return v[0] != none; }
  // Requires a node of the face. Has no branch: any corner is as likely as the others, so that a
  // processor would predict every third one wrong.
  std::size_t corner_of(vertex_index u) const {
    return static_cast<std::size_t>(v[1] == u) + 2 * static_cast<std::size_t>(v[2] == u);
  }
};

// Least number of a segment that stands for an edge of a frame between blocks (mesh_blocks.hpp),
// which does not change.
inline constexpr vertex_index first_of_frame = vertex_index{1} << 31U;
inline constexpr bool is_of_frame(vertex_index segment) {
  return segment >= first_of_frame && segment != none;
}

using face_list = boost::container::small_vector<vertex_index, 16>;

inline constexpr std::size_t after(std::size_t i) { return i == 2 ? 0 : i + 1; }
inline constexpr std::size_t before(std::size_t i) { return i == 0 ? 2 : i - 1; }

// True if a triangle is certainly counter-clockwise, from the two products whose difference is
// twice its area. Differences of coordinates, products and their difference are each rounded once:
// 4 epsilon times the products bounds the error.
inline bool turns_left(double left, double right) {
  constexpr double part = 4 * std::numeric_limits<double>::epsilon();
  return left - right > part * (std::abs(left) + std::abs(right));
}
// True if the three points certainly turn counter-clockwise.
inline bool turns_left(const point& a, const point& b, const point& c) {
  return turns_left((b.x - a.x) * (c.y - a.y), (b.y - a.y) * (c.x - a.x));
}

inline double squared(const metric_tensor& m, double x, double y) {
  return x * (m.m11 * x + 2 * m.m12 * y) + m.m22 * y * y;
}

// Returns the length of the edge between two nodes: the mean of the lengths in both ends' metrics
// where these differ little, else about the length in a metric that changes geometrically along the
// edge.
inline double length_between(const node& p, const node& q) {
  const double x = q.position.x - p.position.x, y = q.position.y - p.position.y;
  const double s = std::sqrt(squared(p.metric, x, y)), t = std::sqrt(squared(q.metric, x, y));
  return (s + t) / 6 + 2.0 / 3 * std::sqrt(s * t);
}

// Edges that end a walk over faces.
enum class walls { boundary, segments };

// End of a walk to a place.
struct located_place {
  vertex_index face = none;
  std::optional<std::size_t> beyond;  // edge of the face at which the walk ended, before the place
};

// Triangulation that is being changed. Several threads may read it while none changes it.
class editable_mesh {
 public:
  // Builds the triangulation from a mesh of `d` without disagreeing triangles. Fails, with a
  // reason, where that is no triangulation in doubles. `d` must outlive it.
  static result<editable_mesh> build(const domain& d, const mesh& start);

  const std::vector<node>& nodes() const { return nodes_; }
  node& at(vertex_index v) { return nodes_[v]; }
  const node& at(vertex_index v) const { return nodes_[v]; }
  const std::vector<face>& faces() const { return faces_; }
  std::size_t count() const { return count_; }  // of nodes that are not gone
  const domain& shape() const { return *domain_; }

  void set_metric(vertex_index v, const metric_tensor& m) {
    nodes_[v].metric = m;
    nodes_[v].root = plain_root_of_determinant(m);
  }

  // Charges the account for the faces visited since the last call: those listed around nodes, and
  // those noted.
  void charge_work(const cancellation& stop) {
    stop.charge(work_weights::face_listed * static_cast<double>(looked_at_.take()));
  }
  // Returns the number of faces visited and not yet charged, and sets it to 0: the caller charges
  // them.
  std::size_t take_looked_at() { return looked_at_.take(); }
  void note_looked_at(std::size_t faces) const { looked_at_.add(faces); }

  // Calls act(v) for each node that exists, in several threads.
  template <class Act>
  void each_node(const Act& act) const {
    constexpr std::size_t chunk = 1024;
    parallel_chunks(nodes_.size(), chunk, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v)
        if (nodes_[v].kind != node_kind::gone) act(static_cast<vertex_index>(v));
    });
  }

  // Prefetches the corners of a face that will be read soon, or a face at a node; the face or node
  // itself is read.
  void prefetch_corners(std::size_t t) const {
    if (faces_[t].exists())
      for (const vertex_index v : faces_[t].v) prefetch(&nodes_[v]);
  }
  void prefetch_face_at(std::size_t v) const {
    if (nodes_[v].face != none) prefetch(&faces_[nodes_[v].face]);
  }

  // Lists the faces at v, counter-clockwise; at the boundary from its first to its last.
  void around(vertex_index v, face_list& out) const;
  // Lists the nodes joined to v by an edge.
  void neighbours(vertex_index v, face_list& out) const;

  double length(vertex_index a, vertex_index b) const {
    return length_between(nodes_[a], nodes_[b]);
  }

  // Walks from a face to the one that has the place, or to the edge beyond which it is: of the
  // boundary or a frame, or of any segment where these are walls. Returns no face where the walk
  // does not end. Computes sides in plain doubles: insert() decides whether a node can be there.
  located_place locate(const point& q, vertex_index from, walls at) const;
  // Adds a node on edge i of t; on a subsegment it becomes a sliding one. Returns no node where a
  // face would not turn left. The caller sets its metric.
  std::optional<vertex_index> split(vertex_index t, std::size_t edge, const point& where);
  // Adds a node inside t; returns no node where a face would not turn left.
  std::optional<vertex_index> insert(vertex_index t, const point& where);
  // True if the edge has faces on both sides, is no subsegment, and the other diagonal gives faces
  // that turn left.
  bool can_flip(vertex_index t, std::size_t edge) const;
  // Flips the edge to the other diagonal. Requires can_flip().
  void flip(vertex_index t, std::size_t edge);
  // True if v may be merged into its neighbour w. `at` lists the faces at v; without it they are
  // looked up.
  bool can_merge(vertex_index v, vertex_index w) const;
  bool can_merge(vertex_index v, vertex_index w, const face_list& at) const;
  // Merges v into its neighbour w. Requires can_merge().
  void merge(vertex_index v, vertex_index w);
  // True if all faces at v would turn left with v at that place.
  bool can_move(vertex_index v, const point& where) const;
  void move(vertex_index v, const point& where) { nodes_[v].position = where; }
  // Returns the place on the segment of a sliding node that is nearest to `where`, or on the curve
  // of which the segment is a chord; the node's present place if an end of the chord is nearest.
  point on_segment(vertex_index v, const point& where) const;
  // Returns the place at which to split an edge near one of its points: a point of the curve that
  // the edge is a chord of, else the point itself. Nothing where the curve has no such place.
  std::optional<point> place_on_edge(vertex_index t, std::size_t edge, const point& where) const;

  // Nodes and faces of a mesh, or of a part of one.
  struct parts {
    std::vector<node> nodes;
    std::vector<face> faces;
  };
  // Removes and returns all nodes and faces. The mesh must not be used until others are assigned.
  parts release();
  // Replaces the nodes and faces: the domain's vertices must come first, all of them present.
  void assign(parts p);
  // Does the same where none of the nodes and faces is gone.
  void assign_all(parts p);
  // Returns a mesh of the same domain with these nodes and faces.
  editable_mesh like(parts p) const;

  // Moves nodes and faces to memory of their exact size, without room for more.
  void shrink_to_fit() {
    nodes_.shrink_to_fit();
    faces_.shrink_to_fit();
  }

  // Returns the mesh: vertices of the domain in their order, then other nodes by number; faces as
  // triangles; subsegments in the order of their segments. `renumbered` maps nodes to sites.
  mesh triangulation(std::vector<vertex_index>& renumbered) const;

 private:
  explicit editable_mesh(const domain& d) : editable_mesh(d, std::make_shared<curve_chords>(d)) {}
  editable_mesh(const domain& d, std::shared_ptr<const curve_chords> curves)
      : domain_(&d), curves_(std::move(curves)) {}
  std::optional<error> add(const mesh& start);
  vertex_index new_face();
  vertex_index new_node(const point& where, node_kind kind);
  void set(vertex_index t, const std::array<vertex_index, 3>& v,
           const std::array<vertex_index, 3>& next, const std::array<vertex_index, 3>& segment);
  void replace_neighbour(vertex_index t, vertex_index old, vertex_index now);
  bool merge_is_allowed(vertex_index v, vertex_index w, const face_list& at) const;

  const domain* domain_;
  std::shared_ptr<const curve_chords> curves_;  // of the domain; copies share them
  std::vector<node> nodes_;
  std::vector<face> faces_;
  std::vector<vertex_index> free_faces_;
  std::size_t count_ = 0;
  mutable shared_count looked_at_;  // faces, not yet charged
};

}  // namespace asterism::internal::adapting
