// SPDX-License-Identifier: MIT
//
// The classes of input on which predicates are known to fail, as records of the batch protocol.
// Deterministic: class and seed name a record for ever.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "asterism/kernels/batch_question.hpp"
#include "asterism/tests/property/random_source.hpp"

namespace asterism::abuse {

using property::random_source;

// The numbers that a record is cut from: four sites, a point for the predicates that want one, and
// a tensor for is_spd, which may be anything.
struct scene {
  std::array<site, 4> sites;
  point at;
  metric_tensor tensor;
};

struct input_class {
  std::string_view name;
  // May return a scene that is not valid: draw_record tries again.
  scene (*attempt)(random_source&);
};

std::span<const input_class> input_classes();

// Finite numbers, positive definite metrics, four distinct positions.
bool is_valid(const scene& s);

// Returns the record of one predicate, from a valid scene.
batch_record cut_record(predicate question, const scene& s);

// Returns a valid record of this class.
batch_record draw_record(const input_class& from, predicate question, random_source& random);

}  // namespace asterism::abuse
