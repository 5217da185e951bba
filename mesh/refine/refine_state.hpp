// SPDX-License-Identifier: MIT
//
// A mesh being refined: sites, split boundary and stars, kept in step, and the ways to add a site.
//
// Encroachment (thesis, definition 8) is counted only from the domain's side of a subsegment: an
// internal subsegment and its twin have a side each.
//
// Corners whose angle in their own metric is below 60 degrees are *sharp*. Two subsegments at a
// sharp corner could encroach on each other for ever; therefore subsegments with one sharp end are
// split at power-of-two distances from it, in the corner's metric (concentric shells, after
// Ruppert; an internal subsegment when the corner on either side of it is sharp), and the far end
// of the subsegment across the corner does not count as encroaching unless it is nearer to the
// corner: of two such subsegments only the longer is ever split because of the other.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/data/outcome.hpp"
#include "asterism/mesh/fill/fill.hpp"
#include "asterism/mesh/stars/boundary.hpp"
#include "asterism/mesh/stars/proximity.hpp"
#include "asterism/mesh/stars/star_oracle.hpp"
#include "asterism/mesh/stars/star_predicates.hpp"
#include "asterism/mesh/stars/star_set.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal {

// An angle of the domain below 180 degrees between two neighbouring input segments at a domain
// vertex. Its directions never change, so neither does its angle.
struct domain_corner {
  vertex_index vertex = 0;
  std::size_t sector = 0;  // which of the vertex's corners and sectors
  double angle = 0;        // degrees, as the vertex measures it
};

// Two input segments that meet in a corner of less than 60 degrees, with nothing between them, as
// far as they go: beyond the first subsegments too.
struct domain_wedge {
  domain_corner corner;
  vertex_index first = 0, last = 0;          // the segments, counter-clockwise
  vertex_index first_end = 0, last_end = 0;  // their vertices other than the corner
  bool internal = false;                     // whether either of them is
};

class refine_state {
 public:
  // `field` and `kernel` must outlive the state. Fails where the field does, and for a boundary
  // that check_domain would have refused. No subsegment is split once there are `most_sites`.
  static result<refine_state> start(const domain& d, const metric_field& field,
                                    const star_predicates& kernel, std::size_t most_sites);
  // The same with a proposal put in first: segments are divided where that is possible, and of the
  // other sites those are taken that are inside what then is the domain and encroach on nothing.
  // `cancelled` is polled between stars and between splits, which may be many, and each slow where
  // only exact arithmetic decides; it ends clear_encroachments and shorten_subsegments early.
  static result<refine_state> start_filled(const domain& d, const metric_field& field,
                                           const star_predicates& kernel, std::size_t most_sites,
                                           const filled_domain& filling,
                                           const cancellation& cancelled = {});

  const std::vector<site>& sites() const { return sites_; }
  const boundary& edges() const { return edges_; }
  const star_set& stars() const { return stars_; }
  star_set& stars() { return stars_; }
  const star_predicates& kernel() const { return *kernel_; }
  const std::vector<domain_corner>& corners() const { return corners_; }
  // Valid until the state is moved.
  site_oracle oracle() const { return {sites_, edges_, *kernel_, memory_.get(), &near_}; }
  std::size_t splits() const { return splits_; }
  bool is_full() const { return sites_.size() >= most_sites_; }

  // Whether the most work that is done for so many sites was done (stars/work_limit.hpp). Counted,
  // not timed, so that every run ends at the same place.
  bool is_overworked() const;

  // Set when the metric field failed at a point that was tried; nothing can go on then.
  const std::optional<error>& field_failure() const { return field_failure_; }

  // The site at q with the field's metric; none where the field fails.
  std::optional<site> site_at(const point& q);
  bool strictly_inside(const point& q) const;
  // Whether s is farther than this from every site, as measured by them and by s.
  bool is_farther(const site& s, double distance) const;
  // The subsegments a site at this place would encroach on.
  std::vector<std::size_t> encroached_by(const site& s) const;

  // Requires a site strictly inside the domain and distinct from the others, and !is_full().
  void add_interior(const site& s);
  // The same without its star, for many in a row; then, before anything is asked of the stars,
  // add_stars() makes those.
  void add_interior_later(const site& s);
  void add_stars();
  // Splits one subsegment at its bisector point or shell. False, and nothing changed, when the mesh
  // is full, a new subsegment would be shorter than `shortest` (metric length, as any of its ends
  // measures), or doubles cannot split it: no double between its ends, or rounding would put a site
  // or another subsegment on the wrong side.
  bool split(std::size_t subsegment, double shortest);
  // Splits the subsegment that q lies on, if there is one; where, and whether, is split()'s affair.
  bool split_at_place(const point& q, double shortest);
  // Splits subsegments until none is encroached by a site, as far as split() allows. False when it
  // ended early, stopped or overworked.
  bool clear_encroachments(double shortest);
  // Splits subsegments longer than `longest`, as far as split() allows, until stopped or
  // overworked.
  void shorten_subsegments(double longest);

  // The corners at a vertex, of all those in corners().
  std::span<const domain_corner> corners_at(vertex_index v) const;
  // Whether the angle between the wedge's segments is surely below `degrees` as v measures it. Errs
  // only towards no.
  bool is_narrower(const domain_wedge& w, vertex_index v, double degrees) const;
  // The first wedge that accepts() and whose two segments hold all three corners of the triangle,
  // at least one of them a point that splits a segment; none if there is none. Each segment must
  // hold one that is not the corner of both.
  const domain_wedge* wedge_across(const triangle& t,
                                   const std::function<bool(const domain_wedge&)>& accepts) const;
  const std::vector<domain_wedge>& wedges() const { return wedges_; }
  // Wedges one of whose segments the site splits.
  std::vector<const domain_wedge*> wedges_at_split(vertex_index v) const;

  // The two subsegments at a corner: leaving it, and entering it.
  std::array<std::size_t, 2> subsegments_at(const domain_corner& c) const;
  // The subsegment's length as `from` measures it.
  double subsegment_length(std::size_t subsegment, vertex_index from) const;

 private:
  refine_state(const metric_field& field, const star_predicates& kernel, std::size_t most_sites)
      : field_(&field), kernel_(&kernel), most_sites_(most_sites) {}

  static result<refine_state> prepare(const domain& d, const metric_field& field,
                                      const star_predicates& kernel, std::size_t most_sites);
  void divide(const domain& d, const filled_domain& filling);
  void add_proposed(const std::vector<site>& proposed);
  void construct_stars();
  std::size_t find_subsegment(vertex_index a, vertex_index b) const;
  void put_on_subsegment(std::size_t subsegment, const site& m);
  void find_corners();
  void find_wedges();
  std::optional<point> mirrored_split_point(const boundary_edge& subsegment,
                                            vertex_index encroacher) const;
  std::optional<point> wedge_split_point(const boundary_edge& subsegment) const;
  bool split_at(std::size_t subsegment, const point& q, double shortest);
  bool strictly_inside_near(const star_predicates& kernel, const point& q) const;
  std::vector<std::size_t> encroached_by(const star_predicates& kernel, const site& s) const;
  bool is_encroached(const star_predicates& kernel, std::size_t subsegment, const site& s,
                     std::optional<vertex_index> self) const;
  bool is_excused(const boundary_edge& subsegment, vertex_index w) const;
  std::optional<vertex_index> find_encroacher(std::size_t subsegment) const;
  const domain_corner* sharp_corner(vertex_index v, const boundary_edge& subsegment) const;
  bool has_sharp_end(const boundary_edge& subsegment, vertex_index v) const;
  point split_point(const boundary_edge& subsegment) const;
  bool can_split_at(const boundary_edge& subsegment, const site& m, double shortest) const;
  void note_encroached_by(vertex_index w);

  std::vector<site> sites_;
  boundary edges_;
  neighbourhood near_;
  star_set stars_;
  const metric_field* field_;
  const star_predicates* kernel_;
  std::unique_ptr<edge_test_memory> memory_ = std::make_unique<edge_test_memory>();
  std::vector<domain_corner> corners_;
  std::vector<domain_wedge> wedges_;
  std::vector<std::vector<std::size_t>> wedges_of_segment_;
  std::vector<std::optional<vertex_index>> split_segment_;  // by site: the segment it splits
  std::vector<std::size_t> suspects_;                       // subsegments that may be encroached
  std::size_t most_sites_;
  std::size_t given_ = 0;  // the domain's vertices, which are the first sites
  std::size_t splits_ = 0;
  std::optional<error> field_failure_;
  cancellation cancelled_;
};

}  // namespace asterism::internal
