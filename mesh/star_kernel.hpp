// SPDX-License-Identifier: MIT
//
// The three predicates stars and refinement ask for, behind one interface, so that everything
// above is compiled once and runs on any kernel.
//
// A virtual call costs a few nanoseconds, an edge_test microseconds. The answers are those of the
// kernel behind it (predicates/ defines them); only filtered_kernel and exact_kernel are always
// right, double_kernel is for comparison. One object a thread, as for the kernels.
#pragma once

#include "asterism/core/sign.hpp"
#include "asterism/core/site.hpp"

namespace asterism {

class star_kernel {
 public:
  virtual ~star_kernel() = default;
  virtual sign orientation(const point& p, const point& q, const point& r) const = 0;
  virtual bool encroaches(const site& a, const site& b, const site& w) const = 0;
  virtual bool edge_test(const site& v, const site& w, const site& x, const site& y) const = 0;
};

// `kernel` must outlive the adaptor.
template <class Kernel>
class star_kernel_on final : public star_kernel {
 public:
  explicit star_kernel_on(const Kernel& kernel) : kernel_(&kernel) {}
  sign orientation(const point& p, const point& q, const point& r) const override {
    return kernel_->orientation(p, q, r);
  }
  bool encroaches(const site& a, const site& b, const site& w) const override {
    return kernel_->encroaches(a, b, w);
  }
  bool edge_test(const site& v, const site& w, const site& x, const site& y) const override {
    return kernel_->edge_test(v, w, x, y);
  }

 private:
  const Kernel* kernel_;
};

}  // namespace asterism
