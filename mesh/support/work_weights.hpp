// SPDX-License-Identifier: MIT
//
// Lists the work units of steps of the mesher and the auditor, in one place.
//
// The unit is that of kernels/work_units.hpp, which weighs the kernel's answers: about ten
// microseconds. Each weight was measured as the processor time of runs that do little else (x86_64,
// Release), with everything that belongs to the step. Weights bound work and are no clock: where a
// run ends depends on them and on counts alone. Changing one changes which runs are cut off.
#pragma once

#include <cstddef>

namespace asterism::internal::work_weights {

// Weights of the repair of a domain (domain/snapping.cpp).
inline constexpr double vertex_beside_edge = 0.0005;  // 5 ns: looked at
inline constexpr double vertex_near_edge = 0.005;     // 50 ns: looked at closely
inline constexpr double crossing_entered = 0.3;       // 3 us
inline constexpr double edge_in_arrangement = 0.05;   // 500 ns: begun with

// Weights of the fill (fill/work_meter.hpp).
inline constexpr double approximate_star = 0.2;    // 2 us: made anew
inline constexpr double plain_candidate = 0.003;   // 30 ns: site or subsegment looked at
inline constexpr double approximate_gap = 0.0003;  // 3 ns: held against a site, or made

// Weights of refinement (refine/refine_state.cpp).
inline constexpr double bad_triangle = 0.2;     // 2 us: tried, where hardly any succeeds
inline constexpr double site_looked_at = 3e-4;  // 3 ns
inline constexpr double star_candidate = 3e-3;  // 30 ns

// Weights of local changes. A step that does more with a face counts as several.
inline constexpr double face_listed = 0.006;            // 60 ns: a face of a list
inline constexpr std::size_t faces_for_flip = 4;        // 240 ns: a face whose edges may flip
inline constexpr std::size_t faces_for_count = 3;       // 180 ns: a face counted and measured
inline constexpr std::size_t faces_for_edge_test = 8;   // 480 ns: an edge asked about
inline constexpr std::size_t faces_for_centre = 6;      // 360 ns: a centre found
inline constexpr std::size_t faces_for_place = 5;       // 300 ns: a place tried for a node
inline constexpr std::size_t faces_for_three_gaps = 3;  // 180 ns: whether gaps see all sites
inline constexpr std::size_t faces_for_taking_back =
    20;                                            // 1.2 us: a face tried with tensors wanted
inline constexpr double graded_pair = 0.04;        // 400 ns: two nodes of a graph graded
inline constexpr double node_without_noise = 0.1;  // 1 us: with its neighbours

// Weights of the audit (audit/audit_work.hpp), and of the theorem on nets.
inline constexpr double audited_pair = 0.1;        // 1 us: two sites, or an arc and a site
inline constexpr double audited_exact_pair = 100;  // 1 ms: an arc and a site, exactly
inline constexpr double audit_decision = 0.003;    // 30 ns: of the auditor's own arithmetic
inline constexpr double audit_exact_decision = 1;  // 10 us: the same in rationals
inline constexpr double audit_finding_text = 0.5;  // 5 us: its sentence
inline constexpr double theorem_pair = 0.05;       // 500 ns: two sites, a site and a subsegment

}  // namespace asterism::internal::work_weights
