// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/subsegment_tree.hpp"

namespace asterism::internal::audit_detail {

subsegment_tree::subsegment_tree(const audit_context& context) {
  for (const vertex_index subsegment : context.subsegments) {
    const boundary_edge& e = context.subject.boundary[subsegment];
    boxed_.push_back({box_around(context.at(e.a), context.at(e.b)), subsegment});
  }
  nodes_.reserve(2 * boxed_.size() / leaf_size + 1);
  if (!boxed_.empty()) build(0, boxed_.size());
}

void subsegment_tree::build(std::size_t first, std::size_t last) {
  const std::size_t self = nodes_.size();
  nodes_.emplace_back();
  plane_box around = boxed_[first].box;
  for (std::size_t i = first; i < last; ++i) {
    const plane_box& b = boxed_[i].box;
    around.low = {std::min(around.low.x, b.low.x), std::min(around.low.y, b.low.y)};
    around.high = {std::max(around.high.x, b.high.x), std::max(around.high.y, b.high.y)};
  }
  nodes_[self] = {around, first, last, 0};
  if (last - first <= leaf_size) return;
  const std::size_t middle = first + (last - first) / 2;
  // Halves coordinates first, as sums and differences of finite doubles may overflow. The half that
  // a subsegment falls into affects cost alone.
  const bool wide = around.high.x / 2 - around.low.x / 2 > around.high.y / 2 - around.low.y / 2;
  const auto place = [wide](const boxed& b) {
    return wide ? b.box.low.x / 2 + b.box.high.x / 2 : b.box.low.y / 2 + b.box.high.y / 2;
  };
  const auto at = [&](std::size_t i) { return boxed_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(middle), at(last), [&](const boxed& a, const boxed& b) {
    const double p = place(a), q = place(b);
    return p < q || (p == q && a.subsegment < b.subsegment);
  });
  build(first, middle);
  nodes_[self].right = nodes_.size();
  build(middle, last);
}

}  // namespace asterism::internal::audit_detail
