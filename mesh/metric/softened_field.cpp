// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric/softened_field.hpp"

#include <algorithm>
#include <utility>

#include "asterism/mesh/metric/graded_field.hpp"
#include "asterism/mesh/metric/sized_field.hpp"
#include "asterism/mesh/numerics/metric_algebra.hpp"

namespace asterism::internal {
namespace {

metric_tensor times(double factor, const metric_tensor& m) {
  return {factor * m.m11, factor * m.m12, factor * m.m22};
}

class softened_field : public metric_field {
 public:
  softened_field(const metric_field& field, double power) : field_(&field), power_(power) {}
  result<metric_tensor> at(const point& q) const override {
    auto given = field_->at(q);
    if (!given) return given;
    const tensor_logarithm l = logarithm(given.value());
    const double density = (l.l11 + l.l22) / 2;
    return checked_tensor(q, exponential({density + power_ * (l.l11 - density), power_ * l.l12,
                                          density + power_ * (l.l22 - density)}));
  }
  void expect(const std::function<std::vector<point>()>& places) const override {
    field_->expect(places);
  }

 private:
  const metric_field* field_;
  double power_;
};

class constant_field : public metric_field {
 public:
  explicit constant_field(const metric_tensor& m) : m_(m) {}
  result<metric_tensor> at(const point& q) const override { return checked_tensor(q, m_); }

 private:
  metric_tensor m_;
};

// Rescales a field to other units of length. Where the field fails it returns `elsewhere`, which is
// so weak that no intersection takes notice of it.
class rescaled_field : public metric_field {
 public:
  rescaled_field(const metric_field& field, double factor, const metric_tensor& elsewhere)
      : field_(&field), factor_(factor), elsewhere_(elsewhere) {}
  result<metric_tensor> at(const point& q) const override {
    const auto given = field_->at(q);
    return given ? times(factor_, given.value()) : elsewhere_;
  }
  void expect(const std::function<std::vector<point>()>& places) const override {
    field_->expect(places);
  }

 private:
  const metric_field* field_;
  double factor_;
  metric_tensor elsewhere_;
};

// And back.
class restored_field : public metric_field {
 public:
  restored_field(std::unique_ptr<metric_field> rescaled, double factor)
      : rescaled_(std::move(rescaled)), factor_(factor) {}
  result<metric_tensor> at(const point& q) const override {
    auto there = rescaled_->at(q);
    if (!there) return there;
    return checked_tensor(q, times(factor_, there.value()));
  }
  void expect(const std::function<std::vector<point>()>& places) const override {
    rescaled_->expect(places);
  }

 private:
  std::unique_ptr<metric_field> rescaled_;
  double factor_;
};

class checked_field : public metric_field {
 public:
  explicit checked_field(std::unique_ptr<metric_field> field) : field_(std::move(field)) {}
  result<metric_tensor> at(const point& q) const override {
    auto found = field_->at(q);
    if (!found) return found;
    return checked_tensor(q, found.value());
  }
  void expect(const std::function<std::vector<point>()>& places) const override {
    field_->expect(places);
  }

 private:
  std::unique_ptr<metric_field> field_;
};

}  // namespace

std::unique_ptr<metric_field> soften(const metric_field& field, double power) {
  return std::make_unique<softened_field>(field, power);
}

std::unique_ptr<metric_field> grade_over(const metric_field& field, const bounding_box& box,
                                         double beta, double reach, const metric_tensor& typical,
                                         const cancellation& stop) {
  constexpr double weak = 0x1p-60;
  const double factor = 1 / (reach * reach);
  const double least = weak * factor * std::min(typical.m11, typical.m22);
  gradation_options options;
  options.beta = beta;
  options.stop = stop;
  auto graded =
      grade_metric(std::make_unique<rescaled_field>(field, factor, metric_tensor{least, 0, least}),
                   box, options);
  if (!graded || graded.value().report.changed == 0) return nullptr;
  return std::make_unique<restored_field>(std::move(graded.value().field), 1 / factor);
}

std::unique_ptr<metric_field> same_everywhere(const metric_tensor& m) {
  return std::make_unique<constant_field>(m);
}

metric_tensor mean_of(const std::vector<metric_tensor>& tensors) {
  tensor_logarithm mean;
  const double part = 1 / static_cast<double>(tensors.size());
  for (const metric_tensor& m : tensors) {
    const tensor_logarithm l = logarithm(m);
    mean = {mean.l11 + part * l.l11, mean.l12 + part * l.l12, mean.l22 + part * l.l22};
  }
  return exponential(mean);
}

std::unique_ptr<metric_field> checked(std::unique_ptr<metric_field> field) {
  return std::make_unique<checked_field>(std::move(field));
}

}  // namespace asterism::internal
