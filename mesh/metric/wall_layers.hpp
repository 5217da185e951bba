// SPDX-License-Identifier: MIT
//
// Computes layers along parts of the boundary: their height at a distance from the wall, the
// direction across, and the length that their triangles may have along the wall.
//
// Heights: the row of triangles of a mesh with edges of metric length 1 is sqrt(3)/2 high. Rows of
// height h need a metric with the length 2/sqrt(3) h across: `edge_across`. Where the direction
// across turns by the angle t, an edge of length l along the wall at one end has the length l t
// across it at the other end, l t / h in the metric. If that is near 1, no good triangles exist. It
// is kept at 0.16 or below: at a vertex where the wall turns by t edges are no longer than 0.16 h /
// t (or h, where that is more), and grow from there; where vertices of a wall of radius of
// curvature R are nearer together, t is l / R over an edge, and edges are no longer than 0.4 sqrt(R
// h). The sagitta of a chord that long is a fiftieth of h, as for curves that are divided for a
// size (domain/divide_curves.hpp). Where a wall ends and the boundary goes straight on, edges are
// as long as high.
#pragma once

#include <cstddef>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/metric/size_wishes.hpp"
#include "asterism/mesh/search/place_tree.hpp"

namespace asterism::internal {

// A segment with layers, directed with the domain on its left.
struct wall_side {
  vertex_index a = 0, b = 0;
  std::size_t segment = 0;  // of the domain
  std::size_t wish = 0;     // which of the layers it has
};

// Returns the sides of segments that have layers; of internal segments both sides.
std::vector<wall_side> wall_sides(const domain& d, const std::vector<boundary_layers>& layers);

// Returns the wanted length of an edge across, at this distance from the wall.
double edge_across(const boundary_layers& layers, double distance);

class wall_layers {
 public:
  // Takes a domain as check_domain leaves it; keeps its own copy of what it needs.
  wall_layers(const domain& d, std::vector<boundary_layers> layers);

  // Returns the tensor refined for the layers at q: no length becomes longer.
  metric_tensor added_to(const metric_tensor& m, const point& q) const;
  // True if each of the layers has a segment with its marker.
  const std::vector<bool>& found() const { return found_; }

 private:
  struct one_wall {
    place_tree segments;
    std::vector<point> normals_at_ends;  // of each segment two
  };

  point direction_across(const one_wall& wall, const point& q, std::size_t segment) const;

  std::vector<boundary_layers> layers_;
  std::vector<one_wall> walls_;  // one for each of layers_
  place_tree lengths_along_;
  std::vector<bool> found_;
};

}  // namespace asterism::internal
