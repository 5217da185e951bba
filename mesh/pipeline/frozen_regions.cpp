// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/frozen_regions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "asterism/mesh/data/region_of.hpp"
#include "asterism/mesh/data/renumbering.hpp"
#include "asterism/mesh/numerics/metric_angle.hpp"
#include "asterism/mesh/numerics/metric_length.hpp"
#include "asterism/mesh/search/triangle_sides.hpp"
#include "asterism/mesh/support/first_numbers.hpp"
#include "asterism/mesh/support/tensor_text.hpp"

namespace asterism {
using namespace internal;
namespace {

bool is_among(const std::vector<int>& regions, int region) {
  return std::find(regions.begin(), regions.end(), region) != regions.end();
}

// Keeps the boundary edges that are a side of some triangle, turned so that it is on their left.
void keep_edges(mesh& m) {
  const triangle_sides sides(m);
  std::size_t kept = 0;
  for (boundary_edge e : m.boundary) {
    const bool left = sides.find(e.a, e.b) != nullptr, right = sides.find(e.b, e.a) != nullptr;
    if (!left && !right) continue;
    if (!left) std::swap(e.a, e.b);
    e.internal = left && right;
    m.boundary[kept++] = e;
  }
  m.boundary.resize(kept);
}

void normalize_regions(mesh& m) {
  if (std::all_of(m.regions.begin(), m.regions.end(), [](int r) { return r == 1; }))
    m.regions.clear();
}

std::array<point, 3> sorted_corners(const mesh& m, const triangle& t) {
  std::array<point, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) corners[i] = m.sites[t[i]].position;
  std::sort(corners.begin(), corners.end(), lexicographically_less);
  return corners;
}

// A frozen triangle by its region and corners, to be compared.
struct placed_triangle {
  int region;
  std::array<double, 6> corners;
  bool operator==(const placed_triangle&) const = default;
};

bool is_before(const placed_triangle& p, const placed_triangle& q) {
  return std::tie(p.region, p.corners) < std::tie(q.region, q.corners);
}

std::vector<placed_triangle> placed(const mesh& m, const std::vector<int>& frozen) {
  std::vector<placed_triangle> all;
  for (std::size_t t = 0; t < m.triangles.size(); ++t) {
    if (!is_among(frozen, region_of(m, t))) continue;
    const auto [a, b, c] = sorted_corners(m, m.triangles[t]);
    all.push_back({region_of(m, t), {a.x, a.y, b.x, b.y, c.x, c.y}});
  }
  std::sort(all.begin(), all.end(), is_before);
  return all;
}

// Renumbers the vertices of triangles in the order of the mesh, without those in no triangle.
// Returns the old number of each.
std::vector<vertex_index> drop_vertices(mesh& m) {
  m.disagreeing.clear();
  std::vector<vertex_index> number(m.sites.size(), no_number), old;
  for (const triangle& t : m.triangles)
    for (const vertex_index v : t) number[v] = 0;
  for (vertex_index v = 0; v < number.size(); ++v) {
    if (number[v] == no_number) continue;
    number[v] = static_cast<vertex_index>(old.size());
    old.push_back(v);
  }
  renumber_vertices(m, number);
  return old;
}

void drop_triangles(mesh& m, const std::vector<int>& frozen, std::vector<vertex_index>& dropped) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < m.triangles.size(); ++t) {
    if (is_among(frozen, region_of(m, t))) {
      dropped.push_back(static_cast<vertex_index>(t));
      continue;
    }
    if (!m.regions.empty()) m.regions[kept] = m.regions[t];
    m.triangles[kept++] = m.triangles[t];
  }
  m.triangles.resize(kept);
  if (!m.regions.empty()) m.regions.resize(kept);
}

}  // namespace

result<frozen_part> without_regions(const mesh& whole, const std::vector<int>& frozen) {
  std::set<int> found;
  for (std::size_t t = 0; t < whole.triangles.size(); ++t) found.insert(region_of(whole, t));
  for (const int region : frozen)
    if (!found.contains(region))
      return error{fmt::format("region {} has no triangle; the regions there are: {}", region,
                               first_numbers(found)),
                   error_code::bad_option};
  frozen_part part;
  part.rest = whole;
  const triangle_sides sides(whole);
  std::vector<std::array<vertex_index, 2>> border;
  for (const boundary_edge& e : whole.boundary) {
    const auto *const left = sides.find(e.a, e.b), *const right = sides.find(e.b, e.a);
    if (left == nullptr || right == nullptr) continue;
    const bool left_stays = is_among(frozen, region_of(whole, left->triangle));
    if (left_stays == is_among(frozen, region_of(whole, right->triangle))) continue;
    border.push_back(left_stays ? std::array{e.b, e.a} : std::array{e.a, e.b});
  }
  drop_triangles(part.rest, frozen, part.frozen);
  if (part.rest.triangles.empty())
    return error{"all triangles are in frozen regions", error_code::bad_option};
  keep_edges(part.rest);
  part.vertex_of = drop_vertices(part.rest);
  normalize_regions(part.rest);
  part.rest.notes.clear();
  part.lone_vertices = whole.sites.size() - part.rest.sites.size();
  std::vector<vertex_index> number(whole.sites.size(), no_number);
  for (vertex_index v = 0; v < part.vertex_of.size(); ++v) number[part.vertex_of[v]] = v;
  for (const auto& [a, b] : border) part.border.push_back({number[a], number[b]});
  for (const vertex_index t : part.frozen)
    for (const vertex_index v : whole.triangles[t])
      if (number[v] != no_number) part.shared.push_back(number[v]);
  std::sort(part.shared.begin(), part.shared.end());
  part.shared.erase(std::unique(part.shared.begin(), part.shared.end()), part.shared.end());
  return part;
}

std::size_t coarsen_border(frozen_part& part, double longest) {
  std::vector<double> greatest(part.rest.sites.size(), 0);
  for (const auto& [a, b] : part.border) {
    const point &p = part.rest.sites[a].position, &q = part.rest.sites[b].position;
    for (const vertex_index v : {a, b})
      greatest[v] =
          std::max(greatest[v], plain_length(part.rest.sites[v].metric, {q.x - p.x, q.y - p.y}));
  }
  std::size_t changed = 0;
  for (std::size_t v = 0; v < greatest.size(); ++v) {
    if (!(greatest[v] > longest)) continue;
    const double factor = (longest / greatest[v]) * (longest / greatest[v]);
    metric_tensor& m = part.rest.sites[v].metric;
    m = {m.m11 * factor, m.m12 * factor, m.m22 * factor};
    ++changed;
  }
  return changed;
}

mesh_marks marks_of_rest(const frozen_part& part, const mesh_marks& marks) {
  std::map<vertex_index, vertex_index> number;
  for (vertex_index v = 0; v < part.vertex_of.size(); ++v) number[part.vertex_of[v]] = v;
  mesh_marks made;
  const auto keep = [&number](const std::vector<vertex_index>& from,
                              std::vector<vertex_index>& to) {
    for (const vertex_index v : from)
      if (const auto at = number.find(v); at != number.end()) to.push_back(at->second);
  };
  keep(marks.corners, made.corners);
  keep(marks.required_vertices, made.required_vertices);
  for (const auto& [a, b] : marks.required_edges) {
    const auto from = number.find(a), to = number.find(b);
    if (from != number.end() && to != number.end())
      made.required_edges.push_back({from->second, to->second});
  }
  made.required_edges.insert(made.required_edges.end(), part.border.begin(), part.border.end());
  made.required_vertices.insert(made.required_vertices.end(), part.shared.begin(),
                                part.shared.end());
  for (auto* const list : {&made.corners, &made.required_vertices}) {
    std::sort(list->begin(), list->end());
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  return made;
}

std::optional<mesh> with_frozen(const mesh& made, const frozen_part& part, const mesh& whole,
                                std::size_t& split) {
  std::map<std::pair<double, double>, vertex_index> at_place;
  for (vertex_index v = 0; v < made.sites.size(); ++v)
    at_place[{made.sites[v].position.x, made.sites[v].position.y}] = v;
  const auto place_of = [&](vertex_index v) {
    const point& p = part.rest.sites[v].position;
    const auto found = at_place.find({p.x, p.y});
    return found == at_place.end() ? no_number : found->second;
  };
  const triangle_sides sides(made);
  std::vector<vertex_index> number(whole.sites.size(), no_number);
  split = 0;
  for (const vertex_index v : part.shared) {
    number[part.vertex_of[v]] = place_of(v);
    if (place_of(v) == no_number) ++split;
  }
  for (const auto& [a, b] : part.border) {
    const vertex_index from = place_of(a), to = place_of(b);
    if (from == no_number || to == no_number || sides.find(from, to) == nullptr) ++split;
  }
  if (split > 0) return std::nullopt;
  mesh all = made;
  all.references.clear();
  all.regions.resize(made.triangles.size(), 1);
  const auto numbered = [&](vertex_index v) {
    if (number[v] == no_number) {
      number[v] = static_cast<vertex_index>(all.sites.size());
      all.sites.push_back(whole.sites[v]);
    }
    return number[v];
  };
  for (const vertex_index t : part.frozen) {
    const triangle& c = whole.triangles[t];
    all.triangles.push_back({numbered(c[0]), numbered(c[1]), numbered(c[2])});
    all.regions.push_back(region_of(whole, t));
  }
  const triangle_sides of_all(all);
  for (boundary_edge& e : all.boundary)
    e.internal = of_all.find(e.a, e.b) != nullptr && of_all.find(e.b, e.a) != nullptr;
  const triangle_sides before(whole);
  const auto is_frozen = [&](vertex_index a, vertex_index b) {
    const auto* const s = before.find(a, b);
    return s == nullptr || std::binary_search(part.frozen.begin(), part.frozen.end(), s->triangle);
  };
  for (const boundary_edge& e : whole.boundary) {
    if (!is_frozen(e.a, e.b) || !is_frozen(e.b, e.a)) continue;
    boundary_edge kept = e;
    kept.a = numbered(e.a);
    kept.b = numbered(e.b);
    kept.segment = static_cast<vertex_index>(all.boundary.size());
    all.boundary.push_back(kept);
  }
  return all;
}

frozen_angles angles_of_frozen(const frozen_part& part, const mesh& whole, double bound) {
  frozen_angles found;
  for (const vertex_index t : part.frozen) {
    const double angle = smallest_angle(whole, whole.triangles[t]);
    found.worst = std::min(found.worst, angle);
    if (angle < bound) ++found.low;
  }
  return found;
}

result<mesh> rest_of(mesh together, const std::vector<int>& frozen) {
  std::vector<vertex_index> dropped;
  const vertex_index given = together.given;
  drop_triangles(together, frozen, dropped);
  keep_edges(together);
  const std::vector<vertex_index> old = drop_vertices(together);
  for (vertex_index v = 0; v < old.size(); ++v)
    if (old[v] != v)
      return error{
          fmt::format("vertex {} is of frozen triangles alone, and vertices of others come "
                      "after it: this is no mesh that a run with --frozen wrote",
                      v + 1),
          error_code::invalid_mesh};
  together.given = std::min(given, static_cast<vertex_index>(old.size()));
  together.references.clear();
  normalize_regions(together);
  return together;
}

std::string difference_of_frozen(const mesh& together, const mesh& before,
                                 const std::vector<int>& frozen) {
  const std::vector<placed_triangle> now = placed(together, frozen), then = placed(before, frozen);
  if (now == then) return "";
  std::vector<placed_triangle> apart;
  std::set_symmetric_difference(now.begin(), now.end(), then.begin(), then.end(),
                                std::back_inserter(apart), is_before);
  const placed_triangle& first = apart.front();
  const auto& c = first.corners;
  return fmt::format(
      "{} frozen triangles are in one of the two meshes alone, the first of region {} "
      "with the corners {}, {} and {}",
      apart.size(), first.region, point_text({c[0], c[1]}), point_text({c[2], c[3]}),
      point_text({c[4], c[5]}));
}

}  // namespace asterism
