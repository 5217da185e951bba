// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface_audit/deviation.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "asterism/mesh/surface_audit/deviation_scene.hpp"
#include "asterism/mesh/surface_audit/mesh_to_surface.hpp"
#include "asterism/mesh/surface_audit/number_ranges.hpp"
#include "asterism/mesh/surface_audit/surface_to_mesh.hpp"

namespace asterism::internal {
namespace {

std::optional<error> fault_of(const space_mesh& mesh) {
  if (mesh.triangles.empty()) return error{"the mesh has no triangle", error_code::invalid_mesh};
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    for (const double x : {mesh.points[v].x, mesh.points[v].y, mesh.points[v].z})
      if (!std::isfinite(x) || std::abs(x) > greatest_modulus)
        return error{fmt::format("vertex {}: coordinate {:g} is out of range", v + 1, x),
                     error_code::invalid_mesh};
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const std::uint32_t v : mesh.triangles[t])
      if (v >= mesh.points.size())
        return error{fmt::format("triangle {}: vertex {} does not exist; there are {}", t + 1,
                                 std::uint64_t{v} + 1, mesh.points.size()),
                     error_code::invalid_mesh};
  return {};
}

double size_of(const std::vector<space_box>& boxes, const surface& s) {
  space_box all = boxes[0];
  for (const space_box& box : boxes) all.include(box);
  for (const surface_patch& p : s.patches)
    for (const control_point& c : p.control) all.include(c.at);
  return all.diagonal();
}

}  // namespace

result<deviation_report> deviation(const space_mesh& mesh, const surface& s,
                                   const deviation_options& options) {
  if (auto wrong = fault_of(mesh)) return *wrong;
  const auto pieces = bezier_pieces(s);
  if (!pieces) return pieces.failure();
  for (std::size_t p = 0; p < s.patches.size(); ++p)
    if (!s.patches[p].loops.empty())
      return error{fmt::format("patch {} is trimmed, which deviation does not treat: `asterism "
                               "surface` meshes it and proves distances, `asterism verify` again",
                               p + 1),
                   error_code::invalid_input};
  const std::vector<space_box> boxes = boxes_of_triangles(mesh);
  const box_tree triangles(boxes);
  const surface_locator locator(pieces.value());
  const deviation_scene scene{mesh, s, pieces.value(), triangles, locator};
  narrowing_limits limits;
  limits.relative_width = options.relative_width;
  limits.negligible = negligible_share * size_of(boxes, s);
  limits.at_most = options.at_most;
  limits.most_cells = options.cells_of_a_triangle * mesh.triangles.size() + options.cells_beside;
  deviation_report report;
  report.from_mesh = from_mesh(scene, limits);
  report.from_surface = from_surface(scene, limits);
  return report;
}

}  // namespace asterism::internal
