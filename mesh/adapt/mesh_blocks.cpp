// SPDX-License-Identifier: MIT
#include "asterism/mesh/adapt/mesh_blocks.hpp"

#include <algorithm>
#include <utility>

#include "asterism/mesh/support/parallel.hpp"
#include "asterism/mesh/support/prefetch.hpp"
#include "asterism/mesh/support/resize_to_overwrite.hpp"
#include "asterism/mesh/support/sort_by_counting.hpp"

namespace asterism::internal::adapting {
namespace {

// Number of faces in a block. With half of this number a tenth of all nodes is on the frame; with
// twice this number a mesh of 10,000 faces has too few blocks for two threads.
constexpr std::size_t faces_in_block = 2048;
// Numbers of items that a thread takes at once.
constexpr std::size_t faces_at_once = 4096, frame_edges_at_once = 1024;

// Returns the box through which the curve of a cut runs: the domain's box, enlarged to the left and
// below by parts of its extent that differ from cut to cut. So the lines across which the curve
// jumps are at other places in each cut.
bounding_box box_of_cut(const bounding_box& box, unsigned cut) {
  // Steps of Roberts' sequence: their multiples, modulo one, are evenly spread in the square.
  constexpr double across = 0.7548776662466927, up = 0.5698402909980532;
  constexpr unsigned period = 64;
  const auto part = [n = static_cast<double>(cut % period)](double step) {
    const double x = n * step;
    return (x - static_cast<double>(static_cast<unsigned>(x))) / 2;
  };
  const point extent{box.high.x - box.low.x, box.high.y - box.low.y};
  bounding_box grown = box;
  grown.low = {box.low.x - part(across) * extent.x, box.low.y - part(up) * extent.y};
  return grown;
}

// Numbers of nodes in a block, by their numbers in the whole: a hash table with open addressing,
// which is at most half full.
class local_numbers {
 public:
  // Returns the slot of a node's number in the block; it holds `none` if the node has no number
  // there yet.
  vertex_index& at(vertex_index v) {
    std::size_t i = place_of(v);
    if (slots_[i].first == none) {
      if (2 * ++used_ > slots_.size()) {
        grow();
        i = place_of(v);
      }
      slots_[i].first = v;
    }
    return slots_[i].second;
  }

 private:
  // Returns the place of a node, or the free one that it would have.
  std::size_t place_of(vertex_index v) const {
    constexpr std::uint64_t spread = 0x9e3779b97f4a7c15U;
    std::size_t i = static_cast<std::size_t>((v * spread) >> 20U) & (slots_.size() - 1);
    while (slots_[i].first != v && slots_[i].first != none) i = (i + 1) & (slots_.size() - 1);
    return i;
  }
  void grow() {
    auto before = std::exchange(slots_, slots(2 * slots_.size(), {none, none}));
    for (const auto& slot : before)
      if (slot.first != none) slots_[place_of(slot.first)] = slot;
  }

  using slots = std::vector<std::pair<vertex_index, vertex_index>>;
  // Number of slots at first: a block's frame has some 250 nodes.
  static constexpr std::size_t slots_at_first = 1024;
  slots slots_ = slots(slots_at_first, {none, none});
  std::size_t used_ = 0;
};

// Makes a block the owner of a node that has none, or one that follows it. Owners are the numbers
// of blocks from 1 on; 0 is none.
void take_node(std::atomic<std::uint32_t>& owner, std::uint32_t block) {
  std::uint32_t before = owner.load(std::memory_order_relaxed);
  while ((before == 0 || block + 1 < before) &&
         !owner.compare_exchange_weak(before, block + 1, std::memory_order_relaxed)) {
  }
}

}  // namespace

bool mesh_blocks::are_worth_it(const editable_mesh& m) {
  constexpr std::size_t least = 4;  // blocks
  return m.faces().size() >= least * faces_in_block;
}

mesh_blocks::mesh_blocks(editable_mesh& whole, unsigned cut)
    : whole_(whole),
      given_(whole.release()),
      parts_(given_.nodes, given_.faces, box_of_cut(whole.shape().box(), cut),
             given_.faces.size() / faces_in_block) {
  list_blocks();
  mark_frame();
  parts_.forget_faces();
  blocks_.resize(count());
  has_.resize(count());
}

void mesh_blocks::list_blocks() {
  const std::size_t faces = given_.faces.size(), blocks = parts_.count();
  // Lists faces that do not exist last, and leaves them out.
  listed_.resize(faces);
  first_ = sort_by_counting(
      faces, blocks + 1, [this](std::size_t t) { return parts_.of(static_cast<vertex_index>(t)); },
      [this](std::size_t at, std::size_t t) { listed_[at] = static_cast<vertex_index>(t); });
  first_.pop_back();
  listed_.resize(first_.back());
  local_.resize(faces);
  parallel_for(blocks, [this](std::size_t b) {
    for (std::size_t i = first_[b]; i < first_[b + 1]; ++i)
      local_[listed_[i]] = static_cast<vertex_index>(i - first_[b]);
  });
}

// Replaces the segments of edges between blocks by numbers of the frame; keeps the segments.
void mesh_blocks::mark_frame() {
  std::vector<face>& faces = given_.faces;
  const auto append = [&](std::size_t begin, std::size_t end, std::vector<frame_edge>& found) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto t = static_cast<vertex_index>(i);
      if (i + triangles_ahead < end)
        for (const vertex_index s : faces[i + triangles_ahead].next)
          if (s != none) parts_.prefetch(s);
      // Compares the parts of all three neighbours at once, which are nearly always the same. A
      // face that is gone has no neighbours.
      const auto& next = faces[t].next;
      const auto is_elsewhere = [&](vertex_index s) {
        return static_cast<int>(parts_.of(s == none ? t : s) != parts_.of(t));
      };
      if ((is_elsewhere(next[0]) | is_elsewhere(next[1]) | is_elsewhere(next[2])) == 0) continue;
      for (std::uint32_t e = 0; e < 3; ++e) {
        const vertex_index s = next[e];
        if (s == none || s < t || parts_.of(s) == parts_.of(t)) continue;
        const std::size_t beyond = after(faces[s].corner_of(faces[t].v[after(e)]));
        found.push_back({{t, e, parts_.of(t)},
                         {s, static_cast<std::uint32_t>(beyond), parts_.of(s)},
                         faces[t].segment[e]});
      }
    }
  };
  frame_ = collect_chunks<frame_edge>(faces.size(), faces_at_once, append);
  owner_ = std::vector<std::atomic<std::uint32_t>>(given_.nodes.size());
  each_frame_edge(faces, [&](std::size_t i) {
    const frame_edge& edge = frame_[i];
    for (const frame_edge::side* side : {&edge.left, &edge.right})
      faces[side->face].segment[side->edge] = first_of_frame + static_cast<vertex_index>(i);
    const face& f = faces[edge.left.face];
    const std::uint32_t first = std::min(edge.left.block, edge.right.block);
    for (const vertex_index v : {f.v[after(edge.left.edge)], f.v[before(edge.left.edge)]})
      take_node(owner_[v], first);
  });
  number_.assign(given_.nodes.size(), none);
}

// Calls act(i) for each edge of the frame, in several threads. Prefetches the faces beside the
// edges, which are anywhere in memory.
template <class Act>
void mesh_blocks::each_frame_edge(const std::vector<face>& faces, const Act& act) const {
  parallel_chunks(frame_.size(), frame_edges_at_once,
                  [&](std::size_t, std::size_t begin, std::size_t end) {
                    for (std::size_t i = begin; i < end; ++i) {
                      if (i + triangles_ahead < end) {
                        const frame_edge& soon = frame_[i + triangles_ahead];
                        prefetch(&faces[soon.left.face]);
                        prefetch(&faces[soon.right.face]);
                      }
                      act(i);
                    }
                  });
}

// Prefetches the nodes of a face that will be taken out soon.
void mesh_blocks::prefetch_nodes(vertex_index t) const {
  for (const vertex_index v : given_.faces[t].v) {
    prefetch(&given_.nodes[v]);
    prefetch(&number_[v]);
    prefetch(&owner_[v]);
  }
}

mesh_blocks::block mesh_blocks::take_out(std::size_t b) {
  block made{whole_.like({}), {}, {}, {}, {}, {}};
  made.faces = std::span(listed_).subspan(first_[b], first_[b + 1] - first_[b]);
  editable_mesh::parts parts;
  parts.faces.reserve(made.faces.size());
  parts.nodes.reserve(made.faces.size());
  made.nodes.reserve(made.faces.size());
  local_numbers numbers;
  for (std::size_t i = 0; i < made.faces.size(); ++i) {
    if (i + triangles_ahead < made.faces.size()) prefetch_nodes(made.faces[i + triangles_ahead]);
    face f = given_.faces[made.faces[i]];
    for (vertex_index& v : f.v) {
      vertex_index& number = is_shared(v) ? numbers.at(v) : number_[v];
      if (number == none) {
        number = static_cast<vertex_index>(made.nodes.size());
        made.nodes.push_back(v);
        parts.nodes.push_back(given_.nodes[v]);
      }
      v = number;
      parts.nodes[v].face = static_cast<vertex_index>(parts.faces.size());
    }
    for (std::size_t e = 0; e < 3; ++e)
      if (f.next[e] != none) f.next[e] = is_of_frame(f.segment[e]) ? none : local_[f.next[e]];
    parts.faces.push_back(f);
  }
  made.is_frame.assign(made.nodes.size(), 0);
  for (const face& f : parts.faces)
    for (std::size_t e = 0; e < 3; ++e)
      if (is_of_frame(f.segment[e]))
        for (const vertex_index v : {f.v[after(e)], f.v[before(e)]}) {
          if (std::exchange(made.is_frame[v], char{1}) != 0) continue;
          made.frame.push_back(v);
          made.frame_kinds.push_back(std::exchange(parts.nodes[v].kind, node_kind::given));
        }
  made.part = whole_.like(std::move(parts));
  return made;
}

void mesh_blocks::put_back(std::size_t b, block changed) {
  has_[b] = count_in(changed);
  changed.part.shrink_to_fit();
  blocks_[b].emplace(std::move(changed));
}

// Counts the nodes and faces that a block adds to the whole, without the frame's nodes and the
// domain's vertices.
mesh_blocks::size mesh_blocks::count_in(const block& now) const {
  const auto given = static_cast<vertex_index>(whole_.shape().vertices.size());
  size has;
  for (vertex_index v = 0; v < now.part.nodes().size(); ++v)
    if (now.part.at(v).kind != node_kind::gone && !now.is_at_frame(v) &&
        !(v < now.nodes.size() && now.nodes[v] < given))
      ++has.nodes;
  for (const face& f : now.part.faces())
    if (f.exists()) ++has.faces;
  return has;
}

// Numbers the nodes of the frame, those of each block that owns them before those inside it, and
// finds where the numbers of each block's other nodes and faces begin.
mesh_blocks::size mesh_blocks::number() {
  const auto given = static_cast<vertex_index>(whole_.shape().vertices.size());
  const auto is_numbered_by = [&](std::size_t b, vertex_index v) {
    const vertex_index before = blocks_[b]->nodes[v];
    return before >= given && is_owned_by(b, before);
  };
  std::vector<std::size_t> owned(count());
  parallel_for(count(), [&](std::size_t b) {
    const std::vector<vertex_index>& frame = blocks_[b]->frame;
    owned[b] = static_cast<std::size_t>(std::count_if(
        frame.begin(), frame.end(), [&](vertex_index v) { return is_numbered_by(b, v); }));
  });
  size next{given, 0};
  for (std::size_t b = 0; b < count(); ++b) {
    next.nodes += static_cast<vertex_index>(owned[b]);
    from_.push_back(next);
    next.nodes += has_[b].nodes;
    next.faces += has_[b].faces;
  }
  parallel_for(count(), [&](std::size_t b) {
    vertex_index number = from_[b].nodes - static_cast<vertex_index>(owned[b]);
    for (const vertex_index v : blocks_[b]->frame) {
      const vertex_index before = blocks_[b]->nodes[v];
      if (is_owned_by(b, before)) number_[before] = before < given ? before : number++;
    }
  });
  return next;
}

mesh_blocks::numbers mesh_blocks::number_block(std::size_t b) const {
  const block& now = *blocks_[b];
  const auto given = static_cast<vertex_index>(whole_.shape().vertices.size());
  size next = from_[b];
  numbers made;
  made.nodes.assign(now.part.nodes().size(), none);
  for (vertex_index v = 0; v < made.nodes.size(); ++v) {
    if (now.part.at(v).kind == node_kind::gone) continue;
    const vertex_index before = v < now.nodes.size() ? now.nodes[v] : none;
    made.nodes[v] = now.is_at_frame(v) ? number_[before] : before < given ? before : next.nodes++;
  }
  made.faces.assign(now.part.faces().size(), none);
  for (vertex_index t = 0; t < made.faces.size(); ++t)
    if (now.part.faces()[t].exists()) made.faces[t] = next.faces++;
  return made;
}

void mesh_blocks::write_block(std::size_t b, const numbers& now_in_whole,
                              editable_mesh::parts& made) {
  const block& now = *blocks_[b];
  const std::vector<vertex_index>&node_now = now_in_whole.nodes, &face_now = now_in_whole.faces;
  const auto write_node = [&](vertex_index v) -> node& {
    node& written = made.nodes[node_now[v]];
    written = now.part.at(v);
    written.face = face_now[written.face];
    return written;
  };
  for (vertex_index v = 0; v < now.part.nodes().size(); ++v)
    if (node_now[v] != none && !now.is_at_frame(v)) write_node(v);
  for (std::size_t i = 0; i < now.frame.size(); ++i)
    if (is_owned_by(b, now.nodes[now.frame[i]])) write_node(now.frame[i]).kind = now.frame_kinds[i];
  for (vertex_index t = 0; t < now.part.faces().size(); ++t) {
    if (face_now[t] == none) continue;
    face f = now.part.faces()[t];
    for (std::uint32_t e = 0; e < 3; ++e) {
      f.v[e] = node_now[f.v[e]];
      if (f.next[e] != none) f.next[e] = face_now[f.next[e]];
      if (!is_of_frame(f.segment[e])) continue;
      frame_edge& edge = frame_[f.segment[e] - first_of_frame];
      frame_edge::side& side = edge.left.block == b ? edge.left : edge.right;
      side.face = face_now[t];
      side.edge = e;
    }
    made.faces[face_now[t]] = f;
  }
}

void mesh_blocks::join(std::size_t expected, const join_visitor& visitor) {
  const size all = number();
  if (visitor.make_room) visitor.make_room(all);
  // Every node and every face is written below: numbers have no gaps, and each vertex of the domain
  // is in a block.
  editable_mesh::parts made = std::move(given_);
  resize_to_overwrite(made.nodes, all.nodes, expected);
  resize_to_overwrite(made.faces, all.faces, 2 * expected);
  parallel_for(count(), [&](std::size_t b) {
    const numbers now = number_block(b);
    write_block(b, now, made);
    if (visitor.take) visitor.take(b, now);
  });
  each_frame_edge(made.faces, [&](std::size_t i) {
    const frame_edge& edge = frame_[i];
    const auto &l = edge.left, &r = edge.right;
    made.faces[l.face].next[l.edge] = r.face;
    made.faces[r.face].next[r.edge] = l.face;
    made.faces[l.face].segment[l.edge] = made.faces[r.face].segment[r.edge] = edge.segment;
  });
  for (std::size_t b = 0; b < count(); ++b)
    whole_.note_looked_at(blocks_[b]->part.take_looked_at());
  whole_.assign_all(std::move(made));
}

}  // namespace asterism::internal::adapting
