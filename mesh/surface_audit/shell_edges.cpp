// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface_audit/shell_edges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "asterism/mesh/surface_audit/shell_findings.hpp"
#include "asterism/mesh/surface_audit/trim_pieces.hpp"

namespace asterism::internal {
namespace {

using shell_edge = std::pair<std::uint32_t, std::uint32_t>;

// Key of a patch's side: its control points and knots, from its start or from its end. Equal keys
// mean one curve, bit for bit.
using side_key = std::vector<double>;

side_key key_of(const surface_patch& p, int side, bool backward) {
  const bool along_u = side % 2 == 0;
  const std::size_t count = along_u ? p.count_u : p.count_v;
  side_key key;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t k = backward ? count - 1 - i : i;
    const control_point& c =
        along_u ? p.at(k, side == 0 ? 0 : p.count_v - 1) : p.at(side == 3 ? 0 : p.count_u - 1, k);
    for (const double x : {c.at.x + 0.0, c.at.y + 0.0, c.at.z + 0.0, c.weight}) key.push_back(x);
  }
  const std::vector<double>& knots = along_u ? p.knots_u : p.knots_v;
  if (knots.size() == 2 * count) return key;  // a Bezier curve, whatever its knots
  for (std::size_t i = 0; i < knots.size(); ++i)
    key.push_back(backward ? knots.back() - knots[knots.size() - 1 - i] : knots[i] - knots.front());
  return key;
}

// Sides, by face and number, that are the same curve as another side, and sides that are one point.
// The sides of a trimmed patch are its curves.
struct side_facts {
  std::set<std::pair<std::size_t, int>> shared, points;
};

void add_rectangle(const surface_patch& p, std::size_t f, side_facts& facts,
                   std::map<side_key, std::vector<std::pair<std::size_t, int>>>& by_curve) {
  for (int side = 0; side < 4; ++side) {
    const side_key forward = key_of(p, side, false), backward = key_of(p, side, true);
    bool is_point = true;
    const std::size_t count = side % 2 == 0 ? p.count_u : p.count_v;
    for (std::size_t k = 1; k < count; ++k)
      for (std::size_t c = 0; c < 3; ++c) is_point = is_point && forward[4 * k + c] == forward[c];
    if (is_point)
      facts.points.emplace(f, side);
    else
      by_curve[std::min(forward, backward)].emplace_back(f, side);
  }
}

side_facts facts_of(const surface& s, const surface_shell& shell) {
  std::map<side_key, std::vector<std::pair<std::size_t, int>>> by_curve;
  std::map<std::string, std::vector<std::pair<std::size_t, int>>> by_edge;
  side_facts facts;
  for (std::size_t f = 0; f < shell.faces.size(); ++f) {
    const surface_patch& p = s.patches[shell.faces[f].patch];
    if (p.loops.empty()) add_rectangle(p, f, facts, by_curve);
    int side = 0;
    for (const trim_link& trim : trims_of(p)) {
      if (trim.curve->is_point)
        facts.points.emplace(f, side);
      else if (!trim.curve->edge.empty())
        by_edge[trim.curve->edge].emplace_back(f, side);
      ++side;
    }
  }
  const auto add_shared = [&](const std::vector<std::pair<std::size_t, int>>& sides) {
    if (sides.size() > 1) facts.shared.insert(sides.begin(), sides.end());
  };
  for (const auto& [curve, sides] : by_curve) add_shared(sides);
  for (const auto& [edge, sides] : by_edge) add_shared(sides);
  return facts;
}

// Finds the side that an edge of a face's plane mesh is on.
class face_sides {
 public:
  face_sides(const surface_patch& patch, const shell_face& face)
      : face_(face), trimmed_(!patch.loops.empty()) {
    // Trusts the markers of boundary edges: the audit of the plane mesh compared them with the
    // trimming curves.
    if (trimmed_)
      for (const boundary_edge& e : face.plane.boundary)
        on_.emplace(std::pair{e.a, e.b}, e.marker - 1);
  }
  // Returns the side that the edge from a to b is on, with the face on its left; none for an inner
  // edge.
  std::optional<int> of(vertex_index a, vertex_index b) const {
    if (!trimmed_)
      return of_rectangle(face_.plane.sites[a].position, face_.plane.sites[b].position);
    const auto found = on_.find({a, b});
    return found == on_.end() ? std::nullopt : std::optional(found->second);
  }

 private:
  std::optional<int> of_rectangle(const point& a, const point& b) const;

  const shell_face& face_;
  bool trimmed_;
  std::map<std::pair<vertex_index, vertex_index>, int> on_;
};

std::optional<int> face_sides::of_rectangle(const point& a, const point& b) const {
  const point low = face_.plane.sites[0].position, high = face_.plane.sites[2].position;
  if (a.y == low.y && b.y == low.y) return 0;
  if (a.x == high.x && b.x == high.x) return 1;
  if (a.y == high.y && b.y == high.y) return 2;
  if (a.x == low.x && b.x == low.x) return 3;
  return std::nullopt;
}

// Calls visit(f, t, k, side_of) for each edge of a plane face's triangles, that from corner k of
// triangle t of face f; side_of() returns the side that the edge is on, if it is on any.
template <class Visit>
void visit_sides(const surface& s, const surface_shell& shell,
                 const std::vector<shell_triangle>& triangles, const Visit& visit) {
  std::size_t at = 0;
  for (std::size_t f = 0; f < shell.faces.size(); ++f) {
    const face_sides sides(s.patches[shell.faces[f].patch], shell.faces[f]);
    for (const triangle& corners : shell.faces[f].plane.triangles) {
      const shell_triangle& t = triangles[at++];
      for (std::size_t k = 0; k < 3; ++k)
        visit(f, t, k, [&] { return sides.of(corners[k], corners[(k + 1) % 3]); });
    }
  }
}

// Returns the edges of plane triangles on sides that belong to one patch alone, in the shell's
// orientation. Edges of triangles collapsed in space count: where such a triangle lies between the
// shell and a side, two of its edges are one edge in space.
std::set<shell_edge> edges_at_open_sides(const surface& s, const surface_shell& shell,
                                         const std::vector<shell_triangle>& triangles,
                                         const side_facts& facts) {
  std::set<shell_edge> edges;
  visit_sides(s, shell, triangles,
              [&](std::size_t f, const shell_triangle& t, std::size_t k, const auto& side_of) {
                const auto side = side_of();
                if (!side || facts.shared.contains({f, *side})) return;
                shell_edge e{t.vertex[k], t.vertex[(k + 1) % 3]};
                if (shell.faces[f].reversed) std::swap(e.first, e.second);
                edges.insert(e);
              });
  return edges;
}

// Reports the edges that occur twice, in the order given.
void name_repeated(const std::vector<shell_edge>& given, const shell_question& asked,
                   shell_report& report) {
  std::set<shell_edge> before;
  for (const shell_edge& e : given)
    if (!before.insert(e).second)
      note_finding(report, asked,
                   fmt::format("the edge from vertex {} to {} is in two triangles the same way",
                               e.first + 1, e.second + 1));
}

}  // namespace

void audit_edges(const surface& s, const surface_shell& shell,
                 const std::vector<shell_triangle>& triangles, const shell_question& asked,
                 shell_report& report) {
  const space_mesh m = mesh_of(shell, triangles);
  std::vector<shell_edge> given, directed;
  std::vector<unsigned char> is_used(shell.points.size(), 0);
  for (const space_triangle& t : m.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      given.emplace_back(t[k], t[(k + 1) % 3]);
      is_used[t[k]] = 1;
    }
  directed = given;
  std::sort(directed.begin(), directed.end());
  const auto end_of_distinct = std::unique(directed.begin(), directed.end());
  if (end_of_distinct != directed.end()) name_repeated(given, asked, report);
  directed.erase(end_of_distinct, directed.end());
  const side_facts facts = facts_of(s, shell);
  const std::set<shell_edge> at_sides = edges_at_open_sides(s, shell, triangles, facts);
  for (const shell_edge& e : directed) {
    if (std::binary_search(directed.begin(), directed.end(), shell_edge{e.second, e.first}))
      continue;
    ++report.open_edges;
    if (!at_sides.contains(e))
      note_finding(report, asked,
                   fmt::format("the edge from vertex {} to {} has no triangle on its other side",
                               e.first + 1, e.second + 1));
  }
  report.edges = (directed.size() + report.open_edges) / 2;
  report.vertices = shell.points.size();
  report.triangles = m.triangles.size();
  report.collapsed = triangles.size() - m.triangles.size();
  report.euler = static_cast<long>(report.vertices) - static_cast<long>(report.edges) +
                 static_cast<long>(report.triangles);
  const auto unused = std::count(is_used.begin(), is_used.end(), 0);
  if (unused > 0)
    note_finding(report, asked, fmt::format("{} vertices are in no triangle", unused));
  // Checks that a collapsed triangle is at a side that is one point.
  visit_sides(s, shell, triangles,
              [&](std::size_t f, const shell_triangle& t, std::size_t k, const auto& side_of) {
                if (!t.collapsed || t.vertex[k] != t.vertex[(k + 1) % 3]) return;
                const auto side = side_of();
                if (!side || !facts.points.contains({f, *side}))
                  note_finding(report, asked,
                               fmt::format("face {}: a triangle has vertex {} twice, which is at "
                                           "no side that is one point",
                                           f + 1, t.vertex[k] + 1));
              });
}

}  // namespace asterism::internal
