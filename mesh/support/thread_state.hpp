// SPDX-License-Identifier: MIT
//
// Keeps for each thread the team and the loop that it works for, and its limit of threads.
#pragma once

#include <cstddef>

namespace asterism::internal {

struct loop_team;
struct team_loop;

// The team and the loop that a thread works for, and the limit that it has set since it joined.
struct thread_state {
  loop_team* member_of = nullptr;
  team_loop* inside = nullptr;
  std::size_t team_limit = 0;  // number of threads that the team may have
  std::size_t limit = 0;       // 0 without one
};

// Returns the state of the calling thread. Loops read it at any depth of calls.
inline thread_state& this_thread() {
  thread_local thread_state state;
  return state;
}

}  // namespace asterism::internal
