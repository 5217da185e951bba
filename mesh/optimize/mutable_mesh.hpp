// SPDX-License-Identifier: MIT
//
// A triangulation of a domain while it is being fitted: what may move where, the energies of its
// triangles (optimize/energy.hpp), elementary changes of it, and a log to undo them by.
//
// Every triangle surely turns left in doubles, always: what would spoil that is refused.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/optimize/energy.hpp"

namespace asterism::internal::fitting {

inline constexpr vertex_index none = ~vertex_index{0};

enum class vertex_kind : char { given, sliding, free };

// Where a sliding vertex is on its segment, from 0 to 1 in the segment's direction.
struct place_on_segment {
  vertex_index segment = none;
  double along = 0;
};

// Vertices counter-clockwise. Edge i lies across from vertex i: the triangle on its other side, and
// the segment it is a subsegment of. A triangle that is gone has no vertices.
struct fit_triangle {
  std::array<vertex_index, 3> v{none, none, none};
  std::array<vertex_index, 3> segment{none, none, none};
  std::array<vertex_index, 3> next{none, none, none};

  bool exists() const { return v[0] != none; }
  std::size_t corner_of(vertex_index u) const { return v[0] == u ? 0 : v[1] == u ? 1 : 2; }
};

// A corner of the domain below the angle bound as its own metric measures it, counter-clockwise
// from one direction to the other.
struct sharp_corner {
  vertex_index vertex = 0;
  point first, last;
};

class fitted_mesh {
 public:
  // Sites get the field's tensors. Fails where the field does, and, naming what is wrong, where
  // `start` is no triangulation of `d` in doubles. All three must outlive it.
  static result<fitted_mesh> build(const domain& d, const metric_field& field, const mesh& start,
                                   double angle_bound, double target_angle);

  const std::vector<fit_site>& sites() const { return sites_; }
  const std::vector<fit_triangle>& triangles() const { return triangles_; }
  vertex_kind kind(vertex_index v) const { return kinds_[v]; }
  const place_on_segment& place(vertex_index v) const { return places_[v]; }
  const std::vector<vertex_index>& around(vertex_index v) const { return around_[v]; }  // triangles
  std::size_t count() const { return count_; }  // of triangles there are
  bool is_sharp(vertex_index t) const { return sharp_[t] != 0; }
  const std::optional<error>& field_failure() const { return field_failure_; }

  // Whether edges are judged as well. Computes the centres.
  void judge_stars(bool yes);
  bool judges_stars() const { return judges_stars_; }

  double shape(vertex_index t) const { return shapes_[t]; }
  double shape_of(const std::array<vertex_index, 3>& v) const;
  // The shape, and the edges as the triangle's own centre sees them.
  double energy(vertex_index t) const;
  // Of an edge as t sees it: across to its far site, or as a subsegment.
  double edge_energy(vertex_index t, std::size_t edge) const;
  // The vertex across edge i; requires a next triangle.
  vertex_index far_vertex(vertex_index t, std::size_t edge) const;

  // All energies that change when v moves, or when the two triangles make way for others.
  double energy_around(vertex_index v) const;
  double star_energy_of_pair(vertex_index t, vertex_index s) const;

  // Where a vertex goes under a displacement of metric length `length` times the numbers, of the
  // unit disc; along its segment the first alone counts. Nothing for a given vertex.
  struct target_place {
    point position;
    double along = 0;
  };
  std::optional<target_place> displaced(vertex_index v, double length, const point& in_disc) const;
  // Moves v if no triangle turns over and all the energy around it gets less than `below`; what it
  // is then, or nothing, and nothing changed.
  std::optional<double> move(vertex_index v, const target_place& to, double below);
  // Flips edge i of t if all the energy of the two triangles falls by more than `margin`; by how
  // much.
  std::optional<double> flip(vertex_index t, std::size_t edge, double margin);

  // By how much the shapes' energy changes if v is merged into its neighbour w; nothing where that
  // would change what is given, or turn a triangle over.
  std::optional<double> merge_cost(vertex_index v, vertex_index w) const;
  // Requires merge_cost.
  void collapse(vertex_index v, vertex_index w);
  // A new vertex on the edge's middle; none where a triangle would be flat or the field fails.
  std::optional<vertex_index> split(vertex_index t, std::size_t edge);

  // What was changed since begin() stays, or is undone: the same triangles under the same numbers.
  void begin();
  void keep();
  void undo();

  // Set for a triangle that was made or reshaped; whoever examines it takes the mark away.
  bool is_changed(vertex_index t) const { return changed_[t] != 0; }
  void clear_changed(vertex_index t) { changed_[t] = 0; }

 private:
  struct log_entry {
    vertex_index triangle = none, vertex = none;
    fit_triangle old_triangle;
    fit_site old_site;
    double old_along = 0;
  };
  struct merge_plan {
    std::vector<vertex_index> gone, stay;
  };

  double own_star_energy(vertex_index t) const;

  fitted_mesh(const domain& d, const metric_field& field) : domain_(&d), field_(&field) {}

  std::optional<error> add_sites(const mesh& start);
  std::optional<error> add_places(const mesh& start);
  std::optional<error> add_triangles(const mesh& start);
  std::optional<error> add_subsegments(const mesh& start);
  void find_sharp_corners(double angle_bound);
  std::optional<sharp_corner> corner_from(vertex_index t, std::size_t at, double angle_bound) const;
  void choose_areas();
  bool set_subsegment(vertex_index a, vertex_index b, vertex_index segment);
  bool touches_sharp_corner(const std::array<vertex_index, 3>& v) const;
  void link(vertex_index t);
  void unlink(vertex_index t);
  void set_triangle(vertex_index t, const std::array<vertex_index, 3>& v,
                    const std::array<vertex_index, 3>& segment);
  vertex_index add_triangle();
  void judge(vertex_index t);
  std::optional<merge_plan> plan_merge(vertex_index v, vertex_index w) const;
  bool is_merge_allowed(vertex_index v, vertex_index w) const;
  double along_segment(vertex_index v, vertex_index segment) const;
  std::optional<fit_site> site_at(const point& q, double log_area);

  const domain* domain_;
  const metric_field* field_;
  angle_targets wanted_;
  bool judges_stars_ = false;
  std::vector<fit_site> sites_;
  std::vector<vertex_kind> kinds_;
  std::vector<place_on_segment> places_;
  std::vector<std::vector<vertex_index>> around_;
  std::vector<fit_triangle> triangles_;
  std::vector<double> shapes_;
  std::vector<voronoi_centre> centres_;
  std::vector<char> sharp_, changed_;
  std::size_t count_ = 0;
  std::vector<sharp_corner> sharp_corners_;  // by vertex
  bool logs_ = false;
  std::vector<log_entry> log_;
  std::size_t sites_before_ = 0, triangles_before_ = 0;
  std::vector<double> old_shapes_;  // of one move, as the next
  std::vector<voronoi_centre> old_centres_;
  std::optional<error> field_failure_;
};

}  // namespace asterism::internal::fitting
