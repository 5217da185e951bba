// SPDX-License-Identifier: MIT
#include "watched_run.hpp"

namespace asterism::python {

void raised_error::keep() {
  const std::lock_guard<std::mutex> alone(lock_);
  if (!error_) error_ = std::current_exception();
}

bool raised_error::any() const {
  const std::lock_guard<std::mutex> alone(lock_);
  return error_ != nullptr;
}

void raised_error::raise() const {
  if (error_) std::rethrow_exception(error_);
}

thread_limit::thread_limit(const keywords& given) {
  if (const auto threads = given.count("threads", 1)) limit_.emplace(*threads);
}

watched_run::watched_run(const keywords& given)
    : threads_(given),
      seconds_(given.positive("max_seconds")),
      progress_(given.object("progress")) {
  if (!progress_.is_none() && PyCallable_Check(progress_.ptr()) == 0)
    throw input_error("progress: a callable is wanted");
}

// Handles Ctrl-C here, where the mesher polls whether to stop. An error in a callback ends the run,
// too.
std::optional<std::string> watched_run::reason_to_stop() {
  if (errors_.any()) return "a callback failed";
  const std::chrono::duration<double> passed = clock::now() - start_;
  const py::gil_scoped_acquire locked;
  try {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (!seconds_ || passed.count() <= *seconds_) return std::nullopt;
    return py::str(py::float_(*seconds_)).cast<std::string>() + " seconds have passed";
  } catch (...) {
    errors_.keep();
    return "interrupted";
  }
}

progress_listener watched_run::listener() {
  if (progress_.is_none()) return {};
  return [this](const mesh_progress& now) { tell(now); };
}

void watched_run::tell(const mesh_progress& now) {
  const py::gil_scoped_acquire locked;
  try {
    constexpr const char* phases[] = {"filling", "refining", "auditing"};
    py::dict state;
    state["phase"] = phases[static_cast<std::size_t>(now.phase)];
    state["sites"] = now.sites;
    state["disagreeing"] = now.disagreeing;
    state["low_angle"] = now.low_angle;
    state["too_large"] = now.too_large;
    progress_(state);
  } catch (...) {
    errors_.keep();
  }
}

}  // namespace asterism::python
