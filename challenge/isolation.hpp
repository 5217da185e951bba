// SPDX-License-Identifier: MIT
//
// Asks a foreign program a batch of questions, and finds the question at which it fails: by asking
// it alone, or by halving. The failing question is left out, and the rest asked again.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "asterism/challenge/foreign_program.hpp"

namespace asterism::challenge {

// Reply to one question, or the failure that took its place.
struct reply {
  std::optional<std::string> answer;  // empty: it failed there, or was not asked
  std::optional<run_end> failure;     // how it failed, if it did
  std::string told;                   // how it failed, in words, with what it said
  bool late = false;                  // slower than run_limits::slow
};

// Replies of a foreign program to a batch of questions, and how its runs ended.
struct batch_replies {
  std::vector<reply> replies;  // one a question
  double seconds = 0;          // of the runs whose answers were taken
  std::size_t hung = 0;        // questions at which it hung
  bool lingered = false;       // it did not end by itself after its last answer
  bool left_behind = false;    // something that it started could not be ended
  bool out_of_time = false;    // the time for the whole was over, and the rest was not asked
};

// Number of failures in one batch after which the rest is not asked. Finding one failure takes some
// ten runs.
inline constexpr std::size_t most_failures = 5;

// Asks the questions. After most_failures failures, or one hang, or when the time for the whole is
// over, the rest is not asked. A program that fails without a pattern is reported at the question
// at which the search ended.
result<batch_replies> ask_in_turn(const std::vector<std::string>& command,
                                  std::span<const std::string> questions, const run_limits& limits);

}  // namespace asterism::challenge
