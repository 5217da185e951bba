// SPDX-License-Identifier: MIT
#include "asterism/apps/run_limits.hpp"

#include <fmt/format.h>

#include <csignal>

#include "asterism/apps/memory_account.hpp"

namespace asterism::apps {
namespace {

// A signal handler can reach nothing else.
volatile std::sig_atomic_t interrupt_noted = 0;

extern "C" void note_interrupt(int signal) {
  interrupt_noted = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

run_limits::run_limits(std::optional<double> seconds, std::optional<double> megabytes)
    : seconds_(seconds), megabytes_(megabytes) {
  interrupt_noted = 0;
  std::signal(SIGINT, note_interrupt);
  std::signal(SIGTERM, note_interrupt);
}

run_limits::~run_limits() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

bool run_limits::interrupted() { return interrupt_noted != 0; }

std::optional<std::string> run_limits::reason() const {
  if (interrupted()) return "interrupted";
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  if (seconds_ && seconds > *seconds_) return fmt::format("{:g} seconds have passed", *seconds_);
  if (lacks_memory_ && !megabytes_) return "there is not enough memory";
  if (lacks_memory_ ||
      (megabytes_ && memory_account::resident() + to_conclude() > *megabytes_ * 1e6))
    return fmt::format("more than {:g} megabytes would be in use", *megabytes_);
  return std::nullopt;
}

double run_limits::to_conclude() const {
  constexpr double bytes_a_site = 150;
  return bytes_a_site * static_cast<double>(sites_.load(std::memory_order_relaxed));
}

}  // namespace asterism::apps
