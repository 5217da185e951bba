// SPDX-License-Identifier: MIT
//
// Limits the number of threads.
#pragma once

#include <tbb/global_control.h>

#include <cstddef>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace asterism::apps {

// Adds --threads, one alone in a program that was built without oneTBB. `what` names the result
// that does not depend on the number: "the mesh is".
void add_threads_option(CLI::App& app, std::size_t& threads, const std::string& what);

// Limits the number of threads during its lifetime. 0 sets no limit: there is one thread a
// processor.
class thread_limit {
 public:
  explicit thread_limit(std::size_t threads) {
    if (threads > 0) limit_.emplace(tbb::global_control::max_allowed_parallelism, threads);
  }

 private:
  std::optional<tbb::global_control> limit_;
};

}  // namespace asterism::apps
