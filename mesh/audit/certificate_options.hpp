// SPDX-License-Identifier: MIT
//
// Lists the names of options that a certificate has in `asked.options`, by the command that made
// it.
#pragma once

#include <array>
#include <string_view>

namespace asterism::internal {

inline constexpr std::array<std::string_view, 26> mesh_option_names = {"angle-bound",
                                                                       "certify",
                                                                       "chord-tolerance",
                                                                       "complexity",
                                                                       "complexity-delivered",
                                                                       "domain",
                                                                       "gradation",
                                                                       "gradation-done",
                                                                       "improve",
                                                                       "improve-done",
                                                                       "max-sites",
                                                                       "metric-fingerprint",
                                                                       "metric-tolerance",
                                                                       "random-points",
                                                                       "refine",
                                                                       "regions",
                                                                       "repair-distance",
                                                                       "repair-done",
                                                                       "repair-places",
                                                                       "seed",
                                                                       "size",
                                                                       "size-delivered",
                                                                       "sizes",
                                                                       "tol",
                                                                       "tol-at-end",
                                                                       "vertices"};

// Names that the certificate of one piece of a domain (mesh/pieces) has in addition: the piece's
// number, the number of pieces, the box that formulas are placed in, and the digest of the job.
inline constexpr std::array<std::string_view, 3> piece_option_names = {"metric-box", "piece",
                                                                       "piece-question"};

inline constexpr std::array<std::string_view, 4> certify_option_names = {"angle-bound", "mesh",
                                                                         "repair", "size"};

// Names of options that a certificate has only if the option was given.
inline constexpr std::array<std::string_view, 6> rare_option_names = {
    "adapt-cutoff",  "adapt-given-hessian", "adapt-relative",
    "boundary-part", "guarantee",           "split-across"};
// Names that the certificate of a run with frozen regions (pipeline/frozen_regions.hpp) has in
// addition.
inline constexpr std::array<std::string_view, 6> frozen_option_names = {
    "frozen",     "frozen-border-coarser", "frozen-border-length",
    "frozen-low", "frozen-triangles",      "frozen-worst-angle"};

// Names of options of an adaptation. A transfer adds names that begin with "transfer-", some for
// each component.
inline constexpr std::array<std::string_view, 50> adapt_option_names = {
    "adapt-aspect",
    "adapt-complexity",
    "adapt-error",
    "adapt-fields",
    "adapt-gradation",
    "adapt-gradation-space",
    "adapt-hessian",
    "adapt-hmax",
    "adapt-hmin",
    "adapt-implied",
    "adapt-intersect",
    "adapt-isotropic",
    "adapt-mesh",
    "adapt-metric",
    "adapt-norm",
    "adapt-solution",
    "adapt-step",
    "adapt-vertices",
    "angle-bound",
    "boundary-distance",
    "boundary-kept",
    "boundary-vertices",
    "corner-angle",
    "domain",
    "hausd",
    "kept",
    "metric-at-boundary",
    "metric-clipped-by-aspect",
    "metric-clipped-by-hmax",
    "metric-clipped-by-hmin",
    "metric-complexity-asked",
    "metric-complexity-at-longest",
    "metric-complexity-before-gradation",
    "metric-complexity-delivered",
    "metric-complexity-flat",
    "metric-error-predicted",
    "metric-factor",
    "metric-fields",
    "metric-fingerprint",
    "metric-flat-fields",
    "metric-floored",
    "metric-gradation-ended",
    "metric-gradation-rounds",
    "metric-graded",
    "metric-intersected",
    "metric-noise",
    "metric-reached",
    "metric-step-limited",
    "metric-steps",
    "metric-tolerance"};

}  // namespace asterism::internal
