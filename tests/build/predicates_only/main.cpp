// SPDX-License-Identifier: MIT
#include <asterism/kernels/filtered_kernel.hpp>

// Cocircular sites: no arc, and the tie is broken so that the diagonal with (1,1) loses.
int main() {
  const asterism::filtered_kernel kernel;
  const asterism::metric_tensor round = {1, 0, 1};
  const asterism::site a{{0, 0}, round}, b{{1, 0}, round}, c{{1, 1}, round}, d{{0, 1}, round};
  const bool right = kernel.edge_test(b, d, a, c) && !kernel.edge_test(a, c, b, d) &&
                     !kernel.insertion_test(a, c, b, d);
  return right ? 0 : 1;
}
