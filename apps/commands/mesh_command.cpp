// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <memory>
#include <string>

#include "asterism/apps/base/commands.hpp"
#include "asterism/apps/base/mesh_job.hpp"
#include "asterism/apps/help/value_lists.hpp"
#include "asterism/apps/job/run_mesh_job.hpp"
#include "asterism/apps/options/option_values.hpp"
#include "asterism/apps/options/periodic_options.hpp"
#include "asterism/apps/options/proof_output.hpp"
#include "asterism/apps/options/second_order.hpp"
#include "asterism/apps/options/size_options.hpp"
#include "asterism/apps/options/thread_limit.hpp"
#include "asterism/apps/pieces/pieces_job.hpp"

namespace asterism::apps {
namespace {

constexpr const char* mesh_examples =
    R"(Exit status: 0 complete and certified; 1 not reached, what is certain is written and says so;
2 bad usage or input, nothing is written.

Examples:
  asterism mesh square --random-points 10 --metric swirl:12 -o swirl.mesh -o swirl.svg
  asterism mesh square --metric 'expr:1+9*x^2;0;1' --size 0.2 --angle-bound 15 -o layer.vtu
  asterism mesh coast.poly --size 0.001 --pieces 64 -o coast/
  asterism mesh wing.poly --size 0.5 --size-near 2:0.01,1.2 --size-at 3,0,1:0.1 -o wing.mesh
  asterism mesh pipe.msh --size 0.1 --layers wall:1e-3,1.2 -o pipe.mesh
  asterism mesh square --size 0.2 --periodic 4,2 --periodic 1,3 -o torus.mesh
  asterism mesh part.poly --refine darts --angle-bound 10 -o part.mesh --certificate part.json)";

const std::map<std::string, refinement_strategy> strategies = {
    {"fill", refinement_strategy::fill},
    {"voronoi", refinement_strategy::voronoi_arcs},
    {"darts", refinement_strategy::poisson_darts}};

constexpr real_range complexities = {0, 1e100, false, true, "positive, at most 1e100"};

void take_gradation(const std::string& text, mesh_job& job) {
  job.gradation.reset();
  if (text != "none") job.gradation = real_of("--gradation", text, gradations);
}

// Adds the options for the metric and its scale.
void add_metric_options(CLI::App& app, mesh_job& job) {
  app.add_option("--metric", job.metric, "The metric wanted (default identity)")->type_name("SPEC");
  auto* const size = add_real(
      app, "--size", sizes, [&job](double x) { job.size = x; },
      "Length wanted of an edge, in the metric as given");
  size->type_name("H");
  auto* const vertices = add_count(
      app, "--vertices", 3, 100000000,
      [&job](std::uint64_t n) { job.refinement.vertices = static_cast<std::size_t>(n); },
      "Number of vertices wanted, in place of a size: the metric is scaled to it");
  vertices->type_name("N")->excludes(size);
  add_real(
      app, "--complexity", complexities, [&job](double x) { job.complexity = x; },
      "Area of the domain as the metric shall measure it, in place of a size")
      ->type_name("C")
      ->excludes(size)
      ->excludes(vertices);
  app.add_option_function<std::string>(
         "--gradation", [&job](const std::string& text) { take_gradation(text, job); },
         "Make the metric change slowly: neighbouring edges differ by a factor of about BETA, or "
         "none "
         "(default)")
      ->type_name("BETA");
}

// Adds the options for the domain and its boundary, and for vertices inside.
void add_domain_options(CLI::App& app, mesh_job& job) {
  auto* const repair = app.add_flag("--repair-domain", job.repair,
                                    "Make crossings of segments vertices, join points that nearly "
                                    "coincide, close gaps; notes and pictures show each repair");
  add_real(
      app, "--repair-distance", positive_reals, [&job](double x) { job.repair_distance = x; },
      "Distance within which points are joined (default: the least that suffices, from 1e-12 to "
      "2.4e-4 of the width)")
      ->type_name("D")
      ->needs(repair);
  add_real(
      app, "--chord-tolerance", positive_reals, [&job](double x) { job.chord_tolerance = x; },
      "Greatest distance of a curve from its chords (default: a fiftieth of each chord, and with a "
      "size a fiftieth of it, as the metric has it across the curve)")
      ->type_name("D");
  add_periodic_option(app, job.periodic);
  app.add_flag("--convex-hull", job.convex_hull,
               "Close the domain by the convex hull of its vertices: of a .node file, or segments "
               "that bound nothing");
  app.add_flag(
      "--no-split-across", job.no_split_across,
      "No inner edge joins two vertices of the boundary, so that no triangle has all three "
      "there");
  app.add_flag("--regions", job.number_regions,
               "Number every region that has no region point, from 1");
  add_count(
      app, "--random-points", 0, 1000000,
      [&job](std::uint64_t n) { job.random_points = static_cast<std::size_t>(n); },
      "Vertices to add at random inside the domain, kept in the mesh")
      ->type_name("N");
}

void add_refinement_options(CLI::App& app, mesh_job& job) {
  mesh_options& options = job.refinement;
  add_real(
      app, "--angle-bound", angle_bounds, [&options](double x) { options.angle_bound = x; },
      "Least angle of a triangle, as each of its vertices measures it (default 20)")
      ->type_name("DEG");
  app.add_option_function<std::string>(
         "--refine",
         [&options](const std::string& name) { options.strategy = strategies.at(name); },
         "fill (default): fill to the size, then mend; voronoi: vertices and ends of Voronoi "
         "arcs; darts: random points")
      ->check([](const std::string& name) {
        return name == "guaranteed" ? "it is called 'fill' now: it guarantees nothing of the result"
                                    : std::string();
      })
      ->check(CLI::IsMember(strategies))
      ->type_name("HOW");
  add_real(
      app, "--metric-tolerance", reals_from_zero,
      [&options](double x) { options.metric_tolerance = x; },
      "Greatest distance of the metric delivered from the one asked for, ln of a ratio of lengths; "
      "0: no tensor is changed, even where stars cannot agree then (default: any, reported, but at "
      "half of the sites no more than ln 10, and no more than ten times as dense or as thin)")
      ->type_name("T");
  add_real(
      app, "--tol", positive_reals, [&options](double x) { options.tolerance = x; },
      "Least metric distance between sites (default: chosen, and reported)")
      ->type_name("T");
}

// Adds the option that chooses the size itself; it excludes every other option about how the mesh
// is made.
void add_guarantee_option(CLI::App& app, mesh_job& job) {
  auto* const guarantee =
      app.add_flag("--guarantee", job.guarantee,
                   "Make edges shorter, until the theorem on nets applies to the mesh: angles, "
                   "agreement and dual are proved then; refused where a corner is too sharp for "
                   "it, or the metric jumps");
  for (const char* other : {"--vertices", "--complexity", "--refine", "--metric-tolerance", "--tol",
                            "--improve", "--pieces", "--periodic", "--no-split-across"})
    guarantee->excludes(other);
}

// Adds the limits on a run, and the options that its course depends on.
void add_run_options(CLI::App& app, mesh_job& job) {
  mesh_options& options = job.refinement;
  add_count(
      app, "--max-sites", 3, 100000000,
      [&options](std::uint64_t n) { options.max_sites = static_cast<std::size_t>(n); },
      "Refinement ends at this many (default 100000, or more: three times those that --vertices or "
      "--complexity ask for, ten times the domain's vertices; of a piece 100000000)")
      ->type_name("N");
  add_count(
      app, "--improve", 0, 1000,
      [&options](std::uint64_t n) { options.improve_passes = static_cast<std::size_t>(n); },
      "Passes over the finished mesh, for fewer sites and better shapes (default 0)")
      ->type_name("N");
  add_seconds_option(app, job.max_seconds, "Refinement ends after this time");
  add_real(
      app, "--max-memory", positive_reals, [&job](double x) { job.max_megabytes = x; },
      "Refinement ends when this much is in use, in megabytes")
      ->type_name("MB");
  add_threads_option(app, job.threads, "the mesh is");
  add_count(
      app, "--seed", 0, UINT64_MAX, [&options](std::uint64_t n) { options.seed = n; },
      "Of the random points and of the darts (default 1)")
      ->type_name("N");
}

// Raises the default limit where more sites are asked for by number, with room for the sites that
// boundaries and angles need.
void make_room(mesh_job& job) {
  constexpr double most = 1e8, times = 3, more = 1000, vertices_of_complexity = 1.2;
  const double asked = job.refinement.vertices
                           ? static_cast<double>(*job.refinement.vertices)
                           : vertices_of_complexity * job.complexity.value_or(0);
  const auto room =
      static_cast<std::size_t>(job.pieces > 0 ? most : std::min(times * asked + more, most));
  job.refinement.max_sites = std::max(job.refinement.max_sites, room);
}

// Adds the options of a mesh in pieces.
void add_piece_options(CLI::App& app, mesh_job& job) {
  auto* const pieces = add_count(
      app, "--pieces", 1, 1000000,
      [&job](std::uint64_t n) { job.pieces = static_cast<std::size_t>(n); },
      "Cut the domain into K pieces of about equal size, mesh them one after another, and write "
      "one mesh each, with an index, to the folder OUT");
  pieces->type_name("K");
  app.add_option(
         "--piece-format", job.piece_formats,
         "Write each piece in this format too: msh, vtu and all others of OUT but html; may "
         "be given several times")
      ->needs(pieces)
      ->type_name("EXT")
      ->allow_extra_args(false);
  app.add_flag("--resume", job.resume,
               "Continue an interrupted run in pieces: complete pieces in the folder are kept")
      ->needs(pieces);
}

void add_output_options(CLI::App& app, mesh_job& job) {
  app.add_option("-o,--output", job.outputs, "File to write; may be given several times")
      ->required()
      ->type_name("OUT")
      ->allow_extra_args(false);
  app.add_option("--certificate", job.certificate,
                 "The certificate's file (default: first OUT with extension .certificate.json)")
      ->type_name("FILE");
  add_order_option(app, job.order)->excludes(app.get_option("--pieces"));
  add_proof_option(app, job.proof);
  app.add_flag("--voronoi", job.refinement.prove_voronoi,
               "Prove it the dual of the anisotropic Voronoi diagram, or end with status 1");
  // Accepts the older spelling, which help does not show.
  app.add_option_function<std::string>(
         "--certify",
         [&job](const std::string& what) { job.refinement.prove_voronoi = what == "voronoi"; })
      ->check(CLI::IsMember({"stars", "voronoi"}))
      ->type_name("WHAT")
      ->group("");
  app.add_flag("--ellipses", job.ellipses, "Draw the metric in pictures");
  app.add_flag("--strict", job.strict,
               "Refuse a domain of which something would be changed or passed over, with a note");
  add_summary_flags(app, job.quiet, job.json, "No progress, no summary");
}

}  // namespace

void add_mesh_command(CLI::App& program, command& chosen, piece_team* team) {
  auto* const app = program.add_subcommand("mesh", "Mesh a domain, and certify the mesh");
  const auto job = std::make_shared<mesh_job>();
  const auto sizes_asked = std::make_shared<std::vector<worded_size>>();
  app->add_option("DOMAIN", job->domain, "What to mesh")->required();
  add_metric_options(*app, *job);
  add_domain_options(*app, *job);
  add_size_options(*app, *job, *sizes_asked);
  add_refinement_options(*app, *job);
  add_run_options(*app, *job);
  add_piece_options(*app, *job);
  add_guarantee_option(*app, *job);
  add_output_options(*app, *job);
  app->footer(mesh_values() + "\n" + mesh_examples);
  app->callback([app, job, sizes_asked, team, &chosen] {
    take_sizes(*job, *sizes_asked);
    if (job->guarantee && !job->size && job->sizes.is_empty() && !job->sizes_of_file) job->size = 1;
    job->refinement.limit_size = job->size || job->complexity || job->refinement.vertices ||
                                 !job->sizes.is_empty() || job->sizes_of_file;
    job->keeps_site_limit = app->count("--max-sites") > 0;
    if (!job->keeps_site_limit) make_room(*job);
    if (job->no_split_across && (job->pieces > 0 || team != nullptr))
      throw CLI::ValidationError("--no-split-across", "a mesh in pieces is not looked at for that");
    if (job->pieces > 0 || team != nullptr)
      chosen = [job, team] { return run_pieces_job(*job, team); };
    else
      chosen = [job] { return run_mesh_job(*job); };
  });
}

}  // namespace asterism::apps
