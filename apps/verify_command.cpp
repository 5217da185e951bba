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

#include "asterism/apps/commands.hpp"
#include "asterism/apps/complain.hpp"
#include "asterism/apps/json_summary.hpp"
#include "asterism/apps/option_values.hpp"
#include "asterism/apps/progress_line.hpp"
#include "asterism/apps/run_limits.hpp"
#include "asterism/apps/summary.hpp"
#include "asterism/apps/verdict_text.hpp"
#include "asterism/core/number_text.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/domain/built_in_domains.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/domain/divide_curves.hpp"
#include "asterism/mesh/domain/point_in_domain.hpp"
#include "asterism/mesh/domain/repair_domain.hpp"
#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/load_domain.hpp"
#include "asterism/mesh/io/medit.hpp"
#include "asterism/mesh/pipeline/field_claims.hpp"
#include "asterism/mesh/pipeline/foreign_mesh.hpp"
#include "asterism/mesh/pipeline/measured_claims.hpp"

namespace asterism::apps {
using namespace internal;
namespace fs = std::filesystem;
namespace {

struct verify_options {
  fs::path mesh, certificate;
  std::optional<double> angle_bound;
  std::string domain;
  bool number_regions = false;
  bool prove_voronoi = false;
  bool all_findings = false, all_edges = false, json = false;
  std::optional<double> max_seconds;
};

constexpr const char* examples =
    R"(MESH is a Medit file NAME.mesh, with its metric in NAME.sol. Everything is checked again from the
files, in exact arithmetic. NAME.certificate.json beside the mesh is used when there is one and none
is named. The domain is the certificate's unless --domain names it; random points added to it
need not be named.

Exit status: 0 certified; 1 refused, with witnesses (numbers count from 1), or no angle bound is
known, from a certificate or --angle-bound, and nothing is certified; 2 unreadable.

Examples:
  asterism verify swirl.mesh
  asterism verify part.mesh --certificate part.json
  asterism verify other.mesh --angle-bound 15 --domain part.poly)";

// Reads the certificate that was named, or the one beside the mesh, or none.
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

// Repairs the domain as the certificate says it was: the same distance gives the same domain.
result<domain> repaired_as_claimed(const domain& d, const std::optional<certificate>& claim) {
  if (claim)
    if (const auto found = claim->options.find("repair-distance");
        found != claim->options.end() && found->second != "none") {
      const auto distance = parse_number(found->second);
      if (!distance) return distance.failure().at("certificate: repair-distance");
      return repair_domain(d, distance.value());
    }
  return check_domain(d);
}

// Divides the curves of the domain as the certificate says they were.
result<domain> divided_as_claimed(const domain& d, const std::optional<certificate>& claim) {
  if (!claim || !claim->original || d.curves.empty()) return divide_curves(d);
  std::vector<std::vector<double>> parameters;
  for (const domain_curve& c : claim->original->curves) parameters.push_back(c.parameters);
  return divide_curves_at(d, parameters);
}

// Reads the domain that was named; empty when none was. Vertices given to the mesh beyond the
// domain's own, as random points are, belong to it when they lie inside.
result<std::optional<domain>> find_domain(const verify_options& options, const mesh& subject,
                                          const std::optional<certificate>& claim) {
  if (options.domain.empty()) return std::optional<domain>();
  auto loaded = load_domain(options.domain);
  if (!loaded) return loaded.failure();
  if (options.number_regions) loaded.value().number_all_regions = true;
  const auto divided = divided_as_claimed(loaded.value(), claim);
  if (!divided) return divided.failure();
  auto checked = repaired_as_claimed(divided.value(), claim);
  if (!checked) return checked.failure();
  const domain bare = checked.value();
  for (std::size_t v = bare.vertices.size();
       v < std::min<std::size_t>(subject.given, subject.sites.size()); ++v)
    if (contains(bare, subject.sites[v].position))
      checked.value().vertices.push_back(subject.sites[v].position);
  return std::optional<domain>(std::move(checked).value());
}

// Checks that the tensors are those of the metric asked for. Returns the answer in words, and
// enters it into the verdict.
std::string check_metric(const mesh& subject, const certificate& claim, verify_report& verdict) {
  const field_check check = check_field(subject, claim);
  for (const std::string& said : check.contradictions) {
    verdict.contradictions.push_back(said);
    verdict.verified = false;
  }
  const std::string name =
      claim.delivered ? "another than asked for, " + claim.metric : claim.metric;
  if (!check.made) return name + ": field not checked, " + check.why_not;
  if (!check.contradictions.empty()) return name + ": REFUSED";
  return name + (claim.delivered ? ", whose distance was measured again"
                                 : ", held against it at every vertex");
}

void check_measured(const mesh& subject, const certificate& claim, verify_report& verdict) {
  for (std::string& said : contradictions_in_measured(subject, claim)) {
    verdict.contradictions.push_back(std::move(said));
    verdict.verified = false;
  }
}

std::string bound_text(const audit_report& audit, const audit_options& asked,
                       const std::optional<certificate>& claim) {
  if (!audit.angles_checked) return "no bound asked for";
  const double bound = asked.angle_bound ? *asked.angle_bound : *claim->angle_bound;
  return fmt::format("bound {} degrees", bound);
}

std::string domain_text(const verify_options& options, const std::optional<certificate>& claim) {
  if (!options.domain.empty()) return "domain " + options.domain;
  if (claim && claim->original) return "the certificate's domain";
  return "no domain to compare with but what the boundary encloses";
}

// Returns what is claimed, what was checked, and against what.
std::string scope_text(const verify_options& options, const audit_options& asked,
                       const std::optional<certificate>& claim, const verify_report& verdict,
                       const std::string& metric) {
  std::string text = "; " + bound_text(verdict.audit, asked, claim) + "; " +
                     domain_text(options, claim) + "; metric: " + metric;
  text += deviation_text(verdict.audit) + curves_text(verdict.audit);
  if (!verdict.audit.stars_checked) text += "; stars not checked";
  if (verdict.audit.stars_cut_short) text += "; " + cut_short_text(verdict.audit);
  if (claim) {
    const auto size = claim->options.find("size");
    if (size != claim->options.end() && size->second != "none") {
      const auto delivered = claim->options.find("size-delivered");
      text += "; size asked for " + size->second + ", not checked";
      if (delivered != claim->options.end() && delivered->second != size->second)
        text += ", delivered " + delivered->second;
    }
  }
  if (verdict.theorem) text += "; the theorem on nets " + theorem_text(*verdict.theorem);
  return text + voronoi_text(verdict.audit);
}

void write_verdict(const verify_report& verdict, const std::string& scope) {
  const audit_report& audit = verdict.audit;
  for (const std::string& contradiction : verdict.contradictions)
    std::cout << "certificate: " << contradiction << '\n';
  write_findings(std::cout, audit);
  const bool unasked = audit.certified && verdict.contradictions.empty() && !audit.angles_checked;
  std::cout << (verdict.verified ? in_colour("certified", ink::green, 1) + ": "
                : unasked ? in_colour("no bound asked for: not certified", ink::yellow, 1) + ": "
                          : in_colour("REFUSED", ink::red, 1) + ": ")
            << audit.sites << " sites, " << audit.triangles << " triangles, " << angles_text(audit)
            << scope << '\n';
}

// Judges a mesh that comes without certificate and domain, as `certify` judges it.
verify_report verify_alone(adopted_mesh& adopted, const audit_options& asked) {
  audit_options questions = questions_for(adopted);
  questions.angle_bound = asked.angle_bound;
  questions.check_voronoi = asked.check_voronoi;
  questions.findings_kept = asked.findings_kept;
  questions.stop = asked.stop;
  return verify(adopted.subject, std::nullopt, questions);
}

int judge(const verify_options& options, mesh subject, const std::optional<certificate>& claim,
          const std::optional<domain>& original, run_limits& limits) {
  audit_options asked;
  asked.angle_bound = options.angle_bound;
  asked.check_voronoi = options.prove_voronoi;
  asked.findings_kept = findings_kept(options.all_findings);
  limits.expect(subject.sites.size());
  asked.stop = [&limits] { return limits.reason(); };
  progress_line line(true);
  line.show({.phase = mesh_phase::auditing, .sites = subject.sites.size()});
  if (original) asked.original = &*original;
  verify_report verdict;
  std::string metric = "the file's, field not checked";
  if (!claim && !original) {
    auto adopted = adopt_mesh(std::move(subject));
    if (!adopted) return complain(adopted.failure().at(options.mesh.string()), refused);
    verdict = verify_alone(adopted.value(), asked);
  } else {
    verdict = verify(subject, claim, asked);
    if (claim) {
      metric = check_metric(subject, *claim, verdict);
      check_measured(subject, *claim, verdict);
    }
  }
  limits.conclude();
  line.clear();
  const int status = verdict.verified ? done : not_reached;
  const std::string scope = scope_text(options, asked, claim, verdict, metric);
  if (options.json)
    std::cout << summary_json(verdict, status, scope.substr(2));
  else
    write_verdict(verdict, scope);
  return status;
}

int run_verify(const verify_options& options) {
  run_limits limits(options.max_seconds, std::nullopt);
  medit_read_options how;
  how.all_edges = options.all_edges;
  auto subject = read_medit(options.mesh, how);
  if (!subject) return complain(subject.failure(), refused);
  const auto claim = find_certificate(options);
  if (!claim) return complain(claim.failure(), refused);
  const auto original = find_domain(options, subject.value(), claim.value());
  if (!original) return complain(original.failure(), refused);
  return judge(options, std::move(subject).value(), claim.value(), original.value(), limits);
}

}  // namespace

void add_verify_command(CLI::App& program, command& chosen) {
  auto* const app = program.add_subcommand("verify", "Check a mesh again from its files");
  const auto options = std::make_shared<verify_options>();
  app->add_option("MESH", options->mesh, "What to check")->required();
  app->add_option("--certificate", options->certificate, "What is claimed of it")
      ->type_name("FILE");
  add_real(
      *app, "--angle-bound", angle_bounds, [options](double x) { options->angle_bound = x; },
      "Check this bound (default: the certificate's)")
      ->type_name("DEG");
  app->add_option("--domain", options->domain, "What it should be a mesh of")->type_name("DOMAIN");
  app->add_flag("--regions", options->number_regions,
                "The domain named by --domain was meshed with --regions");
  app->add_flag("--voronoi", options->prove_voronoi,
                "Prove it the dual of the anisotropic Voronoi diagram (done without, too, when "
                "the certificate claims it)");
  add_real(
      *app, "--max-seconds", positive_reals, [options](double x) { options->max_seconds = x; },
      "Checking ends after this time, with status 1 if it was not done")
      ->type_name("S");
  app->add_flag("--json", options->json, "The verdict as a JSON object, in place of lines");
  add_judging_flags(*app, options->all_findings, options->all_edges);
  app->footer(examples);
  app->callback([options, &chosen] { chosen = [options] { return run_verify(*options); }; });
}

}  // namespace asterism::apps
