// SPDX-License-Identifier: MIT
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "asterism/apps/angle_text.hpp"
#include "asterism/apps/commands.hpp"
#include "asterism/apps/option_values.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/domain/built_in_domains.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/domain/point_in_domain.hpp"
#include "asterism/mesh/io/load_domain.hpp"
#include "asterism/mesh/io/medit.hpp"
#include "asterism/mesh/metric/make_metric_field.hpp"
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
};

constexpr const char* examples =
    R"(MESH is a Medit file NAME.mesh, with its metric in NAME.sol. Everything is checked again from the
files, in exact arithmetic. NAME.certificate.json beside the mesh is used when there is one and none
is named. The domain is the certificate's unless --domain names it; random points added to it
need not be named.

Exit status: 0 certified; 1 refused, with witnesses (numbers count from 1); 2 unreadable.

Examples:
  asterism verify swirl.mesh
  asterism verify part.mesh --certificate part.json
  asterism verify other.mesh --angle-bound 15 --domain part.poly)";

constexpr real_range angle_bounds = {
    0, 60, true, false,
    "at least 0 and below 60 degrees, since no triangle has three angles above 60"};

int refuse(const error& failure) {
  std::cerr << "asterism: " << failure.message << '\n';
  return refused;
}

// The certificate that was named, or the one beside the mesh, or none.
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

// Empty when no domain was named. Vertices given to the mesh beyond the domain's own, as random
// points are, belong to it when they lie inside.
result<std::optional<domain>> find_domain(const verify_options& options, const mesh& subject) {
  if (options.domain.empty()) return std::optional<domain>();
  auto loaded = load_domain(options.domain);
  if (!loaded) return loaded.failure();
  if (options.number_regions) loaded.value().number_all_regions = true;
  auto checked = check_domain(loaded.value());
  if (!checked) return checked.failure();
  const domain bare = checked.value();
  for (std::size_t v = bare.vertices.size();
       v < std::min<std::size_t>(subject.given, subject.sites.size()); ++v)
    if (contains(bare, subject.sites[v].position))
      checked.value().vertices.push_back(subject.sites[v].position);
  return std::optional<domain>(std::move(checked).value());
}

// The metric a certificate says was asked for, where it is a formula and was not graded: another is
// not made again from what the certificate holds.
std::unique_ptr<metric_field> field_asked_for(const certificate& claim) {
  const auto option = [&claim](const char* name) {
    const auto found = claim.options.find(name);
    return found == claim.options.end() ? std::string("none") : found->second;
  };
  if (!claim.original || option("gradation") != "none") return nullptr;
  double size = 1;
  const std::string text = option("size");
  if (text != "none") {
    const auto end = std::from_chars(text.data(), text.data() + text.size(), size);
    if (end.ec != std::errc() || end.ptr != text.data() + text.size()) return nullptr;
  }
  auto made = make_metric_field(claim.metric, claim.original->box(), size);
  return made ? std::move(made).value() : nullptr;
}

// What it lists as low in the metric asked for is measured again, where that metric can be had.
void check_relaxed(const mesh& subject, const certificate& claim, verify_report& verdict) {
  const bool is_of_it =
      claim.sites == subject.sites.size() && claim.triangles == subject.triangles.size();
  if (!claim.relaxed || !is_of_it) return;
  const auto asked = field_asked_for(claim);
  if (!asked) {
    std::cout << "note: the metric asked for was graded or read from a file; what the certificate "
                 "lists as low in it is not checked\n";
    return;
  }
  const auto said = contradiction_in_low_triangles(subject, claim, *asked);
  if (!said) return;
  verdict.contradictions.push_back(*said);
  verdict.verified = false;
}

void check_measured(const mesh& subject, const certificate& claim, verify_report& verdict) {
  for (std::string& said : contradictions_in_measured(subject, claim)) {
    verdict.contradictions.push_back(std::move(said));
    verdict.verified = false;
  }
}

void write_verdict(const verify_report& verdict) {
  const audit_report& audit = verdict.audit;
  for (const std::string& contradiction : verdict.contradictions)
    std::cout << "certificate: " << contradiction << '\n';
  for (const audit_finding& finding : audit.findings)
    std::cout << finding_kind_names[static_cast<std::size_t>(finding.kind)] << ": "
              << finding.witness << '\n';
  if (audit.total_found() > audit.findings.size())
    std::cout << audit.total_found() << " findings in all\n";
  std::cout << (verdict.verified ? "certified: " : "REFUSED: ") << audit.sites << " sites, "
            << audit.triangles << " triangles, " << worst_angle_text(audit.worst().degrees);
  if (!audit.exempt_corners.empty())
    std::cout << ", " << audit.exempt_triangles.size() << " exempt at "
              << audit.exempt_corners.size() << " corners";
  if (!audit.domain_checked) std::cout << "; no domain to compare with";
  if (!audit.angles_checked) std::cout << "; no angle bound asked for";
  if (!audit.stars_checked) std::cout << "; stars not checked";
  if (audit.voronoi != voronoi_verdict::not_asked)
    std::cout << "; dual of the Voronoi diagram: "
              << voronoi_verdict_names[static_cast<std::size_t>(audit.voronoi)];
  std::cout << '\n';
}

int run_verify(const verify_options& options) {
  const auto subject = read_medit(options.mesh);
  if (!subject) return refuse(subject.failure());
  const auto claim = find_certificate(options);
  if (!claim) return refuse(claim.failure());
  const auto original = find_domain(options, subject.value());
  if (!original) return refuse(original.failure());

  audit_options asked;
  asked.angle_bound = options.angle_bound;
  asked.check_voronoi = options.prove_voronoi;
  if (original.value()) asked.original = &*original.value();
  verify_report verdict = verify(subject.value(), claim.value(), asked);
  if (claim.value()) {
    check_relaxed(subject.value(), *claim.value(), verdict);
    check_measured(subject.value(), *claim.value(), verdict);
  }
  write_verdict(verdict);
  return verdict.verified ? done : not_reached;
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
  app->footer(examples);
  app->callback([options, &chosen] { chosen = [options] { return run_verify(*options); }; });
}

}  // namespace asterism::apps
