// SPDX-License-Identifier: MIT
//
// Point 4: the triangles of the mesh around v are the star of v. Not built again but recognised: a
// star is final when (a) each of its neighbours, taken out, would be accepted again, and (b) no
// other site that v sees inside the domain would be. The two ends of an open fan are boundary
// pieces or internal ones, and stay.
// Requires what points 0 to 2 prove: no site lies on an edge or inside a triangle, so that a site
// on the ray of a neighbour is farther than it, and a site in a gap is beyond the gap's edge.
// Source: the thesis, section 3.3 (INSERTIONTEST) and definition 9.
#include <algorithm>
#include <optional>

#include "asterism/mesh/audit_context.hpp"
#include "asterism/mesh/audit_star_filter.hpp"

namespace asterism::audit_detail {
namespace {

// Does some boundary piece meet the open segment between v and w? Such a w is not seen from v: what
// v sees is joined to it inside the domain.
class sight {
 public:
  explicit sight(const audit_context& context) : context_(context) {}

  bool clear(index v, index w) const {
    const auto& pieces = context_.pieces;
    return std::none_of(pieces.begin(), pieces.end(),
                        [&](index p) { return blocks(context_.subject.boundary[p], v, w); });
  }

 private:
  bool blocks(const boundary_edge& e, index v, index w) const {
    const point &p = context_.at(v), &q = context_.at(w);
    const point &a = context_.at(e.a), &b = context_.at(e.b);
    if (std::max(a.x, b.x) < std::min(p.x, q.x) || std::min(a.x, b.x) > std::max(p.x, q.x) ||
        std::max(a.y, b.y) < std::min(p.y, q.y) || std::min(a.y, b.y) > std::max(p.y, q.y))
      return false;
    const sign side_a = context_.orientation(v, w, e.a);
    const sign side_b = context_.orientation(v, w, e.b);
    if (side_a == sign::zero && inside_segment(e.a, v, w)) return true;
    if (side_b == sign::zero && inside_segment(e.b, v, w)) return true;
    if (side_a * side_b != sign::negative) return false;
    return context_.orientation(e.a, e.b, v) * context_.orientation(e.a, e.b, w) == sign::negative;
  }

  // For q on the line of v and w.
  bool inside_segment(index q, index v, index w) const {
    return q != v && q != w && same_ray(context_.at(v), context_.at(q), context_.at(w)) &&
           same_ray(context_.at(w), context_.at(q), context_.at(v));
  }

  const audit_context& context_;
};

// One gap of a fan, from x counter-clockwise to y.
struct star_gap {
  index x = 0, y = 0;
  bool on_boundary = false;  // x -> y is a boundary piece or internal: nothing beyond it is seen
  std::optional<star_gap_filter> filter;
};

class star_check {
 public:
  explicit star_check(audit_context& context)
      : context_(context), sight_(context), tree_(context.subject.sites) {}

  void run(index v) {
    neighbours_.clear();
    for (const vertex_fan& fan : context_.fans[v]) {
      neighbours_.insert(neighbours_.end(), fan.link.begin(), fan.link.end());
      check_neighbours(v, fan);
    }
    std::sort(neighbours_.begin(), neighbours_.end());
    for (const vertex_fan& fan : context_.fans[v]) {
      const star_reach reach = list_gaps(v, fan);
      for (const index w : tree_.near(at(v), reach))
        if (w != v && !std::binary_search(neighbours_.begin(), neighbours_.end(), w))
          check_other(v, fan, w);
    }
  }

 private:
  const site& at(index v) const { return context_.subject.sites[v]; }

  void check_neighbours(index v, const vertex_fan& fan) {
    const std::size_t n = fan.link.size();
    const std::size_t skipped = fan.closed ? 0 : 1;
    for (std::size_t i = skipped; i + skipped < n; ++i) {
      const index w = fan.link[i], x = fan.link[(i + n - 1) % n], y = fan.link[(i + 1) % n];
      if (context_.orientation(v, x, y) != sign::positive) continue;  // a half turn or more
      if (context_.orientation(x, y, w) == sign::positive) continue;  // inside the triangle v, x, y
      if (context_.kernel.edge_test(at(v), at(w), at(x), at(y))) continue;
      context_.found(finding_kind::star_neighbour_rejected,
                     "the star of " + vertex_text(context_, v) + " does not accept its neighbour " +
                         vertex_text(context_, w) + " between " + vertex_text(context_, x) +
                         " and " + vertex_text(context_, y));
    }
  }

  // Fills rays_ and gaps_.
  star_reach list_gaps(index v, const vertex_fan& fan) {
    star_reach reach;
    rays_.clear();
    for (const index r : fan.link)
      rays_.push_back(difference<bounded>(context_.at(r), context_.at(v)));
    gaps_.clear();
    const std::size_t n = fan.link.size();
    for (std::size_t i = 0; i + (fan.closed ? 0 : 1) < n; ++i) {
      star_gap gap{fan.link[i], fan.link[(i + 1) % n], false, {}};
      gap.on_boundary = find_piece(context_, gap.x, gap.y) != context_.subject.boundary.size();
      if (!gap.on_boundary) {
        const star_reach own = gap.filter.emplace(at(v), at(gap.x), at(gap.y)).reach();
        reach = {greatest_bound(reach.radius, own.radius),
                 greatest_bound(reach.longest, own.longest)};
      }
      gaps_.push_back(gap);
    }
    return reach;
  }

  // Which side of the ray from v to fan.link[i] is w on?
  sign side(index v, const vertex_fan& fan, std::size_t i, const vector2<bounded>& to_w, index w) {
    const bounded turned = cross(rays_[i], to_w);
    if (turned.certainly_positive()) return sign::positive;
    if (turned.certainly_negative()) return sign::negative;
    return context_.orientation(v, fan.link[i], w);
  }

  // The gap strictly between whose rays w lies; none on a ray or outside an open fan.
  const star_gap* gap_of(index v, const vertex_fan& fan, index w) {
    const auto to_w = difference<bounded>(context_.at(w), context_.at(v));
    const std::size_t n = fan.link.size();
    sign before = side(v, fan, 0, to_w, w);
    for (std::size_t i = 0; i < gaps_.size(); ++i) {
      const sign after = side(v, fan, (i + 1) % n, to_w, w);
      if (before == sign::positive && after == sign::negative) return &gaps_[i];
      before = after;
    }
    return nullptr;
  }

  void check_other(index v, const vertex_fan& fan, index w) {
    const star_gap* gap = gap_of(v, fan, w);
    if (gap == nullptr || gap->on_boundary) return;
    ++context_.report.star_pairs;
    if (gap->filter->excludes(at(w))) return;
    ++context_.report.star_pairs_tested;
    if (!context_.kernel.edge_test(at(v), at(w), at(gap->x), at(gap->y))) return;
    if (!sight_.clear(v, w)) return;
    context_.found(finding_kind::star_site_missing,
                   "the star of " + vertex_text(context_, v) + " would accept " +
                       vertex_text(context_, w) + " between " + vertex_text(context_, gap->x) +
                       " and " + vertex_text(context_, gap->y));
  }

  audit_context& context_;
  sight sight_;
  site_tree tree_;
  // Of the fan at hand; members to spare allocations.
  std::vector<vector2<bounded>> rays_;
  std::vector<star_gap> gaps_;
  std::vector<index> neighbours_;
};

}  // namespace

void check_stars(audit_context& context) {
  context.report.stars_checked = true;
  star_check check(context);
  for (index v = 0; v < context.subject.sites.size(); ++v) check.run(v);
}

}  // namespace asterism::audit_detail
