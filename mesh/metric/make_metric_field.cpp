// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric/make_metric_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/core/number_text.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/metric/layered_field.hpp"
#include "asterism/mesh/metric/plane_expression.hpp"
#include "asterism/mesh/metric/sized_field.hpp"

namespace asterism {
using namespace internal;

namespace {

class identity_field : public sized_field {
 public:
  using sized_field::sized_field;

 private:
  result<metric_tensor> unsized(const point&) const override { return metric_tensor{1, 0, 1}; }
};

// Both are I + K u u^T, round in the middle of the box, of aspect sqrt(1 + K |p|^2): `swirl`, with
// u = p = (q - centre) / radius, is stretched along circles, `sink`, with u = p turned by a
// quarter, along rays.
class rotating_field : public sized_field {
 public:
  enum class kind { swirl, sink };
  rotating_field(double size, kind k, double strength, const field_frame& frame)
      : sized_field(size), kind_(k), strength_(strength), frame_(frame) {}

 private:
  result<metric_tensor> unsized(const point& q) const override {
    const point p = frame_.local(q);
    const point u = kind_ == kind::swirl ? p : point{-p.y, p.x};
    return metric_tensor{1 + strength_ * (u.x * u.x), strength_ * (u.x * u.y),
                         1 + strength_ * (u.y * u.y)};
  }

  kind kind_;
  double strength_;
  field_frame frame_;
};

class expression_field : public sized_field {
 public:
  expression_field(double size, std::array<plane_expression, 3> entries)
      : sized_field(size), entries_(std::move(entries)) {}

 private:
  // Evaluates the formulas. An expression holds its variables, so one thread at a time.
  result<metric_tensor> unsized(const point& q) const override {
    const std::lock_guard<std::mutex> alone(mutex_);
    std::array<double, 3> m{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto value = entries_[i](q);
      if (!value.ok()) return value.failure();
      m[i] = value.value();
    }
    return metric_tensor{m[0], m[1], m[2]};
  }

  std::array<plane_expression, 3> entries_;
  mutable std::mutex mutex_;
};

made_field make_rotating(std::string_view specification, rotating_field::kind kind,
                         std::optional<std::string_view> parameter, const bounding_box& box,
                         double size) {
  double strength = 12;
  if (parameter) {
    const auto value = parse_number(*parameter);
    if (!value.ok()) return bad_metric(specification, "K: " + value.failure().message);
    if (value.value() < 0)
      return bad_metric(specification, "K must not be negative, not " + std::string(*parameter));
    strength = value.value();
  }
  const auto frame = frame_in_the_middle(box);
  if (!frame) return bad_metric(specification, "the domain has no extent to scale it to");
  return made_field(std::make_unique<rotating_field>(size, kind, strength, *frame));
}

made_field make_expression(std::string_view specification, std::string_view text, double size) {
  std::vector<plane_expression> entries;
  constexpr std::array<std::string_view, 3> names = {"M11", "M12", "M22"};
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(';', begin), text.size());
    if (entries.size() == 3)
      return bad_metric(specification, "three expressions are wanted, M11;M12;M22; there are more");
    auto entry = plane_expression::parse(std::string(text.substr(begin, end - begin)));
    if (!entry.ok())
      return bad_metric(specification,
                        std::string(names[entries.size()]) + ": " + entry.failure().message);
    entries.push_back(std::move(entry).value());
    begin = end + 1;
  }
  if (entries.size() < 3)
    return bad_metric(specification, "three expressions are wanted, M11;M12;M22; there are only " +
                                         std::to_string(entries.size()));
  return made_field(std::make_unique<expression_field>(
      size, std::array<plane_expression, 3>{std::move(entries[0]), std::move(entries[1]),
                                            std::move(entries[2])}));
}

}  // namespace

result<std::unique_ptr<metric_field>> make_metric_field(std::string_view specification,
                                                        const bounding_box& box, double size) {
  if (!(size > 0) || !std::isfinite(size))
    return error{fmt::format("size must be positive and finite, not {}", size),
                 error_code::bad_option};
  const std::size_t colon = specification.find(':');
  const std::string_view name = specification.substr(0, colon);
  std::optional<std::string_view> parameter;
  if (colon != std::string_view::npos) parameter = specification.substr(colon + 1);

  if (name == "identity") {
    if (parameter) return bad_metric(specification, "identity takes no parameter");
    return made_field(std::make_unique<identity_field>(size));
  }
  if (name == "swirl")
    return make_rotating(specification, rotating_field::kind::swirl, parameter, box, size);
  if (name == "sink")
    return make_rotating(specification, rotating_field::kind::sink, parameter, box, size);
  if (name == "expr") return make_expression(specification, parameter.value_or(""), size);
  if (auto layered = make_layered_field(specification, name, parameter, box, size))
    return std::move(*layered);
  return bad_metric(specification,
                    "unknown; there are identity, swirl[:K], sink[:K], layer[:H0,H1], shock[:A], "
                    "linear, polar-1, polar-2, circle-1 and expr:M11;M12;M22");
}

}  // namespace asterism
