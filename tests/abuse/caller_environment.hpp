// SPDX-License-Identifier: MIT
//
// A caller's floating-point environment: set, read, compared. Implemented out of line, so that a
// caller compiled with any options does the same.
#pragma once

namespace asterism::abuse {

struct caller_environment {
  int rounding = 0;          // of <cfenv>
  bool flushes = false;      // FTZ and DAZ, where the processor has them
  unsigned control = 0;      // the SSE control bits, when read
  unsigned x87_control = 0;  // the x87 control word, when read
  friend bool operator==(const caller_environment&, const caller_environment&) = default;
};

// Environments of a caller, the one that programs start with first.
void set_default_environment();
void set_environment(int rounding, bool flushes);
caller_environment current_environment();

}  // namespace asterism::abuse
