// SPDX-License-Identifier: MIT
//
// Interpolates tensors that are given at the vertices of a background mesh: their logarithms
// linearly in each triangle ("log-Euclidean", numerics/metric_algebra.hpp).
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/numerics/metric_algebra.hpp"
#include "asterism/mesh/search/triangle_locator.hpp"

namespace asterism::internal {

// Copies share the background mesh, and may have other tensors on it. Several threads may read one
// object.
class background_metric {
 public:
  // Leaves out flat and clockwise triangles; requires one that is neither.
  explicit background_metric(const mesh& background);
  // Interpolates tensors at the places of triangles that are indexed already.
  background_metric(std::shared_ptr<const triangle_locator> locator,
                    std::vector<metric_tensor> tensors);
  // Interpolates a part of a larger mesh, whose box is given, as the background of the whole would.
  background_metric(const mesh& background, const bounding_box& box);

  const std::vector<point>& places() const { return locator_->places(); }
  const std::vector<metric_tensor>& tensors() const { return *tensors_; }
  void set_tensors(std::vector<metric_tensor> tensors);

  // Returns the tensor at the point, interpolated in the triangle that it is farthest inside of, or
  // in one near it; at a vertex of that triangle the vertex's own, bit for bit.
  metric_tensor at(const point& q) const;
  // Returns the tensor of at(), or nothing if no triangle is within `reach` of the point.
  std::optional<metric_tensor> at_within(const point& q, double reach) const;
  // Returns the tensor of at() with relative errors of 1e-13, faster near the last place: the walk
  // begins at `hint`, which is set to the triangle where it ends. Adds the number of triangles that
  // the search has visited to `looked_at`: few, unless triangles are so thin that the box of each
  // overlaps those of thousands.
  metric_tensor at(const point& q, vertex_index& hint, std::size_t& looked_at) const;
  // Returns the same tensor, and counts no triangles.
  metric_tensor at(const point& q, vertex_index& hint) const {
    std::size_t looked_at = 0;
    return at(q, hint, looked_at);
  }
  // Lets the next search near q without a hint, also of a copy, begin at this triangle.
  void begin_near(const point& q, vertex_index hint) const { locator_->begin_near(q, hint); }
  // Returns the triangle in which at() with this hint interpolates; counts as that does.
  vertex_index triangle_near(const point& q, vertex_index hint, std::size_t& looked_at) const {
    return nearby(q, hint, looked_at).triangle;
  }
  // Returns the tensor of at() with a hint, if it differs from that of another field on the same
  // triangles; counts as that does.
  std::optional<metric_tensor> where_other(const background_metric& than, const point& q,
                                           vertex_index hint, std::size_t& looked_at) const;
  // Returns the corners of the triangle that at() with a hint interpolates in.
  triangle nodes_around(const point& q, vertex_index& hint) const;

  // Returns the edges, each once.
  std::vector<graph_edge> edges() const { return locator_->edges(); }
  // Returns the integral of the root of the determinant: the area in the metric.
  double complexity() const;

 private:
  metric_tensor at_place(const point& q, const triangle_locator::located& where) const;
  triangle_locator::located nearby(const point& q, vertex_index hint, std::size_t& looked_at) const;
  tensor_logarithm mean_logarithm(const triangle_locator::located& where) const;
  metric_tensor mean(const triangle_locator::located& where) const {
    return exponential(mean_logarithm(where));
  }

  std::shared_ptr<const triangle_locator> locator_;
  // Copies share the lists.
  std::shared_ptr<const std::vector<metric_tensor>> tensors_;
  std::shared_ptr<const std::vector<tensor_logarithm>> logarithms_;
};

}  // namespace asterism::internal
