// SPDX-License-Identifier: MIT
//
// Says what a file is that was given where a file of another kind is wanted, and what takes it.
#pragma once

#include <string>
#include <string_view>

#include "asterism/core/export.h"

namespace asterism {

// Returns the end of a message, "; it is a domain, ..."; empty where the name tells nothing. Does
// not open the file.
ASTERISM_EXPORT std::string what_it_is(std::string_view name);

}  // namespace asterism
