// SPDX-License-Identifier: MIT
#include "asterism/mesh/proof/meeting_witness.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "asterism/mesh/proof/gap_row.hpp"
#include "asterism/mesh/proof/meeting.hpp"
#include "asterism/mesh/proof/star_pairs.hpp"

namespace asterism::internal::proof_detail {
namespace {

using exceptions_of_proof = std::span<const proof_exception>;

const proof_exception* meeting_of(exceptions_of_proof exceptions, std::uint32_t gap,
                                  vertex_index w) {
  const proof_exception* found = exception_of(exceptions, gap, w);
  if (found == nullptr || found->why != proof_exception::reason::meeting) return nullptr;
  return found;
}

// Holds the gap of a row of kind `meeting`, and the site beyond the edge of its two neighbours.
struct meeting_gap {
  gap_sites sites;
  const site& beyond;
  std::size_t turn = 0;
};

meeting_gap gap_of(const plane& all, const proof_exception& e) {
  const gap_sites g = sites_of_gap(all, e.gap);
  const site& w = all.subject.sites[e.site];
  if (e.turn < turn_by_site) return {g, w, e.turn};
  return {{w, g.y, g.x}, g.v, e.turn - std::size_t{turn_by_site}};
}

bool is_edge_shown(const plane& all, const proof_exception* e) {
  if (e == nullptr) return false;
  const auto [g, w, turn] = gap_of(all, *e);
  if (turn < 1 || turn + 1 >= e->points.size()) return false;
  const meeting_box box{as_grid_point(e->points[turn - 1]), as_grid_point(e->points[turn]),
                        as_grid_point(e->points[turn + 1])};
  return is_edge_at_meeting({g.v, g.x, g.y, w}, box, e->weights);
}

bool is_refusal_shown(const plane& all, const proof_exception* e) {
  if (e == nullptr) return false;
  const auto [g, w, turn] = gap_of(all, *e);
  const std::vector<grid_point> points = points_of(*e);
  const gap_row row{points, turn};
  return is_sound(g, row) && refuses_but_at_turn(g, row, w) && is_edge_shown(all, e);
}

}  // namespace

const proof_exception* exception_of(std::span<const proof_exception> exceptions, std::uint32_t gap,
                                    vertex_index w) {
  const auto key = std::pair(w, gap);
  const auto found = std::lower_bound(
      exceptions.begin(), exceptions.end(), key,
      [](const proof_exception& e, const std::pair<vertex_index, std::uint32_t>& k) {
        return std::pair(e.site, e.gap) < k;
      });
  if (found == exceptions.end() || std::pair(found->site, found->gap) != key) return nullptr;
  return &*found;
}

std::uint32_t gap_behind(const plane& all, std::uint32_t gap) {
  const std::uint32_t reverse = all.across[plane::next(gap)];
  if (reverse == plane::none || reverse / 3 >= all.inner_count()) return plane::none;
  return plane::previous(reverse);
}

bool is_kept_at_meeting(const plane& all, std::span<const proof_exception> exceptions,
                        std::uint32_t edge) {
  const std::uint32_t left = plane::previous(edge), right = gap_behind(all, left);
  if (right == plane::none) return false;
  return is_edge_shown(all, meeting_of(exceptions, left, all.corner(right))) ||
         is_edge_shown(all, meeting_of(exceptions, right, all.corner(left)));
}

bool is_refused_at_meeting(const plane& all, std::span<const proof_exception> exceptions,
                           std::uint32_t gap, vertex_index w) {
  if (is_refusal_shown(all, meeting_of(exceptions, gap, w))) return true;
  const std::uint32_t behind = gap_behind(all, gap);
  return behind != plane::none && all.corner(behind) == w &&
         is_refusal_shown(all, meeting_of(exceptions, behind, all.corner(gap)));
}

}  // namespace asterism::internal::proof_detail
