// SPDX-License-Identifier: MIT
#include "asterism/mesh/stars/star_set.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include "asterism/mesh/numerics/metric_box.hpp"
#include "asterism/mesh/stars/averaged_metric_triangulation.hpp"
#include "asterism/mesh/stars/equal_metric_stars.hpp"
#include "asterism/mesh/stars/star_finality.hpp"
#include "asterism/mesh/stars/star_insertion.hpp"
#include "asterism/mesh/stars/work_limit.hpp"
#include "asterism/mesh/support/parallel.hpp"
#include "asterism/mesh/support/sort_unique.hpp"

namespace asterism::internal {
namespace {

// Work limit of making all stars, as a multiple of the refinement's limit. It is above 1, so that
// the refinement ends by its own limit first.
constexpr double most_work = 1.1;
// Least number of sites for which guesses of stars are made.
constexpr vertex_index worth_guessing = 100;

// Returns the stars that a new site is offered to: those of its own neighbours, since in most cases
// a site belongs to the stars of its neighbours. A thorough search finds the stars that this choice
// misses (stars/star_construction.hpp).
std::vector<vertex_index> candidate_stars(const site_oracle& oracle, vertex_index w,
                                          const star& own) {
  // Radius of the search, as a multiple of the farthest vertex's distance: twice holds all
  // neighbours where metrics are equal, and a tenth more holds most where they vary
  // (docs/results/constants.md).
  constexpr double reach_of_candidates = 2.2;
  std::vector<vertex_index> candidates;
  const proximity* near = oracle.near();
  const double reach = near == nullptr
                           ? std::numeric_limits<double>::infinity()
                           : reach_of_candidates * farthest_known_vertex(oracle, w, own);
  if (near == nullptr || !(reach < std::numeric_limits<double>::infinity())) {
    for (vertex_index v = 0; v < oracle.size(); ++v)
      if (v != w) candidates.push_back(v);
    return candidates;
  }
  const bounding_box box = box_around(oracle.sites()[w], reach);
  near->sites().visit_box(oracle.sites(), box.low, box.high, [&](vertex_index v) {
    if (v != w && oracle.squared_distance(w, v) <= reach * reach) candidates.push_back(v);
    return true;
  });
  for (const sector& part : own.sectors)
    candidates.insert(candidates.end(), part.neighbours.begin(), part.neighbours.end());
  sort_unique(candidates);
  return candidates;
}

// Returns the sector of a boundary star with its ends replaced. Drops neighbours that the moved ray
// leaves outside; the others keep their order.
sector with_ends(const site_oracle& oracle, vertex_index v, const sector& old, vertex_index first,
                 vertex_index last) {
  sector moved{{first, last}, false};  // may be a slit
  for (std::size_t i = 1; i + 1 < old.size(); ++i) {
    const vertex_index u = old.neighbours[i];
    if (u == first || u == last) continue;
    const placement where = locate(oracle, v, moved, u);
    if (where.kind == placement_kind::in_gap)
      moved.neighbours.insert(moved.neighbours.begin() + static_cast<std::ptrdiff_t>(where.at + 1),
                              u);
  }
  return moved;
}

// Replaces the end `whole` of a subsegment at v by `part`. The subsegment is at the start of a
// corner, at the end of one, or both.
void replace_end(const site_oracle& oracle, vertex_index v, star& at_v, vertex_index whole,
                 vertex_index part) {
  for (sector& s : at_v.sectors) {
    if (s.closed) continue;
    const bool starts = s.neighbours.front() == whole, ends = s.neighbours.back() == whole;
    if (starts || ends)
      s = with_ends(oracle, v, s, starts ? part : s.neighbours.front(),
                    ends ? part : s.neighbours.back());
  }
}

}  // namespace

star_set::star_set(std::vector<star> stars, const std::vector<vertex_index>& unsettled)
    : stars_(std::move(stars)), condition_(stars_.size(), condition::stale), final_(stars_.size()) {
  for (const vertex_index v : unsettled) condition_[v] = condition::unsettled;
}

void star_set::construct_all(const site_oracle& oracle, const neighbour_lists& guesses,
                             star_confirmation confirmed) {
  stars_.clear();
  condition_.clear();
  final_.clear();
  add_empty_stars(oracle.size());
  if (auto made = stars_of_equal_metrics(oracle, cancelled_)) {
    for (vertex_index v = 0; v < oracle.size(); ++v) accept(oracle, v, std::move((*made)[v]));
    return;
  }
  std::vector<vertex_index> all;
  if (oracle.near() != nullptr) {
    all = oracle.near()->order_anew(oracle.sites());
  } else {
    all.resize(oracle.size());
    std::iota(all.begin(), all.end(), vertex_index{0});
  }
  const bool guess =
      guesses.size() == 0 && oracle.size() >= worth_guessing && oracle.near() != nullptr;
  const neighbour_lists own = guess ? guess_neighbours(oracle, cancelled_) : neighbour_lists();
  guesses_ = guess ? &own : &guesses;
  const bool is_own_guess = guess && confirmed == star_confirmation::by_auditor;
  confirmed_ = is_own_guess ? star_confirmation::by_auditor_if_lengths_agree : confirmed;
  construct(oracle, all, star_search::near);
  guesses_ = nullptr;
}

// Adds empty stars up to this number. Reserves room for a few more only: doubled room would exceed
// the memory limit of a large mesh.
void star_set::add_empty_stars(std::size_t size) {
  if (size > stars_.capacity()) {
    const std::size_t room = size + size / 16;
    stars_.reserve(room);
    condition_.reserve(room);
    final_.reserve(room);
  }
  stars_.resize(size);
  condition_.resize(size, condition::stale);
  final_.resize(size);
}

void star_set::touch(vertex_index v) { touch(v, stars_[v]); }

void star_set::touch(vertex_index v, const star& before) {
  std::vector<vertex_index>& neighbours = touched_.neighbours_before;
  touched_.changed.push_back(v);
  for (const sector& part : before.sectors)
    neighbours.insert(neighbours.end(), part.neighbours.begin(), part.neighbours.end());
}

double star_set::part_of_work_bound(const site_oracle& oracle) const {
  if (work_units(oracle.kernel().counters()) > most_of_run_)
    return std::numeric_limits<double>::infinity();
  if (!given_) return 0;
  return asterism::internal::part_of_work_bound(oracle.kernel().counters(), oracle.size(),
                                                *given_) /
         work_share_;
}

// Returns the work limit, in units, for making all stars.
double star_set::most_units(const site_oracle& oracle) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double own =
      given_ ? most_work * work_share_ * most_work_units(oracle.size(), *given_) : infinity;
  return std::min(own, most_of_run_);
}

std::size_t star_set::stars_missing() const {
  return static_cast<std::size_t>(
      std::count_if(stars_.begin(), stars_.end(), [](const star& s) { return s.sectors.empty(); }));
}

// Makes stars block by block and checks the work done in between. Blocks grow while their work is
// small, up to a size at which the new stars beside the old ones take little memory. A star left
// out of a block whose work was used up comes first in the next block.
std::vector<vertex_index> star_set::construct(const site_oracle& oracle,
                                              const std::vector<vertex_index>& which,
                                              star_search search) {
  constexpr std::size_t first_block = 256, careful_block = 128, largest_block = 32768;
  constexpr double much = 0.25;
  const bool confirm = search == star_search::thorough && oracle.near() != nullptr;
  most_of_run_ = work_units(oracle.kernel().counters()) + cancelled_.units_left();
  const site_index latest = confirm ? latest_sites(oracle, which) : site_index();
  std::vector<vertex_index> changed;
  std::vector<vertex_index> waiting(which.rbegin(), which.rend());  // the last one is the next
  std::size_t block = first_block;
  while (!waiting.empty() && !cancelled_.is_requested()) {
    const double part = part_of_work_bound(oracle);
    if (part > most_work) break;
    const std::size_t count = std::min(waiting.size(), part > much ? careful_block : block);
    const auto first = waiting.end() - static_cast<std::ptrdiff_t>(count);
    const std::vector<vertex_index> now(waiting.rbegin(), std::make_reverse_iterator(first));
    waiting.erase(first, waiting.end());
    std::vector<made_star> more =
        construct_block(oracle, now, search, confirm ? &latest : nullptr, which.size());
    const std::size_t left = waiting.size();
    for (auto m = more.rbegin(); m != more.rend(); ++m)
      if (!m->built) waiting.push_back(m->at);
    if (waiting.size() - left == count) break;
    for (made_star& m : more) {
      if (!m.built) continue;
      changed.push_back(m.at);
      accept(oracle, m.at, *std::move(m.built));
    }
    block = std::min(2 * block, largest_block);
  }
  return changed;
}

// Makes one block of stars. Returns those that changed or did not settle, and those left for later:
// each thread has an equal part of the work that is left. `latest` is given if settled stars are to
// be confirmed; `in_all` is the number of stars in all blocks.
std::vector<star_set::made_star> star_set::construct_block(const site_oracle& oracle,
                                                           std::span<const vertex_index> which,
                                                           star_search search,
                                                           const site_index* latest,
                                                           std::size_t in_all) {
  constexpr std::size_t chunk = 64;
  const bool is_alone = in_all <= chunk;
  const double done = work_units(oracle.kernel().counters());
  const double part =
      (most_units(oracle) - done) / static_cast<double>(chunk_count(which.size(), chunk));
  std::vector<tier_counters> counts(chunk_count(which.size(), chunk));
  std::vector<made_star> all = collect_chunks<made_star>(
      which.size(), chunk, [&](std::size_t begin, std::size_t end, std::vector<made_star>& out) {
        const auto kernel = oracle.kernel().fork(counts[begin / chunk]);
        // Uses the common cache of answers if stars are few: this thread then makes them alone.
        star_work_guard guard(cancelled_, is_alone ? done + part : part);
        edge_test_cache memory(edge_test_cache::extent::few);
        const site_oracle own =
            (is_alone ? oracle : oracle.with_kernel(*kernel, &memory)).guarded_by(guard);
        for (std::size_t i = begin; i < end; ++i) {
          constexpr std::size_t at_a_time = 8;
          const bool cancelled = i % at_a_time == 0 && cancelled_.is_requested();
          auto built =
              cancelled || own.is_over() ? std::nullopt : remake(own, which[i], search, latest);
          if (cancelled || own.is_over()) {
            for (; i < end; ++i) out.push_back({which[i], std::nullopt});
            break;
          }
          if (built) out.push_back({which[i], std::move(built)});
        }
      });
  for (const tier_counters& c : counts) oracle.kernel().counters() += c;
  return all;
}

// Constructs the star of v, unless it is settled and known to be final. Returns the new star if its
// neighbours changed or it did not settle.
std::optional<constructed_star> star_set::remake(const site_oracle& oracle, vertex_index v,
                                                 star_search search, const site_index* latest) {
  if (latest != nullptr && condition_[v] == condition::settled && confirm(oracle, v, *latest))
    return std::nullopt;
  const std::span<const vertex_index> others = exchanged_.of(v);
  if (exchanged_.which != nullptr && !accepts_any(oracle, v, others)) return std::nullopt;
  star_proposal proposed;
  if (guesses_ != nullptr) {
    proposed.guess = (*guesses_)[v];
    proposed.is_plain = guesses_->is_marked(v);
  }
  proposed.confirmed = confirmed_;
  proposed.others = others;
  constructed_star built = construct_star(oracle, v, search, proposed);
  if (is_news(v, built)) return built;
  condition_[v] = condition::settled;
  note_final(v, oracle.size(), built.final_reach);
  return std::nullopt;
}

std::span<const vertex_index> star_set::exchanged::of(vertex_index v) const {
  if (which == nullptr) return {};
  const auto at = std::lower_bound(which->begin(), which->end(), v);
  return (*others)[static_cast<std::size_t>(at - which->begin())];
}

bool star_set::accepts_any(const site_oracle& oracle, vertex_index v,
                           std::span<const vertex_index> others) const {
  return std::any_of(others.begin(), others.end(), [&](vertex_index w) {
    return w != v && !stars_[v].contains(w) && would_accept(oracle, v, stars_[v], w);
  });
}

std::vector<vertex_index> star_set::exchange(const site_oracle& oracle,
                                             const std::vector<vertex_index>& which,
                                             const neighbour_lists& others) {
  exchanged_ = {&which, &others};
  std::vector<vertex_index> changed = construct(oracle, which, star_search::near);
  exchanged_ = {};
  return changed;
}

// True if the settled star of v is final against all sites; records that.
bool star_set::confirm(const site_oracle& oracle, vertex_index v, const site_index& latest) {
  if (is_still_final(oracle, v, latest))
    final_[v].against = oracle.size();
  else
    note_final(v, oracle.size(), final_reach(oracle, v, stars_[v]));
  return final_[v].against != 0;
}

void star_set::mark_stale(vertex_index v) {
  condition_[v] = condition::stale;
  final_[v] = {};
}

void star_set::note_final(vertex_index v, vertex_index against,
                          const std::optional<double>& reach) {
  final_[v] = {};
  if (!reach) return;
  // Range of squared reaches that are rounded up to a float: within it the float after the next one
  // is no less than the double, in any floating-point environment.
  constexpr double least = 0x1p-100, most = 0x1p100;
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const auto above = [](double x) { return std::nextafter(static_cast<float>(x), infinity); };
  final_[v] = {against, *reach < most ? above(std::max(*reach, least)) : infinity};
}

// Returns an index of the sites that were added after the first of these stars was found to be
// final. The index is empty if these sites are too many for it to pay; is_still_final() detects
// that.
site_index star_set::latest_sites(const site_oracle& oracle,
                                  const std::vector<vertex_index>& which) const {
  vertex_index first = oracle.size();
  for (const vertex_index v : which)
    if (final_[v].against != 0) first = std::min(first, final_[v].against);
  site_index latest(oracle.near()->box());
  if (oracle.size() - first <= oracle.size() / 2)
    for (vertex_index w = first; w < oracle.size(); ++w) latest.insert(oracle.sites(), w);
  return latest;
}

// True if no site that was added after v's star was found to be final is in its reach.
bool star_set::is_still_final(const site_oracle& oracle, vertex_index v,
                              const site_index& latest) const {
  const finality& then = final_[v];
  if (then.against == oracle.size()) return true;
  if (then.against == 0 || latest.size() < oracle.size() - then.against) return false;
  return latest.visit_reach(oracle.sites(), oracle.sites()[v], static_cast<double>(then.reach),
                            [&](vertex_index w) { return w < then.against; });
}

void star_set::add_last(const site_oracle& oracle) {
  const vertex_index w = oracle.size() - 1;
  add_empty_stars(oracle.size());
  rebuild(oracle, w, star_search::near);
  const std::vector<vertex_index> candidates = candidate_stars(oracle, w, stars_[w]);
  candidates_ += candidates.size();
  bool is_over = part_of_work_bound(oracle) > most_work;
  for (const vertex_index v : candidates) {
    if (stars_[v].contains(w)) continue;
    if (is_over) {
      mark_stale(v);  // nobody asked whether it would accept w
      continue;
    }
    const star before = stars_[v];
    const bool is_changed = offer(oracle, v, stars_[v], w);
    is_over = part_of_work_bound(oracle) > most_work;
    if (!is_changed) continue;
    mark_stale(v);
    touch(v, before);
  }
}

void star_set::add_many(const site_oracle& oracle, vertex_index first) {
  add_empty_stars(oracle.size());
  std::vector<vertex_index> added(oracle.size() - first);
  std::iota(added.begin(), added.end(), first);
  construct(oracle, added, star_search::near);
  constexpr std::size_t chunk = 16;
  std::vector<tier_counters> counts(chunk_count(added.size(), chunk));
  const double part = (most_units(oracle) - work_units(oracle.kernel().counters())) /
                      static_cast<double>(counts.size());
  std::vector<vertex_index> disturbed = collect_chunks<vertex_index>(
      added.size(), chunk, [&](std::size_t begin, std::size_t end, std::vector<vertex_index>& out) {
        const auto kernel = oracle.kernel().fork(counts[begin / chunk]);
        star_work_guard guard(cancelled_, part);
        const site_oracle own = oracle.with_kernel(*kernel).guarded_by(guard);
        // Lists a star that was not tested, at the work limit, like one that accepts a site: both
        // are made anew.
        for (std::size_t i = begin; i < end; ++i)
          for (const vertex_index v : candidate_stars(own, added[i], stars_[added[i]]))
            if (v < first && (own.is_over() || would_accept(own, v, stars_[v], added[i])))
              out.push_back(v);
      });
  for (const tier_counters& c : counts) oracle.kernel().counters() += c;
  sort_unique(disturbed);
  for (const vertex_index v : disturbed) mark_stale(v);
  construct(oracle, disturbed, star_search::near);
}

void star_set::split_subsegment(const site_oracle& oracle, vertex_index a, vertex_index m,
                                vertex_index b) {
  touch(a);
  touch(b);
  replace_end(oracle, a, stars_[a], b, m);
  replace_end(oracle, b, stars_[b], a, m);
  mark_stale(a);
  mark_stale(b);
  // Searches for hidden sites only if m was rounded to an inner side: then m can hide sites from
  // each other. If m was rounded to the outer side, only a and b can see each other for the first
  // time, and their stars are stale already: a segment that enters the sliver a, m, b through a b
  // can only end in m. For an internal subsegment both happen.
  const sign turn = oracle.orientation(a, b, m);
  if (turn == sign::positive || (turn == sign::negative && oracle.edges().is_subsegment(m, a))) {
    remove_hidden(oracle, a, m);
    remove_hidden(oracle, m, b);
  }
  add_last(oracle);
}

bool star_set::is_news(vertex_index v, const constructed_star& built) const {
  return stars_[v] != built.content || !built.settled;
}

void star_set::accept(const site_oracle& oracle, vertex_index v, constructed_star built) {
  touch(v);
  note_final(v, oracle.size(), built.final_reach);
  condition_[v] = built.settled ? condition::settled : condition::unsettled;
  stars_[v] = std::move(built.content);
}

bool star_set::rebuild(const site_oracle& oracle, vertex_index v, star_search search) {
  star_work_guard guard(cancelled_, most_units(oracle));
  constructed_star built = construct_star(oracle.guarded_by(guard), v, search);
  const bool changed = is_news(v, built);
  accept(oracle, v, std::move(built));
  return changed;
}

// Removes from all stars the edges that cross the subsegment a b, which a split has just made. Only
// sites near it can have such edges, as rounding moved the split point only a little.
void star_set::remove_hidden(const site_oracle& oracle, vertex_index a, vertex_index b) {
  const auto remove = [&](vertex_index v) {
    for (sector& s : stars_[v].sectors)
      for (std::size_t i = s.size(); i-- > 0;) {
        if (s.is_forced(i) || !oracle.crosses(v, s.neighbours[i], a, b)) continue;
        touch(v);
        s.neighbours.erase(s.neighbours.begin() + static_cast<std::ptrdiff_t>(i));
        mark_stale(v);
      }
    return true;
  };
  if (oracle.near() == nullptr) {
    for (vertex_index v = 0; v < size(); ++v) remove(v);
    return;
  }
  const bounding_box box = influence_box(oracle.sites()[a], oracle.sites()[b]);
  oracle.near()->sites().visit_box(oracle.sites(), box.low, box.high,
                                   [&](vertex_index v) { return v >= size() || remove(v); });
}

}  // namespace asterism::internal
