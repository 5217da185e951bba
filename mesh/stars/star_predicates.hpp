// SPDX-License-Identifier: MIT
//
// Puts the three predicates that stars and refinement use behind one interface, so that everything
// above is compiled once and runs on any kernel.
//
// A virtual call costs a few nanoseconds, an edge_test microseconds. The answers are those of the
// kernel behind it (predicates/ defines them). Only filtered_kernel and exact_kernel are always
// right; double_kernel is for comparison. Decisions are counted in counters of the caller: one set
// for each thread, to be added.
#pragma once

#include <memory>
#include <type_traits>

#include "asterism/core/sign.hpp"
#include "asterism/core/site.hpp"
#include "asterism/kernels/tier_counters.hpp"

namespace asterism::internal {

class star_predicates {
 public:
  // Three predicates of one arithmetic. Counts decisions in `decided`, which must outlive them.
  // Used by one thread.
  explicit star_predicates(tier_counters& decided) : decided_(&decided) {}
  virtual ~star_predicates() = default;
  star_predicates(const star_predicates&) = delete;
  star_predicates& operator=(const star_predicates&) = delete;

  virtual sign orientation(const point& p, const point& q, const point& r) const = 0;
  virtual bool encroaches(const site& a, const site& b, const site& w) const = 0;
  virtual bool edge_test(const site& v, const site& w, const site& x, const site& y) const = 0;

  // Returns predicates of the same arithmetic that count in `decided`: for another thread, or for
  // work that is counted separately.
  virtual std::unique_ptr<star_predicates> fork(tier_counters& decided) const = 0;
  // Returns the counters of decisions.
  tier_counters& counters() const { return *decided_; }

 private:
  tier_counters* decided_;
};

// Evaluates the predicates by a kernel, and its counters if the kernel has them.
template <class Kernel>
class star_predicates_on final : public star_predicates {
 public:
  using star_predicates::star_predicates;

  sign orientation(const point& p, const point& q, const point& r) const override {
    return kernel().orientation(p, q, r);
  }
  bool encroaches(const site& a, const site& b, const site& w) const override {
    return kernel().encroaches(a, b, w);
  }
  bool edge_test(const site& v, const site& w, const site& x, const site& y) const override {
    return kernel().edge_test(v, w, x, y);
  }
  std::unique_ptr<star_predicates> fork(tier_counters& decided) const override {
    return std::make_unique<star_predicates_on>(decided);
  }

 private:
  Kernel kernel() const {
    if constexpr (std::is_constructible_v<Kernel, tier_counters&>)
      return Kernel(counters());
    else
      return Kernel();
  }
};

}  // namespace asterism::internal
