// SPDX-License-Identifier: MIT
//
// Grades tensors at the nodes of a graph: clips the tensors of neighbours, with small changes.
//
// Reduces the two tensors of an edge simultaneously (A = W W^T, B = W diag(l) W^T) when its ends
// measure lengths too differently. Each |ln l_i| is clipped, a part of the excess taken from the
// coarser end, the rest from the finer one; with a half from each end that is the projection onto
// the pairs within the limit, which keeps the product of the determinants. This is done edge after
// edge in their order, until none is left. With halves the rounds converge, since equal tensors
// satisfy the limits of all edges (docs/math/delivered-metric.md); the number of rounds is bounded
// as well.
//
// Doubles throughout: the outcome is a metric, not a claim.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/search/triangle_locator.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal::adapting {

struct gradation_limit {
  // Distortion allowed between the tensors of an edge of length 1. For an edge of length l it is
  // this to the power of l, where l is raised to `shortest` and lowered to `longest`.
  double distortion = 2;
  double unit = 1;  // length that counts as 1
  double shortest = 0.25, longest = 2;
  // Part of an edge's excess by which its coarser end is refined; its finer end is coarsened by the
  // rest. With more than one half fine layers keep their tensors, and nodes are added beside them
  // (docs/design/adaptation.md). After `uneven_rounds` rounds it is one half, with which rounds are
  // known to end.
  double coarser_part = 0.7;
  std::size_t uneven_rounds = 50, most_rounds = 400;
};

// Returns the natural logarithm of the distortion between two tensors: the greatest |ln| of the
// ratio in which they measure a length.
double log_distortion(const metric_tensor& a, const metric_tensor& b);

// Returns the log distortion between two sites, divided by the length of the edge between them in a
// metric that changes geometrically along it.
double log_variation(const site& a, const site& b);

// Clips the pair to this log distortion; true if that changed anything. `coarser_part` of the
// excess is taken from the coarser side, in each of the two directions of the reduction.
bool clip_distortion(metric_tensor& a, metric_tensor& b, double most, double coarser_part = 0.5);

// Grades the tensors to the limit. Returns the rounds it took; most_rounds + 1 if some edge is
// still above its limit, at the end of the rounds or at a stop. Charges the account of `stop`.
std::size_t grade(const std::vector<point>& places, const std::vector<graph_edge>& edges,
                  const gradation_limit& limit, std::vector<metric_tensor>& tensors,
                  const cancellation& stop = {});

}  // namespace asterism::internal::adapting
