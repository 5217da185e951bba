// SPDX-License-Identifier: MIT
//
// Declares a caller of the predicates: one translation unit (abuse_caller.cpp) that is compiled
// many times, with compilers and options that differ from the library's.
#pragma once

#include "asterism/kernels/batch_question.hpp"

namespace asterism::abuse {

struct caller_answer {
  int by_class = 0;  // answer of filtered_kernel
  int by_c_api = 0;  // answer of the C function, valid when its status is ASTERISM_OK
  int status = 0;    // of the C function
  // The first tier in the caller's own translation unit: empty where it is undecided, and where
  // the caller is compiled with -ffast-math, which its headers refuse.
  uncertain_int by_first_tier;
  bool kept_by_class = true;  // the environment was the same after the call
  bool kept_by_c_api = true;
  bool kept_by_first_tier = true;
};

// Evaluates under the floating-point environment that is set.
using caller = caller_answer (*)(const batch_record&);

struct named_caller {
  const char* name;
  caller ask;
};

}  // namespace asterism::abuse
