// SPDX-License-Identifier: MIT
#include "asterism/apps/run/held_signals.hpp"

namespace asterism::apps {
namespace {

// Global variable, since a signal handler can reach nothing else.
volatile std::sig_atomic_t held = 0;

extern "C" void note_held(int signal) {
  if (held == 0) held = signal;
}

}  // namespace

held_signals::held_signals() {
  held = 0;
  struct sigaction noted {};
  noted.sa_handler = note_held;
  noted.sa_flags = SA_RESTART;
  sigemptyset(&noted.sa_mask);
  for (std::size_t i = 0; i < held_.size(); ++i) {
    sigaction(held_[i], nullptr, &before_[i]);
    // Leaves an ignored signal ignored, as by nohup.
    if (before_[i].sa_handler != SIG_IGN) sigaction(held_[i], &noted, nullptr);
  }
}

held_signals::~held_signals() {
  for (std::size_t i = 0; i < held_.size(); ++i) sigaction(held_[i], &before_[i], nullptr);
  if (held != 0) std::raise(held);
}

}  // namespace asterism::apps
