// SPDX-License-Identifier: MIT
#include "asterism/mesh/solution/metric_steps.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "asterism/core/number_text.hpp"

namespace asterism::internal {
namespace {

std::string optimum_step(const solution_metric_options& options) {
  return fmt::format("optimum {}{}", options.norm ? number_text(*options.norm) : "inf",
                     options.isotropic ? " isotropic" : "");
}

std::string relative_step(const solution_metric_options& options) {
  return fmt::format("relative {}{}{}", number_text(options.error.value_or(0)),
                     options.cutoff ? " cutoff " + number_text(*options.cutoff) : "",
                     options.isotropic ? " isotropic" : "");
}

}  // namespace

std::vector<std::string> metric_steps(const solution_metric_options& options, std::size_t fields,
                                      std::size_t others, bool given,
                                      std::optional<double> layers) {
  constexpr std::array<const char*, 3> methods = {"l2", "green", "lsq"};
  std::vector<std::string> steps;
  if (fields > 0) {
    const bool is_green = !given && options.hessian == hessian_method::green;
    const char* const method = methods[static_cast<std::size_t>(options.hessian)];
    steps.push_back(fmt::format("hessian {}", given ? "given" : method));
    if (is_green) steps.emplace_back("moduli");
    steps.push_back(options.relative ? relative_step(options) : optimum_step(options));
    if (layers) steps.push_back(fmt::format("layers {:.4g}", *layers));
    if (fields > 1) steps.push_back(fmt::format("fields {}", fields));
  }
  if (fields == 0 && options.isotropic) steps.emplace_back("isotropic");
  if ((fields > 0 && !options.relative) || options.vertices || options.complexity)
    steps.emplace_back("factor");
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
