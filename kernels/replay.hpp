// SPDX-License-Identifier: MIT
//
// Writes a question as the source text of a Catch2 test that checks its answer.
#pragma once

#include <string>
#include <string_view>

#include "asterism/core/export.h"
#include "asterism/kernels/batch_question.hpp"

namespace asterism {

// Returns one TEST_CASE for the batch protocol's numbers (hexadecimal doubles: bit for bit), ready
// to be pasted into a file that includes <catch2/catch.hpp>, asterism/kernels/batch_question.hpp
// and the kernel's header. It passes when `kernel_type`, the C++ name of a class to be default
// constructed, answers `expected` or, where its answers are `uncertain`, is undecided; `answered`
// is only mentioned. The case's name ends in a hash of the record, so that names differ.
ASTERISM_EXPORT std::string replay_test(std::string_view kernel_type, const batch_record& record,
                                        int expected, int answered);

// Returns the record as a line of the batch protocol, without an end of line.
ASTERISM_EXPORT std::string record_line(const batch_record& record);

}  // namespace asterism
