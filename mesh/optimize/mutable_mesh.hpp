// SPDX-License-Identifier: MIT
//
// Changes a triangulation of a domain while it is being optimised. Each elementary change is judged
// by the energies (optimize/mesh_energies.hpp), and undone when it does not pay.
//
// Every triangle surely turns left in doubles, always: a change that would spoil that is refused.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/metric/field_sampler.hpp"
#include "asterism/mesh/optimize/mesh_energies.hpp"
#include "asterism/mesh/optimize/mutable_triangulation.hpp"

namespace asterism::internal::fitting {

class mutable_mesh {
 public:
  // Builds the mesh from `start`; its sites get the field's tensors. Fails where the field does,
  // and, naming what is wrong, where `start` is no triangulation of `d` in doubles. All three must
  // outlive it. Angles are in degrees.
  static result<mutable_mesh> build(const domain& d, const metric_field& field, const mesh& start,
                                    double angle_bound, double target_angle);

  const std::vector<fit_site>& sites() const { return net_.sites(); }
  const std::vector<fit_triangle>& triangles() const { return net_.triangles(); }
  vertex_kind kind(vertex_index v) const { return net_.kind(v); }
  const place_on_segment& place(vertex_index v) const { return net_.place(v); }
  // Returns the triangles at v.
  const std::vector<vertex_index>& around(vertex_index v) const { return net_.around(v); }
  // Returns the vertex across the edge; requires a triangle there.
  vertex_index far_vertex(vertex_index t, std::size_t edge) const {
    return net_.far_vertex(t, edge);
  }
  // Returns the field's first failure, at a place that was tried; none if it did not fail.
  const std::optional<error>& field_failure() const { return sampler_.failure(); }

  // Sets whether edges are judged as well as shapes.
  void judge_stars(bool yes) { energies_.judge_stars(net_, yes); }
  bool judges_stars() const { return energies_.judges_stars(); }
  // Returns the energy of t's shape and of its edges as its own centre sees them.
  double energy(vertex_index t) const { return energies_.of_triangle(net_, t); }
  // Returns the sum of all energies that change when v moves.
  double energy_around(vertex_index v) const { return energies_.around(net_, v); }
  // True for a triangle at a corner of the domain that is below the angle bound.
  bool is_sharp(vertex_index t) const { return energies_.is_sharp(t); }
  // True if the triangle was made or reshaped since the mark was cleared; whoever examines it
  // clears the mark.
  bool is_changed(vertex_index t) const { return energies_.is_changed(t); }
  void clear_changed(vertex_index t) { energies_.clear_changed(t); }

  // Place to which a vertex is to go: a position, and for a sliding vertex how far along its
  // segment, from 0 to 1.
  struct target_place {
    point position;
    double along = 0;
  };
  // Returns where v goes under a displacement of metric length `length` times `in_disc`, a point of
  // the unit disc. On a segment its first coordinate alone counts. Returns nothing for a given
  // vertex or beyond an end of the segment.
  std::optional<target_place> displaced(vertex_index v, double length, const point& in_disc) const;
  // Moves v if no triangle turns over and the energy around it falls below `below`. Returns the new
  // energy, or nothing if nothing changed.
  std::optional<double> move(vertex_index v, const target_place& to, double below);
  // Flips the edge of t if the energy of the two triangles falls by more than `margin`. Returns the
  // change, a negative number, or nothing if nothing changed.
  std::optional<double> flip(vertex_index t, std::size_t edge, double margin);

  // Returns by how much the shapes' energy changes if v is collapsed into its neighbour w. Returns
  // nothing where that would change what is given, or turn a triangle over.
  std::optional<double> collapse_cost(vertex_index v, vertex_index w) const;
  // Collapses v into w. Requires that collapse_cost(v, w) returns a number.
  void collapse(vertex_index v, vertex_index w);
  // Splits the edge of t at its middle. Returns the new vertex, or none where a triangle would be
  // flat or the field fails.
  std::optional<vertex_index> split(vertex_index t, std::size_t edge);

  // Logs changes from begin() on until they are kept or undone. Undoing restores the same triangles
  // under the same numbers.
  void begin() { net_.begin(); }
  void keep() { net_.keep(); }
  void undo();

 private:
  class trial_move;

  mutable_mesh(mutable_triangulation net, field_sampler sampler, double angle_bound,
               double target_angle);

  std::optional<fit_site> site_at(const point& q, double log_area);
  void set_triangle(vertex_index t, const std::array<vertex_index, 3>& v,
                    const std::array<vertex_index, 3>& segment);
  bool turns_left_at(vertex_index v, const point& to) const;
  double along_segment(vertex_index v, vertex_index segment) const;
  target_place middle_of(vertex_index t, std::size_t edge) const;
  bool can_cut(const side& whole, const point& middle) const;
  void cut(const fit_triangle& whole, const side& at, vertex_index middle);

  mutable_triangulation net_;
  field_sampler sampler_;
  mesh_energies energies_;
};

}  // namespace asterism::internal::fitting
