// SPDX-License-Identifier: MIT
#include "asterism/apps/surface_summary.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "asterism/core/elementary.hpp"

namespace asterism::apps {
using namespace internal;
namespace {

double degrees_of(double tangent) { return elementary::atan2(tangent, 1) * 180 / std::numbers::pi; }

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
  text += fmt::format("; every edge once each way but {} open ones, Euler number {}", r.open_edges,
                      r.euler);
  text += fmt::format(
      "; least angle {:.4g} degrees in the planes, bound {:.4g}, and {:.4g} in space, "
      "which is not certified",
      r.least_angle, asked.angle_bound, r.least_angle_in_space);
  return text;
}

std::string json_of(const shell_report& r, const shell_question& asked, bool complete,
                    const std::string& reason, int status) {
  nlohmann::ordered_json o = {{"status", status},
                              {"certified", r.certified},
                              {"complete", complete},
                              {"reason", reason},
                              {"chord", asked.chord},
                              {"angle_bound", asked.angle_bound},
                              {"vertices", r.vertices},
                              {"triangles", r.triangles},
                              {"edges", r.edges},
                              {"open_edges", r.open_edges},
                              {"collapsed", r.collapsed},
                              {"euler", r.euler},
                              {"distance", r.distance},
                              {"vertex_distance", r.vertex_distance},
                              {"normal_tangent", r.normal_tangent},
                              {"least_angle", r.least_angle},
                              {"least_angle_in_space", r.least_angle_in_space},
                              {"findings", r.findings}};
  return o.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace asterism::apps
