// SPDX-License-Identifier: MIT
//
// Point 3: no angle is below the bound, measured by any of the triangle's three vertices, except
// the domain's own angles at its sharp corners.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/audit/checks.hpp"
#include "asterism/mesh/audit/corner_angle.hpp"
#include "asterism/mesh/audit/sharp_corners.hpp"
#include "asterism/mesh/audit/unit_subject.hpp"

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
      extent = std::fmax(extent, std::abs(edge[i].x) + std::abs(edge[i].y));
    }
    if (const double power = power_to_unit(extent); power != 1) {
      for (vector2<double>& e : edge) e = {power * e.x, power * e.y};
      extent *= power;
    }
    const double left = edge[0].x * edge[1].y, right = edge[0].y * edge[1].x;
    area_below = left - right - step * (std::abs(left) + std::abs(right)) - lost;
  }

  static constexpr double step = 0x1p-49, lost = 0x1p-600;
  std::array<vector2<double>, 3> edge;  // from corner i to the next
  double extent = 0;
  double area_below = 0;
};

// Returns an upper bound of the cotangent of each corner's angle; infinite if not known.
std::array<double, 3> cotangents_above(const plain_triangle& t, const metric_tensor& own) {
  const double power = power_to_unit(own.m11 + own.m22);
  const metric_tensor m{power * own.m11, power * own.m12, power * own.m22};
  constexpr double infinity = std::numeric_limits<double>::infinity();
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
    const auto &a = t.edge[i], &c = t.edge[(i + 2) % 3];
    const double xx = a.x * c.x, xy = a.x * c.y + a.y * c.x, yy = a.y * c.y;
    const double size = m.m11 * std::abs(xx) +
                        std::abs(m.m12) * (std::abs(a.x * c.y) + std::abs(a.y * c.x)) +
                        m.m22 * std::abs(yy);
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

  void run(vertex_index t) {
    const triangle& c = context_.subject.triangles[t];
    if (!std::all_of(c.begin(), c.end(), [&](vertex_index v) { return context_.measured[v] != 0; }))
      return;
    if (tally_.kernel().orientation(context_.at(c[0]), context_.at(c[1]), context_.at(c[2])) !=
        sign::positive)
      return;
    find_sectors(c);
    const plain_triangle plain(context_, c);
    if (passes_at_once(t, c, plain)) return;
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

 private:
  struct angle {
    vertex_index triangle;
    corner at;
    vertex_index perspective;
    angle_class demand;
    double above;  // its cotangent is at most this
  };

  // True if all angles are ordinary and certainly above the bound by their quick bounds alone: then
  // the triangle needs no further test. If its three vertices have one metric, angles are measured
  // in that metric once.
  bool passes_at_once(vertex_index t, const triangle& c, const plain_triangle& plain) {
    if (beside_) return false;
    constexpr std::size_t perspectives = 3;
    const auto metric = [&](std::size_t j) { return context_.subject.sites[c[j]].metric; };
    const bool is_one = identical(metric(0), metric(1)) && identical(metric(0), metric(2));
    const std::size_t asked_of = is_one ? 1 : perspectives;
    std::array<std::array<double, 3>, perspectives> above;
    for (std::size_t j = 0; j < asked_of; ++j) {
      above[j] = cotangents_above(plain, metric(j));
      for (const double a : above[j])
        if (wanted_.degrees > 0 && !(a < wanted_.bound.root_below)) return false;
    }
    if (wanted_.degrees > 0) tally_.part.decisions += perspectives * 3;
    constexpr auto ordinary = angle_class::ordinary;
    for (std::size_t j = 0; j < asked_of; ++j)
      for (std::size_t i = 0; i < 3; ++i)
        if (!(above[j][i] < greatest_cotangent_[static_cast<std::size_t>(ordinary)]))
          note({t, {c[i], c[(i + 1) % 3], c[(i + 2) % 3]}, c[j], ordinary, above[j][i]});
    return true;
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
    // The margin covers the roundings of the degrees and of their tangent, some 2^-50 of each: a
    // skipped angle exceeds the least known one by more than these roundings. In a metric so thin
    // that the degrees themselves have larger errors, the reported least angle may differ from the
    // true one by such an error.
    constexpr double margin = 1e-9;
    const double cotangent = 1 / elementary::tan(degrees * std::numbers::pi / 180);
    greatest_cotangent_[kind] = cotangent - margin * (1 + std::abs(cotangent));
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
  std::array<double, 3> greatest_cotangent_ = {-std::numeric_limits<double>::infinity(),
                                               -std::numeric_limits<double>::infinity(),
                                               -std::numeric_limits<double>::infinity()};
};

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
    wanted.wedges =
        find_narrow_wedges(context, wanted.sectors, make_squared_cotangent(wanted.degrees / 2));
  }
  const auto check = [&](audit_tally& tally, std::size_t begin, std::size_t end) {
    angle_check part(context, tally, wanted);
    for (std::size_t i = begin; i < end; ++i) {
      context.prefetch_corners(i + triangles_ahead);
      part.run(context.triangles[i]);
    }
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
