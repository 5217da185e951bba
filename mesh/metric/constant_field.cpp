// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric/constant_field.hpp"

#include "asterism/mesh/metric/sized_field.hpp"
#include "asterism/mesh/numerics/metric_algebra.hpp"

namespace asterism::internal {
namespace {

class constant_field : public metric_field {
 public:
  explicit constant_field(const metric_tensor& m) : m_(m) {}
  result<metric_tensor> at(const point& q) const override { return checked_tensor(q, m_); }

 private:
  metric_tensor m_;
};

}  // namespace

std::unique_ptr<metric_field> same_everywhere(const metric_tensor& m) {
  return std::make_unique<constant_field>(m);
}

metric_tensor mean_of(const std::vector<metric_tensor>& tensors) {
  tensor_logarithm mean;
  const double part = 1 / static_cast<double>(tensors.size());
  for (const metric_tensor& m : tensors) add_weighted(part, logarithm(m), mean);
  return exponential(mean);
}

}  // namespace asterism::internal
