// SPDX-License-Identifier: MIT
#include "asterism/mesh/stars/guessed_neighbours.hpp"

#include "asterism/mesh/stars/mean_metric_net.hpp"

namespace asterism::internal {

neighbour_lists guess_neighbours(const site_oracle& oracle, const cancellation& cancelled) {
  auto net = mean_metric_net::make(oracle, cancelled);
  return net ? net->settled_neighbours() : neighbour_lists();
}

}  // namespace asterism::internal
