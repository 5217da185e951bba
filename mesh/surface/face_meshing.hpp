// SPDX-License-Identifier: MIT
//
// Makes the plane mesh of one patch: its background with the metric wanted, and its meshes in
// rounds.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/surface_shell.hpp"
#include "asterism/mesh/surface/face_border.hpp"
#include "asterism/mesh/surface/surface_chart.hpp"
#include "asterism/mesh/surface/surface_mesh_options.hpp"

namespace asterism::internal {

// Places on the sides of a patch, from 0 to 1 along each side's parameter, ascending. A side that
// two patches share, or that trims, is divided at these places alone.
struct side_places {
  std::vector<std::vector<double>> at;
  std::vector<bool> is_common;
};

// A side of a patch, and a place on it.
struct on_side {
  int side = 0;
  double place = 0;
};

// Demands on the plane meshes of faces with common sides, in decreasing order. A vertex that one
// face adds on a common side may make the other face add a vertex on its next side, and so on
// around a vertex or a ring of faces. With lower demands this exchange ends.
enum class plane_demand {
  angles,  // sizes, and the bound of angles
  sizes,   // sizes alone; vertices are kept
  stars    // stars that agree, and no more; vertices are kept
};

class face_meshing {
 public:
  // Makes the background, with `cells` cells in each direction.
  face_meshing(const surface_chart& chart, const face_border& border, const surface_sizes& sizes,
               int cells);

  const surface_chart& chart() const { return *chart_; }
  // Returns the metric wanted at a point, multiplied by the present factor.
  metric_tensor metric_at(const point& p) const;
  // Multiplies densities everywhere by the exponential of this number.
  void add_everywhere(double log_factor);
  // Adds a number to the logarithm of the factor at the background's nodes in and around a
  // triangle; of several numbers the greatest, or the least where all are negative. Takes effect
  // with `apply`.
  void want(const std::array<point, 3>& triangle, double log_factor);
  void apply();
  // Returns the estimated number of vertices of a mesh of unit edges.
  double expected_vertices() const;

  // True if the polygons through these places on the loops of a trimmed patch have the same inside
  // as the loops, as far as a test shows: no two segments meet.
  bool is_simple(const side_places& places) const;
  // Makes the mesh with these places on its sides. Returns the reason if it is not complete, else
  // nothing. If vertices are to be kept, the vertices of the present mesh that were not freed are
  // in the new one, unless it would not be complete with them.
  result<std::string> make(const side_places& places, const surface_mesh_options& options);
  const mesh& plane() const { return plane_; }
  void keep_vertices(bool kept) { keeps_ = kept; }
  // Sets the demand on the next meshes of the face.
  void ask_for(plane_demand demand) { demand_ = demand; }
  plane_demand demand() const { return demand_; }
  // Returns the demand with which the present mesh was made.
  plane_demand made_with() const { return made_with_; }
  bool keeps_vertices() const { return keeps_; }
  // Frees the corners of the marked triangles of the present mesh, and of the triangles across the
  // edges of these.
  void free_around(const std::vector<unsigned char>& marked);
  // Returns the side that a site is on, and its place; none for sites inside and at corners.
  std::optional<on_side> side_of(vertex_index site) const;
  // Returns the places of the given sites of a trimmed patch; empty for other patches.
  std::vector<border_place> border_places() const;

 private:
  point node(int i, int k) const;
  std::size_t node_number(int i, int k) const {
    const std::size_t in_row = static_cast<std::size_t>(cells_) + 1;
    return static_cast<std::size_t>(k) * in_row + static_cast<std::size_t>(i);
  }
  struct cell_place;
  cell_place place_of(const point& p) const;
  void find_base();
  double consistent_density(const point& p, const point& direction, double density) const;
  mesh background() const;
  // A vertex of the plane domain that is no corner, and its place on a side; none for one inside.
  struct placed {
    point at;
    std::optional<on_side> on;
  };
  std::vector<placed> vertices_on_sides(const side_places& places, bool keep) const;
  std::vector<placed> vertices_inside() const;
  domain polygons(const std::vector<placed>& on_sides) const;
  // Finds the places of sites with which the mesh has split chords.
  void find_splits(const domain& shape);
  result<std::string> make_once(const side_places& places, bool keep,
                                const surface_mesh_options& options);

  const surface_chart* chart_;
  const face_border* border_;
  surface_sizes sizes_;
  int cells_;
  std::vector<metric_tensor> local_;  // what the curvature at each node asks for
  std::vector<metric_tensor> base_;   // and what edges can be of that length
  std::vector<double> log_factor_, wanted_;
  std::vector<unsigned char> is_wanted_;
  std::vector<on_side> given_on_;  // the sides of the sites that are given, after the corners
  std::map<vertex_index, on_side> split_on_;  // of a trimmed patch
  mesh plane_;
  bool keeps_ = false;
  plane_demand demand_ = plane_demand::angles, made_with_ = plane_demand::angles;
  std::vector<unsigned char> is_freed_;  // sites of the mesh
};

}  // namespace asterism::internal
