// SPDX-License-Identifier: MIT
#pragma once

namespace asterism::bench {

// Registers batch/predicate-input/contender: batches of 8 questions against scalar kernels.
void add_batches();

}  // namespace asterism::bench
