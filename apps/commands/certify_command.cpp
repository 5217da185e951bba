// SPDX-License-Identifier: MIT

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "asterism/apps/base/commands.hpp"
#include "asterism/apps/base/complain.hpp"
#include "asterism/apps/base/notes.hpp"
#include "asterism/apps/job/job_words.hpp"
#include "asterism/apps/options/option_values.hpp"
#include "asterism/apps/options/proof_output.hpp"
#include "asterism/apps/options/second_order_text.hpp"
#include "asterism/apps/options/thread_limit.hpp"
#include "asterism/apps/run/places.hpp"
#include "asterism/apps/run/progress_line.hpp"
#include "asterism/apps/run/run_files.hpp"
#include "asterism/apps/run/run_limits.hpp"
#include "asterism/apps/text/json_summary.hpp"
#include "asterism/apps/text/page_facts.hpp"
#include "asterism/apps/text/summary.hpp"
#include "asterism/apps/text/verdict_text.hpp"
#include "asterism/core/number_text.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/data/site_box.hpp"
#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/medit.hpp"
#include "asterism/mesh/io/medit_solution.hpp"
#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/mesh/mesher.hpp"
#include "asterism/mesh/metric/interpolated_field.hpp"
#include "asterism/mesh/metric/make_metric_field.hpp"
#include "asterism/mesh/numerics/mesh_statistics.hpp"
#include "asterism/mesh/pipeline/certified_mesh.hpp"
#include "asterism/mesh/pipeline/foreign_mesh.hpp"
#include "asterism/mesh/pipeline/outcome_claims.hpp"
#include "asterism/mesh/pipeline/read_triangulation.hpp"

namespace asterism::apps {
using namespace internal;
namespace fs = std::filesystem;
namespace {

struct certify_options {
  fs::path mesh, solution, proof;
  std::optional<std::string> metric;  // instead of a solution
  double size = 1;
  std::vector<fs::path> outputs;
  double angle_bound = 20;
  bool repair = false;
  bool json = false;
  bool prove_voronoi = false;
  std::optional<std::size_t> max_sites;
  std::optional<double> max_seconds;
  std::size_t threads = 0;  // 0: one for each processor
  bool all_findings = false, all_edges = false;
  bool strict = false;          // what readers change is refused
  bool metric_assumed = false;  // as there is none
};

constexpr const char* certify_examples =
    R"(MESH is a file of triangles from any program: .mesh, .meshb, .msh (gmsh, FreeFEM), .vtu, .vtk, .su2,
.14 or .grd (ADCIRC), .2dm or .stl. SOL holds the metric of a Medit file, a symmetric tensor m11 m12
m22 at each vertex (default: NAME.sol beside NAME.mesh), or is BAMG's NAME.mtr; --metric and --size
give it by a formula instead, as for 'asterism mesh'. Where nobody gives a metric it is the identity,
which is said. The domain is what the file's Edges
enclose, or, when it lists none, the edges with one triangle. An edge listed with triangles on both
sides is a segment if the file requires it (RequiredEdges), or gives it a reference other than 0 in
a list that leaves inner edges out, or has triangles of different references on its sides. With
--repair every edge between triangles of different references is one, listed or not. Certified means: every triangle is in
the stars of its three vertices, none is inverted, none is below the bound as any of the three
measures it, but the domain's own angle at corners that are sharper themselves.

With --repair sites are added, in the metric of the formula or interpolated from the vertices, until
that holds. Whatever is certified is written to OUT, with a certificate; anything else only after
--repair, but for a page (OUT ends in .html), which shows what was found against the mesh, too.

Exit status: 0 certified; 1 not certified; 2 bad usage or input, nothing is written.

Examples:
  asterism certify grid.su2
  asterism certify bamg.mesh bamg.mtr --angle-bound 10
  asterism certify bamg.mesh -o bamg.html
  asterism certify bamg.mesh --metric swirl:24 --size 0.02 --repair -o repaired.mesh)";

// Lists the files that the run writes: outputs of the mesh, certificate and proof. A certificate is
// written only with an output.
run_files files_written_by(const certify_options& options) {
  run_files files{options.outputs, {}, options.proof, {}};
  if (!options.outputs.empty()) files.certificate = certificate_beside(options.outputs);
  return files;
}

std::optional<error> check_files(const certify_options& options) {
  if (options.repair && options.outputs.empty())
    return error{"--repair: name the file to write with -o", error_code::bad_option};
  if (options.outputs.empty() && options.proof.empty()) return std::nullopt;
  std::vector<fs::path> read = {options.mesh};
  if (!options.metric && options.solution.empty()) read = files_read_with(options.mesh);
  if (!options.metric && !options.solution.empty()) read.push_back(options.solution);
  if (options.metric && is_metric_on_mesh(*options.metric))
    for (fs::path& file : files_read_with(*options.metric)) read.push_back(std::move(file));
  return check_files(files_written_by(options), read);
}

std::optional<error> write_result(const certify_options& options, const mesh& m,
                                  const crack_markers& cracks, const certificate& claim,
                                  report_facts facts, const proof_output& proof) {
  const run_files files = files_written_by(options);
  write_options how;
  how.cracks = cracks;
  how.picture.angle_bound = options.angle_bound;
  how.note = file_note_of(claim);
  facts.claim = claim;
  if (!options.outputs.empty())
    facts.repeat = repeating_command(options.outputs, files.certificate);
  how.report = std::move(facts);
  how.names = names_in(options.mesh);
  return write_files(files, {m, claim, how, proof});
}

// Returns the command line that judges the same mesh again.
std::string command_of(const certify_options& options) {
  std::vector<std::string> words = {"asterism", "certify", options.mesh.string()};
  if (options.metric)
    words.insert(words.end(), {"--metric", *options.metric, "--size", format_number(options.size)});
  else if (!options.solution.empty())
    words.push_back(options.solution.string());
  words.insert(words.end(), {"--angle-bound", format_number(options.angle_bound)});
  if (options.prove_voronoi) words.emplace_back("--voronoi");
  if (options.all_edges) words.emplace_back("--all-edges");
  return shell_words(words);
}

// Adds to the certificate what only the command knows: the words of the options.
void describe(certificate& claim, const certify_options& options) {
  const fs::path& metric = options.solution.empty() ? options.mesh : options.solution;
  claim.metric = options.metric.value_or("of " + metric.string());
  claim.options = {{"mesh", options.mesh.string()},
                   {"repair", options.repair ? "yes" : "no"},
                   {"angle-bound", format_number(options.angle_bound)},
                   {"size", options.metric ? format_number(options.size) : "none"}};
}

bool is_dual_as_asked(const certify_options& options, const audit_report& report) {
  return !options.prove_voronoi || report.voronoi == voronoi_verdict::proved;
}

certificate claim_of_judgement(const certify_options& options, const adopted_mesh& adopted,
                               const certify_report& report) {
  audit_options asked = questions_for(adopted);
  asked.angle_bound = options.angle_bound;
  certificate claim = make_certificate(adopted.subject, asked, report.audit);
  claim.measured = by_name(measure(adopted.subject));
  describe(claim, options);
  return claim;
}

report_facts facts_of_page(const certify_options& options, const certify_report& report) {
  report_facts facts;
  facts.title = options.mesh.string();
  facts.claim_from = "As 'asterism certify' judged the mesh that it read.";
  facts.not_of_stars = report.not_in_all;
  return facts;
}

int write_as_it_is(const certify_options& options, const adopted_mesh& adopted,
                   const certify_report& report) {
  const exit_status status = is_dual_as_asked(options, report.audit) ? done : not_reached;
  if (options.outputs.empty() && options.proof.empty()) return status;
  const proof_output proof = find_proof(options.proof, adopted.subject, nullptr, true);
  certificate claim = claim_of_judgement(options, adopted, report);
  claim.complete = true;
  claim.reason = certified_as_it_came;
  const report_facts facts = facts_of_page(options, report);
  if (const auto failure =
          write_result(options, adopted.subject, adopted.cracks, claim, facts, proof))
    return complain(*failure, not_reached);
  return proof.conclude(status);
}

// Writes only pages for a mesh that is not certified: they show the findings.
int show_what_was_found(const certify_options& options, const adopted_mesh& adopted,
                        const certify_report& report) {
  std::vector<fs::path> pages;
  for (const fs::path& output : options.outputs)
    if (has_page({output})) pages.push_back(output);
  write_options how;
  how.report = facts_of_page(options, report);
  how.report.claim = claim_of_judgement(options, adopted, report);
  how.report.claim->reason = "the auditor refuses the mesh as it came";
  how.report.repeat = command_of(options);
  if (const auto failure =
          write_files({pages}, {adopted.subject, *how.report.claim, how, proof_output{}}))
    return complain(*failure, not_reached);
  return not_reached;
}

int repair(const certify_options& options, const adopted_mesh& adopted, const metric_field& field,
           const certify_report& before, run_limits& limits) {
  if (!before.is_triangulation())
    return complain({"--repair: " + options.mesh.string() +
                     " is no triangulation, so that it has no domain to go on from"},
                    not_reached);
  mesh_options wanted;
  wanted.angle_bound = options.angle_bound;
  constexpr std::size_t growth = 10, least = 100000;
  wanted.max_sites =
      options.max_sites.value_or(std::max(least, growth * adopted.subject.sites.size()));
  wanted.prove_voronoi = options.prove_voronoi;
  wanted.stop = [&limits] { return limits.reason(); };
  auto made = [&] {
    progress_line line(true);
    return make_certified_mesh(adopted.shape, field, wanted, [&](const mesh_progress& progress) {
      limits.expect(progress.sites);
      line.show(progress);
    });
  }();
  if (!made) return complain(made.failure(), refused);
  const mesh_outcome& outcome = made.value().outcome;
  const audit_report& judged = made.value().report;
  certificate& claim = made.value().claim;
  describe(claim, options);
  limits.conclude();
  report_facts facts;
  facts.title = options.mesh.string() + ", repaired";
  facts.claim_from = "As the run that made this page judged the mesh it had repaired.";
  if (has_page(options.outputs)) {
    facts.label = "Repaired";
    facts.before = {{"As it came", adopted.subject, {}, before.not_in_all}};
  }
  const bool reached = made.value().certified();
  const proof_output proof = find_proof(options.proof, outcome.result, nullptr, judged.certified);
  if (const auto failure =
          write_result(options, outcome.result, adopted.cracks, claim, facts, proof))
    return complain(*failure, not_reached);
  std::cout << (reached ? "certified" : "NOT certified") << ", repaired: " << outcome.sites
            << " sites, " << outcome.sites - adopted.subject.sites.size() << " of them new, "
            << outcome.triangles << " triangles, " << worst_angle_text(judged.worst().degrees)
            << '\n';
  if (!claim.regions.empty()) std::cout << regions_text(claim.regions) << '\n';
  if (reached && is_dual_as_asked(options, judged)) return proof.conclude(done);
  return complain({reached ? "not proved to be the dual of the Voronoi diagram: " +
                                 judged.findings.front().witness
                           : "not reached: " + claim.reason},
                  not_reached);
}

using made_field = result<std::unique_ptr<metric_field>>;

// Makes the field that --metric names: a formula's, or one on another mesh.
made_field field_named(const certify_options& options, const mesh& m) {
  if (!is_metric_on_mesh(*options.metric))
    return make_metric_field(*options.metric, box_of_sites(m.sites), options.size);
  const auto background = read_metric_on_mesh(*options.metric, options.mesh.string());
  if (!background) return background.failure();
  return make_interpolated_field(background.value().subject, options.size);
}

// Makes the field that --metric names, placed in the box of the vertices, and takes the tensors at
// these from it.
made_field measure_by_formula(const certify_options& options, mesh& m) {
  if (m.sites.empty())
    return error{options.mesh.string() + ": there are no vertices", error_code::invalid_mesh};
  auto field = field_named(options, m);
  if (!field) return field;
  for (std::size_t v = 0; v < m.sites.size(); ++v) {
    const auto metric = field.value()->at(m.sites[v].position);
    if (!metric)
      return metric.failure().at(options.mesh.string() + ": vertex " + std::to_string(v + 1));
    m.sites[v].metric = metric.value();
  }
  return field;
}

struct measured_mesh {
  adopted_mesh adopted;
  std::optional<second_order_report> second_order = {};  // of the triangles in the file
  std::unique_ptr<metric_field> field;
};

// Judges a mesh without a metric in the plane metric, as if that had been asked for.
result<measured_mesh> read_measured(certify_options& options) {
  medit_read_options how;
  how.solution = options.solution;
  how.without_solution = options.metric.has_value();
  how.identity_without_solution = options.solution.empty();
  how.all_edges = options.all_edges;
  auto read = read_mesh_file(options.mesh, how);
  if (!read) return read.failure();
  std::optional<second_order_report> second_order;
  if (read.value().second_order > 0) {
    second_order = prove_second_order(read.value().content, read.value().curved, nullptr);
    if (options.outputs.empty()) take_back_note_of_corners(read.value());
  }
  mesh& subject = read.value().content;
  if (!options.metric && !read.value().has_metric) {
    options.metric = "identity";
    options.metric_assumed = true;
  }
  std::unique_ptr<metric_field> formula;
  if (options.metric) {
    auto made = measure_by_formula(options, subject);
    if (!made) return made.failure();
    formula = std::move(made).value();
  }
  // Adds segments between regions only for a repair: a mesh to be judged has the segments that its
  // file lists.
  auto adopted = adopt_mesh(std::move(subject),
                            options.repair ? region_edges::segments : region_edges::as_listed,
                            slit_rule::joined);
  if (!adopted) return adopted.failure().at(options.mesh.string());
  if (auto refused = say_notes(adopted.value().subject.notes, {false, options.strict}))
    return *refused;
  return measured_mesh{std::move(adopted).value(), std::move(second_order), std::move(formula)};
}

certify_report judge(const certify_options& options, const adopted_mesh& adopted,
                     const run_limits& limits) {
  progress_line line(true);
  line.show({.phase = mesh_phase::auditing, .sites = adopted.subject.sites.size()});
  return certify(adopted, options.angle_bound, options.prove_voronoi,
                 findings_kept(options.all_findings), [&limits] { return limits.reason(); });
}

bool has_folds(const measured_mesh& measured) {
  return measured.second_order && !measured.second_order->proved();
}

// Writes the results, as lines or as an object.
void say_report(const certify_options& options, const measured_mesh& measured,
                const certify_report& report) {
  const auto& second_order = measured.second_order;
  if (options.json) {
    const bool good =
        report.certified() && !has_folds(measured) && is_dual_as_asked(options, report.audit);
    std::cout << summary_json(report, good ? done : not_reached, options.angle_bound, second_order);
    return;
  }
  write_report(std::cout, report, measured.adopted.subject, options.angle_bound,
               options.all_findings);
  if (second_order) std::cout << text_of(*second_order) << '\n';
}

int run_certify(certify_options options) {
  const thread_limit threads(options.threads);
  const bool is_medit = has_ending(options.mesh.string(), ".mesh");
  if (const fs::path beside = solution_path(options.mesh);
      options.solution.empty() && is_medit && internal::holds_tensors(beside))
    options.solution = beside;
  if (const auto failure = check_files(options)) return complain(*failure, refused);
  run_limits limits(options.max_seconds, std::nullopt);
  auto measured = read_measured(options);
  if (!measured) return complain(measured.failure(), refused);
  if (options.metric_assumed && !options.json)
    std::cout << "metric: identity, as there is none in the file or beside it\n";
  const adopted_mesh& adopted = measured.value().adopted;
  const std::size_t sites = adopted.subject.sites.size();
  if (options.max_sites && *options.max_sites < sites)
    return complain({"--max-sites " + std::to_string(*options.max_sites) + ": the mesh has " +
                     std::to_string(sites) + " vertices already"},
                    refused);
  limits.expect(sites);
  const certify_report report = judge(options, adopted, limits);
  say_report(options, measured.value(), report);
  if (has_folds(measured.value()))
    return complain({"NOT certified: " + text_of(*measured.value().second_order)}, not_reached);
  if (report.certified() || !options.repair) limits.conclude();
  if (report.certified()) return write_as_it_is(options, adopted, report);
  if (!options.repair) {
    if (!options.json) std::cerr << "asterism: try --repair -o REPAIRED.mesh\n";
    return show_what_was_found(options, adopted, report);
  }
  std::cout << std::flush;  // said even if the repair is ended where it stands
  if (!measured.value().field) measured.value().field = make_interpolated_field(adopted.subject);
  return repair(options, adopted, *measured.value().field, report, limits);
}

// Adds the options for the mesh and its metric.
void add_input_options(CLI::App& app, certify_options& options) {
  app.add_option("MESH", options.mesh, "What to certify")->required();
  auto* const solution =
      app.add_option("SOL", options.solution, "Its metric (default: NAME.sol beside NAME.mesh)");
  auto* const metric = app.add_option("--metric", options.metric, "Its metric, as `mesh` takes it");
  metric->type_name("SPEC")->excludes(solution);
  add_real(
      app, "--size", sizes, [&options](double x) { options.size = x; },
      "Length of an edge of metric length 1, in the metric as given by --metric")
      ->type_name("H")
      ->needs(metric);
}

}  // namespace

void add_certify_command(CLI::App& program, command& chosen) {
  auto* const app =
      program.add_subcommand("certify", "Certify, or repair, a mesh that came from elsewhere");
  const auto options = std::make_shared<certify_options>();
  add_input_options(*app, *options);
  app->add_option("-o,--output", options->outputs,
                  "Where to write what is certified or repaired; may be given several times")
      ->type_name("OUT")
      ->allow_extra_args(false);
  add_proof_option(*app, options->proof);
  add_real(
      *app, "--angle-bound", angle_bounds, [options](double x) { options->angle_bound = x; },
      "Least angle of a triangle, as each of its vertices measures it (default 20)")
      ->type_name("DEG");
  app->add_flag("--voronoi", options->prove_voronoi,
                "Prove it the dual of the anisotropic Voronoi diagram, or end with status 1");
  auto* const repair =
      app->add_flag("--repair", options->repair, "Add sites until it is certified");
  app->add_flag("--json", options->json, "The verdict as a JSON object, in place of lines")
      ->excludes(repair);
  add_count(
      *app, "--max-sites", 3, 100000000,
      [options](std::uint64_t n) { options->max_sites = static_cast<std::size_t>(n); },
      "Repair ends at this many (default: ten times as many as there are, at least 100000)")
      ->type_name("N");
  add_seconds_option(
      *app, options->max_seconds,
      "Ends after this time: NOT certified, unless it was done; a repair writes what there is");
  add_threads_option(*app, options->threads, "the answer is");
  add_judging_flags(*app, options->all_findings, options->all_edges);
  app->add_flag("--strict", options->strict, "Refuse a file that is read with a note");
  app->footer(certify_examples);
  app->callback([options, &chosen] { chosen = [options] { return run_certify(*options); }; });
}

}  // namespace asterism::apps
