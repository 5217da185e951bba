// SPDX-License-Identifier: MIT
//
// Points 0 to 2 of docs/math/proof-format.md: the triangles of the mesh and of its surroundings
// fill a rectangle (theorem 1), and those of the mesh fill the domain.
#include "asterism/mesh/proof/check_filled.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/proof/check_curves.hpp"
#include "asterism/mesh/proof/number.hpp"
#include "asterism/mesh/proof/proof_words.hpp"
#include "asterism/mesh/support/parallel.hpp"

namespace asterism::internal::proof_detail {
namespace {

constexpr std::size_t chunk = 1024;

sign turn_at(const plane& all, vertex_index a, vertex_index b, vertex_index c) {
  return filtered_kernel().orientation(all.position(a), all.position(b), all.position(c));
}

// Returns the first triangle that is not counter-clockwise, or the number of all triangles.
std::size_t first_turned(const plane& all) {
  const std::size_t count = all.triangles.size();
  std::vector<std::size_t> first(chunk_count(count, chunk), count);
  parallel_chunks(count, chunk, [&](std::size_t nth, std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end && first[nth] == count; ++t) {
      const triangle& c = all.triangles[t];
      if (turn_at(all, c[0], c[1], c[2]) != sign::positive) first[nth] = t;
    }
  });
  return *std::min_element(first.begin(), first.end());
}

// True if the edges without a reverse are the four sides of the rectangle, each once.
bool are_sides_alone(const plane& all) {
  std::array<int, 4> seen{};
  for (std::uint32_t e = 0; e < all.across.size(); ++e) {
    if (all.across[e] != plane::none) continue;
    const std::size_t a = all.corner(e), b = all.corner(plane::next(e)),
                      n = all.subject.sites.size();
    if (a < n || b != n + (a - n + 1) % 4) return false;
    ++seen[a - n];
  }
  return seen == std::array{1, 1, 1, 1};
}

bool has_all_vertices(const plane& all) {
  std::vector<char> used(all.subject.sites.size(), 0);
  for (const triangle& t : all.subject.triangles)
    for (const vertex_index v : t) used[v] = 1;
  return std::find(used.begin(), used.end(), 0) == used.end();
}

// True if each edge listed is an edge of the mesh, listed once, and all edges between the mesh and
// its surroundings are listed.
bool are_edges_listed(const plane& all) {
  std::vector<std::pair<vertex_index, vertex_index>> listed;
  for (const boundary_edge& e : all.subject.boundary) listed.push_back(std::minmax(e.a, e.b));
  std::sort(listed.begin(), listed.end());
  if (std::adjacent_find(listed.begin(), listed.end()) != listed.end()) return false;
  std::size_t found = 0;
  const std::size_t inner = 3 * all.inner_count();
  for (std::uint32_t e = 0; e < inner; ++e) {
    const bool is_outer = all.across[e] >= inner;
    if (is_outer && !all.is_segment[e]) return false;
    found += all.is_segment[e] && (is_outer || e < all.across[e]) ? 1 : 0;
  }
  return found == listed.size();
}

}  // namespace

std::optional<error> check_filled(const plane& all) {
  const std::size_t turned = first_turned(all);
  if (turned != all.triangles.size())
    return not_shown("triangle " + std::to_string(turned + 1) + " is not counter-clockwise");
  if (!are_sides_alone(all)) return not_shown("an edge has nothing, or too much, on one side");
  if (!has_all_vertices(all)) return not_shown("a vertex is in no triangle");
  if (!are_edges_listed(all)) return not_shown("the edges listed are not those of the boundary");
  return std::nullopt;
}

namespace {

// Numbers the parts into which the segments divide the rectangle, and returns the part of each
// triangle.
std::vector<std::size_t> parts_of(const plane& all) {
  const std::size_t count = all.triangles.size();
  std::vector<std::size_t> part(count, count);
  std::vector<std::uint32_t> ahead;
  for (std::size_t first = 0; first < count; ++first) {
    if (part[first] != count) continue;
    part[first] = first;
    ahead.push_back(static_cast<std::uint32_t>(first));
    while (!ahead.empty()) {
      const std::uint32_t t = ahead.back();
      ahead.pop_back();
      for (std::uint32_t e = 3 * t; e < 3 * t + 3; ++e) {
        const std::uint32_t reverse = all.across[e];
        if (reverse == plane::none || all.is_segment[e] || part[reverse / 3] != count) continue;
        part[reverse / 3] = first;
        ahead.push_back(reverse / 3);
      }
    }
  }
  return part;
}

int region_of_triangle(const mesh& subject, std::size_t t) {
  return subject.regions.empty() ? 1 : subject.regions[t];
}

// True if the point is in the triangle, or on an edge that is no segment.
bool holds_point(const plane& all, std::size_t t, const point& p) {
  for (std::size_t i = 0; i < 3; ++i) {
    const auto e = static_cast<std::uint32_t>(3 * t + i);
    const sign side = filtered_kernel().orientation(all.position(all.corner(e)),
                                                    all.position(all.corner(plane::next(e))), p);
    if (side == sign::negative || (side == sign::zero && all.is_segment[e])) return false;
  }
  return true;
}

std::optional<error> check_faces(const plane& all, const domain* shape, const mesh_proof& proof) {
  const std::vector<std::size_t> part = parts_of(all);
  const std::size_t inner = all.inner_count();
  std::map<std::size_t, int> number_of, named;
  for (std::size_t t = 0; t < inner; ++t) {
    const int region = region_of_triangle(all.subject, t);
    if (number_of.emplace(part[t], region).first->second != region)
      return not_shown("triangle " + std::to_string(t + 1) + " is of two regions");
  }
  if (shape == nullptr) return std::nullopt;
  if (proof.places.size() != shape->holes.size() + shape->regions.size())
    return not_shown("the proof does not place the domain's holes and regions");
  std::vector<char> outside(part.size(), 0);
  for (std::size_t e = 0; e < all.across.size(); ++e)
    if (all.across[e] == plane::none) outside[part[e / 3]] = 1;
  for (std::size_t k = 0; k < proof.places.size(); ++k) {
    const bool is_hole = k < shape->holes.size();
    const std::size_t t = proof.places[k];
    const point& at = is_hole ? shape->holes[k] : shape->regions[k - shape->holes.size()].at;
    if (t >= part.size() || !holds_point(all, t, at) || is_hole != (t >= inner))
      return not_shown("a hole or region point is not in the triangle that the proof names");
    if (is_hole) outside[part[t]] = 1;
    const int number = is_hole ? 0 : shape->regions[k - shape->holes.size()].number;
    if (!is_hole && named.emplace(part[t], number).first->second != number)
      return not_shown("a region has two numbers");
  }
  for (std::size_t t = 0; t < part.size(); ++t)
    if ((outside[part[t]] != 0) != (t >= inner))
      return not_shown("the mesh is not where the domain is");
  for (const auto& [p, number] : number_of) {
    const auto name = named.find(p);
    const int wanted = name != named.end() ? name->second : shape->regions.empty() ? 1 : 0;
    if (number != wanted) return not_shown("a region is numbered " + std::to_string(number));
  }
  return std::nullopt;
}

// A part of the boundary from one vertex of the domain to the next.
struct boundary_chain {
  std::vector<vertex_index> vertices;
  std::optional<int> marker;
};

using chain_map = std::map<std::pair<vertex_index, vertex_index>, boundary_chain>;

// Returns the chains of boundary edges from each vertex of the domain to the next one; nothing if a
// chain does not end at a vertex of the domain.
std::optional<chain_map> chains_of(const std::vector<boundary_edge>& edges, std::size_t sites,
                                   std::size_t given) {
  std::vector<std::vector<vertex_index>> around(sites);
  for (const boundary_edge& e : edges) {
    around[e.a].push_back(e.b);
    around[e.b].push_back(e.a);
  }
  chain_map chains;
  std::size_t pieces = 0;
  for (vertex_index v = 0; v < given; ++v)
    for (const vertex_index beside : around[v]) {
      std::vector<vertex_index> along = {v, beside};
      while (along.back() >= given) {
        const auto& ends = around[along.back()];
        if (ends.size() != 2) return std::nullopt;
        along.push_back(ends[0] == along[along.size() - 2] ? ends[1] : ends[0]);
      }
      pieces += along.size() - 1;
      const std::pair key(v, along.back());
      if (!chains.emplace(key, boundary_chain{std::move(along), {}}).second) return std::nullopt;
    }
  if (pieces != 2 * edges.size()) return std::nullopt;
  return chains;
}

bool is_between(double u, double a, double b) { return std::min(a, b) <= u && u <= std::max(a, b); }

// Assigns the marker of a segment of the domain to the chains that lie on it. False if these do not
// lead from its start to its end.
bool mark_chains(const plane& all, chain_map& chains, vertex_index a, vertex_index b, int marker) {
  vertex_index v = a;
  while (v != b) {
    std::optional<vertex_index> next;
    for (auto c = chains.lower_bound({v, 0}); c != chains.end() && c->first.first == v; ++c) {
      const vertex_index u = c->first.second;
      const point &p = all.position(u), &from = all.position(v), &to = all.position(b);
      if (!is_between(p.x, from.x, to.x) || !is_between(p.y, from.y, to.y) ||
          turn_at(all, v, b, u) != sign::zero)
        continue;
      if (next) return false;
      next = u;
    }
    if (!next) return false;
    for (const auto& key : {std::pair(v, *next), std::pair(*next, v)}) {
      std::optional<int>& own = chains[key].marker;
      if (own.value_or(0) == 0) own = marker;
    }
    v = *next;
  }
  return true;
}

// True if every edge of the chain advances along its segment, and no vertex is farther from it than
// rounding explains.
bool is_straight(const plane& all, const std::vector<vertex_index>& along) {
  if (along.size() == 2) return true;
  const point &a = all.position(along.front()), &b = all.position(along.back());
  const auto d = way<rational>(a, b);
  const rational length = dot(d, d);
  const double greatest = std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)});
  const rational unit(std::nextafter(greatest, std::numeric_limits<double>::infinity()) - greatest);
  for (std::size_t i = 0; i + 1 < along.size(); ++i) {
    const point &p = all.position(along[i]), &q = all.position(along[i + 1]);
    if (dot(d, way<rational>(p, q)) <= 0) return false;
    const rational offset = cross(d, way<rational>(a, q)), square = offset * offset;
    const rational part = rational(1) / rational(1 << 20);
    if (square > 4 * unit * unit * length &&
        (square > 256 * unit * unit * length || square > part * length * length))
      return false;
  }
  return true;
}

// Returns the distinct vertices of the domain, and for each vertex its number among these.
std::pair<std::vector<point>, std::vector<vertex_index>> distinct_vertices(const domain& shape) {
  std::map<std::pair<double, double>, vertex_index> known;
  std::pair<std::vector<point>, std::vector<vertex_index>> distinct;
  for (const point& p : shape.vertices) {
    const auto [place, is_new] =
        known.emplace(std::pair(p.x, p.y), static_cast<vertex_index>(distinct.first.size()));
    if (is_new) distinct.first.push_back(p);
    distinct.second.push_back(place->second);
  }
  return distinct;
}

// Returns the part of the boundary that must consist of segments.
result<straight_part> straight_part_of(const plane& all, const proof_question& asked,
                                       const std::vector<vertex_index>& index, std::size_t given) {
  const mesh& subject = all.subject;
  if (!asked.shape->curves.empty()) return part_off_curves(all, asked, index, given);
  if (subject.given != given) return not_shown("the first vertices are not the domain's");
  return straight_part{subject.boundary, asked.shape->segments};
}

std::optional<error> check_chains(const plane& all, const proof_question& asked) {
  const auto [points, index] = distinct_vertices(*asked.shape);
  const mesh& subject = all.subject;
  if (points.size() > subject.sites.size())
    return not_shown("the first vertices are not the domain's");
  for (std::size_t v = 0; v < points.size(); ++v)
    if (!(points[v] == subject.sites[v].position))
      return not_shown(vertex_number(v) + " is not the domain's");
  const auto straight = straight_part_of(all, asked, index, points.size());
  if (!straight) return straight.failure();
  auto chains = chains_of(straight.value().edges, subject.sites.size(), points.size());
  if (!chains) return not_shown("the boundary does not lead from vertex to vertex of the domain");
  for (const segment& s : straight.value().segments)
    if (!mark_chains(all, *chains, index[s.a], index[s.b], s.marker))
      return not_shown("the edges from " + vertex_number(index[s.a]) + " to " +
                       vertex_number(index[s.b]) + " are no segment's");
  std::map<std::pair<vertex_index, vertex_index>, int> marker_of;
  for (const boundary_edge& e : subject.boundary) marker_of[std::minmax(e.a, e.b)] = e.marker;
  for (const auto& [ends, chain] : *chains) {
    if (!chain.marker)
      return not_shown("the edges at " + vertex_number(ends.first) + " are no segment's");
    if (!is_straight(all, chain.vertices))
      return not_shown("the boundary from " + vertex_number(ends.first) + " to " +
                       vertex_number(ends.second) + " is not straight");
    for (std::size_t i = 0; i + 1 < chain.vertices.size(); ++i)
      if (marker_of.at(std::minmax(chain.vertices[i], chain.vertices[i + 1])) != *chain.marker)
        return not_shown("an edge at " + vertex_number(chain.vertices[i]) + " has another marker");
  }
  return std::nullopt;
}

}  // namespace

std::optional<error> check_shape(const plane& all, const proof_question& asked,
                                 const mesh_proof& proof) {
  if (auto failed = check_faces(all, asked.shape, proof)) return failed;
  if (asked.shape == nullptr) return std::nullopt;
  return check_chains(all, asked);
}

}  // namespace asterism::internal::proof_detail
