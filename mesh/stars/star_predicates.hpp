// SPDX-License-Identifier: MIT
//
// Puts the three predicates that stars and refinement use behind one interface, so that everything
// above is compiled once and runs on any kernel.
//
// A virtual call costs a few nanoseconds, an edge_test microseconds. The answers are those of the
// kernel behind it (predicates/ defines them). Only filtered_kernel and exact_kernel are always
// right; double_kernel is for comparison. Each thread needs an object of its own, as for the
// kernels.
#pragma once

#include <memory>
#include <type_traits>

#include "asterism/core/sign.hpp"
#include "asterism/core/site.hpp"
#include "asterism/kernels/tier_counters.hpp"

namespace asterism::internal {

class star_predicates {
 public:
  virtual ~star_predicates() = default;
  virtual sign orientation(const point& p, const point& q, const point& r) const = 0;
  virtual bool encroaches(const site& a, const site& b, const site& w) const = 0;
  virtual bool edge_test(const site& v, const site& w, const site& x, const site& y) const = 0;

  // Returns predicates of the same arithmetic for another thread.
  virtual std::unique_ptr<star_predicates> fork() const = 0;
  // Returns how many questions each tier decided here, and in the forks given to count().
  virtual tier_counters counters() const = 0;
  virtual void count(const tier_counters& of_fork) const = 0;
};

// Asks a kernel of its own, which counts here if it counts at all.
template <class Kernel>
class star_predicates_on final : public star_predicates {
 public:
  star_predicates_on() = default;

  sign orientation(const point& p, const point& q, const point& r) const override {
    return kernel().orientation(p, q, r);
  }
  bool encroaches(const site& a, const site& b, const site& w) const override {
    return kernel().encroaches(a, b, w);
  }
  bool edge_test(const site& v, const site& w, const site& x, const site& y) const override {
    return kernel().edge_test(v, w, x, y);
  }
  std::unique_ptr<star_predicates> fork() const override {
    return std::make_unique<star_predicates_on>();
  }
  tier_counters counters() const override { return decided_; }
  void count(const tier_counters& of_fork) const override { decided_ += of_fork; }

 private:
  Kernel kernel() const {
    if constexpr (std::is_constructible_v<Kernel, tier_counters&>)
      return Kernel(decided_);
    else
      return Kernel();
  }

  mutable tier_counters decided_;  // answers of one thread, and of counted forks
};

}  // namespace asterism::internal
