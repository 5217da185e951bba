// SPDX-License-Identifier: MIT
#include "asterism/mesh/pieces/partitioned_gmsh.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "asterism/mesh/data/region_of.hpp"
#include "asterism/mesh/io/gmsh_numbering.hpp"
#include "asterism/mesh/io/text_lines.hpp"

namespace asterism::internal {
namespace {

using place = std::pair<double, double>;
// A part of a curve: its marker, and the pieces on its sides, the lesser one first; none for a
// missing one.
using part_of_curve = std::tuple<int, piece_index, piece_index>;
using part_of_surface = std::pair<int, piece_index>;  // a region, and the piece

place place_of(const point& q) { return {q.x, q.y}; }

piece_index writer_of(const cut_edge& e) { return std::min(e.left, e.right); }

part_of_curve part_of(const cut_edge& e) {
  return {e.marker, writer_of(e), e.is_seam() ? std::max(e.left, e.right) : no_piece};
}

template <class... Integers>
std::string line_of(Integers... numbers) {
  std::string text;
  ((append_integer(text, numbers), text += ' '), ...);
  text.back() = '\n';
  return text;
}

// Returns the vertices that several pieces have, for their tags; 0 before a tag is given. They
// include the ends of seams, which all pieces around these have.
std::map<place, std::size_t> shared_vertices(const pieces_index& index) {
  std::map<place, std::size_t> shared;
  for (std::size_t e = 0; e < index.cut.edges.size(); ++e) {
    const cut_edge& edge = index.cut.edges[e];
    if (!edge.is_seam()) continue;
    for (const vertex_index end : {edge.a, edge.b})
      shared.emplace(place_of(index.cut.vertices[end]), 0);
    for (const point& q : index.points[e]) shared.emplace(place_of(q), 0);
  }
  return shared;
}

// Counts the vertices and elements that a piece writes, by entity.
struct piece_counts {
  std::size_t first_vertex = 1, vertices = 0;  // tags that it gives
  std::map<part_of_curve, std::size_t> lines;
  std::map<part_of_surface, std::size_t> triangles;
};

class partitioned_writer {
 public:
  partitioned_writer(const pieces_index& index, const physical_names& names,
                     const piece_reader& read, const byte_sink& put)
      : index_(index), read_(read), put_(put), shared_(shared_vertices(index)) {
    std::set<int> markers, regions;
    for (const cut_edge& e : index.cut.edges) {
      markers.insert(e.marker);
      curve_parts_.emplace(part_of(e), 0);
      for (const auto& [piece, region] :
           {std::pair{e.left, e.left_region}, std::pair{e.right, e.right_region}}) {
        if (piece == no_piece) continue;
        regions.insert(region);
        surface_parts_.emplace(part_of_surface{region, piece}, 0);
      }
    }
    curves_ = number_groups(markers, names.markers, "marker");
    surfaces_ = number_groups(regions, names.regions, "region");
    number_parts(curve_parts_, curves_.size());
    number_parts(surface_parts_, surfaces_.size());
  }

  std::optional<error> run() {
    put_("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n");
    put_(names_of_groups(curves_, surfaces_));
    write_entities();
    write_parts();
    put_("$Nodes\n");
    put_(line_of(index_.pieces.size(), index_.sites, 1, index_.sites));
    if (auto failed = for_each_piece([&](piece_index p, const mesh& m) { write_nodes(p, m); }))
      return failed;
    put_("$EndNodes\n$Elements\n");
    std::size_t blocks = 0, elements = 0;
    for (const piece_counts& c : counts_) {
      blocks += c.lines.size() + c.triangles.size();
      for (const auto& [part, n] : c.lines) elements += n;
      for (const auto& [part, n] : c.triangles) elements += n;
    }
    put_(line_of(blocks, elements, 1, elements));
    if (auto failed = for_each_piece([&](piece_index p, const mesh& m) { write_elements(p, m); }))
      return failed;
    put_("$EndElements\n");
    return std::nullopt;
  }

 private:
  // Numbers the entities of partitions of one dimension after its unpartitioned entities, so that
  // all tags differ.
  template <class Part>
  static void number_parts(std::map<Part, std::size_t>& parts, std::size_t before) {
    for (auto& [part, tag] : parts) tag = ++before;
  }

  template <class Take>
  std::optional<error> for_each_piece(const Take& take) {
    for (piece_index p = 0; p < index_.pieces.size(); ++p) {
      const auto m = read_(p);
      if (!m) return m.failure();
      if (m.value().sites.size() != index_.pieces[p].sites)
        return error{index_.pieces[p].mesh + " is not the index's", error_code::invalid_mesh};
      take(p, m.value());
    }
    return std::nullopt;
  }

  // Returns the box of the domain's vertices, for each entity: readers of meshes ignore it.
  std::string box() const {
    const bounding_box all = index_.original.box();
    std::string text;
    for (const double x : {all.low.x, all.low.y, 0.0, all.high.x, all.high.y, 0.0}) {
      append_number(text, x);
      text += ' ';
    }
    return text;
  }

  void write_entities() {
    put_("$Entities\n");
    put_(line_of(0, curves_.size(), surfaces_.size(), 0));
    const std::string whole = box();
    for (const auto* all : {&curves_, &surfaces_})
      for (const auto& [number, g] : *all)
        put_(std::to_string(g.entity) + ' ' + whole + line_of(1, g.tag, 0));
    put_("$EndEntities\n");
  }

  void write_parts() {
    put_("$PartitionedEntities\n");
    put_(line_of(index_.pieces.size()) + line_of(0));
    put_(line_of(0, curve_parts_.size(), surface_parts_.size(), 0));
    const std::string whole = box();
    for (const auto& [part, tag] : curve_parts_) {
      const auto& [marker, piece, other] = part;
      const gmsh_group& g = curves_.at(marker);
      std::string head = line_of(tag, 1, g.entity, other == no_piece ? 1 : 2, piece + 1);
      head.back() = ' ';
      if (other != no_piece) head += std::to_string(other + 1) + ' ';
      put_(head + whole + line_of(1, g.tag, 0));
    }
    for (const auto& [part, tag] : surface_parts_) {
      const gmsh_group& g = surfaces_.at(part.first);
      std::string head = line_of(tag, 2, g.entity, 1, part.second + 1);
      head.back() = ' ';
      put_(head + whole + line_of(1, g.tag, 0));
    }
    put_("$EndPartitionedEntities\n");
  }

  // Returns the edges of the cut for the piece's segments, in their order.
  std::vector<std::size_t> edges_of(piece_index p) const {
    std::vector<std::size_t> edges;
    for (std::size_t e = 0; e < index_.cut.edges.size(); ++e)
      if (index_.cut.edges[e].left == p || index_.cut.edges[e].right == p) edges.push_back(e);
    return edges;
  }

  // Calls take(edge, part) for the boundary edges that are the piece's to write.
  template <class Take>
  void for_each_line(piece_index p, const mesh& m, const Take& take) const {
    const std::vector<std::size_t> edges = edges_of(p);
    for (const boundary_edge& e : m.boundary) {
      const cut_edge& of = index_.cut.edges[edges.at(e.segment)];
      if (!of.is_seam() || writer_of(of) == p) take(e, part_of(of));
    }
  }

  static part_of_surface surface_of(piece_index p, const mesh& m, std::size_t t) {
    return {region_of(m, t), p};
  }

  // Counts the piece's elements as well, which come after all nodes.
  void write_nodes(piece_index p, const mesh& m) {
    piece_counts& own = counts_.emplace_back();
    own.first_vertex = next_vertex_;
    std::string places;
    for (const site& s : m.sites) {
      const auto at = shared_.find(place_of(s.position));
      if (at != shared_.end()) {
        if (at->second != 0) continue;
        at->second = next_vertex_;
      }
      ++next_vertex_;
      append_number(places, s.position.x);
      append_number(places += ' ', s.position.y);
      places += " 0\n";
    }
    own.vertices = next_vertex_ - own.first_vertex;
    for_each_line(p, m, [&](const boundary_edge&, const part_of_curve& c) { ++own.lines[c]; });
    for (std::size_t t = 0; t < m.triangles.size(); ++t) ++own.triangles[surface_of(p, m, t)];
    put_(line_of(2, surface_parts_.at(own.triangles.begin()->first), 0, own.vertices));
    std::string tags;
    for (std::size_t v = own.first_vertex; v < next_vertex_; ++v) tags += line_of(v);
    put_(tags);
    put_(places);
  }

  std::vector<std::size_t> tags_of_vertices(piece_index p, const mesh& m) const {
    std::vector<std::size_t> tags;
    std::size_t next = counts_[p].first_vertex;
    for (const site& s : m.sites) {
      const auto at = shared_.find(place_of(s.position));
      tags.push_back(at == shared_.end() || at->second == next ? next++ : at->second);
    }
    return tags;
  }

  void write_elements(piece_index p, const mesh& m) {
    const std::vector<std::size_t> tags = tags_of_vertices(p, m);
    std::map<part_of_curve, std::string> lines;
    for (const auto& [part, n] : counts_[p].lines)
      lines[part] = line_of(1, curve_parts_.at(part), 1, n);
    std::map<part_of_surface, std::string> triangles;
    for (const auto& [part, n] : counts_[p].triangles)
      triangles[part] = line_of(2, surface_parts_.at(part), 2, n);
    for_each_line(p, m, [&](const boundary_edge& e, const part_of_curve& c) {
      lines[c] += line_of(next_element_++, tags[e.a], tags[e.b]);
    });
    for (std::size_t t = 0; t < m.triangles.size(); ++t) {
      const triangle& c = m.triangles[t];
      triangles[surface_of(p, m, t)] +=
          line_of(next_element_++, tags[c[0]], tags[c[1]], tags[c[2]]);
    }
    for (const auto& [part, text] : lines) put_(text);
    for (const auto& [part, text] : triangles) put_(text);
  }

  const pieces_index& index_;
  const piece_reader& read_;
  const byte_sink& put_;
  std::map<place, std::size_t> shared_;
  gmsh_groups_by_number curves_, surfaces_;
  std::map<part_of_curve, std::size_t> curve_parts_;
  std::map<part_of_surface, std::size_t> surface_parts_;
  std::vector<piece_counts> counts_;
  std::size_t next_vertex_ = 1, next_element_ = 1;
};

}  // namespace

std::optional<error> write_partitioned_gmsh(const pieces_index& index, const physical_names& names,
                                            const piece_reader& read, const byte_sink& put) {
  return partitioned_writer(index, names, read, put).run();
}

}  // namespace asterism::internal
