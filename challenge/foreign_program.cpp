// SPDX-License-Identifier: MIT
#include "asterism/challenge/foreign_program.hpp"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>

#include "asterism/challenge/kept_program.hpp"

namespace asterism::challenge {
namespace {

using clock = std::chrono::steady_clock;

double seconds_since(clock::time_point start) {
  return std::chrono::duration<double>(clock::now() - start).count();
}

// Ignores SIGPIPE: writing to a program that has ended is an error of the call.
class ignored_broken_pipe {
 public:
  ignored_broken_pipe() {
    struct sigaction ignore = {};
    ignore.sa_handler = SIG_IGN;
    ::sigaction(SIGPIPE, &ignore, &before_);
  }
  ~ignored_broken_pipe() { ::sigaction(SIGPIPE, &before_, nullptr); }
  ignored_broken_pipe(const ignored_broken_pipe&) = delete;
  ignored_broken_pipe& operator=(const ignored_broken_pipe&) = delete;

 private:
  struct sigaction before_ = {};
};

// Splits the output into lines, and records the time of each.
class answer_reader {
 public:
  answer_reader(program_run& run, std::size_t expected, double slow)
      : run_(run), expected_(expected), slow_(slow) {}

  // Returns false at the first line that is no answer: the run must then end.
  bool take(std::span<const char> bytes) {
    for (const char byte : bytes) {
      if (byte != '\n') {
        line_ += byte;
        if (line_.size() <= longest_answer) continue;
        run_.how = run_end::endless;
        return false;
      }
      if (!take_line()) return false;
    }
    return true;
  }
  // Adds the last line of the output if it has no end of line.
  bool finish() { return line_.empty() || take_line(); }
  double silence() const { return seconds_since(last_); }

 private:
  bool take_line() {
    if (run_.answers.size() == expected_) {
      run_.how = run_end::too_many;
      return false;
    }
    if (silence() > slow_) run_.slow.push_back(run_.answers.size());
    last_ = clock::now();
    run_.answers.push_back(std::move(line_));
    line_.clear();
    return true;
  }

  program_run& run_;
  std::size_t expected_;
  double slow_;
  std::string line_;
  clock::time_point last_ = clock::now();
};

// A conversation with a program: the text still to be written, and the text read.
class conversation {
 public:
  conversation(kept_program& program, program_run& run, const std::string& text,
               answer_reader& reader, std::size_t expected, const run_limits& limits)
      : program_(program),
        run_(run),
        text_(text),
        reader_(reader),
        expected_(expected),
        limits_(limits) {}

  // Writes and reads until the program has ended or must be ended.
  void hold() {
    while (program_.out.open()) {
      const bool over = program_.ended();  // seen before the pipe is emptied for the last time
      if (!step(over ? 0 : 50)) return;
      if (over) program_.out.close();
      if (waited_too_long()) return;
    }
    if (!reader_.finish()) return;
    while (!program_.ended() && !waited_too_long()) ::usleep(500);
  }

 private:
  bool step(int milliseconds) {
    std::array<pollfd, 3> ends = {pollfd{program_.out.number(), POLLIN, 0},
                                  pollfd{program_.error_out.number(), POLLIN, 0},
                                  pollfd{program_.in.number(), POLLOUT, 0}};
    if (::poll(ends.data(), ends.size(), milliseconds) < 0 && errno != EINTR) return false;
    if (ends[2].revents != 0) write_some();
    if (ends[1].revents != 0) listen();
    return ends[0].revents == 0 || read_some();
  }

  void write_some() {
    const ssize_t count =
        ::write(program_.in.number(), text_.data() + written_, text_.size() - written_);
    if (count > 0) written_ += static_cast<std::size_t>(count);
    const bool gone = count < 0 && errno != EAGAIN && errno != EINTR;
    if (gone || written_ == text_.size()) program_.in.close();
  }

  // Reads the available output; returns false if it is longer than the answers can be.
  bool read_some() {
    std::array<char, 65536> bytes;
    const ssize_t count = ::read(program_.out.number(), bytes.data(), bytes.size());
    if (count > 0) return reader_.take({bytes.data(), static_cast<std::size_t>(count)});
    if (count == 0 || (errno != EAGAIN && errno != EINTR)) program_.out.close();
    return true;
  }

  void listen() {
    std::array<char, 4096> bytes;
    const ssize_t count = ::read(program_.error_out.number(), bytes.data(), bytes.size());
    if (count > 0) run_.said.append(bytes.data(), static_cast<std::size_t>(count));
    if (run_.said.size() > 2 * longest_answer) run_.said.erase(0, longest_answer);
    if (count == 0) program_.error_out.close();
  }

  bool waited_too_long() {
    const bool all = run_.answers.size() == expected_;
    const bool is_out_of_time = clock::now() > limits_.until;
    if (!is_out_of_time && reader_.silence() <= (all ? limits_.patience : limits_.silence))
      return false;
    run_.lingered = all;
    if (!all) run_.how = is_out_of_time ? run_end::out_of_time : run_end::hung;
    return true;
  }

  kept_program& program_;
  program_run& run_;
  const std::string& text_;
  answer_reader& reader_;
  std::size_t expected_;
  const run_limits& limits_;
  std::size_t written_ = 0;
};

void note_status(program_run& run, int status, std::size_t expected) {
  if (run.how != run_end::answered || run.lingered) return;
  if (WIFSIGNALED(status)) {
    run.how = run_end::crashed;
    run.code = WTERMSIG(status);
  } else {
    run.code = WEXITSTATUS(status);
    if (run.answers.size() < expected) run.how = run_end::too_few;
  }
}

std::string last_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  const std::size_t before = text.rfind('\n');
  std::string line = text.substr(before == std::string::npos ? 0 : before + 1, 200);
  for (char& c : line)
    if (c < ' ' || c > '~') c = '?';
  return line;
}

}  // namespace

result<program_run> run_program(const std::vector<std::string>& command,
                                std::span<const std::string> questions, const run_limits& limits) {
  const ignored_broken_pipe ignored;
  std::string text;
  for (const std::string& line : questions) text += line + '\n';
  kept_program program;
  if (auto failure = program.start(command)) return *failure;
  program_run run;
  const clock::time_point start = clock::now();
  answer_reader reader(run, questions.size(), limits.slow);
  conversation(program, run, text, reader, questions.size(), limits).hold();
  run.seconds = seconds_since(start);
  run.left_behind = !program.end();
  note_status(run, program.status(), questions.size());
  run.said = last_line(run.said);
  return run;
}

namespace {

std::string ending_text(const program_run& run) {
  switch (run.how) {
    case run_end::answered:
      return "ended with status " + std::to_string(run.code);
    case run_end::too_few:
      return "ended with status " + std::to_string(run.code) + " before it had answered";
    case run_end::too_many:
      return "gave more answers than there were questions";
    case run_end::crashed:
      return "ended by signal " + std::to_string(run.code) + " (" + ::strsignal(run.code) + ")";
    case run_end::hung:
      return "gave no answer in time and was killed";
    case run_end::endless:
      return "wrote a line longer than any answer";
    case run_end::out_of_time:
      return "was killed when the time for the whole run was over";
  }
  return {};
}

}  // namespace

std::string said_at_end(const program_run& run) {
  return ending_text(run) + (run.said.empty() ? "" : ": " + run.said);
}

}  // namespace asterism::challenge
