// SPDX-License-Identifier: MIT
//
// Builds the faces of a plane graph and finds the face that a point lies in. Works inside
// check_domain.
//
// Half-edge 2e runs along edge e from a to b, 2e + 1 the other way. Walking with the face on the
// left gives closed walks; a face has one walk for each connected part of its border. The walk
// around the outer side of each part is joined to the face it lies in by shooting one ray from the
// part's lowest vertex, lexicographically, in one sweep for all parts. Every decision is an exact
// orientation sign.
#pragma once

#include <cstddef>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/domain/planar_graph.hpp"

namespace asterism::internal {

class face_map {
 public:
  // `vertices` and `edges` must outlive the map; edges meet only at common vertices.
  face_map(const std::vector<point>& vertices, const std::vector<covered_edge>& edges);

  static constexpr std::size_t outside = 0;  // the unbounded face
  std::size_t left_of(std::size_t half_edge) const { return face_of_[half_edge]; }
  // Returns the face around each point; meaningless for a point on an edge. Time: O((n + k) log n)
  // for n edges and k points.
  std::vector<std::size_t> faces_around(const std::vector<point>& points) const;
  // Returns the edge that `q` lies on, ends included; edges.size() when there is none.
  std::size_t edge_through(const point& q) const;

 private:
  vertex_index origin(std::size_t half_edge) const;
  void sort_around_vertices();
  void walk_faces();
  void join_walks();
  struct by_height;
  // Returns, for each point, the nearest half-edge below it, infinitesimally to its left, running
  // to the right; no_half_edge when nothing is below.
  std::vector<std::size_t> half_edges_below(const std::vector<point>& points) const;
  bool is_above(std::size_t e, std::size_t f) const;

  static constexpr std::size_t no_half_edge = static_cast<std::size_t>(-1);

  const std::vector<point>& vertices_;
  const std::vector<covered_edge>& edges_;
  std::vector<std::vector<std::size_t>> around_;  // outgoing half-edges, counter-clockwise
  std::vector<std::size_t> position_;             // of a half-edge in around_[its origin]
  std::vector<std::size_t> face_of_;
};

}  // namespace asterism::internal
