// SPDX-License-Identifier: MIT
#include "asterism/apps/adapt/run_adapt_job.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "asterism/apps/adapt/adapt_report.hpp"
#include "asterism/apps/base/complain.hpp"
#include "asterism/apps/base/notes.hpp"
#include "asterism/apps/job/job_input.hpp"
#include "asterism/apps/job/job_words.hpp"
#include "asterism/apps/options/second_order.hpp"
#include "asterism/apps/options/solution_options.hpp"
#include "asterism/apps/options/thread_limit.hpp"
#include "asterism/apps/run/freed_memory.hpp"
#include "asterism/apps/run/progress_line.hpp"
#include "asterism/apps/run/run_files.hpp"
#include "asterism/apps/run/run_limits.hpp"
#include "asterism/apps/text/page_facts.hpp"
#include "asterism/apps/text/summary.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/claims/adaptation_words.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/domain/cracks.hpp"
#include "asterism/mesh/domain/divide_curves.hpp"
#include "asterism/mesh/domain/smooth_vertices.hpp"
#include "asterism/mesh/io/load_domain.hpp"
#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/mesh/io/solution_output.hpp"
#include "asterism/mesh/pipeline/adaptation_target.hpp"
#include "asterism/mesh/pipeline/curved_sides.hpp"

namespace asterism::apps {
using namespace internal;
namespace fs = std::filesystem;
namespace {

std::optional<error> check_solutions(const adapt_job& job) {
  if (auto failed = check_order(job.order, job.outputs)) return failed;
  if (!job.values.empty() && job.request.solution.empty())
    return error{"--solution-out: there is no --solution to transfer", error_code::bad_option};
  for (const fs::path& values : {job.values, job.carried})
    if (!values.empty())
      if (const auto place = check_solution_output(values); !place) return place.failure();
  return std::nullopt;
}

std::vector<fs::path> files_read_by(const adapt_job& job) {
  std::vector<fs::path> read = files_of(job.request);
  std::error_code ignored;
  if (fs::is_regular_file(job.domain, ignored)) read.emplace_back(job.domain);
  return read;
}

// Lists the files that the run writes: meshes, fields, certificate and proof.
run_files files_written_by(const adapt_job& job) {
  run_files files{job.outputs,
                  {},
                  job.proof,
                  job.certificate.empty() ? certificate_beside(job.outputs) : job.certificate};
  for (const fs::path& values : {job.values, job.carried})
    if (!values.empty()) files.solutions.push_back(values);
  return files;
}

std::optional<error> take_domain(adapt_job& job) {
  if (job.domain.empty()) return std::nullopt;
  auto loaded = load_domain(job.domain);
  if (loaded && job.convex_hull) loaded = close_by_hull(std::move(loaded).value());
  if (!loaded) return loaded.failure();
  if (job.chord_tolerance && loaded.value().curves.empty())
    return error{"--chord-tolerance: " + job.domain + " has no curves"};
  curve_division chords;
  chords.chord_tolerance = job.chord_tolerance;
  const auto divided = divide_curves(loaded.value(), chords);
  if (!divided) return divided.failure();
  domain_repairs repairs;
  auto checked = check_domain(divided.value(), &repairs);
  if (!checked) return checked.failure();
  for (const auto& notes : {loaded.value().origin.notes, repairs.messages})
    if (auto refused = say_notes(notes, {job.quiet, job.strict})) return refused;
  job.options.exact = std::move(checked).value();
  job.options.chord_tolerance = job.chord_tolerance;
  return std::nullopt;
}

// Makes the next mesh, of the whole mesh or of its part outside frozen regions.
std::optional<error> make_next(const marked_mesh& from, const adapt_job& job,
                               const mesh_adaptation_options& options, adapted& made) {
  progress_line line(!job.quiet);
  const auto show = [&line](const mesh_progress& p) { line.show(p); };
  if (job.frozen.empty()) {
    auto next = adapt_to_metric(from, options, show);
    if (!next) return next.failure();
    made.next = std::move(next).value();
    return say_notes(made.next.made.outcome.result.notes, {job.quiet});
  }
  const auto regions = frozen_regions(job.frozen, job.request.mesh);
  if (!regions) return regions.failure();
  auto run = adapt_the_rest(regions.value(), from, options, show);
  if (!run) return run.failure();
  made.next = std::move(run.value().next);
  made.rest = std::move(run.value().background);
  made.together = std::move(run.value().together);
  made.frozen = std::move(run.value().facts);
  made.border_split = run.value().border_split;
  return say_notes(made.next.made.outcome.result.notes, {job.quiet});
}

// Transfers the solution and the fields carried to the mesh, where files are named for them.
std::optional<error> bring_values(const adapt_job& job, adapted& made) {
  if (job.values.empty() && job.carried.empty()) return std::nullopt;
  const mesh& joined = made.written();
  if (joined.triangles.empty())
    return error{"the run ended before there was a triangle to bring values to: " +
                 made.next.made.claim.reason};
  auto values = transfer_solution(made.wanted.background, made.wanted.values,
                                  part_cracks(joined, made.next.cracks).content, job.how);
  if (!values) return values.failure();
  made.values = std::move(values).value();
  return std::nullopt;
}

// Makes the metric, the next mesh, and the solution on it.
result<adapted> adapt(const adapt_job& job, run_limits& limits) {
  metric_request request = job.request;
  request.periodic = job.options.periodic;
  auto wanted = answer(request);
  if (!wanted) return wanted.failure();
  if (auto refused = say_notes(wanted.value().background.notes, {job.quiet, job.strict}))
    return *refused;
  adapted made{std::move(wanted).value(), {}, {}, {}};
  const auto marks = read_mesh_marks(job.request.mesh);
  if (!marks) return marks.failure();
  mesh_adaptation_options options = job.options;
  const adaptation_wish wish{job.request.wishes, made.wanted.report,
                             made.wanted.background.sites.size(), is_of_fields(job.request)};
  if (auto failed = take_target(wish, "--max-sites", options)) return *failed;
  made.vertices_wanted = options.refinement.vertices;
  options.refinement.stop = [&limits] { return limits.reason(); };
  if (auto failed = make_next({made.wanted.background, marks.value()}, job, options, made))
    return *failed;
  if (made.border_split > 0) return made;
  if (auto failed = bring_values(job, made)) return *failed;
  return made;
}

void describe(const adapt_job& job, adapted& made) {
  describe_adaptation(made.next,
                      {job.request, made.background(), made.wanted.report, job.options, job.domain,
                       made.values ? &made.values->report : nullptr, job.how});
  describe_frozen(made.frozen, made.next.made.claim);
}

// Makes triangles of second order, where they are asked for, and adds their proof to the
// certificate.
std::optional<error> curve(const adapt_job& job, adapted& made) {
  if (job.order == 1) return std::nullopt;
  auto sides = curve_sides(made.written(), made.next.shape);
  if (!sides) return sides.failure();
  made.next.made.claim.second_order = sides.value().report;
  made.curved = std::move(sides.value().nodes);
  return say_notes(notes_of_order(job.outputs, sides.value().report), {job.quiet});
}

// Returns the fields of the solution, and those that were only transferred, by the names in their
// files.
std::pair<solution, solution> parted(const adapted& made) {
  std::pair<solution, solution> parts;
  if (!made.values) return parts;
  const solution& all = made.values->values;
  parts.first.vertices = parts.second.vertices = all.vertices;
  for (std::size_t k = 0; k < all.fields.size(); ++k) {
    if (k < made.wanted.own_fields) {
      parts.first.fields.push_back(all.fields[k]);
      continue;
    }
    parts.second.fields.push_back(all.fields[k]);
    parts.second.fields.back().name.erase(0, std::string(carried_prefix).size());
  }
  return parts;
}

std::optional<error> write_all(const adapt_job& job, const run_files& files, const adapted& made) {
  write_options how;
  how.names = names_in(job.request.mesh);
  how.order = job.order;
  how.curved = made.curved;
  how.cracks = made.next.cracks;
  const certificate& claim = made.next.made.claim;
  how.smooth = smooth_vertices(made.next.shape);
  if (has_page(job.outputs)) how.report = facts_of_page(job, files.certificate, made);
  how.note = file_note_of(claim);
  run_contents contents{made.written(), claim, how, made.proof};
  contents.proved = &made.next.made.outcome.result;
  const auto [own, carried] = parted(made);
  if (!job.values.empty())
    contents.solutions.push_back({job.values, solution_text(job.values, own)});
  if (!job.carried.empty())
    contents.solutions.push_back({job.carried, solution_text(job.carried, carried)});
  return write_files(files, contents);
}

// Returns why the job is refused before anything is computed.
std::optional<error> check_job(const adapt_job& job, const run_files& files) {
  if (auto failed = check_request(job.request)) return failed;
  if (auto failed = check_solutions(job)) return failed;
  return check_files(files, files_read_by(job));
}

// Says what was made and written, and what to try where the goal was not reached. Returns the exit
// status.
int say_outcome(const adapt_job& job, const run_files& files, const adapted& made,
                std::chrono::steady_clock::time_point start) {
  const auto missed = what_is_missed(made.next, made.wanted.report, made.vertices_wanted);
  const int status = missed || made.proof.missing ? not_reached : done;
  if (job.json) {
    std::cout << adapt_json(facts_of(made), status, written_files(files, made.proof));
  } else if (!job.quiet) {
    summarize(std::cout, job, made);
    write_files_written(std::cout, written_files(files, made.proof), start);
  }
  if (!missed) return made.proof.conclude(done);
  complain({"not reached: " + *missed}, not_reached);
  const std::string next_one = next_step(job, made);
  if (!next_one.empty() && !job.quiet) std::cerr << "asterism: try " << next_one << '\n';
  return made.proof.conclude(not_reached);
}

}  // namespace

int run_adapt_job(adapt_job job) {
  const auto start = std::chrono::steady_clock::now();
  const thread_limit threads(job.threads);
  const run_files files = files_written_by(job);
  set_defaults(job.request);
  if (const auto failed = check_job(job, files)) return complain(*failed, refused);
  run_limits limits(job.max_seconds, std::nullopt);
  keep_freed_blocks();
  if (const auto failed = take_domain(job)) return complain(*failed, refused);
  auto run = adapt(job, limits);
  if (!run) return complain(run.failure(), refused);
  adapted& made = run.value();
  if (made.border_split > 0)
    return complain({fmt::format("not reached: {} edges of the border of the frozen regions are "
                                 "split, however coarse the metric is made there; nothing is "
                                 "written",
                                 made.border_split)},
                    not_reached);
  describe(job, made);
  const certified_mesh& next = made.next.made;
  made.proof = find_proof(job.proof, next.outcome.result, &made.next.shape, next.report.certified);
  limits.conclude();
  if (const auto failed = curve(job, made)) return complain(*failed, not_reached);
  if (const auto failed = write_all(job, files, made)) return complain(*failed, not_reached);
  return say_outcome(job, files, made, start);
}

}  // namespace asterism::apps
