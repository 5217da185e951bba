// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/field_variation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/domain/point_in_domain.hpp"
#include "asterism/mesh/numerics/mesh_statistics.hpp"

namespace asterism::internal {
namespace {

// Number of points of the grid along each side of the domain's box.
constexpr std::size_t grid_points = 33;
// Distortion tau of two samples from which the segment between them is sampled further. Below it
// the quotient (1 - 1 / tau) / d, d their distance, is about the field's rate of change already. At
// this tau the quotient still has ten digits free of rounding errors.
constexpr double little_distortion = 1.01;
// Distance of two samples, as a part of the box's longer side, at which a distortion above
// little_distortion counts as a jump: 2^-40 is some thousand units in the last place of a
// coordinate.
constexpr double next_to_each_other = 0x1p-40;

class sampling {
 public:
  sampling(const domain& d, const metric_field& field) : field_(field), inside_(d), box_(d.box()) {}

  result<field_samples> run() {
    std::vector<std::optional<site>> before, row;
    for (std::size_t j = 0; j < grid_points; ++j) {
      row.clear();
      for (std::size_t i = 0; i < grid_points; ++i) {
        row.push_back(sample_inside(i, j));
        if (i > 0) look_between(row[i - 1], row[i]);
        if (j > 0) look_between(before[i], row[i]);
        if (failure_) return *failure_;
      }
      before = row;
    }
    return found_;
  }

 private:
  static double between(double low, double high, std::size_t i) {
    const double t = static_cast<double>(i) / static_cast<double>(grid_points - 1);
    return low * (1 - t) + high * t;
  }

  std::optional<site> sample(const point& q) {
    const auto metric = field_.at(q);
    if (!metric) {
      failure_ = metric.failure();
      return std::nullopt;
    }
    return site{q, metric.value()};
  }

  std::optional<site> sample_inside(std::size_t i, std::size_t j) {
    const point q{between(box_.low.x, box_.high.x, i), between(box_.low.y, box_.high.y, j)};
    if (!inside_.contains(q)) return std::nullopt;
    return sample(q);
  }

  void look_between(const std::optional<site>& first, const std::optional<site>& last) {
    if (!first || !last) return;
    site p = *first, q = *last;
    const double least =
        next_to_each_other * std::max(box_.high.x - box_.low.x, box_.high.y - box_.low.y);
    found_.variation = std::max(found_.variation, variation(p, q));
    while (distortion(p.metric, q.metric) > little_distortion) {
      const point a = p.position, b = q.position;
      if (elementary::hypot(b.x - a.x, b.y - a.y) <= least) {
        if (!found_.jump) found_.jump = {a, b, distortion(p.metric, q.metric)};
        return;
      }
      const auto middle = sample({a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2});
      if (!middle) return;
      const bool in_first =
          distortion(p.metric, middle->metric) >= distortion(middle->metric, q.metric);
      (in_first ? q : p) = *middle;
      found_.variation = std::max(found_.variation, variation(p, q));
    }
  }

  const metric_field& field_;
  inside_index inside_;
  bounding_box box_;
  field_samples found_;
  std::optional<error> failure_;
};

}  // namespace

result<field_samples> sample_variation(const domain& d, const metric_field& field) {
  return sampling(d, field).run();
}

}  // namespace asterism::internal
