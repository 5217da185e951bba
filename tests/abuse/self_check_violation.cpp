// SPDX-License-Identifier: MIT
//
// Interval arithmetic in the wrong rounding mode: the self-check build must abort here. Ends
// normally, and thereby fails its test, when nothing is noticed.
#include "asterism/core/floating_point_environment.hpp"
#include "asterism/core/interval.hpp"

namespace {

[[gnu::noinline]] asterism::interval sum(double a, double b) {
  return asterism::interval(a) + asterism::interval(b);
}

}  // namespace

int main() {
  const asterism::floating_point_scope scope(asterism::rounding::nearest);
  return sum(0.1, 0.2).inf() > 0 ? 0 : 1;
}
