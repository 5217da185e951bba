// SPDX-License-Identifier: MIT
#include "asterism/challenge/kept_program.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/select.h>
#include <sys/wait.h>
#include <unistd.h>
#if defined(__linux__)
#include <sys/prctl.h>
#endif

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <span>
#include <string>
#include <system_error>
#include <utility>

#include "asterism/core/number_text.hpp"

namespace asterism::challenge {
namespace {

// The pipes of a program and its keeper.
struct all_channels {
  channel in, out, error;   // the program's
  channel failure;          // why it cannot be run
  channel orders, reports;  // the keeper's

  bool make() {
    return in.make() && out.make() && error.make() && failure.make() && orders.make() &&
           reports.make();
  }
};

// The functions from here to keep() run between fork and exec, or after a fork without exec: they
// make only calls that are allowed there, and use no memory from the heap.

[[noreturn]] void become(const std::vector<char*>& arguments, const all_channels& pipes) {
  ::setpgid(0, 0);
#if defined(__linux__)
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // the program may end its keeper
#endif
  const rlimit none = {0, 0};
  ::setrlimit(RLIMIT_CORE, &none);
  ::signal(SIGPIPE, SIG_DFL);
  ::dup2(pipes.in.read.number(), STDIN_FILENO);
  ::dup2(pipes.out.write.number(), STDOUT_FILENO);
  ::dup2(pipes.error.write.number(), STDERR_FILENO);
  ::execvp(arguments[0], arguments.data());
  const int why = errno;
  (void)!::write(pipes.failure.write.number(), &why, sizeof why);
  ::_exit(127);
}

// Sends SIGKILL to each number of a list of processes, such as "12 345 ".
class list_killer {
 public:
  void take(std::span<const char> bytes) {
    for (const char c : bytes) {
      if (c >= '0' && c <= '9')
        number_ = 10 * number_ + (c - '0');
      else
        finish();
    }
  }
  void finish() {
    if (number_ > 1) ::kill(number_, SIGKILL);
    number_ = 0;
  }

 private:
  pid_t number_ = 0;
};

// Sends SIGKILL to the children of this process. Returns false where the system does not list them.
bool kill_children() {
  const int list = ::open("/proc/thread-self/children", O_RDONLY | O_CLOEXEC);
  if (list < 0) return false;
  list_killer killer;
  std::array<char, 4096> bytes;
  for (ssize_t count = 0; (count = ::read(list, bytes.data(), bytes.size())) > 0;)
    killer.take({bytes.data(), static_cast<std::size_t>(count)});
  killer.finish();
  ::close(list);
  return true;
}

// Collects the statuses of the children that have ended, and reports the program's. Returns false
// once there is no child left.
bool reap(pid_t program, int reports) {
  int status = 0;
  pid_t ended = 0;
  while ((ended = ::waitpid(-1, &status, WNOHANG)) > 0)
    if (ended == program) (void)!::write(reports, &status, sizeof status);
  return ended == 0;
}

// Ends the children, then their own children, and so on. Returns false if some remain.
bool end_all(pid_t program, int reports) {
  constexpr int rounds = 5000;  // about as many milliseconds
  for (int round = 0; round < rounds; ++round) {
    if (!kill_children()) ::kill(-program, SIGKILL);
    if (!reap(program, reports)) return true;
    ::usleep(round < 20 ? 50 : 1000);
  }
  return false;
}

extern "C" void wake(int) {}

// Ignores signals of a terminal or a shell. Blocks SIGCHLD, except in calls that are given the
// returned mask.
sigset_t prepare_signals() {
  for (const int each : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE}) ::signal(each, SIG_IGN);
  struct sigaction woken = {};
  woken.sa_handler = wake;
  ::sigaction(SIGCHLD, &woken, nullptr);
  sigset_t child, asleep;
  ::sigemptyset(&child);
  ::sigaddset(&child, SIGCHLD);
  ::sigprocmask(SIG_BLOCK, &child, &asleep);
  ::sigdelset(&asleep, SIGCHLD);
  return asleep;
}

// Waits until the pipe of orders is closed.
void keep_until_told(pid_t program, int orders, int reports, const sigset_t& asleep) {
  while (true) {
    reap(program, reports);
    fd_set told;
    FD_ZERO(&told);
    FD_SET(orders, &told);
    if (::pselect(orders + 1, &told, nullptr, nullptr, nullptr, &asleep) > 0) return;
    if (errno != EINTR) return;
  }
}

// Runs the keeper, from its fork to its end. Its exit status says whether all processes were ended.
[[noreturn]] void keep(const std::vector<char*>& arguments, all_channels& pipes) {
  ::setpgid(0, 0);
#if defined(__linux__)
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);
#endif
  const pid_t program = ::fork();
  if (program == 0) become(arguments, pipes);
  if (program < 0) {
    const int why = errno;
    (void)!::write(pipes.failure.write.number(), &why, sizeof why);
    ::_exit(0);
  }
  ::setpgid(program, program);
  const sigset_t asleep = prepare_signals();
  for (channel* const theirs : {&pipes.in, &pipes.out, &pipes.error, &pipes.failure}) {
    theirs->read.close();
    theirs->write.close();
  }
  pipes.orders.write.close();
  const int reports = pipes.reports.write.number();
  keep_until_told(program, pipes.orders.read.number(), reports, asleep);
  ::_exit(end_all(program, reports) ? 0 : 1);
}

// Returns what to do about a program that cannot be run; empty if that is not known.
std::string way_to_run(const std::string& program) {
  std::error_code ignored;
  const std::filesystem::path here = program;
  if (std::filesystem::is_directory(here, ignored)) return "; it is a directory";
  if (!std::filesystem::exists(here, ignored)) return "";
  if (!here.has_parent_path()) return "; a file of this folder is called ./" + program;
  return "; `chmod +x " + program +
         "` lets it be run, and so does naming what runs it, as python3 " + program;
}

}  // namespace

std::optional<error> kept_program::start(const std::vector<std::string>& command) {
  const std::string name = internal::quoted_token(command.front());
  all_channels pipes;
  if (!pipes.make()) return error{"no process can be made for " + name};
  std::vector<char*> arguments;
  arguments.reserve(command.size() + 1);
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  keeper_ = ::fork();
  if (keeper_ == 0) keep(arguments, pipes);
  if (keeper_ < 0) return error{"no process can be made for " + name};
  orders_.reset(pipes.orders.write.release());
  reports_.reset(pipes.reports.read.release());
  pipes.failure.write.close();
  pipes.reports.write.close();
  int why = 0;
  if (::read(pipes.failure.read.number(), &why, sizeof why) == static_cast<ssize_t>(sizeof why))
    return error{name + " cannot be run: " + std::strerror(why) + way_to_run(command.front())};
  in.reset(pipes.in.write.release());
  out.reset(pipes.out.read.release());
  error_out.reset(pipes.error.read.release());
  for (const descriptor* const ours : {&in, &out, &error_out, &reports_})
    ::fcntl(ours->number(), F_SETFL, O_NONBLOCK);
  return std::nullopt;
}

bool kept_program::ended() {
  if (over_ || !reports_.open()) return over_;
  int status = 0;
  const ssize_t count = ::read(reports_.number(), &status, sizeof status);
  if (count < 0) return false;  // nothing yet
  over_ = true;
  // Treats a missing report as the end of the keeper, and of the program with it.
  status_ = count == static_cast<ssize_t>(sizeof status) ? status : SIGKILL;
  return true;
}

bool kept_program::end() {
  if (keeper_ <= 0) return true;
  orders_.close();
  int told = 0;
  while (::waitpid(keeper_, &told, 0) < 0 && errno == EINTR) {
  }
  keeper_ = -1;
  ended();
  return WIFEXITED(told) && WEXITSTATUS(told) == 0;
}

}  // namespace asterism::challenge
