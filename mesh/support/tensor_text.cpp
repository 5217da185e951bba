// SPDX-License-Identifier: MIT
#include "asterism/mesh/support/tensor_text.hpp"

#include <cmath>

#include "asterism/core/number_text.hpp"
#include "asterism/kernels/filtered_kernel.hpp"

namespace asterism::internal {
namespace {

bool is_definite(const metric_tensor& m) {
  return std::isfinite(m.m11) && std::isfinite(m.m12) && std::isfinite(m.m22) &&
         filtered_kernel().is_positive_definite(m);
}

// A number that is not finite is not changed: format_number() writes a word for it.
double rounded(double x) {
  const auto read = parse_number(format_number(x));
  return read ? read.value() : x;
}

}  // namespace

std::string point_text(const point& q) {
  return std::string("(").append(format_number(q.x)).append(", ").append(format_number(q.y)) + ")";
}

std::string tensor_text(const metric_tensor& m) {
  const bool misleads =
      !is_definite(m) && is_definite({rounded(m.m11), rounded(m.m12), rounded(m.m22)});
  const auto text = [misleads](double x) { return misleads ? number_text(x) : format_number(x); };
  return text(m.m11) + " " + text(m.m12) + " " + text(m.m22);
}

}  // namespace asterism::internal
