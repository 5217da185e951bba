// SPDX-License-Identifier: MIT
//
// Finds the name that a mistyped word stands for, among those that are known.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace asterism::internal {

// Returns the name that the word begins, if it is one: the shortest, where all others that begin
// with the word begin with that name too. Else returns the nearest name that differs in at most two
// letters, changed, added, removed or exchanged with their neighbour, and less than half of the
// word's; of several as near, the first. Small and capital letters are alike. Empty if there is
// none.
std::string similar_name(std::string_view word, const std::vector<std::string>& names);

// Returns the clause "; did you mean NAME?" about the similar name; empty if there is none.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& names);

}  // namespace asterism::internal
