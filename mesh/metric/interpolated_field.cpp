// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric/interpolated_field.hpp"

#include "asterism/mesh/metric/background_field.hpp"

namespace asterism {

std::unique_ptr<metric_field> make_interpolated_field(const mesh& m, double size) {
  return std::make_unique<internal::background_field>(m, size);
}

}  // namespace asterism
