// SPDX-License-Identifier: MIT
//
// Random numbers for laws: the same on every machine, so that a seed replays a failure.
#pragma once

#include "asterism/core/random.hpp"

namespace asterism::property {

using random_source = internal::splitmix64;

}  // namespace asterism::property
