// SPDX-License-Identifier: MIT
#include "asterism/apps/text/adaptation_json.hpp"

#include <nlohmann/json.hpp>

#include "asterism/apps/text/json_summary.hpp"

namespace asterism::apps {
namespace {

using json = nlohmann::ordered_json;

std::string adaptation_text(const json& object) {
  return object.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

json names_of(const written_paths& files) {
  json names = json::array();
  for (const std::filesystem::path& file : files) names.push_back(file.string());
  return names;
}

json of_metric(const solution_metric_report& r) {
  return {{"reached", r.reached},
          {"reason", r.reason},
          {"steps", r.steps},
          {"fields", r.fields},
          {"flat_fields", r.flat_fields},
          {"complexity_asked", r.complexity_asked > 0 ? json(r.complexity_asked) : json()},
          {"complexity_before_gradation", r.complexity_before_gradation},
          {"complexity_delivered", r.complexity_delivered},
          {"factor", r.factor},
          {"error_predicted", r.error_predicted > 0 ? json(r.error_predicted) : json()},
          {"share_noise", r.share_noise},
          {"share_floored", r.share_floored},
          {"complexity_flat", r.complexity_at_least_density},
          {"complexity_at_longest", r.complexity_along_ridges},
          {"share_intersected", r.share_intersected},
          {"share_step", r.share_step},
          {"share_hmin", r.share_least_size},
          {"share_hmax", r.share_greatest_size},
          {"share_aspect", r.share_aspect},
          {"share_graded", r.share_graded},
          {"gradation_ended", r.gradation_ended}};
}

json of_transfer(const transfer_report& r) {
  json fields = json::array();
  for (const transferred_component& c : r.components)
    fields.push_back({{"name", c.name},
                      {"integral_before", c.integral_before},
                      {"integral_after", c.integral_after},
                      {"least_before", c.least_before},
                      {"greatest_before", c.greatest_before},
                      {"least_after", c.least_after},
                      {"greatest_after", c.greatest_after}});
  return {{"area_before", r.area_before},
          {"area_after", r.area_after},
          {"area_common", r.pieces > 0 ? json(r.area_common) : json()},
          {"outside", r.outside},
          {"greatest_distance", r.greatest_distance},
          {"partly_covered", r.partly_covered},
          {"fields", fields}};
}

}  // namespace

std::string metric_json(const solution_metric_report& report, int status,
                        const written_paths& files, const std::vector<double>& windows) {
  json object = {{"command", "metric"}, {"status", status}};
  object.update(of_metric(report));
  if (!windows.empty()) object["windows"] = windows;
  object["files"] = names_of(files);
  return adaptation_text(object);
}

std::string transfer_json(const transfer_report& report, int status, const written_paths& files) {
  json object = {{"command", "transfer"}, {"status", status}};
  object.update(of_transfer(report));
  object["files"] = names_of(files);
  return adaptation_text(object);
}

std::string adapt_json(const adapt_facts& facts, int status, const written_paths& files) {
  json object = json::parse(summary_json(facts.next.made, status, files, ""));
  object["command"] = "adapt";
  object["vertices_wanted"] = facts.vertices_wanted ? json(*facts.vertices_wanted) : json();
  object["kept"] = facts.next.kept;
  object["boundary_vertices_before"] = facts.next.boundary_vertices;
  object["boundary_vertices_kept"] = facts.next.boundary_kept;
  object["boundary_distance"] = facts.next.boundary_distance;
  object["solution_metric"] = of_metric(facts.metric);
  object["transfer"] = facts.values == nullptr ? json() : of_transfer(*facts.values);
  return adaptation_text(object);
}

}  // namespace asterism::apps
