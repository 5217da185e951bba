// SPDX-License-Identifier: MIT
//
// Shows the progress of refinement on one line of a terminal, which is overwritten and finally
// cleared.
#pragma once

#include <chrono>

#include "asterism/mesh/mesher.hpp"

namespace asterism::apps {

class progress_line {
 public:
  // Shows nothing when `wanted` is false or standard error is no terminal.
  explicit progress_line(bool wanted);
  ~progress_line();
  progress_line(const progress_line&) = delete;
  progress_line& operator=(const progress_line&) = delete;

  // Clears the line; the next output begins at its start.
  void clear();

  // Shows the state, at most ten times a second.
  void show(const mesh_progress& progress);

 private:
  bool shown_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point next_{};
};

}  // namespace asterism::apps
