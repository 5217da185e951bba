// SPDX-License-Identifier: MIT
//
// Makes a triangulation whose edges have length one and whose triangles are as alike as their
// sites' metrics let them be: nodes from the background, splits, merges, flips and moves, by turns.
//
// Every step but splits and merges lowers an energy, and those are bounded in number: it always
// ends. In doubles; a proposal. Internal to mesh/adapt.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "asterism/mesh/adapt/working_mesh.hpp"

namespace asterism::internal::adapting {

// Returns the metric at a point; `hint` helps the next look-up near it (nodal_field.hpp).
using metric_at = std::function<metric_tensor(const point& q, vertex_index& hint)>;

struct unit_mesh_options {
  // Number of nodes wanted; 0, the default: as many as edges of length one take.
  std::size_t count = 0;
  std::size_t most_nodes = 1000000;
  std::function<bool()> stop;
};

// Returns the energy of a triangle, 1 for an equilateral one of the area of a unit one. `unit` is
// the length wanted of an edge, or 0 where size is not to count. Infinite unless it surely turns
// left.
double shape_energy(const node& a, const node& b, const node& c, double unit);

class unit_mesher {
 public:
  unit_mesher(working_mesh& m, metric_at field, unit_mesh_options options)
      : m_(m), field_(std::move(field)), options_(std::move(options)) {}

  // Makes the mesh. `seeds` are places to begin with, in an order in which neighbours follow each
  // other.
  void run(const std::vector<point>& seeds);
  double unit() const { return unit_; }

 private:
  void seed(const std::vector<point>& seeds);
  vertex_index locate(const point& q, vertex_index from) const;
  std::size_t split_long(double longest);
  std::size_t merge_short(double shortest);
  std::size_t flip_all();
  std::size_t smooth();
  void meet_count();
  bool flip_if_better(vertex_index t, std::size_t edge);
  void settle_around(vertex_index v);
  bool is_stopped() const { return options_.stop && options_.stop(); }
  double energy(vertex_index t) const;
  double energy_around(const face_list& at) const;
  bool merge_if_good(vertex_index v, vertex_index w, double longest);
  void measure(vertex_index v) { m_.set_metric(v, field_(m_.at(v).position, m_.at(v).hint)); }
  point pulled(vertex_index v, const face_list& at) const;
  bool try_move(vertex_index v, const point& to, const face_list& at, double before);

  working_mesh& m_;
  metric_at field_;
  unit_mesh_options options_;
  double unit_ = 1;
};

}  // namespace asterism::internal::adapting
