// SPDX-License-Identifier: MIT
//
// Point 4: the triangles of the mesh around v are the star of v. Not built again but recognised: a
// star is final when (a) each of its neighbours, taken out, would be accepted again, and (b) no
// other site that v sees inside the domain would be. The two ends of an open fan are boundary
// subsegments or internal ones, and stay.
// Requires what points 0 to 2 prove: no site lies on an edge or inside a triangle, so that a site
// on the ray of a neighbour is farther than it, and a site in a gap is beyond the gap's edge.
// Source: the thesis, section 3.3 (INSERTIONTEST) and definition 9.
//
// How far a gap reaches takes few operations (audit/gap_reach.hpp); most are asked about no site.
// Nearly every question is decided by the kernel's prepared gap (kernels/star_gap.hpp), made once
// for a gap; what it does not know by the auditor's own filter of wider range, and then edge_test.
// The mesher asks prepared gaps too. Where the two are not to share that, as in verify(), they are
// left out (audit_options::own_filter_alone).
//
// Most stars are settled without any search, by a walk over triangles (audit/star_walk.hpp); sites
// are looked for in a tree for those that it leaves.
//
// A mesh whose metric varies much over an edge has stars that see far, and thousands of sites to
// hold against each. It also has edges that are refused at once, by the site across them. So these
// are asked first, and where some are refused the mesh is, without the rest. Where all sites have
// one metric and none is refused, there is nothing else to ask.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "asterism/kernels/filtered_edge_test.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/kernels/star_gap.hpp"
#include "asterism/mesh/audit/audit_work.hpp"
#include "asterism/mesh/audit/check_order.hpp"
#include "asterism/mesh/audit/context.hpp"
#include "asterism/mesh/audit/gap_reach.hpp"
#include "asterism/mesh/audit/site_tree.hpp"
#include "asterism/mesh/audit/star_filter.hpp"
#include "asterism/mesh/audit/star_surroundings.hpp"
#include "asterism/mesh/audit/star_walk.hpp"
#include "asterism/mesh/audit/visibility_test.hpp"

namespace asterism::internal::audit_detail {
namespace {

// One gap of a fan, from x counter-clockwise to y.
struct fan_gap {
  // Leaves the memory of what is prepared later as it is.
  fan_gap(vertex_index before, vertex_index after) : x(before), y(after) {}

  vertex_index x, y;
  bool is_skipped = false;   // x -> y is a subsegment, beyond which nothing is seen, or left open
  bool is_concerned = true;  // or else changed sites alone are to be held against it
  double reach = 0;          // how far from v sites matter to it
  mutable std::optional<star_gap> prepared;  // made for the first question, if it may be shared
  mutable std::optional<star_gap_filter> filter;  // made when `prepared` does not know something
};

// One fan of v's star, made ready to be asked about other sites.
struct prepared_fan {
  vertex_index v = 0;
  std::span<const vertex_index> link;
  std::vector<vertex_index> neighbours;  // of all fans of v
  std::vector<vector2<double>> rays;
  std::vector<fan_gap> gaps;
  double reach = 0;            // how far from v sites matter to one of the gaps
  double reach_concerned = 0;  // to one of those that are concerned
  bool has_concerned = false;  // gaps that all sites are to be held against
  bool has_others = false;
};

class star_check {
 public:
  star_check(const audit_context& context, audit_tally& tally, const star_surroundings& around)
      : context_(context),
        tally_(tally),
        patience_(context, tally),
        around_(around),
        sight_(context, around.subsegments, tally.kernel()) {}

  bool is_over() { return patience_.is_over(); }

  // Checks vertices near each other: the sites around are looked for once for all of them. Needs
  // the tree unless neighbours alone are asked about. The order of all vertices ends at `last`.
  void run(const vertex_index* begin, const vertex_index* end, const vertex_index* last,
           bool neighbours_alone) {
    used_ = 0;
    for (const vertex_index* v = begin; v != end; ++v) {
      if (!neighbours_alone) {
        prepare(*v);
        continue;
      }
      if (last - v > std::ptrdiff_t{sites_ahead}) context_.prefetch_around(v[sites_ahead]);
      context_.fans.visit(*v, [&](const vertex_fan& fan) { check_neighbours(*v, fan); });
    }
    if (neighbours_alone) return;
    const std::span<const prepared_fan> fans(prepared_.data(), used_);
    hold_all(fans);
    for (const prepared_fan& p : fans)
      if (p.has_others)
        around_.changed_sites.visit_near(at(p.v), p.reach, [&](vertex_index nth) {
          look(p, (*context_.changed)[nth], 0, false);
        });
  }

 private:
  const site& at(vertex_index v) const { return around_.at[v]; }
  sign turn(vertex_index a, vertex_index b, vertex_index c) const {
    return tally_.kernel().orientation(context_.at(a), context_.at(b), context_.at(c));
  }

  static bool is_finite(double reach) { return reach < std::numeric_limits<double>::infinity(); }

  // Holds all sites in reach of the fans against the gaps that are concerned. Looks for them once
  // for all fans whose vertices measure much the same; else for each half, and each one.
  void hold_all(std::span<const prepared_fan> fans) {
    reaching_.clear();
    for (const prepared_fan& p : fans)
      if (p.has_concerned && is_finite(p.reach_concerned))
        reaching_.push_back({at(p.v), p.reach_concerned});
    const bool gathered = reaching_.size() > 1 && around_.sites->gather(reaching_, nearby_);
    if (!gathered && reaching_.size() > 1) {
      hold_all(fans.first(fans.size() / 2));
      hold_all(fans.last(fans.size() - fans.size() / 2));
      return;
    }
    for (const prepared_fan& p : fans)
      if (p.has_concerned) hold_all(p, gathered);
  }

  void hold_all(const prepared_fan& p, bool gathered) {
    const double reach = p.reach_concerned;
    const auto look_at = [&](vertex_index w, double squared) { look(p, w, squared, true); };
    const auto look_at_any = [&](vertex_index w) { look_at(w, 0); };
    if (!gathered || !is_finite(reach))
      around_.sites->visit_near(at(p.v), reach, look_at_any);
    else if (!around_.sites->visit_near(nearby_, at(p.v), reach, look_at))
      around_.sites->visit_near(nearby_.leaves, at(p.v), reach, look_at_any);
  }

  // Looks at w, of which the tree tells `squared`, or 0 where it tells nothing.
  void look(const prepared_fan& p, vertex_index w, double squared, bool at_concerned) {
    patience_.count(unit_of_look + unit_of_gap * static_cast<double>(p.gaps.size()));
    if (w != p.v && !is_neighbour(p, w) && !patience_.is_over())
      check_other(p, w, squared, at_concerned);
  }

  static bool is_neighbour(const prepared_fan& p, vertex_index w) {
    return std::find(p.neighbours.begin(), p.neighbours.end(), w) != p.neighbours.end();
  }

  // Asks about each inner edge of a fan once, from its lesser end: what edge_test is asked about
  // the other end is the same question, and x and y are next to v there.
  void check_neighbours(vertex_index v, const vertex_fan& fan) {
    const std::size_t n = fan.link.size();
    const std::size_t skipped = fan.closed ? 0 : 1;
    for (std::size_t i = skipped; i + skipped < n && !patience_.is_over(); ++i) {
      const vertex_index w = fan.link[i], x = fan.link[(i + n - 1) % n], y = fan.link[(i + 1) % n];
      if (w < v || !around_.concerns(v, w, x, y)) continue;
      if (is_accepted_in_one_metric(v, w, x, y)) continue;
      const bool by_v = is_asked(v, w, x, y), by_w = is_asked(w, v, y, x);
      if ((!by_v && !by_w) || is_accepted_or_open(v, w, x, y)) continue;
      if (by_v) report_rejected(v, w, x, y);
      if (by_w) report_rejected(w, v, y, x);
    }
  }

  // True if all four have one metric and edge_test accepts the edge: then it stands, whether or not
  // either end asks. Elsewhere the answer would be dear where nobody does.
  bool is_accepted_in_one_metric(vertex_index v, vertex_index w, vertex_index x,
                                 vertex_index y) const {
    const metric_tensor& m = at(v).metric;
    return identical(m, at(w).metric) && identical(m, at(x).metric) && identical(m, at(y).metric) &&
           tally_.kernel().edge_test(at(v), at(w), at(x), at(y));
  }

  // False where x to y is a half turn or more, or w inside the triangle v, x, y.
  bool is_asked(vertex_index v, vertex_index w, vertex_index x, vertex_index y) const {
    return turn(v, x, y) == sign::positive && turn(x, y, w) != sign::positive;
  }

  void report_rejected(vertex_index v, vertex_index w, vertex_index x, vertex_index y) {
    tally_.found(finding_kind::star_neighbour_rejected,
                 "the star of " + vertex_text(context_, v) + " does not accept its neighbour " +
                     vertex_text(context_, w) + " between " + vertex_text(context_, x) + " and " +
                     vertex_text(context_, y),
                 {v, w, x, y});
  }

  // Prepares the fans of v, but for those that no changed site is in reach of, and remembers how
  // far they reach.
  void prepare(vertex_index v) {
    double none = 0;
    double& known = context_.memory == nullptr ? none : context_.memory->reaches[v];
    double reach = 0;
    context_.fans.visit(v, [&](const vertex_fan& fan) {
      if (!concerns(v, fan) && !is_reached(v, known)) {
        reach = greatest_bound(reach, known);
        return;
      }
      prepare(v, fan);
      reach = greatest_bound(reach, prepared_[used_ - 1].reach);
    });
    known = reach;
  }

  bool concerns(vertex_index v, const vertex_fan& fan) const {
    return around_.concerns(v) ||
           std::any_of(fan.link.begin(), fan.link.end(),
                       [this](vertex_index r) { return around_.concerns(r); });
  }

  // True if a changed site may matter to a star of v that reaches so far.
  bool is_reached(vertex_index v, double reach) {
    patience_.count(unit_of_look);
    bool any = false;
    around_.changed_sites.visit_near(at(v), reach, [&any](vertex_index) { any = true; });
    return any;
  }

  void prepare(vertex_index v, const vertex_fan& fan) {
    if (used_ == prepared_.size()) prepared_.emplace_back();
    prepared_fan& p = prepared_[used_++];
    p.v = v;
    p.link = fan.link;
    p.reach = 0;
    p.reach_concerned = 0;
    p.has_concerned = p.has_others = false;
    p.neighbours.clear();
    context_.fans.visit(v, [&p](const vertex_fan& each) {
      p.neighbours.insert(p.neighbours.end(), each.link.begin(), each.link.end());
    });
    p.rays.clear();
    const quick_reaches reaches(at(v));
    measured_.clear();
    for (const vertex_index r : fan.link) {
      p.rays.push_back(to(v, r));
      measured_.push_back(reaches.ray_to(at(r)));
    }
    p.gaps.clear();
    const std::size_t n = fan.link.size();
    for (std::size_t i = 0; i + (fan.closed ? 0 : 1) < n; ++i) {
      fan_gap& gap = p.gaps.emplace_back(fan.link[i], fan.link[(i + 1) % n]);
      gap.is_skipped = find_subsegment(context_, gap.x, gap.y) != context_.subject.boundary.size();
      if (gap.is_skipped) continue;
      gap.is_concerned = around_.concerns(v, gap.x, gap.y);
      gap.reach = reach_of(v, gap, reaches, measured_[i], measured_[(i + 1) % n]);
      if (gap.is_concerned && is_left_open(gap)) {
        leave_open(v, v, gap.x, gap.y, open_question::about::gap);
        gap.is_skipped = true;
        continue;
      }
      p.reach = greatest_bound(p.reach, gap.reach);
      (gap.is_concerned ? p.has_concerned : p.has_others) = true;
      if (gap.is_concerned) p.reach_concerned = greatest_bound(p.reach_concerned, gap.reach);
    }
  }

  bool is_left_open(const fan_gap& gap) const {
    return context_.leaves_open && !is_finite(gap.reach) &&
           around_.at.size() >= context_.memory->many_for_a_gap;
  }

  // Returns how far the gap reaches: most do not need to be prepared for that, nor for any
  // question. Nothing better than a few edges of the gap is worth its cost.
  double reach_of(vertex_index v, const fan_gap& gap, const quick_reaches& reaches,
                  const measured_ray& to_x, const measured_ray& to_y) const {
    constexpr double edges = 2;
    const double quick = reaches.between(to_x, to_y);
    if (quick <= edges * std::max(to_x.length, to_y.length)) return quick;
    if (const star_gap* prepared = prepared_gap(v, gap); prepared != nullptr)
      if (const double reach = prepared->reach(); is_finite(reach)) return std::min(quick, reach);
    if (is_finite(quick)) return quick;
    return filter_of(v, gap).reach();
  }

  // Returns the kernel's gap, made when it is first asked for; null where it is not to be shared.
  const star_gap* prepared_gap(vertex_index v, const fan_gap& gap) const {
    if (context_.options.own_filter_alone) return nullptr;
    if (!gap.prepared) gap.prepared.emplace(at(v), at(gap.x), at(gap.y));
    return &*gap.prepared;
  }
  const star_gap_filter& filter_of(vertex_index v, const fan_gap& gap) const {
    if (!gap.filter) gap.filter.emplace(at(v), at(gap.x), at(gap.y));
    return *gap.filter;
  }

  vector2<double> to(vertex_index v, vertex_index w) const {
    return {context_.at(w).x - context_.at(v).x, context_.at(w).y - context_.at(v).y};
  }

  // Returns on which side of the ray from v to link[i] w is. The area is off by at most four
  // roundings, 2^-50, of its magnitude; in the range asked for underflow takes less than the rest
  // of 2^-49.
  sign side(const prepared_fan& p, std::size_t i, const vector2<double>& to_w,
            vertex_index w) const {
    const double left = p.rays[i].x * to_w.y, right = p.rays[i].y * to_w.x;
    const double turned = left - right, size = std::abs(left) + std::abs(right);
    if (std::abs(turned) > 0x1p-49 * size && size > 0x1p-900 && size < 0x1p1000)
      return turned > 0 ? sign::positive : sign::negative;
    return turn(p.v, p.link[i], w);
  }

  // Returns the gap strictly between whose rays w lies; none on a ray or outside an open fan.
  const fan_gap* gap_of(const prepared_fan& p, vertex_index w) const {
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

  // Holds w against the gap it is in, if that is one of those asked about.
  void check_other(const prepared_fan& p, vertex_index w, double squared, bool at_concerned) {
    const fan_gap* gap = gap_of(p, w);
    if (gap == nullptr || gap->is_skipped || gap->is_concerned != at_concerned) return;
    if (site_tree::is_too_far_by(squared, gap->reach)) return;
    // Where nothing is told the tree has asked w's own metric, for the reach of the fan.
    const bool is_asked = squared == 0 && !(gap->reach < p.reach);
    if (!is_asked && site_tree::is_too_far(at(p.v), gap->reach, at(w))) return;
    ++tally_.part.star_pairs;
    if (!is_accepted(p.v, w, *gap) || !sight_.clear(p.v, w)) return;
    tally_.found(finding_kind::star_site_missing,
                 "the star of " + vertex_text(context_, p.v) + " would accept " +
                     vertex_text(context_, w) + " between " + vertex_text(context_, gap->x) +
                     " and " + vertex_text(context_, gap->y),
                 {p.v, w, gap->x, gap->y});
  }

  bool is_accepted(vertex_index v, vertex_index w, const fan_gap& gap) {
    const star_gap* prepared = prepared_gap(v, gap);
    if (prepared != nullptr) {
      const uncertain_bool by_v = prepared->accepts(at(w));
      if (by_v.certain()) return by_v.value();
    }
    // Made once for a gap, and cheaper than a gap of w's.
    if (filter_of(v, gap).excludes(at(w))) return false;
    if (prepared != nullptr) {
      // The question is the same to w, who often sees it more clearly.
      const uncertain_bool by_w = star_gap(at(w), at(gap.y), at(gap.x)).accepts(at(v));
      if (by_w.certain()) return by_w.value();
    }
    // Slower than both, and worth it: edge_test takes thirty times as long when it comes to
    // intervals.
    if (star_gap_filter(at(w), at(gap.y), at(gap.x)).excludes(at(v))) return false;
    if (context_.leaves_open) {
      if (sight_.clear(v, w)) leave_open(v, w, gap.x, gap.y, open_question::about::other_site);
      return false;
    }
    ++tally_.part.star_pairs_tested;
    return tally_.kernel().edge_test(at(v), at(w), at(gap.x), at(gap.y));
  }

  // Returns whether the neighbour w is accepted; true, once that is noted, where it is left open.
  bool is_accepted_or_open(vertex_index v, vertex_index w, vertex_index x, vertex_index y) {
    if (!context_.leaves_open) return tally_.kernel().edge_test(at(v), at(w), at(x), at(y));
    const uncertain_bool answer =
        filtered_edge_test(at(v), at(w), at(x), at(y), tally_.part.counters);
    if (answer.certain()) return answer.value();
    leave_open(v, w, x, y, open_question::about::neighbour);
    return true;
  }

  void leave_open(vertex_index v, vertex_index w, vertex_index x, vertex_index y,
                  open_question::about what) {
    tally_.left_open.push_back({{v, w, x, y}, what});
  }

  // Work of a look at a site, and of the ray that it is held against, as they take 50 and 5
  // nanoseconds.
  static constexpr double unit_of_look = 0.005, unit_of_gap = 0.0005;

  const audit_context& context_;
  audit_tally& tally_;
  audit_patience patience_;
  const star_surroundings& around_;
  visibility_test sight_;
  // Scratch for the vertices at hand; members to spare allocations.
  std::vector<prepared_fan> prepared_;  // the first used_
  std::size_t used_ = 0;
  std::vector<site_tree::reaching> reaching_;
  site_tree::nearby_sites nearby_;
  std::vector<measured_ray> measured_;
};

// True if nothing was found, and nothing left open, so far.
bool found_nothing(const audit_context& context) {
  const bool are_open = context.memory != nullptr && !context.memory->open.empty();
  return context.report.total_found() == 0 && !are_open;
}

// How a look at stars ended.
enum class look_end { all, refused, unfinished };

// Looks at stars one after the other. Refused where more than `most` was found, unfinished after
// the most work that is done for so many sites, or when it is cancelled.
look_end check_in_turn(audit_context& context, const star_surroundings& around,
                       const check_order& in_order, bool neighbours_alone, std::size_t most) {
  const auto& [order, groups, together] = in_order;
  const std::size_t before = context.report.total_found();
  const auto check = [&](audit_tally& tally, std::size_t begin, std::size_t end) {
    star_check part(context, tally, around);
    for (std::size_t i = begin; i < end && !part.is_over(); i += together)
      part.run(order.data() + groups[i], order.data() + groups[std::min(i + together, end)],
               order.data() + order.size(), neighbours_alone);
  };
  const auto is_refused = [&] { return context.report.total_found() - before > most; };
  if (check_in_parts(context, groups.size() - 1, check, is_refused)) return look_end::all;
  return is_refused() ? look_end::refused : look_end::unfinished;
}

void note_end(audit_context& context, look_end how) {
  if (how == look_end::refused) context.report.stars_cut_short = true;
  if (how != look_end::unfinished) return;
  context.report.stars_checked = false;
  context.found(finding_kind::stopped, unfinished_text(context, "the stars"));
}

// True if the neighbours, once none is rejected and nothing else is found or left open, leave no
// other site to look for (docs/math/certificate.md, 4.0).
bool have_one_metric(const std::vector<site>& sites) {
  return std::all_of(sites.begin(), sites.end(),
                     [&](const site& s) { return identical(s.metric, sites.front().metric); });
}

// Makes reaches in the memory that were found in other units, or not at all, unknown ones.
void take_reaches(const audit_context& context, int power_of_squares) {
  star_memory& memory = *context.memory;
  const bool are_known = !memory.reaches.empty() && memory.power_of_squares == power_of_squares;
  memory.power_of_squares = power_of_squares;
  if (!are_known)
    memory.reaches.assign(context.subject.sites.size(), std::numeric_limits<double>::infinity());
}

// True if a walk may spare the tree: where all stars are looked at, and nothing is to be remembered
// of them. Who leaves out the prepared gaps looks at all in a second way, too.
bool may_walk(const audit_context& context, const star_surroundings& around) {
  return context.memory == nullptr && context.changed == nullptr && around.unit.empty() &&
         !context.options.own_filter_alone;
}

// Looks at all sites in reach of the stars that a walk does not settle; of all stars where it
// settles few, or something was found already.
look_end check_others(audit_context& context, star_surroundings& around, std::size_t most,
                      bool may_be_walked) {
  constexpr std::size_t few = 8;  // a part of the sites
  std::optional<walk_outcome> walked;
  if (may_be_walked) walked = walk_stars(context, around);
  if (walked && walked->has_failed) walked.reset();
  const auto left = walked ? static_cast<std::size_t>(std::count(walked->is_left.begin(),
                                                                 walked->is_left.end(), char{1}))
                           : around.at.size();
  if (left == 0) return look_end::all;
  around.plant(context);
  const check_order all = in_order_of_tree(*around.sites);
  const bool is_part = left < around.at.size() / few;
  return check_in_turn(context, around, is_part ? part_of(all, walked->is_left) : all, false, most);
}

// Looks at all sites where neighbours suffice, as a second way to the answer, with half of the
// work. What that is not enough for is settled as it was: thousands of sites on a line, where each
// star sees them all.
look_end check_others_again(audit_context& context, star_surroundings& around, std::size_t most) {
  const double share = context.share_of_work;
  context.share_of_work = share / 2;
  const look_end how = check_others(context, around, most, false);
  context.share_of_work = share;
  if (how != look_end::unfinished || context.options.stop.poll()) return how;
  context.unfinished = false;
  return look_end::all;
}

}  // namespace

// Looks at neighbours first, then at all sites in reach. Ends where as much is refused as a tenth
// of the sites, unless every finding is to be kept: such stars see far, and to look at all of them
// would only say so again. Ends, too, after the most work that is done (audit/audit_work.hpp); of
// that a mesh which is refused already, for its angles or its domain, has a part.
void check_stars(audit_context& context) {
  constexpr std::size_t all = std::numeric_limits<std::size_t>::max(), part = 10;
  const std::size_t most = context.options.findings_kept == all ? all : context.report.sites / part;
  constexpr double of_refused = 0.2;
  if (most != all && context.report.total_found() > 0) context.share_of_work = of_refused;
  context.report.stars_checked = true;
  star_surroundings around(context);
  if (context.memory != nullptr) take_reaches(context, around.power_of_squares);
  const bool may_suffice = have_one_metric(context.subject.sites),
             walks = may_walk(context, around);
  const bool in_two_ways = context.options.own_filter_alone;
  check_order order;
  if ((may_suffice && !in_two_ways) || walks) {
    order = in_order_of_mesh(context.subject.sites.size());
  } else {
    around.plant(context);
    order = in_order_of_tree(*around.sites);
  }
  const std::size_t before = context.report.total_found();
  const look_end neighbours = check_in_turn(context, around, order, true, most);
  if (neighbours != look_end::all) return note_end(context, neighbours);
  const bool suffice = may_suffice && found_nothing(context);
  if (suffice && !in_two_ways) return;
  note_end(context, suffice ? check_others_again(context, around, most)
                            : check_others(context, around, most,
                                           walks && context.report.total_found() == before));
}

}  // namespace asterism::internal::audit_detail
