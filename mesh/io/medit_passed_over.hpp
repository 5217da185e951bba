// SPDX-License-Identifier: MIT
//
// Skips sections of Medit files that this library does not use.
#pragma once

#include <optional>
#include <string>

#include "asterism/core/result.hpp"
#include "asterism/mesh/io/text_scanner.hpp"

namespace asterism::internal {

struct passed_over {
  std::string names;         // of sections that are not known, with commas between
  std::optional<word> next;  // the keyword after one of them, already read
  // Turn above which BAMG makes a vertex a corner, in degrees; BAMG's own default.
  double corner_bound = 10;
};

// Skips the section that the keyword begins: by its count where its shape is known, else to the
// next word that begins with a letter. Refuses a word that cannot be a keyword.
std::optional<error> pass_over(text_scanner& source, const word& keyword, int dimension,
                               passed_over& passed);

}  // namespace asterism::internal
