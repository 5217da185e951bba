// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/regions.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "asterism/mesh/domain/message_names.hpp"
#include "asterism/mesh/domain/repair_tally.hpp"

namespace asterism::internal {

namespace {

using failure = std::optional<error>;

// Checks that the face around q is valid: q is on no edge and not outside. `place` and `name` are
// used in messages.
failure check_bounded(const domain& d, const plane_graph& graph, const face_map& faces,
                      const point& q, std::size_t face, const std::string& place,
                      const std::string& name) {
  const domain_names names(d);
  const std::size_t edge = faces.edge_through(q);
  if (edge < graph.edges.size()) {
    const std::size_t s = graph.edges[edge].source;
    return error{place + name + " lies on " + names.segment(s) + names.line_of_segment(s)};
  }
  if (face == face_map::outside) return error{place + name + " lies outside of the domain"};
  return {};
}

// Reports rings that enclose nothing, and features that overlap.
void tell_polygons(const domain& d, const plane_graph& graph, const polygon_faces& polygons,
                   domain_repairs& repairs) {
  const domain_names names(d);
  const auto place = [&] { return names.at_start(); };
  repair_tally flat(repairs.flat_rings), shared(repairs.shared_parts);
  for (const ring_place& r : polygons.flat)
    flat.add(place, [&] { return names.ring(r.polygon, r.ring); });
  flat.report("rings that enclose nothing", repairs.messages);
  for (std::size_t i = 0; i < polygons.shared; ++i)
    shared.add(place, [&] {
      const auto [f, g] = polygons.shared_features;
      const covered_edge& beside = graph.edges[polygons.shared_half_edge / 2];
      return names.feature(polygons.features[f]) + " and " + names.feature(polygons.features[g]) +
             " beside " + coordinates(d.vertices[beside.a]) + " - " +
             coordinates(d.vertices[beside.b]);
    });
  shared.report("parts in which features overlap, numbered as the first of them", repairs.messages);
}

failure remove_holes(const domain& d, const plane_graph& graph, const face_map& faces,
                     domain_parts& parts) {
  const domain_names names(d);
  const std::vector<std::size_t> around = faces.faces_around(d.holes);
  for (std::size_t h = 0; h < d.holes.size(); ++h) {
    if (auto failed =
            check_bounded(d, graph, faces, d.holes[h], around[h], names.at_hole(h), names.hole(h)))
      return failed;
    parts.removed[around[h]] = true;
  }
  return {};
}

failure remove_outside_polygons(const domain& d, const plane_graph& graph, const face_map& faces,
                                domain_parts& parts, domain_repairs& repairs) {
  auto found = find_polygon_faces(d, graph, faces);
  if (!found) return found.failure();
  parts.polygons = std::move(found).value();
  for (std::size_t face = 0; face < parts.removed.size(); ++face)
    parts.removed[face] = parts.polygons.feature_of[face] == polygon_faces::none;
  tell_polygons(d, graph, parts.polygons, repairs);
  return {};
}

// Maps each face with a region point to the first of its points.
using named_faces = std::map<std::size_t, std::size_t>;

failure name_faces(const domain& d, const plane_graph& graph, const face_map& faces,
                   const domain_parts& parts, named_faces& named) {
  const domain_names names(d);
  std::vector<point> places;
  for (const region_point& r : d.regions) places.push_back(r.at);
  const std::vector<std::size_t> around = faces.faces_around(places);
  for (std::size_t r = 0; r < d.regions.size(); ++r) {
    if (auto failed = check_bounded(d, graph, faces, places[r], around[r], names.at_region(r),
                                    names.region(r)))
      return failed;
    if (parts.removed[around[r]])
      return error{names.at_region(r) + names.region(r) + " lies in a hole"};
    const auto [first, is_new] = named.try_emplace(around[r], r);
    if (!is_new && d.regions[first->second].number != d.regions[r].number)
      return error{names.at_region(r) + names.region(r) + " and " + names.region(first->second) +
                   " give different numbers to one region"};
  }
  return {};
}

// Returns the number that the polygons around a face give it; none if no polygon has one.
std::optional<int> number_of_feature(const domain_parts& parts, std::size_t face) {
  if (parts.polygons.feature_of.empty() || parts.removed[face]) return std::nullopt;
  return parts.polygons.features[parts.polygons.feature_of[face]];
}

// Gives each face of the domain that has no region number yet the least number that is not taken,
// in the order of the edges.
void number_the_rest(const domain& d, const plane_graph& graph, const face_map& faces,
                     const named_faces& named, domain_parts& parts) {
  std::set<int> taken;
  for (const region_point& r : d.regions) taken.insert(r.number);
  for (const auto& number : parts.polygons.features)
    if (number) taken.insert(*number);
  std::vector<bool> done(parts.region.size(), false);
  for (const auto& face : named) done[face.first] = true;
  for (std::size_t face = 0; face < done.size(); ++face)
    if (number_of_feature(parts, face)) done[face] = true;
  int next = 1;
  for (std::size_t h = 0; h < 2 * graph.edges.size(); ++h) {
    const std::size_t face = faces.left_of(h);
    if (parts.removed[face] || done[face]) continue;
    while (taken.contains(next)) ++next;
    parts.region[face] = next++;
    done[face] = true;
  }
}

}  // namespace

result<domain_parts> find_parts(const domain& d, const plane_graph& graph, const face_map& faces,
                                domain_repairs& repairs) {
  const std::size_t count = 2 * graph.edges.size() + 1;  // one walk a half-edge at most
  domain_parts parts{std::vector<bool>(count, false), std::vector<int>(count, 1), {}};
  parts.removed[face_map::outside] = true;
  if (!d.polygons.empty())
    if (auto failed = remove_outside_polygons(d, graph, faces, parts, repairs))
      return std::move(*failed);
  if (auto failed = remove_holes(d, graph, faces, parts)) return std::move(*failed);
  const auto& features = parts.polygons.features;
  const bool has_numbers = !features.empty() && features.back().has_value();
  if (d.regions.empty() && !d.number_all_regions && !has_numbers) return parts;
  named_faces named;
  if (auto failed = name_faces(d, graph, faces, parts, named)) return std::move(*failed);
  for (std::size_t face = 0; face < count; ++face)
    parts.region[face] = number_of_feature(parts, face).value_or(0);
  for (const auto& [face, r] : named) parts.region[face] = d.regions[r].number;
  if (d.number_all_regions) number_the_rest(d, graph, faces, named, parts);
  return parts;
}

}  // namespace asterism::internal
