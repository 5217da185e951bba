// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/star_check.hpp"

#include <algorithm>
#include <string>

#include "asterism/kernels/filtered_edge_test.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/audit/distant_site.hpp"

namespace asterism::internal::audit_detail {

void star_check::run(const vertex_index* begin, const vertex_index* end, const vertex_index* last,
                     bool neighbours_alone) {
  if (!neighbours_alone) make_room({begin, end});
  for (const vertex_index* v = begin; v != end; ++v) {
    if (!neighbours_alone) {
      prepare(*v);
      continue;
    }
    if (!around_.concerns_star_of(*v)) continue;
    if (last - v > std::ptrdiff_t{sites_ahead}) context_.prefetch_around(v[sites_ahead]);
    context_.fans.visit(*v, [&](const vertex_fan& fan) { check_neighbours(*v, fan); });
  }
  if (neighbours_alone) return;
  hold_all(lists_.prepared);
  lists_.outlines.resize(std::max(lists_.outlines.size(), std::size_t{1}));
  for (const prepared_fan& p : lists_.prepared)
    if (p.has_others)
      around_.changed_sites.visit_near(
          extent_of(p, false, lists_.outlines.front()),
          [&](vertex_index nth) { look(p, (*context_.changed)[nth], false); });
}

void star_check::make_room(std::span<const vertex_index> vertices) {
  std::size_t fans = 0, rays = 0;
  for (const vertex_index v : vertices)
    context_.fans.visit(v, [&](const vertex_fan& fan) {
      ++fans;
      rays += fan.link.size();
    });
  lists_.prepared.clear();
  lists_.rays.clear();
  lists_.gaps.clear();
  lists_.kernel_gaps.clear();
  lists_.filters.clear();
  lists_.prepared.reserve(fans);
  lists_.rays.reserve(rays);
  lists_.gaps.reserve(rays);
}

void star_check::hold_all(std::span<const prepared_fan> fans) {
  lists_.extents.clear();
  if (lists_.outlines.size() < fans.size()) lists_.outlines.resize(fans.size());
  for (const prepared_fan& p : fans)
    if (p.has_concerned && is_finite(p.reach_concerned))
      lists_.extents.push_back(extent_of(p, true, lists_.outlines[lists_.extents.size()]));
  around_.sites->gather(lists_.extents, lists_.leaves);
  std::size_t nth = 0;
  for (const prepared_fan& p : fans) {
    if (!p.has_concerned) continue;
    const auto look_at = [&](vertex_index w) { look(p, w, true); };
    if (is_finite(p.reach_concerned))
      around_.sites->visit_near(lists_.leaves, lists_.extents[nth++], look_at);
    else
      around_.sites->visit_near({at(p.v), p.reach_concerned}, look_at);
  }
}

star_extent star_check::extent_of(const prepared_fan& p, bool of_concerned,
                                  std::vector<outline_point>& outline) const {
  constexpr std::size_t points_of_ray = 3;  // at most
  outline.clear();
  outline.reserve(points_of_ray * p.rays.size());
  const auto is_in = [&](std::size_t i) {
    return i < p.gaps.size() && !p.gaps[i].is_skipped && p.gaps[i].is_concerned == of_concerned;
  };
  for (std::size_t i = 0; i < p.rays.size(); ++i) {
    const bool is_after = is_in(i);
    if (is_after && !p.gaps[i].has_kite)
      return {at(p.v), of_concerned ? p.reach_concerned : p.reach};
    if (is_after) outline.push_back(p.gaps[i].vertex);
    if (!is_after && !is_in(i == 0 ? p.rays.size() - 1 : i - 1)) continue;
    const auto& [way, on_way] = p.rays[i];
    outline.push_back(on_way);
    outline.push_back({{way.x, way.y}});
  }
  return {at(p.v), std::span<const outline_point>(outline)};
}

void star_check::check_neighbours(vertex_index v, const vertex_fan& fan) {
  const std::size_t n = fan.link.size();
  const std::size_t skipped = fan.closed ? 0 : 1;
  for (std::size_t i = skipped; i + skipped < n && !guard_.is_over(); ++i) {
    const vertex_index w = fan.link[i], x = fan.link[(i + n - 1) % n], y = fan.link[(i + 1) % n];
    if (w < v || !around_.concerns(v, w, x, y)) continue;
    if (is_accepted_in_one_metric(v, w, x, y)) continue;
    const bool by_v = is_asked(v, w, x, y), by_w = is_asked(w, v, y, x);
    if ((!by_v && !by_w) || is_accepted_or_open(v, w, x, y)) continue;
    if (by_v) report_rejected(v, w, x, y);
    if (by_w) report_rejected(w, v, y, x);
  }
}

bool star_check::is_accepted_in_one_metric(vertex_index v, vertex_index w, vertex_index x,
                                           vertex_index y) const {
  const metric_tensor& m = at(v).metric;
  return identical(m, at(w).metric) && identical(m, at(x).metric) && identical(m, at(y).metric) &&
         tally_.kernel().edge_test(at(v), at(w), at(x), at(y));
}

bool star_check::is_asked(vertex_index v, vertex_index w, vertex_index x, vertex_index y) const {
  return turn(v, x, y) == sign::positive && turn(x, y, w) != sign::positive;
}

void star_check::report_rejected(vertex_index v, vertex_index w, vertex_index x, vertex_index y) {
  tally_.found(finding_kind::star_neighbour_rejected,
               "the star of " + vertex_text(context_, v) + " does not accept its neighbour " +
                   vertex_text(context_, w) + " between " + vertex_text(context_, x) + " and " +
                   vertex_text(context_, y),
               {v, w, x, y});
}

void star_check::prepare(vertex_index v) {
  double none = 0;
  double& known = context_.memory == nullptr ? none : context_.memory->reaches[v];
  double reach = 0;
  context_.fans.visit(v, [&](const vertex_fan& fan) {
    if (!around_.concerns_star_of(v) && !is_reached(v, known)) {
      reach = greatest_bound(reach, known);
      return;
    }
    prepare(v, fan);
    reach = greatest_bound(reach, lists_.prepared.back().reach);
  });
  known = reach;
}

bool star_check::is_reached(vertex_index v, double reach) {
  guard_.count(unit_of_look);
  if (!around_.changed_sites.may_reach(at(v), reach)) return false;
  bool any = false;
  around_.changed_sites.visit_near({at(v), reach}, [&any](vertex_index) {
    any = true;
    return false;
  });
  return any;
}

void star_check::prepare(vertex_index v, const vertex_fan& fan) {
  prepared_fan& p = lists_.prepared.emplace_back();
  p.v = v;
  p.link = fan.link;
  const quick_reaches reaches(at(v));
  const std::size_t first_ray = lists_.rays.size(), first_gap = lists_.gaps.size();
  lists_.measured.clear();
  lists_.measured.reserve(fan.link.size());
  for (const vertex_index r : fan.link) {
    const measured_ray& measured = lists_.measured.emplace_back(reaches.ray_to(at(r)));
    lists_.rays.push_back({to(v, r), measured.on_bisector()});
  }
  const std::size_t n = fan.link.size();
  for (std::size_t i = 0; i + (fan.closed ? 0 : 1) < n; ++i) {
    fan_gap& gap = lists_.gaps.emplace_back(fan.link[i], fan.link[(i + 1) % n]);
    gap.is_skipped = find_subsegment(context_, gap.x, gap.y) != context_.subject.boundary.size();
    if (gap.is_skipped) continue;
    gap.is_concerned = around_.concerns(v, gap.x, gap.y);
    bound(v, gap, reaches, lists_.measured[i], lists_.measured[(i + 1) % n]);
    if (gap.is_concerned && is_left_open(gap)) {
      leave_open(v, v, gap.x, gap.y, open_question::about::gap);
      gap.is_skipped = true;
      continue;
    }
    p.reach = greatest_bound(p.reach, gap.reach);
    (gap.is_concerned ? p.has_concerned : p.has_others) = true;
    if (gap.is_concerned) p.reach_concerned = greatest_bound(p.reach_concerned, gap.reach);
  }
  p.rays = std::span(lists_.rays).subspan(first_ray);
  p.gaps = std::span(lists_.gaps).subspan(first_gap);
}

bool star_check::is_left_open(const fan_gap& gap) const {
  return context_.leaves_open && !is_finite(gap.reach) &&
         around_.at.size() >= context_.many_for_a_gap;
}

void star_check::bound(vertex_index v, fan_gap& gap, const quick_reaches& reaches,
                       const measured_ray& to_x, const measured_ray& to_y) {
  constexpr double edges = 2;
  const gap_bound quick = reaches.between(to_x, to_y);
  gap.reach = quick.reach;
  gap.vertex = quick.vertex;
  gap.has_kite = is_finite(quick.reach);
  if (quick.reach > edges * std::max(to_x.length, to_y.length)) sharpen(v, gap);
  if (gap.has_kite) return;
  const gap_bound balanced = reaches.balanced(to_x, to_y);
  gap.reach = std::min(gap.reach, balanced.reach);
  gap.vertex = balanced.vertex;
  gap.has_kite = is_finite(balanced.reach);
}

void star_check::sharpen(vertex_index v, fan_gap& gap) {
  const star_gap* prepared = prepared_gap(v, gap);
  if (prepared != nullptr) gap.reach = std::min(gap.reach, prepared->reach());
  if (!is_finite(gap.reach)) gap.reach = filter_of(v, gap).reach();
  // Bounds the reach by the kernel's gap where the filter does not, also in an audit by filters
  // alone, which shares no test for that: without a reach all sites of the mesh are tested. In a
  // mesh of 100,000 sites 500 stars had such gaps, and the audit ended at the work limit.
  if (!is_finite(gap.reach) && prepared == nullptr)
    gap.reach = star_gap(at(v), at(gap.x), at(gap.y)).reach();
}

bool star_check::is_outside(const prepared_fan& p, const fan_gap& gap, vertex_index w) const {
  const std::size_t i = &gap - p.gaps.data(), j = i + 1 < p.rays.size() ? i + 1 : 0;
  const auto [x, y] = to(p.v, w);
  const auto side_of = [](const fan_ray& ray) {
    return kite_side{{ray.way.x, ray.way.y}, ray.on_way};
  };
  const std::array<kite_side, 2> sides{side_of(p.rays[i]), side_of(p.rays[j])};
  return is_outside_kite({x, y}, at(w).metric, gap.vertex, sides);
}

fan_gap* star_check::gap_of(const prepared_fan& p, vertex_index w) const {
  const auto to_w = to(p.v, w);
  const std::size_t n = p.rays.size();
  sign before = side(p, 0, to_w, w);
  for (std::size_t i = 0; i < p.gaps.size(); ++i) {
    const sign after = side(p, i + 1 < n ? i + 1 : 0, to_w, w);
    if (before == sign::positive && after == sign::negative) return &p.gaps[i];
    before = after;
  }
  return nullptr;
}

void star_check::check_other(const prepared_fan& p, vertex_index w, bool at_concerned) {
  fan_gap* gap = gap_of(p, w);
  if (gap == nullptr || gap->is_skipped || gap->is_concerned != at_concerned) return;
  if (gap->has_kite && is_outside(p, *gap, w)) return;
  if (is_too_far(at(p.v), gap->reach, at(w))) return;
  ++tally_.part.star_pairs;
  if (!is_accepted(p.v, w, *gap) || !sight_.clear(p.v, w)) return;
  tally_.found(finding_kind::star_site_missing,
               "the star of " + vertex_text(context_, p.v) + " would accept " +
                   vertex_text(context_, w) + " between " + vertex_text(context_, gap->x) +
                   " and " + vertex_text(context_, gap->y),
               {p.v, w, gap->x, gap->y});
}

bool star_check::is_accepted(vertex_index v, vertex_index w, fan_gap& gap) {
  const star_gap* prepared = prepared_gap(v, gap);
  if (prepared != nullptr) {
    const uncertain_bool by_v = prepared->accepts(at(w));
    if (by_v.certain()) return by_v.value();
  }
  // Tries the filter of v's gap before the kernel's gap of w: the filter is cheaper, and prepared
  // once for all sites.
  if (filter_of(v, gap).excludes(at(w))) return false;
  if (prepared != nullptr) {
    // Evaluates the gap of w, which answers the same question and often has the smaller error.
    const uncertain_bool by_w = star_gap(at(w), at(gap.y), at(gap.x)).accepts(at(v));
    if (by_w.certain()) return by_w.value();
  }
  // Tries the filter from w's side. It is slower than both tests above, but edge_test takes thirty
  // times as long when it needs intervals.
  if (star_gap_filter(at(w), at(gap.y), at(gap.x)).excludes(at(v))) return false;
  if (context_.leaves_open) {
    if (sight_.clear(v, w)) leave_open(v, w, gap);
    return false;
  }
  ++tally_.part.star_pairs_tested;
  return tally_.kernel().edge_test(at(v), at(w), at(gap.x), at(gap.y));
}

bool star_check::is_accepted_or_open(vertex_index v, vertex_index w, vertex_index x,
                                     vertex_index y) {
  if (!context_.leaves_open) return tally_.kernel().edge_test(at(v), at(w), at(x), at(y));
  const uncertain_bool answer =
      filtered_edge_test(at(v), at(w), at(x), at(y), tally_.part.counters);
  if (answer.certain()) return answer.value();
  leave_open(v, w, x, y, open_question::about::neighbour);
  return true;
}

void star_check::leave_open(vertex_index v, vertex_index w, fan_gap& gap) {
  leave_open(v, w, gap.x, gap.y, open_question::about::other_site);
  if (++gap.left_open < context_.many_open_at_a_gap) return;
  leave_open(v, v, gap.x, gap.y, open_question::about::gap);
  gap.is_skipped = true;
}

void star_check::leave_open(vertex_index v, vertex_index w, vertex_index x, vertex_index y,
                            open_question::about what) {
  tally_.left_open.push_back({{v, w, x, y}, what});
}

}  // namespace asterism::internal::audit_detail
