// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/verify.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/audit/auditor.hpp"
#include "asterism/mesh/audit/boundary_distance.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/audit/certificate_options.hpp"
#include "asterism/mesh/audit/same_domain.hpp"
#include "asterism/mesh/audit/split_edges.hpp"
#include "asterism/mesh/audit/theorem_hypotheses.hpp"
#include "asterism/mesh/support/size_ladder.hpp"

namespace asterism {
using namespace internal;
namespace {

std::string text_of(bool yes) { return yes ? "true" : "false"; }
std::string text_of(std::size_t count) { return std::to_string(count); }
std::string text_of(double x) { return internal::number_text(x); }
std::string text_of(const std::vector<vertex_index>& numbers) {
  return "a list of " + std::to_string(numbers.size());
}
std::string text_of(const std::string& text) { return text; }
std::string text_of(voronoi_verdict verdict) {
  return std::string(voronoi_verdict_names[static_cast<std::size_t>(verdict)]);
}

std::string option_of(const certificate& claim, const char* name) {
  const auto place = claim.options.find(name);
  return place == claim.options.end() ? std::string() : place->second;
}

// Collects the claims of a certificate that do not hold, a sentence each.
class contradictions {
 public:
  void compare_count(std::string_view what, std::size_t claimed, std::size_t counted) {
    if (claimed != counted)
      add("the certificate is of a mesh with " + std::to_string(claimed) + " " + std::string(what) +
          ", this one has " + std::to_string(counted));
  }

  // Compares to the last bit, as the same program computes both numbers (NaN equals
  // NaN).
  template <class Value>
  void compare(const std::string& field, const Value& claimed, const Value& found) {
    if (claimed != found)
      add("\"" + field + "\" is " + text_of(claimed) + " in the certificate, and " +
          text_of(found) + (text_of(claimed) == text_of(found) ? " others" : "") + " of this mesh");
  }

  void add(std::string sentence) { all_.push_back(std::move(sentence)); }
  bool none() const { return all_.empty(); }
  std::vector<std::string> take() { return std::move(all_); }

 private:
  std::vector<std::string> all_;
};

// Compares every number to the last bit: the auditor's arithmetic has the same roundings on all
// machines.
void compare_measures(contradictions& all, const theorem_hypotheses& claim,
                      const theorem_hypotheses& found) {
  all.compare("theorem.theorem_applies", claim.applies, found.applies);
  all.compare("theorem.reason", claim.reason, found.reason);
  all.compare("theorem.sigma_eps", claim.sigma_eps, found.sigma_eps);
  all.compare("theorem.proved_angle", claim.proved_angle, found.proved_angle);
  all.compare("theorem.covering_radius", claim.covering_radius, found.covering_radius);
  all.compare("theorem.spacing", claim.spacing, found.spacing);
  all.compare("theorem.longest_subsegment", claim.longest_subsegment, found.longest_subsegment);
  all.compare("theorem.distortion", claim.distortion, found.distortion);
  all.compare("theorem.variation", claim.variation, found.variation);
}

void compare_theorems(contradictions& all, const std::optional<theorem_hypotheses>& claim,
                      const std::optional<theorem_hypotheses>& found) {
  if (!claim || !found) {
    if (claim.has_value() != found.has_value())
      all.add(std::string("\"theorem\" is ") + (claim ? "there" : "null") +
              " in the certificate, and should " + (found ? "be there" : "be null"));
    return;
  }
  if (is_unmeasured(*claim)) {
    // Accepts a certificate whose measurement was ended early, if it has that reason and no
    // numbers.
    theorem_hypotheses nothing;
    nothing.reason = claim->reason;
    compare_measures(all, *claim, nothing);
  } else if (is_unmeasured(*found)) {
    all.add("what the certificate says of the theorem on nets could not be measured again: " +
            found->reason);
  } else {
    compare_measures(all, *claim, *found);
  }
}

// True if the factor is a step of the ladder of sizes, to the last bit.
bool is_step_of_sizes(double factor) { return ladder_factor(ladder_step_below(factor)) == factor; }

// Compares a guarantee with the hypotheses as measured again, which depend on the mesh alone and
// not on the angle bound of this verification. Its size factor must be a step of the ladder of
// sizes, and its product with the covering radius at most guaranteed_covering.
void compare_guarantee(contradictions& all, const certificate& claim,
                       const std::optional<theorem_hypotheses>& found) {
  const bool is_asked = option_of(claim, "guarantee") == "asked";
  if (!claim.metric.empty() && claim.guarantee.has_value() != (is_asked && claim.complete))
    all.add(std::string("\"guarantee\" is ") + (claim.guarantee ? "there" : "missing") +
            ", which does not go with \"asked.options.guarantee\"");
  if (!claim.guarantee) return;
  const guarantee_claim& said = *claim.guarantee;
  if (!found || !found->applies)
    return all.add(
        "the certificate says that a guarantee is kept, and the theorem on nets " +
        (found ? "does not apply: " + found->reason : std::string("was not measured again")));
  const guarantee_claim kept =
      guarantee_of(*found, said.size_factor, said.field_variation, said.field_variation_bound);
  all.compare("guarantee.sigma", said.sigma, kept.sigma);
  all.compare("guarantee.eps", said.eps, kept.eps);
  all.compare("guarantee.times_least", said.times_least.value_or(0), kept.times_least.value_or(0));
  if (!is_step_of_sizes(said.size_factor))
    all.add("\"guarantee.size_factor\" is " + text_of(said.size_factor) +
            ", which is no power of 1.3");
  if (!(kept.eps * said.size_factor <= guaranteed_covering))
    all.add("\"guarantee.size_factor\" is " + text_of(said.size_factor) +
            " in the certificate, and the covering radius is " + text_of(kept.eps) +
            ": their product is not " + text_of(guaranteed_covering) + " at most");
}

// Compares the areas of regions. Areas in the domain are compared if the domain is the claimed one;
// areas before an adaptation could only be compared with the mesh that was adapted.
void compare_regions(contradictions& all, const certificate& claim, const certificate& found,
                     bool as_claimed) {
  std::map<int, std::array<region_area, 2>> regions;
  for (const region_area& r : claim.regions) regions[r.number][0] = r;
  for (const region_area& r : found.regions) regions[r.number][1] = r;
  for (const auto& [number, areas] : regions) {
    const auto& [claimed, measured] = areas;
    const std::string name = "audit.regions, region " + std::to_string(number) + ": ";
    all.compare(name + "area", claimed.mesh, measured.mesh);
    if (as_claimed)
      all.compare(name + "area_of_domain", claimed.domain.value_or(0), measured.domain.value_or(0));
    if (claimed.before && claim.options.count("adapt-mesh") == 0)
      all.add("\"" + name + "area_before\" is of no mesh: none was adapted");
  }
}

// Compares two audits. `audited` must answer the question that the certificate answers: the same
// bound and domain.
void compare_audit(contradictions& all, const certificate& claim, const certificate& found) {
  all.compare("audit.domain_checked", claim.domain_checked, found.domain_checked);
  all.compare("audit.angles_checked", claim.angles_checked, found.angles_checked);
  all.compare("audit.worst_angle", claim.worst_angle, found.worst_angle);
  all.compare("audit.exempt_corners", claim.exempt_corners, found.exempt_corners);
  all.compare("audit.worst_collateral_angle", claim.worst_collateral, found.worst_collateral);
  all.compare("audit.worst_exempt_angle", claim.worst_exempt, found.worst_exempt);
  all.compare("audit.exempt_triangles", claim.exempt_triangles, found.exempt_triangles);
  all.compare("audit.collateral_triangles", claim.collateral_triangles, found.collateral_triangles);
  all.compare("audit.low_triangles", claim.low_triangles, found.low_triangles);
  all.compare("audit.largest_boundary_deviation", claim.largest_deviation, found.largest_deviation);
  all.compare("audit.curves.curves", claim.curves.curves, found.curves.curves);
  all.compare("audit.curves.vertices", claim.curves.vertices, found.curves.vertices);
  all.compare("audit.curves.vertices_off", claim.curves.off_curve, found.curves.off_curve);
  all.compare("audit.curves.largest_distance", claim.curves.largest_distance,
              found.curves.largest_distance);
  if (claim.voronoi != voronoi_verdict::not_asked)
    all.compare("audit.voronoi", claim.voronoi, found.voronoi);
  // Accepts missing measures of stars in the certificate of a mesh that was not finished.
  if (!claim.certified) return;
  const auto stopped = finding_kind_names[static_cast<std::size_t>(finding_kind::stopped)];
  if (found.found.contains(std::string(stopped)))
    return all.add("what the certificate says of stars was not looked at to its end");
  all.compare("audit.certified", claim.certified, found.certified);
  all.compare("audit.stars_checked", claim.stars_checked, found.stars_checked);
  compare_theorems(all, claim.theorem, found.theorem);
  // Compares the lists of findings only if both audits, or neither, judged the Voronoi diagram:
  // findings about it count among the others.
  if (claim.voronoi != found.voronoi) return;
  if (claim.found != found.found)
    all.add("\"audit.findings\" are others in the certificate than those of this mesh");
  if (claim.witnesses != found.witnesses)
    all.add("\"audit.witnesses\" are others in the certificate than those of this mesh");
}

std::optional<double> number_of(const std::string& text) {
  double value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
  return value;
}

// The bound is written twice: as the number that is audited, and among the options.
void compare_bounds(contradictions& all, const certificate& claim) {
  const auto option = claim.options.find("angle-bound");
  if (option == claim.options.end()) return;
  const auto bound = number_of(option->second);
  if (bound && claim.angle_bound == bound) return;
  all.add("\"asked.angle_bound\" is " +
          (claim.angle_bound ? text_of(*claim.angle_bound) : std::string("null")) +
          " in the certificate, and \"asked.options.angle-bound\" is " + option->second);
}

template <class Names>
void compare_names(contradictions& all, const certificate& claim, const Names& names) {
  for (const std::string_view name : names)
    if (claim.options.count(std::string(name)) == 0)
      all.add("\"asked.options." + std::string(name) + "\" is missing");
  for (const auto& [name, value] : claim.options)
    if (std::find(names.begin(), names.end(), name) == names.end())
      all.add("\"asked.options." + name + "\" is nothing that is asked");
}

void erase_rare(certificate& claim) {
  for (const std::string_view name : rare_option_names) claim.options.erase(std::string(name));
}

// Checks that the options about a piece are present together, or all absent.
void compare_mesh_names(contradictions& all, const certificate& claim) {
  certificate without = claim;
  if (claim.options.count("piece") != 0)
    for (const std::string_view name : piece_option_names)
      if (without.options.erase(std::string(name)) == 0)
        all.add("\"asked.options." + std::string(name) + "\" is missing");
  // Accepts certificates without an option for sizes at places: certificates made before that
  // option existed have none.
  without.options.emplace("sizes", "none");
  erase_rare(without);
  compare_names(all, without, mesh_option_names);
}

// Refuses options of a transfer that are missing for one of its components, and options of frozen
// regions of which some are missing.
void compare_adapted_names(contradictions& all, const certificate& claim) {
  certificate without = claim;
  if (claim.options.count("frozen") != 0)
    for (const std::string_view name : frozen_option_names)
      if (without.options.erase(std::string(name)) == 0)
        all.add("\"asked.options." + std::string(name) + "\" is missing");
  const std::size_t unfrozen = without.options.size();
  std::erase_if(without.options, [](const auto& o) { return o.first.starts_with("transfer-"); });
  const std::size_t left = without.options.size();
  erase_rare(without);
  compare_names(all, without, adapt_option_names);
  if (left != unfrozen && claim.options.count("transfer-how") == 0)
    all.add("\"asked.options.transfer-how\" is missing");
}

// True if the name of the metric is that of a file with it at the vertices of a mesh, in upper or
// lower case, with the endings of is_mesh_file and is_metric_file (mesh/io/read_mesh.hpp).
bool is_of_mesh(const std::string& metric) {
  constexpr std::array<std::string_view, 14> endings = {".mesh", ".meshb", ".msh",  ".msh2", ".vtu",
                                                        ".vtk",  ".su2",   ".14",   ".grd",  ".2dm",
                                                        ".stl",  ".sol",   ".solb", ".mtr"};
  std::string lower = metric;
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return std::any_of(endings.begin(), endings.end(),
                     [&lower](std::string_view ending) { return lower.ends_with(ending); });
}

// Compares with the limits for a run without a metric tolerance: on the median distance of the
// delivered metric, and on the ratio of densities.
void compare_with_rule(contradictions& all, const delivered_report& delivered) {
  if (delivered.median > most_median_distance)
    all.add(
        "the certificate says that its mesh was completed, and of half of the sites the metric "
        "delivered is more than " +
        text_of(delivered.median) + " from the one wanted");
  if (density_ratio(delivered) > most_density_ratio)
    all.add("the certificate says that its mesh was completed, and the metric delivered is " +
            text_of(density_ratio(delivered)) + " times as dense or as thin as the one wanted");
}

// True if the delivered size is the one asked for or, with a guarantee, that size divided by the
// guarantee's factor.
bool is_size_delivered(const certificate& claim) {
  if (claim.options.count("size-delivered") == 0) return true;
  const std::string asked = option_of(claim, "size"), done = option_of(claim, "size-delivered");
  if (!claim.guarantee) return asked == done;
  const auto size = number_of(asked), delivered = number_of(done);
  return size && delivered &&
         std::abs(*delivered * claim.guarantee->size_factor - *size) <= 0x1p-40 * *size;
}

// Checks against the numbers of the certificate whether a mesh that it calls complete was
// completed. A metric farther from the wanted one than tolerated, or longer edges than wanted, do
// not refuse a mesh, but the run was then not complete. The numbers themselves are measured again
// elsewhere.
void compare_completeness(contradictions& all, const certificate& claim) {
  const std::string tolerance = option_of(claim, "metric-tolerance");
  const bool is_limited = !tolerance.empty() && tolerance != "none";
  const double tolerated = is_limited ? number_of(tolerance).value_or(-1) : 0;
  if (!(tolerated >= 0))
    return all.add("\"asked.options.metric-tolerance\" is no number of at least 0");
  if (!claim.complete) return;
  if (!is_size_delivered(claim))
    all.add(
        "the certificate says that its mesh was completed, and \"asked.options.size\" is not "
        "\"asked.options.size-delivered\"");
  if (!claim.delivered) return;
  if (!is_limited) return compare_with_rule(all, *claim.delivered);
  if (!(claim.delivered->greatest <= tolerated))
    all.add("the certificate says that its mesh was completed, and the metric delivered is " +
            text_of(claim.delivered->greatest) + " from the one wanted, where " + tolerance +
            " is tolerated");
}

// Accepts certificates of library callers, who need not state the question in words: then there is
// no metric, and no option except the metric tolerance, which decides whether the run was complete.
void compare_unworded(contradictions& all, const certificate& claim) {
  for (const auto& [name, value] : claim.options)
    if (name != "metric-tolerance")
      all.add("\"asked.options." + name + "\" is there, and \"asked.metric\" names no metric");
}

// Checks the options of `certify`. A metric that came from a file has no size.
void compare_certify_options(contradictions& all, const certificate& claim) {
  compare_names(all, claim, certify_option_names);
  if (claim.metric.starts_with("of ") != (option_of(claim, "size") == "none"))
    all.add("\"asked.options.size\" does not go with \"asked.metric\"");
}

void compare_options(contradictions& all, const certificate& claim) {
  compare_bounds(all, claim);
  compare_completeness(all, claim);
  if (claim.metric.empty()) return compare_unworded(all, claim);
  if (claim.options.count("adapt-mesh") != 0) return compare_adapted_names(all, claim);
  if (claim.options.count("mesh") != 0) return compare_certify_options(all, claim);
  compare_mesh_names(all, claim);
  const auto option = [&claim](const char* name) { return option_of(claim, name); };
  if ((option("gradation") == "none") != (option("gradation-done") == "none"))
    all.add(
        "\"asked.options.gradation\" and \"asked.options.gradation-done\" contradict each other");
  const bool is_scaled = option("vertices") != "none" || option("complexity") != "none";
  if (is_scaled == (option("complexity-delivered") == "none"))
    all.add(
        "\"asked.options.complexity-delivered\" does not go with \"asked.options.vertices\" and "
        "\"asked.options.complexity\"");
  if ((option("metric-fingerprint") == "none") == is_of_mesh(claim.metric))
    all.add("\"asked.options.metric-fingerprint\" does not go with \"asked.metric\"");
  const bool is_verdict = option("certify") == "voronoi" || option("certify") == "stars";
  if (!is_verdict ||
      (option("certify") == "voronoi") != (claim.voronoi != voronoi_verdict::not_asked))
    all.add("\"asked.options.certify\" and \"audit.voronoi\" contradict each other");
}

// Measures again how far the mesh's boundary is from the former one. The former boundary is a part
// of the question, as the domain is; the distance is the answer.
void compare_former(contradictions& all, const mesh& subject, const certificate& claim) {
  if (!claim.former) {
    const auto asked = claim.options.find("hausd");
    if (asked != claim.options.end() && asked->second != "none")
      all.add("\"asked.options.hausd\" is " + asked->second +
              ", and there is no \"former_boundary\"");
    return;
  }
  if (!claim.original) return all.add("\"former_boundary\" is there, and no \"domain\"");
  const former_boundary_report found =
      measure_former_boundary(subject, *claim.original, *claim.former);
  all.compare("audit.former_boundary.vertices_gone", claim.former_distance.vertices_gone,
              found.vertices_gone);
  all.compare("audit.former_boundary.largest_distance", claim.former_distance.largest_distance,
              found.largest_distance);
  const std::optional<double>& allowed = claim.former->allowed;
  const auto said = [&](const char* name, const std::string& text) {
    const auto option = claim.options.find(name);
    if (option != claim.options.end() && option->second != text)
      all.add("\"asked.options." + std::string(name) + "\" is " + option->second +
              " in the certificate, and its \"former_boundary\" says " + text);
  };
  said("hausd", allowed ? text_of(*allowed) : "none");
  said("boundary-distance", text_of(claim.former_distance.largest_distance));
  if (allowed && !(found.largest_distance <= *allowed))
    all.add("the boundary is up to " + text_of(found.largest_distance) +
            " away from the former one, and " + text_of(*allowed) + " was asked for");
}

// Matches the pairs of periodic sides again, and compares the outcome with the certificate's.
void compare_periodic(contradictions& all, const mesh& subject, const certificate& claim,
                      verify_report& report) {
  for (const periodic_pair& sides : claim.periodic_asked) {
    const auto found = match_periodic(subject, sides);
    if (!found) {
      all.add(found.failure().message);
      continue;
    }
    report.periodic.push_back(found.value());
  }
  if (all.none() && report.periodic != claim.periodic)
    all.add(
        "\"audit.periodic\" says in the certificate how other sides match than those of this mesh");
}

// Searches again for inner edges that join two vertices of the boundary, where there were to be
// none.
void compare_split_edges(contradictions& all, const mesh& subject, const certificate& claim,
                         int first_number) {
  const auto asked = claim.options.find("split-across");
  if (asked == claim.options.end()) return;
  if (asked->second != "no")
    return all.add("\"asked.options.split-across\" is " + asked->second + ", and not no");
  if (!claim.complete) return;
  const auto found = internal::edges_across(subject);
  if (found.empty()) return;
  const auto first = static_cast<vertex_index>(first_number);
  all.add("the certificate says that its mesh was completed, and the inner edge of the vertices " +
          std::to_string(found[0][0] + first) + " and " + std::to_string(found[0][1] + first) +
          " joins two vertices of the boundary, where \"asked.options.split-across\" is no");
}

// Returns the contradictions. `as_claimed`: the audit answered the question that the certificate
// answers.
std::vector<std::string> contradictions_of(const certificate& claim, const certificate& found,
                                           const audit_report& audited, bool as_claimed) {
  contradictions all;
  all.compare_count("vertices", claim.sites, audited.sites);
  all.compare_count("given vertices", claim.given, audited.given);
  all.compare_count("triangles", claim.triangles, audited.triangles);
  all.compare_count("boundary edges", claim.boundary_subsegments, audited.boundary_subsegments);
  if (all.none() && claim.fingerprint != found.fingerprint)
    all.add("the certificate is of another mesh: the fingerprints differ");
  // Compares further numbers only if nothing differs so far: numbers of another mesh cannot be
  // compared.
  if (all.none()) {
    compare_regions(all, claim, found, as_claimed);
    if (as_claimed) compare_audit(all, claim, found);
  }
  compare_options(all, claim);
  if (!claim.certified) all.add("the certificate itself says that its mesh was not certified");
  if (!claim.complete)
    all.add("the certificate itself says that its mesh was not completed: " + claim.reason);
  return all.take();
}

// Returns the hypotheses of the theorem for the certificate's angle bound: measured anew where the
// present bound is another one and the mesh is certified.
std::optional<theorem_hypotheses> theorem_at_bound(const mesh& subject, const certificate& claim,
                                                   const audit_options& options,
                                                   const certificate& found) {
  if (!claim.guarantee || !claim.angle_bound || !found.theorem ||
      options.angle_bound == claim.angle_bound)
    return found.theorem;
  return measure_theorem_hypotheses(subject, *claim.angle_bound, options.stop);
}

// Returns the certificate of the audit. Its witnesses are compared with those of a claim to be
// certified, which count from 1: audits again where both lists have witnesses, and the audit's
// count from another number. An empty list differs from any other whatever they count from.
certificate certificate_of(const auditor& judge, const mesh& subject,
                           const std::optional<certificate>& claim, audit_options options) {
  certificate found = judge.make_certificate(options.stop);
  const bool are_compared =
      claim && claim->certified && !claim->witnesses.empty() && !found.witnesses.empty();
  if (!are_compared || options.first_number == 1) return found;
  options.first_number = 1;
  auditor again(subject, options);
  again.run();
  return again.make_certificate(options.stop);
}

}  // namespace

verify_report verify(const mesh& subject, const std::optional<certificate>& claim,
                     audit_options options) {
  bool as_claimed = false;
  const bool must_be_dual =
      options.check_voronoi || (claim && claim->voronoi == voronoi_verdict::proved);
  if (claim) {
    const bool is_claimed_domain =
        options.original == nullptr ||
        (claim->original && is_same_domain(*options.original, *claim->original));
    as_claimed = (!options.angle_bound || options.angle_bound == claim->angle_bound) &&
                 is_claimed_domain && options.exempt_corners.empty();
    if (!options.angle_bound) options.angle_bound = claim->angle_bound;
    if (options.original == nullptr && claim->original) options.original = &*claim->original;
    if (claim->voronoi != voronoi_verdict::not_asked) options.check_voronoi = true;
  }
  if (options.original == nullptr) options.domain_is_the_mesh = true;
  options.find_exempt_corners = true;
  options.own_filter_alone = true;
  verify_report report;
  internal::auditor judge(subject, options);
  report.audit = judge.run();
  const certificate found = certificate_of(judge, subject, claim, options);
  report.theorem = found.theorem;
  report.regions = found.regions;
  if (claim) {
    report.contradictions = contradictions_of(*claim, found, report.audit, as_claimed);
    contradictions of_mesh;
    compare_former(of_mesh, subject, *claim);
    compare_periodic(of_mesh, subject, *claim, report);
    compare_split_edges(of_mesh, subject, *claim, options.first_number);
    compare_guarantee(of_mesh, *claim, theorem_at_bound(subject, *claim, options, found));
    for (std::string& sentence : of_mesh.take())
      report.contradictions.push_back(std::move(sentence));
  }
  report.verified = report.audit.certified && report.audit.angles_checked &&
                    report.contradictions.empty() &&
                    (!must_be_dual || report.audit.voronoi == voronoi_verdict::proved);
  return report;
}

}  // namespace asterism
