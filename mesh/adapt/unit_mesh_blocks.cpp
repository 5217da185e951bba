// SPDX-License-Identifier: MIT
//
// Changes a large unit mesh in blocks, by several threads.
#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "asterism/mesh/adapt/mesh_blocks.hpp"
#include "asterism/mesh/adapt/unit_mesh.hpp"
#include "asterism/mesh/support/free_memory.hpp"
#include "asterism/mesh/support/parallel.hpp"
#include "asterism/mesh/support/resize_to_overwrite.hpp"
#include "asterism/mesh/support/sort_unique.hpp"

namespace asterism::internal::adapting {

struct unit_mesh_remesher::block_state {
  std::size_t done = 0;
  std::vector<char> is_inside;
  // Holds what the next cut needs of the states of nodes and faces, and not all of it: the states
  // of all blocks are kept until the blocks are joined.
  std::vector<char> is_restless;
  std::vector<double> shapes;
  std::vector<char> is_due;
};

// Makes this the mesher of one block of a larger mesh.
void unit_mesh_remesher::begin_block(const unit_mesh_remesher& whole,
                                     const mesh_blocks::block& part) {
  field_ = whole.field_;
  unit_ = whole.unit_;
  crowding_ = whole.crowding_;
  node_states_.resize(part.nodes.size());
  for (std::size_t v = 0; v < part.nodes.size(); ++v)
    if (part.nodes[v] < whole.node_states_.size())
      node_states_[v].is_restless = whole.node_states_[part.nodes[v]].is_restless;
  face_states_.resize(part.faces.size());
  for (vertex_index t = 0; t < part.faces.size(); ++t) {
    if (part.faces[t] >= whole.face_states_.size()) continue;
    const face_state& before = whole.face_states_[part.faces[t]];
    face_states_[t].shape = before.shape;
    face_states_[t].is_due = before.is_due;
    if (before.is_due) due_.push_back(t);
  }
}

unit_mesh_remesher::block_state unit_mesh_remesher::end_block(const unit_mesh_remesher& whole,
                                                              const mesh_blocks::block& part,
                                                              std::size_t done) {
  block_state left;
  left.done = done;
  const std::size_t nodes = m_.nodes().size(), faces = m_.faces().size();
  left.is_inside.assign(nodes, 1);
  for (std::size_t v = 0; v < part.nodes.size(); ++v)
    if (part.is_frame[v] != 0)
      left.is_inside[v] =
          part.nodes[v] < whole.is_inside_.size() ? whole.is_inside_[part.nodes[v]] : 0;
  make_states();
  left.is_restless.reserve(nodes);
  for (const node_state& state : node_states_)
    left.is_restless.push_back(state.is_restless ? 1 : 0);
  left.shapes.reserve(faces);
  left.is_due.reserve(faces);
  for (const face_state& state : face_states_) {
    left.shapes.push_back(state.shape);
    left.is_due.push_back(state.is_due ? 1 : 0);
  }
  return left;
}

// Joins the blocks. Queues again the changes that they have left undone, and flips of the edges of
// the frame. Returns the sum of the blocks' counts.
std::size_t unit_mesh_remesher::join(mesh_blocks& blocks, const std::vector<block_state>& states) {
  merges_in_vain_.clear();
  flips_in_vain_.clear();
  const auto make_room = [this](const mesh_blocks::size& whole) {
    node_states_.assign(whole.nodes, {});
    is_inside_.assign(whole.nodes, 0);
    // Every state is written when its block is taken, as each face is in one block.
    resize_to_overwrite(face_states_, whole.faces, 2 * options_.count);
  };
  const auto take_node = [&](std::size_t b, vertex_index v, vertex_index now) {
    node_states_[now].is_restless |= states[b].is_restless[v] != 0;
    is_inside_[now] = static_cast<char>(is_inside_[now] | states[b].is_inside[v]);
  };
  const auto take = [&](std::size_t b, const mesh_blocks::numbers& now) {
    const block_state& left = states[b];
    for (vertex_index v = 0; v < now.nodes.size(); ++v)
      if (now.nodes[v] != none && !blocks.is_at_frame(b, v)) take_node(b, v, now.nodes[v]);
    for (vertex_index t = 0; t < now.faces.size(); ++t) {
      if (now.faces[t] == none) continue;
      face_state& state = face_states_[now.faces[t]] = {};
      state.is_due = left.is_due[t] != 0 || blocks.is_beside_frame(b, t);
      state.shape = left.shapes[t];
    }
  };
  blocks.join(options_.count, {make_room, take});
  // Takes the nodes of the frame, which several blocks share, one block after the other.
  std::size_t done = 0;
  for (std::size_t b = 0; b < states.size(); ++b) {
    done += states[b].done;
    for (const vertex_index v : blocks.nodes_at_frame(b))
      take_node(b, v, blocks.frame_node_now(b, v));
  }
  constexpr std::size_t faces_at_once = 16384;  // for a thread
  due_ = collect_chunks<vertex_index>(
      face_states_.size(), faces_at_once,
      [this](std::size_t begin, std::size_t end, std::vector<vertex_index>& found) {
        for (std::size_t t = begin; t < end; ++t)
          if (face_states_[t].is_due) found.push_back(static_cast<vertex_index>(t));
      });
  return done;
}

// Applies `work` to each block of the next cut, after calling `prepare` with the cut. Returns the
// sum of the results of `work`. Begins with the blocks of which `prepare` expects most: one of
// these at the end would keep one thread alone busy.
std::size_t unit_mesh_remesher::in_blocks(const block_work& work,
                                          const block_preparation& prepare) {
  const std::size_t count = m_.count();
  mesh_blocks blocks(m_, cuts_++);
  free_memory(due_);  // flags say the same; joining lists them anew
  std::vector<std::size_t> order(blocks.count());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (prepare) {
    const std::vector<std::size_t> expected = prepare(blocks);
    std::stable_sort(order.begin(), order.end(), [&expected](std::size_t a, std::size_t b) {
      return expected[a] > expected[b];
    });
  }
  const std::size_t room = options_.most_nodes > count ? options_.most_nodes - count : 0;
  std::vector<block_state> states(blocks.count());
  parallel_for(blocks.count(), [&](std::size_t i) {
    const std::size_t b = order[i];
    mesh_blocks::block taken = blocks.take_out(b);
    unit_mesh_options options = options_;
    options.most_nodes = taken.part.count() + room / blocks.count();
    unit_mesh_remesher mesher(taken.part, options);
    mesher.begin_block(*this, taken);
    const std::size_t done = work(mesher, b);
    states[b] = mesher.end_block(*this, taken, done);
    blocks.put_back(b, std::move(taken));
  });
  return join(blocks, states);
}

// Splits the edges longer than this until none is left, or none can be split; returns whether any
// was. Blocks split each edge once and leave further splits to the next cut: beside a frame that is
// not yet split, repeated splits would make twice the number of nodes that are wanted. Where one
// cut has split few edges, the rest is split without blocks, in less time than another cut takes.
bool unit_mesh_remesher::split_all_long(double longest) {
  constexpr int most_splits = 40;
  constexpr std::size_t few = 16;  // one node in this number
  bool is_little = false, is_any = false;
  const auto split = [longest](unit_mesh_remesher& part, std::size_t) {
    return part.split_long(longest);
  };
  // Looks again only at edges of faces that changed since the last time: the others were tested in
  // vain.
  std::optional<face_numbers> last;
  for (int i = 0; i < most_splits && !is_stopped(); ++i) {
    if (!is_little && mesh_blocks::are_worth_it(m_)) {
      const std::size_t done = in_blocks(split);
      last.reset();  // faces have other numbers now
      is_any = is_any || done > 0;
      is_little = few * done < m_.count();
      continue;
    }
    changed_.emplace();
    const std::size_t done = split_long(longest, no_limit, last ? &*last : nullptr);
    last = std::exchange(changed_, std::nullopt);
    sort_unique(*last);
    if (done == 0) break;
    is_any = true;
  }
  is_inside_.clear();
  return is_any;
}

// Merges edges shorter than this, flips and moves: in the blocks of two cuts where the mesh is
// large, then at the nodes that are on the frames of both. One cut where nothing is to be merged:
// there most nodes have been moved before, and those on its frames are few.
void unit_mesh_remesher::merge_and_move(double shortest, int sweeps) {
  const int cuts = shortest > 0 ? 2 : 1;
  if (!mesh_blocks::are_worth_it(m_)) {
    merge_short(shortest);
    return move_all(sweeps);
  }
  is_inside_.clear();
  for (int cut = 0; cut < cuts && !is_stopped(); ++cut)
    in_blocks([shortest](unit_mesh_remesher& part, std::size_t) {
      const std::size_t done = part.merge_short(shortest);
      part.move_all(1);
      return done;
    });
  merge_short(shortest);
  move_all(1);
  is_inside_.clear();
}

// Flips and moves until neither lowers the energy, or the limit on sweeps is reached.
void unit_mesh_remesher::move_all(int sweeps) {
  flip_all();
  for (int i = 0; i < sweeps; ++i) {
    smooth();
    flip_all();
  }
}

}  // namespace asterism::internal::adapting
