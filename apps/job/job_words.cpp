// SPDX-License-Identifier: MIT
#include "asterism/apps/job/job_words.hpp"

#include <fmt/format.h>

#include <array>
#include <cstddef>

#include "asterism/apps/text/summary.hpp"
#include "asterism/core/number_text.hpp"
#include "asterism/mesh/audit/certificate.hpp"

namespace asterism::apps {
using namespace internal;
namespace {

// Returns all places where the domain was repaired, each as a word and two coordinates.
std::string text_of_places(const domain_repairs& repairs) {
  std::string text;
  for (const repair_place& place : repairs.places)
    text += fmt::format("{}{} {} {}", text.empty() ? "" : "; ", place.what, number_text(place.at.x),
                        number_text(place.at.y));
  return text.empty() ? "none" : text;
}

// Returns the size for which the mesh was made; "none" also where it was made without demands.
std::string text_of_size_delivered(const mesh_job& job, const mesh_outcome& outcome) {
  const bool demanded = !outcome.one_metric || outcome.one_metric->has_demands;
  return job.size && demanded ? number_text(*job.size * outcome.ended.length_factor) : "none";
}

}  // namespace

std::map<std::string, std::string> options_of(const mesh_job& job, const prepared_input& input,
                                              const mesh_outcome& outcome) {
  const mesh_options& asked = job.refinement;
  const std::array<const char*, 3> strategies = {"voronoi", "darts", "fill"};
  std::map<std::string, std::string> words = {
      {"domain", job.domain},
      {"angle-bound", number_text(asked.angle_bound)},
      {"vertices", asked.vertices ? std::to_string(*asked.vertices) : "none"},
      {"complexity", job.complexity ? number_text(*job.complexity) : "none"},
      {"complexity-delivered",
       input.metric.complexity ? number_text(*input.metric.complexity) : "none"},
      {"size", job.size ? number_text(*job.size) : "none"},
      {"sizes", asterism::text_of(input.sizes)},
      {"size-delivered", text_of_size_delivered(job, outcome)},
      {"gradation", job.gradation ? number_text(*job.gradation) : "none"},
      {"gradation-done", input.metric.gradation ? text_of(*input.metric.gradation) : "none"},
      {"refine", strategies[static_cast<std::size_t>(asked.strategy)]},
      {"tol", asked.tolerance ? number_text(*asked.tolerance) : "chosen"},
      {"tol-at-end", number_text(outcome.ended.tolerance)},
      {"improve", std::to_string(asked.improve_passes)},
      {"improve-done", outcome.improved ? text_of(*outcome.improved, outcome.sites) : "none"},
      {"certify", job.refinement.prove_voronoi ? "voronoi" : "stars"},
      {"max-sites", std::to_string(asked.max_sites)},
      {"chord-tolerance", job.chord_tolerance ? number_text(*job.chord_tolerance) : "none"},
      {"regions", job.number_regions ? "numbered" : "as given"},
      {"repair-distance",
       input.repairs.distance > 0 ? number_text(input.repairs.distance) : "none"},
      {"repair-done", input.repairs.distance > 0 ? text_of(input.repairs) : "none"},
      {"repair-places", text_of_places(input.repairs)},
      {"random-points", std::to_string(job.random_points)},
      {"metric-fingerprint", input.metric.background_fingerprint
                                 ? std::to_string(*input.metric.background_fingerprint)
                                 : "none"},
      {"metric-tolerance", asked.metric_tolerance ? number_text(*asked.metric_tolerance) : "none"},
      {"seed", std::to_string(asked.seed)}};
  if (job.guarantee) words.emplace("guarantee", "asked");
  return words;
}

std::string file_note_of(const certificate& claim) {
  if (claim.complete && claim.certified) return "";
  const bool in_another_metric = claim.delivered && claim.certified;
  return (in_another_metric ? "Incomplete, certified in a metric that is not the one asked for: "
                            : "Incomplete, not certified: ") +
         claim.reason;
}

}  // namespace asterism::apps
