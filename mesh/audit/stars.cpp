// SPDX-License-Identifier: MIT
//
// Point 4: the triangles of the mesh around v are the star of v. Stars are not built again but
// recognised: a star is final when (a) each of its neighbours, taken out, would be accepted again,
// and (b) no other site that v sees inside the domain would be. The two ends of an open fan are
// boundary subsegments or internal ones, and stay. Requires what points 0 to 2 prove: no site lies
// on an edge or inside a triangle, so that a site on the ray of a neighbour is farther than it, and
// a site in a gap is beyond the gap's edge. Source: the thesis, section 3.3 (INSERTIONTEST) and
// definition 9.
//
// Where a mesh's metric varies much over an edge, stars have a great reach, and thousands of sites
// must be tested against each. Such a mesh also has edges that the test against the site across
// them refuses. So edges are tested first; if some are refused, so is the mesh, and the other tests
// are left out. Where all sites have one metric and no edge is refused, no other test is needed.
#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "asterism/mesh/audit/audit_work.hpp"
#include "asterism/mesh/audit/check_order.hpp"
#include "asterism/mesh/audit/checks.hpp"
#include "asterism/mesh/audit/site_tree.hpp"
#include "asterism/mesh/audit/star_check.hpp"
#include "asterism/mesh/audit/star_surroundings.hpp"

namespace asterism::internal::audit_detail {
namespace {

// True if no finding was made and no question left open so far.
bool found_nothing(const audit_context& context) {
  const bool are_open = context.memory != nullptr && !context.memory->open.empty();
  return context.report.total_found() == 0 && !are_open;
}

// Result of a check of some stars: all checked, mesh refused early, or work used up.
enum class look_end { all, refused, unfinished };

// Checks stars in order. Ends as `refused` after more than `most` findings, and as `unfinished`
// once the work limit for the number of sites is reached, or when the run is cancelled.
look_end check_in_turn(audit_context& context, const star_surroundings& around,
                       const check_order& in_order, bool neighbours_alone, std::size_t most) {
  const std::vector<vertex_index>& order = in_order.vertices;
  const std::vector<std::size_t>& groups = in_order.groups;
  const std::size_t together = in_order.together;
  const std::size_t before = context.report.total_found();
  star_lists_pool pool;
  const auto check = [&](audit_tally& tally, std::size_t begin, std::size_t end) {
    star_check part(context, tally, around, pool.take());
    for (std::size_t i = begin; i < end && !part.is_over(); i += together)
      part.run(order.data() + groups[i], order.data() + groups[std::min(i + together, end)],
               order.data() + order.size(), neighbours_alone);
    pool.give_back(part.take_lists());
  };
  const auto is_refused = [&] { return context.report.total_found() - before > most; };
  if (check_in_parts(context, groups.size() - 1, check, is_refused)) return look_end::all;
  return is_refused() ? look_end::refused : look_end::unfinished;
}

// Enters a finding that the check ended early.
void note_end(audit_context& context, look_end how) {
  if (how == look_end::refused) context.report.stars_cut_short = true;
  if (how != look_end::unfinished) return;
  context.report.stars_checked = false;
  context.found(finding_kind::stopped, unfinished_text(context, "the stars"));
}

// True if all sites have one metric: then the tests of neighbours suffice, if none is rejected and
// nothing else is found or left open (docs/math/certificate.md, 4.0).
bool have_one_metric(const std::vector<site>& sites) {
  return std::all_of(sites.begin(), sites.end(),
                     [&](const site& s) { return identical(s.metric, sites.front().metric); });
}

// Resets the remembered reaches to unknown if the memory has none, or has them in other units.
void take_reaches(const audit_context& context, int power_of_squares) {
  audit_memory& memory = *context.memory;
  const bool are_known = !memory.reaches.empty() && memory.power_of_squares == power_of_squares;
  memory.power_of_squares = power_of_squares;
  if (!are_known)
    memory.reaches.assign(context.subject.sites.size(), std::numeric_limits<double>::infinity());
}

// Tests every star against all sites in its reach.
look_end check_others(audit_context& context, star_surroundings& around, std::size_t most) {
  around.plant(context);
  return check_in_turn(context, around, in_order_of_tree(*around.sites), false, most);
}

// Tests against all sites although the tests of neighbours suffice, as a second proof, with half of
// the work limit. If the limit is too low, as for thousands of sites on a line, each of which is in
// reach of all others, the first proof counts.
look_end check_others_again(audit_context& context, star_surroundings& around, std::size_t most) {
  const double share = context.share_of_work;
  context.share_of_work = share / 2;
  const look_end how = check_others(context, around, most);
  context.share_of_work = share;
  if (how != look_end::unfinished || context.told || context.options.stop.poll()) return how;
  context.unfinished = false;
  return look_end::all;
}

}  // namespace

// Tests stars against their neighbours first, then against all sites in reach. Ends once the number
// of refused edges exceeds a tenth of the number of sites, unless every finding is to be kept: such
// stars have a great reach, and testing them all would only refuse the mesh again. Ends, too, at
// the work limit (audit/audit_work.hpp), which is a part of the usual one if the mesh is refused
// already.
void check_stars(audit_context& context) {
  constexpr std::size_t all = std::numeric_limits<std::size_t>::max(), part = 10;
  const std::size_t most = context.options.findings_kept == all ? all : context.report.sites / part;
  constexpr double of_refused = 0.2;
  if (most != all && context.report.total_found() > 0) context.share_of_work = of_refused;
  context.report.stars_checked = true;
  star_surroundings around(context);
  if (context.memory != nullptr) take_reaches(context, around.power_of_squares);
  const bool may_suffice = have_one_metric(context.subject.sites);
  const bool in_two_ways = context.options.own_filter_alone;
  check_order order;
  // Checks in the order of the vertices where findings are reported, and in that of the tree where
  // open questions are passed to the next audit.
  if (!in_two_ways && (may_suffice || context.memory == nullptr)) {
    order = in_order_of_mesh(context.subject.sites.size());
  } else {
    around.plant(context);
    order = in_order_of_tree(*around.sites);
  }
  const look_end neighbours = check_in_turn(context, around, order, true, most);
  if (neighbours != look_end::all) return note_end(context, neighbours);
  const bool suffice = may_suffice && found_nothing(context);
  if (suffice && !in_two_ways) return;
  note_end(context, suffice ? check_others_again(context, around, most)
                            : check_others(context, around, most));
}

}  // namespace asterism::internal::audit_detail
