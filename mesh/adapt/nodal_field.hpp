// SPDX-License-Identifier: MIT
//
// Interpolates the logarithms of tensors at the vertices of a background mesh, looked up by walking
// from where one was before. Internal to mesh/adapt.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/adapt/nodal_gradation.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/numerics/metric_algebra.hpp"
#include "asterism/mesh/search/box_index.hpp"

namespace asterism::internal::adapting {

class nodal_field {
 public:
  // Leaves out flat and clockwise triangles; requires one that is neither.
  explicit nodal_field(const mesh& background);

  const std::vector<point>& places() const { return places_; }
  const std::vector<metric_tensor>& tensors() const { return tensors_; }
  void set_tensors(std::vector<metric_tensor> tensors);

  // Returns the tensor at the point, interpolated in the triangle it is in, or in one near it. The
  // walk begins at `hint`, which is set to where it ended.
  metric_tensor at(const point& q, vertex_index& hint) const;
  // Returns what at() does, where that is another tensor than a field says which has the same
  // triangles.
  std::optional<metric_tensor> where_other(const nodal_field& than, const point& q,
                                           vertex_index hint) const;
  // Returns how many triangles searches have looked at since the last call: few, but where
  // triangles are so thin that the box of each overlaps those of thousands. One thread asks.
  std::size_t take_looked_at() const { return std::exchange(looked_at_, 0); }

  // Returns the edges, each once.
  std::vector<graph_edge> edges() const;
  // Returns the integral of the root of the determinant: the area as the metric measures it.
  double complexity() const;

 private:
  struct cell {
    triangle v;
    triangle next;  // across from each vertex; its own number at the boundary
  };

  void link();
  // Returns the triangle and sets the point's weights in it, none negative.
  vertex_index locate(const point& q, vertex_index hint, double (&w)[3]) const;
  metric_tensor mean(vertex_index t, const double (&w)[3]) const;
  bool walk(const point& q, vertex_index& t, double (&w)[3]) const;
  vertex_index search(const point& q, double (&w)[3]) const;
  double least_weight(const point& q, vertex_index t, double (&w)[3]) const;

  std::vector<point> places_;
  std::vector<metric_tensor> tensors_;
  std::vector<tensor_logarithm> logarithms_;
  std::vector<cell> cells_;
  box_index boxes_;
  bounding_box box_;
  mutable std::size_t looked_at_ = 0;
};

}  // namespace asterism::internal::adapting
