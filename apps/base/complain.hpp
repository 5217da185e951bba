// SPDX-License-Identifier: MIT
//
// Ends a command with a status, and states the reason.
#pragma once

#include <iostream>

#include "asterism/apps/base/terminal.hpp"
#include "asterism/core/result.hpp"
#include "asterism/mesh/support/one_line.hpp"

namespace asterism::apps {

// 0: done. 1: goal not reached; certain results were written. 2: bad usage or input; nothing
// written.
enum exit_status : int { done = 0, not_reached = 1, refused = 2 };

// Writes the failure to standard error, in one line, and returns the status.
inline int complain(const error& failure, exit_status status) {
  std::cerr << in_colour("asterism:", ink::red, 2) << ' ' << internal::one_line(failure.message)
            << '\n';
  return status;
}

}  // namespace asterism::apps
