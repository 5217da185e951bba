// SPDX-License-Identifier: MIT
#include "asterism/apps/run_limits.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

namespace asterism::apps {
namespace {

// A signal handler can reach nothing else.
volatile std::sig_atomic_t interrupt_noted = 0;

extern "C" void note_interrupt(int signal) {
  interrupt_noted = 1;
  std::signal(signal, SIG_DFL);
}

// Zero where the system does not tell.
double resident_megabytes() {
  std::ifstream status("/proc/self/statm");
  double size = 0, resident = 0;
  if (!(status >> size >> resident)) return 0;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
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
  if (megabytes_ && resident_megabytes() > *megabytes_)
    return fmt::format("more than {:g} megabytes are in use", *megabytes_);
  return std::nullopt;
}

}  // namespace asterism::apps
