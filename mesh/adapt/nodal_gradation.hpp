// SPDX-License-Identifier: MIT
//
// Changes tensors at the nodes of a graph as little as makes neighbours alike enough.
//
// Reduces the two tensors of an edge simultaneously (A = W W^T, B = W diag(l) W^T) when its ends
// measure lengths too differently. Each |ln l_i| is clipped, half of the excess taken from each
// end: the projection onto the pairs that are alike enough, which leaves the product of the
// determinants. This is done edge after edge in their order, until none is left. It ends since all
// sets of such pairs have the equal pairs in common (docs/math/delivered-metric.md), and is bounded
// besides.
//
// Doubles throughout: the outcome is a metric, not a claim.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal::adapting {

struct graph_edge {
  vertex_index a = 0, b = 0;
};

struct gradation_limit {
  // Distortion allowed over an edge of length 1 (metric_tensor pairs: the greatest ratio of
  // lengths). Over one of length l it is this to the power of l, at least `shortest`, at most
  // `longest` in place of l.
  double distortion = 2;
  double unit = 1;  // length that counts as 1
  double shortest = 0.25, longest = 2;
  std::size_t most_rounds = 400;
};

// Returns the natural logarithm of the distortion between two tensors: the greatest |ln| of the
// ratio in which they measure a length.
double log_distortion(const metric_tensor& a, const metric_tensor& b);

// Clips the pair to this log distortion, half from each side; true if that changed anything.
bool make_alike(metric_tensor& a, metric_tensor& b, double most);

// Grades the tensors to the limit. Returns the rounds it took; most_rounds + 1 if some edge is
// still above its limit.
std::size_t grade(const std::vector<point>& places, const std::vector<graph_edge>& edges,
                  const gradation_limit& limit, std::vector<metric_tensor>& tensors);

}  // namespace asterism::internal::adapting
