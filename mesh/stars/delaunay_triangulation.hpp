// SPDX-License-Identifier: MIT
//
// Keeps the constrained Delaunay triangulation of sites that all have one metric.
//
// Sites are inserted one by one and edges flipped (Lawson), exactly, with the ties of edge_test.
// The sites are in a frame of four more, far enough outside to be corners of no face inside the
// domain once the domain's boundary is inserted. Source: Lawson, Software for C1 surface
// interpolation, 1977; Sloan, A fast algorithm for generating constrained Delaunay triangulations,
// 1993.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/stars/star_predicates.hpp"

namespace asterism::internal {

class delaunay_triangulation {
 public:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  // A face with its corners in counter-clockwise order. across[i] is the face on the other side of
  // the edge that corner[i] is not an end of, and fixed[i] tells whether that edge must stay.
  struct face {
    std::array<vertex_index, 3> corner{};
    std::array<std::uint32_t, 3> across{};
    std::array<bool, 3> fixed{};
  };
  // A face, and one of its corners.
  struct place {
    std::uint32_t face = none;
    std::uint32_t corner = 0;
  };

  // Starts with the frame alone. Requires at least one site, all of the same metric. The kernel
  // must outlive the triangulation.
  delaunay_triangulation(std::vector<site> sites, const star_predicates& kernel);

  // Each of the following functions returns false, and leaves an unusable triangulation, if the
  // sites are not as required or the limit of steps for this number of sites is reached.

  // Inserts site v. Requires that it was not inserted yet and that no segment was.
  bool insert(vertex_index v);
  // Makes the edge from a to b one that stays. Requires that both sites were inserted; returns
  // false where the segment goes through a site.
  bool insert_segment(vertex_index a, vertex_index b);
  // Flips edges until all that may be flipped are Delaunay; to be called after the last segment.
  bool settle();
  // Flips edges while is_better(a, b, c, d) says that the edge from c to d is to take the place of
  // that from a to b, at most `most` times. The result is a triangulation with the edges that stay,
  // and in general not the Delaunay one: must be called last. Returns true if is_better was called
  // for each remaining edge with the faces that it has in the end.
  using comparison =
      std::function<bool(vertex_index a, vertex_index b, vertex_index c, vertex_index d)>;
  bool flip_towards(const comparison& is_better, std::size_t most);
  // Walks from this face to the face that contains q, or has q on an edge; the corner returned is
  // the one across from that edge. None where the walk meets a fixed edge, or is long.
  struct location {
    place where;
    bool on_edge = false;
  };
  std::optional<location> locate_near(const point& q, std::uint32_t from) const;
  // Inserts one more site at a place found for it, and flips edges around it as flip_towards()
  // does, at most `most` times: all faces that are new or changed have it as a corner. Returns its
  // number, which is not the next one: the frame's corners are numbered in between. Requires that
  // it is on no edge that stays.
  vertex_index insert_towards(const site& s, const location& at, const comparison& is_better,
                              std::size_t most);
  // Inserts a site on or beside the edge across from the corner. If that edge is fixed, both its
  // parts are. Edges are flipped on the corner's side, and on the other side as well if that is
  // asked for. The first of the two new faces is on the corner's side. Requires a face on either
  // side.
  vertex_index split_towards(const site& s, const place& at, bool on_both_sides,
                             const comparison& is_better, std::size_t most);
  // Returns the number of flips made by the two insertions above, in all.
  std::size_t flips_of_insertions() const { return flips_of_insertions_; }
  // Returns the face to the left of the edge from a to b, with the corner that is not on it; none
  // where there is no such edge, or too many steps were taken.
  std::optional<place> find_edge(vertex_index a, vertex_index b);

  // Returns the number of sites that the triangulation was made of, which is the number of the
  // first corner of the frame.
  std::size_t sites() const { return frame_; }
  const std::vector<site>& all_sites() const { return sites_; }
  bool is_frame(vertex_index v) const { return v >= frame_ && v < frame_ + frame_size; }
  const std::vector<face>& faces() const { return faces_; }
  // Returns one face at the site v, with v's corner in it.
  place at(vertex_index v) const { return {face_at_[v], corner_of(faces_[face_at_[v]], v)}; }
  // Returns the next face around the corner, counter-clockwise.
  place next_around(const place& p) const;

  // True if the face turns counter-clockwise and every edge of it is fixed or Delaunay; each edge
  // is tested for the face with the lesser number.
  bool is_sound(std::uint32_t face, const star_predicates& kernel) const;

 private:
  static constexpr vertex_index frame_size = 4;

  static std::uint32_t corner_of(const face& f, vertex_index v) {
    return f.corner[0] == v ? 0 : f.corner[1] == v ? 1 : 2;
  }
  static constexpr std::uint32_t after(std::uint32_t i) { return i == 2 ? 0 : i + 1; }
  static constexpr std::uint32_t before(std::uint32_t i) { return i == 0 ? 2 : i - 1; }

  bool add_frame();
  place other_side(const place& p) const;
  sign turn(vertex_index a, vertex_index b, vertex_index c) const {
    return turn(a, b, sites_[c].position);
  }
  sign turn(vertex_index a, vertex_index b, const point& q) const {
    return kernel_->orientation(sites_[a].position, sites_[b].position, q);
  }
  // True if the edge across from the corner is fixed or Delaunay. Evaluates the first tier of the
  // kernel directly: all metrics are the same, and it nearly always decides.
  bool stays(const place& p, const star_predicates& kernel) const;
  bool take_step() { return ++steps_ <= most_steps_; }
  std::optional<place> locate(vertex_index v, bool& on_edge);
  // Result of one step of the walk to q: the edge to cross or, where q is in the face, the number
  // of edges that q is on.
  struct way {
    bool goes_on = false;
    std::uint32_t edge = 0, touched = 0;
  };
  way way_to(const point& q, std::uint32_t at, std::uint32_t from) const;
  void put(std::uint32_t f, const face& what);
  void relink(std::uint32_t neighbour, std::uint32_t old_face, std::uint32_t new_face);
  void turn_to_front(const place& p);
  void split_face(std::uint32_t f, vertex_index v);
  void split_edge(const place& p, vertex_index v);
  void flip(const place& p);
  bool flip_around(vertex_index v);
  bool may_flip(const place& p, const comparison& is_better) const;
  bool improve(std::uint32_t face, std::uint32_t first, const comparison& is_better);
  vertex_index add_site(const site& s);
  void flip_around_towards(vertex_index v, const comparison& is_better, std::size_t most);
  bool cross(vertex_index a, vertex_index b, std::vector<std::pair<vertex_index, vertex_index>>&);
  bool clear_way(vertex_index a, vertex_index b,
                 std::vector<std::pair<vertex_index, vertex_index>> crossing);
  void suspect(const face& f);
  bool fix(vertex_index a, vertex_index b);

  std::vector<site> sites_;  // the frame after those it was made of, and before more
  vertex_index frame_ = 0;
  const star_predicates* kernel_;
  std::vector<face> faces_;
  std::vector<std::uint32_t> face_at_;                           // by site
  std::vector<std::uint32_t> open_;                              // scratch of flip_around
  std::vector<std::pair<vertex_index, vertex_index>> suspects_;  // edges for settle()
  std::uint32_t last_ = 0;
  std::size_t steps_ = 0, most_steps_ = 0, flips_of_insertions_ = 0;
  bool is_framed_ = false;
};

}  // namespace asterism::internal
