// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/field_claims.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/mesh/metric/graded_field.hpp"
#include "asterism/mesh/metric/interpolated_field.hpp"
#include "asterism/mesh/metric/make_metric_field.hpp"
#include "asterism/mesh/pipeline/adaptation_claims.hpp"
#include "asterism/mesh/pipeline/delivered_metric.hpp"
#include "asterism/mesh/pipeline/foreign_mesh.hpp"
#include "asterism/mesh/pipeline/metric_complexity.hpp"

namespace asterism::internal {
namespace {

std::string option_of(const certificate& claim, const std::string& name) {
  const auto place = claim.options.find(name);
  return place == claim.options.end() ? "none" : place->second;
}

// Returns the number an option has; 1 where it is "none".
result<double> size_of(const certificate& claim, const std::string& name) {
  const std::string text = option_of(claim, name);
  return text == "none" ? result<double>(1.0) : parse_number(text);
}

bool is_near(const metric_tensor& a, const metric_tensor& b) {
  const double allowed = 0x1p-40 * std::sqrt(b.m11) * std::sqrt(b.m22);
  return std::abs(a.m11 - b.m11) <= 0x1p-40 * b.m11 && std::abs(a.m12 - b.m12) <= allowed &&
         std::abs(a.m22 - b.m22) <= 0x1p-40 * b.m22;
}

std::string text_of(const metric_tensor& m) { return fmt::format("{} {} {}", m.m11, m.m12, m.m22); }

// Returns a sentence if the tensors are not the field's.
std::optional<std::string> difference_from(const metric_field& field, const mesh& subject) {
  std::size_t differing = 0;
  std::string first;
  for (std::size_t v = 0; v < subject.sites.size(); ++v) {
    const site& s = subject.sites[v];
    const auto asked = field.at(s.position);
    if (asked && is_near(s.metric, asked.value())) continue;
    if (differing++ > 0) continue;
    first = fmt::format("vertex {} has {}, and should have {}", v + 1, text_of(s.metric),
                        asked ? text_of(asked.value()) : "none: " + asked.failure().message);
  }
  if (differing == 0) return std::nullopt;
  return fmt::format("the tensors of {} of {} vertices are not those of \"asked.metric\": {}",
                     differing, subject.sites.size(), first);
}

// Returns the metric of a mesh, where its file is still there.
result<std::unique_ptr<metric_field>> background_of(const certificate& claim, double size) {
  auto background = read_mesh(claim.metric);
  if (!background) return background.failure();
  const auto adopted = adopt_mesh(std::move(background).value());
  if (!adopted) return adopted.failure();
  return make_sampled_field(adopted.value().subject, size);
}

// Passes on a field that is on a mesh if that is the mesh the certificate names, graded as it was.
result<std::unique_ptr<metric_field>> if_the_same(const certificate& claim,
                                                  std::unique_ptr<metric_field> field) {
  const mesh* const background = field->background();
  if (background != nullptr &&
      option_of(claim, "metric-fingerprint") != std::to_string(mesh_fingerprint(*background)))
    return error{"its file holds another mesh now"};
  return field;
}

}  // namespace

// Tensors are those of the size asked for even where the limit on sites made edges longer.
result<std::unique_ptr<metric_field>> field_asked_for(const certificate& claim) {
  if (!claim.original) return error{"the certificate has no domain to place it in"};
  const auto size = size_of(claim, "size");
  if (!size) return error{"the size is no number"};
  const bounding_box box = claim.original->box();
  auto field = is_mesh_file(claim.metric) ? background_of(claim, size.value())
                                          : make_metric_field(claim.metric, box, size.value());
  const std::string gradation = option_of(claim, "gradation");
  if (!field) return field;
  if (gradation == "none") return if_the_same(claim, std::move(field).value());
  const auto beta = parse_number(gradation);
  if (!beta) return error{"the gradation is no number"};
  gradation_options options;
  options.beta = beta.value();
  auto graded = grade_as_given(std::move(field).value(), *claim.original, options);
  if (!graded) return graded.failure();
  return if_the_same(claim, std::move(graded.value().field));
}

namespace {

// True if the metric came as numbers, and is named by its file; `mesh` takes them on a mesh alone.
bool is_of_file(const certificate& claim) {
  return claim.options.count("mesh") != 0 && claim.metric.starts_with("of ");
}

}  // namespace

field_check check_field(const mesh& subject, const certificate& claim) {
  field_check check;
  if (claim.fingerprint != mesh_fingerprint(subject)) {
    check.why_not = "the certificate is of another mesh";
    return check;
  }
  if (is_of_file(claim)) {
    check.why_not = "it was read from a file";
    return check;
  }
  // Whoever calls the library need not name a metric.
  if (claim.options.empty() && claim.metric.empty()) {
    check.why_not = "the certificate names none";
    return check;
  }
  const bool is_adapted = is_of_adaptation(claim);
  const auto field = is_adapted ? check_adaptation(subject, claim, check) : field_asked_for(claim);
  if (!field) {
    check.why_not = field.failure().message;
    // A file may be gone, or another by now.
    if (is_adapted || is_mesh_file(claim.metric)) return check;
    check.contradictions.push_back("\"asked.metric\" cannot be made again: " + check.why_not);
    return check;
  }
  check.made = true;
  if (claim.delivered) {
    for (std::string& said : contradictions_in_delivered(subject, claim, *field.value()))
      check.contradictions.push_back(std::move(said));
    return check;
  }
  if (const auto said = difference_from(*field.value(), subject))
    check.contradictions.push_back(*said);
  return check;
}

}  // namespace asterism::internal
