// SPDX-License-Identifier: MIT
//
// Cuts a triangulation into blocks along a Hilbert curve, which are changed independently, and
// joins them again.
//
// The faces of a block follow each other on the curve; all blocks have about equally many, whatever
// the number of threads. The edges between blocks, and their ends, are the frame, which changes in
// blocks leave as it is. As blocks are independent, and are numbered in the order of the curve when
// they are joined, the result does not depend on the number of threads. Cuts with different numbers
// have different frames: after two cuts only the few nodes at which both frames cross have changed
// in no block. Internal to mesh/adapt.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "asterism/mesh/adapt/curve_parts.hpp"
#include "asterism/mesh/adapt/editable_mesh.hpp"

namespace asterism::internal::adapting {

class mesh_blocks {
 public:
  // One block, with the numbers that its nodes and faces had in the whole. Nodes and faces made
  // later follow these.
  struct block {
    editable_mesh part;
    std::vector<vertex_index> nodes;
    std::span<const vertex_index> faces;  // in the memory of the object that made the block
    std::vector<char> is_frame;           // of these nodes
    std::vector<vertex_index> frame;      // the nodes that are
    // Kinds that these have in the whole; in the block they are given, so that nothing moves them.
    std::vector<node_kind> frame_kinds;

    bool is_at_frame(vertex_index v) const { return v < is_frame.size() && is_frame[v] != 0; }
  };
  struct size {
    vertex_index nodes = 0, faces = 0;
  };
  // The numbers in the whole of a block's nodes and faces; none for those that were removed.
  struct numbers {
    std::vector<vertex_index> nodes, faces;
  };
  // Functions that are called while blocks are joined; either may be empty.
  struct join_visitor {
    // Called first, with the size of the whole.
    std::function<void(const size& whole)> make_room;
    // Called for each block when it is in the whole, by several threads: what the block has is in
    // the cache of a thread then.
    std::function<void(std::size_t b, const numbers& now)> take;
  };

  // True if the mesh has enough faces for blocks to pay.
  static bool are_worth_it(const editable_mesh& m);

  // Cuts the mesh into blocks. The mesh is empty until join(), and must outlive the object.
  mesh_blocks(editable_mesh& whole, unsigned cut);

  std::size_t count() const { return parts_.count(); }
  // Returns the block that contains the point's place on the curve. Near the frame the face at the
  // point may be in another block.
  std::size_t block_near(const point& q) const { return parts_.near(q); }
  // Removes one block, to be changed, and puts it back. Several threads may do that with different
  // blocks.
  block take_out(std::size_t b);
  void put_back(std::size_t b, block changed);
  // Joins all blocks, which must have been put back, in the memory of the mesh that was cut: other
  // memory would be new at each cut, and one thread alone would wait for its pages. Removed nodes
  // and faces get no number.
  // `expected` is the number of nodes for which there is to be room; 0 where none is expected.
  void join(std::size_t expected, const join_visitor& visitor = {});

  // Returns the nodes of a block that are on the frame, and, once the blocks are joined, the number
  // of one of them in the whole.
  const std::vector<vertex_index>& nodes_at_frame(std::size_t b) const { return blocks_[b]->frame; }
  vertex_index frame_node_now(std::size_t b, vertex_index v) const {
    return number_[blocks_[b]->nodes[v]];
  }
  bool is_at_frame(std::size_t b, vertex_index v) const { return blocks_[b]->is_at_frame(v); }
  // True if an edge of the face in the block is on the frame.
  bool is_beside_frame(std::size_t b, vertex_index t) const {
    const auto& segment = blocks_[b]->part.faces()[t].segment;
    return is_of_frame(segment[0]) || is_of_frame(segment[1]) || is_of_frame(segment[2]);
  }

 private:
  // An edge between two blocks: for each block the face beside the edge, and the edge's number in
  // that face. Faces have the numbers of the cut mesh; after join() they have those of the joined
  // mesh.
  struct frame_edge {
    struct side {
      vertex_index face = none;
      std::uint32_t edge = 0, block = 0;
    };
    side left, right;
    vertex_index segment = none;
  };

  void list_blocks();
  void mark_frame();
  template <class Act>
  void each_frame_edge(const std::vector<face>& faces, const Act& act) const;
  // True if several blocks may have the node: it is on the frame, or a vertex of the domain. Around
  // any other node, successive faces share edges of one block.
  bool is_shared(vertex_index v) const {
    return v < whole_.shape().vertices.size() || owner_[v].load(std::memory_order_relaxed) != 0;
  }
  bool is_owned_by(std::size_t b, vertex_index v) const {
    return owner_[v].load(std::memory_order_relaxed) == b + 1;
  }
  void prefetch_nodes(vertex_index t) const;
  size count_in(const block& now) const;
  size number();
  numbers number_block(std::size_t b) const;
  void write_block(std::size_t b, const numbers& now_in_whole, editable_mesh::parts& made);

  editable_mesh& whole_;
  editable_mesh::parts given_;        // the mesh that was cut, until the blocks are joined
  curve_parts parts_;                 // the faces of each block
  std::vector<std::size_t> first_;    // of each block in listed_
  std::vector<vertex_index> listed_;  // the faces, block after block
  std::vector<vertex_index> local_;   // number of each face in its block
  // The first block of those at each node of the frame, which writes it to the whole, numbered from
  // 1 on; 0 for other nodes.
  std::vector<std::atomic<std::uint32_t>> owner_;
  // The number of each node that no other block has, in its block, and once the blocks are joined
  // that of each node of the frame, in the whole; none before.
  std::vector<vertex_index> number_;
  std::vector<frame_edge> frame_;
  std::vector<std::optional<block>> blocks_;
  std::vector<size> has_;   // what each block adds to the whole
  std::vector<size> from_;  // first numbers of that in the whole
};

}  // namespace asterism::internal::adapting
