// SPDX-License-Identifier: MIT
#include "asterism/mesh/stars/star_finality.hpp"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <vector>

#include "asterism/kernels/semi_static_filter.hpp"
#include "asterism/kernels/star_gap.hpp"
#include "asterism/mesh/stars/star_insertion.hpp"
#include "asterism/mesh/support/infinity.hpp"

namespace asterism::internal {
namespace {

// Gap of a sector from neighbour y counter-clockwise to x.
struct prepared_gap {
  vertex_index y = 0, x = 0;
  bool on_boundary = false;         // accepts nothing
  std::optional<star_gap> content;  // unless on the boundary, or half a turn or more

  double reach() const {
    if (on_boundary) return 0;
    return content ? content->reach() : infinity;
  }
};

// One sector of v's star with its gaps prepared for many tests.
class prepared_sector {
 public:
  prepared_sector(const site_oracle& oracle, vertex_index v, const sector& part)
      : oracle_(&oracle), v_(v), part_(&part), gaps_(part.gaps()) {
    for (std::size_t i = 0; i < gaps_.size(); ++i) {
      prepared_gap& gap = gaps_[i];
      gap.y = part.neighbours[i];
      gap.x = part.neighbours[part.after(i)];
      gap.on_boundary = oracle.edges().is_subsegment(gap.y, gap.x);
      // Prepares no gaps of half a turn or more: they accept sites that a prepared gap would
      // refuse.
      if (!gap.on_boundary && holds_triangle(oracle, v, part, i))
        gap.content.emplace(at(v), at(gap.y), at(gap.x));
    }
  }

  bool is_at_boundary() const {
    return std::any_of(gaps_.begin(), gaps_.end(),
                       [](const prepared_gap& gap) { return gap.on_boundary; });
  }

  double reach() const {
    if (gaps_.empty()) return infinity;
    double reach = 0;
    for (const prepared_gap& gap : gaps_) reach = std::max(reach, gap.reach());
    return reach;
  }

  // Returns a reach that covers most gaps: the largest one that is at most `times` the median.
  double common_reach(double times) const {
    boost::container::small_vector<double, 16> all;
    for (const prepared_gap& gap : gaps_)
      if (!gap.on_boundary) all.push_back(gap.reach());
    if (all.empty()) return 0;
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    std::nth_element(all.begin(), middle, all.end());
    const double most = times * *middle;
    double reach = 0;
    for (const double r : all)
      if (r <= most && r < infinity) reach = std::max(reach, r);
    return reach;
  }

  // Visits every site that may lie in a gap whose reach exceeds `common`, within that reach; all
  // sites if one of these gaps is half a turn or more.
  template <class Visit>
  bool visit_gaps_beyond(double common, const Visit& visit) const {
    const site_index& near = oracle_->near()->sites();
    const auto is_wide = [](const prepared_gap& gap) { return !gap.on_boundary && !gap.content; };
    if (gaps_.empty() || std::any_of(gaps_.begin(), gaps_.end(), is_wide))
      return near.visit_reach(oracle_->sites(), at(v_), infinity, visit);
    return std::all_of(gaps_.begin(), gaps_.end(), [&](const prepared_gap& gap) {
      return gap.reach() <= common ||
             near.visit_cone(oracle_->sites(), at(v_), gap.reach(), at(gap.y).position,
                             at(gap.x).position, visit);
    });
  }

  // True if w is certainly not accepted. Requires that w is not in the star.
  bool certainly_refuses(vertex_index w) const {
    const prepared_gap* gap = gap_in_doubles(w);
    if (gap == nullptr) {
      const placement where = locate(*oracle_, v_, *part_, w);
      if (where.kind == placement_kind::outside) return true;
      if (where.kind == placement_kind::on_ray || gaps_.empty()) return false;
      gap = &gaps_[where.at];
    }
    if (!gap->content) return false;
    // Returns false for sites inside the gap's triangle: the star accepts these without an
    // edge_test.
    return refuses(*gap, w) && oracle_->orientation(gap->y, gap->x, w) != sign::positive;
  }

 private:
  const site& at(vertex_index u) const { return oracle_->sites()[u]; }

  // True if the gap certainly refuses w. If v's test is undecided, evaluates w's: it answers the
  // same question, and may have the smaller error.
  bool refuses(const prepared_gap& gap, vertex_index w) const {
    const uncertain_bool by_v = gap.content->accepts(at(w));
    if (by_v.certain()) return !by_v.value();
    const uncertain_bool by_w = star_gap(at(w), at(gap.x), at(gap.y)).accepts(at(v_));
    return by_w.certain() && !by_w.value();
  }

  // Returns the gap of less than half a turn whose two rays w lies strictly between; none if
  // doubles do not decide which.
  const prepared_gap* gap_in_doubles(vertex_index w) const {
    if (gaps_.empty()) return nullptr;
    const point &v = at(v_).position, &q = at(w).position;
    bool left_of_y =
        semi_static::orientation(v, at(gaps_[0].y).position, q).certainly(sign::positive);
    for (const prepared_gap& gap : gaps_) {
      const uncertain_sign side = semi_static::orientation(v, at(gap.x).position, q);
      if (left_of_y && side.certainly(sign::negative)) return &gap;
      left_of_y = side.certainly(sign::positive);
    }
    return nullptr;
  }

  const site_oracle* oracle_;
  vertex_index v_;
  const sector* part_;
  std::vector<prepared_gap> gaps_;
};

}  // namespace

std::optional<double> final_reach(const site_oracle& oracle, vertex_index v, const star& s,
                                  unbounded_gaps unbounded) {
  std::vector<prepared_sector> sectors;
  sectors.reserve(s.sectors.size());
  // Multiple of the median reach up to which gaps share one search around v. Each gap with a longer
  // reach is searched by itself, so that it adds no sites to the tests of the other gaps.
  constexpr double much = 1.5;
  double reach = 0, common = 0;
  bool at_boundary = false;
  for (const sector& part : s.sectors) {
    sectors.emplace_back(oracle, v, part);
    reach = std::max(reach, sectors.back().reach());
    common = std::max(common, sectors.back().common_reach(much));
    at_boundary = at_boundary || sectors.back().is_at_boundary();
  }
  if (reach == infinity && unbounded == unbounded_gaps::give_up) return std::nullopt;
  const auto refused = [&](vertex_index w) {
    if (w == v || s.contains(w)) return true;
    if (oracle.is_over()) return false;
    return std::all_of(sectors.begin(), sectors.end(),
                       [w](const prepared_sector& p) { return p.certainly_refuses(w); }) ||
           !would_accept(oracle, v, s, w);
  };
  if (common > 0 &&
      !oracle.near()->sites().visit_reach(oracle.sites(), oracle.sites()[v], common, refused))
    return std::nullopt;
  for (const prepared_sector& p : sectors)
    if (!p.visit_gaps_beyond(common, refused)) return std::nullopt;
  // Sets an infinite reach at the boundary: a split of a subsegment opens the gap it closed.
  return at_boundary ? infinity : reach;
}

}  // namespace asterism::internal
