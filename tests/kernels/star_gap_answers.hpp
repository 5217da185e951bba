// SPDX-License-Identifier: MIT
//
// Evaluates a gap of a star, and compares its answers with those of the exact arithmetics.
#pragma once

#include <catch2/catch.hpp>
#include <cstdint>

#include "asterism/kernels/star_gap.hpp"
#include "gap_questions.hpp"

namespace asterism::gap_questions {

inline uncertain_bool ask(const question& q) { return star_gap(q.v, q.y, q.x).accepts(q.w); }

// Moves w along its ray to the last place where the gap decides the question, on either side.
inline question at_the_border_of_knowledge(const question& q, bool from_yes) {
  const star_gap gap(q.v, q.y, q.x);
  return moved_to_border(q, from_yes ? 0.05 : 20, 1, [&](const question& moved) {
    return gap.accepts(moved.w).certainly(from_yes);
  });
}

inline void check_right(const question& q, const uncertain_bool& answer, std::uint64_t replay) {
  if (!answer.certain()) return;
  INFO("replay: sequence{" << replay << "}");
  CHECK(answer.value() == second_route(q));
}

}  // namespace asterism::gap_questions
