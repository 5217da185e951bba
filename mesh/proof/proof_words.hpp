// SPDX-License-Identifier: MIT
//
// Makes the error messages of the checks of a proof.
#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include "asterism/core/result.hpp"

namespace asterism::internal::proof_detail {

inline error not_shown(std::string what) { return {std::move(what), error_code::invalid_mesh}; }
inline std::string vertex_number(std::size_t v) { return "vertex " + std::to_string(v + 1); }

}  // namespace asterism::internal::proof_detail
