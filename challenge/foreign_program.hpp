// SPDX-License-Identifier: MIT
//
// Runs a foreign program with lines on its standard input, reads lines from its standard output,
// and always ends it. The program may crash, hang, read nothing, write for ever or not at all.
#pragma once

#include <chrono>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "asterism/core/result.hpp"

namespace asterism::challenge {

// Limits that the program is granted.
struct run_limits {
  double silence = 10;   // seconds without an answer until it is killed
  double slow = 1;       // seconds until an answer is called slow
  double patience = 10;  // seconds from its last answer until it is killed
  double whole = 3600;   // seconds for all runs of a challenge
  // Time at which the whole challenge ends, by a clock that was started with it
  // (challenge/referee.cpp).
  std::chrono::steady_clock::time_point until = std::chrono::steady_clock::time_point::max();
};

// How a run ended.
enum class run_end {
  answered,     // as many answers as questions, and not one of the others
  too_few,      // it ended by itself before
  too_many,     // killed at the first answer that no question belongs to
  crashed,      // ended by a signal
  hung,         // killed after the silence
  endless,      // killed within a line longer than any answer
  out_of_time,  // killed when the time for the whole was over, before it had answered all
};

// Result of a run.
struct program_run {
  run_end how = run_end::answered;
  int code = 0;                      // exit status, or number of the signal
  std::vector<std::string> answers;  // lines, no more than questions
  std::vector<std::size_t> slow;     // indices of the answers that came late
  bool lingered = false;             // all answered, and killed since it did not end
  bool left_behind = false;          // something that it started could not be ended
  double seconds = 0;                // by the clock
  std::string said;                  // last line of standard error, cut when long
};

// Longest line that may be an answer, in bytes.
inline constexpr std::size_t longest_answer = 4096;

// Runs `command` (a program and its arguments) on the questions, one a line, and closes its input
// after the last. No process that it started remains afterwards, with the exceptions named in
// challenge/kept_program.hpp. A gap between answers is counted from the start or the answer before;
// if a program buffers its output, the first line of each buffer is late.
//
// Errors: no such program, or no process can be made.
result<program_run> run_program(const std::vector<std::string>& command,
                                std::span<const std::string> questions, const run_limits& limits);

// Returns words for an ending, with the program's own message: "ended by signal 11 (Segmentation
// fault)".
std::string said_at_end(const program_run& run);

}  // namespace asterism::challenge
