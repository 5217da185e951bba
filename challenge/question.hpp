// SPDX-License-Identifier: MIT
//
// Lists the questions for a foreign program: those of the batch protocol, and the two plane
// predicates under their usual names.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "asterism/kernels/batch_question.hpp"

namespace asterism::challenge {

// A question by its name in the batch protocol.
struct question {
  std::string_view name;
  predicate asked;
  bool plain;  // without metrics: the tensor of in_circle is not written, and is the identity
};

// Number of questions.
inline constexpr std::size_t question_count = predicate_count + 2;

// All questions, those without metrics first.
constexpr std::array<question, question_count> questions() {
  std::array<question, question_count> all{};
  all[0] = {"orient2d", predicate::orientation, true};
  all[1] = {"incircle", predicate::in_circle, true};
  for (std::size_t i = 0; i < predicate_count; ++i)
    all[i + 2] = {predicate_names[i], static_cast<predicate>(i), false};
  return all;
}

// Returns the question of that name, if there is one.
constexpr std::optional<question> question_named(std::string_view name) {
  for (const question& q : questions())
    if (q.name == name) return q;
  return std::nullopt;
}

}  // namespace asterism::challenge
