// SPDX-License-Identifier: MIT
//
// Searches for the factor of a metric that gives the number of sites wanted, by making meshes.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "asterism/core/elementary.hpp"

namespace asterism::internal {

// Returns the number of vertices to aim at for this factor of the metric, within the limit on
// sites.
inline std::size_t count_aimed_at(std::size_t wanted, double factor, std::size_t max_sites) {
  constexpr double fewest = 3;
  const double aim = std::round(factor * static_cast<double>(wanted));
  return static_cast<std::size_t>(std::clamp(aim, fewest, static_cast<double>(max_sites)));
}

// Searches for the factor of the metric with which a mesh has the number of vertices wanted.
//
// The number grows with the factor, in steps where a domain is narrow: all subsegments of one
// length are halved at once, and no factor may lead to a number between.
class count_search {
 public:
  // `slowest` is the least exponent p in sites ~ factor^p that is assumed: 1 where all sites depend
  // on the factor, less where some do not, as on a boundary with narrow parts.
  explicit count_search(double wanted, double slowest = 1) : wanted_(wanted), slowest_(slowest) {}

  // Returns the factor to try next, 1 to begin with.
  double factor() const { return elementary::exp(at_); }
  // Returns the smallest |log(sites / wanted)| found so far.
  double least_off() const { return least_; }

  // Enters the number of sites of the mesh made with the last factor. Returns whether it is the
  // nearest to the number wanted so far.
  //
  // Assumes that sites are proportional to the factor; later that they grow as between the last two
  // factors, with no exponent below `slowest`. Once one factor was too large and one too small, the
  // next is between them, where a line through both meets the number wanted, but not near an end.
  bool take(double sites) {
    constexpr double nearest_to_end = 0.2;
    const double off = elementary::log(sites / wanted_);
    const bool is_nearest = std::abs(off) < least_;
    if (is_nearest) least_ = std::abs(off);
    bound& side = off > 0 ? above_ : below_;
    const double growth = side.known ? (off - side.off) / (at_ - side.at) : 1;
    side = {at_, off, true};
    if (above_.known && below_.known) {
      const double part =
          std::clamp(-below_.off / (above_.off - below_.off), nearest_to_end, 1 - nearest_to_end);
      at_ = below_.at + part * (above_.at - below_.at);
    } else {
      at_ -= off / std::clamp(growth, slowest_, 1.0);
    }
    return is_nearest;
  }

 private:
  struct bound {
    double at = 0, off = 0;  // logarithms of the factor, and of how far the number is off
    bool known = false;
  };

  double wanted_, slowest_;
  double at_ = 0;  // the logarithm of the factor
  double least_ = std::numeric_limits<double>::infinity();
  bound above_, below_;
};

}  // namespace asterism::internal
