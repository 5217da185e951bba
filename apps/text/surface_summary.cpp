// SPDX-License-Identifier: MIT
#include "asterism/apps/text/surface_summary.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/surface_audit/shell_numbers.hpp"

namespace asterism::apps {
using namespace internal;
namespace {

double degrees_of(double tangent) { return elementary::atan2(tangent, 1) * 180 / std::numbers::pi; }

std::string text_of_trims(const shell_report& r) {
  std::string text = fmt::format(
      "trimmed as the chords of {} curves say, which are within {:.2g} of the curves in space",
      r.trims, r.trim_distance);
  if (r.trim_edges > 0)
    text += fmt::format("; the faces' own gap along their {} common edges is at most {:.2g}",
                        r.trim_edges, r.trim_gap);
  return text;
}

}  // namespace

std::string text_of(const shell_report& r, const shell_question& asked) {
  std::string text = fmt::format("{} vertices, {} triangles", r.vertices, r.triangles);
  if (r.triangles == 0) return text;
  text += fmt::format(
      "; every point of the surface is within {:.6g} of the mesh and of the mesh within {:.6g} of "
      "the "
      "surface, {:.6g} asked for",
      r.distance, r.distance, asked.chord);
  text += r.folded == 0 && std::isfinite(r.normal_tangent)
              ? fmt::format("; nowhere folded, normals turn by at most {:.4g} degrees",
                            degrees_of(r.normal_tangent))
              : fmt::format("; {} triangles not proved unfolded", r.folded);
  text += fmt::format("; vertices within {:.2g} of the surface", r.vertex_distance);
  if (r.trims > 0) text += "; " + text_of_trims(r);
  text += fmt::format("; every edge once each way but {} open ones, Euler number {}", r.open_edges,
                      r.euler);
  if (asked.no_crossings && r.certified) text += "; no two triangles cross";
  text += fmt::format(
      "; least angle {:.4g} degrees in the planes, bound {:.4g}, and {:.4g} in space, "
      "which is not certified",
      r.least_angle, asked.angle_bound, r.least_angle_in_space);
  return text;
}

std::vector<std::pair<std::string, std::string>> table_of(const shell_report& r,
                                                          const shell_question& asked) {
  const auto number = [](double x) { return fmt::format("{:.6g}", x); };
  const bool unfolded = r.folded == 0 && std::isfinite(r.normal_tangent);
  std::vector<std::pair<std::string, std::string>> table = {
      {"distance asked", number(asked.chord)},
      {"distance proved, both ways", number(r.distance)},
      {"vertices", fmt::format("{}", r.vertices)},
      {"triangles", fmt::format("{}", r.triangles)},
      {"folded", unfolded ? "nowhere" : fmt::format("{} triangles not proved", r.folded)},
      {"normals turn by at most",
       unfolded ? number(degrees_of(r.normal_tangent)) + " degrees" : "unknown"},
      {"vertices off the surface by", number(r.vertex_distance)},
      {"edges", fmt::format("{}", r.edges)},
      {"open edges", fmt::format("{}", r.open_edges)},
      {"Euler number", fmt::format("{}", r.euler)},
      {"no two triangles cross", !asked.no_crossings ? "not asked"
                                 : r.certified       ? "proved"
                                                     : "see the findings"},
      {"least angle in the planes", number(r.least_angle) + " degrees"},
      {"least angle in space, not certified", number(r.least_angle_in_space) + " degrees"}};
  if (r.trims > 0)
    table.insert(table.begin() + 2, {{"trimming curves, their chords within",
                                      fmt::format("{}, {}", r.trims, number(r.trim_distance))},
                                     {"common edges of faces, their own gap at most",
                                      fmt::format("{}, {}", r.trim_edges, number(r.trim_gap))}});
  return table;
}

std::string json_of(const shell_report& r, const shell_question& asked, bool complete,
                    const std::string& reason, int status) {
  nlohmann::ordered_json o = {{"status", status},
                              {"certified", r.certified},
                              {"complete", complete},
                              {"reason", reason},
                              {"chord", asked.chord},
                              {"angle_bound", asked.angle_bound},
                              {"no_crossings", asked.no_crossings}};
  const auto add = [&](const char* key, const char* /*in words*/, auto member) {
    o[key] = r.*member;
  };
  visit_numbers(add);
  o["least_angle_in_space"] = r.least_angle_in_space;
  o["findings"] = r.findings;
  if (r.trims > 0) visit_trim_numbers(add);
  return o.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace asterism::apps
