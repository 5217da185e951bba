// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "asterism/apps/base/commands.hpp"
#include "asterism/apps/base/complain.hpp"
#include "asterism/apps/base/notes.hpp"
#include "asterism/apps/job/frozen.hpp"
#include "asterism/apps/job/job_input.hpp"
#include "asterism/apps/job/job_words.hpp"
#include "asterism/apps/options/option_values.hpp"
#include "asterism/apps/options/periodic_options.hpp"
#include "asterism/apps/options/proof_output.hpp"
#include "asterism/apps/options/second_order.hpp"
#include "asterism/apps/options/solution_options.hpp"
#include "asterism/apps/options/thread_limit.hpp"
#include "asterism/apps/run/progress_line.hpp"
#include "asterism/apps/run/run_files.hpp"
#include "asterism/apps/run/run_limits.hpp"
#include "asterism/apps/text/adaptation_json.hpp"
#include "asterism/apps/text/page_facts.hpp"
#include "asterism/apps/text/summary.hpp"
#include "asterism/apps/text/transfer_text.hpp"
#include "asterism/core/number_text.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/claims/adaptation_words.hpp"
#include "asterism/mesh/claims/metric_words.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/domain/divide_curves.hpp"
#include "asterism/mesh/domain/smooth_vertices.hpp"
#include "asterism/mesh/io/load_domain.hpp"
#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/mesh/io/solution_output.hpp"
#include "asterism/mesh/metric/interpolated_field.hpp"
#include "asterism/mesh/pipeline/adapt_to_metric.hpp"
#include "asterism/mesh/pipeline/adaptation_target.hpp"
#include "asterism/mesh/pipeline/curved_sides.hpp"
#include "asterism/mesh/pipeline/foreign_mesh.hpp"

namespace asterism::apps {
using namespace internal;
namespace fs = std::filesystem;
namespace {

struct adapt_job {
  metric_request request;
  std::string domain;
  mesh_adaptation_options options;
  transfer_method how = transfer_method::interpolate;
  std::vector<fs::path> outputs;
  fs::path values, carried, certificate;  // the solution, and what is carried, on the new mesh
  fs::path proof;
  std::optional<double> chord_tolerance, max_seconds;
  std::vector<std::string> frozen;  // regions, by number or name
  bool convex_hull = false;         // of the domain's vertices, as segments
  std::size_t threads = 0;
  int order = 1;  // of the triangles in files that hold second ones
  bool quiet = false, json = false;
  bool strict = false;  // what readers change is refused
};

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

const std::map<std::string, keep_rule> keep_rules = {
    {"auto", keep_rule::automatic}, {"never", keep_rule::never}, {"always", keep_rule::always}};

// The mesh, metric, solution and reports of a run, before they are written.
struct adapted {
  requested_metric wanted;
  adapted_mesh next;
  std::optional<transferred_solution> values;
  std::optional<std::size_t> vertices_wanted;  // none where the metric alone says how many
  proof_output proof = {};
  std::vector<side_node> curved = {};  // of triangles of second order
  // The part outside frozen regions, with its metric, and the whole mesh that is written.
  mesh rest = {}, together = {};
  frozen_facts frozen = {};
  std::size_t border_split = 0;  // edges, where no way was found to leave them whole

  bool has_frozen() const { return !frozen.regions.empty(); }
  const mesh& written() const { return has_frozen() ? together : next.made.outcome.result; }
  const mesh& background() const { return has_frozen() ? rest : wanted.background; }
};

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

// Returns the files of the run.
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
  if (job.values.empty() && job.carried.empty()) return made;
  const mesh& joined = made.written();
  if (joined.triangles.empty())
    return error{"the run ended before there was a triangle to bring values to: " +
                 made.next.made.claim.reason};
  auto values = transfer_solution(made.wanted.background, made.wanted.values,
                                  part_cracks(joined, made.next.cracks).content, job.how);
  if (!values) return values.failure();
  made.values = std::move(values).value();
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

// Returns the fields of the solution alone, without those that are only transferred.
solution own_fields(const solution& all, std::size_t own) {
  solution shown{all.vertices, all.fields};
  if (shown.fields.size() > own) shown.fields.resize(own);
  return shown;
}

// Puts the mesh before the adaptation, and the solution on both meshes, onto the page. Shows the
// interpolated solution where no transfer was asked for.
void show_solution(const adapt_job& job, const adapted& made, report_facts& facts) {
  const solution& old = made.wanted.values;
  const std::size_t own = made.wanted.own_fields;
  facts.label = "Adapted";
  facts.before = {{"Before", made.wanted.background, own_fields(old, own), {}}};
  if (old.fields.empty()) return;
  // Leaves out values on a mesh with slits: a page has one vertex at each place, and values of the
  // two sides may differ.
  if (made.values && made.next.cracks.empty()) {
    facts.fields = own_fields(made.values->values, own);
    return;
  }
  auto shown =
      transfer_solution(made.wanted.background, own_fields(old, own), made.written(), job.how);
  if (shown) facts.fields = std::move(shown).value().values;
}

report_facts facts_of_page(const adapt_job& job, const fs::path& certificate_path,
                           const adapted& made) {
  const certified_mesh& next = made.next.made;
  report_facts facts;
  facts.title = job.request.mesh + ", metric of " + next.claim.metric;
  facts.claim = next.claim;
  facts.claim_from = "As the run that made this page judged the mesh it had made.";
  facts.repeat = repeating_command(job.outputs, certificate_path);
  const auto adopted =
      adopt_mesh(made.wanted.background, region_edges::segments, slit_rule::joined);
  if (next.outcome.delivered && adopted)
    facts.wanted =
        tensors_at_sites(*make_interpolated_field(adopted.value().subject, 1), made.written());
  show_solution(job, made, facts);
  return facts;
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

// Writes a line on whether the given mesh stays, where the options do not determine that.
void say_kept(const adapt_job& job, const adapted& made) {
  const bool always = job.options.keep == keep_rule::always;
  if (made.next.kept && job.options.keep == keep_rule::never)
    std::cout << "the new mesh is the one given, vertex by vertex\n";
  else if (made.next.kept)
    std::cout << (always ? "the mesh stays as it is, as --keep always wants it\n"
                         : "the mesh meets its metric and stays as it is\n");
  else if (always)
    std::cout << "a new mesh: the one given is not certified in the metric, as one of its domain\n";
}

void summarize(const adapt_job& job, const adapted& made) {
  write_summary(std::cout, made.next.made, made.next.made.claim.measured.at("unit_edges"));
  if (made.has_frozen())
    std::cout << text_of(made.frozen, job.options.refinement.angle_bound) << '\n';
  std::cout << "metric: " << internal::text_of(made.wanted.report) << '\n';
  if (made.next.keeps_boundary)
    std::cout << "domain: all boundary vertices kept, as its parts touch; --domain names one "
                 "exactly\n";
  else if (made.next.boundary_vertices > 0)
    std::cout << fmt::format(
        "domain: {} of {} boundary vertices kept; old and new boundary within {:.3g} of each "
        "other\n",
        made.next.boundary_kept, made.next.boundary_vertices, made.next.boundary_distance);
  write_periodic(std::cout, made.next.made.claim);
  std::cout << cracks_text(made.next.cracks);
  say_kept(job, made);
  if (made.next.made.outcome.delivered)
    std::cout << "delivered: " << text_of(*made.next.made.outcome.delivered) << '\n';
  if (made.values) std::cout << text_of(made.values->report);
}

adapt_facts facts_of(const adapted& made) {
  return {made.wanted.report, made.next, made.values ? &made.values->report : nullptr,
          made.vertices_wanted};
}

// Returns an option to add after a run that did not reach its goal; empty where none would help. A
// bound on sizes where most of the complexity is on edges as long as the domain, as it is where the
// solution varies in one direction alone. A greater distance where the boundary bends and leaves
// more vertices than were wanted, or angles below the bound.
std::string next_step(const adapt_job& job, const adapted& made) {
  const adapted_mesh& next = made.next;
  const mesh_outcome& outcome = next.made.outcome;
  if (outcome.how() == ending::stopped) return "";
  constexpr double most = 0.5, part = 0.5;
  const bool has_bound = std::isfinite(job.request.wishes.greatest_size);
  if (made.wanted.report.complexity_along_ridges > most && !has_bound) {
    const bounding_box box = next.shape.box();
    return fmt::format("--hmax {:.2g}, or an --aspect of 30",
                       part * std::max(box.high.x - box.low.x, box.high.y - box.low.y));
  }
  constexpr double greatest = 0.125, factor = 4, usual = 0.03;
  const double now = job.options.boundary_part.value_or(usual);
  const bool is_polygon = job.domain.empty() && !job.options.largest_boundary_distance;
  const bool has_more = made.vertices_wanted && outcome.sites > *made.vertices_wanted;
  if (is_polygon && !next.shape.curves.empty() && now < greatest &&
      (has_more || !next.made.certified()))
    return fmt::format("--boundary-part {:g}, which lets more vertices of the boundary go",
                       std::min(greatest, factor * now));
  return "";
}

int run_adapt(adapt_job job) {
  const auto start = std::chrono::steady_clock::now();
  const thread_limit threads(job.threads);
  const run_files files = files_written_by(job);
  set_defaults(job.request);
  if (const auto failed = check_request(job.request)) return complain(*failed, refused);
  if (const auto failed = check_solutions(job)) return complain(*failed, refused);
  if (const auto failed = check_files(files, files_read_by(job))) return complain(*failed, refused);
  run_limits limits(job.max_seconds, std::nullopt);
  if (const auto failed = take_domain(job)) return complain(*failed, refused);
  auto made = adapt(job, limits);
  if (!made) return complain(made.failure(), refused);
  if (made.value().border_split > 0)
    return complain({fmt::format("not reached: {} edges of the border of the frozen regions are "
                                 "split, however coarse the metric is made there; nothing is "
                                 "written",
                                 made.value().border_split)},
                    not_reached);
  describe(job, made.value());
  const certified_mesh& next = made.value().next.made;
  made.value().proof =
      find_proof(job.proof, next.outcome.result, &made.value().next.shape, next.report.certified);
  limits.conclude();
  if (const auto failed = curve(job, made.value())) return complain(*failed, not_reached);
  if (const auto failed = write_all(job, files, made.value()))
    return complain(*failed, not_reached);
  const auto missed =
      what_is_missed(made.value().next, made.value().wanted.report, made.value().vertices_wanted);
  const int status = missed || made.value().proof.missing ? not_reached : done;
  if (job.json)
    std::cout << adapt_json(facts_of(made.value()), status,
                            written_files(files, made.value().proof));
  else if (!job.quiet) {
    summarize(job, made.value());
    write_files_written(std::cout, written_files(files, made.value().proof), start);
  }
  if (!missed) return made.value().proof.conclude(done);
  complain({"not reached: " + *missed}, not_reached);
  const std::string next_one = next_step(job, made.value());
  if (!next_one.empty() && !job.quiet) std::cerr << "asterism: try " << next_one << '\n';
  return made.value().proof.conclude(not_reached);
}

void add_mesh_options(CLI::App& app, adapt_job& job) {
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

}  // namespace

void add_adapt_command(CLI::App& program, command& chosen) {
  auto* const app = program.add_subcommand("adapt", "Make the next mesh for a solution");
  const auto job = std::make_shared<adapt_job>();
  add_solution_options(*app, job->request);
  add_mesh_options(*app, *job);
  add_transfer_option(*app, job->how);
  app->add_option("--frozen", job->frozen,
                  "A region whose triangles stay exactly as they are, by number or name; may be "
                  "given several times. The rest is adapted and certified by itself")
      ->excludes(app->get_option("--domain"))
      ->type_name("REGION")
      ->allow_extra_args(false);
  app->add_option("-o,--output", job->outputs, "File to write; may be given several times")
      ->required()
      ->type_name("OUT")
      ->allow_extra_args(false);
  app->add_option("--solution-out", job->values, "The solution on the new mesh, .sol or .bb")
      ->type_name("FILE");
  auto* const carry =
      app->add_option("--carry", job->request.carried,
                      "Fields at the vertices, transferred to the new mesh without a part in the "
                      "metric: .sol, .bb or .vtu")
          ->type_name("FILE");
  auto* const carried =
      app->add_option("--carry-out", job->carried, "Those on the new mesh, .sol or .bb")
          ->type_name("FILE")
          ->needs(carry);
  carry->needs(carried);
  app->add_option("--certificate", job->certificate,
                  "The certificate's file (default: first OUT with extension .certificate.json)")
      ->type_name("FILE");
  add_order_option(*app, job->order);
  add_proof_option(*app, job->proof);
  app->get_option("--frozen")->excludes(app->get_option("--proof"));
  add_summary_flags(*app, job->quiet, job->json, "No progress, no summary");
  app->add_flag("--strict", job->strict,
                "Refuse a mesh of which something would be changed or passed over, with a note");
  app->footer(adapt_examples);
  app->callback([job, &chosen] { chosen = [job] { return run_adapt(*job); }; });
}

}  // namespace asterism::apps
