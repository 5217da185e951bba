// SPDX-License-Identifier: MIT
//
// Makes the metric of a solution from its optimum: finds the factor with which the metric meets its
// target after intersections, step limit, bounds on sizes and gradation. Steps 4 to 8 of
// solution_metric.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/core/site.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/search/mesh_links.hpp"
#include "asterism/mesh/solution/solution_metric_options.hpp"
#include "asterism/mesh/solution/solution_metric_report.hpp"

namespace asterism::internal {

using tensors = std::vector<metric_tensor>;

// Vertices for each unit of complexity, in a mesh of equilateral triangles of edge length 1.
inline constexpr double vertices_of_unit = 2 / std::numbers::sqrt3;

// Returns the share part / of, which is 0 if `of` is 0.
inline double share_of(std::size_t part, std::size_t of) {
  return of == 0 ? 0 : static_cast<double>(part) / static_cast<double>(of);
}

// Makes steps 4 to 8 of the metric for any factor.
class metric_maker {
 public:
  // Refers to the arguments, which must outlive the metric_maker.
  metric_maker(const mesh& m, const solution_metric_options& options,
               const std::vector<tensors>& intersected);

  const std::vector<double>& areas() const { return areas_; }
  // Returns the longer side of the box around the sites.
  double extent() const { return std::max(sides_[0], sides_[1]); }
  // Returns the sides of that box.
  const std::array<double, 2>& sides() const { return sides_; }
  const mesh_links& links() const { return links_; }
  solution_metric_report& report() { return report_; }
  void set_raw(tensors raw) { raw_ = std::move(raw); }
  // Sets the complexity wanted to the metric's own unless one is asked for.
  void set_given(tensors given) {
    raw_ = std::move(given);
    is_given_ = true;
  }
  void set_layers(std::optional<double> aspect) { layers_ = aspect; }
  // Takes the second derivatives of fields that were divided by 2 to the powers.
  void set_recovered(std::vector<tensors> recovered, std::vector<int> powers, bool are_given) {
    recovered_ = std::move(recovered);
    powers_ = std::move(powers);
    hessians_given_ = are_given;
  }
  std::optional<error> set_implied();
  result<solution_metric> run();

 private:
  tensors shaped(double factor);
  tensors graded(tensors t);
  void note_marks(const std::vector<std::uint8_t>& marks);
  double greatest_size() const;
  double error_of(const tensors& t) const;
  double measure(double factor);
  void meet(double target);
  void say(double target, double got);

  const mesh& mesh_;
  const solution_metric_options& options_;
  const std::vector<tensors>& others_;
  mesh_links links_;
  std::vector<double> areas_;
  std::array<double, 2> sides_;
  bool is_given_ = false, hessians_given_ = false;
  tensors raw_, implied_, made_;
  std::vector<tensors> recovered_;
  std::vector<int> powers_;
  std::optional<double> layers_;  // bound on aspects of fields that were computed
  solution_metric_report report_;
};

}  // namespace asterism::internal
