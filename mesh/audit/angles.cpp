// SPDX-License-Identifier: MIT
//
// Point 3: no angle is below the bound, measured by any of the triangle's three vertices, except
// the domain's own angles at its sharp corners.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/audit/checks.hpp"
#include "asterism/mesh/audit/corner_angle.hpp"
#include "asterism/mesh/audit/sharp_corners.hpp"
#include "asterism/mesh/audit/unit_subject.hpp"
#include "asterism/mesh/support/infinity.hpp"

namespace asterism::internal::audit_detail {
namespace {

// A triangle in plain doubles, scaled for the angles of one metric. Each edge component has an
// error of at most eps = 2^-52 of itself, whichever way the machine rounds, and no monomial of the
// terms below meets more than four roundings besides those of its two components: 8 eps of the
// magnitude bound them, and the few roundings of the bound itself. Within `in_range` underflow
// takes less than 2^-600. Triangle and metric are brought to about unit size by powers of two,
// which no angle depends on.
struct plain_triangle {
  plain_triangle(const audit_context& context, const triangle& t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const point &from = context.at(t[i]), &to = context.at(t[(i + 1) % 3]);
      edge[i] = {to.x - from.x, to.y - from.y};
      extent = std::max(extent, std::abs(edge[i].x) + std::abs(edge[i].y));
    }
    if (const double power = power_to_unit(extent); power != 1) {
      for (vector2<double>& e : edge) e = {power * e.x, power * e.y};
      extent *= power;
    }
    const double left = edge[0].x * edge[1].y, right = edge[0].y * edge[1].x;
    area_below = left - right - step * (std::abs(left) + std::abs(right)) - lost;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto &a = edge[i], &c = edge[(i + 2) % 3];
      const double ahead = a.x * c.y, behind = a.y * c.x;
      at[i] = {a.x * c.x, ahead + behind, a.y * c.y, std::abs(ahead) + std::abs(behind)};
    }
  }

  static constexpr double step = 0x1p-49, lost = 0x1p-600;
  // Products of the components of both edges at a corner; `mixed` bounds |xy|.
  struct corner_products {
    double xx, xy, yy, mixed;
  };
  std::array<vector2<double>, 3> edge;  // from corner i to the next
  std::array<corner_products, 3> at;
  double extent = 0;
  double area_below = 0;
};

// Returns an upper bound of the cotangent of each corner's angle; infinite if not known.
std::array<double, 3> cotangents_above(const plain_triangle& t, const metric_tensor& own) {
  const double power = power_to_unit(own.m11 + own.m22);
  const metric_tensor m{power * own.m11, power * own.m12, power * own.m22};
  std::array<double, 3> above = {infinity, infinity, infinity};
  const double product = m.m11 * m.m22, square = m.m12 * m.m12;
  const double determinant_below =
      product - square - plain_triangle::step * (product + square) - plain_triangle::lost;
  const bool in_range = t.extent < 0x1p200 && m.m11 + m.m22 < 0x1p400;
  if (!(in_range && determinant_below > 0 && t.area_below > 0)) return above;
  const double height = std::sqrt(determinant_below) * t.area_below;
  if (!(height > 0x1p-700)) return above;
  const double inverse = 1 / height;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& [xx, xy, yy, mixed] = t.at[i];
    const double size = m.m11 * std::abs(xx) + std::abs(m.m12) * mixed + m.m22 * std::abs(yy);
    const double left = -(m.m11 * xx + m.m12 * xy + m.m22 * yy);
    above[i] = (left + plain_triangle::step * size + plain_triangle::lost) * inverse;
    above[i] += std::abs(above[i]) * plain_triangle::step;
  }
  return above;
}

// The angle bound of an audit, with the sectors and wedges in which domain angles are below it.
struct audited_requirement {
  double degrees = 0;
  squared_cotangent bound;
  std::vector<narrow_sector> sectors;
  narrow_wedges wedges;
};

enum class angle_class { ordinary, collateral, exempt };

class angle_check {
 public:
  angle_check(const audit_context& context, audit_tally& tally, const audited_requirement& wanted)
      : context_(context), tally_(tally), wanted_(wanted) {}

  // Returns an upper bound of the cotangents of all angles of the triangle, if all are ordinary and
  // certainly above the angle bound. Returns infinity where that is not known, and minus infinity
  // where there is no angle to measure.
  double bound_of(vertex_index t) {
    const triangle& c = context_.subject.triangles[t];
    if (!std::all_of(c.begin(), c.end(), [&](vertex_index v) { return context_.measured[v] != 0; }))
      return -infinity;
    if (tally_.kernel().orientation(context_.at(c[0]), context_.at(c[1]), context_.at(c[2])) !=
        sign::positive)
      return -infinity;
    find_sectors(c);
    if (beside_) return infinity;
    const bool has_bound = wanted_.degrees > 0;
    const double most = has_bound ? wanted_.bound.root_below : infinity;
    double greatest = -infinity;
    bool is_known = true;
    visit_bounds(c, [&](std::size_t, vertex_index, double above) {
      is_known = is_known && above < most;  // false for a value that is no number
      greatest = std::max(greatest, above);
    });
    if (!is_known) return infinity;
    constexpr std::size_t angles = 9;
    if (has_bound) tally_.part.decisions += angles;
    return greatest;
  }

  // Measures the angle with the greatest bound of the cotangent: most other angles then need not be
  // measured.
  void start_from(vertex_index t) {
    const triangle& c = context_.subject.triangles[t];
    double greatest = -infinity;
    angle least{};
    visit_bounds(c, [&](std::size_t i, vertex_index perspective, double above) {
      if (!(above > greatest)) return;
      greatest = above;
      least = ordinary_angle(t, i, perspective, above);
    });
    skip_wider(least, angle_in_degrees(context_, least.at, least.perspective));
  }

  // Enters the angles of a triangle with this bound into the least angles found so far, and reports
  // those that are low.
  void judge(vertex_index t, double bound) {
    if (bound == -infinity) return;
    if (bound == infinity) return judge_each(t);
    if (bound < greatest_cotangent_[static_cast<std::size_t>(angle_class::ordinary)]) return;
    visit_bounds(context_.subject.triangles[t],
                 [&](std::size_t i, vertex_index perspective, double above) {
                   note(ordinary_angle(t, i, perspective, above));
                 });
  }

 private:
  struct angle {
    vertex_index triangle;
    corner at;
    vertex_index perspective;
    angle_class demand;
    double above;  // its cotangent is at most this
  };

  angle ordinary_angle(vertex_index t, std::size_t i, vertex_index perspective,
                       double above) const {
    const triangle& c = context_.subject.triangles[t];
    return {t, {c[i], c[(i + 1) % 3], c[(i + 2) % 3]}, perspective, angle_class::ordinary, above};
  }

  // Calls take(i, perspective, above) for each angle, with an upper bound of its cotangent. If the
  // three vertices have one metric, measures angles in that metric once.
  template <class Take>
  void visit_bounds(const triangle& c, const Take& take) const {
    const plain_triangle plain(context_, c);
    const auto metric = [&](std::size_t j) { return context_.subject.sites[c[j]].metric; };
    const bool is_one = identical(metric(0), metric(1)) && identical(metric(0), metric(2));
    for (std::size_t j = 0; j < (is_one ? 1 : c.size()); ++j) {
      const std::array<double, 3> above = cotangents_above(plain, metric(j));
      for (std::size_t i = 0; i < above.size(); ++i) take(i, c[j], above[i]);
    }
  }

  void judge_each(vertex_index t) {
    const triangle& c = context_.subject.triangles[t];
    find_sectors(c);
    const plain_triangle plain(context_, c);
    std::array<bool, 3> failed{};
    for (const vertex_index perspective : c) {
      const auto above = cotangents_above(plain, context_.subject.sites[perspective].metric);
      for (std::size_t i = 0; i < 3; ++i) {
        const angle a{t,
                      {c[i], c[(i + 1) % 3], c[(i + 2) % 3]},
                      perspective,
                      class_of(i, perspective),
                      above[i]};
        note(a);
        if (!is_wide(a)) failed[static_cast<std::size_t>(a.demand)] = true;
      }
    }
    if (failed[0]) tally_.part.low_triangles.push_back(t);
    if (failed[1]) tally_.part.collateral_triangles.push_back(t);
    if (failed[2]) tally_.part.exempt_triangles.push_back(t);
  }

  void find_sectors(const triangle& c) {
    sector_ = {};
    beside_ = false;
    if (wanted_.sectors.empty()) return;
    for (std::size_t i = 0; i < 3; ++i) {
      sector_[i] = sector_of(context_, tally_.kernel(), c, c[i], wanted_.sectors);
      beside_ = beside_ || sector_[i] != nullptr;
    }
    beside_ = beside_ || crosses_narrow_wedge(context_, tally_, c, wanted_.wedges, wanted_.bound);
  }

  // Classifies an angle. The sector is narrow in the corner's own metric; seen from another vertex
  // the angle is exempt only if it is proved narrow in that vertex's metric, too.
  angle_class class_of(std::size_t i, vertex_index perspective) {
    if (!beside_) return angle_class::ordinary;
    const narrow_sector* const s = sector_[i];
    if (s == nullptr) return angle_class::collateral;
    const bool forced =
        perspective == s->at ||
        is_proven_narrow(context_, tally_, {s->at, s->first, s->last}, perspective, wanted_.bound);
    return forced ? angle_class::exempt : angle_class::collateral;
  }

  // Enters an angle into the least angles found so far. Skips computing its degrees if its quick
  // bound proves that a smaller angle of its kind is known.
  void note(const angle& a) {
    const auto kind = static_cast<std::size_t>(a.demand);
    if (a.above < greatest_cotangent_[kind]) return;
    const std::array<audited_angle*, 3> worst = {
        &tally_.part.worst_ordinary, &tally_.part.worst_collateral, &tally_.part.worst_exempt};
    const double degrees = angle_in_degrees(context_, a.at, a.perspective);
    if (!(degrees < worst[kind]->degrees)) return;
    *worst[kind] = {degrees, a.triangle, a.at.at, a.perspective};
    skip_wider(a, degrees);
  }

  // Skips from now on angles of this kind that certainly have more degrees than this one.
  void skip_wider(const angle& a, double degrees) {
    // The margin covers the roundings of the degrees and of their tangent, some 2^-50 of each: a
    // skipped angle exceeds the least known one by more than these roundings. In a metric so thin
    // that the degrees themselves have larger errors, the reported least angle may differ from the
    // true one by such an error.
    constexpr double margin = 1e-9;
    const double cotangent = 1 / elementary::tan(degrees * std::numbers::pi / 180);
    greatest_cotangent_[static_cast<std::size_t>(a.demand)] =
        cotangent - margin * (1 + std::abs(cotangent));
  }

  bool is_wide(const angle& a) {
    if (wanted_.degrees <= 0) return true;
    if (a.above < wanted_.bound.root_below) {
      ++tally_.part.decisions;
      return true;
    }
    if (is_proven_wide(context_, tally_, a.at, a.perspective, wanted_.bound)) return true;
    if (a.demand != angle_class::exempt) report(a);
    return false;
  }

  void report(const angle& a) {
    const finding_kind kind = a.demand == angle_class::collateral
                                  ? finding_kind::collateral_angle_below_bound
                                  : finding_kind::angle_below_bound;
    tally_.found(kind, tally_.is_kept(kind) ? witness(a) : std::string());
  }

  std::string witness(const angle& a) const {
    return "the angle at " + vertex_text(context_, a.at.at) + " of " +
           triangle_text(context_, a.triangle) + " is " +
           number_text(angle_in_degrees(context_, a.at, a.perspective)) +
           " degrees in the metric of " + vertex_text(context_, a.perspective) + ", below " +
           number_text(wanted_.degrees) +
           (a.demand == angle_class::collateral ? "; a sharp corner excuses its own angle alone"
                                                : "");
  }

  const audit_context& context_;
  audit_tally& tally_;
  const audited_requirement& wanted_;
  // State of the triangle that is audited: the narrow sector that each corner lies in, or null, and
  // whether any corner lies in one or the triangle crosses a narrow wedge.
  std::array<const narrow_sector*, 3> sector_{};
  bool beside_ = false;
  // Lower bound of the cotangent of the smallest angle so far: ordinary, exempt, collateral.
  std::array<double, 3> greatest_cotangent_ = {-infinity, -infinity, -infinity};
};

// Returns a flag for each triangle: 0 if the audit before bounded its angles, and no tensor of its
// corners has changed. Which angles are ordinary may depend on tensors elsewhere if there is a
// wedge.
std::vector<char> triangles_to_bound(audit_context& context, const audited_requirement& wanted) {
  const auto& triangles = context.subject.triangles;
  const bool is_known = context.changed != nullptr && wanted.wedges.list.empty() &&
                        context.angle_bounds.size() == triangles.size();
  std::vector<char> is_new(triangles.size(), 1);
  context.angle_bounds.resize(triangles.size());
  if (!is_known) return is_new;
  std::vector<char> is_changed(context.subject.sites.size(), 0);
  for (const vertex_index v : *context.changed) is_changed[v] = 1;
  for (const vertex_index t : context.triangles) {
    const auto& [a, b, c] = triangles[t];
    is_new[t] = is_changed[a] | is_changed[b] | is_changed[c];
  }
  return is_new;
}

}  // namespace

void check_angles(audit_context& context) {
  audited_requirement wanted;
  wanted.degrees = context.options.angle_bound.value_or(0);
  if (!(wanted.degrees >= 0 && wanted.degrees < 90)) {
    context.found(finding_kind::invalid_option, "an angle bound of " + number_text(wanted.degrees) +
                                                    " degrees is not in [0, 90)");
    return;
  }
  context.report.angles_checked = context.options.angle_bound.has_value();
  if (wanted.degrees > 0) {  // else trivially met
    wanted.bound = make_squared_cotangent(wanted.degrees);
    wanted.sectors = find_narrow_sectors(context, wanted.bound);
    if (!wanted.sectors.empty())
      wanted.wedges =
          find_narrow_wedges(context, wanted.sectors, make_squared_cotangent(wanted.degrees / 2));
  }
  const std::vector<char> is_new = triangles_to_bound(context, wanted);
  std::vector<double>& bounds = context.angle_bounds;
  const auto check = [&](audit_tally& tally, std::size_t begin, std::size_t end) {
    angle_check part(context, tally, wanted);
    std::optional<vertex_index> least;
    for (std::size_t i = begin; i < end; ++i) {
      context.prefetch_corners(i + triangles_ahead);
      const vertex_index t = context.triangles[i];
      if (is_new[t] != 0) bounds[t] = part.bound_of(t);
      if (bounds[t] < infinity && (!least || bounds[t] > bounds[*least])) least = t;
    }
    if (least && bounds[*least] > -infinity) part.start_from(*least);
    for (std::size_t i = begin; i < end; ++i)
      part.judge(context.triangles[i], bounds[context.triangles[i]]);
  };
  check_in_parallel(context, context.triangles.size(), check);
}

namespace {

// True if all three sides of the triangle are segments, one of them inside the domain: the segments
// alone decide its shape. A triangle with three sides on the outer boundary is the whole mesh, and
// is not counted.
bool is_enclosed(const audit_context& context, vertex_index t) {
  const triangle& c = context.subject.triangles[t];
  bool is_inner = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t e = find_subsegment(context, c[i], c[(i + 1) % 3]);
    if (e == context.subject.boundary.size()) return false;
    is_inner = is_inner || context.subject.boundary[e].internal;
  }
  return is_inner;
}

// True if the mesh has inner edges and every one of them is a segment. Sets `inner` to their
// number.
bool has_no_free_edge(const audit_context& context, std::size_t& inner) {
  std::size_t internal = 0;
  for (const vertex_index e : context.subsegments)
    internal += context.subject.boundary[e].internal ? 1 : 0;
  inner = (context.edges.size() - (context.subsegments.size() - internal)) / 2;
  return inner > 0 && internal >= inner;
}

}  // namespace

// Refuses a mesh of which most triangles have no angle to judge, as the domain decides their shape:
// more than half of them have an exempt angle, and segments for all their sides.
void check_something_judged(audit_context& context) {
  const std::vector<vertex_index>& exempt = context.report.exempt_triangles;
  if (exempt.empty()) return;
  std::size_t inner = 0;
  if (context.options.domain_is_the_mesh && has_no_free_edge(context, inner)) {
    context.found(finding_kind::nothing_judged,
                  "all " + std::to_string(inner) +
                      " inner edges are listed as segments of the domain, and " +
                      std::to_string(exempt.size()) +
                      " triangles are at corners between them that are below the bound: nothing of "
                      "the mesh is judged");
    return;
  }
  const auto enclosed = static_cast<std::size_t>(std::count_if(
      exempt.begin(), exempt.end(), [&](vertex_index t) { return is_enclosed(context, t); }));
  const std::size_t all = context.subject.triangles.size();
  if (2 * enclosed <= all) return;
  context.found(finding_kind::nothing_judged,
                std::to_string(enclosed) + " of " + std::to_string(all) +
                    " triangles have segments for all their sides, some inside the domain, and an "
                    "angle below the bound: these are the domain's own, and next to nothing of the "
                    "mesh is judged");
}

}  // namespace asterism::internal::audit_detail
