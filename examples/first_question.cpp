// SPDX-License-Identifier: MIT
//
// One question to the predicates: does the diagonal v-w belong into v's star, between x and y?
#include <asterism/kernels/filtered_kernel.hpp>
#include <iostream>

int main() {
  const asterism::metric_tensor round = {1, 0, 1};
  const asterism::site v{{0, 0}, round}, w{{1, 1}, round}, x{{1, 0}, round}, y{{0, 1}, round};

  asterism::tier_counters decided;
  const asterism::filtered_kernel kernel(decided);
  // The four sites lie on one circle: the arc of v and w is a single point, which is not enough...
  std::cout << "without ties broken: " << kernel.insertion_test(v, w, x, y) << '\n';
  // ... and the tie goes to one of the diagonals, the same one seen from every corner.
  const bool diagonal = kernel.edge_test(v, w, x, y), other = kernel.edge_test(x, y, v, w);
  std::cout << "v-w: " << diagonal << ", x-y: " << other << '\n';

  const auto exact = decided.at(asterism::predicate::edge_test, asterism::tier::exact);
  std::cout << exact << " of 2 edge tests needed exact arithmetic\n";
  return diagonal != other ? 0 : 1;
}
