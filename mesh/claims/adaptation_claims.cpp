// SPDX-License-Identifier: MIT
#include "asterism/mesh/claims/adaptation_claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/claims/metric_request.hpp"
#include "asterism/mesh/claims/metric_words.hpp"
#include "asterism/mesh/data/same_triangulation.hpp"
#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/mesh/metric/interpolated_field.hpp"
#include "asterism/mesh/pipeline/foreign_mesh.hpp"
#include "asterism/mesh/pipeline/frozen_regions.hpp"
#include "asterism/mesh/pipeline/joined_marks.hpp"
#include "asterism/mesh/pipeline/outline_chords.hpp"
#include "asterism/mesh/pipeline/periodic_outline.hpp"

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

// The mesh that was adapted: that of the file, or its part outside frozen regions.
struct adapted_rest {
  adopted_mesh adopted;
  std::optional<frozen_part> part;
};

result<adapted_rest> rest_as_claimed(const certificate& claim, const adopted_mesh& whole,
                                     field_check& check) {
  if (claim.options.count("frozen") == 0) return adapted_rest{whole, {}};
  std::vector<int> regions;
  std::string list = word_of(claim, "frozen") + ",";
  for (std::size_t at = 0, comma = 0; (comma = list.find(',', at)) != std::string::npos;
       at = comma + 1) {
    const std::size_t begin = list.find_first_not_of(' ', at);
    const auto number = parse_number(list.substr(begin, comma - begin));
    if (!number) return number.failure().at("\"frozen\"");
    regions.push_back(static_cast<int>(number.value()));
  }
  const auto length = parse_number(word_of(claim, "frozen-border-length"));
  if (!length) return length.failure().at("\"frozen-border-length\"");
  auto part = without_regions(whole.subject, regions);
  if (!part) return part.failure();
  const std::size_t coarser = coarsen_border(part.value(), length.value());
  const frozen_angles angles =
      angles_of_frozen(part.value(), whole.subject, claim.angle_bound.value_or(0));
  compare({{"frozen-border-coarser", std::to_string(coarser)},
           {"frozen-triangles", std::to_string(part.value().frozen.size())},
           {"frozen-low", std::to_string(angles.low)},
           {"frozen-worst-angle", number_text(angles.worst)}},
          claim, check);
  auto adopted = adopt_mesh(part.value().rest);
  if (!adopted) return adopted.failure();
  return adapted_rest{std::move(adopted).value(), std::move(part).value()};
}

// Returns the mesh as in its file: with slits parted and frozen triangles added.
mesh written_of(const mesh& subject, const adopted_mesh& whole, const adapted_rest& rest) {
  if (!rest.part) return part_cracks(subject, whole.cracks).content;
  std::size_t split = 0;
  auto together = with_frozen(subject, *rest.part, whole.subject, split);
  return together ? *std::move(together) : subject;
}

// Compares the claims about the domain, if the domain is that of the mesh that was adapted.
void compare_domain(const certificate& claim, const adapted_rest& rest, field_check& check) {
  const adopted_mesh& adopted = rest.adopted;
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
  if (const auto part = parse_number(word_of(claim, "boundary-part")))
    options.part_of_length = options.part_of_size = part.value();
  const auto outline =
      outline_with_partners(adopted.subject,
                            rest.part ? marks_of_rest(*rest.part, marks.value())
                                      : joined_marks(marks.value(), adopted.number),
                            options, claim.periodic_asked);
  if (!outline) {
    check.contradictions.push_back("the domain: " + outline.failure().message);
    return;
  }
  const mesh_outline& found = outline.value().found;
  compare(
      {{"boundary-vertices", std::to_string(found.boundary_vertices)},
       {"boundary-kept", std::to_string(found.keeps_all ? found.boundary_vertices : found.kept)},
       {"boundary-distance", number_text(claim.former_distance.largest_distance)}},
      claim, check);
  // Uses the outline without chords if the adaptation kept the mesh, or if sides are periodic.
  const bool is_whole = word_of(claim, "kept") == "yes" || !claim.periodic_asked.empty();
  const chorded_outline now = is_whole ? chorded_outline{found.shape, found.former}
                                       : with_chords_for(adopted.subject, found);
  if (!claim.former || claim.former->between != now.former.between ||
      claim.former->allowed != now.former.allowed)
    check.contradictions.push_back("the former boundary is not that of the mesh that was adapted");
  const domain& own = found.keeps_all ? adopted.shape : now.shape;
  const domain& said = *claim.original;
  const auto same = [](const segment& s, const segment& t) {
    return s.a == t.a && s.b == t.b && s.marker == t.marker && s.internal == t.internal;
  };
  if (own.vertices != said.vertices ||
      !std::equal(own.segments.begin(), own.segments.end(), said.segments.begin(),
                  said.segments.end(), same))
    check.contradictions.push_back("the domain is not that of the mesh that was adapted");
}

// Compares the claims about regions of the mesh that was adapted.
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

// Compares the words of a request with each other, without reading files.
void compare_request(const certificate& claim, const metric_request& request, field_check& check) {
  compare(words_of(request), claim, check);
  if (const auto failed = check_sources(request))
    check.contradictions.push_back("\"adapt-...\": " + failed->message);
  if (claim.metric != name_of(request))
    check.contradictions.push_back("\"asked.metric\" is " + quoted_token(claim.metric) +
                                   " in the certificate, and \"adapt-...\" speak of the " +
                                   name_of(request));
  if (is_of_fields(request)) return;
  // Accepts the defaults of options about a solution where there is none.
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
  metric_request asked = request.value();
  asked.periodic = claim.periodic_asked;
  auto made = answer(asked);
  if (!made) return made.failure();
  compare(words_of(made.value().report), claim, check);
  const auto whole = adopt_mesh(made.value().background, region_edges::segments, slit_rule::joined);
  if (!whole) return whole.failure();
  auto rest = rest_as_claimed(claim, whole.value(), check);
  if (!rest) return rest.failure();
  const auto& adopted = rest.value().adopted;
  compare_transfer(written_of(subject, whole.value(), rest.value()), claim, made.value(), check);
  auto field = make_interpolated_field(adopted.subject, 1);
  compare_domain(claim, rest.value(), check);
  compare_areas(claim, adopted.subject, check);
  compare({{"kept", is_same_triangulation(subject, adopted.subject) ? "yes" : "no"}}, claim, check);
  if (word_of(claim, "metric-fingerprint") !=
      std::to_string(mesh_fingerprint(*field->background())))
    return error{"its files hold another metric now"};
  return field;
}

}  // namespace asterism::internal
