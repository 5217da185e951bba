// SPDX-License-Identifier: MIT
//
// The option --threads.
#pragma once

#include <cstddef>
#include <string>

#include "asterism/mesh/support/thread_limit.hpp"  // IWYU pragma: export

namespace CLI {
class App;
}

namespace asterism::apps {

// Adds --threads, one alone in a program that was built without threads. `what` names the result
// that does not depend on the number: "the mesh is".
void add_threads_option(CLI::App& app, std::size_t& threads, const std::string& what);

using internal::thread_limit;

}  // namespace asterism::apps
