// SPDX-License-Identifier: MIT
//
// Holds the measures of a mesh for the theorem on nets (mesh/audit/theorem_hypotheses.hpp).
#pragma once

#include <string>

namespace asterism {

// Measurements of a mesh; lengths are metric. Two sites are `near` if their disks of the covering
// radius, each in its own metric, are not certainly apart; where the theorem applies, all near
// pairs are measured.
struct theorem_hypotheses {
  bool applies = false;
  std::string reason;  // one sentence: which hypothesis fails, and where; or that all hold
  // Covering radius R: every point of the domain is within R of a vertex of its triangle.
  double covering_radius = 0;
  // Spacing lambda: of two near sites at least one measures a distance of at least lambda.
  double spacing = 0;
  // Greatest length of a boundary edge, internal ones included, as either end measures it.
  double longest_subsegment = 0;
  // Distortion tau: the greatest ratio of a length as measured by two near sites.
  double distortion = 1;
  // Variation sigma: the least for which tau <= 1 / (1 - sigma d) for all near sites, d the smaller
  // of their two distances.
  double variation = 0;
  // Value with which the theorem's table of angles is entered: the greater of sigma R and 1 - 1 /
  // sqrt(tau), R the covering radius.
  double sigma_eps = 0;
  // Angle that the theorem proves for these numbers, in degrees; 0 if none.
  double proved_angle = 0;
};

}  // namespace asterism
