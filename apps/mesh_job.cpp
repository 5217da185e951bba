// SPDX-License-Identifier: MIT
#include "asterism/apps/mesh_job.hpp"

#include <tbb/global_control.h>

#include <array>
#include <charconv>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <map>
#include <memory>
#include <system_error>
#include <utility>

#include "asterism/apps/commands.hpp"
#include "asterism/apps/held_signals.hpp"
#include "asterism/apps/places.hpp"
#include "asterism/apps/progress_line.hpp"
#include "asterism/apps/run_limits.hpp"
#include "asterism/apps/verdict_text.hpp"
#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/domain/built_in_domains.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/load_domain.hpp"
#include "asterism/mesh/io/medit.hpp"
#include "asterism/mesh/io/render_mesh.hpp"
#include "asterism/mesh/io/write_mesh.hpp"
#include "asterism/mesh/metric/graded_field.hpp"
#include "asterism/mesh/metric/interpolated_field.hpp"
#include "asterism/mesh/metric/make_metric_field.hpp"
#include "asterism/mesh/pipeline/certified_mesh.hpp"
#include "asterism/mesh/pipeline/foreign_mesh.hpp"

namespace asterism::apps {
using namespace internal;
namespace fs = std::filesystem;
namespace {

int complain(const error& failure, exit_status status) {
  std::cerr << "asterism: " << failure.message << '\n';
  return status;
}

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

struct prepared_input {
  domain shape;
  std::unique_ptr<metric_field> field;
  std::optional<gradation_report> gradation;
};

// A mesh that is a triangulation, with whatever metric is beside it.
result<adopted_mesh> read_triangulation(const std::string& path, bool metric_wanted) {
  medit_read_options how;
  how.identity_without_solution = !metric_wanted;
  auto read = read_medit(path, how);
  if (!read) return read.failure();
  auto adopted = adopt_mesh(std::move(read).value());
  if (!adopted) return error{path + ": " + adopted.failure().message};
  audit_options options;
  options.check_stars = false;
  options.angle_bound = 0;
  const audit_report found = audit(adopted.value().subject, options);
  if (!found.certified)
    return error{path + " is no triangulation: " + found.findings.at(0).witness};
  return adopted;
}

using made_field = result<std::unique_ptr<metric_field>>;

made_field make_field(const mesh_job& job, const domain& shape) {
  const double size = job.size.value_or(1);
  if (!has_ending(job.metric, ".mesh")) return make_metric_field(job.metric, shape.box(), size);
  const auto background = read_triangulation(job.metric, true);
  if (!background) return background.failure();
  return make_sampled_field(background.value().subject, size);
}

result<prepared_input> with_metric(const mesh_job& job, domain shape) {
  auto field = make_field(job, shape);
  if (!field) return field.failure();
  if (!job.gradation)
    return prepared_input{std::move(shape), std::move(field).value(), std::nullopt};
  gradation_options options;
  options.beta = *job.gradation;
  auto graded = grade_metric(std::move(field).value(), shape.box(), options);
  if (!graded) return graded.failure();
  return prepared_input{std::move(shape), std::move(graded.value().field), graded.value().report};
}

result<domain> load_and_check(const mesh_job& job) {
  auto loaded = load_domain(job.domain);
  if (!loaded) return loaded.failure();
  if (job.number_regions) loaded.value().number_all_regions = true;
  domain_repairs repairs;
  auto checked = check_domain(loaded.value(), &repairs);
  if (checked && !job.quiet)
    for (const std::string& message : repairs.messages)
      std::cerr << "asterism: note: " << message << '\n';
  return checked;
}

// What a mesh covers, with its vertices, boundary edges and regions; its metric is not used.
result<domain> domain_of_mesh(const mesh_job& job) {
  if (job.number_regions)
    return error{"--regions: " + job.domain + " is a mesh, which has its regions already"};
  auto adopted = read_triangulation(job.domain, false);
  if (!adopted) return adopted.failure();
  return std::move(adopted.value().shape);
}

bool is_mesh(const mesh_job& job) { return has_ending(job.domain, ".mesh"); }

result<prepared_input> prepare(const mesh_job& job) {
  const auto checked = is_mesh(job) ? domain_of_mesh(job) : load_and_check(job);
  if (!checked) return checked.failure();
  auto populated = add_random_points(checked.value(), job.random_points, job.refinement.seed);
  if (!populated) return populated.failure();
  const std::size_t given = populated.value().vertices.size();
  if (given > job.refinement.max_sites)
    return error{"--max-sites " + std::to_string(job.refinement.max_sites) + ": the domain has " +
                 std::to_string(given) + " vertices already"};
  return with_metric(job, std::move(populated).value());
}

// The shortest decimal that is read back as the same double.
std::string text_of(double x) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), x).ptr;
  return {buffer.data(), end};
}

// What gradation did, in one line.
std::string text_of(const gradation_report& done) {
  std::string text = std::to_string(done.changed) + " of " + std::to_string(done.nodes) +
                     " nodes changed, density at most times " + text_of(done.largest_growth) +
                     ", cells from " + text_of(done.smallest_cell) + " to " +
                     text_of(done.largest_cell) + ", " + std::to_string(done.sweeps) + " sweeps";
  if (!done.resolved) text += "; the grid could not be made as fine as it should be";
  if (!done.settled) text += "; NOT settled";
  return text;
}

// The size the mesh was made for; none, too, where the relaxed mesh was made without demands.
std::string text_of_size_delivered(const mesh_job& job, const mesh_outcome& outcome) {
  const bool demanded =
      !outcome.relaxed || outcome.relaxed->kind != relaxation_kind::without_demands;
  return job.size && demanded ? text_of(*job.size * outcome.length_factor) : "none";
}

// What the passes over the finished mesh did, in one line.
std::string text_of(const improvement_report& done, std::size_t sites) {
  return std::to_string(done.passes) + " passes of " + std::to_string(done.tries) + " tries, " +
         std::to_string(done.removed) + " removed, " + std::to_string(done.moved) + " moved, " +
         std::to_string(done.sites_before) + " to " + std::to_string(sites) +
         " sites, mean quality " + text_of(done.mean_quality_before) + " to " +
         text_of(done.mean_quality_after) + (done.stopped ? "; stopped" : "");
}

// What fitting did, in one line.
std::string text_of(const fitting_report& done, std::size_t too_large) {
  return "from aspects to the power of " + text_of(done.power) + ", " +
         std::to_string(done.low_before) + " triangles below the bound before, " +
         std::to_string(done.rounds) + " rounds, " + std::to_string(done.moves) + " moves, " +
         std::to_string(done.flips) + " flips, " + std::to_string(done.collapses) + " merged, " +
         std::to_string(done.insertions) + " split, " + std::to_string(too_large) +
         " larger than the size asks for";
}

std::map<std::string, std::string> options_of(const mesh_job& job, const prepared_input& input,
                                              const mesh_outcome& outcome) {
  const mesh_options& asked = job.refinement;
  const std::array<const char*, 3> strategies = {"voronoi", "darts", "fill"};
  return {{"domain", job.domain},
          {"angle-bound", text_of(asked.angle_bound)},
          {"size", job.size ? text_of(*job.size) : "none"},
          {"size-delivered", text_of_size_delivered(job, outcome)},
          {"gradation", job.gradation ? text_of(*job.gradation) : "none"},
          {"gradation-done", input.gradation ? text_of(*input.gradation) : "none"},
          {"refine", strategies[static_cast<std::size_t>(asked.strategy)]},
          {"tol", asked.tolerance ? text_of(*asked.tolerance) : "chosen"},
          {"tol-at-end", text_of(outcome.tolerance)},
          {"improve", std::to_string(asked.improve_passes)},
          {"improve-done", outcome.improved ? text_of(*outcome.improved, outcome.sites) : "none"},
          {"certify", job.refinement.prove_voronoi ? "voronoi" : "stars"},
          {"max-sites", std::to_string(asked.max_sites)},
          {"regions", job.number_regions ? "numbered" : "as given"},
          {"random-points", std::to_string(job.random_points)},
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
         text_of(angle_bound) + " degrees as the metric given measures them";
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

void write_summary(const mesh_outcome& outcome, const audit_report& report, bool reached,
                   std::optional<double> unit_edges) {
  std::cout << report.sites << " sites, " << report.triangles << " triangles, "
            << angles_text(report) << ", " << std::fixed << std::setprecision(2)
            << outcome.disagreeing << " disagreeing, "
            << (report.angles_checked ? report.low_triangles.size() : outcome.low_angle)
            << " low-angle";
  if (outcome.too_large > 0) std::cout << ", " << outcome.too_large << " too large";
  if (outcome.stars_missing > 0) std::cout << ", " << outcome.stars_missing << " stars never made";
  if (unit_edges) std::cout << ", " << *unit_edges * 100 << "% unit edges";
  if (report.voronoi != voronoi_verdict::not_asked)
    std::cout << ", dual of the Voronoi diagram: "
              << voronoi_verdict_names[static_cast<std::size_t>(report.voronoi)];
  const char* relaxed = outcome.relaxed ? " in a relaxed metric" : "";
  if (reached)
    std::cout << ": certified" << relaxed << '\n';
  else if (outcome.relaxed && report.certified)
    std::cout << ": certified" << relaxed << ", NOT complete\n";
  else
    std::cout << ": NOT certified, incomplete\n";
}

int conclude(const mesh_job& job, const certified_mesh& made) {
  const mesh_outcome& outcome = made.outcome;
  const audit_report& report = made.report;
  const bool reached = made.certified();
  std::optional<double> unit_edges;
  if (job.size) unit_edges = made.claim.measured.at("unit_edges");
  if (!job.quiet && outcome.improved)
    std::cout << "improvement: " << text_of(*outcome.improved, outcome.sites) << '\n';
  if (!job.quiet && outcome.fitted)
    std::cout << "fitted: " << text_of(*outcome.fitted, outcome.too_large) << '\n';
  if (!job.quiet && outcome.relaxed && reached) std::cout << "relaxed: " << outcome.reason << '\n';
  if (!job.quiet) write_summary(outcome, report, reached, unit_edges);
  const bool dual_as_asked =
      !job.refinement.prove_voronoi || report.voronoi == voronoi_verdict::proved;
  if (reached && dual_as_asked) return done;
  if (!outcome.complete) return complain({"not reached: " + outcome.reason}, not_reached);
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
