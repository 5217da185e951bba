// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

namespace asterism::internal {

// JSON with its keys in the order they were written: the text is deterministic.
using certificate_json = nlohmann::ordered_json;

inline constexpr std::string_view certificate_format = "asterism certificate 2";

// Degrees in a certificate's worst angles if there was no angle to judge; null in JSON.
inline constexpr double no_angle_to_judge = 180;

// Names of curves, in the order of curve_kind.
inline constexpr std::array<std::string_view, 2> curve_kind_names = {"arc", "cubic"};

}  // namespace asterism::internal
