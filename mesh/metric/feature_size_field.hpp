// SPDX-License-Identifier: MIT
//
// Spreads the first sites of a domain with many vertices by its short segments: close together
// there, farther apart inside, with about the growth of triangles of 20 degrees. Otherwise the star
// of every vertex would have a large part of all others as neighbours, until refinement has
// inserted sites between them, one by one. The field decides only where sites are proposed; the
// sites have the metric as given.
#pragma once

#include <cstddef>
#include <vector>

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"

namespace asterism::internal {

// The tensor of `field` divided by h^2: with l_v the shorter segment at the vertex v, in the metric
// there, and |q - v| measured at q, h is the least of `longest` and of 1.3 l_v + 0.7 |q - v| over
// all vertices, or up to a sixth more (which spares visiting all vertices that are about equally
// far). Isolated vertices are ignored.
class featured_field : public metric_field {
 public:
  // Makes the field for a checked `d`; `field` must outlive this object. Fails where `field` does.
  static result<featured_field> make(const domain& d, const metric_field& field, double longest);

  // Returns the metric; may be called from any thread.
  result<metric_tensor> at(const point& q) const override;

 private:
  struct feature {
    point vertex;
    double shorter;  // l_v
  };
  // A binary tree; a node without children has features_[first .. last).
  struct node {
    bounding_box box;
    double shortest;
    std::size_t first, last;
    std::size_t second_child;  // the first one is next to the node; 0: none
  };

  featured_field(const metric_field& field, double longest) : field_(&field), longest_(longest) {}
  void add_node(std::size_t first, std::size_t last);
  double length_at(const site& q) const;

  const metric_field* field_;
  double longest_;
  std::vector<feature> features_;
  std::vector<node> nodes_;
};

}  // namespace asterism::internal
