// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface_audit/plane_faces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/surface_audit/shell_findings.hpp"
#include "asterism/mesh/surface_audit/shell_trims.hpp"

namespace asterism::internal {
namespace {

struct side_site {
  vertex_index site;
  double along;  // in the order of going around
};

std::array<double, 2> ends(const std::vector<double>& knots) {
  if (knots.empty()) return {0, 1};
  return {knots.front(), knots.back()};
}

}  // namespace

result<domain> rectangle_of(const surface_patch& patch, const shell_face& face) {
  const auto u = ends(patch.knots_u), v = ends(patch.knots_v);
  const double x0 = std::ldexp(u[0], face.scale_u), x1 = std::ldexp(u[1], face.scale_u),
               y0 = std::ldexp(v[0], face.scale_v), y1 = std::ldexp(v[1], face.scale_v);
  const mesh& m = face.plane;
  if (m.given < 4 || m.given > m.sites.size())
    return error{"fewer than four sites are given", error_code::invalid_mesh};
  const std::array<point, 4> corners = {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
  std::array<std::vector<side_site>, 4> sides;
  for (vertex_index k = 0; k < m.given; ++k) {
    const point p = m.sites[k].position;
    if (k < 4) {
      if (p.x != corners[k].x || p.y != corners[k].y)
        return error{fmt::format("site {} is not the corner of its patch", k + 1),
                     error_code::invalid_mesh};
      continue;
    }
    const bool in_x = x0 < p.x && p.x < x1, in_y = y0 < p.y && p.y < y1;
    if (in_x && p.y == y0)
      sides[0].push_back({k, p.x});
    else if (in_y && p.x == x1)
      sides[1].push_back({k, p.y});
    else if (in_x && p.y == y1)
      sides[2].push_back({k, -p.x});
    else if (in_y && p.x == x0)
      sides[3].push_back({k, -p.y});
    else
      return error{fmt::format("site {} is on no side of its patch", k + 1),
                   error_code::invalid_mesh};
  }
  domain d;
  for (vertex_index k = 0; k < m.given; ++k) d.vertices.push_back(m.sites[k].position);
  for (vertex_index side = 0; side < 4; ++side) {
    auto& on = sides[side];
    std::sort(on.begin(), on.end(),
              [](const side_site& a, const side_site& b) { return a.along < b.along; });
    vertex_index from = side;
    for (const side_site& s : on) {
      d.segments.push_back({from, s.site, static_cast<int>(side) + 1});
      from = s.site;
    }
    d.segments.push_back({from, (side + 1) % 4, static_cast<int>(side) + 1});
  }
  return d;
}

void audit_planes(const surface& s, const surface_shell& shell, const shell_question& asked,
                  shell_report& report) {
  for (std::size_t f = 0; f < shell.faces.size(); ++f) {
    const shell_face& face = shell.faces[f];
    const surface_patch& patch = s.patches[face.patch];
    const auto shape = patch.loops.empty() ? rectangle_of(patch, face) : polygons_of(patch, face);
    if (!shape) {
      note_finding(report, asked, fmt::format("face {}: {}", f + 1, shape.failure().message));
      continue;
    }
    audit_options options;
    options.angle_bound = asked.angle_bound;
    options.find_exempt_corners = true;
    options.original = &shape.value();
    const audit_report found = audit(face.plane, options);
    report.least_angle = std::min(report.least_angle, found.worst().degrees);
    for (const audit_finding& finding : found.findings)
      note_finding(
          report, asked,
          fmt::format("face {}: {}: {}", f + 1,
                      finding_kind_names[static_cast<std::size_t>(finding.kind)], finding.witness));
    if (!found.certified && found.findings.empty())
      note_finding(report, asked, fmt::format("face {}: its plane mesh is not certified", f + 1));
  }
}

}  // namespace asterism::internal
