// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit_context.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace asterism::audit_detail {

void audit_context::found(finding_kind kind, std::string witness) {
  std::size_t& count = report.found[static_cast<std::size_t>(kind)];
  if (count++ < options.findings_kept) report.findings.push_back({kind, std::move(witness)});
}

std::size_t find_edge(const audit_context& context, index a, index b) {
  const auto& edges = context.edges;
  const auto place =
      std::lower_bound(edges.begin(), edges.end(), std::array{a, b}, [](const auto& e, auto key) {
        return std::array{e.a, e.b} < key;
      });
  if (place == edges.end() || place->a != a || place->b != b) return edges.size();
  return static_cast<std::size_t>(place - edges.begin());
}

std::size_t find_piece(const audit_context& context, index a, index b) {
  const auto& sides = context.sides;
  const auto place =
      std::lower_bound(sides.begin(), sides.end(), std::array{a, b}, [](const auto& s, auto key) {
        return std::array{s.a, s.b} < key;
      });
  if (place == sides.end() || place->a != a || place->b != b)
    return context.subject.boundary.size();
  return place->piece;
}

index apex(const audit_context& context, const directed_edge& edge) {
  const triangle& t = context.subject.triangles[edge.triangle];
  for (const index corner : t)
    if (corner != edge.a && corner != edge.b) return corner;
  return t[0];  // not reached: the corners are distinct
}

bool same_ray(const point& v, const point& a, const point& b) {
  if (a.x != v.x) return (a.x > v.x) == (b.x > v.x) && b.x != v.x;
  return (a.y > v.y) == (b.y > v.y) && b.y != v.y;
}

std::string number_text(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end.ptr};
}

std::string vertex_text(const audit_context& context, index v) {
  std::string text = "vertex " + std::to_string(std::size_t{v} + 1);
  if (v < context.subject.sites.size())
    text += " (" + number_text(context.at(v).x) + ", " + number_text(context.at(v).y) + ")";
  return text;
}

std::string triangle_text(const audit_context& context, index t) {
  const triangle& corners = context.subject.triangles[t];
  return "triangle " + std::to_string(std::size_t{t} + 1) + " of " +
         vertex_text(context, corners[0]) + ", " + vertex_text(context, corners[1]) + ", " +
         vertex_text(context, corners[2]);
}

std::string piece_text(const audit_context& context, index piece) {
  const boundary_edge& e = context.subject.boundary[piece];
  return (e.internal ? "internal edge " : "boundary edge ") +
         std::to_string(std::size_t{piece} + 1) + " from " + vertex_text(context, e.a) + " to " +
         vertex_text(context, e.b);
}

}  // namespace asterism::audit_detail
