// SPDX-License-Identifier: MIT
#include "asterism/mesh/refine/refine_state.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "asterism/mesh/stars/strictly_inside.hpp"
#include "asterism/mesh/stars/visibility.hpp"
#include "asterism/mesh/stars/work_limit.hpp"
#include "asterism/mesh/support/parallel.hpp"
#include "asterism/mesh/support/work_weights.hpp"

namespace asterism::internal {
result<refine_state> refine_state::start(const domain& d, const metric_field& field,
                                         const star_predicates& kernel, std::size_t most_sites,
                                         const filled_domain& filling,
                                         const cancellation& cancelled, double work_share) {
  auto given = site_set::start(d, field, most_sites);
  if (!given) return given.failure();
  auto sites = std::make_unique<site_set>(std::move(given).value());
  auto segments = split_boundary::build(d, kernel, *sites);
  if (!segments) return segments.failure();
  refine_state state(kernel, d.vertices.size(), std::move(sites), std::move(segments).value());
  state.stars_.cancel_by(cancelled);
  state.cancelled_ = cancelled;
  state.work_share_ = work_share;
  state.charged_ = work_units(kernel.counters());
  numbered_sites taken(d.vertices.size());
  std::iota(taken.begin(), taken.end(), vertex_index{0});
  state.divide(d, filling, taken);
  state.add_proposed(filling.interior, taken);
  // Guesses no stars in one metric: there all stars are read from one triangulation.
  if (!state.sites_->has_one_metric()) state.guess_stars(filling.stars, taken);
  state.segments_.suspect_all();
  return state;
}

void refine_state::construct_stars(star_confirmation confirmed) {
  construct_stars(guesses_, confirmed);
}

void refine_state::construct_stars(const neighbour_lists& likely, star_confirmation confirmed) {
  stars_.bound_work(given_, work_share_);
  is_overworked();  // charges the run's account, what is left of which bounds the stars
  stars_.construct_all(oracle(), likely, confirmed);
  is_overworked();  // so that mending has what is left after them
  guesses_ = {};
  has_stars_ = true;
}

// Divides the segments at the proposed points, or beside them on the curve of a chord. Leaves out a
// point that rounding moved to the wrong side of a site or subsegment, and all further points once
// the run is told to end: where thousands of segments share a vertex each point is tested against
// all of them.
void refine_state::divide(const domain& d, const filled_domain& filling, numbered_sites& taken) {
  for (std::size_t s = 0; s < d.segments.size(); ++s) {
    std::size_t subsegment = segments_.find_subsegment(d.segments[s].a, d.segments[s].b);
    const bool is_stopped = cancelled_.told().has_value();
    for (const site& m : filling.divisions[s]) {
      taken.push_back(left_out);
      if (is_stopped || is_full()) continue;
      const std::size_t first_new = edges().subsegments().size();
      const boundary_edge& whole = edges().subsegments()[subsegment];
      const auto beside = segments_.place_on_curve(whole, m.position);
      const auto curved = beside ? site_at(*beside) : std::nullopt;
      if (curved && segments_.can_split_at(whole, *curved, 0, true))
        segments_.put_on_subsegment(subsegment, *curved, true);
      else if (segments_.can_split_at(whole, m, 0))
        segments_.put_on_subsegment(subsegment, m);
      else
        continue;
      taken.back() = static_cast<vertex_index>(sites().size() - 1);
      subsegment = first_new;
    }
  }
}

// Notes for each of a few sites near each other whether it is strictly inside and encroaches on
// nothing. Mostly no subsegment meets their common box: then all sites are on the same side of the
// boundary.
void refine_state::test_group(const star_predicates& kernel, std::span<const site> group,
                              std::vector<char>& out) const {
  bounding_box box{group[0].position, group[0].position};
  for (const site& s : group) box.include(s.position);
  const auto stop_at_first = [](std::uint32_t) { return false; };
  const proximity& near = std::as_const(*sites_).near();
  if (near.subsegments().visit(box, stop_at_first) && near.influences().visit(box, stop_at_first)) {
    out.insert(out.end(), group.size(), strictly_inside_near(kernel, group[0].position));
    return;
  }
  for (const site& s : group)
    out.push_back(strictly_inside_near(kernel, s.position) &&
                  segments_.encroached_by(kernel, s).empty());
}

void refine_state::add_proposed(const std::vector<site>& proposed, numbered_sites& taken) {
  constexpr std::size_t chunk = 256, group_size = 16;
  const std::vector<char> fits = collect_chunks<char>(
      proposed.size(), chunk, [&](std::size_t begin, std::size_t end, std::vector<char>& out) {
        tier_counters apart;  // proposing is no part of the work that is bounded
        const auto kernel = kernel_->fork(apart);
        for (std::size_t i = begin; i < end; i += group_size)
          test_group(*kernel, std::span(proposed).subspan(i, std::min(group_size, end - i)), out);
      });
  sites_->reserve(proposed.size());
  taken.reserve(taken.size() + proposed.size());
  for (std::size_t i = 0; i < proposed.size(); ++i)
    taken.push_back(fits[i] != 0 && !is_full() ? sites_->add(proposed[i]) : left_out);
}

// Renumbers the neighbours that the fill found for its sites, and copies its marks. A star with a
// neighbour that was left out gets no guess.
void refine_state::guess_stars(const neighbour_lists& stars, const numbered_sites& taken) {
  guesses_.reserve(sites().size());
  for (std::size_t i = 0; i < stars.size(); ++i) {
    if (taken[i] == left_out) continue;
    for (const vertex_index u : stars[i]) {
      if (taken[u] == left_out) {
        guesses_.clear_list();
        break;
      }
      guesses_.add(taken[u]);
    }
    guesses_.end_list();
  }
  guesses_.make_room_for_marks();
  for (std::size_t i = 0; i < stars.size(); ++i)
    if (taken[i] != left_out && stars.is_marked(i)) guesses_.mark(taken[i]);
}

bool refine_state::is_overworked() const {
  const double done =
      work_units(kernel_->counters()) +
      work_weights::bad_triangle * static_cast<double>(triangles_tried_) +
      work_weights::site_looked_at * static_cast<double>(looked_at_) +
      work_weights::star_candidate * static_cast<double>(stars_.candidates_looked_at());
  cancelled_.expect(sites().size());
  cancelled_.charge(done - std::exchange(charged_, done));
  return done > work_share_ * most_work_units(sites().size(), given_) ||
         !(cancelled_.units_left() > 0);
}

bool refine_state::strictly_inside(const point& q) const {
  return strictly_inside_near(*kernel_, q);
}

bool refine_state::strictly_inside_near(const star_predicates& kernel, const point& q) const {
  return asterism::internal::strictly_inside(edges(), sites(), kernel, q,
                                             &std::as_const(*sites_).near());
}

std::vector<std::size_t> refine_state::encroached_by(const site& s) const {
  return segments_.encroached_by(*kernel_, s);
}

void refine_state::add_interior(const site& s) {
  const vertex_index added = sites_->add(s);
  stars_.add_last(oracle());
  segments_.note_encroached_by(added);
}

void refine_state::add_interior_later(const site& s) { sites_->add(s); }

void refine_state::add_stars() {
  const vertex_index first = stars_.size();
  stars_.add_many(oracle(), first);
  for (vertex_index w = first; w < sites().size(); ++w) segments_.note_encroached_by(w);
}

bool refine_state::split(std::size_t subsegment, double shortest) {
  return split_at(subsegment, segments_.split_point(edges().subsegments()[subsegment]), shortest);
}

bool refine_state::split_at(std::size_t subsegment, const point& q, double shortest) {
  if (is_full()) return false;
  const auto beside = segments_.place_on_curve(edges().subsegments()[subsegment], q);
  return (beside && split_exactly_at(subsegment, *beside, shortest, true)) ||
         split_exactly_at(subsegment, q, shortest, false);
}

bool refine_state::split_exactly_at(std::size_t subsegment, const point& q, double shortest,
                                    bool on_curve) {
  const boundary_edge whole = edges().subsegments()[subsegment];
  const auto m = site_at(q);
  if (!m || !segments_.can_split_at(whole, *m, shortest, on_curve)) return false;
  segments_.put_on_subsegment(subsegment, *m, on_curve);
  const auto added = static_cast<vertex_index>(sites().size() - 1);
  if (has_stars_) stars_.split_subsegment(oracle(), whole.a, added, whole.b);
  if (on_split_) on_split_(whole.a, whole.b);
  segments_.note_encroached_by(added);
  return true;
}

bool refine_state::split_at_place(const point& q, double shortest) {
  const auto through = segments_.subsegment_through(q);
  return through && split(*through, shortest);
}

bool refine_state::split_before(const triangle& t, const point& q, double shortest) {
  const auto before = segments_.subsegment_before(t, q);
  return before && split(*before, shortest);
}

bool refine_state::clear_encroachments(double shortest) {
  while (segments_.has_suspects() && !is_full()) {
    if (is_overworked()) return false;
    const auto found = segments_.next_encroachment();
    if (!found) continue;
    if (cancelled_.is_requested()) return false;
    if (!found->mirrored || !split_at(found->subsegment, *found->mirrored, shortest))
      split(found->subsegment, shortest);
  }
  return true;
}

void refine_state::shorten_subsegments(double longest) {
  for (std::size_t subsegment = 0; subsegment < edges().subsegments().size(); ++subsegment) {
    const auto too_long = [&] {
      const boundary_edge& p = edges().subsegments()[subsegment];
      return std::max(segments_.subsegment_length(subsegment, p.a),
                      segments_.subsegment_length(subsegment, p.b)) > longest;
    };
    while (too_long() && !cancelled_.is_requested() && !is_overworked() && split(subsegment, 0)) {
    }
  }
}

}  // namespace asterism::internal
