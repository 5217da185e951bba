// SPDX-License-Identifier: MIT
#include "asterism/mesh/pieces/domain_cut.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>

#include "asterism/mesh/pieces/coarse_mesh.hpp"
#include "asterism/mesh/pieces/piece_labels.hpp"

namespace asterism::internal {
namespace {

class cutting {
 public:
  cutting(const domain& d, const mesh& coarse, const std::vector<piece_index>& piece_of,
          std::size_t pieces)
      : domain_(d), mesh_(coarse), piece_of_(piece_of) {
    cut_.pieces = pieces;
    cut_.given = static_cast<vertex_index>(d.vertices.size());
    cut_.vertices = d.vertices;
    for (const segment& s : d.segments) cut_.marker = std::max(cut_.marker, s.marker);
    ++cut_.marker;
    for (std::size_t t = 0; t < coarse.triangles.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i)
        left_of_[{coarse.triangles[t][i], coarse.triangles[t][(i + 1) % 3]}] = t;
  }

  domain_cut run() && {
    note_segments();
    std::vector<cut_edge> cuts = find_cuts();
    number_ends(cuts);
    for (vertex_index s = 0; s < domain_.segments.size(); ++s) add_parts(s);
    for (cut_edge& c : cuts) {
      c.a = number_[c.a];
      c.b = number_[c.b];
      cut_.edges.push_back(c);
    }
    place_loose();
    return std::move(cut_);
  }

 private:
  using ends = std::array<vertex_index, 2>;

  piece_index piece_left_of(vertex_index a, vertex_index b) const {
    const auto t = left_of_.find({a, b});
    return t == left_of_.end() ? no_piece : piece_of_[t->second];
  }
  int region_left_of(vertex_index a, vertex_index b) const {
    const auto t = left_of_.find({a, b});
    return t == left_of_.end() || mesh_.regions.empty() ? 1 : mesh_.regions[t->second];
  }

  // Records which edges are parts of segments, and the order of these along each segment.
  void note_segments() {
    next_.resize(domain_.segments.size());
    for (const boundary_edge& e : mesh_.boundary) {
      next_[e.segment][e.a] = e.b;
      is_segment_[{std::min(e.a, e.b), std::max(e.a, e.b)}] = true;
    }
  }

  // Returns the edges between triangles of different pieces, along no segment, in the order of the
  // triangles; the piece with the lower number is on the left.
  std::vector<cut_edge> find_cuts() const {
    std::vector<cut_edge> cuts;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        const vertex_index a = mesh_.triangles[t][i], b = mesh_.triangles[t][(i + 1) % 3];
        const piece_index left = piece_of_[t], right = piece_left_of(b, a);
        if (right == no_piece || !(left < right)) continue;
        if (is_segment_.count({std::min(a, b), std::max(a, b)}) != 0) continue;
        const int region = region_left_of(a, b);
        cuts.push_back({a, b, cut_.marker, no_segment, region, region, left, right});
      }
    return cuts;
  }

  // Numbers the vertices of the coarse mesh at which cuts end, after the given vertices.
  void number_ends(const std::vector<cut_edge>& cuts) {
    for (vertex_index v = 0; v < cut_.given; ++v) number_[v] = v;
    std::vector<vertex_index> at;
    for (const cut_edge& c : cuts)
      for (const vertex_index v : {c.a, c.b})
        if (v >= cut_.given) at.push_back(v);
    std::sort(at.begin(), at.end());
    at.erase(std::unique(at.begin(), at.end()), at.end());
    for (const vertex_index v : at) {
      number_[v] = static_cast<vertex_index>(cut_.vertices.size());
      cut_.vertices.push_back(mesh_.sites[v].position);
    }
  }

  // Adds the parts of a segment between its ends and the ends of cuts on it. No cut begins between
  // two of these, so that each part has the same pieces beside it throughout.
  void add_parts(vertex_index s) {
    const segment& whole = domain_.segments[s];
    for (vertex_index from = whole.a, at = from; at != whole.b;) {
      const vertex_index first = at;
      const vertex_index second = next_[s].at(first);
      at = second;
      while (at != whole.b && number_.count(at) == 0) at = next_[s].at(at);
      cut_edge part{number_[from],
                    number_[at],
                    whole.marker,
                    s,
                    whole.left_region,
                    whole.right_region,
                    piece_left_of(first, second),
                    no_piece};
      if (whole.internal) part.right = piece_left_of(second, first);
      cut_.edges.push_back(part);
      from = at;
    }
  }

  // Finds the pieces of the given vertices that are on no edge.
  void place_loose() {
    cut_.piece_of_loose.assign(cut_.given, no_piece);
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      for (const vertex_index v : mesh_.triangles[t])
        if (v < cut_.given) cut_.piece_of_loose[v] = piece_of_[t];
    for (const cut_edge& e : cut_.edges)
      for (const vertex_index v : {e.a, e.b})
        if (v < cut_.given) cut_.piece_of_loose[v] = no_piece;
  }

  const domain& domain_;
  const mesh& mesh_;
  const std::vector<piece_index>& piece_of_;
  domain_cut cut_;
  std::map<ends, std::size_t> left_of_;
  std::map<ends, bool> is_segment_;
  std::vector<std::map<vertex_index, vertex_index>> next_;
  std::map<vertex_index, vertex_index> number_;
};

}  // namespace

domain_cut cut_along(const domain& d, const mesh& coarse, const std::vector<piece_index>& piece_of,
                     std::size_t pieces) {
  return cutting(d, coarse, piece_of, pieces).run();
}

result<domain_cut> cut_domain(const domain& d, const metric_field& field,
                              const cut_wishes& wishes) {
  domain straight = d;
  straight.curves.clear();
  const auto coarse = make_coarse_mesh(straight, field, wishes);
  if (!coarse) return coarse.failure();
  const auto labels = label_triangles(coarse.value(), field, wishes.pieces);
  if (!labels) return labels.failure();
  domain_cut cut = cut_along(d, coarse.value(), labels.value(), wishes.pieces);
  std::vector<char> is_there(wishes.pieces, 0);
  for (const piece_index p : labels.value()) is_there[p] = 1;
  for (std::size_t p = 0; p < wishes.pieces; ++p)
    if (is_there[p] == 0)
      return error{"--pieces " + std::to_string(wishes.pieces) +
                       ": the domain is too small for so many at this size",
                   error_code::bad_option};
  return cut;
}

}  // namespace asterism::internal
