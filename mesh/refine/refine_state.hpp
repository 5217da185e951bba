// SPDX-License-Identifier: MIT
//
// Keeps the sites, the split boundary and the stars of a mesh being refined in step, and adds
// sites.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/data/neighbour_lists.hpp"
#include "asterism/mesh/fill/fill.hpp"
#include "asterism/mesh/refine/site_set.hpp"
#include "asterism/mesh/refine/split_boundary.hpp"
#include "asterism/mesh/stars/star_oracle.hpp"
#include "asterism/mesh/stars/star_predicates.hpp"
#include "asterism/mesh/stars/star_set.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal {

class refine_state {
 public:
  // Builds the state with the proposed sites, without stars. Divides segments where that is
  // possible. Takes the other sites that are inside the divided domain and encroach on no
  // subsegment. No subsegment is split once there are `most_sites`. `field` and `kernel` must
  // outlive the state. Fails where the field does, and for a boundary that check_domain would have
  // refused. `cancelled` ends clear_encroachments and shorten_subsegments early. It is polled
  // between stars and between splits: these may be many, and each takes long where only exact
  // arithmetic decides.
  static result<refine_state> start(const domain& d, const metric_field& field,
                                    const star_predicates& kernel, std::size_t most_sites,
                                    const filled_domain& filling,
                                    const cancellation& cancelled = {}, double work_share = 1);

  const std::vector<site>& sites() const { return sites_->all(); }
  const split_boundary& segments() const { return segments_; }
  const boundary& edges() const { return segments_.edges(); }
  const star_set& stars() const { return stars_; }
  star_set& stars() { return stars_; }
  const star_predicates& kernel() const { return *kernel_; }
  site_oracle oracle() const {
    return {sites(), edges(), *kernel_, memory_.get(), &std::as_const(*sites_).near()};
  }
  bool is_full() const { return sites_->is_full(); }
  // Frees the index of sites and subsegments. The mesh must not be changed from then on.
  void forget_index() { sites_->forget_index(); }
  // Lowers the limit on sites to this number.
  void limit_sites(std::size_t most_sites) { sites_->limit(most_sites); }

  // True if the work limit for the number of sites was reached (stars/work_limit.hpp). Work is
  // counted, not timed, so that every run ends at the same place.
  bool is_overworked() const;
  // Count work that the kernel does not: proposing places for one triangle, and comparing
  // stars.
  void count_triangle_tried() { ++triangles_tried_; }
  void count_neighbours_looked_at(std::size_t neighbours) { looked_at_ += neighbours; }

  const std::optional<error>& field_failure() const { return sites_->field_failure(); }
  std::optional<site> site_at(const point& q) { return sites_->site_at(q); }
  bool is_farther(const site& s, double distance) const { return sites_->is_farther(s, distance); }
  bool strictly_inside(const point& q) const;
  // Returns the subsegments a site at this place would encroach on.
  std::vector<std::size_t> encroached_by(const site& s) const;

  // Makes all stars; those guessed by the fill are not all tested against all sites. Before this
  // call subsegments may be split, but no function that uses stars may be called.
  void construct_stars(star_confirmation confirmed);
  // Makes all stars from the neighbours that they are likely to have.
  void construct_stars(const neighbour_lists& likely, star_confirmation confirmed);

  // Adds a site with its star. Requires a site strictly inside the domain and distinct from the
  // others, and that the mesh is not full.
  void add_interior(const site& s);
  // Adds a site without its star, for many sites in a row; requires the same as add_interior(). The
  // stars left out must be made by add_stars() before any use of stars.
  void add_interior_later(const site& s);
  void add_stars();
  // Renumbers the inside sites, all but the domain's vertices, among themselves (site_set).
  // Requires that there are no stars yet.
  std::vector<vertex_index> number_along_curve(const std::vector<vertex_index>& inside) {
    return sites_->number_along_curve(inside);
  }
  // Splits one subsegment at its split point, or, if the subsegment is a chord of a curve, at the
  // point of the curve beside the split point. Returns false, with nothing changed, when the mesh
  // is full or the subsegment cannot be split there (split_boundary::can_split_at).
  bool split(std::size_t subsegment, double shortest);
  // Splits the subsegment that q lies on, if there is one, at its split point, not at q. Returns
  // false where split() does, and where there is none.
  bool split_at_place(const point& q, double shortest);
  // Splits the subsegment that hides q, a place outside the domain, from a corner of the triangle,
  // if a site at q would encroach on it from behind. Returns false where split() does, and where
  // there is none.
  bool split_before(const triangle& t, const point& q, double shortest);
  // Splits subsegments until none is encroached by a site, as far as split() allows. Returns false
  // when it ended early, cancelled or overworked.
  bool clear_encroachments(double shortest);
  // Sets a function that is called after each split of a subsegment from a to b by the last site;
  // an empty function ends that.
  using split_listener = std::function<void(vertex_index a, vertex_index b)>;
  void listen_to_splits(split_listener listener) { on_split_ = std::move(listener); }
  // Splits subsegments longer than `longest`, as far as split() allows, until cancelled or
  // overworked.
  void shorten_subsegments(double longest);

 private:
  refine_state(const star_predicates& kernel, std::size_t given, std::unique_ptr<site_set> sites,
               split_boundary segments)
      : kernel_(&kernel), given_(given), sites_(std::move(sites)), segments_(std::move(segments)) {}

  // Numbers of the sites here, indexed by the numbers of filled_domain::stars; `left_out` for a
  // site that was not taken.
  using numbered_sites = std::vector<vertex_index>;
  static constexpr vertex_index left_out = std::numeric_limits<vertex_index>::max();

  void divide(const domain& d, const filled_domain& filling, numbered_sites& taken);
  void add_proposed(const std::vector<site>& proposed, numbered_sites& taken);
  void guess_stars(const neighbour_lists& stars, const numbered_sites& taken);
  bool split_at(std::size_t subsegment, const point& q, double shortest);
  bool split_exactly_at(std::size_t subsegment, const point& q, double shortest, bool on_curve);
  void test_group(const star_predicates& kernel, std::span<const site> group,
                  std::vector<char>& out) const;
  bool strictly_inside_near(const star_predicates& kernel, const point& q) const;

  const star_predicates* kernel_;
  double work_share_ = 1;            // of the work allowed (stars/work_limit.hpp)
  mutable double charged_ = 0;       // of the work done, what the run's account was charged with
  std::size_t triangles_tried_ = 0;  // for which places were proposed
  std::size_t looked_at_ = 0;        // neighbours in stars
  std::size_t given_;                // the domain's vertices, which are the first sites
  std::unique_ptr<site_set> sites_;  // here, so that the boundary finds it when the state is moved
  split_boundary segments_;
  star_set stars_;
  neighbour_lists guesses_;  // by site; until the stars are made
  std::unique_ptr<edge_test_cache> memory_ = std::make_unique<edge_test_cache>();
  cancellation cancelled_;
  split_listener on_split_;
  bool has_stars_ = false;
};

}  // namespace asterism::internal
