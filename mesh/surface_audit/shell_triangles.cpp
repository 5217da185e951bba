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
