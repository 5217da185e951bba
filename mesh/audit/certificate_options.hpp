// SPDX-License-Identifier: MIT
//
// The names among `asked.options` of a certificate, by what made it.
#pragma once

#include <array>
#include <string_view>

namespace asterism::internal {

inline constexpr std::array<std::string_view, 19> mesh_option_names = {
    "angle-bound",    "certify",        "domain",       "fit-done",  "gradation",
    "gradation-done", "improve",        "improve-done", "max-sites", "metric-fingerprint",
    "random-points",  "refine",         "regions",      "relax",     "seed",
    "size",           "size-delivered", "tol",          "tol-at-end"};

inline constexpr std::array<std::string_view, 4> certify_option_names = {"angle-bound", "mesh",
                                                                         "repair", "size"};

}  // namespace asterism::internal
