// SPDX-License-Identifier: MIT
//
// Scales a metric field so that edges of unit length in it are shorter by any factor.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/data/outcome.hpp"

namespace asterism::internal {

// Multiplies the squared lengths of a field by the square of a factor; each entry is rounded once.
class shorter_field : public metric_field {
 public:
  // `field` must outlive this object. The factor must be at least 1.
  shorter_field(const metric_field& field, double factor) : field_(&field), factor_(factor) {}
  // Fails where the field does, and where the product is no metric: its numbers leave the range of
  // doubles, or rounding makes it indefinite.
  result<metric_tensor> at(const point& q) const override;
  void expect(const std::function<std::vector<point>()>& places) const override {
    field_->expect(places);
  }

  // Gives the sites of an outcome made in this field the tensors of the original field, to the bit,
  // and converts its lengths.
  std::optional<error> restore(mesh_outcome& outcome) const;

 private:
  const metric_field* field_;
  double factor_;
};

}  // namespace asterism::internal
