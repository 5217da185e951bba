// SPDX-License-Identifier: MIT
//
// Shows how far refinement has come on one line of a terminal, written over and wiped at the end.
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

  // Wipes the line; what is written next begins at its start.
  void clear();

  // Shows the state, at most ten times a second.
  void show(const mesh_progress& progress);

 private:
  bool shown_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point next_{};
};

}  // namespace asterism::apps
