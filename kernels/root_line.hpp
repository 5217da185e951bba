// SPDX-License-Identifier: MIT
//
// Cuts the parameter line at the real roots of several polynomials: the distinct roots in order,
// which polynomials vanish at each, and one dyadic sample in every open section between them.
#pragma once

#include <cstdint>
#include <vector>

#include "asterism/kernels/exact_polynomial.hpp"

namespace asterism::internal::exact {

struct cut {
  real_root root;
  std::uint64_t vanishing;  // bit k: the polynomial added with tag k vanishes here
};

class root_line {
 public:
  // Cuts the line at the roots of p; the zero polynomial cuts nowhere. tag < 64.
  void add(const dense_polynomial& p, unsigned tag);
  // Returns the cuts in increasing order.
  const std::vector<cut>& cuts() const { return cuts_; }
  std::vector<cut>& cuts() { return cuts_; }
  // Returns cuts().size() + 1 samples: sample k lies strictly between cuts k-1 and k.
  std::vector<dyadic> samples();

 private:
  std::vector<cut> cuts_;
};

}  // namespace asterism::internal::exact
