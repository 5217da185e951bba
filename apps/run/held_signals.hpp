// SPDX-License-Identifier: MIT
//
// Keeps a signal from ending the program between two files of a run.
#pragma once

#include <array>
#include <csignal>

namespace asterism::apps {

// While it lives, signals that would end the program and can be held are only noted. The first that
// came is raised again at the end, to whatever was set before.
class held_signals {
 public:
  held_signals();
  ~held_signals();
  held_signals(const held_signals&) = delete;
  held_signals& operator=(const held_signals&) = delete;

 private:
  static constexpr std::array held_ = {SIGHUP,  SIGINT,    SIGTERM, SIGQUIT, SIGPIPE, SIGALRM,
                                       SIGXCPU, SIGVTALRM, SIGPROF, SIGUSR1, SIGUSR2};
  std::array<struct sigaction, held_.size()> before_{};
};

}  // namespace asterism::apps
