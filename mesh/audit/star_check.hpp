// SPDX-License-Identifier: MIT
//
// Tests the fans of a few stars against sites: their neighbours, or all that are in reach.
//
// The reach and the kite of a gap take few operations (audit/gap_reach.hpp); most gaps have no site
// within that reach, or one that is outside of the outline of the kite (audit/star_outline.hpp).
// Nearly every other test is decided by the kernel's prepared gap (kernels/star_gap.hpp), made once
// for a gap; the rest by the auditor's own filter of wider range, and then edge_test. The mesher
// uses prepared gaps too. Where no test may be shared with the mesher, as in verify(), prepared
// gaps are left out (audit_options::own_filter_alone), except to bound the reach of gaps that the
// filter does not bound.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "asterism/kernels/star_gap.hpp"
#include "asterism/mesh/audit/audit_work.hpp"
#include "asterism/mesh/audit/context.hpp"
#include "asterism/mesh/audit/gap_reach.hpp"
#include "asterism/mesh/audit/site_tree.hpp"
#include "asterism/mesh/audit/site_visibility.hpp"
#include "asterism/mesh/audit/star_extent.hpp"
#include "asterism/mesh/audit/star_filter.hpp"
#include "asterism/mesh/audit/star_outline.hpp"
#include "asterism/mesh/audit/star_surroundings.hpp"

namespace asterism::internal::audit_detail {

// A gap of a fan, from neighbour x counter-clockwise to neighbour y.
struct fan_gap {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  fan_gap(vertex_index from, vertex_index to) : x(from), y(to) {}

  vertex_index x, y;
  bool is_skipped = false;   // x -> y is a subsegment, beyond which nothing is seen, or left open
  bool is_concerned = true;  // or else changed sites alone are to be held against it
  double reach = 0;          // how far from v sites matter to it
  bool has_kite = false;
  outline_point vertex;  // of the kite
  // Places of the kernel's gap and of the filter in the lists of those made; none before. The first
  // is made for the first question if it may be shared, the second where the first cannot answer.
  // They are apart, as few gaps need either, and both are large.
  std::uint32_t prepared = none, filter = none;
  std::size_t left_open = 0;  // number of questions about single sites
};

// The way from v to a neighbour.
struct fan_ray {
  vector2<double> way;
  outline_point on_way;  // up to which it belongs to the kites
};

// One fan of v's star, prepared for tests of other sites. Rays and gaps are in lists of all fans
// that are prepared together.
struct prepared_fan {
  vertex_index v = 0;
  std::span<const vertex_index> link;
  std::span<fan_ray> rays;
  std::span<fan_gap> gaps;
  double reach = 0;            // how far from v sites matter to one of the gaps
  double reach_concerned = 0;  // to one of those that are concerned
  bool has_concerned = false;  // gaps that all sites are to be held against
  bool has_others = false;
};

// Lists of the vertices that are checked together, in memory that later checks use again.
struct star_lists {
  std::vector<prepared_fan> prepared;
  std::vector<fan_ray> rays;
  std::vector<fan_gap> gaps;
  std::vector<star_gap> kernel_gaps;
  std::vector<star_gap_filter> filters;
  std::vector<std::vector<outline_point>> outlines;
  std::vector<star_extent> extents;
  std::vector<std::size_t> leaves;
  std::vector<measured_ray> measured;
};

// Keeps the lists of checks that have ended, for those that begin, in any thread.
class star_lists_pool {
 public:
  star_lists take() {
    const std::scoped_lock lock(access_);
    if (free_.empty()) return {};
    star_lists taken = std::move(free_.back());
    free_.pop_back();
    return taken;
  }
  void give_back(star_lists lists) {
    const std::scoped_lock lock(access_);
    free_.push_back(std::move(lists));
  }

 private:
  std::mutex access_;
  std::vector<star_lists> free_;
};

// Checks the stars of some vertices in one thread, and enters findings into the tally of that
// thread.
class star_check {
 public:
  // `lists` may have any contents.
  star_check(const audit_context& context, audit_tally& tally, const star_surroundings& around,
             star_lists lists)
      : context_(context),
        tally_(tally),
        guard_(context, tally),
        around_(around),
        sight_(context, around.subsegments, tally.kernel()),
        lists_(std::move(lists)) {}

  star_lists take_lists() { return std::move(lists_); }
  bool is_over() { return guard_.is_over(); }

  // Checks vertices near each other: searches the sites around all of them once. Needs the tree
  // unless only neighbours are tested. `last` is the end of the order of all vertices.
  void run(const vertex_index* begin, const vertex_index* end, const vertex_index* last,
           bool neighbours_alone);

 private:
  const site& at(vertex_index v) const { return around_.at[v]; }
  sign turn(vertex_index a, vertex_index b, vertex_index c) const {
    return tally_.kernel().orientation(context_.at(a), context_.at(b), context_.at(c));
  }

  static bool is_finite(double reach) { return reach < std::numeric_limits<double>::infinity(); }

  // Empties the lists of prepared fans, and makes room for those of these vertices.
  void make_room(std::span<const vertex_index> vertices);
  // Tests all sites within the extents of the fans against their gaps. Descends the tree once for
  // all fans.
  void hold_all(std::span<const prepared_fan> fans);
  // Tests w against one fan.
  void look(const prepared_fan& p, vertex_index w, bool at_concerned) {
    guard_.count(unit_of_look + unit_of_gap * static_cast<double>(p.gaps.size()));
    if (w != p.v && !is_neighbour(p, w) && !guard_.is_over()) check_other(p, w, at_concerned);
  }
  // True if w is a neighbour in this fan. Neighbours in other fans of v, of which there may be
  // thousands, are in none of its gaps.
  static bool is_neighbour(const prepared_fan& p, vertex_index w) {
    return std::find(p.link.begin(), p.link.end(), w) != p.link.end();
  }

  // Tests each inner edge of a fan once, from the end with the lesser number: edge_test from the
  // other end is the same question, as x and y are adjacent to v there.
  void check_neighbours(vertex_index v, const vertex_fan& fan);
  // True if all four sites have one metric and edge_test accepts the edge: then neither end needs
  // to test it. With other metrics this test would cost more than it saves.
  bool is_accepted_in_one_metric(vertex_index v, vertex_index w, vertex_index x,
                                 vertex_index y) const;
  // False if the gap from x to y is 180 degrees or more, or w is inside the triangle v, x, y.
  bool is_asked(vertex_index v, vertex_index w, vertex_index x, vertex_index y) const;
  void report_rejected(vertex_index v, vertex_index w, vertex_index x, vertex_index y);
  // Prepares the fans of v and remembers their reaches. Leaves out fans that have no changed site
  // within reach.
  void prepare(vertex_index v);
  // True if a changed site is within this reach of v, and may matter to its star.
  bool is_reached(vertex_index v, double reach);
  void prepare(vertex_index v, const vertex_fan& fan);
  // Returns the extent of those gaps of the fan that are tested and whose is_concerned equals
  // `of_concerned`: by their outline, to which `outline` is set, or by their reach where the kite
  // of such a gap is not known.
  star_extent extent_of(const prepared_fan& p, bool of_concerned,
                        std::vector<outline_point>& outline) const;
  // True if w is certainly outside of the gap's kite, in the sense of its outline.
  bool is_outside(const prepared_fan& p, const fan_gap& gap, vertex_index w) const;
  bool is_left_open(const fan_gap& gap) const;
  // Sets the gap's reach and kite without preparing its tests, which most gaps do not need.
  // Computes a sharper reach only where the quick one is more than twice the length of the gap's
  // edges: elsewhere it would cost more than it saves.
  void bound(vertex_index v, fan_gap& gap, const quick_reaches& reaches, const measured_ray& to_x,
             const measured_ray& to_y);
  [[gnu::noinline]] void sharpen(vertex_index v, fan_gap& gap);
  // Return the kernel's gap, null where the kernel is not to be shared, and the filter, made when a
  // test first needs them. They stay in place until the next call.
  const star_gap* prepared_gap(vertex_index v, fan_gap& gap) {
    if (context_.options.own_filter_alone) return nullptr;
    return &made_once(lists_.kernel_gaps, gap.prepared, v, gap);
  }
  const star_gap_filter& filter_of(vertex_index v, fan_gap& gap) {
    return made_once(lists_.filters, gap.filter, v, gap);
  }
  template <class Test>
  const Test& made_once(std::vector<Test>& made, std::uint32_t& nth, vertex_index v,
                        const fan_gap& gap) {
    if (nth == fan_gap::none) {
      nth = static_cast<std::uint32_t>(made.size());
      made.emplace_back(at(v), at(gap.x), at(gap.y));
    }
    return made[nth];
  }

  vector2<double> to(vertex_index v, vertex_index w) const {
    return {context_.at(w).x - context_.at(v).x, context_.at(w).y - context_.at(v).y};
  }

  // Returns on which side of the ray from v to link[i] the site w is. The computed area has an
  // error of at most four roundings, 2^-50, of its magnitude; in the range checked first, underflow
  // takes less than the rest of 2^-49. Defined in the header to be inlined, as it is called for
  // every ray.
  sign side(const prepared_fan& p, std::size_t i, const vector2<double>& to_w,
            vertex_index w) const {
    const vector2<double>& way = p.rays[i].way;
    const double left = way.x * to_w.y, right = way.y * to_w.x;
    const double turned = left - right, size = std::abs(left) + std::abs(right);
    if (std::abs(turned) > 0x1p-49 * size && size > 0x1p-900 && size < 0x1p1000)
      return turned > 0 ? sign::positive : sign::negative;
    return turn(p.v, p.link[i], w);
  }
  // Returns the gap whose two rays w lies strictly between; none if w is on a ray or outside an
  // open fan.
  fan_gap* gap_of(const prepared_fan& p, vertex_index w) const;
  // Tests w against the gap that contains it, if that gap is among those to be tested.
  void check_other(const prepared_fan& p, vertex_index w, bool at_concerned);
  bool is_accepted(vertex_index v, vertex_index w, fan_gap& gap);
  // Returns whether the star accepts the neighbour w. Where that is left open, notes the question
  // and returns true.
  bool is_accepted_or_open(vertex_index v, vertex_index w, vertex_index x, vertex_index y);
  void leave_open(vertex_index v, vertex_index w, vertex_index x, vertex_index y,
                  open_question::about what);
  // Leaves open whether the gap accepts w, and after many such questions the gap itself.
  void leave_open(vertex_index v, vertex_index w, fan_gap& gap);
  // Work units of comparing a site with a ray, and of preparing the ray: 50 and 5
  // nanoseconds.
  static constexpr double unit_of_look = 0.005, unit_of_gap = 0.0005;

  const audit_context& context_;
  audit_tally& tally_;
  audit_work_guard guard_;
  const star_surroundings& around_;
  site_visibility sight_;
  star_lists lists_;
};

}  // namespace asterism::internal::audit_detail
