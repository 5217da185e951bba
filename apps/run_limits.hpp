// SPDX-License-Identifier: MIT
//
// Ends a run early: at an interrupt from the keyboard, or at a limit on time or on memory. The run
// then writes what is certain.
#pragma once

#include <chrono>
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

  // Why to end now, in half a sentence.
  std::optional<std::string> reason() const;
  static bool interrupted();

 private:
  std::optional<double> seconds_, megabytes_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace asterism::apps
