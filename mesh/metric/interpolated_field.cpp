// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric/interpolated_field.hpp"

#include "asterism/mesh/metric/background_metric.hpp"
#include "asterism/mesh/metric/sized_field.hpp"

namespace asterism {
using namespace internal;
namespace {

class interpolated_field final : public sized_field {
 public:
  interpolated_field(const mesh& m, double size) : sized_field(size), metric_(m) {
    given_.sites = m.sites;
    given_.triangles = m.triangles;
    const double squared = size_squared();
    for (site& s : given_.sites)
      s.metric = {s.metric.m11 / squared, s.metric.m12 / squared, s.metric.m22 / squared};
  }

  const mesh* background() const override { return &given_; }

 private:
  result<metric_tensor> unsized(const point& q) const override { return metric_.at(q); }

  mesh given_;  // with the size
  background_metric metric_;
};

}  // namespace

std::unique_ptr<metric_field> make_sampled_field(const mesh& m, double size) {
  return std::make_unique<interpolated_field>(m, size);
}

}  // namespace asterism
