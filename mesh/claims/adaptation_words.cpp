// SPDX-License-Identifier: MIT
#include "asterism/mesh/claims/adaptation_words.hpp"

#include <map>
#include <utility>
#include <vector>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/claims/adaptation_claims.hpp"
#include "asterism/mesh/claims/metric_words.hpp"
#include "asterism/mesh/domain/mesh_outline.hpp"
#include "asterism/mesh/metric/interpolated_field.hpp"
#include "asterism/mesh/pipeline/foreign_mesh.hpp"

namespace asterism::internal {
namespace {

// Sets the area before adaptation of every region, and adds those regions of `before` that the new
// mesh no longer has.
void note_areas_before(const mesh& before, std::vector<region_area>& regions) {
  const areas_by_region areas = areas_of_regions(before);
  if (regions.empty() && areas.size() == 1 && areas.begin()->first == 1) return;
  std::map<int, region_area> all;
  for (const region_area& r : regions) all[r.number] = r;
  for (const auto& [number, area] : areas) all[number].before = area;
  regions.clear();
  for (auto& [number, r] : all) {
    r.number = number;
    if (!r.before) r.before = 0;
    regions.push_back(r);
  }
}

std::string fingerprint_of(const mesh& background) {
  const auto adopted = adopt_mesh(background, region_edges::segments, slit_rule::joined);
  if (!adopted) return "none";
  const auto field = make_interpolated_field(adopted.value().subject, 1);
  return std::to_string(mesh_fingerprint(*field->background()));
}

}  // namespace

void describe_adaptation(adapted_mesh& next, const adaptation_wording& w) {
  certificate& claim = next.made.claim;
  note_areas_before(w.background, claim.regions);
  claim.metric = name_of(w.request);
  const auto& tolerance = w.options.refinement.metric_tolerance;
  const auto& hausd = w.options.largest_boundary_distance;
  claim.options = {{"domain", w.domain.empty() ? "of " + w.request.mesh : w.domain},
                   {"angle-bound", number_text(w.options.refinement.angle_bound)},
                   {"corner-angle", number_text(w.options.corner_angle)},
                   {"hausd", hausd ? number_text(*hausd) : "none"},
                   {"metric-tolerance", tolerance ? number_text(*tolerance) : "none"},
                   {"kept", next.kept ? "yes" : "no"},
                   {"boundary-vertices", std::to_string(next.boundary_vertices)},
                   {"boundary-kept", std::to_string(next.boundary_kept)},
                   {"boundary-distance", number_text(next.boundary_distance)},
                   {"metric-fingerprint", fingerprint_of(w.background)}};
  if (w.options.boundary_part)
    claim.options["boundary-part"] = number_text(*w.options.boundary_part);
  if (w.options.no_split_across) claim.options["split-across"] = "no";
  claim.options.merge(words_of(w.request));
  claim.options.merge(words_of(w.report));
  if (w.transfer != nullptr) claim.options.merge(words_of(*w.transfer, w.how));
  if (w.transfer != nullptr && !w.request.carried.empty())
    claim.options["transfer-carried"] = w.request.carried;
}

}  // namespace asterism::internal
