// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/adaptation_claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/domain/mesh_outline.hpp"
#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/mesh/metric/interpolated_field.hpp"
#include "asterism/mesh/pipeline/foreign_mesh.hpp"
#include "asterism/mesh/pipeline/metric_request.hpp"

namespace asterism::internal {
namespace {

using words = std::map<std::string, std::string>;

constexpr std::array<const char*, 3> transfer_methods = {"interpolate", "project", "bounded"};

std::string word_of(const certificate& claim, const std::string& name) {
  const auto at = claim.options.find(name);
  return at == claim.options.end() ? "none" : at->second;
}

void compare(const words& found, const certificate& claim, field_check& check) {
  for (const auto& [name, text] : found)
    if (const std::string claimed = word_of(claim, name); claimed != text)
      check.contradictions.push_back("\"" + name + "\" is " + quoted_token(claimed) +
                                     " in the certificate, and " + quoted_token(text) +
                                     " when it is made again");
}

void compare_transfer(const mesh& subject, const certificate& claim, const requested_metric& made,
                      field_check& check) {
  const std::string claimed = word_of(claim, "transfer-how");
  const bool is_method = std::find(transfer_methods.begin(), transfer_methods.end(), claimed) !=
                         transfer_methods.end();
  if (!is_method && claim.options.count("transfer-how") != 0)
    check.contradictions.push_back("\"transfer-how\" is no way to transfer a solution: " +
                                   quoted_token(claimed));
  for (std::size_t i = 0; i < transfer_methods.size(); ++i) {
    if (claimed != transfer_methods[i]) continue;
    const auto how = static_cast<transfer_method>(i);
    const auto again = transfer_solution(made.background, made.values, subject, how);
    if (!again)
      check.contradictions.push_back("the transfer cannot be made again: " +
                                     again.failure().message);
    else
      compare(words_of(again.value().report, how), claim, check);
  }
}

bool is_same_triangulation(const mesh& a, const mesh& b) {
  return a.triangles == b.triangles &&
         std::equal(a.sites.begin(), a.sites.end(), b.sites.begin(), b.sites.end(),
                    [](const site& s, const site& t) { return s.position == t.position; });
}

// Compares what is said of the domain, where it was the mesh's own.
void compare_domain(const certificate& claim, const adopted_mesh& adopted, field_check& check) {
  if (word_of(claim, "domain") != "of " + word_of(claim, "adapt-mesh")) return;
  const auto marks = read_mesh_marks(word_of(claim, "adapt-mesh"));
  const auto angle = parse_number(word_of(claim, "corner-angle"));
  if (!angle)
    check.contradictions.push_back("\"corner-angle\" is no number: " + angle.failure().message);
  if (!marks || !angle || !claim.original) return;
  outline_options options;
  options.corner_angle = angle.value();
  if (const auto hausd = parse_number(word_of(claim, "hausd")))
    options.largest_distance = hausd.value();
  const auto outline = outline_of_mesh(adopted.subject, marks.value(), options);
  if (!outline) {
    check.contradictions.push_back("the domain: " + outline.failure().message);
    return;
  }
  const mesh_outline& found = outline.value();
  compare(
      {{"boundary-vertices", std::to_string(found.boundary_vertices)},
       {"boundary-kept", std::to_string(found.keeps_all ? found.boundary_vertices : found.kept)},
       {"boundary-distance", number_text(claim.former_distance.largest_distance)}},
      claim, check);
  if (!claim.former || claim.former->between != found.former.between ||
      claim.former->allowed != found.former.allowed)
    check.contradictions.push_back("the former boundary is not that of the mesh that was adapted");
  const domain& own = found.keeps_all ? adopted.shape : found.shape;
  const domain& said = *claim.original;
  const auto same = [](const segment& s, const segment& t) {
    return s.a == t.a && s.b == t.b && s.marker == t.marker && s.internal == t.internal;
  };
  if (own.vertices != said.vertices ||
      !std::equal(own.segments.begin(), own.segments.end(), said.segments.begin(),
                  said.segments.end(), same))
    check.contradictions.push_back("the domain is not that of the mesh that was adapted");
}

// Compares what is said of the regions of the mesh that was adapted.
void compare_areas(const certificate& claim, const mesh& before, field_check& check) {
  areas_by_region areas = areas_of_regions(before);
  if (claim.regions.empty() && areas.size() == 1 && areas.begin()->first == 1) return;
  std::map<int, double> claimed;
  for (const region_area& r : claim.regions) {
    if (!r.before) {
      check.contradictions.push_back(
          fmt::format("region {} has no area before the adaptation in the certificate", r.number));
      return;
    }
    claimed[r.number] = *r.before;
  }
  for (const auto& [number, area] : areas) claimed.try_emplace(number, 0);
  for (const auto& [number, area] : claimed)
    if (const double found = areas.contains(number) ? areas[number] : 0; found != area)
      check.contradictions.push_back(
          fmt::format("the area of region {} before the adaptation is {} in the certificate, and "
                      "{} in its mesh",
                      number, number_text(area), number_text(found)));
}

}  // namespace

bool is_of_adaptation(const certificate& claim) { return claim.options.count("adapt-mesh") != 0; }

words words_of(const transfer_report& report, transfer_method how) {
  words all = {{"transfer-how", transfer_methods[static_cast<std::size_t>(how)]},
               {"transfer-area-before", number_text(report.area_before)},
               {"transfer-area-after", number_text(report.area_after)},
               {"transfer-area-common", number_text(report.area_common)},
               {"transfer-outside", std::to_string(report.outside)},
               {"transfer-partly-covered", std::to_string(report.partly_covered)}};
  for (const transferred_component& c : report.components) {
    all["transfer-integral-before " + c.name] = number_text(c.integral_before);
    all["transfer-integral-after " + c.name] = number_text(c.integral_after);
    all["transfer-range-after " + c.name] =
        number_text(c.least_after) + " to " + number_text(c.greatest_after);
  }
  return all;
}

namespace {

// Holds the words of a request against each other, whatever the files say.
void compare_request(const certificate& claim, const metric_request& request, field_check& check) {
  compare(words_of(request), claim, check);
  if (const auto failed = check_sources(request))
    check.contradictions.push_back("\"adapt-...\": " + failed->message);
  if (claim.metric != name_of(request))
    check.contradictions.push_back("\"asked.metric\" is " + quoted_token(claim.metric) +
                                   " in the certificate, and \"adapt-...\" speak of the " +
                                   name_of(request));
  if (is_of_fields(request)) return;
  // Wishes about a solution where there is none are those that nobody named.
  const words unnamed = words_of(metric_request{});
  for (const char* const name : {"adapt-hessian", "adapt-norm", "adapt-error", "adapt-fields"})
    compare({{name, unnamed.at(name)}}, claim, check);
}

}  // namespace

result<std::unique_ptr<metric_field>> check_adaptation(const mesh& subject,
                                                       const certificate& claim,
                                                       field_check& check) {
  const auto request = request_of(claim.options);
  if (!request) {
    check.contradictions.push_back(request.failure().message);
    return request.failure();
  }
  compare_request(claim, request.value(), check);
  auto made = answer(request.value());
  if (!made) return made.failure();
  compare(words_of(made.value().report), claim, check);
  compare_transfer(subject, claim, made.value(), check);
  const auto adopted = adopt_mesh(made.value().background);
  if (!adopted) return adopted.failure();
  auto field = make_sampled_field(adopted.value().subject, 1);
  compare_domain(claim, adopted.value(), check);
  compare_areas(claim, adopted.value().subject, check);
  compare({{"kept", is_same_triangulation(subject, adopted.value().subject) ? "yes" : "no"}}, claim,
          check);
  if (word_of(claim, "metric-fingerprint") !=
      std::to_string(mesh_fingerprint(*field->background())))
    return error{"its files hold another metric now"};
  return field;
}

}  // namespace asterism::internal
