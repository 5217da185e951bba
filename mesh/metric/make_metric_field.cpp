// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric/make_metric_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/core/number_text.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/metric/expression_enclosure.hpp"
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
  std::optional<tensor_jet> unsized_over(const plane_jet&) const override {
    return tensor_jet{1, 0, 1};
  }
};

// Makes I + K u u^T, round in the middle of the box, of aspect sqrt(1 + K |p|^2): `swirl`, with
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
  std::optional<tensor_jet> unsized_over(const plane_jet& at) const override {
    const plane_jet p = frame_.local(at);
    const plane_jet u = kind_ == kind::swirl ? p : plane_jet{-p.y, p.x};
    return tensor_jet{1 + strength_ * square(u.x), strength_ * (u.x * u.y),
                      1 + strength_ * square(u.y)};
  }

  kind kind_;
  double strength_;
  field_frame frame_;
};

class expression_field : public sized_field {
 public:
  expression_field(double size, std::array<plane_expression, 3> entries,
                   std::optional<std::array<expression_enclosure, 3>> enclosures)
      : sized_field(size), entries_(std::move(entries)), enclosures_(std::move(enclosures)) {}

 private:
  result<metric_tensor> unsized(const point& q) const override {
    return metric_tensor{entries_[0](q), entries_[1](q), entries_[2](q)};
  }
  std::optional<tensor_jet> unsized_over(const plane_jet& at) const override {
    if (!enclosures_) return std::nullopt;
    const auto& [m11, m12, m22] = *enclosures_;
    return tensor_jet{m11.over(at), m12.over(at), m22.over(at)};
  }

  std::array<plane_expression, 3> entries_;
  std::optional<std::array<expression_enclosure, 3>> enclosures_;
};

made_field make_identity(const field_request& asked) {
  if (asked.parameter) return takes_no_parameter(asked);
  return made_field(std::make_unique<identity_field>(asked.size));
}

template <rotating_field::kind kind>
made_field make_rotating(const field_request& asked) {
  double strength = 12;
  if (asked.parameter) {
    const auto value = parse_number(*asked.parameter);
    if (!value.ok()) return bad_metric(asked.specification, "K: " + value.failure().message);
    if (value.value() < 0)
      return bad_metric(asked.specification,
                        "K must not be negative, not " + std::string(*asked.parameter));
    strength = value.value();
  }
  const auto frame = frame_in_the_middle(asked.box);
  if (!frame) return bad_metric(asked.specification, "the domain has no extent to scale it to");
  return made_field(std::make_unique<rotating_field>(asked.size, kind, strength, *frame));
}

made_field make_expression(const field_request& asked) {
  std::vector<plane_expression> entries;
  std::vector<expression_enclosure> enclosures;
  constexpr std::array<std::string_view, 3> names = {"M11", "M12", "M22"};
  const std::string_view text = asked.parameter.value_or("");
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(';', begin), text.size());
    if (entries.size() == 3)
      return bad_metric(asked.specification,
                        "three expressions are wanted, M11;M12;M22; there are more");
    const std::string formula(text.substr(begin, end - begin));
    auto entry = plane_expression::parse(formula);
    if (!entry.ok())
      return bad_metric(asked.specification,
                        std::string(names[entries.size()]) + ": " + entry.failure().message);
    entries.push_back(std::move(entry).value());
    if (auto enclosure = expression_enclosure::parse(formula))
      enclosures.push_back(std::move(*enclosure));
    begin = end + 1;
  }
  if (entries.size() < 3)
    return bad_metric(asked.specification,
                      "three expressions are wanted, M11;M12;M22; there are only " +
                          std::to_string(entries.size()));
  std::optional<std::array<expression_enclosure, 3>> enclosed;
  if (enclosures.size() == 3) enclosed = {enclosures[0], enclosures[1], enclosures[2]};
  return made_field(std::make_unique<expression_field>(
      asked.size,
      std::array<plane_expression, 3>{std::move(entries[0]), std::move(entries[1]),
                                      std::move(entries[2])},
      std::move(enclosed)));
}

constexpr std::array<named_field, 4> tensor_fields = {{
    {"identity", "", "the same everywhere", make_identity},
    {"swirl", "[:K]",
     "stretched along circles around the middle of the domain's box, by sqrt(1+K) at half of its "
     "longer side (12)",
     make_rotating<rotating_field::kind::swirl>},
    {"sink", "[:K]", "stretched as much along rays (12)",
     make_rotating<rotating_field::kind::sink>},
    {"expr", ":M11;M12;M22", "three formulas in x and y", make_expression},
}};

// Returns the rows of all fields: those given by tensors, then those given by lengths.
std::vector<named_field> named_fields() {
  std::vector<named_field> all(tensor_fields.begin(), tensor_fields.end());
  const auto layered = layered_fields();
  all.insert(all.end(), layered.begin(), layered.end());
  return all;
}

// Returns the names with their arguments, such as "identity, swirl[:K] and sink[:K]".
std::string listed_names() {
  std::string text;
  const std::vector<metric_name> names = metric_names();
  for (std::size_t i = 0; i < names.size(); ++i)
    text += fmt::format("{}{}{}",
                        i == 0                 ? ""
                        : i + 1 < names.size() ? ", "
                                               : " and ",
                        names[i].name, names[i].arguments);
  return text;
}

}  // namespace

std::vector<metric_name> metric_names() {
  std::vector<metric_name> names;
  for (const named_field& row : named_fields())
    names.push_back({row.name, row.arguments, row.sentence});
  return names;
}

result<std::unique_ptr<metric_field>> make_metric_field(std::string_view specification,
                                                        const bounding_box& box, double size) {
  if (!(size > 0) || !std::isfinite(size))
    return error{fmt::format("size must be positive and finite, not {}", size),
                 error_code::bad_option};
  const std::size_t colon = specification.find(':');
  field_request asked{specification, std::nullopt, box, size};
  if (colon != std::string_view::npos) asked.parameter = specification.substr(colon + 1);
  for (const named_field& row : named_fields())
    if (row.name == specification.substr(0, colon)) return row.make(asked);
  return bad_metric(specification, "unknown; there are " + listed_names());
}

}  // namespace asterism
