// SPDX-License-Identifier: MIT
//
// Answers records of the batch protocol with the predicates of the single file: reads standard
// input.
#include <iostream>

#include "asterism_predicates.h"

int main() {
  std::ios::sync_with_stdio(false);
  asterism::batch_evaluator evaluator(asterism::kernel_choice::filtered);
  evaluator.answer_all(std::cin, std::cout);
  return evaluator.statistics().errors == 0 ? 0 : 1;
}
