// SPDX-License-Identifier: MIT
//
// A triangulation of a domain while it is being optimised: elementary changes of it, each judged by
// the energies (optimize/mesh_energies.hpp), and undone when it does not pay.
//
// Every triangle surely turns left in doubles, always: what would spoil that is refused.
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
  // Sites get the field's tensors. Fails where the field does, and, naming what is wrong, where
  // `start` is no triangulation of `d` in doubles. All three must outlive it. Angles in degrees.
  static result<mutable_mesh> build(const domain& d, const metric_field& field, const mesh& start,
                                    double angle_bound, double target_angle);

  const std::vector<fit_site>& sites() const { return net_.sites(); }
  const std::vector<fit_triangle>& triangles() const { return net_.triangles(); }
  vertex_kind kind(vertex_index v) const { return net_.kind(v); }
  const place_on_segment& place(vertex_index v) const { return net_.place(v); }
  // The triangles at v.
  const std::vector<vertex_index>& around(vertex_index v) const { return net_.around(v); }
  // The vertex across edge i; requires a next triangle.
  vertex_index far_vertex(vertex_index t, std::size_t edge) const {
    return net_.far_vertex(t, edge);
  }
  // The field's first failure, at a place that was tried.
  const std::optional<error>& field_failure() const { return sampler_.failure(); }

  // True if edges are judged as well as shapes.
  void judge_stars(bool yes) { energies_.judge_stars(net_, yes); }
  bool judges_stars() const { return energies_.judges_stars(); }
  // The energy of t's shape and of its edges as its own centre sees them.
  double energy(vertex_index t) const { return energies_.of_triangle(net_, t); }
  // All energies that change when v moves.
  double energy_around(vertex_index v) const { return energies_.around(net_, v); }
  // True for a triangle at a corner of the domain that is below the angle bound.
  bool is_sharp(vertex_index t) const { return energies_.is_sharp(t); }
  // Set for a triangle that was made or reshaped; whoever examines it takes the mark away.
  bool is_changed(vertex_index t) const { return energies_.is_changed(t); }
  void clear_changed(vertex_index t) { energies_.clear_changed(t); }

  // Where a vertex goes under a displacement of metric length `length` times the numbers, of the
  // unit disc; along its segment the first alone counts. Nothing for a given vertex.
  struct target_place {
    point position;
    double along = 0;
  };
  std::optional<target_place> displaced(vertex_index v, double length, const point& in_disc) const;
  // Moves v if no triangle turns over and all the energy around it gets less than `below`. Returns
  // what it is then, or nothing, and nothing changed.
  std::optional<double> move(vertex_index v, const target_place& to, double below);
  // Flips edge i of t if all the energy of the two triangles falls by more than `margin`. Returns
  // by how much, or nothing, and nothing changed.
  std::optional<double> flip(vertex_index t, std::size_t edge, double margin);

  // Returns by how much the shapes' energy changes if v is collapsed into its neighbour w; nothing
  // where that would change what is given, or turn a triangle over.
  std::optional<double> collapse_cost(vertex_index v, vertex_index w) const;
  // Requires collapse_cost.
  void collapse(vertex_index v, vertex_index w);
  // Returns the new vertex on the edge's middle; none where a triangle would be flat or the field
  // fails.
  std::optional<vertex_index> split(vertex_index t, std::size_t edge);

  // What was changed since begin() stays, or is undone: the same triangles under the same numbers.
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
