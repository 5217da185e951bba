// SPDX-License-Identifier: MIT
#include "asterism/apps/options/thread_limit.hpp"

#include <CLI/CLI.hpp>
#include <cstdint>

#include "asterism/apps/options/option_values.hpp"

namespace asterism::apps {

void add_threads_option(CLI::App& app, std::size_t& threads, const std::string& what) {
#ifdef ASTERISM_ONE_THREAD
  constexpr std::uint64_t most = 1;
#else
  constexpr std::uint64_t most = 1024;
#endif
  add_count(
      app, "--threads", 1, most,
      [&threads](std::uint64_t n) { threads = static_cast<std::size_t>(n); },
      "Threads to use (default: one a processor); " + what + " the same for any number")
      ->type_name("N");
}

}  // namespace asterism::apps
