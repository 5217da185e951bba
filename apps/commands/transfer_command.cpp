// SPDX-License-Identifier: MIT

#include <chrono>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "asterism/apps/base/commands.hpp"
#include "asterism/apps/base/complain.hpp"
#include "asterism/apps/base/notes.hpp"
#include "asterism/apps/options/option_values.hpp"
#include "asterism/apps/options/thread_limit.hpp"
#include "asterism/apps/run/held_signals.hpp"
#include "asterism/apps/run/places.hpp"
#include "asterism/apps/text/adaptation_json.hpp"
#include "asterism/apps/text/summary.hpp"
#include "asterism/apps/text/transfer_text.hpp"
#include "asterism/mesh/io/medit.hpp"
#include "asterism/mesh/io/solution_file.hpp"
#include "asterism/mesh/io/solution_output.hpp"
#include "asterism/mesh/pipeline/read_triangulation.hpp"
#include "asterism/mesh/transfer/transfer.hpp"

namespace asterism::apps {
using namespace internal;
namespace fs = std::filesystem;
namespace {

struct transfer_job {
  std::string from, values, to;
  transfer_method how = transfer_method::interpolate;
  fs::path output;
  std::size_t threads = 0;
  bool quiet = false, json = false, strict = false;
};

constexpr const char* transfer_examples =
    R"(Brings a solution from the vertices of one mesh to those of another mesh of the same domain. Nothing is
read across a gap or a hole. The summary has, for each component, its integral before and after, and
its least and greatest value.

Exit status: 0 done; 2 bad usage or input, nothing is written.

Examples:
  asterism transfer old.mesh u.sol new.mesh -o v.sol
  asterism transfer old.mesh u.sol new.mesh --transfer project -o v.sol)";

std::optional<error> check_files(const transfer_job& job) {
  const auto place = check_solution_output(job.output);
  if (!place) return place.failure();
  return check_distinct({job.from, job.values, job.to}, {job.output});
}

// Returns the solution with zeros at the vertices that the reader left out of the mesh, so that it
// has a row for each vertex of the file.
solution with_rows(const solution& s, const std::vector<vertex_index>& left_out) {
  if (left_out.empty()) return s;
  solution whole{s.vertices + left_out.size(), {}};
  for (const solution_field& f : s.fields) {
    const std::size_t width = components_of(f.kind);
    solution_field& filled = whole.fields.emplace_back(solution_field{f.name, f.kind, {}});
    filled.values.assign(whole.vertices * width, 0);
    auto next = left_out.begin();
    for (std::size_t v = 0, from = 0; v < whole.vertices; ++v) {
      if (next != left_out.end() && *next == v) {
        ++next;
        continue;
      }
      for (std::size_t i = 0; i < width; ++i)
        filled.values[v * width + i] = f.values[from * width + i];
      ++from;
    }
  }
  return whole;
}

int run_transfer(const transfer_job& job) {
  const auto start = std::chrono::steady_clock::now();
  const thread_limit threads(job.threads);
  if (const auto failed = check_files(job)) return complain(*failed, refused);
  const auto from = read_plain_mesh_file(job.from);
  if (!from) return complain(from.failure(), refused);
  const mesh& source = from.value().content;
  const auto values = internal::read_fields(job.values, source, from.value().left_out);
  if (!values) return complain(values.failure(), refused);
  if (values.value().fields.empty())
    return complain({job.values + ": there is no field in it to transfer"}, refused);
  const auto to = read_plain_mesh_file(job.to);
  if (!to) return complain(to.failure(), refused);
  for (const mesh_file* const read : {&from.value(), &to.value()})
    if (const auto failed = say_notes(read->content.notes, {job.quiet, job.strict}))
      return complain(*failed, refused);
  if (const auto failed = say_notes(values.value().notes, {job.quiet, job.strict}))
    return complain(*failed, refused);
  const auto done_so = transfer_solution(source, values.value(), to.value().content, job.how);
  if (!done_so) return complain(done_so.failure(), refused);
  const held_signals held;
  const auto written =
      write_solution(job.output, with_rows(done_so.value().values, to.value().left_out));
  if (!written) return complain(written.failure(), not_reached);
  if (job.json)
    std::cout << transfer_json(done_so.value().report, done, {job.output});
  else if (!job.quiet) {
    std::cout << text_of(done_so.value().report);
    write_files_written(std::cout, {job.output}, start);
  }
  return done;
}

}  // namespace

void add_transfer_command(CLI::App& program, command& chosen) {
  auto* const app = program.add_subcommand("transfer", "Bring a solution to another mesh");
  const auto job = std::make_shared<transfer_job>();
  app->add_option("OLD", job->from, "The mesh that the solution is on")->required();
  app->add_option("SOLUTION", job->values, "Values at its vertices: .sol, .bb or .vtu")->required();
  app->add_option("NEW", job->to, "The mesh to bring it to")->required();
  add_transfer_option(*app, job->how);
  app->add_option("-o,--output", job->output, "File to write, .sol or .bb")
      ->required()
      ->type_name("OUT");
  add_threads_option(*app, job->threads, "the values are");
  add_summary_flags(*app, job->quiet, job->json, "No summary");
  app->add_flag("--strict", job->strict, "Refuse a file that is read with a note");
  app->footer(transfer_examples);
  app->callback([job, &chosen] { chosen = [job] { return run_transfer(*job); }; });
}

}  // namespace asterism::apps
