// SPDX-License-Identifier: MIT
//
// Holds a triangulation that an audit found to be in order, with the lists that the audit made of
// it. Another audit of a mesh with the same boundary takes the lists, and checks the triangulation
// only where it has changed: nowhere if only tensors have. Inside the auditor alone.
#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "asterism/mesh/audit/audit_report.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/support/parallel.hpp"

namespace asterism::internal::audit_detail {

// Compares bits: zeros of either sign are equal as numbers.
inline bool same_bits(const point& a, const point& b) {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  return bits(a.x) == bits(b.x) && bits(a.y) == bits(b.y);
}

// The edge a -> b of `triangle`, the triangle on its left, whose third corner is the apex.
struct directed_edge {
  vertex_index a = 0, b = 0;
  vertex_index apex = 0;
  vertex_index triangle = 0;
};

// The boundary edge `subsegment` seen with the domain on the left of a -> b. An internal one is
// listed in both directions.
struct directed_subsegment {
  vertex_index a = 0, b = 0;
  vertex_index subsegment = 0;
};

// The triangles around a vertex, counter-clockwise, as far as the next boundary edge: triangle i
// has the vertex, link[i] and link[i + 1]; a closed fan comes back to link[0], an open one has one
// more neighbour than triangles. At the free end of an internal edge the open fan starts and ends
// with the same neighbour.
struct vertex_fan {
  bool closed = false;
  std::span<const vertex_index> link;  // in the list the fan is from
};

// Keeps the fans of many vertices in few blocks. A block is written by one thread.
class fan_lists {
 public:
  static constexpr std::size_t vertices_of_a_block = 1024;

  struct block {
    struct fan {
      bool closed = false;
      std::uint32_t end = 0;  // of its part of `links`
    };
    std::vector<vertex_index> links;
    std::vector<fan> fans;
    std::vector<std::uint32_t> ends;  // in `fans`, by vertex
  };

  // Makes one block for every `vertices_of_a_block` vertices, in order.
  void resize(std::size_t vertices) { blocks_.resize(chunk_count(vertices, vertices_of_a_block)); }
  block& block_of(vertex_index v) { return blocks_[v / vertices_of_a_block]; }
  // Calls take(fan) for each fan of v.
  template <class Take>
  void visit(vertex_index v, const Take& take) const {
    const block& from = blocks_[v / vertices_of_a_block];
    const std::size_t nth = v % vertices_of_a_block;
    const std::uint32_t first = nth == 0 ? 0 : from.ends[nth - 1];
    std::uint32_t begin = first == 0 ? 0 : from.fans[first - 1].end;
    for (std::uint32_t i = first; i < from.ends[nth]; ++i) {
      const auto& [closed, end] = from.fans[i];
      take(vertex_fan{closed, std::span(from.links).subspan(begin, end - begin)});
      begin = end;
    }
  }

 private:
  std::vector<block> blocks_;
};

// Lists made of positions, triangles and boundary alone.
struct triangulation_lists {
  // One flag a site, set by check_values: finite position. vector<char> is written from several
  // threads.
  std::vector<char> placed;
  std::vector<vertex_index> triangles;    // in range, three distinct placed corners
  std::vector<vertex_index> subsegments;  // of the boundary: in range, two distinct placed ends
  // Sorted lists of edges, made by check_edges.
  std::vector<directed_edge> edges;        // of `triangles`, sorted by (a, b, triangle)
  std::vector<directed_subsegment> sides;  // of `subsegments`, sorted by (a, b, subsegment)
  // Edges that leave v are edges[edge_start[v] .. edge_start[v + 1]), and the same for sides.
  std::vector<std::size_t> edge_start, side_start;
  // Segment of the domain that each boundary edge is a subsegment of, entered by
  // check_domain_kept.
  std::vector<std::optional<vertex_index>> segment_of;
  // Fans of all vertices, made by check_fans if the edges match.
  fan_lists fans;
};

// The part in which a mesh differs from one that was checked. Its sites and triangles are in the
// places of others.
struct triangulation_changes {
  std::vector<vertex_index> moved;      // inside sites with another position, ascending
  std::vector<vertex_index> triangles;  // with other corners or a moved one, ascending
  std::vector<vertex_index> corners;    // that these have or had, ascending
};

class checked_triangulation {
 public:
  // Copies what the checks were made of. Requires that points 0 to 2, the domain (null where none
  // was given) and the regions were checked, without a finding; `report` is theirs.
  checked_triangulation(const mesh& subject, const domain* original, triangulation_lists lists,
                        const audit_report& report);

  // True if the mesh differs from the checked one in tensors alone, bit for bit.
  bool has_lists_of(const mesh& subject) const;
  // Returns the changes, none or few, where the mesh differs from the checked one in these and in
  // tensors alone, and the domain is the same object; else nothing. Requires that the lists are not
  // lent.
  std::optional<triangulation_changes> changes_to(const mesh& subject,
                                                  const domain* original) const;
  // Makes the mesh with these changes the checked one; requires that it passed its checks.
  void take_changes(const mesh& subject, const triangulation_changes& changes);

  const triangulation_lists& lists() const { return lists_; }
  // Lends the lists, and takes them back: until then this object has none.
  triangulation_lists lend_lists() { return std::exchange(lists_, {}); }
  void take_back(triangulation_lists lists) { lists_ = std::move(lists); }
  // Enters the measurements of the domain that the checks entered into their report.
  void enter_measurements(audit_report& report) const;

 private:
  bool has_boundary_of(const mesh& subject) const;
  bool is_inside(vertex_index v) const;
  std::optional<std::vector<vertex_index>> moved_in(const mesh& subject) const;

  std::vector<point> places_;
  vertex_index given_;
  std::vector<triangle> triangles_;
  std::vector<int> regions_;
  std::vector<boundary_edge> boundary_;
  const domain* original_;
  triangulation_lists lists_;
  bool domain_checked_;
  double largest_deviation_, largest_deviation_ulps_;
  curve_report curves_;
};

}  // namespace asterism::internal::audit_detail
