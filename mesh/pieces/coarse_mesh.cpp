// SPDX-License-Identifier: MIT
#include "asterism/mesh/pieces/coarse_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/core/number_text.hpp"
#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/delivery/metric_complexity.hpp"
#include "asterism/mesh/pipeline/make_mesh.hpp"
#include "asterism/mesh/refine/coarser_mesh.hpp"

namespace asterism::internal {
namespace {

// Number of triangles of the coarse mesh for each piece; least number of wanted triangles that one
// of its triangles stands for; least number of wanted triangles in a piece. Edges of the cut are
// then about four edges of the mesh long, or longer (docs/results/pieces.md).
constexpr double coarse_for_piece = 100, least_in_coarse = 16, fewest_for_piece = 6;
// Number of triangles in a unit of metric area, as measured in meshes; equilateral triangles with
// edges of length 1 are 2.31.
constexpr double triangles_for_area = 2.4;

result<int> halvings_for(double triangles, const cut_wishes& wishes) {
  const auto pieces = static_cast<double>(wishes.pieces);
  if (!(triangles >= fewest_for_piece * pieces))
    return error{"--pieces " + std::to_string(wishes.pieces) + ": the size wants about " +
                     format_number(std::round(triangles)) + " triangles, less than " +
                     format_number(fewest_for_piece) + " a piece",
                 error_code::bad_option};
  const double wanted = std::clamp(triangles / (coarse_for_piece * pieces), least_in_coarse,
                                   std::max(least_in_coarse, triangles));
  const double most = triangles / (fewest_for_piece * pieces);
  return static_cast<int>(std::max(0.0, std::floor(elementary::log2(std::min(wanted, most)))));
}

}  // namespace

result<mesh> make_coarse_mesh(const domain& d, const metric_field& field,
                              const cut_wishes& wishes) {
  const auto area = complexity_over(d, field, wishes.stop);
  if (!area) return area.failure();
  const auto halvings = halvings_for(triangles_for_area * area.value(), wishes);
  if (!halvings) return halvings.failure();
  const coarser_field coarser(field, halvings.value());
  mesh_options options;
  options.angle_bound = wishes.angle_bound;
  options.limit_size = true;
  options.max_sites = 100'000'000;
  options.stop = wishes.stop;
  auto made = make_mesh(d, coarser, options);
  if (!made) return made.failure();
  if (const auto why = wishes.stop.told()) return error{"cutting was stopped: " + *why};
  audit_options asked;
  asked.original = &d;
  asked.check_stars = false;
  const audit_report report = audit(made.value().result, asked);
  if (!report.certified)
    return error{"the domain could not be cut: the coarse mesh is no triangulation of it" +
                 (report.findings.empty() ? "" : ": " + report.findings.front().witness)};
  return std::move(made.value().result);
}

}  // namespace asterism::internal
