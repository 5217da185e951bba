// SPDX-License-Identifier: MIT
#include "asterism/apps/text/json_summary.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "asterism/mesh/io/certificate_json.hpp"
#include "asterism/mesh/io/certificate_writer.hpp"
namespace asterism::apps {
namespace {

using json = nlohmann::ordered_json;

std::string text_of(const json& object) {
  return object.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

// Returns an angle in degrees; null where no angle is of the kind.
json angle(const audited_angle& least) {
  return least.degrees < 180 ? json(least.degrees) : json();
}

json number(double x) { return std::isfinite(x) ? json(x) : json(); }

// Returns the areas of regions; null for an area that does not exist. The area before is that in
// the mesh that was adapted, else that in the domain.
json regions_of(const std::vector<region_area>& regions) {
  json all = json::array();
  for (const region_area& r : regions) {
    const std::optional<double> before = r.before ? r.before : r.domain;
    all.push_back({{"region", r.number},
                   {"area_before", before ? number(*before) : json()},
                   {"area_of_domain", r.domain ? number(*r.domain) : json()},
                   {"area_after", number(r.mesh)}});
  }
  return all;
}

// Adds the findings of an audit, in the same form for all commands.
void add_audit(json& object, const audit_report& audit, const std::vector<region_area>& regions) {
  object["vertices"] = audit.sites;
  object["triangles"] = audit.triangles;
  object["worst_angle"] = angle(audit.worst_ordinary);
  object["worst_collateral_angle"] = angle(audit.worst_collateral);
  object["worst_exempt_angle"] = angle(audit.worst_exempt);
  object["exempt_corners"] = audit.exempt_corners.size();
  object["exempt_triangles"] = audit.exempt_triangles.size();
  object["low_triangles"] = audit.low_triangles.size();
  object["largest_boundary_deviation"] = audit.largest_deviation;
  if (audit.curves.curves > 0) object["distance_from_curves"] = audit.curves.largest_distance;
  if (!regions.empty()) object["regions"] = regions_of(regions);
  object["voronoi"] = voronoi_verdict_names[static_cast<std::size_t>(audit.voronoi)];
  json findings = json::object();
  for (std::size_t kind = 0; kind < finding_kind_count; ++kind)
    if (audit.found[kind] > 0) findings[std::string(finding_kind_names[kind])] = audit.found[kind];
  object["findings"] = findings;
  json witnesses = json::array();
  for (const audit_finding& f : audit.findings) witnesses.push_back(f.witness);
  object["witnesses"] = witnesses;
}

// Adds how periodic sides match, if the question includes that.
void add_periodic(json& object, const std::vector<periodic_match>& matches) {
  if (!matches.empty()) object["periodic"] = internal::json_of(matches);
}

void add_second_order(json& object, const std::optional<second_order_report>& r) {
  if (!r) return;
  object["second_order"] = {
      {"triangles", r->triangles},          {"curved_sides", r->curved_sides},
      {"on_curves", r->on_curves},          {"kept_straight", r->kept_straight},
      {"folded", r->folded.size()},         {"undecided", r->undecided.size()},
      {"least_jacobian", r->least_jacobian}};
}

// Adds whether the theorem on nets applies to the mesh, and the measures of its hypotheses; null if
// the question does not include that.
void add_theorem(json& object, const std::optional<theorem_hypotheses>& measured) {
  object["theorem"] = json();
  if (!measured) return;
  object["theorem"] = {{"applies", measured->applies},
                       {"reason", measured->reason},
                       {"sigma_eps", number(measured->sigma_eps)},
                       {"covering_radius", number(measured->covering_radius)},
                       {"proved_angle", number(measured->proved_angle)}};
}

}  // namespace

std::string summary_json(const certified_mesh& made, int status,
                         const std::vector<std::filesystem::path>& files, const std::string& next) {
  const mesh_outcome& outcome = made.outcome;
  json object = {{"command", "mesh"},
                 {"status", status},
                 {"certified", made.report.certified},
                 {"complete", outcome.complete},
                 {"reason", made.claim.reason}};
  add_audit(object, made.report, made.claim.regions);
  add_periodic(object, made.claim.periodic);
  add_theorem(object, made.claim.theorem);
  add_second_order(object, made.claim.second_order);
  if (made.claim.guarantee)
    object["guarantee"] = {
        {"size_factor", made.claim.guarantee->size_factor},
        {"field", made.claim.guarantee->field_variation_bound ? "bounded" : "sampled"},
        {"sigma", number(made.claim.guarantee->sigma)},
        {"eps", number(made.claim.guarantee->eps)}};
  object["disagreeing"] = outcome.disagreeing;
  object["too_large"] = outcome.too_large;
  object["length_factor"] = outcome.ended.length_factor;
  object["metric"] = outcome.delivered ? "delivered" : "as asked";
  const auto unit_edges = made.claim.measured.find("unit_edges");
  object["unit_edges"] =
      unit_edges == made.claim.measured.end() ? json() : json(unit_edges->second);
  json written = json::array();
  for (const std::filesystem::path& file : files) written.push_back(file.string());
  object["files"] = written;
  object["next"] = next.empty() ? json() : json(next);
  return text_of(object);
}

namespace {

json word(const std::string& text) { return text.empty() ? json() : json(text); }

// Returns each part of the question, with its source: an option or the certificate.
json question_of(const judgement& judged) {
  const asked_domain& shape = judged.shape;
  const metric_answer& metric = judged.metric;
  const bool is_repaired = shape.repaired_by != asked_by::nobody;
  const bool has_bound = judged.bound_by != asked_by::nobody;
  return {{"angle_bound", has_bound ? json(judged.bound) : json()},
          {"angle_bound_by", word(name_of(judged.bound_by))},
          {"domain", word(shape.name)},
          {"domain_by", word(name_of(shape.by))},
          {"repair_distance", is_repaired ? json(shape.distance) : json()},
          {"repair_distance_by", word(name_of(shape.repaired_by))},
          {"greatest_move", is_repaired ? json(shape.greatest_move) : json()},
          {"metric", word(metric.name)},
          {"metric_by", word(name_of(metric.by))},
          {"metric_tolerance", metric.tolerance ? json(*metric.tolerance) : json()},
          {"metric_tolerance_by", word(name_of(metric.tolerance_by))}};
}

// Returns the distance of the mesh's metric from the one asked for; null where both are equal, or
// it is unknown.
json distance_of(const metric_answer& metric) {
  if (!metric.apart) return json();
  const delivered_report& apart = *metric.apart;
  return {{"vertices_changed", apart.changed},
          {"beyond_tenth", apart.beyond_tenth},
          {"median", apart.median},
          {"ninetieth", apart.ninetieth},
          {"greatest", apart.greatest},
          {"worst_angle_as_wanted",
           apart.worst_angle_wanted < 180 ? json(apart.worst_angle_wanted) : json()},
          {"low_triangles_as_wanted", apart.low_wanted.size()}};
}

}  // namespace

std::string summary_json(const judgement& judged, int status, const std::string& scope) {
  const verify_report& verdict = judged.verdict;
  std::vector<std::string> refusals = judged.metric.refusals;
  refusals.insert(refusals.end(), judged.side_refusals.begin(), judged.side_refusals.end());
  json object = {{"command", "verify"},
                 {"status", status},
                 {"verified", verdict.verified},
                 {"scope", scope},
                 {"question", question_of(judged)},
                 {"metric_checked", judged.metric.made},
                 {"metric_delivered", distance_of(judged.metric)},
                 {"contradictions", verdict.contradictions},
                 {"refusals", refusals}};
  add_audit(object, verdict.audit, verdict.regions);
  add_periodic(object, verdict.periodic);
  add_theorem(object, verdict.theorem);
  add_second_order(object, judged.second_order);
  return text_of(object);
}

std::string summary_json(const certify_report& report, int status, double angle_bound,
                         const std::optional<second_order_report>& second_order) {
  json object = {{"command", "certify"},
                 {"status", status},
                 {"certified", report.certified()},
                 {"angle_bound", angle_bound}};
  add_audit(object, report.audit, report.regions);
  add_theorem(object, report.theorem);
  add_second_order(object, second_order);
  object["compared"] = report.compared;
  object["in_stars_of_all"] = report.compared ? json(report.in_stars[3]) : json();
  object["inverted"] = report.inverted;
  object["below_bound"] = report.below_bound;
  object["edges"] = report.edges;
  object["unit_edges"] = report.unit_edges;
  return text_of(object);
}

}  // namespace asterism::apps
