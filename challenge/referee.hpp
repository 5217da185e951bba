// SPDX-License-Identifier: MIT
//
// Asks a foreign program questions of every class, and judges the answers.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "asterism/challenge/foreign_program.hpp"
#include "asterism/challenge/record_file.hpp"

namespace asterism::challenge {

// Verdict on one record.
enum class verdict : std::size_t {
  right,
  wrong,      // an integer, and not the exact one
  undecided,  // '?'
  refused,    // a line that begins with "error"
  garbage,    // a line that is none of these, or never ends
  too_few,    // the program ended without an answer
  too_many,   // it gave an answer more
  crashed,    // it ended by a signal
  hung,       // no answer in time
  not_asked   // after too many failures of the program
};
// Number of verdicts.
inline constexpr std::size_t verdict_count = 10;
// Names of the verdicts, in order.
inline constexpr std::array<std::string_view, verdict_count> verdict_names = {
    "right",   "wrong",    "undecided", "refused", "garbage",
    "too few", "too many", "crashed",   "hung",    "not asked"};

// Numbers of records by verdict, and the times of answers.
struct tally {
  std::array<std::size_t, verdict_count> of{};
  std::size_t slow = 0;  // answered, but late
  double seconds = 0;    // of the runs whose answers were taken, start of the program included

  std::size_t at(verdict v) const { return of[static_cast<std::size_t>(v)]; }
  std::size_t records() const;
  tally& operator+=(const tally& other);
};

// The first failing record of its class and kind of failure.
struct witness {
  std::string class_name;
  verdict what;
  bool slow;  // answered, but late, whatever the answer
  std::string record;
  int exact;
  std::string given;  // the answer, or how the program failed
};

// Plan of a challenge: the program and the questions.
struct challenge_plan {
  std::vector<std::string> command;
  std::vector<record_source> sources;
  std::vector<question> questions;
  record_choice records;
  run_limits limits;
  bool find_out = true;  // asks first which of the questions the program answers, and only those
};

// Number of hangs after which nothing more is asked: each costs the time limit, and more.
inline constexpr std::size_t most_hangs = 8;

// Outcome of a challenge.
struct challenge_outcome {
  std::vector<std::string> class_names, class_texts;
  std::vector<question> questions;         // asked
  std::vector<question> unknown;           // not asked: no answer to a simple one
  std::string unknown_told;                // what came for the first of them
  std::vector<std::vector<tally>> counts;  // by class, then by question
  std::vector<witness> witnesses;          // in the order of the classes
  bool lingered = false;                   // it did not end after its last answer
  bool left_behind = false;                // something that it started could not be ended
  bool gave_up = false;                    // most_hangs reached
  bool out_of_time = false;                // run_limits::whole was over before all was asked

  // True if every record was answered, rightly, and nothing is left of the program; `undecided` may
  // pass for right.
  bool all_right(bool undecided_passes) const;
  tally of_class(std::size_t which) const;
  tally of_question(std::size_t which) const;
};

// Asks the program, for plan.limits.whole seconds at most. Errors: it cannot be run.
result<challenge_outcome> challenge_program(const challenge_plan& plan);

}  // namespace asterism::challenge
