// SPDX-License-Identifier: MIT
//
// Defines scenes, from which questions are made: four sites, a point and a tensor, made by an input
// class. Deterministic: class and seed determine a record for ever.
#pragma once

#include <array>
#include <string>

#include "asterism/challenge/question.hpp"
#include "asterism/core/random.hpp"
#include "asterism/core/site.hpp"
#include "asterism/kernels/batch_question.hpp"

namespace asterism::challenge {

using random_source = internal::splitmix64;

// Four sites, a point for the predicates that need one, and a tensor for is_spd, which may be
// any.
struct scene {
  std::array<site, 4> sites;
  point at;
  metric_tensor tensor;
};

// A way to make scenes.
struct input_class {
  std::string_view name;  // as on the command line
  std::string_view text;  // a sentence for people
  // Makes a scene. It may be invalid: draw_record tries again.
  scene (*attempt)(random_source&);
};

// True if all numbers are finite, the sites' metrics positive definite, the four positions
// distinct.
bool is_valid(const scene& s);

// Returns the record of one predicate, from a valid scene.
batch_record cut_record(predicate question, const scene& s);

// Returns a valid record of this class. For a plain question (in the plane) the metric of
// `in_circle` is left out of its text.
batch_record draw_record(const input_class& from, predicate question, random_source& random);

// Writes the record as a line of the batch protocol, without an end of line.
std::string record_text(const question& asked, const batch_record& record, bool decimal);

}  // namespace asterism::challenge
