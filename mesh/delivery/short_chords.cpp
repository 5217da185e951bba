// SPDX-License-Identifier: MIT
#include "asterism/mesh/delivery/short_chords.hpp"

#include <algorithm>
#include <cstddef>

#include "asterism/mesh/numerics/constructions.hpp"

namespace asterism::internal {
namespace {

// Metric length below which a chord is short: half of the least length of a chord that
// divide_curves halves for the size across. Only a tolerance of the curve makes shorter chords,
// with few exceptions.
constexpr double least_of_wanted = 0.4;

}  // namespace

std::vector<double> factors_at_short_chords(const domain& d, const background_metric& field) {
  std::vector<double> factors(field.places().size(), 1);
  bool any = false;
  vertex_index hint = 0;
  for (const domain_curve& curve : d.curves) {
    if (curve.vertices.size() == 2) continue;
    for (std::size_t i = 0; i + 1 < curve.vertices.size(); ++i) {
      const point &from = d.vertices[curve.vertices[i]], &to = d.vertices[curve.vertices[i + 1]];
      const point chord{to.x - from.x, to.y - from.y};
      const double square = chord.x * chord.x + chord.y * chord.y;
      for (const point& end : {from, to})
        for (const vertex_index v : field.nodes_around(end, hint)) {
          const point &place = field.places()[v], off{place.x - end.x, place.y - end.y};
          if (off.x * off.x + off.y * off.y > square) continue;
          const double measured = squared_length(field.tensors()[v], chord);
          if (!(measured > 0 && measured < least_of_wanted * least_of_wanted)) continue;
          factors[v] = std::max(factors[v], 1 / measured);
          any = true;
        }
    }
  }
  if (!any) factors.clear();
  return factors;
}

}  // namespace asterism::internal
