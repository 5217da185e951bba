// SPDX-License-Identifier: MIT
//
//   measure SECONDS PROGRAM ARGUMENTS...
//
// Runs the program, ends it after SECONDS, and prints as JSON what getrusage says of it. A program
// of its own because a child's peak memory starts from that of the process it was forked from:
// this one is small, a script's interpreter is not. The program's output and errors go to
// output.txt.
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace {

[[noreturn]] void become(unsigned limit, char** words) {
  const int log = open("output.txt", O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (log < 0 || dup2(log, 1) < 0 || dup2(log, 2) < 0) _exit(127);
  alarm(limit);  // the timer survives exec and ends the program
  execvp(words[0], words);
  std::perror(words[0]);
  _exit(127);
}

double seconds(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

}  // namespace

int main(int argc, char** argv) {
  const int limit = argc < 3 ? 0 : std::atoi(argv[1]);
  if (limit <= 0) {
    std::fputs("measure: SECONDS (1 or more) PROGRAM ARGUMENTS...\n", stderr);
    return 2;
  }
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child == 0) become(static_cast<unsigned>(limit), argv + 2);
  int status = 0;
  rusage usage{};
  if (child < 0 || wait4(child, &status, 0, &usage) != child) {
    std::perror("measure");
    return 2;
  }
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  const bool late = WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM;
  std::printf(R"({"status": %d, "late": %s, "seconds": %.6f, "processor": %.6f, "megabytes": %.3f})"
              "\n",
              WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), late ? "true" : "false",
              wall.count(), seconds(usage.ru_utime) + seconds(usage.ru_stime),
              static_cast<double>(usage.ru_maxrss) * 1024 / 1e6);
  return 0;
}
