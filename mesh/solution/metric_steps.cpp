// SPDX-License-Identifier: MIT
#include "asterism/mesh/solution/metric_steps.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "asterism/core/number_text.hpp"

namespace asterism::internal {

std::vector<std::string> metric_steps(const solution_metric_options& options, std::size_t fields,
                                      std::size_t others) {
  constexpr std::array<const char*, 3> methods = {"l2", "green", "lsq"};
  std::vector<std::string> steps;
  if (fields > 0) {
    steps.push_back(fmt::format("hessian {}", methods[static_cast<std::size_t>(options.hessian)]));
    if (options.hessian == hessian_method::green) steps.emplace_back("moduli");
    steps.push_back(fmt::format("optimum {}{}", options.norm ? number_text(*options.norm) : "inf",
                                options.isotropic ? " isotropic" : ""));
    if (fields > 1) steps.push_back(fmt::format("fields {}", fields));
  }
  if (fields == 0 && options.isotropic) steps.emplace_back("isotropic");
  if (fields > 0 || options.vertices || options.complexity) steps.emplace_back("factor");
  if (others > 0) steps.push_back(fmt::format("intersect {}", others));
  if (options.step) steps.push_back(fmt::format("step {}", number_text(*options.step)));
  if (options.least_size > 0)
    steps.push_back(fmt::format("hmin {}", number_text(options.least_size)));
  if (std::isfinite(options.greatest_size))
    steps.push_back(fmt::format("hmax {}", number_text(options.greatest_size)));
  steps.push_back(fmt::format("aspect {}", number_text(options.aspect)));
  if (options.gradation)
    steps.push_back(fmt::format("gradation {} {}", number_text(*options.gradation),
                                options.gradation_keeps_shape ? "metric" : "mixed"));
  return steps;
}

}  // namespace asterism::internal
