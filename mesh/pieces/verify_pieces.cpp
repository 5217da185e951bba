// SPDX-License-Identifier: MIT
#include "asterism/mesh/pieces/verify_pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <map>
#include <optional>
#include <utility>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/audit/divided_domain.hpp"
#include "asterism/mesh/pieces/piece_curves.hpp"

namespace asterism::internal {
namespace {

using faults = std::vector<std::string>;
using bits = std::array<std::uint64_t, 2>;  // of a point: coordinates that differ differ here
using directed = std::array<std::uint64_t, 4>;

bits bits_of(const point& q) {
  return {std::bit_cast<std::uint64_t>(q.x), std::bit_cast<std::uint64_t>(q.y)};
}
directed bits_of(const point& a, const point& b) {
  const bits from = bits_of(a), to = bits_of(b);
  return {from[0], from[1], to[0], to[1]};
}

std::string text_of(const point& q) {
  return fmt::format("({}, {})", number_text(q.x), number_text(q.y));
}

std::string name_of(piece_index piece) { return fmt::format("piece {}", std::size_t{piece} + 1); }

std::string edge_text(const pieces_index& index, std::size_t e) {
  const cut_edge& edge = index.cut.edges[e];
  return std::string(edge.is_cut() ? "cut " : "edge ") + std::to_string(e + 1) + " from " +
         text_of(index.cut.vertices[edge.a]) + " to " + text_of(index.cut.vertices[edge.b]);
}

// Returns what is wrong with the pieces, regions and marker of an edge of the cut; none if nothing.
std::optional<std::string> wrong_sides(const pieces_index& index, const cut_edge& e) {
  if (e.left == no_piece) return "has no piece on its left";
  if (e.is_cut()) {
    if (e.right == no_piece || e.left == e.right) return "has not two pieces beside it";
    if (e.left_region != e.right_region) return "has two regions beside it";
    if (e.marker != index.cut.marker) return "has not the marker of cuts";
    return std::nullopt;
  }
  const segment& s = index.original.segments[e.segment];
  if (s.internal != (e.right != no_piece))
    return s.internal ? "has a piece on one side alone" : "has a piece outside the domain";
  if (e.marker != s.marker) return "has not the marker of its segment";
  if (e.left_region != s.left_region || e.right_region != s.right_region)
    return "has not the regions of its segment";
  return std::nullopt;
}

void check_edges(const pieces_index& index, faults& all) {
  std::map<std::array<vertex_index, 2>, std::size_t> seen;
  std::vector<char> has_edge(index.cut.pieces, 0);
  for (std::size_t e = 0; e < index.cut.edges.size(); ++e) {
    const cut_edge& edge = index.cut.edges[e];
    if (const auto wrong = wrong_sides(index, edge))
      all.push_back(edge_text(index, e) + " " + *wrong);
    if (edge.a == edge.b ||
        !seen.emplace(std::array{std::min(edge.a, edge.b), std::max(edge.a, edge.b)}, e).second)
      all.push_back(edge_text(index, e) + " has no length, or is there twice");
    if (!index.points[e].empty() && !edge.is_seam())
      all.push_back(edge_text(index, e) + " is divided, and no seam");
    for (const piece_index p : {edge.left, edge.right})
      if (p != no_piece) has_edge[p] = 1;
  }
  for (piece_index p = 0; p < has_edge.size(); ++p)
    if (has_edge[p] == 0) all.push_back(name_of(p) + " has no edge");
}

// Checks that each given vertex is on an edge or in a piece, and nothing twice.
void check_loose(const pieces_index& index, faults& all) {
  std::vector<char> is_on_edge(index.cut.vertices.size(), 0);
  for (const cut_edge& e : index.cut.edges) is_on_edge[e.a] = is_on_edge[e.b] = 1;
  for (vertex_index v = 0; v < index.cut.vertices.size(); ++v) {
    const bool is_loose = v < index.cut.given && index.cut.piece_of_loose[v] != no_piece;
    if (is_loose == (is_on_edge[v] != 0))
      all.push_back("vertex " + std::to_string(std::size_t{v} + 1) + " of the cut is " +
                    (is_loose ? "on an edge, and loose" : "on no edge, and in no piece"));
  }
}

void check_segments(const pieces_index& index, faults& all) {
  std::vector<boundary_edge> parts;
  std::vector<char> is_on_segment(index.cut.vertices.size(), 0);
  for (const cut_edge& e : index.cut.edges)
    if (!e.is_cut()) {
      const segment& s = index.original.segments[e.segment];
      parts.push_back({e.a, e.b, e.segment, e.marker, s.internal});
      is_on_segment[e.a] = is_on_segment[e.b] = 1;
    }
  // Leaves out vertices inside the domain at which only cuts end: they divide no segment.
  std::vector<point> vertices(index.cut.vertices.begin(),
                              index.cut.vertices.begin() + index.cut.given);
  std::vector<vertex_index> number(index.cut.vertices.size(), 0);
  for (vertex_index v = 0; v < index.cut.vertices.size(); ++v) {
    number[v] = v;
    if (v < index.cut.given || is_on_segment[v] == 0) continue;
    number[v] = static_cast<vertex_index>(vertices.size());
    vertices.push_back(index.cut.vertices[v]);
  }
  for (boundary_edge& e : parts) {
    e.a = number[e.a];
    e.b = number[e.b];
  }
  const audit_report report = audit_divided_domain(index.original, vertices, parts);
  for (const audit_finding& f : report.findings) all.push_back("the cut domain: " + f.witness);
}

// Compares the domain of a piece with the edges that the index gives to it.
void compare_domain(const pieces_index& index, piece_index piece, const domain& d, faults& all) {
  struct wanted_edge {
    std::size_t edge;
    segment as;  // the ends left out
    bool found = false;
  };
  std::map<directed, wanted_edge> wanted;
  for (std::size_t e = 0; e < index.cut.edges.size(); ++e) {
    const cut_edge& edge = index.cut.edges[e];
    const point &a = index.cut.vertices[edge.a], &b = index.cut.vertices[edge.b];
    const bool is_left = edge.left == piece, is_right = edge.right == piece;
    if (is_left)
      wanted[bits_of(a, b)] = {
          e, {0, 0, edge.marker, is_right, edge.left_region, is_right ? edge.right_region : 1}};
    else if (is_right)
      wanted[bits_of(b, a)] = {e, {0, 0, edge.marker, false, edge.right_region, 1}};
  }
  for (const segment& s : d.segments) {
    const auto place = wanted.find(bits_of(d.vertices[s.a], d.vertices[s.b]));
    if (place == wanted.end() || std::exchange(place->second.found, true)) {
      all.push_back("its domain has a segment from " + text_of(d.vertices[s.a]) + " to " +
                    text_of(d.vertices[s.b]) + ", and the index gives it none there");
      continue;
    }
    const segment& as = place->second.as;
    if (s.marker != as.marker || s.internal != as.internal || s.left_region != as.left_region ||
        (s.internal && s.right_region != as.right_region))
      all.push_back("its domain has another marker, side or region at " +
                    edge_text(index, place->second.edge));
  }
  for (const auto& [ends, one] : wanted)
    if (!one.found) all.push_back("its domain is without " + edge_text(index, one.edge));
}

bool is_same_curve(const domain_curve& c, const domain& of_c, const domain_curve& d,
                   const std::vector<point>& of_d) {
  const auto same = [](const point& p, const point& q) { return bits_of(p) == bits_of(q); };
  if (c.kind != d.kind || c.vertices.size() != d.vertices.size() || c.parameters != d.parameters)
    return false;
  for (std::size_t i = 0; i < c.vertices.size(); ++i)
    if (!same(of_c.vertices[c.vertices[i]], of_d[d.vertices[i]])) return false;
  if (c.kind == curve_kind::arc) return same(c.centre, d.centre) && c.clockwise == d.clockwise;
  return same(c.control[0], d.control[0]) && same(c.control[1], d.control[1]);
}

// Compares the curves of a piece's domain with the parts of the whole domain's curves in this
// piece.
void compare_curves(const pieces_index& index, piece_index piece, const domain& d, faults& all) {
  const std::vector<domain_curve> wanted = curves_of_piece(index.original, index.cut, piece);
  bool same = wanted.size() == d.curves.size();
  for (std::size_t i = 0; same && i < wanted.size(); ++i)
    same = is_same_curve(d.curves[i], d, wanted[i], index.cut.vertices);
  if (!same) all.emplace_back("the curves of its domain are not those of the index");
}

// Checks that the vertices given inside a piece are those that the index places there.
void compare_loose(const pieces_index& index, piece_index piece, const domain& d, faults& all) {
  std::vector<char> is_on_segment(d.vertices.size(), 0);
  for (const segment& s : d.segments) is_on_segment[s.a] = is_on_segment[s.b] = 1;
  std::vector<bits> here, wanted;
  for (vertex_index v = 0; v < d.vertices.size(); ++v)
    if (is_on_segment[v] == 0) here.push_back(bits_of(d.vertices[v]));
  for (vertex_index v = 0; v < index.cut.given; ++v)
    if (index.cut.piece_of_loose[v] == piece) wanted.push_back(bits_of(index.cut.vertices[v]));
  std::sort(here.begin(), here.end());
  std::sort(wanted.begin(), wanted.end());
  if (here != wanted) all.push_back("the vertices given inside it are not those of the index");
}

// Chains of a mesh between given vertices, by the first and last of each.
class given_chains {
 public:
  explicit given_chains(const mesh& m) : mesh_(m) {
    std::map<vertex_index, std::vector<vertex_index>> leaving;
    for (const boundary_edge& e : m.boundary) leaving[e.a].push_back(e.b);
    for (const boundary_edge& e : m.boundary)
      if (e.a < m.given) add(leaving, e.a, e.b);
    for (vertex_index v = 0; v < m.given && v < m.sites.size(); ++v)
      number_[bits_of(m.sites[v].position)] = v;
  }

  // Returns the vertices from a to b, both included; empty where there is no such chain.
  std::vector<vertex_index> between(const point& a, const point& b) const {
    const auto from = number_.find(bits_of(a)), to = number_.find(bits_of(b));
    if (from == number_.end() || to == number_.end()) return {};
    const auto chain = chains_.find({from->second, to->second});
    return chain == chains_.end() ? std::vector<vertex_index>() : chain->second;
  }

 private:
  void add(const std::map<vertex_index, std::vector<vertex_index>>& leaving, vertex_index from,
           vertex_index next) {
    std::vector<vertex_index> along{from, next};
    while (along.back() >= mesh_.given && along.size() <= mesh_.boundary.size() + 1) {
      const auto step = leaving.find(along.back());
      if (step == leaving.end() || step->second.size() != 1) return;
      along.push_back(step->second.front());
    }
    chains_[{along.front(), along.back()}] = std::move(along);
  }

  const mesh& mesh_;
  std::map<bits, vertex_index> number_;
  std::map<std::array<vertex_index, 2>, std::vector<vertex_index>> chains_;
};

// Returns the vertices of a seam in a piece's mesh, in the direction of the edge.
std::vector<vertex_index> along_seam(const pieces_index& index, const given_chains& chains,
                                     const cut_edge& e, piece_index piece) {
  const point &a = index.cut.vertices[e.a], &b = index.cut.vertices[e.b];
  if (e.left == piece) return chains.between(a, b);
  std::vector<vertex_index> along = chains.between(b, a);
  std::reverse(along.begin(), along.end());
  return along;
}

// Hashes positions and tensors byte by byte.
std::uint64_t digest_along(const mesh& m, const std::vector<vertex_index>& along) {
  std::string bytes;
  for (const vertex_index v : along) {
    const site& s = m.sites[v];
    for (const double x : {s.position.x, s.position.y, s.metric.m11, s.metric.m12, s.metric.m22}) {
      auto word = std::bit_cast<std::uint64_t>(x);
      for (int i = 0; i < 8; ++i, word >>= 8) bytes += static_cast<char>(word & 0xff);
    }
  }
  return digest_of(bytes);
}

void compare_seams(const pieces_index& index, piece_index piece, const mesh& m, faults& all) {
  const given_chains chains(m);
  for (std::size_t e = 0; e < index.cut.edges.size(); ++e) {
    const cut_edge& edge = index.cut.edges[e];
    if (!edge.is_seam() || (edge.left != piece && edge.right != piece)) continue;
    const std::vector<vertex_index> along = along_seam(index, chains, edge, piece);
    std::vector<bits> here, wanted;
    for (const vertex_index v : along) here.push_back(bits_of(m.sites[v].position));
    wanted.push_back(bits_of(index.cut.vertices[edge.a]));
    for (const point& q : index.points[e]) wanted.push_back(bits_of(q));
    wanted.push_back(bits_of(index.cut.vertices[edge.b]));
    if (here != wanted)
      all.push_back("its mesh does not divide the seam as the index does: " + edge_text(index, e));
    else if (digest_along(m, along) != index.digests[e])
      all.push_back("its mesh has other tensors on the seam than the index: " +
                    edge_text(index, e));
  }
}

}  // namespace

std::vector<std::string> faults_of_index(const pieces_index& index) {
  faults all;
  check_edges(index, all);
  check_loose(index, all);
  check_segments(index, all);
  for (piece_index p = 0; p < index.pieces.size(); ++p) {
    const piece_entry& entry = index.pieces[p];
    if (entry.mesh != name_of_piece(p, index.cut.pieces, ".mesh") ||
        entry.certificate != name_of_piece(p, index.cut.pieces, ".certificate.json"))
      all.push_back(name_of(p) + " is said to be in other files than those of its number");
  }
  return all;
}

std::vector<std::string> faults_of_piece(const pieces_index& index, piece_index piece,
                                         const mesh& subject, const certificate& claim) {
  faults all;
  const piece_entry& entry = index.pieces[piece];
  if (mesh_fingerprint(subject) != entry.fingerprint)
    all.push_back("its mesh is not the one of the index: the fingerprints differ");
  if (subject.sites.size() != entry.sites || subject.triangles.size() != entry.triangles)
    all.push_back("its mesh has other numbers of vertices and triangles than the index says");
  const std::string number =
      std::to_string(std::size_t{piece} + 1) + " of " + std::to_string(index.cut.pieces);
  const auto said = claim.options.find("piece");
  if (said == claim.options.end() || said->second != number)
    all.push_back("its certificate is of " +
                  (said == claim.options.end() ? "no piece" : "piece " + said->second));
  if (claim.metric != index.metric || claim.angle_bound != index.angle_bound)
    all.push_back("its certificate answers another question: the metric or the bound differ");
  for (const auto& [name, value] : index.options) {
    const auto option = claim.options.find(name);
    if (option == claim.options.end() || option->second != value)
      all.push_back("its certificate answers another question: \"" + name + "\" differs");
  }
  if (!claim.original) {
    all.emplace_back("its certificate has no domain");
    return all;
  }
  compare_domain(index, piece, *claim.original, all);
  compare_loose(index, piece, *claim.original, all);
  compare_curves(index, piece, *claim.original, all);
  compare_seams(index, piece, subject, all);
  return all;
}

seam_digests digests_of(const pieces_index& index, piece_index piece, const mesh& subject) {
  const given_chains chains(subject);
  seam_digests digests(index.cut.edges.size(), 0);
  for (std::size_t e = 0; e < digests.size(); ++e) {
    const cut_edge& edge = index.cut.edges[e];
    if (!edge.is_seam() || (edge.left != piece && edge.right != piece)) continue;
    const std::vector<vertex_index> along = along_seam(index, chains, edge, piece);
    if (!along.empty()) digests[e] = digest_along(subject, along);
  }
  return digests;
}

}  // namespace asterism::internal
