// SPDX-License-Identifier: MIT
//
// Finds, among places with a size that grows with the distance from them, the one that allows the
// least size at a point: with slope 1 and size 0 the nearest one.
//
// A binary tree of boxes, made in O(n log n); a query visits about log n places where they are
// spread evenly. Computes in doubles, and decides nothing. A distance has a relative error of some
// units in the last place, however near the point is to a long segment, so that sizes do not sink
// on the way from a place. Of equal places the first is found, whatever the order of the tree.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/bounding_box.hpp"

namespace asterism::internal {

// A place: the segment from a to b, or the box between these corners, with everything within
// `radius` of it.
struct sized_place {
  point a, b;
  double radius = 0;
  bool is_box = false;
  double size = 0, slope = 1;  // size + slope * distance is allowed
};

// Returns the point of the segment that is nearest to q. If an end is nearest, it is returned bit
// for bit.
point nearest_on_segment(const point& q, const point& a, const point& b);
// Returns the distance of q from the segment or the box; 0 inside.
double distance_from(const point& q, const sized_place& place);

class place_tree {
 public:
  explicit place_tree(std::vector<sized_place> places);

  struct found {
    std::size_t place = 0;  // its number; of no meaning where there are none
    double size = std::numeric_limits<double>::infinity();
  };
  // Returns the place that allows the least size at q, and that size.
  found least_at(const point& q) const;

  const std::vector<sized_place>& places() const { return places_; }

 private:
  struct node {
    bounding_box box;  // around its places, their circles included
    double size, slope;
    std::uint32_t first, last;       // of order_; a leaf
    std::uint32_t second_child = 0;  // the first is next to the node; 0: none
  };

  void add_node(std::uint32_t first, std::uint32_t last);
  static double bound_at(const node& n, const point& q);

  std::vector<sized_place> places_;
  std::vector<std::uint32_t> order_;
  std::vector<node> nodes_;
};

}  // namespace asterism::internal
