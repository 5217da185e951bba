// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/snapping.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "asterism/core/sign.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/data/bounding_box.hpp"
#include "asterism/mesh/domain/exact_lengths.hpp"
#include "asterism/mesh/domain/near_vertices.hpp"
#include "asterism/mesh/support/work_weights.hpp"

namespace asterism::internal {
namespace {

// Largest number of pieces, which bounds memory: at 64 bytes a piece, with its lists, a quarter of
// a gigabyte.
constexpr std::size_t most_pieces = 4000000;

using vertex_pair = std::pair<vertex_index, vertex_index>;

// A straight edge, shared by all segments that run along it.
struct edge {
  vertex_index a = 0, b = 0;  // a has the lower index
  std::size_t source = 0;     // of the first piece
  std::vector<vertex_index> through = {};
};

class snapper {
 public:
  snapper(const domain& d, double distance, const cancellation& stop)
      : distance_(distance), near_(distance), stop_(stop) {
    made_.vertices = d.vertices;
    join_vertices(d);
    for (std::size_t s = 0; s < d.segments.size(); ++s)
      made_.pieces.push_back(
          {made_.joined_to[d.segments[s].a], made_.joined_to[d.segments[s].b], s});
    std::erase_if(made_.pieces, [](const snapped_piece& p) { return p.a == p.b; });
  }

  result<snapped_graph> snap() {
    for (bool changed = true; changed; ++made_.rounds) {
      while (bend_to_vertices())
        if (is_too_much()) return too_much();
      if (is_too_much()) return too_much();
      changed = cut_crossings();
      if (is_too_much()) return too_much();
    }
    return std::move(made_);
  }

 private:
  bool is_too_much() {
    if (!why_ended_) why_ended_ = stop_.poll();
    return why_ended_ || std::max(made_.pieces.size(), made_.meetings.size()) > most_pieces;
  }
  error too_much() const {
    if (why_ended_) return {"the repair was ended: " + *why_ended_};
    return {"the segments cross too often to be repaired: they fall into more than " +
            std::to_string(most_pieces) + " pieces"};
  }
  const point& at(vertex_index v) const { return made_.vertices[v]; }
  bounding_box box_of(const edge& e) const {
    bounding_box box{at(e.a), at(e.a)};
    box.include(at(e.b));
    return box;
  }

  void join_vertices(const domain& d);
  std::vector<edge> edges() const;
  void order_along(edge& e) const;
  bool bend_to_vertices();
  bool cut_crossings();
  void meet(edge& e, edge& f);
  std::optional<vertex_index> common_vertex(const edge& e, const edge& f);
  bool is_safe(vertex_index v, const edge& e) const;
  std::vector<vertex_index> chain_of(const edge& e) const;
  bool replace(const std::vector<edge>& edges);

  double distance_;
  near_vertices near_;
  const cancellation& stop_;
  std::optional<std::string> why_ended_;
  std::vector<vertex_index> kept_;  // what no other vertex replaces
  snapped_graph made_;
};

void snapper::join_vertices(const domain& d) {
  for (vertex_index v = 0; v < d.vertices.size(); ++v) {
    vertex_index nearest = v;
    for (const vertex_index w : near_.around(at(v))) {
      if (!are_nearer(at(v), at(w), distance_)) continue;
      const bool is_first = nearest == v || is_nearer_to(at(v), at(w), at(nearest)) ||
                            (!is_nearer_to(at(v), at(nearest), at(w)) && w < nearest);
      if (is_first) nearest = w;
    }
    made_.joined_to.push_back(nearest);
    if (nearest != v) continue;
    near_.add(v, at(v));
    kept_.push_back(v);
  }
}

// Returns each edge once, in the order of the pieces.
std::vector<edge> snapper::edges() const {
  std::map<vertex_pair, std::size_t> known;
  std::vector<edge> all;
  for (const snapped_piece& p : made_.pieces) {
    const vertex_pair ends = std::minmax(p.a, p.b);
    if (known.try_emplace(ends, all.size()).second)
      all.push_back({ends.first, ends.second, p.source});
  }
  return all;
}

// Sorts the vertices that the edge is to pass, from a to b. Works in doubles: a wrong order makes
// links that are too long, and those are refused.
void snapper::order_along(edge& e) const {
  const point &a = at(e.a), &b = at(e.b);
  const double scale = std::max(std::abs(b.x - a.x), std::abs(b.y - a.y));
  const double x = (b.x - a.x) / scale, y = (b.y - a.y) / scale;
  const auto along = [&](vertex_index v) { return (at(v).x - a.x) * x + (at(v).y - a.y) * y; };
  std::stable_sort(e.through.begin(), e.through.end(),
                   [&](vertex_index v, vertex_index w) { return along(v) < along(w); });
  e.through.erase(std::unique(e.through.begin(), e.through.end()), e.through.end());
}

// Bends edges to near vertices (step 2), each edge once. Returns true if anything changed.
bool snapper::bend_to_vertices() {
  std::vector<vertex_index> by_x = kept_;
  std::stable_sort(by_x.begin(), by_x.end(), [&](vertex_index v, vertex_index w) {
    return lexicographically_less(at(v), at(w));
  });
  std::vector<edge> all = edges();
  for (edge& e : all) {
    double units = work_weights::edge_in_arrangement;
    const bounding_box box = box_of(e);
    // Searches wider than half the distance, so that rounding excludes no vertex.
    const double low = box.low.x - distance_, high = box.high.x + distance_;
    auto v = std::lower_bound(by_x.begin(), by_x.end(), low,
                              [&](vertex_index w, double x) { return at(w).x < x; });
    for (; v != by_x.end() && at(*v).x <= high; ++v) {
      const point& p = at(*v);
      units += work_weights::vertex_beside_edge;
      if (p.y < box.low.y - distance_ || p.y > box.high.y + distance_) continue;
      units += work_weights::vertex_near_edge;
      if (*v == e.a || *v == e.b || !is_beside(p, at(e.a), at(e.b), distance_ / 2)) continue;
      e.through.push_back(*v);
      made_.meetings.push_back({*v, e.source, *v, false});
    }
    order_along(e);
    stop_.charge(units);
    if (is_too_much()) return false;
  }
  return replace(all);
}

// Adds the vertices of all present crossings (step 3). Returns true if there were any.
bool snapper::cut_crossings() {
  const filtered_kernel kernel;
  std::vector<edge> all = edges();
  std::vector<bounding_box> boxes;
  boxes.reserve(all.size());
  for (const edge& e : all) boxes.push_back(box_of(e));
  std::vector<std::size_t> by_x(all.size());
  for (std::size_t i = 0; i < by_x.size(); ++i) by_x[i] = i;
  std::stable_sort(by_x.begin(), by_x.end(),
                   [&](std::size_t i, std::size_t j) { return boxes[i].low.x < boxes[j].low.x; });
  const auto cross = [&](const edge& e, const edge& f) {
    if (e.a == f.a || e.a == f.b || e.b == f.a || e.b == f.b) return false;
    const point &a = at(e.a), &b = at(e.b), &c = at(f.a), &d = at(f.b);
    return kernel.orientation(a, b, c) * kernel.orientation(a, b, d) == sign::negative &&
           kernel.orientation(c, d, a) * kernel.orientation(c, d, b) == sign::negative;
  };
  for (std::size_t i = 0; i < by_x.size(); ++i) {
    edge& e = all[by_x[i]];
    const bounding_box& box = boxes[by_x[i]];
    double units = work_weights::edge_in_arrangement;
    for (std::size_t j = i + 1; j < by_x.size() && boxes[by_x[j]].low.x <= box.high.x; ++j) {
      const bounding_box& other = boxes[by_x[j]];
      units += work_weights::vertex_beside_edge;
      if (other.low.y > box.high.y || other.high.y < box.low.y) continue;
      units += work_weights::vertex_near_edge;
      if (!cross(e, all[by_x[j]])) continue;
      units += work_weights::crossing_entered;
      meet(e, all[by_x[j]]);
    }
    stop_.charge(units);
    if (is_too_much()) return false;
  }
  for (edge& e : all) order_along(e);
  return replace(all);
}

bool snapper::is_safe(vertex_index v, const edge& e) const {
  return v == e.a || v == e.b || shortens(at(v), at(e.a), at(e.b));
}

// Returns a vertex for the crossing: a new one at the rounded crossing, or a present one near it.
// The vertex nearest to the exact crossing would always be valid; since the crossing is rounded,
// further near vertices are tried after it.
std::optional<vertex_index> snapper::common_vertex(const edge& e, const edge& f) {
  const point p = rounded_crossing(at(e.a), at(e.b), at(f.a), at(f.b));
  std::vector<vertex_index> near = near_.around(p);
  const bool is_free = std::none_of(
      near.begin(), near.end(), [&](vertex_index v) { return are_nearer(p, at(v), distance_); });
  if (is_free && shortens(p, at(e.a), at(e.b)) && shortens(p, at(f.a), at(f.b))) {
    const auto made = static_cast<vertex_index>(made_.vertices.size());
    made_.vertices.push_back(p);
    near_.add(made, p);
    kept_.push_back(made);
    return made;
  }
  near.insert(near.end(), {e.a, e.b, f.a, f.b});
  std::stable_sort(near.begin(), near.end(), [&](vertex_index v, vertex_index w) {
    return is_nearer_to(p, at(v), at(w)) || (!is_nearer_to(p, at(w), at(v)) && v < w);
  });
  for (const vertex_index v : near)
    if (is_safe(v, e) && is_safe(v, f)) return v;
  return std::nullopt;
}

void snapper::meet(edge& e, edge& f) {
  const auto v = common_vertex(e, f);
  if (!v) return;
  for (edge* const cut : {&e, &f})
    if (*v != cut->a && *v != cut->b) cut->through.push_back(*v);
  const auto [first, second] = std::minmax(e.source, f.source);
  made_.meetings.push_back({*v, second, first, true});
}

// Returns the vertices that replace the edge from a to b, both included: all that it must pass
// through; or only the first of these if a piece between two successive ones would not be shorter
// than the edge.
std::vector<vertex_index> snapper::chain_of(const edge& e) const {
  std::vector<vertex_index> chain = {e.a};
  chain.insert(chain.end(), e.through.begin(), e.through.end());
  chain.push_back(e.b);
  if (chain.size() <= 3) return chain;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i)
    if (!is_shorter(at(chain[i]), at(chain[i + 1]), at(e.a), at(e.b)))
      return {e.a, e.through.front(), e.b};
  return chain;
}

// Replaces each piece along an edge that must pass through other vertices by the pieces between
// these. Returns true if there are any such edges.
bool snapper::replace(const std::vector<edge>& edges) {
  std::map<vertex_pair, std::vector<vertex_index>> chains;
  for (const edge& e : edges)
    if (!e.through.empty()) chains.emplace(vertex_pair{e.a, e.b}, chain_of(e));
  if (chains.empty()) return false;
  std::vector<snapped_piece> pieces;
  for (const snapped_piece& p : made_.pieces) {
    const auto found = chains.find(std::minmax(p.a, p.b));
    if (found == chains.end()) {
      pieces.push_back(p);
      continue;
    }
    std::vector<vertex_index> chain = found->second;
    if (p.a > p.b) std::reverse(chain.begin(), chain.end());
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
      pieces.push_back({chain[i], chain[i + 1], p.source});
  }
  made_.pieces = std::move(pieces);
  return true;
}

}  // namespace

result<snapped_graph> snap_segments(const domain& d, double distance, const cancellation& stop) {
  return snapper(d, distance, stop).snap();
}

}  // namespace asterism::internal
