// SPDX-License-Identifier: MIT
//
// Writes notes on changes of the input by readers and repairs, or refuses the input for such a
// change.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "asterism/core/result.hpp"

namespace asterism::apps {

struct note_options {
  bool quiet = false;   // says nothing
  bool strict = false;  // refuses the input for its first note
};

// Writes each note as a line "asterism: note: ..." to standard error. Returns a refusal with the
// first note where `how` is strict; then nothing is written.
std::optional<error> say_notes(const std::vector<std::string>& notes, const note_options& how);

}  // namespace asterism::apps
