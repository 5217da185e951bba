// SPDX-License-Identifier: MIT
//
// Returns a hint for a file of the wrong kind: what it is, and which command reads it.
#pragma once

#include <string>
#include <string_view>

#include "asterism/core/export.h"

namespace asterism {

// Returns the end of a message, "; it is a domain, ..."; empty if the name shows no kind. Does not
// open the file.
ASTERISM_EXPORT std::string what_it_is(std::string_view name);

}  // namespace asterism
