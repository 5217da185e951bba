// SPDX-License-Identifier: MIT
//
// Defines the field of tensors that are given at the vertices of a background mesh.
#pragma once

#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/metric/background_metric.hpp"
#include "asterism/mesh/metric/sized_field.hpp"

namespace asterism::internal {

// Interpolates logarithms of tensors in the triangles of a mesh, as the field of
// make_interpolated_field (interpolated_field.hpp).
class background_field final : public sized_field {
 public:
  background_field(const mesh& m, double size);

  const mesh* background() const override { return &given_; }
  // Returns the tensors before they are divided by size^2.
  const background_metric& without_size() const { return metric_; }
  double size() const { return size_; }

 private:
  result<metric_tensor> unsized(const point& q) const override { return metric_.at(q); }

  double size_;
  mesh given_;  // with the size
  background_metric metric_;
};

}  // namespace asterism::internal
