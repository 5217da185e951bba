// SPDX-License-Identifier: MIT
#include "asterism/mesh/proof/star_conditions.hpp"

#include <algorithm>
#include <array>

namespace asterism::internal::proof_detail {

namespace {

template <class Number>
Number opposite_angles(const site& v, const site& w, const site& x, const site& y) {
  const tensor<Number> metric(v.metric);
  const auto from = [&](const site& z) {
    const vector2<Number> a = way<Number>(z.position, v.position),
                          b = way<Number>(z.position, w.position);
    return std::array{dot(a, metric * b), cross(a, b)};
  };
  const auto at_x = from(x), at_y = from(y);
  return at_x[0] * at_y[1] - at_y[0] * at_x[1];  // the area at x is negative
}

}  // namespace

bool is_kept_in_one_metric(const site& v, const site& w, const site& x, const site& y) {
  const uncertain_bool quick = exceeds_zero(opposite_angles<bounded>(v, w, x, y));
  if (quick.certain()) return quick.value();
  const rational excess = opposite_angles<rational>(v, w, x, y);
  if (excess != 0) return excess > 0;
  const auto less = [](const site* a, const site* b) {
    const point &p = a->position, &q = b->position;
    return p.x < q.x || (p.x == q.x && p.y < q.y);
  };
  const site* greatest = std::max({&v, &w, &x, &y}, less);
  return greatest == &x || greatest == &y;
}

}  // namespace asterism::internal::proof_detail
