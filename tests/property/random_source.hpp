// SPDX-License-Identifier: MIT
//
// Random numbers for laws: the same on every machine, so that a seed replays a failure.
#pragma once

#include "asterism/core/random.hpp"

namespace asterism::property {

class random_source : public internal::splitmix64 {
 public:
  using splitmix64::splitmix64;

  // True once in `one_in` times.
  bool chance(int one_in) { return integer(1, one_in) == 1; }
};

}  // namespace asterism::property
