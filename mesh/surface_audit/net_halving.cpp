// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface_audit/net_halving.hpp"

#include <algorithm>

namespace asterism::internal {

std::array<control_net, 2> halved(const control_net& net, std::size_t row, bool by_s) {
  const std::size_t rows = net.size() / row;
  const std::size_t lines = by_s ? row : rows, count = by_s ? rows : row;
  const std::size_t stride = by_s ? row : 1, between_lines = by_s ? 1 : row;
  std::array<control_net, 2> parts = {control_net(net.size()), control_net(net.size())};
  std::array<weighted_point, most_degree + 1> c;
  for (std::size_t line = 0; line < lines; ++line) {
    const std::size_t first = line * between_lines;
    for (std::size_t k = 0; k < count; ++k) c[k] = net[first + k * stride];
    for (std::size_t left = count; left > 0; --left) {
      parts[0][first + (count - left) * stride] = c[0];
      parts[1][first + (left - 1) * stride] = c[left - 1];
      for (std::size_t k = 0; k + 1 < left; ++k) c[k] = rounded_interval(0.5) * (c[k] + c[k + 1]);
    }
  }
  return parts;
}

bool is_longer_by_s(const control_net& net, std::size_t row) {
  const auto at = [&](std::size_t k) {
    return (1 / middle_of(net[k].weight)) * middle_of(net[k].at);
  };
  const auto far = [&](std::size_t a, std::size_t b) {
    const plain_vector d = at(a) - at(b);
    return dot(d, d);
  };
  double by_s = 0, by_t = 0;
  for (std::size_t i = 0; i < net.size(); i += row) by_t = std::max(by_t, far(i + row - 1, i));
  for (std::size_t j = 0; j < row; ++j) by_s = std::max(by_s, far(net.size() - row + j, j));
  return by_s >= by_t;
}

}  // namespace asterism::internal
