// SPDX-License-Identifier: MIT
//
// Maps to coordinates in which one site v is the origin and its metric the identity, so that its
// neighbours' positions do not depend on how stretched its metric is. Plain doubles, any
// floating-point environment.
//
// With M_v = [a b; b c] and D = a c - b^2 the frame is x' = (x - v.x) + beta (y - v.y),
// y' = gamma (y - v.y), beta = b / a, gamma = sqrt(D) / a; lengths are divided by sqrt(a), so v's
// metric is exactly the identity. The frame is that of the exact beta and gamma: rounding is an
// error of what is brought into it, never of the frame.
//
// Error. A displacement d and a tensor N are off by at most rho |d|_1 and rho (n11 + n22) in each
// component, a determinant by rho (n11 + n22)^2, with rho = 24 eps sigma, eps = 2^-52,
// sigma = 1 + 2 |beta| / gamma: of the order of the root of the condition number, since neither
// lengths nor tensors are expanded into monomials and determinants keep twice the digits.
// Derivation: docs/math/star-gap-errors.md, section 1.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "asterism/core/plane_algebra.hpp"
#include "asterism/core/site.hpp"

namespace asterism::internal::star_gap_detail {

inline constexpr double eps = 0x1p-52;
inline constexpr double frame_error_factor = 24;

// Returns the upper 26 bits of the significand: products of two such numbers are exact.
inline double upper_half(double x) {
  constexpr std::uint64_t mask = ~((std::uint64_t{1} << 27) - 1);
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & mask);
}

// Returns the determinant, off by at most 4 eps det M + 2^-73 m11 m22, for positive definite M in
// range: where the products of the upper halves cancel, their difference is exact.
inline double determinant(const metric_tensor& m) {
  const metric_tensor high{upper_half(m.m11), upper_half(m.m12), upper_half(m.m22)};
  const metric_tensor low = m - high;
  const double coarse = high.m11 * high.m22 - high.m12 * high.m12;
  const double mixed = high.m11 * low.m22 + low.m11 * high.m22 - 2 * (high.m12 * low.m12);
  return coarse + (mixed + (low.m11 * low.m22 - low.m12 * low.m12));
}

// A neighbouring site in v's frame.
struct framed_site {
  displacement<double> offset;  // from v
  metric_tensor metric;
  double determinant = 0;
  double extent = 0;  // |offset|_1
  double trace = 0;   // bounds every entry of the metric
};

class normal_frame {
 public:
  // Makes the frame of v. Requires a positive definite metric.
  explicit normal_frame(const site& v) : origin_(v.position), scale_(v.metric.m11) {
    const double determinant_of_v = star_gap_detail::determinant(v.metric);
    const double root = std::sqrt(determinant_of_v);
    inverse_scale_ = 1 / scale_;
    inverse_root_ = 1 / root;
    inverse_determinant_ = inverse_root_ * inverse_root_;
    shear_ = v.metric.m12 * inverse_scale_;
    stretch_ = root * inverse_scale_;
    const double tilt = 1 + 2 * (std::abs(v.metric.m12) * inverse_root_);
    usable_ = within(scale_, 0x1p150) && within(stretch_, 0x1p80) && tilt <= most_tilt;
    rho_ = frame_error_factor * eps * tilt;
  }

  bool usable() const { return usable_; }
  double rho() const { return rho_; }
  // Returns the scale: |u|_v^2 = scale |u'|^2.
  double scale() const { return scale_; }

  framed_site bring(const site& s) const {
    framed_site f;
    const auto d = between(origin_, s.position);
    f.offset = {d.x + shear_ * d.y, stretch_ * d.y};
    const double n11 = s.metric.m11 * inverse_scale_;
    const double n12 = (s.metric.m12 - shear_ * s.metric.m11) * inverse_root_;
    f.determinant = star_gap_detail::determinant(s.metric) * inverse_determinant_;
    const double n22 = (n12 * n12 + f.determinant) * (1 / n11);
    f.metric = {n11, n12, n22};
    f.extent = std::abs(f.offset.x) + std::abs(f.offset.y);
    f.trace = n11 + n22;
    return f;
  }

  // True within ranges in which no product of four lengths and four tensor entries overflows or
  // loses to underflow more than rho allows.
  static bool in_range(const framed_site& f) {
    return within(f.extent, most_length) && within(f.trace, most_trace) && f.metric.m11 >= 0x1p-40;
  }
  // Bounds on displacements and tensors: metrics of neighbours that are stretched by up to 4096 in
  // directions of their own are in range.
  static constexpr double most_length = 0x1p160, most_trace = 0x1p24;
  static bool within(double x, double most) { return x <= most && x * most >= 1; }

  point original(const displacement<double>& u) const {
    const double y = u.y / stretch_;
    return {origin_.x + (u.x - shear_ * y), origin_.y + y};
  }

 private:
  // Greatest tilt at which 16 rho and the second order of rho are below the tolerances of star_gap.
  static constexpr double most_tilt = 0x1p21;

  point origin_;
  double scale_, inverse_scale_, inverse_root_, inverse_determinant_, shear_, stretch_, rho_;
  bool usable_;
};

}  // namespace asterism::internal::star_gap_detail
