// SPDX-License-Identifier: MIT
//
// Keeps the stars of all sites up to date as sites are added and boundary subsegments split.
//
// Adding a site offers it to stars one by one (candidate_stars decides which) and marks the changed
// ones as *stale*: they were changed in the order of insertion and may not be settled
// (stars/star_construction.hpp). A star that is not stale is settled, because it refused every site
// that came after its construction. rebuild() makes a stale star anew.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "asterism/mesh/data/neighbour_lists.hpp"
#include "asterism/mesh/stars/star.hpp"
#include "asterism/mesh/stars/star_construction.hpp"
#include "asterism/mesh/stars/star_oracle.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal {

class star_set {
 public:
  star_set() = default;
  // Takes stars made elsewhere: all of them stale, except those named, which count as
  // unsettled.
  explicit star_set(std::vector<star> stars, const std::vector<vertex_index>& unsettled = {});

  // Sets the cancellation, which is polled while many stars are made. Once it is requested the
  // other stars stay as they are: stale, and empty if they are new. The caller must then end
  // refinement.
  void cancel_by(cancellation cancelled) { cancelled_ = std::move(cancelled); }

  // Bounds the work of making stars: ends it, even inside a star, once the kernel's work exceeds
  // 1.1 times `share` of the work limit (stars/work_limit.hpp) for the number of sites, `given`
  // vertices among them. Other stars then stay as they are.
  void bound_work(std::size_t given, double share = 1) {
    given_ = given;
    work_share_ = share;
  }

  // Returns the number of stars that were never made; they are empty.
  std::size_t stars_missing() const;

  vertex_index size() const { return static_cast<vertex_index>(stars_.size()); }
  const star& operator[](vertex_index v) const { return stars_[v]; }
  bool is_stale(vertex_index v) const { return condition_[v] == condition::stale; }
  // True if the star was found to be final (stars/star_finality.hpp) against all sites of that
  // time.
  bool is_confirmed(vertex_index v) const { return final_[v].against != 0; }
  // True if construction met its bound: the star violates (a) or (b) and is a defect of the mesh.
  bool is_unsettled(vertex_index v) const { return condition_[v] == condition::unsettled; }

  // Replaces everything by one star per site of the oracle, each constructed by itself. `guesses`
  // has the neighbours that some of them are likely to have, counter-clockwise; `confirmed` says
  // which guesses are tested against all sites.
  void construct_all(const site_oracle& oracle, const neighbour_lists& guesses = {},
                     star_confirmation confirmed = star_confirmation::by_mesher);
  // Adds the oracle's last site: offers it to the other stars and constructs its own. If it splits
  // a boundary subsegment, call split_subsegment instead.
  void add_last(const site_oracle& oracle);
  // Adds the sites from `first` on, none of them on the boundary. Makes their stars, and those of
  // the sites they disturb, anew, in parallel.
  void add_many(const site_oracle& oracle, vertex_index first);
  // Adds the oracle's last site m, which has just split the subsegment a -> b of the boundary, and
  // its twin if there is one. The boundary must know of the split already.
  void split_subsegment(const site_oracle& oracle, vertex_index a, vertex_index m, vertex_index b);
  // Constructs the star of v anew. True if its neighbours changed or it did not settle.
  bool rebuild(const site_oracle& oracle, vertex_index v,
               star_search search = star_search::thorough);
  // Constructs the star of each of `which` anew, in parallel. Returns those whose neighbours
  // changed or that did not settle, in the order of `which`. Requires distinct indices.
  std::vector<vertex_index> construct(const site_oracle& oracle,
                                      const std::vector<vertex_index>& which, star_search search);

  // Offers each of `which` the sites listed for it, list by list in the same order, and constructs
  // those anew that would accept one, from these and the near sites. Returns those that changed or
  // did not settle, as the overload above. Requires `which` sorted.
  std::vector<vertex_index> exchange(const site_oracle& oracle,
                                     const std::vector<vertex_index>& which,
                                     const neighbour_lists& others);

  // Returns the total number of stars that were tested against sites added one by one. Where
  // metrics vary wildly, each site added is tested against every star.
  std::size_t candidates_looked_at() const { return candidates_; }

  // Stars that were changed, and the neighbours they had before; an index may occur twice in either
  // list.
  struct touched_stars {
    std::vector<vertex_index> changed, neighbours_before;
  };
  // Returns the changes since the last call. Triangles at these sites have to be examined
  // again.
  touched_stars take_touched() { return std::exchange(touched_, {}); }

 private:
  enum class condition : unsigned char { settled, stale, unsettled };
  // Number of first sites against which the star, as it is, is final (stars/star_finality.hpp); 0,
  // the default, if it is not known to be. The reach is rounded up.
  struct finality {
    vertex_index against = 0;
    float reach = 0;
  };

  struct made_star {
    vertex_index at;
    std::optional<constructed_star> built;  // empty if it was left for later
  };

  void add_empty_stars(std::size_t size);
  double part_of_work_bound(const site_oracle& oracle) const;
  double most_units(const site_oracle& oracle) const;
  std::vector<made_star> construct_block(const site_oracle& oracle,
                                         std::span<const vertex_index> which, star_search search,
                                         const site_index* latest, std::size_t in_all);
  std::optional<constructed_star> remake(const site_oracle& oracle, vertex_index v,
                                         star_search search, const site_index* latest);
  bool accepts_any(const site_oracle& oracle, vertex_index v,
                   std::span<const vertex_index> others) const;
  bool confirm(const site_oracle& oracle, vertex_index v, const site_index& latest);
  void remove_hidden(const site_oracle& oracle, vertex_index a, vertex_index b);
  bool is_news(vertex_index v, const constructed_star& built) const;
  void mark_stale(vertex_index v);
  void note_final(vertex_index v, vertex_index against, const std::optional<double>& reach);
  site_index latest_sites(const site_oracle& oracle, const std::vector<vertex_index>& which) const;
  bool is_still_final(const site_oracle& oracle, vertex_index v, const site_index& latest) const;
  void accept(const site_oracle& oracle, vertex_index v, constructed_star built);
  void touch(vertex_index v);  // notes a change of v's star; to be called before it
  void touch(vertex_index v, const star& before);

  cancellation cancelled_;
  // Work, in units, at which the run's account is used up.
  double most_of_run_ = std::numeric_limits<double>::infinity();
  std::optional<std::size_t> given_;
  double work_share_ = 1;
  std::size_t candidates_ = 0;
  touched_stars touched_;
  const neighbour_lists* guesses_ = nullptr;                    // while all stars are made
  star_confirmation confirmed_ = star_confirmation::by_mesher;  // the guesses
  // Arguments of exchange(), kept for the threads while it runs.
  struct exchanged {
    const std::vector<vertex_index>* which = nullptr;
    const neighbour_lists* others = nullptr;
    std::span<const vertex_index> of(vertex_index v) const;
  } exchanged_;
  std::vector<star> stars_;
  std::vector<condition> condition_;
  std::vector<finality> final_;
};

}  // namespace asterism::internal
