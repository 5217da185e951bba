// SPDX-License-Identifier: MIT
//
// Delays signals so that none ends the program between two files of a run.
#pragma once

#include <array>
#include <csignal>

namespace asterism::apps {

// During its lifetime, signals that would end the program are only noted, if they can be. At its
// end the first noted signal is raised again, with the former handler.
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
