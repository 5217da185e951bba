// SPDX-License-Identifier: MIT
//
// Cuts a triangulation into blocks along a Hilbert curve, which are changed apart from each other,
// and puts them together again.
//
// The faces of a block follow each other on the curve; about as many are in each, whatever threads
// there are. The edges between blocks, and their ends, are the frame: in a block they cannot
// change. As no block sees another one, and all are numbered in the order of the curve when they
// are put together, what comes out does not depend on the threads. Cuts with other numbers have
// their frames elsewhere: what two cuts leave out is the few nodes where the frames of both cross.
// Internal to mesh/adapt.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "asterism/mesh/adapt/working_mesh.hpp"

namespace asterism::internal::adapting {

class mesh_blocks {
 public:
  // One block, with the numbers that its nodes and faces had in the whole. New ones come after
  // these.
  struct block {
    working_mesh part;
    std::vector<vertex_index> nodes, faces;
    std::vector<char> is_frame;       // of these nodes
    std::vector<vertex_index> frame;  // the nodes that are
  };

  // True if the mesh has so many faces that blocks are worth their frames.
  static bool are_worth_it(const working_mesh& m);

  // Cuts the mesh, which is empty until join(). It must outlive the object.
  mesh_blocks(working_mesh& whole, unsigned cut);

  std::size_t count() const { return first_.size() - 1; }
  // Returns the block that a point's place on the curve is in. Near the frame the face at the point
  // may be in another one.
  std::size_t block_near(const point& q) const;
  // Takes a block out, once, to be changed, and puts it back. Several threads may do so with
  // different blocks.
  block take_out(std::size_t b);
  void put_back(std::size_t b, block changed) { blocks_[b].emplace(std::move(changed)); }
  // Puts the whole together when all blocks are back. Nodes and faces that are gone get no number.
  void join();

  // After join(): returns the number in the whole of a block's node or face; none if it is gone.
  vertex_index node_now(std::size_t b, vertex_index v) const { return node_now_[b][v]; }
  vertex_index face_now(std::size_t b, vertex_index t) const { return face_now_[b][t]; }
  // Returns which nodes of a block, by their numbers in it, are on the frame.
  const std::vector<vertex_index>& nodes_at_frame(std::size_t b) const { return blocks_[b]->frame; }
  bool is_at_frame(std::size_t b, vertex_index v) const {
    return v < blocks_[b]->is_frame.size() && blocks_[b]->is_frame[v] != 0;
  }
  // Returns the faces beside the frame, two for each of its edges.
  std::vector<vertex_index> faces_at_frame() const;

 private:
  // Edge between two blocks. For each: the face beside the edge and the edge's number in it, in the
  // whole as it was until join(), then as it is.
  struct frame_edge {
    struct side {
      vertex_index face = none;
      std::uint32_t edge = 0, block = 0;
    };
    side left, right;
    vertex_index segment = none;
  };

  void assign_blocks();
  std::size_t block_at(std::uint64_t place) const;
  void list_blocks();
  void mark_frame();
  struct range {
    vertex_index nodes = 0, faces = 0;
  };
  range count_block(std::size_t b);
  std::vector<range> number_frame();
  void number_block(std::size_t b, range from);
  void write_block(std::size_t b, working_mesh::parts& made);

  working_mesh& whole_;
  working_mesh::parts given_;
  bounding_box box_;                     // that the curve goes through
  std::vector<std::uint64_t> bounds_;    // places on it between blocks
  std::vector<std::uint32_t> block_of_;  // of each face
  std::vector<std::size_t> first_;       // of each block in listed_
  std::vector<vertex_index> listed_;     // the faces, block after block
  std::vector<vertex_index> local_;      // number of each face in its block
  std::vector<frame_edge> frame_;
  std::vector<std::optional<block>> blocks_;
  std::vector<std::vector<vertex_index>> node_now_, face_now_;
  std::vector<vertex_index> frame_now_;     // numbers of the frame's nodes, by those they had
  std::vector<std::uint32_t> frame_owner_;  // the block that writes them to the whole
};

}  // namespace asterism::internal::adapting
