// SPDX-License-Identifier: MIT
//
// Finds the boundary subsegments whose boxes meet a given box, in a tree of boxes, by comparisons
// alone.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "asterism/mesh/audit/context.hpp"

namespace asterism::internal::audit_detail {

struct plane_box {
  point low, high;
};

inline plane_box box_around(const point& p, const point& q) {
  return {{std::min(p.x, q.x), std::min(p.y, q.y)}, {std::max(p.x, q.x), std::max(p.y, q.y)}};
}

inline bool overlap(const plane_box& a, const plane_box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

class subsegment_tree {
 public:
  // Builds the tree over context.subsegments.
  explicit subsegment_tree(const audit_context& context);

  // Calls visit(subsegment) for each subsegment whose box meets the closed one, in an order that
  // depends on the boundary alone, until visit returns false; returns whether it never did.
  template <class Visit>
  bool visit(const plane_box& box, const Visit& visit) const {
    return nodes_.empty() || visit_below(0, box, visit);
  }

 private:
  static constexpr std::size_t leaf_size = 4;

  struct boxed {
    plane_box box;
    vertex_index subsegment = 0;
  };
  struct node {
    plane_box box;
    std::size_t first = 0, last = 0;  // of boxed_
    std::size_t right = 0;            // the left child follows its parent; no right child: a leaf
  };

  void build(std::size_t first, std::size_t last);

  // Depth bound: the halves of a node differ in size by one at most, so the depth is at most the
  // number of bits of the count.
  template <class Visit>
  bool visit_below(std::size_t self, const plane_box& box, const Visit& visit) const {
    const node& n = nodes_[self];
    if (!overlap(n.box, box)) return true;
    if (n.right != 0) return visit_below(self + 1, box, visit) && visit_below(n.right, box, visit);
    return std::all_of(boxed_.begin() + static_cast<std::ptrdiff_t>(n.first),
                       boxed_.begin() + static_cast<std::ptrdiff_t>(n.last),
                       [&](const boxed& b) { return !overlap(b.box, box) || visit(b.subsegment); });
  }

  std::vector<boxed> boxed_;
  std::vector<node> nodes_;
};

}  // namespace asterism::internal::audit_detail
