// SPDX-License-Identifier: MIT
//
// Holds what is measured of a mesh for the theorem on nets (mesh/audit/theorem_hypotheses.hpp).
#pragma once

#include <string>

namespace asterism {

// Measurements of a mesh; lengths are metric. Two sites are `near` if their disks of the covering
// radius, each in its own metric, are not certainly apart; where it applies all near pairs are
// measured.
struct theorem_hypotheses {
  bool applies = false;
  std::string reason;  // one sentence: which hypothesis fails, and where; or that all hold
  // R: every point of the domain is as near as this to one of its triangle's vertices.
  double covering_radius = 0;
  // lambda: of two near sites at least one is as far as this from the other, as it measures.
  double spacing = 0;
  // Greatest length of a boundary edge, internal ones included, as either end measures it.
  double longest_subsegment = 0;
  // tau: the greatest factor between lengths as two near sites measure them.
  double distortion = 1;
  // sigma: the least for which tau <= 1 / (1 - sigma d) for two near sites, d the smaller of their
  // distances.
  double variation = 0;
  // sigma R, or 1 - 1 / sqrt(tau) if that is more: what the table is entered with.
  double sigma_eps = 0;
  // Angle of the theorem for these numbers, in degrees; 0 if none is proved.
  double proved_angle = 0;
};

}  // namespace asterism
