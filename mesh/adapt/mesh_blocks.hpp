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

#include <cstddef>
#include <cstdint>
#include <optional>
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
    std::vector<vertex_index> nodes, faces;
    std::vector<char> is_frame;       // of these nodes
    std::vector<vertex_index> frame;  // the nodes that are
    std::vector<node> frame_before;   // what these were in the whole
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
  void join(std::size_t expected);

  // Returns, after join(), the number in the whole of a block's node or face; none if it was
  // removed.
  vertex_index node_now(std::size_t b, vertex_index v) const { return node_now_[b][v]; }
  vertex_index face_now(std::size_t b, vertex_index t) const { return face_now_[b][t]; }
  // Returns a flag for each node of a block: whether it is on the frame.
  const std::vector<vertex_index>& nodes_at_frame(std::size_t b) const { return blocks_[b]->frame; }
  bool is_at_frame(std::size_t b, vertex_index v) const {
    return v < blocks_[b]->is_frame.size() && blocks_[b]->is_frame[v] != 0;
  }
  // Returns the faces beside the frame, two for each of its edges.
  std::vector<vertex_index> faces_at_frame() const;

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
  void prefetch_nodes(vertex_index t) const;
  std::size_t shared_corners(const std::vector<vertex_index>& faces) const;
  struct range {
    vertex_index nodes = 0, faces = 0;
  };
  range count_block(std::size_t b);
  std::vector<range> number_frame();
  void number_block(std::size_t b, range from);
  void write_block(std::size_t b, editable_mesh::parts& made);

  editable_mesh& whole_;
  editable_mesh::parts given_;        // the mesh that was cut, until the blocks are joined
  curve_parts parts_;                 // the faces of each block
  std::vector<std::size_t> first_;    // of each block in listed_
  std::vector<vertex_index> listed_;  // the faces, block after block
  std::vector<vertex_index> local_;   // number of each face in its block
  // Nodes that several blocks may have: ends of frame edges, and vertices of the domain.
  std::vector<char> is_shared_;
  std::vector<vertex_index> number_;  // of each other node, in its block; none before
  std::vector<frame_edge> frame_;
  std::vector<std::optional<block>> blocks_;
  std::vector<std::vector<vertex_index>> node_now_, face_now_;
  std::vector<vertex_index> frame_now_;     // numbers of the frame's nodes, by those they had
  std::vector<std::uint32_t> frame_owner_;  // the block that writes them to the whole
};

}  // namespace asterism::internal::adapting
