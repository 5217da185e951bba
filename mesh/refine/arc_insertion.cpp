// SPDX-License-Identifier: MIT
#include "asterism/mesh/refine/arc_insertion.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "asterism/mesh/refine/off_centre.hpp"
#include "asterism/mesh/refine/site_insertion.hpp"
#include "asterism/mesh/refine/voronoi_arc_candidates.hpp"

namespace asterism::internal {

bool arc_insertion::insert() {
  while (true) {
    const pass_result result = insert_at_worst();
    if (result != pass_result::exhausted) return result == pass_result::progressed;
    // Tries failed triangles again: a candidate may succeed once another site was inserted.
    failed_at_tolerance_.clear();
    if (std::exchange(retry_, false)) continue;
    if (tolerance_ <= range_.floor) return split_before_worst();
    if (cancelled_.is_requested()) return true;
    tolerance_ = std::max(range_.floor, range_.shrink * tolerance_);
  }
}

arc_insertion::pass_result arc_insertion::insert_at_worst() {
  for (const bad_triangle& b : queue_.bad()) {
    if (state_.is_overworked()) return pass_result::progressed;
    if (is_set_aside(b) || steep_.gives_up(b)) continue;
    const bool inserted = insert_at(b.where, tolerance_);
    if (state_.field_failure()) return pass_result::field_failed;
    if (!inserted) {
      failed_at_tolerance_.insert(b);
      continue;
    }
    retry_ = true;
    if (b.why == badness::too_large) insert_for_large();
    return pass_result::progressed;
  }
  return pass_result::exhausted;
}

// Splits a subsegment only at the floor of the tolerance, where no candidate is left. Where metrics
// vary, not only rounding moves candidates out of the domain, and smaller tolerances cost fewer
// sites: splitting before the tolerance shrinks takes 143 sites in place of 110 for the square in
// swirl:12.
bool arc_insertion::split_before_worst() {
  if (state_.is_full() || cancelled_.is_requested()) return false;
  return std::any_of(queue_.bad().begin(), queue_.bad().end(), [&](const bad_triangle& b) {
    return !state_.is_overworked() && !steep_.is_given_up(b.where) &&
           split_before_candidates(state_, b.where, tolerance_);
  });
}

// Tries off-centres first where collateral angles are mended. Voronoi vertices there encroach on
// the long subsegments at the tips of wedges; these are split, and the same happens again at half
// the size. An angle a quarter above the bound leaves room for metrics that vary.
bool arc_insertion::insert_at(const triangle& t, double tolerance) {
  constexpr double part_of_bound = 1.25;
  if (mends_collateral_)
    if (const auto s = find_off_centre(state_, t, part_of_bound * angle_.degrees(), tolerance)) {
      state_.add_interior(*s);
      return true;
    }
  return shorten_tight_corner(state_, t, angle_, tolerance) ||
         refine_by_arcs(state_, t, tolerance, rejected_);
}

// Inserts sites for all triangles of the queue that are not set aside, from one state of the queue.
// Skips triangles that earlier insertions removed. The order of triangles matters little where all
// of them are only too large.
void arc_insertion::insert_for_large() {
  for (const bad_triangle& b : queue_.bad()) {
    if (state_.is_full() || state_.is_overworked() || state_.field_failure()) return;
    const auto [v, y, x] = b.where;
    if (!is_set_aside(b) && has_triangle(state_.oracle(), v, state_.stars()[v], y, x))
      refine_by_arcs(state_, b.where, tolerance_, rejected_);
  }
}

bool arc_insertion::insert_in_bulk() {
  constexpr std::size_t fewest = 32;
  if (queue_.bad().size() < fewest) return false;
  std::vector<char> busy(state_.sites().size(), 0);
  bool any = false;
  for (const bad_triangle& b : queue_.bad()) {
    if (state_.is_full() || state_.is_overworked()) break;
    if (is_set_aside(b)) continue;
    if (std::any_of(b.where.begin(), b.where.end(), [&](vertex_index v) { return busy[v] != 0; }))
      continue;
    if (steep_.gives_up(b)) continue;
    const auto s = find_place(state_, b.where, tolerance_, rejected_);
    if (state_.field_failure()) break;
    if (!s) continue;
    state_.add_interior_later(*s);
    any = true;
    for (const vertex_index v : b.where) {
      busy[v] = 1;
      for (const sector& part : state_.stars()[v].sectors)
        for (const vertex_index u : part.neighbours) busy[u] = 1;
    }
  }
  if (any) state_.add_stars();
  retry_ = retry_ || any;
  return any && !state_.field_failure();
}

bool arc_insertion::insert_at_exempt_corners() {
  if (state_.is_full()) return false;
  constexpr double modest = 0x1p-4;
  const double tolerance = std::max(range_.floor, modest * range_.start);
  const std::set<bad_triangle>& improvable = queue_.improvable();
  return std::any_of(improvable.begin(), improvable.end(),
                     [&](const bad_triangle& b) { return insert_at(b.where, tolerance); });
}

}  // namespace asterism::internal
