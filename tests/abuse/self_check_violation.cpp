// SPDX-License-Identifier: MIT
//
// Does interval arithmetic in the wrong rounding mode: the self-check build must abort here, and
// the abort is this program's success. Exit status 1 if no violation is noticed.
#include <csignal>
#include <cstdlib>

#include "asterism/core/floating_point_environment.hpp"
#include "asterism/core/interval.hpp"

namespace {

[[gnu::noinline]] asterism::interval sum(double a, double b) {
  return asterism::interval(a) + asterism::interval(b);
}

}  // namespace

int main() {
  if (std::signal(SIGABRT, [](int) { std::_Exit(0); }) == SIG_ERR) return 2;
  const asterism::floating_point_scope scope(asterism::rounding::nearest);
  return sum(0.1, 0.2).inf() > 0 ? 1 : 2;
}
