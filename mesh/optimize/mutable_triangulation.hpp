// SPDX-License-Identifier: MIT
//
// Holds a triangulation of a domain that can be changed and restored: vertices, triangles, who is
// next to whom, and a log. It knows nothing of what a change is good for.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/optimize/energy.hpp"

namespace asterism::internal::fitting {

inline constexpr vertex_index none = ~vertex_index{0};

// How a vertex may move. A `given` one is a vertex of the domain and stays. A `sliding` one is
// inside a segment and moves along it.
enum class vertex_kind : char { given, sliding, free };

// Place of a sliding vertex on its segment, from 0 to 1 in the segment's direction.
struct place_on_segment {
  vertex_index segment = none;
  double along = 0;
};

// Triangle with its vertices counter-clockwise. Edge i lies across from vertex i: `next` is the
// triangle on its other side, `segment` the one it is a subsegment of. A removed triangle has no
// vertices.
struct fit_triangle {
  std::array<vertex_index, 3> v{none, none, none};
  std::array<vertex_index, 3> segment{none, none, none};
  std::array<vertex_index, 3> next{none, none, none};

  bool exists() const { return v[0] != none; }
  std::size_t corner_of(vertex_index u) const { return v[0] == u ? 0 : v[1] == u ? 1 : 2; }
};

// Edge as the triangle on its left has it.
struct side {
  vertex_index triangle = none;
  std::size_t edge = 0;
};

class mutable_triangulation {
 public:
  // Starts empty. The domain must outlive it.
  explicit mutable_triangulation(const domain& d) : domain_(&d) {}

  const domain& shape() const { return *domain_; }
  const std::vector<fit_site>& sites() const { return sites_; }
  vertex_kind kind(vertex_index v) const { return kinds_[v]; }
  const place_on_segment& place(vertex_index v) const { return places_[v]; }
  const std::vector<fit_triangle>& triangles() const { return triangles_; }
  // Returns the triangles at v.
  const std::vector<vertex_index>& around(vertex_index v) const { return around_[v]; }
  // Returns the edge as the triangle on its other side has it; nothing where there is none.
  std::optional<side> opposite(vertex_index t, std::size_t edge) const;
  // Returns the vertex across the edge; requires a triangle there.
  vertex_index far_vertex(vertex_index t, std::size_t edge) const;

  vertex_index add_vertex(const fit_site& s, vertex_kind kind, const place_on_segment& place);
  // Makes a free vertex one that slides on a segment; for building.
  void put_on_segment(vertex_index v, const place_on_segment& place);
  void set_log_area(vertex_index v, double log_area) { sites_[v].log_area = log_area; }
  // Replaces the site of v on trial and returns the one before. This is not logged. The trial ends
  // by replacing it again or by keep_move().
  fit_site replace_site(vertex_index v, const fit_site& s);
  void keep_move(vertex_index v, const fit_site& before, double along);

  // Adds a place for a triangle, which does not exist yet. Returns its index.
  vertex_index add_triangle();
  // Makes t a triangle of these vertices, next to those that have its edges; with no vertices,
  // removes it. When several change in turn, each finds its neighbours by the direction in which
  // they run through the common edge, so that old and new ones are not mistaken.
  void set_triangle(vertex_index t, const std::array<vertex_index, 3>& v,
                    const std::array<vertex_index, 3>& segment);
  // Makes the edge from a to b, as the triangle on its left has it, a subsegment. False if there is
  // no such edge.
  bool set_subsegment(vertex_index a, vertex_index b, vertex_index segment);

  // Effect of collapsing v into its neighbour w. The triangles at v that have w too vanish
  // (`gone`), the others get w for v (`stay`).
  struct collapse_plan {
    std::vector<vertex_index> gone, stay;
  };
  // Plans the collapse of v into w. Returns nothing where it would change what is given, or leave
  // no triangulation: v and w may have no common neighbours but those in triangles with both.
  std::optional<collapse_plan> plan_collapse(vertex_index v, vertex_index w) const;

  // Logs changes from begin() on until they are kept or undone. Undoing restores the same triangles
  // under the same numbers. undo() returns those that exist and were touched, ascending.
  void begin();
  void keep() { logs_ = false; }
  std::vector<vertex_index> undo();

 private:
  struct log_entry {
    vertex_index triangle = none, vertex = none;
    fit_triangle old_triangle;
    fit_site old_site;
    double old_along = 0;
  };

  void link(vertex_index t);
  void unlink(vertex_index t);
  bool may_collapse(vertex_index v, vertex_index w) const;
  std::vector<vertex_index> neighbours_but(vertex_index v, vertex_index a, vertex_index b) const;

  const domain* domain_;
  std::vector<fit_site> sites_;  // by vertex, like the next three
  std::vector<vertex_kind> kinds_;
  std::vector<place_on_segment> places_;
  std::vector<std::vector<vertex_index>> around_;
  std::vector<fit_triangle> triangles_;
  bool logs_ = false;
  std::vector<log_entry> log_;
  std::size_t sites_before_ = 0, triangles_before_ = 0;
};

}  // namespace asterism::internal::fitting
