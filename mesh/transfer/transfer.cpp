// SPDX-License-Identifier: MIT
#include "asterism/mesh/transfer/transfer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/numerics/nodal_sums.hpp"
#include "asterism/mesh/search/mesh_links.hpp"
#include "asterism/mesh/transfer/bounded_projection.hpp"
#include "asterism/mesh/transfer/locate.hpp"
#include "asterism/mesh/transfer/mass_matrix.hpp"
#include "asterism/mesh/transfer/supermesh.hpp"
#include "asterism/mesh/transfer/transfer_scale.hpp"
#include "asterism/mesh/transfer/triangle_overlap.hpp"

namespace asterism {
using namespace internal;
namespace {

constexpr std::array<std::array<const char*, 3>, 3> suffixes = {
    {{"", "", ""}, {".x", ".y", ""}, {".xx", ".xy", ".yy"}}};

std::vector<nodal_values> components_in(const solution& s) {
  std::vector<nodal_values> all;
  for (const solution_field& f : s.fields)
    for (std::size_t c = 0; c < components_of(f.kind); ++c) {
      nodal_values one{f.name + suffixes[components_of(f.kind) - 1][c], {}};
      for (std::size_t v = 0; v < s.vertices; ++v)
        one.values.push_back(f.values[v * components_of(f.kind) + c]);
      all.push_back(std::move(one));
    }
  return all;
}

solution assembled(const solution& like, const std::vector<std::vector<double>>& columns,
                   std::size_t vertices) {
  solution made;
  made.vertices = vertices;
  std::size_t column = 0;
  for (const solution_field& f : like.fields) {
    const std::size_t count = components_of(f.kind);
    solution_field field{f.name, f.kind, std::vector<double>(count * vertices)};
    for (std::size_t c = 0; c < count; ++c, ++column)
      for (std::size_t v = 0; v < vertices; ++v) field.values[v * count + c] = columns[column][v];
    made.fields.push_back(std::move(field));
  }
  return made;
}

double integral(const mesh& m, const std::vector<double>& u) {
  return ordered_sum(m.triangles.size(), [&](std::size_t i) {
    const triangle& t = m.triangles[i];
    return doubled_area(m, t) / 6 * (u[t[0]] + u[t[1]] + u[t[2]]);
  });
}

double area_of(const mesh& m) {
  return ordered_sum(m.triangles.size(),
                     [&](std::size_t i) { return doubled_area(m, m.triangles[i]) / 2; });
}

std::vector<double> interpolated(const mesh& from, const std::vector<double>& u, const mesh& to,
                                 const located_vertices& located) {
  std::vector<double> made(to.sites.size());
  for_each_node(made.size(), [&](std::size_t v) {
    const triangle& t = from.triangles[located.triangle[v]];
    const auto w = weights_in(
        {from.sites[t[0]].position, from.sites[t[1]].position, from.sites[t[2]].position},
        to.sites[v].position);
    // Interpolates differences from one corner, so that a constant stays unchanged to the last bit.
    made[v] = u[t[0]] + w[1] * (u[t[1]] - u[t[0]]) + w[2] * (u[t[2]] - u[t[0]]);
    const auto [low, high] = std::minmax({u[t[0]], u[t[1]], u[t[2]]});
    made[v] = std::clamp(made[v], low, high);
  });
  return made;
}

std::vector<std::vector<double>> projected(const mesh& to, const mesh_links& links,
                                           const supermesh& common, transfer_method how,
                                           std::vector<std::vector<double>> guess) {
  const mass_matrix mass(to, links, common.mass);
  for (std::size_t f = 0; f < guess.size(); ++f) {
    std::vector<double> b(to.sites.size(), 0.0);
    for_each_node(b.size(), [&](std::size_t v) {
      for (const incidence& at : links.around(static_cast<vertex_index>(v)))
        b[v] += common.load[f][at.triangle].of_corner[at.corner];
    });
    guess[f] = mass.solve(b, std::move(guess[f]));
    if (how == transfer_method::bounded)
      guess[f] = bounded_projection(to, links, mass, common.load[f], b, guess[f]);
  }
  return guess;
}

std::optional<error> check(const mesh& from, const solution& values, const mesh& to) {
  if (from.triangles.empty()) return error{"the mesh of the values has no triangle"};
  if (to.triangles.empty()) return error{"the mesh that values are to go to has no triangle"};
  if (values.vertices != from.sites.size())
    return error{"the solution has values at " + std::to_string(values.vertices) +
                 " vertices, and the mesh has " + std::to_string(from.sites.size())};
  for (const solution_field& f : values.fields)
    if (f.values.size() != values.vertices * components_of(f.kind))
      return error{"field " + quoted_token(f.name) +
                   " has not as many numbers as its vertices take"};
  for (const solution_field& f : values.fields)
    for (const double u : f.values)
      if (!std::isfinite(u)) return error{"field " + quoted_token(f.name) + " is not finite"};
  return std::nullopt;
}

// Refuses values beyond the range of doubles.
std::optional<error> check_finite(const transfer_report& report, const solution& after) {
  const auto bad = [](const std::string& what) {
    return error{what +
                 " is not finite: coordinates or values are so large that no double holds it; give "
                 "them in other units"};
  };
  for (const double area : {report.area_before, report.area_after, report.area_common})
    if (!std::isfinite(area)) return bad("the area of a mesh");
  std::size_t component = 0;
  for (const solution_field& f : after.fields) {
    const std::size_t count = components_of(f.kind);
    for (std::size_t i = 0; i < f.values.size(); ++i)
      if (!std::isfinite(f.values[i]))
        return bad("field " + quoted_token(report.components[component + i % count].name) +
                   " at vertex " + std::to_string(i / count + 1));
    for (std::size_t c = 0; c < count; ++c, ++component) {
      const transferred_component& one = report.components[component];
      if (!std::isfinite(one.integral_before) || !std::isfinite(one.integral_after))
        return bad("the integral of field " + quoted_token(one.name));
    }
  }
  return std::nullopt;
}

// Transfers values and places of ordinary size (mesh/transfer/transfer_scale.hpp).
result<transferred_solution> transfer_ordinary(const mesh& from, const solution& values,
                                               const mesh& to, transfer_method how) {
  const mesh_links old_links(from), new_links(to);
  auto located = locate_vertices(from, old_links, to, new_links);
  if (!located) return located.failure();
  const std::vector<nodal_values> before = components_in(values);
  std::vector<std::vector<double>> after;
  after.reserve(before.size());
  for (const nodal_values& u : before)
    after.push_back(interpolated(from, u.values, to, located.value()));
  transfer_report report;
  report.outside = located.value().outside;
  report.greatest_distance = located.value().greatest_distance;
  report.area_before = area_of(from);
  report.area_after = area_of(to);
  if (how != transfer_method::interpolate) {
    const supermesh common = intersect_meshes(from, old_links, before, to, located.value(), after);
    report.area_common = common.common_area;
    report.partly_covered = common.partly_covered;
    report.pieces = common.pieces;
    after = projected(to, new_links, common, how, std::move(after));
  }
  for (std::size_t f = 0; f < before.size(); ++f) {
    const auto [low, high] = std::minmax_element(before[f].values.begin(), before[f].values.end());
    const auto [least, greatest] = std::minmax_element(after[f].begin(), after[f].end());
    report.components.push_back({before[f].name, integral(from, before[f].values),
                                 integral(to, after[f]), *low, *high, *least, *greatest});
  }
  return transferred_solution{assembled(values, after, to.sites.size()), std::move(report)};
}

}  // namespace

result<transferred_solution> transfer_solution(const mesh& from, const solution& values,
                                               const mesh& to, transfer_method how) {
  if (auto failed = check(from, values, to)) return *failed;
  const transfer_scale scale = scale_of(from, values, to);
  auto made = scale.is_one() ? transfer_ordinary(from, values, to, how)
                             : transfer_ordinary(placed(from, scale), divided(values, scale),
                                                 placed(to, scale), how);
  if (!made) return made;
  multiply(made.value(), scale);
  if (auto failed = check_finite(made.value().report, made.value().values)) return *failed;
  return made;
}

}  // namespace asterism
