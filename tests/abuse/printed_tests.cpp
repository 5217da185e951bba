// SPDX-License-Identifier: MIT
//
// Includes sixty reports of differences, as they were printed: each report is a test.
#include <catch2/catch.hpp>

#include "asterism/kernels/batch_question.hpp"
#include "asterism/kernels/exact_kernel.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/kernels/interval_kernel.hpp"
#include "differences.inc"
