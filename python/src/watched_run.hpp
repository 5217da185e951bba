// SPDX-License-Identifier: MIT
//
// Watches a run made without the interpreter's lock: handles Ctrl-C, limits on time and threads,
// calls of `progress`, and exceptions of Python callables.
#pragma once

#include <chrono>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

#include "arguments.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/support/thread_limit.hpp"

namespace asterism::python {

// Keeps what Python raised in a callback until the run has ended.
class raised_error {
 public:
  void keep();
  bool any() const;
  // With the interpreter's lock.
  void raise() const;

 private:
  mutable std::mutex lock_;
  std::exception_ptr error_;
};

// Uses as many threads as the keyword `threads` says while the object lives; else one for each
// processor.
class thread_limit {
 public:
  explicit thread_limit(const keywords& given);

 private:
  std::optional<internal::thread_limit> limit_;
};

// The keywords are threads, max_seconds and progress. The clock starts when it is made.
class watched_run {
 public:
  explicit watched_run(const keywords& given);

  // Returns a reason to end now, or nothing. Any thread may call it, without the interpreter's
  // lock.
  std::optional<std::string> reason_to_stop();
  cancellation stop() {
    return [this] { return reason_to_stop(); };
  }
  // Empty if there is no callback.
  progress_listener listener();
  raised_error& errors() { return errors_; }

 private:
  using clock = std::chrono::steady_clock;
  void tell(const mesh_progress& now);

  thread_limit threads_;
  std::optional<double> seconds_;
  clock::time_point start_ = clock::now();
  py::object progress_;
  raised_error errors_;
};

}  // namespace asterism::python
