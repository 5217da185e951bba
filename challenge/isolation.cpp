// SPDX-License-Identifier: MIT
#include "asterism/challenge/isolation.hpp"

#include <algorithm>

namespace asterism::challenge {
namespace {

class search {
 public:
  search(const std::vector<std::string>& command, std::span<const std::string> questions,
         const run_limits& limits)
      : command_(command), questions_(questions), limits_(limits) {
    all_.replies.resize(questions.size());
  }

  std::optional<error> run() {
    std::size_t from = 0, failures = 0;
    while (from < questions_.size() && failures < most_failures && all_.hung == 0) {
      const auto whole = ask(from, questions_.size());
      if (!whole) return whole.failure();
      if (whole.value().how == run_end::answered) {
        take(whole.value(), from, questions_.size());
        return std::nullopt;
      }
      if (all_.out_of_time) {
        take(whole.value(), from, from + whole.value().answers.size());
        return std::nullopt;
      }
      const auto at = first_failure(from, whole.value());
      if (!at) return at.failure();
      if (all_.out_of_time) return std::nullopt;
      from = at.value() + 1;
      ++failures;
    }
    return std::nullopt;
  }

  batch_replies all() && { return std::move(all_); }

 private:
  result<program_run> ask(std::size_t from, std::size_t to) {
    auto run = run_program(command_, questions_.subspan(from, to - from), limits_);
    if (!run) return run;
    all_.left_behind = all_.left_behind || run.value().left_behind;
    all_.out_of_time = all_.out_of_time || run.value().how == run_end::out_of_time;
    return run;
  }

  void take(const program_run& run, std::size_t from, std::size_t to) {
    all_.seconds += run.seconds;
    all_.lingered = all_.lingered || run.lingered;
    for (std::size_t i = from; i < to; ++i) all_.replies[i].answer = run.answers[i - from];
    for (const std::size_t i : run.slow)
      if (from + i < to) all_.replies[from + i].late = true;
  }

  void fail(std::size_t at, const program_run& run) {
    reply& r = all_.replies[at];
    r.failure = run.how;
    r.told = said_at_end(run);
    all_.hung += run.how == run_end::hung ? 1 : 0;
  }

  // Finds the first failing question of a run that asked all questions from `from` on, and takes
  // the answers before it, which are valid. The result is meaningless if time runs out first.
  result<std::size_t> first_failure(std::size_t from, const program_run& failed) {
    const std::size_t answered = failed.answers.size();
    const std::size_t rest = questions_.size() - from;
    // Assumes that a program which writes each answer at once fails at the first question without
    // one.
    if (failed.how != run_end::too_many && answered < rest) {
      auto alone = ask(from + answered, from + answered + 1);
      if (!alone || alone.value().how != run_end::answered) {
        if (!alone) return alone.failure();
        if (all_.out_of_time) return from;
        take(failed, from, from + answered);
        fail(from + answered, alone.value());
        return from + answered;
      }
    }
    return halved(from, failed);
  }

  // Finds the first failing question by bisection: among the questions from `from` on, the first
  // `good` are answered well as a batch, the first `bad` are not.
  result<std::size_t> halved(std::size_t from, program_run failed) {
    std::size_t good = 0, bad = questions_.size() - from;
    program_run well;
    while (bad - good > 1) {
      const std::size_t middle = good + (bad - good) / 2;
      auto run = ask(from, from + middle);
      if (!run) return run.failure();
      if (all_.out_of_time) return from;
      const bool answered = run.value().how == run_end::answered;
      (answered ? good : bad) = middle;
      (answered ? well : failed) = std::move(run.value());
    }
    take(well, from, from + good);
    fail(from + good, failed);
    return from + good;
  }

  const std::vector<std::string>& command_;
  std::span<const std::string> questions_;
  const run_limits& limits_;
  batch_replies all_;
};

}  // namespace

result<batch_replies> ask_in_turn(const std::vector<std::string>& command,
                                  std::span<const std::string> questions,
                                  const run_limits& limits) {
  search asked(command, questions, limits);
  if (auto failure = asked.run()) return *failure;
  return std::move(asked).all();
}

}  // namespace asterism::challenge
