// SPDX-License-Identifier: MIT
#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "asterism/apps/adapt/run_adapt_job.hpp"
#include "asterism/apps/base/commands.hpp"
#include "asterism/apps/job/job_words.hpp"
#include "asterism/apps/options/option_values.hpp"
#include "asterism/apps/options/periodic_options.hpp"
#include "asterism/apps/options/proof_output.hpp"
#include "asterism/apps/options/second_order.hpp"
#include "asterism/apps/options/solution_options.hpp"
#include "asterism/apps/options/thread_limit.hpp"
#include "asterism/apps/run/run_limits.hpp"
#include "asterism/apps/text/transfer_text.hpp"

namespace asterism::apps {
namespace {

const std::map<std::string, keep_rule> keep_rules = {
    {"auto", keep_rule::automatic}, {"never", keep_rule::never}, {"always", keep_rule::always}};

constexpr const char* adapt_examples =
    R"(Makes the mesh on which the next solution is best: the metric that the solution asks for (see
`asterism metric --help`), a mesh of the same domain in it, certified, and the solution on that.
The domain is the mesh's: its corners, required vertices and edges, ends of markers, and where it
turns by more than --corner-angle stay; all else may go, as near to the old boundary as --hausd
says, and what comes is put on cubics through the old vertices. Or it is the one named by --domain.
A mesh that is as good as a new one already stays as it is (--keep).

Exit status: 0 complete and certified; 1 not reached, what is certain is written and says so;
2 bad usage or input, nothing is written.

Examples:
  asterism adapt old.mesh --solution u.sol --vertices 4000 -o new.mesh --solution-out new_u.sol
  asterism adapt old.mesh --solution u.bb --error 1e-3 --domain wing.poly --transfer project \
                 -o new.mesh --solution-out new_u.bb)";

// Adds the options for the domain and its boundary.
void add_domain_options(CLI::App& app, adapt_job& job) {
  constexpr real_range corner_angles = {0, 180, false, true, "above 0, at most 180 degrees"};
  constexpr real_range boundary_parts = {0, 0.125, false, true, "above 0, at most 0.125"};
  auto* const exact =
      app.add_option("--domain", job.domain, "What to mesh (default: what the mesh covers)")
          ->type_name("DOMAIN");
  app.add_flag("--convex-hull", job.convex_hull, "Close DOMAIN by the convex hull of its vertices")
      ->needs(exact);
  add_real(
      app, "--chord-tolerance", positive_reals, [&job](double x) { job.chord_tolerance = x; },
      "Greatest distance of a curve of DOMAIN from its chords (default: a fiftieth of each chord, "
      "and a hundredth of the size wanted across it)")
      ->needs(exact)
      ->type_name("D");
  add_real(
      app, "--corner-angle", corner_angles, [&job](double x) { job.options.corner_angle = x; },
      "Vertices where the boundary turns by more stay (default 30)")
      ->excludes(exact)
      ->type_name("DEG");
  add_real(
      app, "--hausd", positive_reals,
      [&job](double x) { job.options.largest_boundary_distance = x; },
      "Greatest distance of old and new boundary, both ways (default: where vertices go, a "
      "hundredth of the size wanted across it)")
      ->excludes(exact)
      ->type_name("D");
  add_real(
      app, "--boundary-part", boundary_parts, [&job](double x) { job.options.boundary_part = x; },
      "Without --hausd, greatest distance of a piece of the boundary from what it takes the place "
      "of, in sizes wanted across it and in its length (default 0.01 and 0.03)")
      ->excludes(exact)
      ->type_name("P");
  add_periodic_option(app, job.options.periodic);
  app.add_flag(
      "--no-split-across", job.options.no_split_across,
      "No inner edge joins two vertices of the boundary, so that no triangle has all three "
      "there (splitpbedge of adaptmesh)");
}

// Adds the options for the mesh, and the limits of its making.
void add_refinement_options(CLI::App& app, adapt_job& job) {
  add_real(
      app, "--angle-bound", angle_bounds,
      [&job](double x) { job.options.refinement.angle_bound = x; },
      "Least angle of a triangle, as each of its vertices measures it (default 20)")
      ->type_name("DEG");
  add_real(
      app, "--metric-tolerance", reals_from_zero,
      [&job](double x) { job.options.refinement.metric_tolerance = x; },
      "Greatest distance of the metric delivered from the one wanted, ln of a ratio of lengths; 0: "
      "no tensor is changed (default: any, reported)")
      ->type_name("T");
  app.add_option_function<std::string>(
         "--keep", [&job](const std::string& word) { job.options.keep = keep_rules.at(word); },
         "Whether MESH may be kept. auto (default): if it is as good as a new one; never; always: "
         "if it is certified in the metric")
      ->check(CLI::IsMember(keep_rules))
      ->type_name("WHEN");
  add_count(
      app, "--max-sites", 3, 100000000,
      [&job](std::uint64_t n) {
        job.options.refinement.max_sites = static_cast<std::size_t>(n);
        job.options.keeps_site_limit = true;
      },
      "Refinement ends at this many (default 100000, or three times those wanted, 10000000 at "
      "most; "
      "where a metric alone wants them, no more than ten times those of MESH)")
      ->type_name("N");
  add_seconds_option(app, job.max_seconds, "Refinement ends after this time");
  add_threads_option(app, job.threads, "everything is");
}

// Adds the options for the files of a run, and for what stays and what is transferred.
void add_file_options(CLI::App& app, adapt_job& job) {
  app.add_option("--frozen", job.frozen,
                 "A region whose triangles stay exactly as they are, by number or name; may be "
                 "given several times. The rest is adapted and certified by itself")
      ->excludes(app.get_option("--domain"))
      ->type_name("REGION")
      ->allow_extra_args(false);
  app.add_option("-o,--output", job.outputs, "File to write; may be given several times")
      ->required()
      ->type_name("OUT")
      ->allow_extra_args(false);
  app.add_option("--solution-out", job.values, "The solution on the new mesh, .sol or .bb")
      ->type_name("FILE");
  auto* const carry =
      app.add_option("--carry", job.request.carried,
                     "Fields at the vertices, transferred to the new mesh without a part in the "
                     "metric: .sol, .bb or .vtu")
          ->type_name("FILE");
  auto* const carried =
      app.add_option("--carry-out", job.carried, "Those on the new mesh, .sol or .bb")
          ->type_name("FILE")
          ->needs(carry);
  carry->needs(carried);
  app.add_option("--certificate", job.certificate,
                 "The certificate's file (default: first OUT with extension .certificate.json)")
      ->type_name("FILE");
  add_order_option(app, job.order);
  add_proof_option(app, job.proof);
  app.get_option("--frozen")->excludes(app.get_option("--proof"));
}

}  // namespace

void add_adapt_command(CLI::App& program, command& chosen) {
  auto* const app = program.add_subcommand("adapt", "Make the next mesh for a solution");
  const auto job = std::make_shared<adapt_job>();
  add_solution_options(*app, job->request);
  add_domain_options(*app, *job);
  add_refinement_options(*app, *job);
  add_transfer_option(*app, job->how);
  add_file_options(*app, *job);
  add_summary_flags(*app, job->quiet, job->json, "No progress, no summary");
  app->add_flag("--strict", job->strict,
                "Refuse a mesh of which something would be changed or passed over, with a note");
  app->footer(adapt_examples);
  app->callback([job, &chosen] { chosen = [job] { return run_adapt_job(*job); }; });
}

}  // namespace asterism::apps
