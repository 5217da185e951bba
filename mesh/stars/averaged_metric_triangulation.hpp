// SPDX-License-Identifier: MIT
//
// Keeps a triangulation of all sites of a mesh whose edges are flipped by the mean of the metrics
// at the four sites around each.
//
// It begins as a triangulation in one metric for all sites. Where metrics vary little over an edge,
// stars are nearly those of this triangulation. Its edges are proposals; only that it is a
// triangulation with all subsegments is exact.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "asterism/kernels/tier_counters.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/neighbour_lists.hpp"
#include "asterism/mesh/stars/site_triangulation.hpp"

namespace asterism::internal {

class averaged_metric_triangulation {
 public:
  // Triangulates the sites of the oracle, which must have a neighbourhood; none where that takes
  // too long or a segment goes through a site. The kernel's decisions are counted apart.
  static std::optional<averaged_metric_triangulation> make(const site_oracle& oracle,
                                                           const cancellation& cancelled);

  // Returns the number of faces, some of which are outside of the domain.
  std::size_t faces() const { return from_.delaunay.faces().size(); }
  bool is_inside(std::uint32_t face) const { return inside_[face] != 0; }
  // Returns the corners of a face inside the domain by the numbers of the sites, the least first.
  triangle corners(std::uint32_t face) const;

  // Walks over inside faces to the place of q among the faces; none where q is on or beyond a
  // subsegment, or the walk is long.
  std::optional<delaunay_triangulation::location> locate(const point& q, std::uint32_t from) const {
    return from_.delaunay.locate_near(q, from);
  }
  // Inserts the mesh's next site at a place found by locate; adds the faces at it to
  // `around`.
  void insert(const site& s, const delaunay_triangulation::location& at,
              std::vector<std::uint32_t>& around);
  // Inserts a site that splits the subsegment from a to b; the vertices are numbered as the sites.
  // Returns false, with nothing changed, where the rounded position of the site is on the wrong
  // side of another edge: then the triangulation is of no use.
  bool split(const site& s, vertex_index a, vertex_index b, std::vector<std::uint32_t>& around);

  // Follows a renumbering: the former site v of the mesh is now site to[v].
  void renumber(const std::vector<vertex_index>& to);

  // Flips edges that the stars of both ends refuse, though the mean metric does not. Returns the
  // neighbours of each site, counter-clockwise from the nearest. Marks the sites all of whose
  // neighbours are accepted in doubles without doubt.
  neighbour_lists settled_neighbours();

 private:
  // Answers and counts questions; on the heap, so that its address stays when this object is moved.
  struct asked {
    tier_counters counted;
    std::unique_ptr<star_predicates> kernel;
  };

  averaged_metric_triangulation(std::unique_ptr<asked> questions, site_triangulation from,
                                std::vector<char> inside);

  // Returns by how much the angles at c and d together exceed half a turn, in the mean of the four
  // metrics, for an edge from a to b with c on its left and d on its right: from -1 to 1, above 0
  // where the edge from c to d is the Delaunay one.
  double excess(vertex_index a, vertex_index b, vertex_index c, vertex_index d) const;
  bool is_better(vertex_index a, vertex_index b, vertex_index c, vertex_index d) const;
  delaunay_triangulation::comparison better() const {
    return [this](vertex_index a, vertex_index b, vertex_index c, vertex_index d) {
      return is_better(a, b, c, d);
    };
  }
  // Decides whether the stars refuse the edge from a to b and accept that from c to d. Marks the
  // ends of an edge whose stars do not accept it without doubt.
  bool is_better_in_stars(vertex_index a, vertex_index b, vertex_index c, vertex_index d);
  // Returns the number of flips that the next site may take.
  std::size_t flips_left() const;
  void number_last(vertex_index v);
  void collect_faces(vertex_index v, std::vector<std::uint32_t>& around) const;
  // Collects the neighbours of a site by their numbers, the nearest first.
  void collect_ring(vertex_index v, std::vector<vertex_index>& ring) const;

  std::unique_ptr<asked> questions_;
  site_triangulation from_;
  std::vector<site> sites_;  // by number in the triangulation
  std::vector<char> inside_;
  std::vector<char>
      has_doubtful_edge_;  // by number in the triangulation: is an edge at it in doubt?
};

// Returns the neighbours that the star of each site is likely to have, counter-clockwise from the
// nearest: those in an averaged-metric triangulation of the oracle's sites. Each is confirmed
// exactly or not used. Returns nothing where there is no triangulation. Requires a neighbourhood.
neighbour_lists guess_neighbours(const site_oracle& oracle, const cancellation& cancelled);

}  // namespace asterism::internal
