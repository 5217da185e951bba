// SPDX-License-Identifier: MIT
#include "asterism/mesh/support/thread_limit.hpp"

#include <algorithm>
#include <thread>

#include "asterism/mesh/support/thread_state.hpp"

namespace asterism::internal {

std::size_t processor_count() {
#ifdef ASTERISM_ONE_THREAD
  return 1;
#else
  static const std::size_t count = std::max(1U, std::thread::hardware_concurrency());
  return count;
#endif
}

std::size_t thread_count() {
  const thread_state& state = this_thread();
  if (state.limit != 0) return state.limit;
  return state.member_of != nullptr ? state.team_limit : processor_count();
}

thread_limit::thread_limit(std::size_t threads, std::size_t most) : before_(this_thread().limit) {
  thread_state& state = this_thread();
  if (threads == 0) return;
  const bool has_limit = state.limit != 0 || state.member_of != nullptr;
  state.limit =
      std::min({threads, std::max<std::size_t>(most, 1), has_limit ? thread_count() : threads});
}

thread_limit::~thread_limit() { this_thread().limit = before_; }

}  // namespace asterism::internal
