// SPDX-License-Identifier: MIT
//
// Ends a run early: at an interrupt from the keyboard, or at a limit on time or on memory. The run
// then writes the results that are certain.
//
// A run ends at the next place where it polls; there are many such places. A timer watches it, in
// case an unforeseen loop takes minutes: if a run has been requested to end, and does not begin to
// write its files within the time that a conclusion takes, the program ends with status 1, and
// nothing is written. A thread in place of the timer would take 1 % of a small run: its start takes
// a tenth of a millisecond, and beside a second thread reference counts and the allocator's lists
// are locked.
#pragma once

#include <pthread.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <optional>
#include <string>

namespace asterism::apps {

class run_limits {
 public:
  // From now on the first interrupt (SIGINT, SIGTERM) is noted instead of ending the program; a
  // second one ends it. The clock starts here, for the thread that calls this, which is watched.
  // There can be one at a time.
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

  // Ends the program if the run does not end in time after a request to end. Called by signal
  // handlers alone, in any thread, and calls nothing that is not allowed in them.
  void watch();
  // Makes the timer call watch() at intervals, first in `seconds`. Allowed in signal handlers.
  void watch_from(double seconds);

 private:
  using clock = std::chrono::steady_clock;

  enum class stage { running, concluding, ending };

  double to_conclude() const;
  bool is_late() const;
  std::optional<std::string> reason_to_hurry() const;
  double seconds_to_conclude() const;
  double seconds_worked() const;
  double seconds_passed() const;
  bool is_overdue();
  [[noreturn]] void end_without_files() const;

  std::optional<double> seconds_, megabytes_;
  std::atomic<std::size_t> sites_ = 0;
  std::atomic<bool> lacks_memory_ = false;
  clock::time_point start_ = clock::now();
  clockid_t worker_clock_{};  // of the watched thread's processor time
  bool is_clock_known_ = false;
  timer_t timer_{};
  bool has_timer_ = false;
  std::string late_text_;  // the reason when the seconds have passed
  bool is_shown_on_terminal_ = false;
  // Seconds since the start, and those worked, at the first call of watch() after a request to end.
  std::atomic<double> watched_from_ = -1, worked_then_ = 0;
  std::atomic<stage> stage_ = stage::running;
};

}  // namespace asterism::apps
