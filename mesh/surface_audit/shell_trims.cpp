// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface_audit/shell_trims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "asterism/mesh/support/parallel_for.hpp"
#include "asterism/mesh/surface_audit/shell_findings.hpp"
#include "asterism/mesh/surface_audit/trim_distance.hpp"

namespace asterism::internal {
namespace {

struct placed_site {
  double place = 0;
  vertex_index site = 0;
};

error fault(std::string what) { return {std::move(what), error_code::invalid_mesh}; }

// Returns the given sites of each curve, ordered by place; the first is the curve's start.
result<std::vector<std::vector<placed_site>>> sites_along(const std::vector<trim_link>& trims,
                                                          const shell_face& face) {
  const mesh& m = face.plane;
  if (m.given < trims.size() || m.given > m.sites.size() || face.border.size() != m.given)
    return fault("the places of its given sites on the trimming curves differ in number");
  std::vector<std::vector<placed_site>> along(trims.size());
  for (vertex_index k = 0; k < m.given; ++k) {
    const border_place& at = face.border[k];
    const bool is_start = k < trims.size();
    const bool is_right = is_start ? at.curve == k && at.place == 0 : at.place > 0 && at.place < 1;
    if (at.curve >= trims.size() || !is_right)
      return fault(fmt::format("site {} has no place on a trimming curve", k + 1));
    along[at.curve].push_back({at.place, k});
  }
  for (std::vector<placed_site>& some : along) {
    std::sort(some.begin(), some.end(), [](const placed_site& a, const placed_site& b) {
      return a.place != b.place ? a.place < b.place : a.site < b.site;
    });
    for (std::size_t k = 1; k < some.size(); ++k)
      if (some[k].place == some[k - 1].place)
        return fault(fmt::format("sites {} and {} have one place on a trimming curve",
                                 some[k - 1].site + 1, some[k].site + 1));
  }
  return along;
}

parameter_point parameters_of(const shell_face& face, vertex_index site) {
  const point& p = face.plane.sites[site].position;
  return {std::ldexp(p.x, -face.scale_u), std::ldexp(p.y, -face.scale_v)};
}

// A chord of a face, and its curve.
struct face_chord {
  std::uint32_t face = 0, curve = 0;
  trim_chord chord;
};

void add_chords(const surface_patch& patch, const shell_face& face, std::uint32_t number,
                std::vector<face_chord>& chords) {
  const std::vector<trim_link> trims = trims_of(patch);
  const auto found = sites_along(trims, face);
  if (!found) return;  // a finding of the planes
  const auto at = [&](vertex_index site) { return parameters_of(face, site); };
  for (std::uint32_t c = 0; c < trims.size(); ++c) {
    std::vector<placed_site> sites = found.value()[c];
    sites.push_back({1, static_cast<vertex_index>(trims[c].next)});
    for (std::size_t k = 0; k + 1 < sites.size(); ++k)
      chords.push_back(
          {number,
           c,
           {sites[k].place, sites[k + 1].place, at(sites[k].site), at(sites[k + 1].site)}});
  }
}

// A use of an edge by a curve of a face.
struct edge_use {
  std::size_t face = 0;
  const trim_curve* curve = nullptr;
};

std::map<std::string, std::vector<edge_use>> uses_of_edges(const surface& s,
                                                           const surface_shell& shell) {
  std::map<std::string, std::vector<edge_use>> uses;
  for (std::size_t f = 0; f < shell.faces.size(); ++f)
    for (const trim_link& trim : trims_of(s.patches[shell.faces[f].patch]))
      if (!trim.curve->edge.empty() && !trim.curve->is_point)
        uses[trim.curve->edge].push_back({f, trim.curve});
  return uses;
}

}  // namespace

result<domain> polygons_of(const surface_patch& patch, const shell_face& face) {
  const std::vector<trim_link> trims = trims_of(patch);
  const auto along = sites_along(trims, face);
  if (!along) return along.failure();
  domain d;
  for (vertex_index k = 0; k < face.plane.given; ++k)
    d.vertices.push_back(face.plane.sites[k].position);
  for (std::size_t c = 0; c < trims.size(); ++c) {
    const std::vector<placed_site>& sites = along.value()[c];
    for (std::size_t k = 0; k < sites.size(); ++k) {
      const vertex_index to =
          k + 1 < sites.size() ? sites[k + 1].site : static_cast<vertex_index>(trims[c].next);
      d.segments.push_back({sites[k].site, to, static_cast<int>(c) + 1});
    }
  }
  return d;
}

bool is_trimmed(const surface& s) {
  return std::any_of(s.patches.begin(), s.patches.end(),
                     [](const surface_patch& p) { return !p.loops.empty(); });
}

trim_scene trims_of_shell(const surface& s, const surface_shell& shell,
                          const std::vector<shell_triangle>& triangles,
                          const std::vector<patch_spans>& spans) {
  trim_scene scene;
  scene.spans = spans;
  std::vector<std::vector<parameter_segment>> borders(s.patches.size());
  for (const shell_face& face : shell.faces) {
    if (s.patches[face.patch].loops.empty()) continue;
    const auto at = [&](vertex_index site) { return parameters_of(face, site); };
    for (const boundary_edge& e : face.plane.boundary)
      if (std::max(e.a, e.b) < face.plane.sites.size())
        borders[face.patch].push_back({at(e.a), at(e.b)});
  }
  for (auto& border : borders) scene.regions.emplace_back(std::move(border));
  for (const shell_triangle& t : triangles)
    if (!t.collapsed) scene.origins.push_back({shell.faces[t.face].patch, t.at});
  return scene;
}

void audit_trims(const surface& s, const surface_shell& shell,
                 const std::vector<bezier_piece>& pieces, double negligible,
                 const shell_question& asked, shell_report& report) {
  std::vector<face_chord> chords;
  for (std::uint32_t f = 0; f < shell.faces.size(); ++f) {
    const surface_patch& patch = s.patches[shell.faces[f].patch];
    if (patch.loops.empty()) continue;
    report.trims += trims_of(patch).size();
    add_chords(patch, shell.faces[f], f, chords);
  }
  if (report.trims == 0) return;
  const auto spans = spans_of(pieces, s.patches.size());
  const auto on_patch = [&](std::size_t face, const trim_curve& curve) {
    return curve_on_patch{pieces, spans[shell.faces[face].patch], curve};
  };
  std::vector<double> far(chords.size());
  parallel_for(far.size(), [&](std::size_t k) {
    const face_chord& c = chords[k];
    const shell_face& face = shell.faces[c.face];
    const trim_link trim = trims_of(s.patches[face.patch])[c.curve];
    far[k] = chord_distance_above(on_patch(c.face, *trim.curve), c.chord,
                                  {std::ldexp(1.0, -face.scale_u), std::ldexp(1.0, -face.scale_v)},
                                  negligible);
  });
  for (std::size_t k = 0; k < far.size(); ++k) {
    report.trim_distance = std::max(report.trim_distance, far[k]);
    if (far[k] > asked.chord)
      note_finding(report, asked,
                   fmt::format("face {}: a chord of trimming curve {} is proved within {:.9g} of "
                               "it in space, and {:.9g} is asked",
                               chords[k].face + 1, chords[k].curve + 1, far[k], asked.chord));
  }
  std::vector<std::array<edge_use, 2>> pairs;
  for (const auto& [name, uses] : uses_of_edges(s, shell))
    if (uses.size() == 2) pairs.push_back({uses[0], uses[1]});
  std::vector<double> gaps(pairs.size());
  parallel_for(gaps.size(), [&](std::size_t k) {
    const auto& [a, b] = pairs[k];
    gaps[k] = trim_gap_above(on_patch(a.face, *a.curve), on_patch(b.face, *b.curve),
                             a.curve->backward != b.curve->backward, negligible);
  });
  report.trim_edges = gaps.size();
  for (const double gap : gaps) report.trim_gap = std::max(report.trim_gap, gap);
}

}  // namespace asterism::internal
