// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/shorter_field.hpp"

#include "asterism/mesh/metric/sized_field.hpp"

namespace asterism::internal {

result<metric_tensor> shorter_field::at(const point& q) const {
  const auto given = field_->at(q);
  if (!given || factor_ == 1) return given;
  const metric_tensor& m = given.value();
  const double square = factor_ * factor_;
  return checked_tensor(q, {square * m.m11, square * m.m12, square * m.m22});
}

std::optional<error> shorter_field::restore(mesh_outcome& outcome) const {
  for (site& s : outcome.result.sites) {
    const auto own = field_->at(s.position);
    if (!own) return own.failure();
    s.metric = own.value();
  }
  outcome.ended.tolerance /= factor_;
  if (outcome.ended.steep) outcome.ended.steep->spacing /= factor_;
  return std::nullopt;
}

}  // namespace asterism::internal
