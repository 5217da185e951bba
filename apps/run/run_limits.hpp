// SPDX-License-Identifier: MIT
//
// Ends a run early: at an interrupt from the keyboard, or at a limit on time or on memory. The run
// then writes the results that are certain.
//
// A run ends at the next place where it polls; there are many such places. A thread watches it, in
// case an unforeseen loop takes minutes: if a run has been requested to end, and does not begin to
// write its files within the time that a conclusion takes, the program ends with status 1, and
// nothing is written.
#pragma once

#include <pthread.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <ctime>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace asterism::apps {

class run_limits {
 public:
  // From now on the first interrupt (SIGINT, SIGTERM) is noted instead of ending the program; a
  // second one ends it. The clock starts here, for the thread that calls this, which is watched.
  run_limits(std::optional<double> seconds, std::optional<double> megabytes);
  ~run_limits();
  run_limits(const run_limits&) = delete;
  run_limits& operator=(const run_limits&) = delete;

  // Returns the reason to end now, in half a sentence, or nothing.
  std::optional<std::string> reason() const;
  static bool interrupted();

  // Sets the number of sites, from which the time to conclude the run is estimated.
  void expect(std::size_t sites) { sites_.store(sites, std::memory_order_relaxed); }
  // Ends the watch: files are being written, and writing is not interrupted.
  void conclude();
  // Makes `reason` return, from now on, that there is not enough memory.
  void note_want_of_memory() { lacks_memory_ = true; }

 private:
  using clock = std::chrono::steady_clock;

  double to_conclude() const;
  std::optional<std::string> reason_to_hurry() const;
  double seconds_to_conclude() const;
  double seconds_worked() const;
  void watch();

  std::optional<double> seconds_, megabytes_;
  std::atomic<std::size_t> sites_ = 0;
  std::atomic<bool> lacks_memory_ = false;
  clock::time_point start_ = clock::now();
  clockid_t worker_clock_{};  // of the watched thread's processor time
  bool is_clock_known_ = false;
  std::mutex concluding_mutex_;
  std::condition_variable concluded_;
  bool is_concluded_ = false;
  std::thread watcher_;  // the last, as it reads the others
};

}  // namespace asterism::apps
