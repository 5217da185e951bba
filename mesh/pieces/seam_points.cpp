// SPDX-License-Identifier: MIT
#include "asterism/mesh/pieces/seam_points.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/fill/segment_division.hpp"
#include "asterism/mesh/metric/feature_size_field.hpp"

namespace asterism::internal {
namespace {

// Greatest metric length of a subsegment of a seam. Subsegments of a domain's boundary are at most
// 0.9 long, 0.81 in the mean; edges inside are 1.00 in the mean, and a seam is inside. With 0.9 a
// mesh in 64 pieces of 6,000 triangles had 0.5 to 0.8 % more triangles than without pieces, with
// 1.05 none more (docs/results/pieces.md). A piece splits subsegments longer than 1.2.
constexpr double longest_subsegment_of_seam = 1.05;
// Number of vertices from which a fill spreads sites by features (refine/site_budget.cpp).
constexpr std::size_t many_vertices = 120;

// Returns the chain of points between the ends of a segment in a mesh.
std::vector<point> points_along(const mesh& m, const segment& whole,
                                const std::map<vertex_index, vertex_index>& next) {
  std::vector<point> points;
  for (vertex_index at = whole.a; at != whole.b;) {
    const auto step = next.find(at);
    if (step == next.end() || points.size() > next.size()) break;
    at = step->second;
    if (at != whole.b) points.push_back(m.sites[at].position);
  }
  return points;
}

// True if all of `few` are in `many`, in their order.
bool are_among(const std::vector<point>& few, const std::vector<point>& many) {
  std::size_t i = 0;
  for (const point& q : many)
    if (i < few.size() && few[i] == q) ++i;
  return i == few.size();
}

// Merges two lists of points on a seam, both of which contain all points of `before`. Between two
// successive points of `before` takes the points of `now`, or, if `now` has none there, of `asked`.
std::vector<point> united(const std::vector<point>& before, const std::vector<point>& now,
                          const std::vector<point>& asked) {
  std::vector<point> all;
  std::size_t in_now = 0, in_asked = 0;
  for (std::size_t i = 0; i <= before.size(); ++i) {
    const auto between = [&](const std::vector<point>& from, std::size_t& at) {
      std::vector<point> found;
      while (at < from.size() && !(i < before.size() && from[at] == before[i]))
        found.push_back(from[at++]);
      ++at;
      return found;
    };
    const std::vector<point> there = between(now, in_now), wanted = between(asked, in_asked);
    const std::vector<point>& taken = there.empty() ? wanted : there;
    all.insert(all.end(), taken.begin(), taken.end());
    if (i < before.size()) all.push_back(before[i]);
  }
  return all;
}

result<seam_points> divided_in(const domain_cut& cut, const metric_field& field) {
  domain all;
  all.vertices = cut.vertices;
  for (const cut_edge& e : cut.edges) all.segments.push_back({e.a, e.b, e.marker});
  auto divided = divide_segments(all, field, longest_subsegment_of_seam,
                                 std::numeric_limits<vertex_index>::max());
  if (!divided) return divided.failure();
  if (divided.value().of_each.size() != cut.edges.size())
    return error{"the seams want more vertices than there can be"};
  seam_points points(cut.edges.size());
  for (std::size_t e = 0; e < points.size(); ++e) {
    const std::vector<point>& one = divided.value().of_each[e].points;
    if (cut.edges[e].is_seam() && one.size() > 2) points[e] = {one.begin() + 1, one.end() - 1};
  }
  return points;
}

}  // namespace

result<seam_points> divide_seams(const domain& d, const domain_cut& cut,
                                 const metric_field& field) {
  if (d.vertices.size() < many_vertices) return divided_in(cut, field);
  const auto featured = featured_field::make(d, field, 1);
  if (!featured) return featured.failure();
  return divided_in(cut, featured.value());
}

result<std::vector<seam_in_mesh>> seams_asked_for(const domain_cut& cut, const piece_shape& piece,
                                                  piece_index number, const mesh& m) {
  std::vector<std::map<vertex_index, vertex_index>> next(piece.shape.segments.size());
  for (const boundary_edge& e : m.boundary) next[e.segment][e.a] = e.b;
  std::vector<seam_in_mesh> asked;
  for (std::size_t s = 0; s < piece.shape.segments.size(); ++s) {
    if (!piece.divisions[s]) continue;
    const segment& whole = piece.shape.segments[s];
    std::vector<point> points = points_along(m, whole, next[s]);
    if (points == *piece.divisions[s]) continue;
    if (!are_among(*piece.divisions[s], points)) {
      const point &a = piece.shape.vertices[whole.a], &b = piece.shape.vertices[whole.b];
      return error{"piece " + std::to_string(number + 1) +
                   ": its mesh left out a point of the seam from (" + number_text(a.x) + ", " +
                   number_text(a.y) + ") to (" + number_text(b.x) + ", " + number_text(b.y) +
                   "): other parts of the domain are too near to it"};
    }
    if (cut.edges[piece.edge_of[s]].left != number) std::reverse(points.begin(), points.end());
    asked.push_back({piece.edge_of[s], std::move(points)});
  }
  return asked;
}

std::vector<std::size_t> unite_seams(const std::vector<seam_in_mesh>& asked, seam_points& points) {
  std::map<std::size_t, std::vector<point>> now;
  for (const seam_in_mesh& one : asked) {
    const auto place = now.emplace(one.edge, points[one.edge]).first;
    place->second = united(points[one.edge], place->second, one.points);
  }
  std::vector<std::size_t> changed;
  for (auto& [edge, united_points] : now) {
    points[edge] = std::move(united_points);
    changed.push_back(edge);
  }
  return changed;
}

}  // namespace asterism::internal
