// SPDX-License-Identifier: MIT
//
// answers_to_nearest FILE: answers the file's records with a library that has no directed rounding.
// Writes to standard error how many questions each tier decided.
#include <fstream>
#include <iostream>

#include "asterism/core/directed_rounding.hpp"
#include "asterism/kernels/batch_protocol.hpp"

static_assert(!ASTERISM_DIRECTED_ROUNDING, "tells nothing about arithmetic to nearest");

int main(int count, char** arguments) {
  std::ifstream in(count == 2 ? arguments[1] : "");
  if (!in) return 2;
  asterism::batch_evaluator evaluator(asterism::kernel_choice::filtered);
  evaluator.answer_all(in, std::cout);
  asterism::write_statistics(std::cerr, evaluator.statistics());
  return evaluator.statistics().errors == 0 ? 0 : 1;
}
