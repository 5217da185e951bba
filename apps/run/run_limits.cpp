// SPDX-License-Identifier: MIT
#include "asterism/apps/run/run_limits.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <utility>

#include "asterism/apps/base/complain.hpp"
#include "asterism/apps/run/memory_account.hpp"

namespace asterism::apps {
namespace {

// Global variable, since a signal handler can reach nothing else. Atomic without a lock, since
// other threads than the one that is interrupted read it.
std::atomic<int> interrupt_noted = 0;
static_assert(std::atomic<int>::is_always_lock_free);

extern "C" void note_interrupt(int signal) {
  interrupt_noted = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

run_limits::run_limits(std::optional<double> seconds, std::optional<double> megabytes)
    : seconds_(seconds), megabytes_(megabytes) {
  interrupt_noted = 0;
  is_clock_known_ = pthread_getcpuclockid(pthread_self(), &worker_clock_) == 0;
  std::signal(SIGINT, note_interrupt);
  std::signal(SIGTERM, note_interrupt);
  watcher_ = std::thread([this] { watch(); });
}

run_limits::~run_limits() {
  conclude();
  watcher_.join();
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

bool run_limits::interrupted() { return interrupt_noted != 0; }

// Returns the reason to end, other than memory.
std::optional<std::string> run_limits::reason_to_hurry() const {
  if (interrupted()) return "interrupted";
  const double seconds = std::chrono::duration<double>(clock::now() - start_).count();
  if (seconds_ && seconds > *seconds_) return fmt::format("{:g} seconds have passed", *seconds_);
  return std::nullopt;
}

std::optional<std::string> run_limits::reason() const {
  if (auto why = reason_to_hurry()) return why;
  if (lacks_memory_ && !megabytes_) return "there is not enough memory";
  if (lacks_memory_ ||
      (megabytes_ && memory_account::resident() + to_conclude() > *megabytes_ * 1e6))
    return fmt::format("more than {:g} megabytes would be in use", *megabytes_);
  return std::nullopt;
}

void run_limits::conclude() {
  {
    const std::lock_guard lock(concluding_mutex_);
    is_concluded_ = true;
  }
  concluded_.notify_all();
}

// Returns the seconds between a request to end and the writing of files: the audit of the present
// mesh, without its stars, and its measures take up to twenty microseconds a site.
double run_limits::seconds_to_conclude() const {
  constexpr double at_least = 0.7, for_a_site = 2e-5;
  return at_least + for_a_site * static_cast<double>(sites_.load(std::memory_order_relaxed));
}

// Returns the processor time of the watched thread; the time since the start where there is none.
double run_limits::seconds_worked() const {
  std::timespec now{};
  if (is_clock_known_ && clock_gettime(worker_clock_, &now) == 0)
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  return std::chrono::duration<double>(clock::now() - start_).count();
}

// Ends the program if a run does not end in time after a request to end. The time is processor time
// of the run, so that no mesh is lost on a busy machine; a run that waits for a file or a pipe is
// given a few times as long in wall time.
void run_limits::watch() {
  constexpr double times_waiting = 4;
  constexpr std::chrono::milliseconds between{20};
  std::optional<std::pair<clock::time_point, double>> told;
  std::unique_lock lock(concluding_mutex_);
  while (!concluded_.wait_for(lock, between, [this] { return is_concluded_; })) {
    const auto why = reason_to_hurry();
    if (!why) continue;
    if (!told) told.emplace(clock::now(), seconds_worked());
    const double waited = std::chrono::duration<double>(clock::now() - told->first).count();
    const double worked = seconds_worked() - told->second;
    if (worked < seconds_to_conclude() && waited < times_waiting * seconds_to_conclude()) continue;
    const std::string said = fmt::format(
        "{}asterism: not reached: stopped: {}, and nothing was certain yet; nothing is written\n",
        isatty(STDERR_FILENO) != 0 ? "\r\033[K" : "", *why);
    const auto ignored = ::write(STDERR_FILENO, said.data(), said.size());
    static_cast<void>(ignored);
    _exit(not_reached);
  }
}

double run_limits::to_conclude() const {
  constexpr double bytes_a_site = 150;
  return bytes_a_site * static_cast<double>(sites_.load(std::memory_order_relaxed));
}

}  // namespace asterism::apps
