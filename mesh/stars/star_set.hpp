// SPDX-License-Identifier: MIT
//
// The stars of all sites, kept up to date as sites are added and boundary subsegments split.
//
// Adding a site offers it to stars one by one (candidate_stars decides which) and marks those that
// changed as *stale*: they were changed in the order of insertion and may not be settled
// (stars/star_construction.hpp). A star that is not stale is settled, because it refused every site
// that came after its construction. rebuild() makes a stale star anew.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "asterism/mesh/stars/star.hpp"
#include "asterism/mesh/stars/star_construction.hpp"
#include "asterism/mesh/stars/star_oracle.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal {

class star_set {
 public:
  star_set() = default;
  // Stars from elsewhere, taken as they are: all stale, but those named, which count as unsettled.
  explicit star_set(std::vector<star> stars, const std::vector<vertex_index>& unsettled = {});

  // Polls it while many stars are made; once it is requested the rest stay as they are: stale, and
  // empty if they are new. Whoever sets it ends refinement then.
  void cancel_by(cancellation cancelled) { cancelled_ = std::move(cancelled); }

  // Gives up making many stars once the kernel was asked twice what is done for so many sites, and
  // so many given vertices among them (stars/work_limit.hpp); the rest stay as they are, as above.
  void bound_work(std::size_t given) { given_ = given; }

  // How many stars were never made: empty.
  std::size_t stars_missing() const;

  vertex_index size() const { return static_cast<vertex_index>(stars_.size()); }
  const star& operator[](vertex_index v) const { return stars_[v]; }
  bool is_stale(vertex_index v) const { return condition_[v] == condition::stale; }
  // The star is known to be final (stars/star_finality.hpp) as far as the sites go that there were
  // then.
  bool is_confirmed(vertex_index v) const { return final_[v].against != 0; }
  // Construction met its bound: the star violates (a) or (b) and is a defect of the mesh.
  bool is_unsettled(vertex_index v) const { return condition_[v] == condition::unsettled; }

  // Replaces everything: one star per site of the oracle, each constructed by itself.
  void construct_all(const site_oracle& oracle);
  // The oracle's last site is new: offers it to the other stars and constructs its own. If it
  // splits a boundary subsegment, call split_subsegment instead.
  void add_last(const site_oracle& oracle);
  // The sites from `first` on are new, none of them on the boundary: their stars, and those of the
  // sites they disturb, are made anew, in parallel.
  void add_many(const site_oracle& oracle, vertex_index first);
  // The oracle's last site m has just split the subsegment a -> b of the boundary, which already
  // knows, and its twin if there is one.
  void split_subsegment(const site_oracle& oracle, vertex_index a, vertex_index m, vertex_index b);
  // Constructs the star of v anew. Returns whether there is anything new to know of it: its
  // neighbours changed, or it did not settle.
  bool rebuild(const site_oracle& oracle, vertex_index v,
               star_search search = star_search::thorough);
  // The same for each of `which`, in parallel: those of which there is anything new to know, in
  // their order. No index twice.
  std::vector<vertex_index> construct(const site_oracle& oracle,
                                      const std::vector<vertex_index>& which, star_search search);

  // The stars changed since this was last asked, and those they had as neighbours: whatever was
  // known of a triangle at one of these sites is to be looked at again. May hold an index twice.
  std::vector<vertex_index> take_touched() { return std::exchange(touched_, {}); }

 private:
  enum class condition : unsigned char { settled, stale, unsettled };
  // The star, as it is, is final (stars/star_finality.hpp) as far as the first `against` sites go;
  // none of them: not known. The reach is rounded up.
  struct finality {
    vertex_index against = 0;
    float reach = 0;
  };

  struct made_star {
    vertex_index at;
    constructed_star built;
  };

  double part_of_work_bound(const site_oracle& oracle) const;
  std::vector<made_star> construct_block(const site_oracle& oracle,
                                         std::span<const vertex_index> which, star_search search,
                                         const site_index* latest, std::size_t in_all);
  std::optional<constructed_star> remake(const site_oracle& oracle, vertex_index v,
                                         star_search search, const site_index* latest);
  bool confirm(const site_oracle& oracle, vertex_index v, const site_index& latest);
  void remove_hidden(const site_oracle& oracle, vertex_index a, vertex_index b);
  bool is_news(vertex_index v, const constructed_star& built) const;
  void mark_stale(vertex_index v);
  void note_final(vertex_index v, vertex_index against, const std::optional<double>& reach);
  site_index latest_sites(const site_oracle& oracle, const std::vector<vertex_index>& which) const;
  bool is_still_final(const site_oracle& oracle, vertex_index v, const site_index& latest) const;
  void accept(const site_oracle& oracle, vertex_index v, constructed_star built);
  void touch(vertex_index v);  // before a change of v's star

  cancellation cancelled_;
  std::optional<std::size_t> given_;
  std::vector<vertex_index> touched_;
  std::vector<star> stars_;
  std::vector<condition> condition_;
  std::vector<finality> final_;
};

}  // namespace asterism::internal
