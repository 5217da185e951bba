// SPDX-License-Identifier: MIT
//
// Runs a program under a keeper, and leaves no process of it behind.
//
// The keeper is a process between this one and the program. Whatever the program starts, with
// setsid or not, becomes the keeper's child when its own parent ends (Linux: a child subreaper,
// prctl(2)), so that the keeper ends one generation after the other until it has no child. It does
// so on request, and when this process ends for any reason.
//
// Guarantees: on Linux with a list of children in /proc (CONFIG_PROC_CHILDREN, as distributions
// have it) all that descends from the program is ended, but for processes of another user, which
// may not be sent signals. Elsewhere the program's process group is. A program that forks faster
// than it can be ended is left after some seconds, which is reported.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

#include "asterism/challenge/descriptor.hpp"
#include "asterism/core/result.hpp"

namespace asterism::challenge {

class kept_program {
 public:
  kept_program() = default;
  ~kept_program() { end(); }
  kept_program(const kept_program&) = delete;
  kept_program& operator=(const kept_program&) = delete;

  // Runs a program and its arguments. Returns an error unless it runs.
  std::optional<error> start(const std::vector<std::string>& command);
  // True once the program has ended; its status, in the form of waitpid, is then kept.
  bool ended();
  int status() const { return status_; }
  // Ends the program and all processes that it started. Returns false if some could not be ended.
  bool end();

  // Our ends of the pipes to the program's standard input, output and error; they do not block.
  descriptor in, out, error_out;

 private:
  pid_t keeper_ = -1;
  descriptor orders_;   // closed, it tells the keeper to end the program
  descriptor reports_;  // the status comes from there
  int status_ = 0;
  bool over_ = false;
};

}  // namespace asterism::challenge
