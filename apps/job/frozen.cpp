// SPDX-License-Identifier: MIT
#include "asterism/apps/job/frozen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/mesh/pipeline/foreign_mesh.hpp"
#include "asterism/mesh/pipeline/frozen_regions.hpp"

namespace asterism::apps {
using namespace internal;
namespace {

std::string list_of(const std::vector<int>& regions) {
  return fmt::format("{}", fmt::join(regions, ", "));
}

// Returns the names of the regions in a file, as the end of a message.
std::string names_of(const physical_names& names) {
  std::string text;
  for (const auto& [number, name] : names.regions)
    text += (text.empty() ? "; it names " : ", ") + quoted_token(name);
  return text.empty() ? "; it names none, and a number is wanted" : text;
}

}  // namespace

result<std::vector<int>> frozen_regions(const std::vector<std::string>& named,
                                        const std::string& mesh_file) {
  std::vector<int> regions;
  for (const std::string& name : named) {
    const auto number = parse_number(name);
    if (number && number.value() == static_cast<int>(number.value())) {
      regions.push_back(static_cast<int>(number.value()));
      continue;
    }
    const physical_names names = names_in(mesh_file);
    const auto at = std::find_if(names.regions.begin(), names.regions.end(),
                                 [&name](const auto& one) { return one.second == name; });
    if (at == names.regions.end())
      return error{
          "--frozen: " + mesh_file + " names no region " + quoted_token(name) + names_of(names),
          error_code::bad_option};
    regions.push_back(at->first);
  }
  std::sort(regions.begin(), regions.end());
  regions.erase(std::unique(regions.begin(), regions.end()), regions.end());
  return regions;
}

result<frozen_run> adapt_the_rest(const std::vector<int>& regions, const marked_mesh& from,
                                  const mesh_adaptation_options& options,
                                  const progress_listener& progress) {
  const auto adopted = adopt_mesh(from.subject);
  if (!adopted) return adopted.failure();
  const mesh& whole = adopted.value().subject;
  const auto parted = without_regions(whole, regions);
  if (!parted) return error{"--frozen: " + parted.failure().message, parted.failure().code};
  const mesh_marks marks = marks_of_rest(parted.value(), from.marks);
  std::size_t split = 0;
  for (const double longest : border_lengths) {
    frozen_part part = parted.value();
    frozen_run made;
    made.facts.regions = regions;
    made.facts.border_length = longest;
    made.facts.coarser = coarsen_border(part, longest);
    auto next = adapt_to_metric({part.rest, marks}, options, progress);
    if (!next) return next.failure();
    auto together = with_frozen(next.value().made.outcome.result, part, whole, split);
    if (!together && !next.value().made.outcome.stopped) continue;
    if (!together) break;
    const frozen_angles angles = angles_of_frozen(part, whole, options.refinement.angle_bound);
    made.facts.triangles = part.frozen.size();
    made.facts.worst_angle = angles.worst;
    made.facts.low = angles.low;
    made.next = std::move(next).value();
    made.together = *std::move(together);
    made.background = std::move(part.rest);
    return made;
  }
  frozen_run made;
  made.border_split = split;
  return made;
}

void describe_frozen(const frozen_facts& facts, certificate& claim) {
  if (facts.regions.empty()) return;
  claim.options["frozen"] = list_of(facts.regions);
  claim.options["frozen-triangles"] = std::to_string(facts.triangles);
  claim.options["frozen-low"] = std::to_string(facts.low);
  claim.options["frozen-worst-angle"] = number_text(facts.worst_angle);
  claim.options["frozen-border-length"] = number_text(facts.border_length);
  claim.options["frozen-border-coarser"] = std::to_string(facts.coarser);
}

std::string text_of(const frozen_facts& facts, double angle_bound) {
  std::string text = fmt::format(
      "frozen, not judged: {} triangles of region{} {}, as they were, {} of them below {:g} "
      "degrees, "
      "the least angle {:.2f}",
      facts.triangles, facts.regions.size() == 1 ? "" : "s", list_of(facts.regions), facts.low,
      angle_bound, facts.worst_angle);
  if (facts.coarser > 0)
    text += fmt::format("; the metric is coarser at {} vertices of their border, whose edges stay",
                        facts.coarser);
  return text;
}

}  // namespace asterism::apps
