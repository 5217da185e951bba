// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "asterism/apps/base/commands.hpp"
#include "asterism/apps/base/complain.hpp"
#include "asterism/apps/base/notes.hpp"
#include "asterism/apps/options/option_values.hpp"
#include "asterism/apps/options/periodic_options.hpp"
#include "asterism/apps/options/second_order_text.hpp"
#include "asterism/apps/options/thread_limit.hpp"
#include "asterism/apps/run/progress_line.hpp"
#include "asterism/apps/run/run_limits.hpp"
#include "asterism/apps/text/json_summary.hpp"
#include "asterism/apps/text/summary.hpp"
#include "asterism/apps/text/verdict_text.hpp"
#include "asterism/apps/text/verify_question.hpp"
#include "asterism/apps/verify/verify_domain.hpp"
#include "asterism/apps/verify/verify_mesh.hpp"
#include "asterism/apps/verify/verify_metric.hpp"
#include "asterism/apps/verify/verify_pieces_command.hpp"
#include "asterism/apps/verify/verify_subject.hpp"
#include "asterism/apps/verify/verify_surface.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/claims/field_claims.hpp"
#include "asterism/mesh/claims/measured_claims.hpp"
#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/medit.hpp"
#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/mesh/pipeline/foreign_mesh.hpp"
#include "asterism/mesh/pipeline/outcome_claims.hpp"
#include "asterism/mesh/support/one_line.hpp"

namespace asterism::apps {
using namespace internal;
namespace fs = std::filesystem;
namespace {

constexpr const char* verify_examples =
    R"(MESH is a mesh in any format that is written and read: NAME.mesh with its metric in NAME.sol,
.meshb, .msh, .vtu. Everything is checked again from the files, in exact arithmetic; so are triangles
of second order, where the file holds them. .su2, .14, .grd
and .2dm have no place for the metric and for segments: these are taken from the certificate, and the
verdict says so. NAME.certificate.json beside the mesh is used when there is one and none is
named. Each part of the question that an option names is judged: the domain, the bound, the
metric and how far the mesh's may be from it. What no option names is taken from the certificate,
and the verdict says so. Random points added to the domain need not be named.

Of a folder that `mesh --pieces` wrote every piece is checked, and that all together are a mesh of the
domain; one of its pieces is checked by itself as any other mesh.

Exit status: 0 certified; 1 refused, with witnesses (numbers count from 1), or no angle bound is
known, from a certificate or --angle-bound, and nothing is certified; 2 unreadable.

Examples:
  asterism verify swirl.mesh
  asterism verify swirl.vtu --domain swirl.poly
  asterism verify part.mesh --certificate part.json
  asterism verify coast/
  asterism verify other.mesh --angle-bound 15 --domain part.poly
  asterism verify part.mesh --domain part.poly --repair-distance 0.01 --angle-bound 20 \
                  --metric swirl:3 --size 0.1 --metric-tolerance 0.5)";

// Reads the certificate that is named, or the one beside the mesh, or none.
result<std::optional<certificate>> find_certificate(const verify_options& options) {
  fs::path path = options.certificate;
  if (path.empty()) {
    path = fs::path(options.mesh).replace_extension(".certificate.json");
    std::error_code ignored;
    if (!fs::exists(path, ignored)) return std::optional<certificate>();
  }
  auto read = read_certificate(path);
  if (!read) return read.failure();
  return std::optional<certificate>(std::move(read).value());
}

void contradict(std::vector<std::string> all, verify_report& verdict) {
  for (std::string& said : all) {
    verdict.contradictions.push_back(std::move(said));
    verdict.verified = false;
  }
}

std::string bound_text(const judgement& judged) {
  if (judged.bound_by == asked_by::nobody) return "no bound asked for";
  return fmt::format("bound {} degrees{}", judged.bound, by_text(judged.bound_by));
}

// Returns a clause that sizes were not checked. The size in a certificate of `certify` is a scale
// of the metric, which is compared.
std::string size_text(const std::optional<certificate>& claim) {
  if (!claim || claim->options.count("mesh") != 0) return "";
  const auto size = claim->options.find("size");
  if (size == claim->options.end() || size->second == "none") return "";
  std::string text = "; size asked for " + size->second + ", not checked";
  const auto delivered = claim->options.find("size-delivered");
  if (delivered != claim->options.end() && delivered->second != size->second)
    text += ", delivered " + delivered->second;
  return text;
}

// Returns the words for the metric in which the theorem on nets was measured: the mesh's own.
std::string theorem_metric_text(const metric_answer& metric) {
  if (metric.apart) return "in the metric delivered, ";
  return metric.made ? "in the metric asked for, " : "in the metric of the file, ";
}

// Returns a sentence on the guarantee of the certificate, which holds; empty where it has
// none.
std::string guarantee_text(const verify_report& verdict, const std::optional<certificate>& claim) {
  if (!claim || !claim->guarantee || !verdict.theorem || !verdict.verified) return "";
  if (!verdict.theorem->applies) return "";  // at the bound asked now, which is another
  return "; guaranteed: " + text_of(*claim->guarantee, *verdict.theorem);
}

std::string scope_text(const judgement& judged, const std::optional<certificate>& claim,
                       bool tells_theorem) {
  const verify_report& verdict = judged.verdict;
  std::string text = "; " + bound_text(judged) + "; " + text_of(judged.shape, claim) +
                     "; metric: " + text_of(judged.metric) + judged.completed;
  text += deviation_text(verdict.audit) + curves_text(verdict.audit) + former_text(claim);
  if (!verdict.regions.empty()) text += "; " + regions_text(verdict.regions);
  if (!judged.frozen.empty()) text += "; " + judged.frozen;
  if (judged.second_order)
    text += "; " + text_of(*judged.second_order);
  else if (claim && claim->second_order)
    text += "; triangles of second order are in other files, not checked";
  if (!verdict.audit.stars_checked) text += "; stars not checked";
  if (verdict.audit.stars_cut_short) text += "; " + cut_short_text(verdict.audit);
  text += periodic_text(verdict.periodic);
  text += size_text(claim);
  if (verdict.theorem && tells_theorem)
    text += "; the theorem on nets, " + theorem_metric_text(judged.metric) +
            theorem_text(*verdict.theorem);
  return text + guarantee_text(verdict, claim) + voronoi_text(verdict.audit);
}

void write_verdict(const judgement& judged, const std::string& scope) {
  const verify_report& verdict = judged.verdict;
  const audit_report& audit = verdict.audit;
  const bool unasked = audit.certified && verdict.contradictions.empty() &&
                       judged.metric.refusals.empty() && judged.side_refusals.empty() &&
                       !audit.angles_checked;
  std::cout << (verdict.verified ? in_colour("certified", ink::green, 1) + ": "
                : unasked ? in_colour("no bound asked for: not certified", ink::yellow, 1) + ": "
                          : in_colour("REFUSED", ink::red, 1) + ": ")
            << audit.sites << " sites, " << audit.triangles << " triangles, " << angles_text(audit)
            << one_line(scope) << '\n';
  for (const std::string& contradiction : verdict.contradictions)
    std::cout << "certificate: " << one_line(contradiction) << '\n';
  for (const std::string& refusal : judged.metric.refusals)
    std::cout << "metric: " << one_line(refusal) << '\n';
  for (const std::string& refusal : judged.side_refusals)
    std::cout << "periodic: " << one_line(refusal) << '\n';
  write_findings(std::cout, audit);
}

// Judges a mesh that comes without certificate and domain, as `certify` does.
verify_report verify_alone(adopted_mesh& adopted, const audit_options& asked) {
  audit_options questions = questions_for(adopted);
  questions.angle_bound = asked.angle_bound;
  questions.check_voronoi = asked.check_voronoi;
  questions.findings_kept = asked.findings_kept;
  questions.stop = asked.stop;
  return verify(adopted.subject, std::nullopt, questions);
}

audit_options questions_of(const verify_options& options, const asked_domain& shape) {
  audit_options asked;
  asked.angle_bound = options.angle_bound;
  asked.check_voronoi = options.prove_voronoi;
  asked.findings_kept = findings_kept(options.all_findings);
  if (shape.shape) asked.original = &*shape.shape;
  return asked;
}

// Judges a mesh of which the domain is named, or in the certificate.
void judge_claimed(const mesh& subject, const std::optional<certificate>& claim,
                   const audit_options& asked, judgement& judged) {
  judged.verdict = verify(subject, claim, asked);
  contradict(judged.shape.contradictions, judged.verdict);
  if (!claim) return;
  contradict(contradictions_in_measured(subject, *claim), judged.verdict);
  contradict(contradictions_in_outcome(*claim), judged.verdict);
}

// Results of matching the periodic sides that options name.
struct side_answer {
  std::vector<periodic_match> matches;
  std::vector<std::string> refusals;
};

side_answer match_sides(const std::vector<periodic_pair>& pairs, const mesh& subject) {
  side_answer found;
  for (const periodic_pair& one : pairs) {
    auto match = match_periodic(subject, one);
    if (match)
      found.matches.push_back(std::move(match).value());
    else
      found.refusals.push_back(match.failure().message);
  }
  return found;
}

// Adds the match of sides to the verdict. Refuses the mesh for sides that do not match.
void take_sides(side_answer found, judgement& judged) {
  std::vector<periodic_match>& known = judged.verdict.periodic;
  for (const periodic_match& one : found.matches)
    if (std::find(known.begin(), known.end(), one) == known.end()) known.push_back(one);
  if (!found.refusals.empty()) judged.verdict.verified = false;
  judged.side_refusals = std::move(found.refusals);
}

// Judges the mesh. Takes its own boundary as the domain where no option or certificate names one.
result<judgement> judge(const verify_options& options, judged_mesh read,
                        const std::optional<certificate>& claim, asked_domain shape,
                        std::vector<std::string> of_file, const cancellation& stop) {
  judgement judged;
  side_answer sides;
  judged.frozen = read.frozen;
  judged.shape = std::move(shape);
  const domain* const numbered = judged.shape.shape         ? &*judged.shape.shape
                                 : claim && claim->original ? &*claim->original
                                                            : nullptr;
  if (numbered != nullptr) number_segments(options, *numbered, read);
  judged.second_order = judge_second_order(read, claim, numbered, of_file);
  audit_options asked = questions_of(options, judged.shape);
  asked.stop = stop;
  const std::optional<domain> placed = claim ? placed_in(*claim) : std::nullopt;
  const domain* where = asked.original;
  if (placed && (where == nullptr || claim->options.count("metric-box") != 0)) where = &*placed;
  if (auto failed = complete_metric(read, options, claim, where)) return *failed;
  judged.completed = text_of_completion(read, claim.has_value());
  mesh subject = std::move(read.content);
  auto metric = judge_metric(options, subject, claim, where);
  if (!metric) return metric.failure();
  judged.metric = std::move(metric).value();
  judged.metric.is_taken = read.took_metric;
  if (!claim && !judged.shape.shape) {
    auto adopted = adopt_mesh(std::move(subject), region_edges::as_listed, slit_rule::joined);
    if (!adopted) return adopted.failure().at(options.mesh.string());
    if (auto refusal = say_notes(adopted.value().subject.notes, {})) return *refusal;
    judged.verdict = verify_alone(adopted.value(), asked);
    sides = match_sides(options.periodic, adopted.value().subject);
  } else {
    if (auto refusal = say_notes(subject.notes, {})) return *refusal;
    judge_claimed(subject, claim, asked, judged);
    sides = match_sides(options.periodic, subject);
  }
  contradict(judged.metric.contradictions, judged.verdict);
  take_sides(std::move(sides), judged);
  contradict(std::move(of_file), judged.verdict);
  if (!judged.metric.refusals.empty()) judged.verdict.verified = false;
  if (!judged.verdict.audit.angles_checked) return judged;
  judged.bound_by = options.angle_bound ? asked_by::option : asked_by::certificate;
  judged.bound = options.angle_bound ? *options.angle_bound : *claim->angle_bound;
  return judged;
}

int tell(const verify_options& options, const std::optional<certificate>& claim,
         const judgement& judged) {
  const int status = judged.verdict.verified ? done : not_reached;
  const std::string scope = scope_text(judged, claim, options.tells_theorem);
  if (options.json)
    std::cout << summary_json(judged, status, scope.substr(2));
  else
    write_verdict(judged, scope);
  return status;
}

// Reads the domain, and completes a mesh whose format has no place for its segments: from the
// certificate's domain, or else from the one named.
result<asked_domain> find_shape(const verify_options& options, judged_mesh& subject,
                                const std::optional<certificate>& claim) {
  std::optional<std::string> contradiction;
  const bool is_claimed = claim && claim->original;
  if (is_claimed) contradiction = complete_segments(subject, *claim->original);
  auto shape = find_domain(options, subject.content, claim);
  if (!shape) return shape;
  if (!is_claimed && shape.value().shape)
    contradiction = complete_segments(subject, *shape.value().shape);
  if (contradiction)
    shape.value().contradictions.push_back(
        "the mesh is not of " +
        (is_claimed ? "the certificate's domain" : "domain " + shape.value().name) + ": " +
        *contradiction);
  return shape;
}

// Adds to a refusal the command that judges meshes of other programs.
error with_way_out(const error& refusal, const fs::path& mesh) {
  const std::string name = mesh.string();
  std::error_code ignored;
  if (!is_mesh_file(name)) return {refusal.message + kind_hint(mesh), refusal.code};
  const bool is_medit = has_ending(name, ".mesh") || has_ending(name, ".meshb");
  if (!is_medit || fs::exists(solution_path(mesh), ignored)) return refusal;
  const auto plain = read_mesh_file(mesh, {.identity_without_solution = true});
  if (!plain || plain.value().content.triangles.empty()) return refusal;
  return {refusal.message + "; `asterism certify " + name + "` judges a mesh without a metric",
          refusal.code};
}

int run_verify(const verify_options& options) {
  if (const auto status = verify_surface(options)) return *status;
  run_limits limits(options.max_seconds, std::nullopt);
  auto subject = read_judged(options);
  if (!subject) return complain(with_way_out(subject.failure(), options.mesh), refused);
  const auto claim = find_certificate(options);
  if (!claim) return complain(claim.failure(), refused);
  std::vector<std::string> of_file;
  if (const auto failed = take_frozen(claim.value(), subject.value(), of_file))
    return complain(*failed, refused);
  auto shape = find_shape(options, subject.value(), claim.value());
  if (!shape) return complain(shape.failure(), refused);
  const std::size_t sites = subject.value().content.sites.size();
  limits.expect(sites);
  progress_line line(true);
  line.show({.phase = mesh_phase::auditing, .sites = sites});
  const auto judged =
      judge(options, std::move(subject).value(), claim.value(), std::move(shape).value(),
            std::move(of_file), [&limits] { return limits.reason(); });
  limits.conclude();
  line.clear();
  if (!judged) return complain(judged.failure(), refused);
  return tell(options, claim.value(), judged.value());
}

// Adds the options that are parts of the question.
void add_question(CLI::App& app, verify_options& options) {
  add_real(
      app, "--angle-bound", angle_bounds, [&options](double x) { options.angle_bound = x; },
      "Check this bound (default: the certificate's)")
      ->type_name("DEG");
  auto* const shape = app.add_option("--domain", options.domain, "What it should be a mesh of")
                          ->type_name("DOMAIN");
  add_real(
      app, "--repair-distance", positive_reals,
      [&options](double x) { options.repair_distance = x; },
      "It should be a mesh of that domain as --repair-domain repairs it within this distance")
      ->type_name("D")
      ->needs(shape);
  app.add_flag("--convex-hull", options.convex_hull,
               "The domain named by --domain was meshed with --convex-hull")
      ->needs(shape);
  app.add_flag("--regions", options.number_regions,
               "The domain named by --domain was meshed with --regions");
  auto* const metric =
      app.add_option("--metric", options.metric, "The metric it should be in, as `mesh` takes it")
          ->type_name("SPEC");
  add_real(
      app, "--size", sizes, [&options](double x) { options.size = x; },
      "Length of an edge of metric length 1, in the metric as given by --metric (default: the "
      "certificate's, or 1)")
      ->type_name("H")
      ->needs(metric);
  add_real(
      app, "--gradation", gradations, [&options](double x) { options.gradation = x; },
      "Gradation of that metric (default: the certificate's, or none)")
      ->type_name("BETA")
      ->needs(metric);
  add_real(
      app, "--metric-tolerance", reals_from_zero,
      [&options](double x) { options.metric_tolerance = x; },
      "How far the metric of the mesh may be from the one asked for: the logarithm of the greatest "
      "ratio of lengths (default: what the certificate says was asked of its metric, and 0)")
      ->type_name("T");
  add_periodic_option(app, options.periodic);
  app.add_flag("--voronoi", options.prove_voronoi,
               "Prove it the dual of the anisotropic Voronoi diagram (done without, too, when "
               "the certificate claims it)");
}

}  // namespace

void add_verify_command(CLI::App& program, command& chosen, piece_team* team) {
  auto* const app = program.add_subcommand("verify", "Check a mesh again from its files");
  const auto options = std::make_shared<verify_options>();
  app->add_option("MESH", options->mesh, "What to check")->required();
  app->add_option("--certificate", options->certificate, "What is claimed of it")
      ->type_name("FILE");
  add_question(*app, *options);
  add_seconds_option(*app, options->max_seconds,
                     "Checking ends after this time, with status 1 if it was not done");
  app->add_flag("--long", options->tells_theorem,
                "Say, too, whether the theorem on nets applies to the mesh, and why not");
  app->add_flag("--json", options->json, "The verdict as a JSON object, in place of lines");
  const auto threads = std::make_shared<std::size_t>(0);
  add_threads_option(*app, *threads, "the answer is");
  add_judging_flags(*app, options->all_findings, options->all_edges);
  app->footer(verify_examples);
  app->callback([options, team, threads, &chosen] {
    chosen = [options, team, threads] {
      const thread_limit limit(*threads);
      return team != nullptr || is_of_pieces(*options) ? run_verify_pieces(*options, team)
                                                       : run_verify(*options);
    };
  });
}

}  // namespace asterism::apps
