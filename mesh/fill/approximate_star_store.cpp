// SPDX-License-Identifier: MIT
#include "asterism/mesh/fill/approximate_star_store.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "asterism/mesh/numerics/constructions.hpp"
#include "asterism/mesh/numerics/metric_box.hpp"
#include "asterism/mesh/support/parallel.hpp"
#include "asterism/mesh/support/prefetch.hpp"
#include "asterism/mesh/support/sort_unique.hpp"

namespace asterism::internal {
namespace {

constexpr std::size_t stars_a_chunk = 256;
constexpr std::size_t ahead = 4;

// True if x follows y in the star.
bool has_gap(const approximate_star& star, vertex_index y, vertex_index x) {
  for (std::size_t i = 0; i < star.size(); ++i)
    if (star[i].neighbour == y) return star[following(star, i)].neighbour == x;
  return false;
}

void add_neighbours(const approximate_star& star, std::vector<vertex_index>& to) {
  for (const approximate_gap& gap : star) to.push_back(gap.neighbour);
}

bool has_neighbour(const approximate_star& star, vertex_index w) {
  return std::any_of(star.begin(), star.end(),
                     [w](const approximate_gap& gap) { return gap.neighbour == w; });
}

// Concatenates, in order, what append(begin, end, claims) adds to `claims` for each chunk.
template <class Append>
void collect_claims(std::size_t count, claim_list& claims, const Append& append) {
  const auto found_in = [&append](std::size_t begin, std::size_t end) {
    claim_list found;
    append(begin, end, found);
    return found;
  };
  for (const claim_list& part : map_chunks<claim_list>(count, stars_a_chunk, found_in))
    claims.append(part);
}

}  // namespace

// Makes the stars with claims anew: make(star, claimants) builds each from its neighbours and the
// sites that claim it.
template <class Make>
void approximate_star_store::make_anew(const claims_by_star& all, const Make& make) {
  parallel_chunks(all.stars.size(), stars_a_chunk,
                  [&](std::size_t, std::size_t begin, std::size_t end) {
                    std::vector<vertex_index> candidates;
                    std::uint64_t looked_at = 0;
                    for (std::size_t i = begin; i < end; ++i) {
                      if (is_enough(i)) break;
                      if (i + ahead < end) {
                        prefetch_star(all.stars[i + ahead]);
                        for (const vertex_index w : all.of(i + ahead)) prefetch_star(w);
                      }
                      const vertex_index v = all.stars[i];
                      candidates.clear();
                      add_neighbours(stars_[v], candidates);
                      const auto more = all.of(i);
                      candidates.insert(candidates.end(), more.begin(), more.end());
                      looked_at += candidates.size();
                      stars_[v] = make(v, candidates);
                    }
                    work_->count_candidates(looked_at);
                  });
}

bool approximate_star_store::renew(double distance) {
  // Number of stars made between two readings of the work meter, before and after a quarter of the
  // work limit is reached. Claims are joined block by block, as all at once would take much
  // memory.
  constexpr std::size_t ordinary_block = 65536, late_block = 1024;
  constexpr std::uint64_t quarter = 4;
  const std::size_t count = sites_->size();
  if (count > claim_list::most_sites) return false;
  stars_.resize(count);
  claim_list disturbed;
  for (std::size_t at = finished_; at < count;) {
    const std::size_t block = work_->is_overworked(count, quarter) ? late_block : ordinary_block;
    const std::size_t end = std::min(count, at + block);
    const std::size_t claims = disturbed.size();
    make_stars(at, end, distance, disturbed);
    // Limits the room reserved for claims, as a number for each star still to be made: the first
    // stars may disturb more than later ones.
    constexpr std::size_t likely = 8;
    if (claims == 0)
      disturbed.reserve(
          std::min(disturbed.entries() * ((count - at) / (end - at) + 1), likely * (count - at)));
    work_->count_disturbed(disturbed.size() - claims);
    at = end;
    if (work_->is_overworked(count)) return false;
  }
  changed_.clear();
  renew_disturbed(disturbed);
  for (; finished_ < count; ++finished_) changed_.push_back(static_cast<vertex_index>(finished_));
  return true;
}

void approximate_star_store::mark_all_changed() {
  changed_.resize(stars_.size());
  std::iota(changed_.begin(), changed_.end(), vertex_index{0});
}

bool approximate_star_store::agrees_with_neighbours(vertex_index v) const {
  const approximate_star& star = stars_[v];
  for (std::size_t i = 0; i < star.size(); ++i) {
    const vertex_index y = star[i].neighbour, x = star[following(star, i)].neighbour;
    if (is_between_segments(v, y, x)) continue;
    if (!has_gap(stars_[y], x, v) || !has_gap(stars_[x], v, y)) return false;
  }
  return true;
}

bool approximate_star_store::is_between_segments(vertex_index v, vertex_index y,
                                                 vertex_index x) const {
  return sites_->is_on_segment(v) && sites_->is_on_segment(y) && sites_->is_on_segment(x);
}

// Returns for each star whether it agrees with its neighbours. Each triangle is looked up in the
// star of its next corner only: that corner looks it up in the third one's.
std::vector<char> approximate_star_store::which_agree(
    const std::vector<vertex_index>& order) const {
  const std::vector<vertex_index> those_not = collect_chunks<vertex_index>(
      order.size(), stars_a_chunk,
      [&](std::size_t begin, std::size_t end, std::vector<vertex_index>& out) {
        for (std::size_t i = begin; i < end; ++i) note_disagreeing(order[i], out);
      });
  std::vector<char> agrees(stars_.size(), 1);
  for (const vertex_index v : those_not) agrees[v] = 0;
  return agrees;
}

void approximate_star_store::note_disagreeing(vertex_index v,
                                              std::vector<vertex_index>& out) const {
  const approximate_star& star = stars_[v];
  for (std::size_t i = 0; i < star.size(); ++i) {
    const vertex_index y = star[i].neighbour, x = star[following(star, i)].neighbour;
    if (is_between_segments(v, y, x) || has_gap(stars_[y], x, v)) continue;
    out.push_back(v);
    if (has_gap(stars_[x], v, y)) out.push_back(x);
  }
}

void approximate_star_store::follow_moves(const std::vector<vertex_index>& order) {
  make_anew({order, std::vector<std::uint32_t>(order.size() + 1, 0), {}},
            [&](vertex_index v, const std::vector<vertex_index>& candidates) {
              return build_approximate_star(sites_->all(), v, candidates);
            });
  make_anew(sort_by_star(new_neighbours(order), 0, stars_.size()),
            [&](vertex_index v, const std::vector<vertex_index>& candidates) {
              return build_approximate_star(sites_->all(), v, candidates, stars_[v]);
            });
}

// Returns the pairs y, x such that the star of y lacks x, although x follows y in a star. The pairs
// x, y come from the star on the other side of the edge.
claim_list approximate_star_store::new_neighbours(const std::vector<vertex_index>& order) const {
  claim_list lacking;
  collect_claims(order.size(), lacking, [&](std::size_t begin, std::size_t end, claim_list& out) {
    for (std::size_t i = begin; i < end; ++i) {
      const approximate_star& star = stars_[order[i]];
      for (std::size_t k = 0; k < star.size(); ++k) {
        const vertex_index y = star[k].neighbour, x = star[following(star, k)].neighbour;
        if (!has_neighbour(stars_[y], x)) out.add(y, x);
      }
    }
  });
  return lacking;
}

std::vector<char> approximate_star_store::mend_disagreeing(const std::vector<vertex_index>& order) {
  std::vector<char> agrees = which_agree(order);
  const claims_by_star all = sort_by_star(claims_on_disagreeing(agrees), 0, stars_.size());
  make_anew(all, [&](vertex_index v, const std::vector<vertex_index>& candidates) {
    return build_careful_star(sites_->all(), v, candidates);
  });
  // Compares again only the stars made anew and their neighbours: others have not changed.
  std::vector<vertex_index> to_compare = all.stars;
  to_compare.insert(to_compare.end(), all.by.begin(), all.by.end());
  sort_unique(to_compare);
  for (const vertex_index v : to_compare) agrees[v] = agrees_with_neighbours(v) ? 1 : 0;
  return agrees;
}

// Returns the stars that do not agree with their neighbours, each with the sites whose stars have
// its centre as a neighbour.
claim_list approximate_star_store::claims_on_disagreeing(const std::vector<char>& agrees) const {
  claim_list claims;
  collect_claims(stars_.size(), claims, [&](std::size_t begin, std::size_t end, claim_list& out) {
    for (std::size_t v = begin; v < end; ++v)
      for (const approximate_gap& gap : stars_[v])
        if (agrees[gap.neighbour] == 0) out.add(gap.neighbour, static_cast<vertex_index>(v));
  });
  return claims;
}

// Makes the stars of the sites from `first` to before `last`; adds which stars of older sites they
// disturb. Sites placed together follow a curve (fill/site_proposals.hpp), so that data read for
// one star is in the cache for the next.
void approximate_star_store::make_stars(std::size_t first, std::size_t last, double distance,
                                        claim_list& disturbed) {
  collect_claims(last - first, disturbed, [&](std::size_t begin, std::size_t end, claim_list& out) {
    std::vector<vertex_index> near;
    std::uint64_t looked_at = 0, gaps = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const auto w = static_cast<vertex_index>(first + i);
      if (is_enough(i)) break;
      make_star(w, distance, near, looked_at);
      gaps += stars_[w].size();
      for (const vertex_index u : near) {
        if (u >= finished_) continue;
        gaps += stars_[u].size();
        if (disturbs(sites_->all(), u, stars_[u], w)) out.add(u, w);
      }
    }
    work_->count_candidates(looked_at);
    work_->count_gaps(gaps);
  });
}

// Makes each disturbed star anew from its neighbours and the sites that disturb it, and adds it to
// changed_. Works in parts, since a run has its peak of memory here.
void approximate_star_store::renew_disturbed(const claim_list& disturbed) {
  constexpr std::size_t most_parts = 4, claims_for_a_part = 65536;
  const std::size_t parts = std::min(most_parts, 1 + disturbed.size() / claims_for_a_part);
  for (std::size_t part = 0; part < parts; ++part) {
    const claims_by_star claims =
        sort_by_star(disturbed, finished_ * part / parts, finished_ * (part + 1) / parts);
    make_anew(claims, [&](vertex_index v, const std::vector<vertex_index>& candidates) {
      return build_approximate_star(
          sites_->all(), v, candidates, stars_[v],
          [&](approximate_gap& gap, vertex_index next) { return take_from_new(v, gap, next); });
    });
    changed_.insert(changed_.end(), claims.stars.begin(), claims.stars.end());
  }
}

// Copies the Voronoi vertex of a gap of an older site v from the star of a new site beside that
// gap, if it has the same triangle. Stars of new sites do not change while older ones are renewed.
bool approximate_star_store::take_from_new(vertex_index v, approximate_gap& gap,
                                           vertex_index next) const {
  const auto take = [&](vertex_index w, vertex_index first, vertex_index second) {
    // Largest number of gaps of a star that is searched: beyond it, computing the vertex again
    // costs less.
    constexpr std::size_t most_gaps = 16;
    if (w < finished_ || stars_[w].size() > most_gaps) return false;
    const approximate_star& star = stars_[w];
    for (std::size_t i = 0; i < star.size(); ++i)
      if (star[i].neighbour == first)
        return star[following(star, i)].neighbour == second &&
               take_vertex(sites_->all(), v, gap, next, w, star[i]);
    return false;
  };
  return take(gap.neighbour, next, v) || take(next, v, gap.neighbour);
}

bool approximate_star_store::is_enough(std::size_t i) const {
  constexpr std::size_t at_a_time = 8;
  return i % at_a_time == 0 && options_->stop.is_requested();
}

// Adds the sites that are within `reach` of w and not within `known`, in w's metric; if the reach
// covers about the whole box, all sites not within `known`. Returns whether it covers the box.
bool approximate_star_store::find_near(vertex_index w, double known, double reach,
                                       std::vector<vertex_index>& near,
                                       std::uint64_t& looked_at) const {
  const site& s = (*sites_)[w];
  const bounding_box box = box_around(s, reach);
  const bool all = box.low.x <= box_.low.x && box.low.y <= box_.low.y &&
                   box.high.x >= box_.high.x && box.high.y >= box_.high.y;
  const double squared_known = known < 0 ? known : known * known;
  const double squared_reach = reach * reach;
  std::size_t count = near.size();
  // Writes every site to near[count], but counts only those that are to be added: branches would be
  // mispredicted.
  sites_->index().visit_clusters(
      sites_->all(), box, [&](std::span<const point> places, std::span<const vertex_index> which) {
        looked_at += places.size();
        if (near.size() < count + places.size()) near.resize(2 * (count + places.size()));
        for (std::size_t i = 0; i < places.size(); ++i) {
          const double squared = squared_distance(s, places[i]);
          near[count] = which[i];
          count += std::size_t{which[i] != w} & std::size_t{!(squared <= squared_known)} &
                   (std::size_t{all} | std::size_t{squared <= squared_reach});
        }
        return true;
      });
  near.resize(count);
  return all;
}

// Makes the star of w from all sites within a reach beyond which none could belong to it, and
// leaves these sites in `near`.
//
// Where metrics are equal, a site that changes a star is nearer to one of its Voronoi vertices than
// the centre is. If that vertex is at distance r, the site is within 2 r of the centre. The 5 %
// beyond are for metrics that vary. The first reach is large enough for stars whose vertices are
// all within 1.05 times `distance`, as most are when their level is done. Multiples of 1.5, 2, 2.5
// and 3 in place of 2.1 were tried: they led to between 0.2 % fewer and 4 % more sites.
void approximate_star_store::make_star(vertex_index w, double distance,
                                       std::vector<vertex_index>& near, std::uint64_t& looked_at) {
  constexpr double diameters = 2.1, first_reach = 2.2;
  constexpr double margin = 1.02, least_growth = 1.25;
  // Least number of neighbours that surround a site.
  constexpr std::size_t least_neighbours = 3;
  // Largest number of searches for one site. Each doubles the reach, which leaves the box, or the
  // range of doubles, long before.
  constexpr int most_attempts = 64;
  const double ordinary = first_reach * distance;
  double reach = std::min(ordinary, first_reach_among_dense(w, distance));
  near.clear();
  double known = -1;  // nothing
  for (int attempt = 1; attempt <= most_attempts; ++attempt) {
    const std::size_t before = near.size();
    const bool all = find_near(w, known, reach, near, looked_at);
    known = reach;
    for (std::size_t i = before; i < near.size(); ++i)
      if (near[i] < finished_) prefetch_star(near[i]);
    if (near.size() < least_neighbours && !all) {
      reach *= 2;
      continue;
    }
    if (stars_[w].empty())
      stars_[w] = build_approximate_star(sites_->all(), w, near);
    else
      extend_star(w, std::span(near).subspan(before));
    const double wanted = diameters * farthest_vertex(w, attempt >= 2);
    if (all || wanted <= reach || ends_search(w, attempt, reach >= ordinary, near.size())) return;
    reach = std::clamp(margin * wanted, least_growth * reach, 2 * reach);
  }
}

// Prefetches the neighbours of a star with few gaps.
void approximate_star_store::prefetch_star(vertex_index v) const {
  constexpr std::size_t line = 64, most = 4;
  const char* const at = reinterpret_cast<const char*>(&stars_[v]);
  for (std::size_t i = 0; i < most; ++i) prefetch(at + i * line);
}

// Makes the star of w anew from its neighbours and more sites. Other sites that it refused before
// are not offered again.
void approximate_star_store::extend_star(vertex_index w, std::span<const vertex_index> more) {
  std::vector<vertex_index> candidates;
  candidates.reserve(stars_[w].size() + more.size());
  add_neighbours(stars_[w], candidates);
  candidates.insert(candidates.end(), more.begin(), more.end());
  stars_[w] = build_approximate_star(sites_->all(), w, candidates, stars_[w]);
}

// Returns the distance of w from the farthest Voronoi vertex of its star; infinite where a gap has
// none. With leaves_out, gaps of less than half a turn without a vertex are skipped.
double approximate_star_store::farthest_vertex(vertex_index w, bool leaves_out) const {
  const approximate_star& star = stars_[w];
  double squared = 0;
  for (std::size_t i = 0; i < star.size(); ++i) {
    const vertex_index next = star[following(star, i)].neighbour;
    if (star[i].squared_radius > squared &&
        !(leaves_out && lacks_vertex(sites_->all(), w, star[i], next)))
      squared = star[i].squared_radius;
  }
  return std::sqrt(squared);
}

// True if a wider search around w is given up. At the boundary there may be no neighbour on the
// outer side, however wide the search. Where lengths differ by large factors, there may be no
// neighbour beyond sites whose metrics are far denser. The number of sites tested is bounded, too:
// if w is at the rim of many given sites, sites beyond them are far away.
bool approximate_star_store::ends_search(vertex_index w, int attempt, bool is_ordinary,
                                         std::size_t looked_at) const {
  constexpr int enough_attempts = 3;
  constexpr std::size_t many = 512;
  const bool is_late = attempt >= enough_attempts;
  if (!sites_->is_on_segment(w) && !(options_->is_uneven && is_late)) return false;
  return is_ordinary || (is_late && looked_at > many);
}

// Returns the first reach for an isolated vertex w of the domain: a few spacings of the sites
// around it where these are much closer together than the level's distance, so that its star is not
// made from a large part of all sites; infinite elsewhere.
double approximate_star_store::first_reach_among_dense(vertex_index w, double distance) const {
  if (!sites_->is_isolated(w)) return std::numeric_limits<double>::infinity();
  constexpr double much_closer = 0.25, spacings = 2.2;
  const double spacing = sites_->index().spacing_near((*sites_)[w]);
  const bool is_dense = spacing > 0 && spacing < much_closer * distance;
  return is_dense ? spacings * spacing : std::numeric_limits<double>::infinity();
}

std::optional<crowded_site> approximate_star_store::most_crowded() const {
  if (stars_.empty()) return std::nullopt;
  const auto most = std::max_element(
      stars_.begin(), stars_.end(),
      [](const approximate_star& a, const approximate_star& b) { return a.size() < b.size(); });
  const auto at = static_cast<vertex_index>(most - stars_.begin());
  bool has_one_metric = true;
  for (vertex_index v = 1; v < sites_->size(); ++v)
    has_one_metric = has_one_metric && (*sites_)[v].metric == (*sites_)[0].metric;
  return crowded_site{(*sites_)[at].position, most->size(), sites_->size(), has_one_metric};
}

}  // namespace asterism::internal
