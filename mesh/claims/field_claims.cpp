// SPDX-License-Identifier: MIT
#include "asterism/mesh/claims/field_claims.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>
#include <sstream>
#include <utility>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/claims/adaptation_claims.hpp"
#include "asterism/mesh/delivery/delivered_metric.hpp"
#include "asterism/mesh/delivery/metric_complexity.hpp"
#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/mesh/metric/graded_field.hpp"
#include "asterism/mesh/metric/interpolated_field.hpp"
#include "asterism/mesh/metric/local_sizes.hpp"
#include "asterism/mesh/metric/make_metric_field.hpp"
#include "asterism/mesh/metric/variation_bound.hpp"
#include "asterism/mesh/pipeline/read_triangulation.hpp"

namespace asterism::internal {
namespace {

std::string option_of(const certificate& claim, const std::string& name) {
  const auto place = claim.options.find(name);
  return place == claim.options.end() ? "none" : place->second;
}

bool is_near(const metric_tensor& a, const metric_tensor& b) {
  const double allowed = 0x1p-40 * std::sqrt(b.m11) * std::sqrt(b.m22);
  return std::abs(a.m11 - b.m11) <= 0x1p-40 * b.m11 && std::abs(a.m12 - b.m12) <= allowed &&
         std::abs(a.m22 - b.m22) <= 0x1p-40 * b.m22;
}

std::string text_of(const metric_tensor& m) { return fmt::format("{} {} {}", m.m11, m.m12, m.m22); }

// Returns a sentence if some tensor of the mesh differs from the field's.
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

// Returns the metric given on a mesh, if the mesh's file still exists.
result<std::unique_ptr<metric_field>> background_of(const metric_wording& asked) {
  const auto background = read_metric_on_mesh(asked.name, asked.domain);
  if (!background) return background.failure();
  return make_interpolated_field(background.value().subject, asked.size);
}

// Makes the metric of the size asked for, without local sizes or gradation.
result<std::unique_ptr<metric_field>> bare_field(const metric_wording& asked, const domain& shape) {
  return is_metric_on_mesh(asked.name) ? background_of(asked)
                                       : make_metric_field(asked.name, shape.box(), asked.size);
}

// Adds local sizes and gradation to the metric.
result<std::unique_ptr<metric_field>> dressed(std::unique_ptr<metric_field> bare,
                                              const metric_wording& asked, const domain& shape) {
  const auto wishes = size_wishes_of(asked.sizes);
  if (!wishes) return wishes.failure().at("sizes");
  auto field = with_local_sizes(std::move(bare), shape, wishes.value());
  if (!field || !asked.gradation) return field;
  gradation_options options;
  options.beta = *asked.gradation;
  auto graded = grade_as_given(std::move(field).value(), shape, options);
  if (!graded) return graded.failure();
  return std::move(graded.value().field);
}

// Makes the metric that, by the certificate, was asked for; its size is the one asked for even if
// the limit on sites made edges longer. For a metric on a mesh, the file named must still hold that
// mesh.
result<std::unique_ptr<metric_field>> field_asked_for(const certificate& claim) {
  const auto placed = placed_in(claim);
  if (!placed) return error{"the certificate has no domain to place it in"};
  const auto asked = wording_in(claim);
  if (!asked) return asked.failure();
  auto bare = bare_field(asked.value(), *placed);
  if (!bare) return bare;
  const mesh* const background = bare.value()->background();
  const std::string known = option_of(claim, "metric-fingerprint");
  if (background != nullptr && known != "none" &&
      known != std::to_string(mesh_fingerprint(*background)))
    return error{"its file holds another mesh now"};
  return dressed(std::move(bare).value(), asked.value(), *placed);
}

// True if the metric was given as numbers: from a file that `certify` read, or from a program.
bool is_of_numbers(const certificate& claim) { return claim.metric.starts_with("of "); }

// True if the certificate is of a piece, and its metric was graded, or has sizes at places, over
// the whole domain.
bool is_shaped_piece(const certificate& claim) {
  return claim.options.count("metric-box") != 0 &&
         (option_of(claim, "gradation") != "none" || option_of(claim, "sizes") != "none");
}

// Returns the name of the mesh that was judged, or whose own domain an adaptation kept, else the
// name of the domain.
std::string mesh_or_domain_of(const certificate& claim) {
  if (claim.options.count("mesh") != 0) return option_of(claim, "mesh");
  std::string adapted = option_of(claim, "adapt-mesh"), meshed = option_of(claim, "domain");
  return meshed == "of " + adapted ? adapted : meshed;
}

// Computes the upper bound of the field's variation again, if the certificate claims a guarantee.
void check_variation(const certificate& claim, const metric_field& wanted, field_check& check) {
  if (!claim.guarantee || !claim.guarantee->field_variation_bound || !claim.original) return;
  const variation_bounds found = bound_variation(*claim.original, wanted);
  const double said = *claim.guarantee->field_variation_bound;
  // Requires equality to the last bit, as the same formula on the same domain has the same bound.
  if (found.above && *found.above == said) return;
  check.contradictions.push_back(
      "\"guarantee.field_variation_bound\" is " + number_text(said) + ", and the metric is " +
      (found.above ? "bounded by " + number_text(*found.above) : "not bounded: " + found.obstacle));
}

// Checks the report on the distance to the metric asked for, where another one is delivered.
void check_delivered(const mesh& subject, const certificate& claim, const metric_field& wanted,
                     field_check& check) {
  auto measured = compare_with_wanted(subject, wanted, claim.angle_bound);
  if (!measured) {
    check.contradictions.push_back("the metric wanted fails: " + measured.failure().message);
    return;
  }
  for (std::string& said : contradictions_in_delivered(*claim.delivered, measured.value()))
    check.contradictions.push_back(std::move(said));
  if (measured.value().changed > 0) check.apart = std::move(measured).value();
}

}  // namespace

result<std::unique_ptr<metric_field>> field_of(const metric_wording& asked, const domain& shape) {
  auto bare = bare_field(asked, shape);
  if (!bare) return bare;
  return dressed(std::move(bare).value(), asked, shape);
}

result<metric_wording> wording_in(const certificate& claim) {
  metric_wording asked;
  asked.name = claim.metric;
  asked.domain = mesh_or_domain_of(claim);
  if (const std::string size = option_of(claim, "size"); size != "none") {
    const auto number = parse_number(size);
    if (!number) return error{"the size is no number"};
    asked.size = number.value();
  }
  if (const std::string gradation = option_of(claim, "gradation"); gradation != "none") {
    const auto number = parse_number(gradation);
    if (!number) return error{"the gradation is no number"};
    asked.gradation = number.value();
  }
  const auto wishes = size_wishes_of(option_of(claim, "sizes"));
  if (!wishes) return error{"the sizes cannot be read: " + wishes.failure().message};
  asked.sizes = text_of(wishes.value());
  return asked;
}

std::optional<domain> placed_in(const certificate& claim) {
  const auto box = claim.options.find("metric-box");
  if (box == claim.options.end()) return claim.original;
  domain corners;
  std::istringstream words(box->second);
  std::array<std::string, 4> numbers;
  for (std::string& number : numbers) words >> number;
  std::array<double, 4> at{};
  for (std::size_t i = 0; i < at.size(); ++i) {
    const auto number = parse_number(numbers[i]);
    if (!number) return std::nullopt;
    at[i] = number.value();
  }
  corners.vertices = {{at[0], at[1]}, {at[2], at[3]}};
  return corners;
}

result<std::unique_ptr<metric_field>> field_in(const certificate& claim) {
  if (claim.delivered || is_of_adaptation(claim)) return error{"the mesh has a metric of its own"};
  if (claim.metric.empty()) return error{"the certificate names none"};
  if (is_of_numbers(claim)) return error{"it came as numbers"};
  if (is_shaped_piece(claim)) return error{"it was made of the domain of which this is a piece"};
  return field_asked_for(claim);
}

field_check check_field(const mesh& subject, const certificate& claim) {
  field_check check;
  if (claim.fingerprint != mesh_fingerprint(subject)) {
    check.why_not = "the certificate is of another mesh";
    return check;
  }
  // Checks nothing where no metric is named: callers of the library need not name one.
  if (claim.metric.empty() || is_of_numbers(claim)) {
    check.why_not = claim.metric.empty() ? "the certificate names none" : "it came as numbers";
    return check;
  }
  if (is_shaped_piece(claim)) {
    check.why_not = "it was made of the domain of which this is a piece";
    return check;
  }
  const bool is_adapted = is_of_adaptation(claim);
  const auto field = is_adapted ? check_adaptation(subject, claim, check) : field_asked_for(claim);
  if (!field) {
    check.why_not = field.failure().message;
    // Accepts that a file is missing or changed, if the words of the certificate are readable.
    const bool is_readable = wording_in(claim).ok();
    if (is_readable && (is_adapted || is_metric_on_mesh(claim.metric))) return check;
    check.contradictions.push_back("\"asked.metric\" cannot be made again: " + check.why_not);
    return check;
  }
  check.made = true;
  check_variation(claim, *field.value(), check);
  if (claim.delivered)
    check_delivered(subject, claim, *field.value(), check);
  else if (const auto said = difference_from(*field.value(), subject))
    check.contradictions.push_back(*said);
  return check;
}

field_check check_against(const mesh& subject, const metric_field& wanted,
                          std::optional<double> angle_bound) {
  field_check check;
  check.made = true;
  if (!difference_from(wanted, subject)) return check;
  auto measured = compare_with_wanted(subject, wanted, angle_bound);
  if (measured)
    check.apart = std::move(measured).value();
  else
    check.contradictions.push_back("the metric asked for fails: " + measured.failure().message);
  return check;
}

}  // namespace asterism::internal
