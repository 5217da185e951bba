// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric/background_field.hpp"

namespace asterism::internal {

background_field::background_field(const mesh& m, double size)
    : sized_field(size), size_(size), metric_(m) {
  given_.sites = m.sites;
  given_.triangles = m.triangles;
  const double squared = size_squared();
  for (site& s : given_.sites)
    s.metric = {s.metric.m11 / squared, s.metric.m12 / squared, s.metric.m22 / squared};
}

}  // namespace asterism::internal
