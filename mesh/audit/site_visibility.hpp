// SPDX-License-Identifier: MIT
//
// Decides, for the auditor, which sites see each other inside the domain.
#pragma once

#include "asterism/core/sign.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/audit/context.hpp"
#include "asterism/mesh/audit/subsegment_tree.hpp"

namespace asterism::internal::audit_detail {

class site_visibility {
 public:
  site_visibility(const audit_context& context, const subsegment_tree& subsegments,
                  filtered_kernel kernel)
      : context_(context), subsegments_(subsegments), kernel_(kernel) {}

  // True if no boundary subsegment meets the open segment between v and w. Otherwise v does not see
  // w: only sites joined to v inside the domain are seen.
  bool clear(vertex_index v, vertex_index w) const {
    return subsegments_.visit(box_around(context_.at(v), context_.at(w)),
                              [&](vertex_index subsegment) {
                                return !blocks(context_.subject.boundary[subsegment], v, w);
                              });
  }

 private:
  sign turn(vertex_index a, vertex_index b, vertex_index c) const {
    return kernel_.orientation(context_.at(a), context_.at(b), context_.at(c));
  }

  bool blocks(const boundary_edge& e, vertex_index v, vertex_index w) const {
    const sign side_a = turn(v, w, e.a), side_b = turn(v, w, e.b);
    if (side_a == sign::zero && inside_segment(e.a, v, w)) return true;
    if (side_b == sign::zero && inside_segment(e.b, v, w)) return true;
    if (side_a * side_b != sign::negative) return false;
    return turn(e.a, e.b, v) * turn(e.a, e.b, w) == sign::negative;
  }

  // True if q, which is on the line of v and w, is strictly between them.
  bool inside_segment(vertex_index q, vertex_index v, vertex_index w) const {
    return q != v && q != w && same_ray(context_.at(v), context_.at(q), context_.at(w)) &&
           same_ray(context_.at(w), context_.at(q), context_.at(v));
  }

  const audit_context& context_;
  const subsegment_tree& subsegments_;
  filtered_kernel kernel_;
};

}  // namespace asterism::internal::audit_detail
