// SPDX-License-Identifier: MIT
//
// Throws Poisson darts: the second heuristic of the thesis, section 4.2, with its optimization of
// throwing near a bad triangle only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "asterism/core/random.hpp"
#include "asterism/core/site.hpp"
#include "asterism/mesh/refine/bad_triangle_queue.hpp"
#include "asterism/mesh/refine/refine_state.hpp"
#include "asterism/mesh/refine/site_insertion.hpp"

namespace asterism::internal {

// Returns a uniformly random point of an ellipse around the triangle. It is centred at the
// centroid, a disk in the mean of the three metrics, and large enough for the triangle enlarged by
// half.
point throw_dart(const refine_state& state, const triangle& t, splitmix64& random);

class dart_thrower {
 public:
  // Starts from `tolerance`; after `max_rejected` rejections in a row it is multiplied by 0.8,
  // never below `floor`.
  dart_thrower(std::uint64_t seed, int max_rejected, double tolerance, double floor)
      : random_(seed), max_rejected_(max_rejected), tolerance_(tolerance), floor_(floor) {}

  double tolerance() const { return tolerance_; }
  // Throws darts at the bad triangles in turn until one is accepted. Adds to `rejected` those that
  // are not. Returns false when the tolerance is at its floor and max_rejected darts in a row
  // failed, or the field failed.
  bool refine(refine_state& state, const std::vector<bad_triangle>& bad, std::size_t& rejected);

 private:
  splitmix64 random_;
  int max_rejected_;
  double tolerance_, floor_;
  int rejected_in_a_row_ = 0;
  std::size_t turn_ = 0;
};

}  // namespace asterism::internal
