// SPDX-License-Identifier: MIT
#include "asterism/apps/mesh_job.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <array>
#include <iostream>
#include <iterator>
#include <map>
#include <system_error>
#include <utility>

#include "asterism/apps/complain.hpp"
#include "asterism/apps/held_signals.hpp"
#include "asterism/apps/job_input.hpp"
#include "asterism/apps/places.hpp"
#include "asterism/apps/progress_line.hpp"
#include "asterism/apps/run_limits.hpp"
#include "asterism/apps/summary.hpp"
#include "asterism/core/number_text.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/medit.hpp"
#include "asterism/mesh/io/render_mesh.hpp"
#include "asterism/mesh/io/write_mesh.hpp"
#include "asterism/mesh/pipeline/certified_mesh.hpp"

namespace asterism::apps {
using namespace internal;
namespace fs = std::filesystem;
namespace {

// Every file the job reads or writes is a different one, and each can be written.
std::optional<error> check_files(const mesh_job& job, const fs::path& certificate_path) {
  std::vector<fs::path> used = {certificate_path};
  std::error_code ignored;
  std::vector<fs::path> read = {job.domain};
  if (has_ending(job.metric, ".mesh") && job.metric != job.domain) read.emplace_back(job.metric);
  for (const fs::path& file : read) {
    if (fs::is_regular_file(file, ignored)) used.push_back(file);
    if (has_ending(file.string(), ".mesh") && fs::is_regular_file(solution_path(file), ignored))
      used.push_back(solution_path(file));
    const fs::path vertices = fs::path(file).replace_extension(".node");
    if (has_ending(file.string(), ".poly") && fs::is_regular_file(vertices, ignored))
      used.push_back(vertices);
  }
  for (const fs::path& output : job.outputs) {
    const auto format = check_output(output);
    if (!format) return format.failure();
    used.push_back(output);
    if (format.value() != mesh_format::medit) continue;
    used.push_back(solution_path(output));
    if (auto failure = check_place(used.back())) return failure;
  }
  if (auto failure = check_distinct(used)) return failure;
  return check_place(certificate_path);
}

// The size the mesh was made for; none, too, where the relaxed mesh was made without demands.
std::string text_of_size_delivered(const mesh_job& job, const mesh_outcome& outcome) {
  const bool demanded =
      !outcome.relaxed || outcome.relaxed->kind != relaxation_kind::without_demands;
  return job.size && demanded ? number_text(*job.size * outcome.ended.length_factor) : "none";
}

std::map<std::string, std::string> options_of(const mesh_job& job, const prepared_input& input,
                                              const mesh_outcome& outcome) {
  const mesh_options& asked = job.refinement;
  const std::array<const char*, 3> strategies = {"voronoi", "darts", "fill"};
  return {{"domain", job.domain},
          {"angle-bound", number_text(asked.angle_bound)},
          {"size", job.size ? number_text(*job.size) : "none"},
          {"size-delivered", text_of_size_delivered(job, outcome)},
          {"gradation", job.gradation ? number_text(*job.gradation) : "none"},
          {"gradation-done", input.gradation ? text_of(*input.gradation) : "none"},
          {"refine", strategies[static_cast<std::size_t>(asked.strategy)]},
          {"tol", asked.tolerance ? number_text(*asked.tolerance) : "chosen"},
          {"tol-at-end", number_text(outcome.ended.tolerance)},
          {"improve", std::to_string(asked.improve_passes)},
          {"improve-done", outcome.improved ? text_of(*outcome.improved, outcome.sites) : "none"},
          {"certify", job.refinement.prove_voronoi ? "voronoi" : "stars"},
          {"max-sites", std::to_string(asked.max_sites)},
          {"regions", job.number_regions ? "numbered" : "as given"},
          {"random-points", std::to_string(job.random_points)},
          {"metric-fingerprint", input.field->background() != nullptr
                                     ? std::to_string(mesh_fingerprint(*input.field->background()))
                                     : "none"},
          {"fit-done", outcome.fitted ? text_of(*outcome.fitted, outcome.too_large) : "none"},
          {"relax", asked.relax ? "where needed" : "no"},
          {"seed", std::to_string(asked.seed)}};
}

// Adds to the certificate what only the command knows: how the job was worded.
void describe(certified_mesh& made, const mesh_job& job, const prepared_input& input) {
  made.claim.metric = job.metric;
  made.claim.options = options_of(job, input, made.outcome);
}

std::string text_of_low(const relaxation_report& relaxed, double angle_bound) {
  return std::to_string(relaxed.low_triangles.size()) + " triangles are below " +
         number_text(angle_bound) + " degrees as the metric given measures them";
}

// All files are written before the first gets its name, the certificate last: where it is,
// everything else is too.
std::optional<error> write_files(const mesh_job& job, const fs::path& certificate_path,
                                 const mesh& made, const certificate& claim) {
  write_options options;
  options.picture.ellipses = job.ellipses;
  options.picture.angle_bound = job.refinement.angle_bound;
  if (!claim.complete || !claim.certified)
    options.note = claim.relaxed && claim.certified
                       ? "Incomplete, certified in a relaxed metric: " +
                             text_of_low(*claim.relaxed, job.refinement.angle_bound)
                       : "Incomplete, not certified: " + claim.reason;
  std::vector<output_file> files;
  for (const fs::path& output : job.outputs) {
    auto rendered = render_mesh(output, made, options);
    if (!rendered) return rendered.failure();
    std::move(rendered.value().begin(), rendered.value().end(), std::back_inserter(files));
  }
  files.push_back({certificate_path, certificate_text(claim)});
  const held_signals held;
  const auto written = asterism::internal::write_files(files);
  if (!written) return written.failure();
  return std::nullopt;
}

int conclude(const mesh_job& job, const certified_mesh& made) {
  const mesh_outcome& outcome = made.outcome;
  const audit_report& report = made.report;
  const bool reached = made.certified();
  std::optional<double> unit_edges;
  if (job.size) unit_edges = made.claim.measured.at("unit_edges");
  if (!job.quiet && outcome.improved)
    std::cout << "improvement: " << text_of(*outcome.improved, outcome.sites) << '\n';
  if (!job.quiet && outcome.delivered)
    std::cout << "delivered: " << text_of(*outcome.delivered) << '\n';
  if (!job.quiet && outcome.fitted)
    std::cout << "fitted: " << text_of(*outcome.fitted, outcome.too_large) << '\n';
  if (!job.quiet && outcome.relaxed && reached)
    std::cout << "relaxed: " << made.claim.reason << '\n';
  if (!job.quiet) write_summary(std::cout, made, unit_edges);
  const bool dual_as_asked =
      !job.refinement.prove_voronoi || report.voronoi == voronoi_verdict::proved;
  if (reached && dual_as_asked) return done;
  if (!outcome.complete) return complain({"not reached: " + made.claim.reason}, not_reached);
  const std::string witness = report.findings.empty() ? "" : ": " + report.findings[0].witness;
  return complain({reached ? "not proved to be the dual of the Voronoi diagram" + witness
                           : "the audit refuses the mesh" + witness},
                  not_reached);
}

result<certified_mesh> mesh_with_progress(const mesh_job& job, const prepared_input& input,
                                          const run_limits& limits) {
  mesh_options options = job.refinement;
  options.keep_if_complete = is_mesh(job);
  options.stop = [&limits] { return limits.reason(); };
  progress_line line(!job.quiet);
  return make_certified_mesh(input.shape, *input.field, options,
                             [&line](const mesh_progress& progress) { line.show(progress); });
}

}  // namespace

int run_mesh_job(const mesh_job& job) {
  std::optional<tbb::global_control> threads;
  if (job.threads > 0) threads.emplace(tbb::global_control::max_allowed_parallelism, job.threads);
  fs::path certificate_path = job.certificate;
  if (certificate_path.empty())
    certificate_path = fs::path(job.outputs[0]).replace_extension(".certificate.json");
  if (const auto failure = check_files(job, certificate_path)) return complain(*failure, refused);
  const auto input = prepare(job);
  if (!input) return complain(input.failure(), refused);
  if (input.value().gradation && !job.quiet)
    std::cout << "gradation: " << text_of(*input.value().gradation) << '\n';

  // Until all is written: an interrupt during the audit must not lose the mesh, nor one between two
  // files the second.
  const run_limits limits(job.max_seconds, job.max_megabytes);
  auto made = mesh_with_progress(job, input.value(), limits);
  if (!made) return complain(made.failure(), refused);
  describe(made.value(), job, input.value());
  if (const auto failure =
          write_files(job, certificate_path, made.value().outcome.result, made.value().claim))
    return complain(*failure, not_reached);
  return conclude(job, made.value());
}

}  // namespace asterism::apps
