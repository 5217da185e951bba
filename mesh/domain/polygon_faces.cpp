// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/polygon_faces.hpp"

#include <algorithm>
#include <set>
#include <string>

#include "asterism/mesh/domain/message_names.hpp"

namespace asterism::internal {
namespace {

// Lists of numbers, one list for each key, stored in two arrays.
class number_lists {
 public:
  struct entry {
    std::size_t key = 0, number = 0;
  };
  number_lists(std::size_t keys, const std::vector<entry>& entries)
      : first_(keys + 1, 0), numbers_(entries.size()) {
    for (const entry& e : entries) ++first_[e.key + 1];
    for (std::size_t k = 0; k < keys; ++k) first_[k + 1] += first_[k];
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (const entry& e : entries) numbers_[next[e.key]++] = e.number;
  }
  std::size_t begin_of(std::size_t key) const { return first_[key]; }
  std::size_t end_of(std::size_t key) const { return first_[key + 1]; }
  std::size_t operator[](std::size_t place) const { return numbers_[place]; }

 private:
  std::vector<std::size_t> first_, numbers_;
};

std::vector<ring_place> all_rings(const domain& d) {
  std::vector<ring_place> rings;
  for (std::size_t p = 0; p < d.polygons.size(); ++p)
    for (std::size_t r = 0; r < d.polygons[p].rings.size(); ++r) rings.push_back({p, r});
  return rings;
}

std::vector<std::optional<int>> all_features(const domain& d) {
  std::vector<std::optional<int>> features;
  for (const domain_polygon& p : d.polygons) features.push_back(p.region);
  std::sort(features.begin(), features.end());
  features.erase(std::unique(features.begin(), features.end()), features.end());
  return features;
}

// Sorts the numbers, and keeps one copy of each that occurs an odd number of times.
void keep_odd(std::vector<std::size_t>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t j = i;
    while (j < numbers.size() && numbers[j] == numbers[i]) ++j;
    if ((j - i) % 2 == 1) numbers[kept++] = numbers[i];
    i = j;
  }
  numbers.resize(kept);
}

// A walk across edges that knows which polygons contain its present face.
class polygon_walk {
 public:
  polygon_walk(const domain& d, const std::vector<ring_place>& rings,
               const std::vector<std::optional<int>>& features, const number_lists& rings_of_edge)
      : rings_(rings),
        rings_of_edge_(rings_of_edge),
        is_in_(rings.size(), 0),
        in_outer_(d.polygons.size(), 0),
        holes_around_(d.polygons.size(), 0),
        polygons_here_(features.size(), 0) {
    for (const domain_polygon& p : d.polygons)
      feature_.push_back(static_cast<std::size_t>(
          std::lower_bound(features.begin(), features.end(), p.region) - features.begin()));
  }

  void cross(std::size_t edge) {
    for (std::size_t i = rings_of_edge_.begin_of(edge); i < rings_of_edge_.end_of(edge); ++i)
      change_side(rings_of_edge_[i]);
  }
  // Returns the features that contain the present face.
  const std::set<std::size_t>& here() const { return here_; }

 private:
  bool contains(std::size_t p) const { return in_outer_[p] != 0 && holes_around_[p] == 0; }

  void change_side(std::size_t ring) {
    const auto [p, number] = rings_[ring];
    const bool before = contains(p);
    is_in_[ring] ^= 1;
    if (number == 0)
      in_outer_[p] = is_in_[ring];
    else if (is_in_[ring] != 0)
      ++holes_around_[p];
    else
      --holes_around_[p];
    if (contains(p) == before) return;
    std::size_t& count = polygons_here_[feature_[p]];
    count += before ? static_cast<std::size_t>(-1) : 1;
    if (count == 0) here_.erase(feature_[p]);
    if (count == 1 && !before) here_.insert(feature_[p]);
  }

  const std::vector<ring_place>& rings_;
  const number_lists& rings_of_edge_;
  std::vector<char> is_in_, in_outer_;      // by ring, by polygon
  std::vector<std::size_t> holes_around_;   // by polygon: of its own holes
  std::vector<std::size_t> feature_;        // by polygon
  std::vector<std::size_t> polygons_here_;  // by feature
  std::set<std::size_t> here_;
};

// Returns for each edge the rings that run along it an odd number of times; lists the rings without
// any such edge.
number_lists crossed_rings(const domain& d, const plane_graph& graph,
                           const std::vector<ring_place>& rings, std::vector<ring_place>& flat) {
  std::vector<number_lists::entry> parts, crossed;
  for (const covering& c : graph.coverings) parts.push_back({c.source, c.edge});
  const number_lists edges_of_segment(d.segments.size(), parts);
  for (std::size_t r = 0; r < rings.size(); ++r) {
    std::vector<std::size_t> edges;
    for (const std::uint32_t s : d.polygons[rings[r].polygon].rings[rings[r].ring])
      for (std::size_t i = edges_of_segment.begin_of(s); i < edges_of_segment.end_of(s); ++i)
        edges.push_back(edges_of_segment[i]);
    keep_odd(edges);
    if (edges.empty()) flat.push_back(rings[r]);
    for (const std::size_t e : edges) crossed.push_back({e, r});
  }
  return {graph.edges.size(), crossed};
}

// Returns the half-edges around each face.
number_lists borders_of_faces(const plane_graph& graph, const face_map& faces) {
  std::vector<number_lists::entry> borders;
  for (std::size_t h = 0; h < 2 * graph.edges.size(); ++h) borders.push_back({faces.left_of(h), h});
  return {2 * graph.edges.size() + 1, borders};
}

void label(std::size_t face, std::size_t half_edge, const std::set<std::size_t>& here,
           polygon_faces& found) {
  if (here.empty()) return;
  found.feature_of[face] = *here.begin();
  if (here.size() == 1 || found.shared++ > 0) return;
  found.shared_half_edge = half_edge;
  found.shared_features = {*here.begin(), *std::next(here.begin())};
}

// Visits every face along a tree and back, so that the walk knows which polygons contain each.
void label_faces(const plane_graph& graph, const face_map& faces, polygon_walk& walk,
                 polygon_faces& found) {
  struct step {
    std::size_t face = face_map::outside, next = 0, came_across = 0;
  };
  const number_lists borders = borders_of_faces(graph, faces);
  std::vector<char> seen(2 * graph.edges.size() + 1, 0);
  seen[face_map::outside] = 1;
  std::vector<step> path{{face_map::outside, borders.begin_of(face_map::outside), 0}};
  while (!path.empty()) {
    step& at = path.back();
    if (at.next == borders.end_of(at.face)) {
      if (path.size() > 1) walk.cross(at.came_across);
      path.pop_back();
      continue;
    }
    const std::size_t half_edge = borders[at.next++] ^ 1;
    const std::size_t beyond = faces.left_of(half_edge);
    if (seen[beyond] != 0) continue;
    seen[beyond] = 1;
    walk.cross(half_edge / 2);
    label(beyond, half_edge, walk.here(), found);
    path.push_back({beyond, borders.begin_of(beyond), half_edge / 2});
  }
}

// Returns an error for the first ring that comes to a vertex without leaving it.
std::optional<error> check_rings(const domain& d, const plane_graph& graph,
                                 const std::vector<ring_place>& rings) {
  for (const ring_place& place : rings) {
    std::vector<std::size_t> ends;
    for (const std::uint32_t s : d.polygons[place.polygon].rings[place.ring])
      for (const vertex_index v : {d.segments[s].a, d.segments[s].b})
        ends.push_back(graph.first_alike[v]);
    keep_odd(ends);
    if (ends.empty()) continue;
    const domain_names names(d);
    return error{names.at_start() + names.ring(place.polygon, place.ring) +
                 " is not closed: it ends at " + names.vertex(ends.front())};
  }
  return {};
}

}  // namespace

result<polygon_faces> find_polygon_faces(const domain& d, const plane_graph& graph,
                                         const face_map& faces) {
  const std::vector<ring_place> rings = all_rings(d);
  if (auto failed = check_rings(d, graph, rings)) return std::move(*failed);
  polygon_faces found;
  found.features = all_features(d);
  found.feature_of.assign(2 * graph.edges.size() + 1, polygon_faces::none);
  const number_lists rings_of_edge = crossed_rings(d, graph, rings, found.flat);
  polygon_walk walk(d, rings, found.features, rings_of_edge);
  label_faces(graph, faces, walk, found);
  return found;
}

}  // namespace asterism::internal
