// SPDX-License-Identifier: MIT
#include "asterism/mesh/fill/net_completion.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/fill/domain_locator.hpp"
#include "asterism/mesh/fill/work_meter.hpp"
#include "asterism/mesh/metric/field_sampler.hpp"
#include "asterism/mesh/numerics/constructions.hpp"
#include "asterism/mesh/numerics/eight_directions.hpp"
#include "asterism/mesh/numerics/metric_algebra.hpp"
#include "asterism/mesh/numerics/metric_box.hpp"
#include "asterism/mesh/search/site_index.hpp"
#include "asterism/mesh/support/infinity.hpp"

namespace asterism::internal {
namespace {

// Part of the covering radius: a point farther than this from all sites leads to a new site. A box
// without such a point is divided until its parts, in the sites' metrics, are no longer than the
// rest of the radius; only boxes beside points that are nearly as far become so small.
constexpr double part_of_covering = 1 - 0x1p-20;
// Bounds the number of boxes, for each site and in all: about 200 a site are usual.
constexpr std::size_t most_boxes_a_site = 4096, most_boxes = 1U << 20U;
// Factor by which search boxes are enlarged, since the metrics of two sites measure the distance
// between them differently. Where these distances differ by a larger factor, a search may miss
// sites; the theorem on nets (docs/math/guarantee.md) is then not claimed.
constexpr double search_margin = 1.25;

std::array<point, 4> corners_of(const bounding_box& b) {
  return {{b.low, {b.high.x, b.low.y}, b.high, {b.low.x, b.high.y}}};
}

bool meet(const bounding_box& a, const bounding_box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

// A box that is to be covered, with the sites and segments of the domain that may reach into it.
struct open_box {
  bounding_box box;
  std::vector<vertex_index> sites;
  std::vector<std::uint32_t> segments;
  std::size_t sites_known = 0;  // those from this number on came later
};

class net_completion {
 public:
  net_completion(const domain& d, const metric_field& field, const net_options& options)
      : domain_(d),
        options_(options),
        sampler_(field),
        locator_(d),
        index_(d.box(), site_index::purpose::places) {}

  result<net_report> run(filled_domain& proposed) {
    list_boundary(proposed);
    if (sampler_.failure()) return *sampler_.failure();
    const std::size_t first_inside = sites_.size();
    for (const site& s : proposed.interior)
      if (has_room(s)) add(s);
    report_.taken_out = first_inside + proposed.interior.size() - sites_.size();
    const std::size_t kept = sites_.size();
    report_.covered = cover();
    if (sampler_.failure()) return *sampler_.failure();
    report_.added = sites_.size() - kept;
    charge();
    proposed.work_units += charged_;
    if (report_.taken_out + report_.added > 0) proposed.stars = {};
    proposed.interior.assign(sites_.begin() + static_cast<std::ptrdiff_t>(first_inside),
                             sites_.end());
    return report_;
  }

 private:
  void add(const site& s) {
    sites_.push_back(s);
    index_.insert(sites_, static_cast<vertex_index>(sites_.size() - 1));
  }

  // Charges the work since the last call to the account of the run.
  void charge() {
    const double units = work_.units();
    options_.stop.charge(units - std::exchange(charged_, units));
  }

  void list_boundary(const filled_domain& proposed) {
    for (const point& v : domain_.vertices)
      if (const auto s = sampler_.at(v)) add(*s);
    for (const std::vector<site>& division : proposed.divisions)
      for (const site& s : division) add(s);
  }

  bool has_room(const site& s) {
    const bounding_box near = box_around(s, search_margin * options_.spacing);
    const double squared = options_.spacing * options_.spacing;
    return index_.visit_box(sites_, near.low, near.high, [&](vertex_index w) {
      work_.count_candidates(1);
      return squared_distance(sites_[w], s.position) >= squared ||
             squared_distance(s, sites_[w].position) >= squared;
    });
  }

  // Covers the box of the domain, part by part, the last part first. False if it was ended.
  bool cover() {
    open_box all{domain_.box(), {}, {}, 0};
    for (std::uint32_t s = 0; s < domain_.segments.size(); ++s) all.segments.push_back(s);
    std::vector<open_box> open{std::move(all)};
    std::size_t looked_at = 0;
    while (!open.empty()) {
      if (++looked_at > most_boxes + most_boxes_a_site * sites_.size()) return false;
      open_box next = std::move(open.back());
      open.pop_back();
      // Counts the sites and segments compared by the tests of the box, of its middle, and by its
      // division.
      work_.count_candidates(6 * (1 + next.sites.size() + next.segments.size()));
      charge();
      if (options_.stop.is_requested()) return false;
      note_later_sites(next);
      if (is_covered(next) || is_outside(next)) continue;
      const point middle{next.box.low.x / 2 + next.box.high.x / 2,
                         next.box.low.y / 2 + next.box.high.y / 2};
      if (is_wanted(next, middle)) {
        const auto s = sampler_.at(farthest_from(next, middle));
        if (!s || sites_.size() >= options_.max_sites) return false;
        add(*s);
        open.push_back(std::move(next));
      } else if (!divide(next, middle, open)) {
        return false;
      }
    }
    return true;
  }

  bool reaches(const site& s, const bounding_box& box) const {
    constexpr double covers_roundings = 1 + 0x1p-40;
    return meet(box_around(s, covers_roundings * options_.covering), box);
  }

  void note_later_sites(open_box& b) const {
    for (; b.sites_known < sites_.size(); ++b.sites_known)
      if (reaches(sites_[b.sites_known], b.box))
        b.sites.push_back(static_cast<vertex_index>(b.sites_known));
  }

  // True if one disk holds the corners, hence the box.
  bool is_covered(const open_box& b) const {
    const double squared = options_.covering * options_.covering;
    const std::array<point, 4> corners = corners_of(b.box);
    return std::any_of(b.sites.begin(), b.sites.end(), [&](vertex_index w) {
      return std::all_of(corners.begin(), corners.end(),
                         [&](const point& q) { return squared_distance(sites_[w], q) <= squared; });
    });
  }

  bool is_outside(const open_box& b) const {
    return b.segments.empty() && !locator_.contains(kernel_, b.box.low);
  }

  // True if the point is inside the domain and farther than part_of_covering times the covering
  // radius from all sites.
  bool is_wanted(const open_box& b, const point& q) const {
    const double least = part_of_covering * options_.covering;
    return std::all_of(
               b.sites.begin(), b.sites.end(),
               [&](vertex_index w) { return squared_distance(sites_[w], q) > least * least; }) &&
           locator_.contains(kernel_, q);
  }

  // Returns the squared distance of q from the nearest site, in that site's metric. Searches the
  // sites near q as measured by m; infinite where there is none.
  double nearest_squared(const point& q, const metric_tensor& m) {
    const bounding_box near = box_around({q, m}, 2 * search_margin * options_.covering);
    double least = infinity;
    index_.visit_box(sites_, near.low, near.high, [&](vertex_index w) {
      work_.count_candidates(1);
      least = std::min(least, squared_distance(sites_[w], q));
      return true;
    });
    return least;
  }

  // Climbs from a point that is far from all sites to about the farthest point of the hole around
  // it. Each step is to a farther point inside the domain. Sites then come no nearer to each other
  // than about the covering radius.
  point farthest_from(const open_box& b, point q) {
    constexpr int halvings = 12, most_moves = 64;  // of each length of a step
    if (b.sites.empty()) return q;
    const metric_tensor& m = sites_[b.sites.front()].metric;
    const unit_displacements unit = unit_circle(m);
    double far = nearest_squared(q, m);
    double step = options_.covering / 2;
    for (int i = 0; i < halvings; step /= 2, ++i)
      for (int moves = 0; moves < most_moves && far < infinity; ++moves) {
        bool goes = false;
        for (const point& u : eight_directions) {
          const double x = step * u.x, y = step * u.y;
          const point to{q.x + x * unit.first.x + y * unit.second.x,
                         q.y + x * unit.first.y + y * unit.second.y};
          const double farther = nearest_squared(to, m);
          if (!(farther > far && farther < infinity) || !locator_.contains(kernel_, to)) continue;
          q = to;
          far = farther;
          goes = true;
        }
        if (!goes) break;
      }
    return q;
  }

  // True unless the segment certainly misses the box: all corners are on one side of its line.
  bool may_cross(std::uint32_t s, const bounding_box& box) const {
    const point &a = domain_.vertices[domain_.segments[s].a],
                &b = domain_.vertices[domain_.segments[s].b];
    if (!meet(box_of(a, b), box)) return false;
    bool left = false, right = false;
    for (const point& q : corners_of(box)) {
      const sign side = kernel_.orientation(a, b, q);
      left = left || side != sign::negative;
      right = right || side != sign::positive;
    }
    return left && right;
  }

  // Adds the four quarters to the list; false if the box is so small that its middle, in doubles,
  // is on its border.
  bool divide(const open_box& whole, const point& middle, std::vector<open_box>& open) const {
    const bounding_box& b = whole.box;
    if (!(b.low.x < middle.x && middle.x < b.high.x && b.low.y < middle.y && middle.y < b.high.y))
      return false;
    for (const point& corner : corners_of(b)) {
      open_box part{{corner, corner}, {}, {}, whole.sites_known};
      part.box.include(middle);
      for (const vertex_index w : whole.sites)
        if (reaches(sites_[w], part.box)) part.sites.push_back(w);
      for (const std::uint32_t s : whole.segments)
        if (may_cross(s, part.box)) part.segments.push_back(s);
      open.push_back(std::move(part));
    }
    return true;
  }

  const domain& domain_;
  const net_options& options_;
  field_sampler sampler_;
  filtered_kernel kernel_;
  domain_locator locator_;
  site_index index_;
  std::vector<site> sites_;
  work_meter work_;
  double charged_ = 0;  // of that, to the account of the run
  net_report report_;
};

}  // namespace

result<net_report> complete_net(const domain& d, const metric_field& field,
                                const net_options& options, filled_domain& proposed) {
  return net_completion(d, field, options).run(proposed);
}

}  // namespace asterism::internal
