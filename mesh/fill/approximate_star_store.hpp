// SPDX-License-Identifier: MIT
//
// Keeps the plain stars (numerics/approximate_star.hpp) of the sites a fill has placed up to date
// as sites are added.
#pragma once

#include <boost/container/deque.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/outcome.hpp"
#include "asterism/mesh/fill/fill_options.hpp"
#include "asterism/mesh/fill/placed_sites.hpp"
#include "asterism/mesh/fill/star_claims.hpp"
#include "asterism/mesh/fill/work_meter.hpp"
#include "asterism/mesh/numerics/approximate_star.hpp"
#include "asterism/mesh/support/large_page_allocator.hpp"

namespace asterism::internal {

class approximate_star_store {
 public:
  // Keeps stars of the sites in `box`, which must hold all of them. The other arguments must
  // outlive the store.
  approximate_star_store(const placed_sites& sites, const bounding_box& box,
                         const fill_options& options, work_meter& work)
      : sites_(&sites), box_(box), options_(&options), work_(&work) {}

  // Makes the missing stars, and renews those that new sites disturb. `distance` is that of the
  // level: once the level is done no point is farther from all sites, so that most stars find their
  // neighbours within a multiple of it. Returns false, with stars missing, at the work limit of the
  // meter.
  bool renew(double distance);

  const approximate_star& operator[](vertex_index v) const { return stars_[v]; }
  // True if each triangle of v's star is in the stars of its other two corners. Triangles between
  // three sites on segments, which may be outside the domain, are not compared.
  bool agrees_with_neighbours(vertex_index v) const;
  // Makes all stars anew from their neighbours after sites have moved by parts of their distances,
  // and offers each star the neighbours of its neighbours. `order` is as for the function below.
  void follow_moves(const std::vector<vertex_index>& order);
  // Makes the disagreeing stars anew, each from its neighbours and from the sites that have it as a
  // neighbour; most agree then. Returns one flag for each star: whether it agrees. Requires that no
  // more sites are added, and an `order` in which near sites follow each other.
  std::vector<char> mend_disagreeing(const std::vector<vertex_index>& order);
  // Returns the stars that the last renewal made anew, or all after mark_all_changed(): only these
  // can have new room for sites.
  const std::vector<vertex_index>& changed() const { return changed_; }
  void mark_all_changed();

  // Returns the site whose star has most neighbours; of several, the first.
  std::optional<crowded_site> most_crowded() const;

  // Frees the stars. The store must not be used from then on.
  void forget_stars() { stars_.clear(); }

 private:
  template <class Make>
  void make_anew(const claims_by_star& all, const Make& make);
  void prefetch_star(vertex_index v) const;
  bool is_between_segments(vertex_index v, vertex_index y, vertex_index x) const;
  std::vector<char> which_agree(const std::vector<vertex_index>& order) const;
  void note_disagreeing(vertex_index v, std::vector<vertex_index>& out) const;
  claim_list new_neighbours(const std::vector<vertex_index>& order) const;
  claim_list claims_on_disagreeing(const std::vector<char>& agrees) const;

  void make_stars(std::size_t first, std::size_t last, double distance, claim_list& disturbed);
  void renew_disturbed(const claim_list& disturbed);
  bool take_from_new(vertex_index v, approximate_gap& gap, vertex_index next) const;
  void make_star(vertex_index w, double distance, std::vector<vertex_index>& near,
                 std::uint64_t& looked_at);
  bool find_near(vertex_index w, double known, double reach, std::vector<vertex_index>& near,
                 std::uint64_t& looked_at) const;
  void extend_star(vertex_index w, std::span<const vertex_index> more);
  double farthest_vertex(vertex_index w, bool leaves_out) const;
  bool is_enough(std::size_t i) const;
  bool ends_search(vertex_index w, int attempt, bool is_ordinary, std::size_t looked_at) const;
  double first_reach_among_dense(vertex_index w, double distance) const;

  const placed_sites* sites_;
  bounding_box box_;
  const fill_options* options_;
  work_meter* work_;
  // Keeps stars in pages: a growing vector would hold these many large records twice.
  using star_blocks =
      boost::container::deque_options_t<boost::container::block_bytes<within_large_page>>;
  boost::container::deque<approximate_star, large_page_allocator<approximate_star>, star_blocks>
      stars_;
  std::size_t finished_ = 0;  // sites whose stars are made and known to their neighbours
  std::vector<vertex_index> changed_;
};

}  // namespace asterism::internal
