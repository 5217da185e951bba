// SPDX-License-Identifier: MIT
#include "asterism/apps/job/run_mesh_job.hpp"

#include <fmt/format.h>

#include <chrono>
#include <iostream>
#include <limits>
#include <new>
#include <system_error>
#include <utility>

#include "asterism/apps/base/complain.hpp"
#include "asterism/apps/base/notes.hpp"
#include "asterism/apps/job/job_input.hpp"
#include "asterism/apps/job/job_words.hpp"
#include "asterism/apps/job/next_step.hpp"
#include "asterism/apps/options/periodic_options.hpp"
#include "asterism/apps/options/proof_output.hpp"
#include "asterism/apps/options/second_order.hpp"
#include "asterism/apps/options/thread_limit.hpp"
#include "asterism/apps/run/freed_memory.hpp"
#include "asterism/apps/run/memory_account.hpp"
#include "asterism/apps/run/places.hpp"
#include "asterism/apps/run/progress_line.hpp"
#include "asterism/apps/run/run_files.hpp"
#include "asterism/apps/run/run_limits.hpp"
#include "asterism/apps/text/json_summary.hpp"
#include "asterism/apps/text/page_facts.hpp"
#include "asterism/apps/text/summary.hpp"
#include "asterism/core/number_text.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/domain/smooth_vertices.hpp"
#include "asterism/mesh/draw/outline.hpp"
#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/medit.hpp"
#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/mesh/pipeline/certified_mesh.hpp"
#include "asterism/mesh/pipeline/counted_mesh.hpp"
#include "asterism/mesh/pipeline/curved_sides.hpp"
#include "asterism/mesh/pipeline/guaranteed_mesh.hpp"
#include "asterism/mesh/pipeline/read_triangulation.hpp"
#include "asterism/mesh/pipeline/split_across.hpp"
#include "asterism/mesh/support/one_line.hpp"

namespace asterism::apps {
using namespace internal;
namespace fs = std::filesystem;
namespace {

// Returns the files that the job reads.
std::vector<fs::path> files_read_by(const mesh_job& job) {
  std::vector<fs::path> used;
  std::error_code ignored;
  std::vector<fs::path> read = {job.domain};
  if (is_metric_on_mesh(job.metric) && job.metric != job.domain) read.emplace_back(job.metric);
  for (const fs::path& file : read) {
    if (!fs::is_regular_file(file, ignored)) continue;
    for (fs::path& opened : files_read_with(file)) used.push_back(std::move(opened));
    const fs::path vertices = fs::path(file).replace_extension(".node");
    if (has_ending(file.string(), ".poly") && fs::is_regular_file(vertices, ignored))
      used.push_back(vertices);
  }
  return used;
}

// Adds to the certificate what only the command knows: the words of the options.
void describe(certified_mesh& made, const mesh_job& job, const prepared_input& input) {
  made.claim.metric = job.metric;
  made.claim.options = options_of(job, input, made.outcome);
  if (job.no_split_across) made.claim.options["split-across"] = "no";
}

report_facts facts_of_page(const mesh_job& job, const fs::path& certificate_path,
                           const prepared_input& input, const certified_mesh& made) {
  report_facts facts;
  facts.title = job.domain + ", metric " + job.metric;
  facts.claim = made.claim;
  facts.claim_from = "As the run that made this page judged the mesh it had made.";
  facts.repeat = repeating_command(job.outputs, certificate_path);
  if (made.outcome.delivered)
    facts.wanted = tensors_at_sites(*input.metric.field, made.outcome.result);
  if (input.before_repair) {
    facts.label = "Repaired and meshed";
    facts.before = {{"As the file has it", outline_of(*input.before_repair), {}, {}}};
  }
  return facts;
}

// Makes triangles of second order, where they are asked for, and adds their proof to the
// certificate.
result<std::vector<side_node>> curve(const mesh_job& job, const prepared_input& input,
                                     certified_mesh& made) {
  if (job.order == 1) return std::vector<side_node>{};
  auto sides = curve_sides(made.outcome.result, input.shape);
  if (!sides) return sides.failure();
  if (auto refused = say_notes(notes_of_order(job.outputs, sides.value().report), {job.quiet}))
    return *refused;
  made.claim.second_order = sides.value().report;
  return std::move(sides.value().nodes);
}

// Returns the options for writing the mesh.
write_options how_to_write(const mesh_job& job, const fs::path& certificate_path,
                           const prepared_input& input, const certified_mesh& made,
                           std::vector<side_node> curved) {
  write_options how;
  if (has_page(job.outputs)) how.report = facts_of_page(job, certificate_path, input, made);
  how.order = job.order;
  how.curved = std::move(curved);
  how.cracks = input.cracks;
  how.names = names_in(job.domain);
  how.smooth = smooth_vertices(input.shape);
  for (const repair_place& place : input.repairs.places) how.picture.marks.push_back(place.at);
  how.picture.ellipses = job.ellipses;
  how.picture.angle_bound = job.refinement.angle_bound;
  how.note = file_note_of(made.claim);
  return how;
}

// Writes the number of vertices and, if it is not near the one wanted, that no mesh with a nearer
// number was found.
std::string vertex_count_text(std::size_t wanted, std::size_t delivered) {
  const double more = 100 * (static_cast<double>(delivered) / static_cast<double>(wanted) - 1);
  return fmt::format("vertices: {} wanted, {} delivered ({:+.1f} %{})", wanted, delivered, more,
                     is_count_near(wanted, delivered) ? "" : ": none nearer to that were found");
}

// Writes how near the mesh is to the size or number that was asked for.
void tell_scale(const mesh_job& job, const prepared_input& input, const mesh_outcome& outcome) {
  if (!input.metric.complexity) return;
  if (job.refinement.vertices)
    std::cout << vertex_count_text(*job.refinement.vertices, outcome.sites);
  else
    std::cout << fmt::format("complexity: {:g} wanted, {:g} delivered", *job.complexity,
                             *input.metric.complexity);
  std::cout << ", size " << number_text(*job.size) << '\n';
}

// Writes the summary of the mesh: the verdict, then the options beside the measures, and notes on
// the run.
void tell(const mesh_job& job, const prepared_input& input, const certified_mesh& made) {
  if (!job.tells()) return;
  const mesh_outcome& outcome = made.outcome;
  std::optional<double> unit_edges;
  if (job.size && !job.guarantee) unit_edges = made.claim.measured.at("unit_edges");
  write_summary(std::cout, made, unit_edges);
  if (made.claim.guarantee)
    std::cout << "guarantee: " << text_of(*made.claim.guarantee, *made.claim.theorem) << '\n';
  if (outcome.delivered) std::cout << "delivered: " << text_of(*outcome.delivered) << '\n';
  if (outcome.one_metric && made.certified())
    std::cout << "last resort: " << made.claim.reason << '\n';
  tell_scale(job, input, outcome);
  write_periodic(std::cout, made.claim);
  if (input.metric.gradation)
    std::cout << "gradation: " << text_of(*input.metric.gradation) << '\n';
  std::cout << cracks_text(input.cracks);
  if (input.repairs.distance > 0) std::cout << "repaired: " << text_of(input.repairs) << '\n';
  if (outcome.improved)
    std::cout << "improvement: " << text_of(*outcome.improved, outcome.sites) << '\n';
}

// Returns the status of the run, and writes to standard error what was not reached.
int conclude(const mesh_job& job, const certified_mesh& made) {
  const mesh_outcome& outcome = made.outcome;
  const audit_report& report = made.report;
  const bool reached = made.certified();
  const bool dual_as_asked =
      !job.refinement.prove_voronoi || report.voronoi == voronoi_verdict::proved;
  if (reached && dual_as_asked) return done;
  if (!outcome.complete) return complain({"not reached: " + made.claim.reason}, not_reached);
  const std::string witness = report.findings.empty() ? "" : ": " + report.findings[0].witness;
  if (reached)
    return complain({"not proved to be the dual of the Voronoi diagram" + witness}, not_reached);
  const bool ended = report.found[static_cast<std::size_t>(finding_kind::stopped)] == 0;
  return complain({(ended ? "the audit refuses the mesh" : "the audit did not end") + witness},
                  not_reached);
}

result<certified_mesh> mesh_with_progress(const mesh_job& job, const mesh_input& input,
                                          const mesh_options& options, run_limits& limits) {
  progress_line line(!job.quiet);
  const metric_field& field = *input.metric.field;
  // Number of sites from which freed blocks are given back to the system: lower for a fill, in
  // which blocks of all sizes are freed before it is at its largest (3 % of the memory at a million
  // triangles). Where the metric is given on a mesh, as a mesh is then changed locally, blocks of
  // the same sizes are needed again and again.
  constexpr std::size_t never = std::numeric_limits<std::size_t>::max();
  const std::size_t many = field.background() != nullptr ? never
                           : options.limit_size          ? 100'000
                                                         : 300'000;
  bool keeps_blocks = !job.max_megabytes;
  const auto show = [&](const mesh_progress& progress) {
    if (progress.sites > many && std::exchange(keeps_blocks, false)) give_back_large_blocks();
    limits.expect(progress.sites);
    line.show(progress);
  };
  if (!job.guarantee)
    return make_periodic_mesh(input.shape, field, options, job.periodic, show, job.no_split_across);
  auto made = make_guaranteed_mesh(input.shape, field, options, show);
  if (!made || !job.no_split_across) return made;
  return split_across(std::move(made).value(), input.shape, field, options);
}

// Makes the mesh. If that exceeds the memory limit, all memory is given back, and the
// result is a mesh without any step of the mesher: the domain's vertices and
// segments.
result<certified_mesh> mesh_within_memory(const mesh_job& job, const mesh_input& input,
                                          const mesh_options& options, run_limits& limits) {
  try {
    return mesh_with_progress(job, input, options, limits);
  } catch (const std::bad_alloc&) {
    limits.note_want_of_memory();
  }
  return mesh_with_progress(job, input, options, limits);
}

// Makes the mesh of a job, with the number of vertices wanted, if any, and replaces the input by
// the input of this mesh.
result<certified_mesh> make(const mesh_job& job, prepared_input& input, run_limits& limits) {
  mesh_options options = job.refinement;
  options.keep_if_complete = input.of_mesh;
  options.stop = [&limits] { return limits.reason(); };
  const mesh_maker maker = [&](const mesh_input& of, const mesh_options& how) {
    return mesh_within_memory(job, of, how, limits);
  };
  auto made = maker(input, options);
  if (!made || !input.source) return made;
  counted_mesh met =
      meet_vertices({std::move(static_cast<mesh_input&>(input)), std::move(made).value()},
                    *input.source, options, maker);
  static_cast<mesh_input&>(input) = std::move(met.input);
  return std::move(met.made);
}

int run_within_limits(const mesh_job& asked) {
  const auto start = std::chrono::steady_clock::now();
  mesh_job job = asked;
  const thread_limit threads(job.threads);
  const run_files files{
      job.outputs,
      {},
      job.proof,
      job.certificate.empty() ? certificate_beside(job.outputs) : job.certificate};
  if (const auto failure = check_order(job.order, job.outputs)) return complain(*failure, refused);
  if (const auto failure = check_files(files, files_read_by(job)))
    return complain(*failure, refused);
  std::optional<memory_account> account;
  if (job.max_megabytes) account.emplace(*job.max_megabytes * 1e6);
  // Holds signals until all is written: an interrupt during the audit must not lose the mesh, nor
  // one between two files the second file.
  run_limits limits(job.max_seconds, job.max_megabytes);
  if (!job.max_megabytes) keep_freed_blocks();
  auto input = prepare(job);
  if (!input) return complain(input.failure(), refused);
  if (job.no_split_across && !input.value().cracks.empty())
    return complain(
        {"--no-split-across: the mesh has slits, and edges beside them are not looked at"},
        refused);
  if (!job.keeps_site_limit) make_room(input.value().shape.vertices.size(), job.refinement);
  auto made = make(job, input.value(), limits);
  if (!made) return complain(made.failure(), refused);
  if (input.value().metric.complexity || !input.value().sizes.is_empty())
    job.size = input.value().metric.size;
  describe(made.value(), job, input.value());
  const proof_output proof = find_proof(job.proof, made.value().outcome.result,
                                        &input.value().shape, made.value().report.certified);
  limits.conclude();
  auto curved = curve(job, input.value(), made.value());
  if (!curved) return complain(curved.failure(), not_reached);
  const write_options how =
      how_to_write(job, files.certificate, input.value(), made.value(), std::move(curved).value());
  if (job.max_megabytes) give_back_small_blocks();  // of the mesher's stars: texts need the room
  if (const auto failure =
          write_files(files, {made.value().outcome.result, made.value().claim, how, proof}))
    return complain(*failure, not_reached);
  tell(job, input.value(), made.value());
  if (job.tells()) write_files_written(std::cout, written_files(files, proof), start);
  const int status = proof.conclude(conclude(job, made.value()));
  const std::string next = status == done ? "" : next_step(job, input.value(), made.value());
  if (!next.empty() && !job.quiet) std::cerr << "asterism: try " << printable(next) << '\n';
  if (job.json) std::cout << summary_json(made.value(), status, written_files(files, proof), next);
  return status;
}

}  // namespace

int run_mesh_job(const mesh_job& job) {
  try {
    return run_within_limits(job);
  } catch (const std::bad_alloc&) {
    if (!job.max_megabytes) throw;
    return complain({fmt::format("not reached: stopped: more than {:g} megabytes would be in use; "
                                 "nothing is written",
                                 *job.max_megabytes)},
                    not_reached);
  }
}

}  // namespace asterism::apps
