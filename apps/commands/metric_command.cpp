// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <chrono>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "asterism/apps/base/commands.hpp"
#include "asterism/apps/base/complain.hpp"
#include "asterism/apps/base/notes.hpp"
#include "asterism/apps/options/option_values.hpp"
#include "asterism/apps/options/solution_options.hpp"
#include "asterism/apps/options/thread_limit.hpp"
#include "asterism/apps/run/held_signals.hpp"
#include "asterism/apps/run/places.hpp"
#include "asterism/apps/text/adaptation_json.hpp"
#include "asterism/apps/text/summary.hpp"
#include "asterism/core/number_text.hpp"
#include "asterism/mesh/claims/metric_series.hpp"
#include "asterism/mesh/claims/metric_words.hpp"
#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/file_output.hpp"
#include "asterism/mesh/io/medit.hpp"
#include "asterism/mesh/io/write_mesh.hpp"
#include "asterism/mesh/support/one_line.hpp"

namespace asterism::apps {
using namespace internal;
namespace fs = std::filesystem;
namespace {

struct metric_job {
  metric_request request;
  std::vector<std::string> series;  // solutions of windows in time, in place of one
  fs::path output;
  std::size_t threads = 0;
  bool quiet = false, json = false;
};

constexpr const char* metric_examples =
    R"(Makes the metric in which the next mesh for a solution is best, at the vertices of the mesh it is on.
The steps, in this order: second derivatives of each field; the metric that is optimal in the L^P
norm; fields intersected, sorted by name; a factor; --intersect; --step; --hmin, --hmax, --aspect;
--gradation. The factor is found such that the outcome has the complexity wanted.
OUT is a mesh with its metric in .sol beside it, or the .sol alone:
`asterism mesh DOMAIN --metric OUT --size 1`.

Exit status: 0 done; 1 the target cannot be met, the nearest metric is written, and the reason told;
2 bad usage or input, nothing is written.

Examples:
  asterism metric plate.mesh --solution u.sol --vertices 5000 --gradation 1.5 -o wanted.mesh
  asterism metric plate.mesh --solution flow.vtu --field p --field v.x --norm 1 --hmin 1e-4 -o m.mesh
  asterism metric plate.mesh --implied -o own.mesh
  asterism metric plate.mesh --series t1.sol --series t2.sol --vertices 3000 -o wanted.mesh)";

// Returns OUT.mesh, or OUT.1.mesh to OUT.N.mesh for N windows.
std::vector<fs::path> outputs_of(const metric_job& job) {
  if (job.series.empty()) return {job.output};
  std::vector<fs::path> all;
  for (std::size_t k = 1; k <= job.series.size(); ++k) {
    fs::path name = job.output;
    all.push_back(
        name.replace_extension("." + std::to_string(k) + job.output.extension().string()));
  }
  return all;
}

// True if the output holds the metric without a mesh.
bool is_alone(const fs::path& output) { return has_ending(output.string(), ".sol"); }

// Returns the outputs with the files beside them.
std::vector<fs::path> written_files(const metric_job& job) {
  std::vector<fs::path> all;
  for (const fs::path& output : outputs_of(job)) {
    all.push_back(output);
    if (!is_alone(output)) all.push_back(solution_path(output));
  }
  return all;
}

// Checks the options of a series for contradictions, and sets their defaults, by the rules for a
// metric of one solution.
std::optional<error> take_series(metric_job& job) {
  if (job.series.empty()) return std::nullopt;
  const metric_request& request = job.request;
  if (is_of_fields(request) || !request.metric.empty() || request.implied)
    return error{
        "--series stands in the place of --solution, --given-hessian, --metric and "
        "--implied: name one of them",
        error_code::bad_option};
  for (const std::string& file : job.series)
    if (file.find('\n') != std::string::npos)
      return error{"a name has a line end in it: " + quoted_token(file), error_code::bad_option};
  job.request.solution = job.series.front();
  return std::nullopt;
}

std::optional<error> check_files(const metric_job& job) {
  if (!has_ending(job.output.string(), ".mesh") && !is_alone(job.output))
    return error{job.output.string() +
                 ": a metric is written as .mesh, with its .sol beside it, or as .sol alone"};
  std::vector<fs::path> read = files_of(job.request);
  read.insert(read.end(), job.series.begin(), job.series.end());
  const std::vector<fs::path> written = written_files(job);
  // Refuses a window that is given twice, which would weigh twice; the mesh's own file may be one
  // of the windows.
  std::vector<fs::path> once = written;
  for (const std::string& window : job.series)
    if (window != job.request.mesh) once.emplace_back(window);
  if (auto failed = check_distinct({}, once)) return failed;
  if (auto failed = check_distinct(read, written)) return failed;
  for (const fs::path& place : written)
    if (auto free = check_writable(place); !free) return free.failure();
  return std::nullopt;
}

// Returns one metric for each file that is written.
result<metric_series> metrics_for(const metric_job& job) {
  if (!job.series.empty()) return answer_series(job.request, job.series);
  auto made = answer(job.request);
  if (!made) return made.failure();
  metric_series one;
  one.windows.push_back(std::move(made.value().background));
  one.left_out.push_back(std::move(made.value().left_out));
  one.report = std::move(made.value().report);
  return one;
}

// Returns sites with the identity at the vertices that the reader left out of the mesh, so that a
// metric that is written alone has a tensor for each vertex of the mesh's file.
mesh with_left_out(const mesh& made, const std::vector<vertex_index>& left_out) {
  mesh whole;
  auto next = left_out.begin();
  for (const site& s : made.sites) {
    for (; next != left_out.end() && *next == whole.sites.size(); ++next)
      whole.sites.push_back(site{point{0, 0}, metric_tensor{1, 0, 1}});
    whole.sites.push_back(s);
  }
  whole.sites.resize(whole.sites.size() + static_cast<std::size_t>(left_out.end() - next),
                     site{point{0, 0}, metric_tensor{1, 0, 1}});
  return whole;
}

// Says what readers changed in the meshes, once for windows on one mesh.
void say_what_was_changed(const metric_series& made, bool quiet) {
  std::vector<std::string> said;
  for (const mesh& window : made.windows) {
    if (window.notes == said) continue;
    said = window.notes;
    (void)say_notes(said, {quiet});
  }
}

// Writes the metric with its mesh, or alone. `note` says what was not reached.
result<bool> write_metric(const fs::path& output, const mesh& made,
                          const std::vector<vertex_index>& left_out, const std::string& note) {
  write_options options;
  options.note = note;
  if (!is_alone(output)) {
    const auto written = write_mesh(output, made, options);
    return written ? result<bool>(true) : written.failure();
  }
  std::string text = medit_solution_text(left_out.empty() ? made : with_left_out(made, left_out));
  if (!note.empty()) text.insert(text.find('\n') + 1, "# " + note + "\n");
  const auto written = internal::write_files({{output, text}});
  return written ? result<bool>(true) : written.failure();
}

void summarize(const metric_job& job, const metric_series& made) {
  std::cout << "metric: " << internal::text_of(made.report) << '\n';
  for (std::size_t k = 0; k < made.complexities.size(); ++k)
    std::cout << fmt::format("window {}, {}: complexity {:.6g}\n", k + 1,
                             internal::printable(job.series[k]), made.complexities[k]);
}

int run_metric(metric_job job) {
  const auto start = std::chrono::steady_clock::now();
  const thread_limit threads(job.threads);
  if (const auto failed = take_series(job)) return complain(*failed, refused);
  set_defaults(job.request);
  if (const auto failed = check_request(job.request)) return complain(*failed, refused);
  if (const auto failed = check_files(job)) return complain(*failed, refused);
  const auto made = metrics_for(job);
  if (!made) return complain(made.failure(), refused);
  say_what_was_changed(made.value(), job.quiet);
  const solution_metric_report& report = made.value().report;
  const std::string note = report.reached ? "" : "The target was not met: " + report.reason;
  const held_signals held;
  const std::vector<fs::path> outputs = outputs_of(job);
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    const auto written =
        write_metric(outputs[k], made.value().windows[k], made.value().left_out[k], note);
    if (!written) return complain(written.failure(), not_reached);
  }
  if (job.json)
    std::cout << metric_json(report, report.reached ? done : not_reached, written_files(job),
                             made.value().complexities);
  else if (!job.quiet) {
    summarize(job, made.value());
    write_files_written(std::cout, written_files(job), start);
  }
  if (report.reached) return done;
  return complain({"not reached: " + report.reason}, not_reached);
}

}  // namespace

void add_metric_command(CLI::App& program, command& chosen) {
  auto* const app = program.add_subcommand("metric", "Make the metric that a solution asks for");
  const auto job = std::make_shared<metric_job>();
  add_solution_options(*app, job->request);
  app->add_option("--series", job->series,
                  "The solution of a window in time, several times, with one complexity over all: "
                  "values at the vertices of MESH, or a mesh with its own. --vertices and "
                  "--complexity are then means over the windows, and OUT.1.mesh, OUT.2.mesh, ... "
                  "are written")
      ->type_name("FILE")
      ->allow_extra_args(false);
  app->add_option("-o,--output", job->output, "File to write")->required()->type_name("OUT");
  add_threads_option(*app, job->threads, "the metric is");
  add_summary_flags(*app, job->quiet, job->json, "No summary");
  app->footer(metric_examples);
  app->callback([job, &chosen] { chosen = [job] { return run_metric(*job); }; });
}

}  // namespace asterism::apps
