// SPDX-License-Identifier: MIT
//
// Measures sites by a metric field, and keeps the field's first error, for code that ends only at a
// convenient place.
#pragma once

#include <optional>

#include "asterism/core/result.hpp"
#include "asterism/core/site.hpp"
#include "asterism/mesh/data/metric_field.hpp"

namespace asterism::internal {

class field_sampler {
 public:
  // The field must outlive this object.
  explicit field_sampler(const metric_field& field) : field_(&field) {}

  // Returns the site at q; nothing where the field fails.
  std::optional<site> at(const point& q) {
    auto metric = field_->at(q);
    if (metric) return site{q, metric.value()};
    if (!failure_) failure_ = metric.failure();
    return std::nullopt;
  }

  const metric_field& field() const { return *field_; }
  // Returns the first failure of the field, if it has failed.
  const std::optional<error>& failure() const { return failure_; }

 private:
  const metric_field* field_;
  std::optional<error> failure_;
};

}  // namespace asterism::internal
