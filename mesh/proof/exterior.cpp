// SPDX-License-Identifier: MIT
#include "asterism/mesh/proof/exterior.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "asterism/kernels/filtered_kernel.hpp"

namespace asterism::internal::proof_detail {
namespace {

// An edge of the boundary, from its left end to its right one.
struct sweep_edge {
  vertex_index left = 0, right = 0;
  bool has_domain_above = false;
};

// A chain of vertices between two edges that the sweep line crosses, to the right of which there
// are no triangles yet. Both parts end with the latest vertex; `lower` begins at the lower edge,
// `upper` at the upper one.
struct open_chain {
  std::vector<vertex_index> lower, upper;  // both end with the latest; both empty at the beginning
};

class sweep {
 public:
  sweep(const mesh& subject, const std::array<point, 4>& corners)
      : mesh_(subject),
        corners_(corners),
        status_(above{this}),
        arriving_(size()),
        leaving_(size()) {}

  result<std::vector<triangle>> run() {
    std::vector<vertex_index> order = vertices_in_order();
    for (const vertex_index v : order)
      if (!pass(v))
        return error{"the boundary near vertex " + std::to_string(std::size_t{v} + 1) +
                         " does not bound a domain",
                     error_code::invalid_mesh};
    return std::move(triangles_);
  }

 private:
  struct above {
    const sweep* in;
    // True if e is below f; both cross the sweep line.
    bool operator()(const sweep_edge& e, const sweep_edge& f) const { return in->is_below(e, f); }
  };
  // Maps each edge to the chain above it, which is empty if the domain is above.
  using status = std::map<sweep_edge, std::optional<open_chain>, above>;

  std::size_t size() const { return mesh_.sites.size() + corners_.size(); }
  const point& at(vertex_index v) const {
    return v < mesh_.sites.size() ? mesh_.sites[v].position : corners_[v - mesh_.sites.size()];
  }
  bool is_before(vertex_index a, vertex_index b) const {
    const point &p = at(a), &q = at(b);
    return p.x < q.x || (p.x == q.x && p.y < q.y);
  }
  sign turn(vertex_index a, vertex_index b, vertex_index c) const {
    return kernel_.orientation(at(a), at(b), at(c));
  }

  bool is_below(const sweep_edge& e, const sweep_edge& f) const {
    if (e.left == f.left) return turn(e.left, e.right, f.right) == sign::positive;
    if (is_before(e.left, f.left)) {
      const sign side = turn(e.left, e.right, f.left);
      return side == sign::zero ? turn(e.left, e.right, f.right) == sign::positive
                                : side == sign::positive;
    }
    const sign side = turn(f.left, f.right, e.left);
    return side == sign::zero ? turn(f.left, f.right, e.right) == sign::negative
                              : side == sign::negative;
  }

  std::vector<vertex_index> vertices_in_order() {
    std::vector<vertex_index> order;
    for (const boundary_edge& e : mesh_.boundary) {
      if (e.internal) continue;
      const bool is_forward = is_before(e.a, e.b);
      const sweep_edge edge = is_forward ? sweep_edge{e.a, e.b, true} : sweep_edge{e.b, e.a, false};
      leaving_[edge.left].push_back(edge);
      arriving_[edge.right].push_back(edge);
      order.push_back(e.a);
      order.push_back(e.b);
    }
    for (std::size_t v = mesh_.sites.size(); v < size(); ++v)
      order.push_back(static_cast<vertex_index>(v));
    std::sort(order.begin(), order.end(),
              [this](vertex_index a, vertex_index b) { return is_before(a, b); });
    order.erase(std::unique(order.begin(), order.end()), order.end());
    const auto upwards = [this](const sweep_edge& e, const sweep_edge& f) {
      return is_below(e, f);
    };
    for (const vertex_index v : order) {
      std::sort(arriving_[v].begin(), arriving_[v].end(), [this](const auto& e, const auto& f) {
        return turn(e.right, e.left, f.left) == sign::negative;
      });
      std::sort(leaving_[v].begin(), leaving_[v].end(), upwards);
    }
    return order;
  }

  // Makes a triangle of v and each edge at the end of the chain that v sees, removes the vertices
  // between these edges, and appends v.
  void advance(std::vector<vertex_index>& chain, vertex_index v, bool is_lower) {
    while (chain.size() > 1) {
      const vertex_index last = chain.back(), next = chain[chain.size() - 2];
      // Uses that triangles lie to the right of next -> last -> ... for the lower part, and to the
      // left of it for the upper part.
      if (turn(next, last, v) != (is_lower ? sign::negative : sign::positive)) break;
      triangles_.push_back(is_lower ? triangle{last, next, v} : triangle{next, last, v});
      chain.pop_back();
    }
    chain.push_back(v);
  }

  // Makes the triangles between the chain and v.
  void advance(open_chain& chain, vertex_index v) {
    advance(chain.lower, v, true);
    advance(chain.upper, v, false);
  }

  // Moves the sweep line over v. False if the edges at v do not fit the status.
  bool pass(vertex_index v) {
    std::optional<open_chain>* below = find_below(v);
    if (below == nullptr) return false;
    // Keeps two chains that end at v. `lower` is the lower part of the chain above the edge that
    // passes just below v. `upper` is the upper part of the chain above the last edge that arrives
    // at v, or of the former chain if no edge arrives.
    std::optional<std::vector<vertex_index>> lower, upper;
    if (*below) {
      advance(**below, v);
      lower = std::move((*below)->lower);
      upper = std::move((*below)->upper);
    }
    for (const sweep_edge& edge : arriving_[v]) {
      const auto found = status_.find(edge);
      if (found == status_.end()) return false;
      upper.reset();
      if (found->second) {
        advance(*found->second, v);
        upper = std::move(found->second->upper);
      }
      status_.erase(found);
    }
    return begin(v, *below, std::move(lower), std::move(upper));
  }

  // Inserts the edges that begin at v, with the chains between them, and ends the chains below and
  // above them at v. False if the sides on which edges have the domain contradict each other.
  bool begin(vertex_index v, std::optional<open_chain>& below,
             std::optional<std::vector<vertex_index>> lower,
             std::optional<std::vector<vertex_index>> upper) {
    const auto& leaving = leaving_[v];
    if (leaving.empty()) {
      if (lower.has_value() != upper.has_value()) return false;
      if (lower) below = open_chain{std::move(*lower), std::move(*upper)};
      return true;
    }
    if (lower) below = open_chain{std::move(*lower), {v}};
    for (std::size_t i = 0; i < leaving.size(); ++i) {
      const bool is_last = i + 1 == leaving.size();
      if (is_last && upper.has_value() == leaving[i].has_domain_above) return false;
      std::optional<open_chain> here;
      if (!leaving[i].has_domain_above)
        here = open_chain{{v}, is_last ? std::move(*upper) : std::vector<vertex_index>{v}};
      if (!status_.emplace(leaving[i], std::move(here)).second) return false;
    }
    return true;
  }

  // Returns the chain above the highest edge that is below v and does not end there; null if an
  // edge that ends at v is not in the status.
  std::optional<open_chain>* find_below(vertex_index v) {
    if (!arriving_[v].empty()) {
      const auto first = status_.find(arriving_[v].front());
      if (first == status_.end()) return nullptr;
      return first == status_.begin() ? &bottom_ : &std::prev(first)->second;
    }
    // Uses that an edge of length zero is ordered as its point is.
    const auto next = status_.lower_bound(sweep_edge{v, v, false});
    return next == status_.begin() ? &bottom_ : &std::prev(next)->second;
  }

  const mesh& mesh_;
  const std::array<point, 4>& corners_;
  filtered_kernel kernel_;
  status status_;
  std::optional<open_chain> bottom_{std::in_place};  // below all edges
  std::vector<std::vector<sweep_edge>> arriving_, leaving_;
  std::vector<triangle> triangles_;
};

}  // namespace

result<std::vector<triangle>> triangulate_outside(const mesh& subject,
                                                  const std::array<point, 4>& corners) {
  return sweep(subject, corners).run();
}

}  // namespace asterism::internal::proof_detail
