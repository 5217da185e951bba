// SPDX-License-Identifier: MIT
//
// Keeps the energies (optimize/energy.hpp) of all triangles and edges of a triangulation as it
// changes. Whoever changes it must have the changed triangles judged anew.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "asterism/mesh/optimize/energy.hpp"
#include "asterism/mesh/optimize/mutable_triangulation.hpp"
#include "asterism/mesh/optimize/sharp_corners.hpp"

namespace asterism::internal::fitting {

class mesh_energies {
 public:
  // Judges all triangles by their shapes alone. The bound and the angle aimed at are in degrees.
  mesh_energies(const mutable_triangulation& net, double angle_bound, double target_angle);

  // Sets whether edges are judged as well, by what their stars would say. Judges all triangles
  // again and, if so, computes their centres.
  void judge_stars(const mutable_triangulation& net, bool yes);
  bool judges_stars() const { return judges_stars_; }

  // Judges t, which was made, reshaped or removed.
  void judge(const mutable_triangulation& net, vertex_index t);
  // Forgets the triangles after the first `count`.
  void truncate(std::size_t count);

  // True for a triangle at a sharp corner.
  bool is_sharp(vertex_index t) const { return sharp_[t] != 0; }
  // True if the triangle was judged since the mark was cleared; whoever examines it clears the
  // mark.
  bool is_changed(vertex_index t) const { return changed_[t] != 0; }
  void set_changed(vertex_index t) { changed_[t] = 1; }
  void clear_changed(vertex_index t) { changed_[t] = 0; }

  double shape(vertex_index t) const { return shapes_[t]; }
  // Returns the energy of shape that a triangle of these vertices would have.
  double shape_of(const mutable_triangulation& net, const std::array<vertex_index, 3>& v) const;
  // Returns the energy of t's shape and of its edges as its own centre sees them.
  double of_triangle(const mutable_triangulation& net, vertex_index t) const;
  // Returns the sum of all energies that change when v moves.
  double around(const mutable_triangulation& net, vertex_index v) const;
  // Returns the sum of the energies of edges that change when two triangles next to each other make
  // way for others.
  double of_edges_of_pair(const mutable_triangulation& net, vertex_index t, vertex_index s) const;

  // Judges the triangles around v, which has moved on trial. Returns the energy around it, or a
  // part of it as soon as that is not less than `below`. restore_around() puts all back.
  double try_around(const mutable_triangulation& net, vertex_index v, double below);
  void restore_around(const mutable_triangulation& net, vertex_index v);

 private:
  void judge_again(const mutable_triangulation& net, vertex_index t);
  double shape_now(const mutable_triangulation& net, vertex_index t) const;
  voronoi_centre centre_now(const mutable_triangulation& net, vertex_index t) const;
  double of_edge(const mutable_triangulation& net, vertex_index t, std::size_t edge) const;
  double of_edges(const mutable_triangulation& net, vertex_index t) const;

  angle_targets wanted_;
  sharp_corners corners_;
  bool judges_stars_ = false;
  std::vector<double> shapes_;  // by triangle, like the next three
  std::vector<voronoi_centre> centres_;
  std::vector<char> sharp_, changed_;
  std::vector<double> old_shapes_;  // from before the trial, like the next
  std::vector<voronoi_centre> old_centres_;
};

}  // namespace asterism::internal::fitting
