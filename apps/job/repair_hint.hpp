// SPDX-License-Identifier: MIT
//
// Finds whether --repair-domain would mend a domain that is refused, for a hint.
#pragma once

#include <string>

#include "asterism/mesh/data/domain.hpp"

namespace asterism::apps {

// Result of a tried repair.
enum class repair_answer {
  mends,
  fails,
  not_known,  // it takes more work than a hint is worth
};

struct repair_hint {
  repair_answer answer = repair_answer::fails;
  std::string changes;  // in words, where it mends
};

// Tries the repair with the work of some tenths of a second. Segments that cross hundreds of
// thousands of times take minutes, where the refusal takes none.
repair_hint try_repair(const domain& refused);

}  // namespace asterism::apps
