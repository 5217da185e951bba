// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface_audit/shell_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asterism::internal {

std::vector<patch_spans> spans_of(const std::vector<bezier_piece>& pieces, std::size_t patches) {
  std::vector<patch_spans> all(patches);
  for (std::uint32_t k = 0; k < pieces.size(); ++k) {
    patch_spans& p = all[pieces[k].patch];
    if (p.u.empty()) {
      p.first = k;
      p.u.push_back(pieces[k].u_low);
      p.v.push_back(pieces[k].v_low);
    }
    if (pieces[k].u_high > p.u.back()) p.u.push_back(pieces[k].u_high);
    if (pieces[k].v_high > p.v.back()) p.v.push_back(pieces[k].v_high);
  }
  return all;
}

surface_place place_in(const std::vector<bezier_piece>& pieces, const patch_spans& spans, double u,
                       double v) {
  const auto span = [](const std::vector<double>& ends, double x) {
    const auto after = std::upper_bound(ends.begin() + 1, ends.end() - 1, x);
    return static_cast<std::size_t>(after - ends.begin()) - 1;
  };
  const auto local = [](double x, double low, double high) {
    return x >= high ? 1.0 : std::clamp((x - low) / (high - low), 0.0, 1.0);
  };
  const std::size_t at = spans.first + span(spans.u, u) * (spans.v.size() - 1) + span(spans.v, v);
  const bezier_piece& piece = pieces[at];
  return {static_cast<std::uint32_t>(at), local(u, piece.u_low, piece.u_high),
          local(v, piece.v_low, piece.v_high)};
}

std::vector<shell_triangle> triangles_of(const surface_shell& shell) {
  std::vector<shell_triangle> all;
  std::uint32_t kept = 0;
  for (std::uint32_t f = 0; f < shell.faces.size(); ++f) {
    const shell_face& face = shell.faces[f];
    for (const triangle& corners : face.plane.triangles) {
      shell_triangle t;
      t.face = f;
      for (std::size_t k = 0; k < 3; ++k) {
        const point& p = face.plane.sites[corners[k]].position;
        t.vertex[k] = face.vertex[corners[k]];
        t.at[k] = {std::ldexp(p.x, -face.scale_u), std::ldexp(p.y, -face.scale_v)};
      }
      t.collapsed =
          t.vertex[0] == t.vertex[1] || t.vertex[1] == t.vertex[2] || t.vertex[2] == t.vertex[0];
      t.kept = t.collapsed ? kept : kept++;
      all.push_back(t);
    }
  }
  return all;
}

space_mesh mesh_of(const surface_shell& shell, const std::vector<shell_triangle>& triangles) {
  space_mesh m;
  m.points = shell.points;
  for (const shell_triangle& t : triangles) {
    if (t.collapsed) continue;
    space_triangle corners = t.vertex;
    if (shell.faces[t.face].reversed) std::swap(corners[1], corners[2]);
    m.triangles.push_back(corners);
    m.faces.push_back(t.face);
  }
  return m;
}

}  // namespace asterism::internal
