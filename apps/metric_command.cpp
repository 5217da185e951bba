// SPDX-License-Identifier: MIT
#include <tbb/global_control.h>

#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "asterism/apps/adaptation_json.hpp"
#include "asterism/apps/commands.hpp"
#include "asterism/apps/complain.hpp"
#include "asterism/apps/held_signals.hpp"
#include "asterism/apps/option_values.hpp"
#include "asterism/apps/places.hpp"
#include "asterism/apps/solution_options.hpp"
#include "asterism/apps/thread_limit.hpp"
#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/medit.hpp"
#include "asterism/mesh/io/write_mesh.hpp"

namespace asterism::apps {
using namespace internal;
namespace fs = std::filesystem;
namespace {

struct metric_job {
  metric_request request;
  fs::path output;
  std::size_t threads = 0;
  bool quiet = false, json = false;
};

constexpr const char* metric_examples =
    R"(Makes the metric in which the next mesh for a solution is best, at the vertices of the mesh it is on.
The steps, in this order: second derivatives of each field; the metric that is optimal in the L^P
norm; fields intersected, sorted by name; a factor; --intersect; --step; --hmin, --hmax, --aspect;
--gradation. The factor is found such that the outcome has the complexity wanted.
OUT is a mesh with its metric in .sol beside it: `asterism mesh DOMAIN --metric OUT --size 1`.

Exit status: 0 done; 1 the target cannot be met, the nearest metric is written, and the reason told;
2 bad usage or input, nothing is written.

Examples:
  asterism metric plate.mesh --solution u.sol --vertices 5000 --gradation 1.5 -o wanted.mesh
  asterism metric plate.mesh --solution flow.vtu --field p --field v.x --norm 1 --hmin 1e-4 -o m.mesh
  asterism metric plate.mesh --implied -o own.mesh)";

std::optional<error> check_files(const metric_job& job) {
  if (!has_ending(job.output.string(), ".mesh"))
    return error{job.output.string() + ": a metric is written as .mesh, with its .sol"};
  std::vector<fs::path> used = files_of(job.request);
  used.push_back(job.output);
  used.push_back(solution_path(job.output));
  if (auto failed = check_distinct(used)) return failed;
  for (const fs::path& place : {job.output, solution_path(job.output)})
    if (auto failed = check_place(place)) return failed;
  return std::nullopt;
}

int run_metric(metric_job job) {
  std::optional<tbb::global_control> threads;
  if (job.threads > 0) threads.emplace(tbb::global_control::max_allowed_parallelism, job.threads);
  set_defaults(job.request);
  if (const auto failed = check_request(job.request)) return complain(*failed, refused);
  if (const auto failed = check_files(job)) return complain(*failed, refused);
  const auto made = answer(job.request);
  if (!made) return complain(made.failure(), refused);
  const solution_metric_report& report = made.value().report;
  write_options options;
  if (!report.reached) options.note = "The target was not met: " + report.reason;
  const held_signals held;
  const auto written = write_mesh(job.output, made.value().background, options);
  if (!written) return complain(written.failure(), not_reached);
  if (job.json)
    std::cout << metric_json(report, report.reached ? done : not_reached,
                             {job.output, solution_path(job.output)});
  else if (!job.quiet)
    std::cout << "metric: " << internal::text_of(report) << '\n';
  if (report.reached) return done;
  return complain({"not reached: " + report.reason}, not_reached);
}

}  // namespace

void add_metric_command(CLI::App& program, command& chosen) {
  auto* const app = program.add_subcommand("metric", "Make the metric that a solution asks for");
  const auto job = std::make_shared<metric_job>();
  add_solution_options(*app, job->request);
  app->add_option("-o,--output", job->output, "File to write")->required()->type_name("OUT");
  add_count(
      *app, "--threads", 1, most_threads,
      [job](std::uint64_t n) { job->threads = static_cast<std::size_t>(n); },
      "Threads to use (default: one a processor); the metric is the same for any number")
      ->type_name("N");
  auto* const quiet = app->add_flag("--quiet", job->quiet, "No summary");
  app->add_flag("--json", job->json, "The summary as a JSON object, in place of lines")
      ->excludes(quiet);
  app->footer(metric_examples);
  app->callback([job, &chosen] { chosen = [job] { return run_metric(*job); }; });
}

}  // namespace asterism::apps
