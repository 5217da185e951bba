// SPDX-License-Identifier: MIT
//
// Keeps the boundary of a mesh being refined: its subsegments, which of them are encroached, and
// where they may be split.
//
// Encroachment (thesis, definition 8) is counted only from the domain's side of a subsegment: an
// internal subsegment and its twin have a side each.
//
// Corners whose angle in their own metric is below 60 degrees are *sharp*. Two subsegments at a
// sharp corner could encroach on each other for ever. Therefore subsegments with one sharp end are
// split at power-of-two distances from it, in the corner's metric (concentric shells, after
// Ruppert). An internal subsegment has a sharp end if the corner on either side of it is sharp. The
// far end of the subsegment across the corner does not count as encroaching unless it is nearer to
// the corner: of two such subsegments only the longer is ever split because of the other.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/refine/curved_splits.hpp"
#include "asterism/mesh/refine/narrow_wedges.hpp"
#include "asterism/mesh/refine/site_set.hpp"
#include "asterism/mesh/stars/boundary.hpp"
#include "asterism/mesh/stars/star_predicates.hpp"

namespace asterism::internal {

class split_boundary {
 public:
  // Builds the boundary from the domain's segments as they are, and indexes the sites, which must
  // be its vertices. Both references must outlive it. Fails for a boundary that check_domain would
  // have refused.
  static result<split_boundary> build(const domain& d, const star_predicates& kernel,
                                      site_set& sites);

  const boundary& edges() const { return edges_; }
  std::size_t splits() const { return splits_; }
  // Returns the angles of the domain, in the order of their vertices.
  const std::vector<domain_corner>& corners() const { return corners_; }
  // Returns the corners at a vertex, of all those in corners().
  std::span<const domain_corner> corners_at(vertex_index v) const;
  const narrow_wedges& wedges() const { return wedges_; }

  // Returns the two subsegments at a corner: leaving it, and entering it.
  std::array<std::size_t, 2> subsegments_at(const domain_corner& c) const;
  // Returns the subsegment from a to b, which must exist.
  std::size_t find_subsegment(vertex_index a, vertex_index b) const;
  // Returns the subsegment that q lies on, its ends left out; none if there is none.
  std::optional<std::size_t> subsegment_through(const point& q) const;
  // Returns the subsegment that hides q, a place outside the domain, from a corner of the triangle,
  // if a site at q with that corner's metric would encroach on it from behind: the field may not
  // exist outside. Returns none if there is none. Decided exactly.
  std::optional<std::size_t> subsegment_before(const triangle& t, const point& q) const;
  // Returns the subsegment's length as `from` measures it.
  double subsegment_length(std::size_t subsegment, vertex_index from) const;

  // Returns the subsegments a site at this place would encroach on.
  std::vector<std::size_t> encroached_by(const star_predicates& kernel, const site& s) const;
  // Marks the subsegments that site w may encroach on as suspects. suspect_all() marks all.
  void note_encroached_by(vertex_index w);
  void suspect_all();
  bool has_suspects() const { return !suspects_.empty(); }
  struct encroachment {
    std::size_t subsegment = 0;
    std::optional<point> mirrored;  // place to split it at rather than split_point()
  };
  // Takes the last suspect, of which there must be one, and returns its encroachment; nothing if it
  // is not encroached.
  std::optional<encroachment> next_encroachment();

  // Returns the place at which the subsegment is to be split: its bisector point, a shell, or a
  // round distance from the corner of a narrow wedge.
  point split_point(const boundary_edge& subsegment) const;
  // Returns the point of the curve beside q, a point of the subsegment, if the subsegment is a
  // chord. None at sharp corners and in narrow wedges, whose two sides are split alike.
  std::optional<point> place_on_curve(const boundary_edge& subsegment, const point& q) const;
  // True if m may split the subsegment: no part would be shorter than `shortest` (metric length, as
  // any of its ends measures), doubles have a place between its ends, and no site or other
  // subsegment would come to the wrong side. `on_curve`: m is from place_on_curve().
  bool can_split_at(const boundary_edge& subsegment, const site& m, double shortest,
                    bool on_curve = false) const;
  // Adds the site, and splits the subsegment, and its twin if it has one, at it. Requires
  // can_split_at().
  void put_on_subsegment(std::size_t subsegment, const site& m, bool on_curve = false);

 private:
  split_boundary(const star_predicates& kernel, site_set& sites)
      : kernel_(&kernel), sites_(&sites) {}

  const std::vector<site>& sites() const { return sites_->all(); }
  const proximity& near() const { return std::as_const(*sites_).near(); }
  // A sharp corner at an end of a segment, and whether the segment's subsegment there leaves the
  // corner or enters it.
  struct segment_corner {
    vertex_index vertex;
    bool leaving;
    std::size_t corner;  // one of corners_
  };

  void find_corners();
  void note_sharp_corners();
  bool is_reached(const star_predicates& kernel, const boundary_edge& p, const site& s) const;
  bool is_encroached(const star_predicates& kernel, std::size_t subsegment, const site& s,
                     std::optional<vertex_index> self) const;
  bool is_excused(const boundary_edge& subsegment, vertex_index w) const;
  template <class Visit>
  void visit_near(const boundary_edge& p, const Visit& visit) const;
  std::optional<vertex_index> find_encroacher(std::size_t subsegment) const;
  const domain_corner* sharp_corner(vertex_index v, const boundary_edge& subsegment) const;
  bool has_sharp_end(const boundary_edge& subsegment, vertex_index v) const;

  const star_predicates* kernel_;
  site_set* sites_;
  boundary edges_;
  std::vector<domain_corner> corners_;
  std::vector<std::vector<segment_corner>> sharp_at_;  // by segment: at most four
  narrow_wedges wedges_;
  curved_splits curves_;
  std::vector<std::size_t> suspects_;  // subsegments that may be encroached
  std::size_t splits_ = 0;
};

}  // namespace asterism::internal
