// SPDX-License-Identifier: MIT
//
// Ends a run early: at an interrupt from the keyboard, or at a limit on time or on memory. The run
// then writes what is certain.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

namespace asterism::apps {

class run_limits {
 public:
  // From now on the first interrupt (SIGINT, SIGTERM) is noted instead of ending the program; a
  // second one ends it. The clock starts here.
  run_limits(std::optional<double> seconds, std::optional<double> megabytes);
  ~run_limits();
  run_limits(const run_limits&) = delete;
  run_limits& operator=(const run_limits&) = delete;

  // Returns why to end now, in half a sentence, or nothing.
  std::optional<std::string> reason() const;
  static bool interrupted();

  // Tells how many sites there are, for what it will take to conclude the run.
  void expect(std::size_t sites) { sites_.store(sites, std::memory_order_relaxed); }
  // Makes `reason` say from now on that there is not enough memory.
  void note_want_of_memory() { lacks_memory_ = true; }

 private:
  double to_conclude() const;

  std::optional<double> seconds_, megabytes_;
  std::atomic<std::size_t> sites_ = 0;
  bool lacks_memory_ = false;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace asterism::apps
