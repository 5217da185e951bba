// SPDX-License-Identifier: MIT
#include "asterism/mesh/delivery/delivered_metric.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/audit/auditor.hpp"
#include "asterism/mesh/data/site_box.hpp"
#include "asterism/mesh/gradation/nodal_gradation.hpp"
#include "asterism/mesh/numerics/metric_length.hpp"
#include "asterism/mesh/support/parallel.hpp"
#include "asterism/mesh/support/wide_range.hpp"

namespace asterism::internal {
namespace {

constexpr std::size_t sites_at_once = 1024;  // for a thread

double area_in_metric(const mesh& m) {
  std::vector<double> root_of(m.sites.size());
  parallel_chunks(root_of.size(), sites_at_once,
                  [&](std::size_t, std::size_t begin, std::size_t end) {
                    for (std::size_t v = begin; v < end; ++v)
                      root_of[v] = plain_root_of_determinant(m.sites[v].metric);
                  });
  double sum = 0;
  for (const triangle& t : m.triangles) {
    const point &a = m.sites[t[0]].position, &b = m.sites[t[1]].position,
                &c = m.sites[t[2]].position;
    const double twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    double roots = 0;
    for (const vertex_index v : t) roots += root_of[v];
    sum += twice * roots / 6;
  }
  return sum;
}

// Returns the distance of two tensors in numbers of wider range: their ratios may exceed the
// doubles.
double distance_in_wide_range(const metric_tensor& a, const metric_tensor& b) {
  using number = wide_range;
  const number a11 = a.m11, a12 = a.m12, a22 = a.m22, b11 = b.m11, b12 = b.m12, b22 = b.m22;
  const number determinant = a11 * a22 - a12 * a12;
  const number half = (b11 * a22 - number(2) * b12 * a12 + b22 * a11) / (number(2) * determinant);
  const number product = (b11 * b22 - b12 * b12) / determinant;
  const number greatest = half + root(half * half - product);
  const auto log_of_root = [](const number& eigenvalue) {
    return std::abs(2 * elementary::log(static_cast<double>(root(root(eigenvalue)))));
  };
  return std::max(log_of_root(greatest), log_of_root(product / greatest));
}

// Returns the distance of two tensors; very large and very small tensors, whose determinants leave
// the range of doubles, are first scaled by one power of two, which does not change the distance.
double distance(const metric_tensor& a, const metric_tensor& b) {
  constexpr int ordinary = 200;
  constexpr double most = 1420;  // more than ln of the ratio of any two doubles, less than twice it
  const int size = std::ilogb(std::max(a.m11, a.m22));
  if (std::abs(size) <= ordinary) {
    const double plain = adapting::log_distortion(a, b);
    if (std::isfinite(plain)) return plain;
  }
  const auto scaled = [size](const metric_tensor& m) {
    return metric_tensor{std::scalbn(m.m11, -size), std::scalbn(m.m12, -size),
                         std::scalbn(m.m22, -size)};
  };
  const double found = adapting::log_distortion(scaled(a), scaled(b));
  if (std::isfinite(found)) return found;
  const double wide = distance_in_wide_range(a, b);
  return std::isfinite(wide) ? std::min(wide, most) : most;
}

std::vector<double> distances_of(const std::vector<site>& p, const std::vector<site>& q) {
  std::vector<double> found(p.size(), 0);
  parallel_chunks(p.size(), sites_at_once, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v)
      if (!identical(p[v].metric, q[v].metric)) found[v] = distance(p[v].metric, q[v].metric);
  });
  return found;
}

// Gives sites the wanted tensors at their places; returns the first failure.
std::optional<error> take_tensors(const metric_field& wanted, std::vector<site>& sites) {
  std::vector<std::optional<error>> failures(chunk_count(sites.size(), sites_at_once));
  parallel_chunks(sites.size(), sites_at_once,
                  [&](std::size_t i, std::size_t begin, std::size_t end) {
                    for (std::size_t v = begin; v < end && !failures[i]; ++v) {
                      auto there = wanted.at(sites[v].position);
                      if (there)
                        sites[v].metric = there.value();
                      else
                        failures[i] = there.failure();
                    }
                  });
  const auto failed = std::find_if(failures.begin(), failures.end(),
                                   [](const std::optional<error>& f) { return f.has_value(); });
  return failed == failures.end() ? std::nullopt : *failed;
}

void note_distances(const mesh& delivered, const mesh& wanted, delivered_report& report) {
  const double tenth = elementary::log(1.1);
  std::vector<double> distances = distances_of(wanted.sites, delivered.sites);
  std::size_t beyond = 0;
  for (std::size_t v = 0; v < wanted.sites.size(); ++v) {
    if (!identical(wanted.sites[v].metric, delivered.sites[v].metric)) ++report.changed;
    if (distances[v] > tenth) ++beyond;
  }
  if (distances.empty()) return;
  // Returns the distance at this place in ascending order, counted from 0.
  const auto after_smaller = [&](std::size_t smaller) {
    const auto at = distances.begin() + static_cast<std::ptrdiff_t>(smaller);
    std::nth_element(distances.begin(), at, distances.end());
    return *at;
  };
  report.beyond_tenth = static_cast<double>(beyond) / static_cast<double>(distances.size());
  report.median = after_smaller(distances.size() / 2);
  report.ninetieth = after_smaller(distances.size() * 9 / 10);
  report.greatest = after_smaller(distances.size() - 1);
}

}  // namespace

result<delivered_report> compare_with_wanted(const mesh& m, const metric_field& wanted,
                                             std::optional<double> angle_bound,
                                             const past_audit* audited) {
  mesh as_wanted = m;
  wanted.expect([&m] { return positions_of(m.sites); });
  if (auto failure = take_tensors(wanted, as_wanted.sites)) return *failure;
  delivered_report report;
  note_distances(m, as_wanted, report);
  parallel_for(2, [&](std::size_t i) {
    (i == 0 ? report.complexity_wanted : report.complexity_delivered) =
        area_in_metric(i == 0 ? as_wanted : m);
  });
  audit_options options;
  options.angle_bound = angle_bound;
  options.find_exempt_corners = true;
  options.findings_kept = 0;
  past_audit before;
  if (audited != nullptr) before.memory.triangulation = audited->memory.triangulation;
  auditor judge(as_wanted, options, std::move(before));
  const audit_report& found = judge.check_angles();
  report.worst_angle_wanted = found.worst().degrees;
  report.low_wanted = found.refused_triangles();
  return report;
}

std::vector<std::string> contradictions_in_delivered(const mesh& subject, const certificate& claim,
                                                     const metric_field& wanted) {
  if (!claim.delivered) return {};
  const auto found = compare_with_wanted(subject, wanted, claim.angle_bound);
  if (!found) return {"the metric wanted fails: " + found.failure().message};
  return contradictions_in_delivered(*claim.delivered, found.value());
}

std::vector<std::string> contradictions_in_delivered(const delivered_report& claimed,
                                                     const delivered_report& measured) {
  std::vector<std::string> said;
  if (claimed.changed != measured.changed)
    said.push_back(
        fmt::format("{} sites have another tensor than the one wanted, and the "
                    "certificate says {}",
                    measured.changed, claimed.changed));
  const std::array<std::pair<const char*, double delivered_report::*>, 7> numbers = {
      {{"beyond_tenth", &delivered_report::beyond_tenth},
       {"median", &delivered_report::median},
       {"ninetieth", &delivered_report::ninetieth},
       {"greatest", &delivered_report::greatest},
       {"complexity_wanted", &delivered_report::complexity_wanted},
       {"complexity_delivered", &delivered_report::complexity_delivered},
       {"worst_angle_wanted", &delivered_report::worst_angle_wanted}}};
  for (const auto& [name, member] : numbers)
    if (claimed.*member != measured.*member)
      said.push_back(fmt::format("of the metric delivered, {} is {}, and the certificate says {}",
                                 name, measured.*member, claimed.*member));
  if (claimed.low_wanted != measured.low_wanted)
    said.push_back(
        fmt::format("as the metric wanted measures them {} triangles are below the "
                    "bound, and the certificate lists {}, or others",
                    measured.low_wanted.size(), claimed.low_wanted.size()));
  return said;
}

}  // namespace asterism::internal
