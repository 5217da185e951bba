// SPDX-License-Identifier: MIT
//
// Reports of differences are tests: this includes sixty as they were printed.
#include <catch2/catch.hpp>

#include "asterism/kernels/batch_question.hpp"
#include "asterism/kernels/exact_kernel.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/kernels/interval_kernel.hpp"
#include "differences.inc"
