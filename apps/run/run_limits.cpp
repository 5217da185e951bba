// SPDX-License-Identifier: MIT
#include "asterism/apps/run/run_limits.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <string_view>

#include "asterism/apps/base/complain.hpp"
#include "asterism/apps/run/memory_account.hpp"

namespace asterism::apps {
namespace {

// Global variable, since a signal handler can reach nothing else. Atomic without a lock, since
// other threads than the one that is interrupted read it.
std::atomic<int> interrupt_noted = 0;
std::atomic<run_limits*> watched = nullptr;
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<double>::is_always_lock_free &&
              std::atomic<run_limits*>::is_always_lock_free);

constexpr double between_looks = 0.02;  // seconds

extern "C" void look_again(int /*signal*/) {
  const int before = errno;
  if (run_limits* const limits = watched) limits->watch();
  errno = before;
}

extern "C" void note_interrupt(int signal) {
  const int before = errno;
  interrupt_noted = 1;
  std::signal(signal, SIG_DFL);
  if (run_limits* const limits = watched) limits->watch_from(between_looks);
  errno = before;
}

// Converts seconds to the system's structure, clamped to 1 ns to 1e9 s: a longer time may overflow,
// and 0 would stop a timer.
std::timespec time_of(double seconds) {
  constexpr double least = 1e-9, most = 1e9;
  const double taken = std::clamp(seconds, least, most);
  const auto whole = static_cast<std::time_t>(taken);
  return {whole, static_cast<long>(1e9 * (taken - static_cast<double>(whole)))};
}

// Returns whether there is a timer that sends `signal`, for which look_again() is called.
bool make_timer(int signal, timer_t& timer) {
  struct sigaction action {};
  action.sa_handler = look_again;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigevent event{};
  event.sigev_notify = SIGEV_SIGNAL;
  event.sigev_signo = signal;
  return sigaction(signal, &action, nullptr) == 0 &&
         timer_create(CLOCK_MONOTONIC, &event, &timer) == 0;
}

void say(std::string_view text) {
  const auto ignored = ::write(STDERR_FILENO, text.data(), text.size());
  static_cast<void>(ignored);
}

}  // namespace

run_limits::run_limits(std::optional<double> seconds, std::optional<double> megabytes)
    : seconds_(seconds), megabytes_(megabytes) {
  interrupt_noted = 0;
  is_clock_known_ = pthread_getcpuclockid(pthread_self(), &worker_clock_) == 0;
  is_shown_on_terminal_ = isatty(STDERR_FILENO) != 0;
  if (seconds_) late_text_ = fmt::format("{:g} seconds have passed", *seconds_);
  has_timer_ = make_timer(SIGRTMIN, timer_);
  watched = this;
  std::signal(SIGINT, note_interrupt);
  std::signal(SIGTERM, note_interrupt);
  if (seconds_) watch_from(*seconds_);
}

// The handler of the timer's signal stays: one that is still to come would end the program.
run_limits::~run_limits() {
  conclude();
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  watched = nullptr;
  if (has_timer_) timer_delete(timer_);
}

bool run_limits::interrupted() { return interrupt_noted != 0; }

double run_limits::seconds_passed() const {
  return std::chrono::duration<double>(clock::now() - start_).count();
}

bool run_limits::is_late() const { return seconds_ && seconds_passed() > *seconds_; }

// Returns the reason to end, other than memory.
std::optional<std::string> run_limits::reason_to_hurry() const {
  if (interrupted()) return "interrupted";
  if (is_late()) return late_text_;
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
  stage before = stage::running;
  stage_.compare_exchange_strong(before, stage::concluding);
  while (before == stage::ending) pause();  // another thread ends the program
  const itimerspec never{};
  if (has_timer_) timer_settime(timer_, 0, &never, nullptr);
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
  return seconds_passed();
}

void run_limits::watch_from(double seconds) {
  const itimerspec when = {time_of(between_looks), time_of(seconds)};
  if (has_timer_) timer_settime(timer_, 0, &when, nullptr);
}

// Returns whether the run had its time after a request to end. The time is processor time of the
// run, so that no mesh is lost on a busy machine; a run that waits for a file or a pipe is given a
// few times as long in wall time.
bool run_limits::is_overdue() {
  constexpr double times_waiting = 4;
  if (!interrupted() && !is_late()) return false;
  if (watched_from_ < 0) {
    worked_then_ = seconds_worked();
    watched_from_ = seconds_passed();
  }
  return seconds_worked() - worked_then_ >= seconds_to_conclude() ||
         seconds_passed() - watched_from_ >= times_waiting * seconds_to_conclude();
}

void run_limits::watch() {
  stage before = stage::running;
  if (is_overdue() && stage_.compare_exchange_strong(before, stage::ending)) end_without_files();
}

void run_limits::end_without_files() const {
  if (is_shown_on_terminal_) say("\r\033[K");
  say("asterism: not reached: stopped: ");
  say(interrupted() ? "interrupted" : std::string_view(late_text_));
  say(", and nothing was certain yet; nothing is written\n");
  _exit(not_reached);
}

double run_limits::to_conclude() const {
  constexpr double bytes_a_site = 150;
  return bytes_a_site * static_cast<double>(sites_.load(std::memory_order_relaxed));
}

}  // namespace asterism::apps
