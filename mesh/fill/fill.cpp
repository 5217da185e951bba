// SPDX-License-Identifier: MIT
#include "asterism/mesh/fill/fill.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/fill/approximate_star_store.hpp"
#include "asterism/mesh/fill/placed_sites.hpp"
#include "asterism/mesh/fill/relaxation.hpp"
#include "asterism/mesh/fill/segment_division.hpp"
#include "asterism/mesh/fill/segment_intervals.hpp"
#include "asterism/mesh/fill/site_proposals.hpp"
#include "asterism/mesh/fill/work_meter.hpp"
#include "asterism/mesh/metric/field_sampler.hpp"
#include "asterism/mesh/search/hilbert_order.hpp"
#include "asterism/mesh/support/parallel.hpp"

namespace asterism::internal {
namespace {

class filling {
 public:
  filling(const domain& d, const metric_field& field, const fill_options& options,
          std::vector<division> divisions)
      : domain_(d),
        options_(options),
        box_(d.box()),
        sampler_(field),
        sites_(box_, options.max_sites),
        stars_(sites_, box_, options, work_),
        segments_(d, std::move(divisions), sites_),
        parts_{d, box_, field, sites_, segments_, stars_, work_},
        proposals_(parts_, options.is_uneven) {}

  result<filled_domain> run(const fill_progress& progress) {
    const int coarsest = coarsest_level();
    place_vertices();
    if (!is_over()) segments_.start();
    if (options_.is_uneven) begin_unevenly();
    renew_stars(distance_at(coarsest));
    for (int level = coarsest; level >= 0 && !is_over(); --level) {
      if (level < coarsest) reserve_next_level();
      divide_segments_at(level);
      while (!is_over() && rounds_ < most_rounds && goes_on(progress) && round(level)) {
      }
      needed_ = is_over() ? std::max(needed_, static_cast<double>(sites_.size()))
                          : sites_at_last_level(level);
    }
    if (sampler_.failure()) return *sampler_.failure();
    if (failure_) return *failure_;
    if (!options_.is_uneven && goes_on(progress)) relax();
    return std::move(*this).outcome();
  }

 private:
  // Largest number of rounds on one level. Each round but the last inserts a site, so only a run
  // with invalid numbers reaches it.
  static constexpr std::size_t most_rounds = 4000;

  bool is_over() const {
    return sampler_.failure() || failure_ || stopped_ || crowded_ || sites_.is_exhausted();
  }

  // Returns the distance between sites wanted on a level: the final one on level 0, doubled with
  // each level above.
  double distance_at(int level) const { return options_.distance * elementary::exp2(level); }

  // Returns the first level on which no segment is longer than the distance.
  int coarsest_level() const {
    constexpr int most_levels = 40;  // 2^40 sites on a segment are more than can be
    if (options_.is_uneven) return 0;
    const double longest = segments_.longest_segment();
    int level = 0;
    while (level < most_levels && distance_at(level) < longest) ++level;
    return level;
  }

  void place_vertices() {
    for (const point& q : domain_.vertices) {
      const auto s = sampler_.at(q);
      if (!s) return;
      sites_.place(*s, true);
    }
    sites_.mark_isolated(domain_);
  }

  void begin_unevenly() {
    if (!is_over()) segments_.halve(0, sites_, sampler_);
    if (!is_over()) proposals_.scatter(distance_at(0));
  }

  // Brings all stars up to date, unless the fill is over.
  void renew_stars(double distance) {
    if (!is_over()) crowded_ = !stars_.renew(distance);
  }

  // Makes room for the sites of the next level, up to four times as many as now.
  void reserve_next_level() {
    constexpr std::size_t times = 4;
    sites_.reserve(times * sites_.size());
  }

  void divide_segments_at(int level) {
    const double longest = level == 0 ? 0 : options_.longest_subsegment * elementary::exp2(level);
    segments_.halve(longest, sites_, sampler_);
    renew_stars(distance_at(level));
    stars_.mark_all_changed();  // the distance is new as well
  }

  bool goes_on(const fill_progress& progress) {
    if (progress) progress(sites_.size(), needed_);
    const double units = work_.units();
    options_.stop.expect(sites_.size());
    options_.stop.charge(units - std::exchange(charged_, units));
    stopped_ = options_.stop.told().has_value();
    crowded_ = crowded_ || (!stopped_ && !(options_.stop.units_left() > 0));
    return !is_over();
  }

  // Places sites where the stars leave room. Returns false if there was no room, or no site could
  // be placed.
  bool round(int level) {
    ++rounds_;
    auto proposals = proposals_.collect(distance_at(level));
    if (!proposals) {
      failure_ = proposals.failure();
      return false;
    }
    const std::size_t before = sites_.size();
    proposals_.place(std::move(proposals).value(), distance_at(level));
    if (sites_.size() == before) return false;
    renew_stars(distance_at(level));
    return true;
  }

  // Moves the sites towards the mean of their neighbours, twice: the second move gains half as much
  // as the first, a third one would gain little. Stars are renewed once after both, as most keep
  // their neighbours.
  void relax() {
    constexpr int times = 2;
    sites_.forget_index();
    const std::vector<vertex_index> order = in_order_of_outcome();
    relaxation relaxed(parts_, order);
    for (int i = 0; i < times; ++i) relaxed.run(options_.distance, options_.stop);
    stars_.follow_moves(order);
  }

  // Estimates the number of sites at the last level: half the distance takes twice the sites on
  // segments and four times those inside.
  double sites_at_last_level(int level) const {
    const auto on_segments = static_cast<double>(sites_.count_on_segments());
    const double inside = static_cast<double>(sites_.size()) - on_segments;
    return on_segments * elementary::exp2(level) + inside * elementary::exp2(2 * level);
  }

  // Frees each part of the fill's working memory as soon as nothing reads it any more: the end of a
  // fill is where a run needs most memory.
  filled_domain outcome() && {
    filled_domain filled;
    filled.rounds = rounds_;
    filled.complete = !is_over();
    filled.stopped = stopped_;
    filled.needed = needed_;
    filled.work_units = work_.units();
    if (crowded_) filled.crowded = stars_.most_crowded();
    sites_.forget_index();
    const std::vector<vertex_index> order = in_order_of_outcome();
    if (filled.complete) filled.stars = stars_in_order(order, stars_.mend_disagreeing(order));
    stars_.forget_stars();
    put_sites_in_order(order, filled);
    return filled;
  }

  // Returns the sites in the order of the outcome, each by its number in the fill: the vertices,
  // those that divide segments, and the interior along a curve.
  std::vector<vertex_index> in_order_of_outcome() const {
    std::vector<vertex_index> order(domain_.vertices.size()), inside;
    std::iota(order.begin(), order.end(), vertex_index{0});
    for (const std::vector<vertex_index>& division : segments_.dividing_sites())
      order.insert(order.end(), division.begin(), division.end());
    inside.reserve(sites_.size() - order.size());
    for (auto w = static_cast<vertex_index>(domain_.vertices.size()); w < sites_.size(); ++w)
      if (!sites_.is_on_segment(w)) inside.push_back(w);
    sort_along_curve(inside, sites_.all(), box_);
    order.insert(order.end(), inside.begin(), inside.end());
    return order;
  }

  // Copies the sites, in the order given, into the outcome.
  void put_sites_in_order(const std::vector<vertex_index>& order, filled_domain& filled) const {
    auto next = order.begin() + static_cast<std::ptrdiff_t>(domain_.vertices.size());
    for (const std::vector<vertex_index>& division : segments_.dividing_sites()) {
      std::vector<site>& points = filled.divisions.emplace_back();
      for (std::size_t i = 0; i < division.size(); ++i) points.push_back(sites_[*next++]);
    }
    filled.interior.reserve(static_cast<std::size_t>(order.end() - next));
    for (; next != order.end(); ++next) filled.interior.push_back(sites_[*next]);
  }

  // Returns the neighbours of the sites in `order`, by their numbers in it. A star that disagrees
  // with another gets an empty list, as one of the two is wrong.
  neighbour_lists stars_in_order(const std::vector<vertex_index>& order,
                                 const std::vector<char>& agrees) const {
    constexpr std::size_t chunk = 256;
    std::vector<vertex_index> number(sites_.size());
    std::vector<std::size_t> sizes(order.size());
    parallel_chunks(order.size(), chunk, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const vertex_index v = order[i];
        number[v] = static_cast<vertex_index>(i);
        sizes[i] = agrees[v] != 0 ? stars_[v].size() : 0;
      }
    });
    neighbour_lists lists(std::move(sizes));
    lists.make_room_for_marks();
    parallel_chunks(order.size(), chunk, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const std::span<vertex_index> list = lists.list(i);
        for (std::size_t k = 0; k < list.size(); ++k)
          list[k] = number[stars_[order[i]][k].neighbour];
        if (!list.empty() && is_plainly_a_star(sites_.all(), order[i], stars_[order[i]]))
          lists.mark(i);
      }
    });
    return lists;
  }

  const domain& domain_;
  const fill_options& options_;
  bounding_box box_;
  field_sampler sampler_;
  work_meter work_;
  placed_sites sites_;
  approximate_star_store stars_;
  segment_intervals segments_;
  fill_parts parts_;
  site_proposals proposals_;
  std::size_t rounds_ = 0;
  bool stopped_ = false;  // by options_.stop
  bool crowded_ = false;  // there was too much work for so many sites
  double charged_ = 0;    // of the work, what the run's account was charged with
  double needed_ = 0;
  std::optional<error> failure_;  // of the field, where a site was proposed
};

// Replaces the computed divisions of segments by the prescribed ones. Assumes parts of equal
// length: lengths only decide on which level of the fill a point is added.
void keep_prescribed(const domain& d, const prescribed_divisions& prescribed,
                     std::vector<division>& divisions) {
  for (std::size_t s = 0; s < divisions.size(); ++s) {
    if (!prescribed[s]) continue;
    division& one = divisions[s];
    const double total = one.lengths.back();
    one.points = {d.vertices[d.segments[s].a]};
    one.points.insert(one.points.end(), prescribed[s]->begin(), prescribed[s]->end());
    one.points.push_back(d.vertices[d.segments[s].b]);
    const auto parts = static_cast<double>(one.points.size() - 1);
    one.lengths.clear();
    for (std::size_t i = 0; i < one.points.size(); ++i)
      one.lengths.push_back(total * (static_cast<double>(i) / parts));
  }
}

}  // namespace

result<filled_domain> fill(const domain& d, const metric_field& field, const fill_options& options,
                           const fill_progress& progress) {
  auto divisions = divide_segments(d, field, options.longest_subsegment, options.max_sites);
  if (!divisions) return divisions.failure();
  if (divisions.value().of_each.empty() && !d.segments.empty()) {
    filled_domain nothing;
    nothing.divisions.resize(d.segments.size());
    nothing.needed = divisions.value().subsegments;
    return nothing;
  }
  if (options.prescribed != nullptr)
    keep_prescribed(d, *options.prescribed, divisions.value().of_each);
  return filling(d, field, options, std::move(divisions.value().of_each)).run(progress);
}

}  // namespace asterism::internal
