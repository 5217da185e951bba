// SPDX-License-Identifier: MIT
#include "asterism/apps/base/notes.hpp"

#include <iostream>

#include "asterism/mesh/support/one_line.hpp"

namespace asterism::apps {

std::optional<error> say_notes(const std::vector<std::string>& notes, const note_options& how) {
  if (how.strict && !notes.empty()) return error{"--strict: " + notes.front()};
  if (how.quiet) return std::nullopt;
  for (const std::string& note : notes)
    std::cerr << "asterism: note: " << internal::one_line(note) << '\n';
  return std::nullopt;
}

}  // namespace asterism::apps
