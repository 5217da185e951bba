// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface_audit/shell_audit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/core/floating_point_environment.hpp"
#include "asterism/mesh/surface_audit/lifted_distance.hpp"
#include "asterism/mesh/surface_audit/lifted_normals.hpp"
#include "asterism/mesh/surface_audit/mesh_to_surface.hpp"
#include "asterism/mesh/surface_audit/number_ranges.hpp"
#include "asterism/mesh/surface_audit/plane_faces.hpp"
#include "asterism/mesh/surface_audit/shell_crossings.hpp"
#include "asterism/mesh/surface_audit/shell_edges.hpp"
#include "asterism/mesh/surface_audit/shell_findings.hpp"
#include "asterism/mesh/surface_audit/shell_trims.hpp"
#include "asterism/mesh/surface_audit/surface_folds.hpp"

namespace asterism::internal {
namespace {

constexpr int deepest = 9;          // quarterings of a triangle
constexpr double finite = 0x1p500;  // its square is below infinity
// Part of the chord distance asked for, below which bounds of trimmed patches are not narrowed
// further: places inside of trims are moved inward, so that no bound falls below about that. Bounds
// are valid for any value.
constexpr double negligible_at_trims = 1e-6;

error no_triangle() {
  return {
      "no triangle has three corners in space: a patch is a curve, or is folded onto itself "
      "along sides that are one curve",
      error_code::invalid_mesh};
}

std::optional<error> fault_of_face(const surface& s, const surface_shell& shell, std::size_t f) {
  const shell_face& face = shell.faces[f];
  const auto fault = [&](const std::string& what) {
    return error{fmt::format("face {}: {}", f + 1, what), error_code::invalid_mesh};
  };
  if (face.patch >= s.patches.size()) return fault("its patch does not exist");
  if (std::abs(face.scale_u) > 1000 || std::abs(face.scale_v) > 1000)
    return fault("the scale of its chart is out of range");
  if (face.vertex.size() != face.plane.sites.size())
    return fault("sites and vertices differ in number");
  for (const std::uint32_t v : face.vertex)
    if (v >= shell.points.size()) return fault("a vertex does not exist");
  for (const site& p : face.plane.sites)
    if (!std::isfinite(p.position.x) || !std::isfinite(p.position.y))
      return fault("a site is not finite");
  for (const triangle& t : face.plane.triangles)
    for (const vertex_index v : t)
      if (v >= face.plane.sites.size()) return fault("a site does not exist");
  return {};
}

std::optional<error> fault_of(const surface& s, const surface_shell& shell) {
  for (std::size_t v = 0; v < shell.points.size(); ++v)
    for (const double x : {shell.points[v].x, shell.points[v].y, shell.points[v].z})
      if (!std::isfinite(x) || std::abs(x) > greatest_modulus)
        return error{fmt::format("vertex {}: coordinate {:g} is out of range", v + 1, x),
                     error_code::invalid_mesh};
  std::vector<std::size_t> faces(s.patches.size(), 0);
  for (std::size_t f = 0; f < shell.faces.size(); ++f) {
    if (auto wrong = fault_of_face(s, shell, f)) return wrong;
    ++faces[shell.faces[f].patch];
  }
  for (std::size_t p = 0; p < faces.size(); ++p)
    if (faces[p] != 1)
      return error{fmt::format("patch {} has {} faces, not 1", p + 1, faces[p]),
                   error_code::invalid_mesh};
  return {};
}

// Data that the bounds of cells need: indexes of shell and surface.
class shell_view {
 public:
  shell_view(const surface& s, const surface_shell& shell, std::vector<bezier_piece> pieces)
      : pieces_(std::move(pieces)),
        triangles_(triangles_of(shell)),
        mesh_(mesh_of(shell, triangles_)),
        boxes_(boxes_of_triangles(mesh_)),
        tree_(boxes_),
        locator_(pieces_),
        space_{mesh_, s, pieces_, tree_, locator_, &places_, is_trimmed(s) ? &trims_ : nullptr} {
    const auto by_patch = spans_of(pieces_, s.patches.size());
    for (const shell_face& face : shell.faces) spans_.push_back(by_patch[face.patch]);
    if (is_trimmed(s)) trims_ = trims_of_shell(s, shell, triangles_, by_patch);
    for (const shell_triangle& t : triangles_)
      if (!t.collapsed) places_.push_back(middle_of(t));
  }
  shell_view(const shell_view&) = delete;
  shell_view& operator=(const shell_view&) = delete;

  lifted_scene scene() const { return {space_, spans_, triangles_}; }
  const std::vector<shell_triangle>& triangles() const { return triangles_; }
  const std::vector<bezier_piece>& pieces() const { return pieces_; }
  const space_mesh& in_space() const { return mesh_; }
  double size() const {
    space_box all = boxes_[0];
    for (const space_box& box : boxes_) all.include(box);
    return all.diagonal();
  }

 private:
  // Returns the approximate place of a triangle's middle on the surface.
  surface_place middle_of(const shell_triangle& t) const {
    const auto mean = [&](std::size_t k) { return (t.at[0][k] + t.at[1][k] + t.at[2][k]) / 3; };
    return place_in(pieces_, spans_[t.face], mean(0), mean(1));
  }

  std::vector<bezier_piece> pieces_;
  std::vector<shell_triangle> triangles_;
  space_mesh mesh_;
  std::vector<space_box> boxes_;
  box_tree tree_;
  surface_locator locator_;
  std::vector<surface_place> places_;  // of the triangles in space
  trim_scene trims_;                   // where there are any
  deviation_scene space_;
  std::vector<patch_spans> spans_;
};

using look = void (*)(const lifted_scene&, lifted_cell&, const triangle_net&);
using lifted_cells = std::vector<lifted_cell>;

[[gnu::noinline]] void look_at(const lifted_scene& scene, lifted_cell& cell, look at) {
  at(scene, cell, net_of(scene, cell));
}

lifted_cells cells_of_triangle(const lifted_scene& scene, std::uint32_t t) {
  const floating_point_scope scope(rounding::upward);
  return cells_of(scene, t);
}

// Returns the first cells of a triangle, with bounds; none where a cut is not certain.
lifted_cells first_cells(const lifted_scene& scene, std::uint32_t t, look at) {
  const floating_point_scope scope(rounding::upward);
  lifted_cells cells = cells_of(scene, t);
  for (lifted_cell& cell : cells) look_at(scene, cell, at);
  return cells;
}

// The undivided cell of each triangle twice: with bounds of its distance, and with bounds of its
// normals. Both bounds are computed from one net of control points.
struct first_looks {
  std::vector<lifted_cells> distances, normals;
};

[[gnu::noinline]] void look_at_both(const lifted_scene& scene, lifted_cell& distance,
                                    lifted_cell& normal) {
  const triangle_net net = net_of(scene, distance);
  look_at_distance(scene, distance, net);
  look_at_normals(scene, normal, net);
}

first_looks first_looks_at(const lifted_scene& scene) {
  first_looks first;
  first.distances.resize(scene.triangles.size());
  first.normals.resize(scene.triangles.size());
  parallel_for(scene.triangles.size(), [&](std::size_t t) {
    const auto number = static_cast<std::uint32_t>(t);
    if (scene.triangles[t].collapsed) {
      first.distances[t] = first_cells(scene, number, look_at_distance);
      return;
    }
    const floating_point_scope scope(rounding::upward);
    first.distances[t] = first.normals[t] = cells_of(scene, number);
    for (std::size_t k = 0; k < first.normals[t].size(); ++k)
      look_at_both(scene, first.distances[t][k], first.normals[t][k]);
  });
  return first;
}

lifted_cells joined(const std::vector<lifted_cells>& parts) {
  std::size_t count = 0;
  for (const lifted_cells& some : parts) count += some.size();
  lifted_cells all;
  all.reserve(count);
  for (const lifted_cells& some : parts) all.insert(all.end(), some.begin(), some.end());
  return all;
}

std::vector<lifted_cell> parts_of(const lifted_scene& scene, const lifted_cell& cell, look at) {
  const floating_point_scope scope(rounding::upward);
  const auto four = quarters(cell);
  std::vector<lifted_cell> parts(four.begin(), four.end());
  for (lifted_cell& part : parts) {
    look_at(scene, part, at);
    part.above = std::min(part.above, cell.above);
  }
  return parts;
}

// True if dividing the cell is useless: the surface is folded there, in doubles, or the cell is
// small.
bool gives_up(const lifted_cell& cell) {
  return cell.depth >= deepest || (std::isinf(cell.above) && cell.below < 0);
}

// Returns false if the surface is folded over the triangle, by tests in doubles at a few places, or
// if that is undecided after `most_cells` parts.
bool is_unfolded(const lifted_scene& scene, std::uint32_t t) {
  constexpr std::size_t most_cells = 1000;
  std::vector<lifted_cell> waiting = first_cells(scene, t, look_at_normals);
  for (std::size_t k = 0; k < waiting.size(); ++k) {
    const lifted_cell cell = waiting[k];
    if (!std::isinf(cell.above)) continue;
    if (gives_up(cell) || waiting.size() > most_cells) return false;
    for (const lifted_cell& part : parts_of(scene, cell, look_at_normals)) waiting.push_back(part);
  }
  return true;
}

// Returns u and v of a place within the triangle's piece where the surface itself is folded, if
// doubles find one.
std::optional<std::array<double, 2>> fold_over(const lifted_scene& scene, std::uint32_t t) {
  for (const lifted_cell& cell : cells_of_triangle(scene, t)) {
    const bezier_piece& piece = scene.space.pieces[cell.piece];
    if (const auto at = fold_in(piece, cell.corners))
      return std::array{piece.u_low + (*at)[0] * (piece.u_high - piece.u_low),
                        piece.v_low + (*at)[1] * (piece.v_high - piece.v_low)};
  }
  return std::nullopt;
}

double root_above(double squared) {
  const floating_point_scope scope(rounding::upward);
  return rounded_root(squared);
}

void audit_distances(const shell_view& view, const std::vector<lifted_cells>& first,
                     const shell_question& asked, shell_report& report) {
  const lifted_scene scene = view.scene();
  for (std::size_t t = 0; t < first.size(); ++t)
    if (first[t].empty())
      note_finding(report, asked,
                   fmt::format("triangle {}: knots cross at a corner of it but for rounding, so "
                               "that nothing is proved of it",
                               t + 1));
  narrowing_limits limits;
  limits.negligible = negligible_share * view.size();
  if (scene.space.trims != nullptr)
    limits.negligible = std::max(limits.negligible, negligible_at_trims * asked.chord);
  limits.at_most = asked.chord;
  limits.most_cells = 100 * scene.triangles.size() + 1'000'000;
  // Reports the greater of the bounds of mesh to surface and of surface to mesh: the second bound
  // is not narrowed below the first.
  const double of_mesh = distance_of_mesh(scene.space, limits);
  limits.negligible = std::max(limits.negligible, of_mesh);
  const auto found = narrow(joined(first), limits, [&](const lifted_cell& cell) {
    return parts_of(scene, cell, look_at_distance);
  });
  report.distance = std::max(root_above(found.above), of_mesh);
  if (report.distance > asked.chord)
    note_finding(
        report, asked,
        fmt::format("the mesh is proved within {:.9g} of the surface, and {:.9g} is asked: "
                    "see triangle {}",
                    report.distance, asked.chord, found.best ? found.best->triangle + 1 : 0));
}

void audit_normals(const shell_view& view, const std::vector<lifted_cells>& first,
                   const shell_question& asked, shell_report& report) {
  const lifted_scene scene = view.scene();
  lifted_cells cells = joined(first);
  const auto divide = [&](const lifted_cell& cell) {
    return gives_up(cell) ? std::vector<lifted_cell>{} : parts_of(scene, cell, look_at_normals);
  };
  // Proves first that all is unfolded, with any finite bound; then narrows the bound, within the
  // work limit.
  std::vector<unsigned char> failed(scene.triangles.size(), 0);
  narrowing_limits limits;
  limits.negligible = finite;
  limits.most_cells = 200 * scene.triangles.size() + 50'000;
  const auto unfolded =
      narrow(cells, limits, divide, [&](const lifted_cell& cell) { failed[cell.triangle] = 1; });
  limits.relative_width = 0.1;
  limits.negligible = 1e-9;
  const auto found = narrow(std::move(cells), limits, divide);
  report.normal_tangent = root_above(std::min(unfolded.above, found.above));
  for (std::size_t t = 0; t < failed.size(); ++t) {
    if (failed[t] == 0) continue;
    ++report.folded;
    note_finding(
        report, asked,
        fmt::format("triangle {}: it is not proved that the surface is not folded over it, "
                    "or how far its normals turn",
                    t + 1));
  }
  if (!unfolded.done && report.folded == 0)
    note_finding(report, asked, "the normals could not be bounded with the work allowed");
}

void audit_vertices(const surface_shell& shell, const shell_view& view, shell_report& report) {
  const lifted_scene scene = view.scene();
  double most = 0;
  for (std::uint32_t f = 0; f < shell.faces.size(); ++f) {
    const shell_face& face = shell.faces[f];
    std::vector<double> far(face.plane.sites.size());
    parallel_for(far.size(), [&](std::size_t k) {
      const floating_point_scope scope(rounding::upward);
      const point& p = face.plane.sites[k].position;
      far[k] =
          squared_vertex_distance(scene, f, std::ldexp(p.x, -face.scale_u),
                                  std::ldexp(p.y, -face.scale_v), shell.points[face.vertex[k]]);
    });
    for (const double x : far) most = std::max(most, x);
  }
  report.vertex_distance = root_above(most);
}

void audit_crossings(const shell_view& view, const shell_question& asked, shell_report& report) {
  if (!asked.no_crossings) return;
  if (const auto two = crossing_triangles(view.in_space()))
    note_finding(report, asked,
                 fmt::format("triangles {} and {} in space cross each other, or touch beside what "
                             "they have in common",
                             (*two)[0] + 1, (*two)[1] + 1));
}

void measure_angles(const shell_view& view, shell_report& report) {
  const space_mesh& m = view.in_space();
  for (const space_triangle& t : m.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const plain_vector at = plain(m.points[t[k]]), p = plain(m.points[t[(k + 1) % 3]]) - at,
                         q = plain(m.points[t[(k + 2) % 3]]) - at;
      const plain_vector area = cross(p, q);
      const double angle =
          elementary::atan2(std::sqrt(dot(area, area)), dot(p, q)) * 180 / std::numbers::pi;
      report.least_angle_in_space = std::min(report.least_angle_in_space, angle);
    }
}

}  // namespace

result<shell_report> audit_shell(const surface& s, const surface_shell& shell,
                                 const shell_question& asked) {
  auto pieces = bezier_pieces(s);
  if (!pieces) return pieces.failure();
  if (auto wrong = fault_of(s, shell)) return *wrong;
  shell_report report;
  audit_planes(s, shell, asked, report);
  // Ends here for meshes that are no triangulations: further findings would be meaningless.
  if (report.found > 0) return report;
  const shell_view view(s, shell, std::move(pieces).value());
  if (view.in_space().triangles.empty()) return no_triangle();
  audit_edges(s, shell, view.triangles(), asked, report);
  audit_trims(s, shell, view.pieces(), negligible_share * view.size(), asked, report);
  audit_vertices(shell, view, report);
  const first_looks first = first_looks_at(view.scene());
  audit_distances(view, first.distances, asked, report);
  audit_normals(view, first.normals, asked, report);
  audit_crossings(view, asked, report);
  measure_angles(view, report);
  report.certified = report.found == 0;
  return report;
}

result<std::vector<shell_measure>> shell_measures(const surface& s, const surface_shell& shell,
                                                  double enough,
                                                  const std::vector<unsigned char>& wanted) {
  auto pieces = bezier_pieces(s);
  if (!pieces) return pieces.failure();
  if (auto wrong = fault_of(s, shell)) return *wrong;
  const shell_view view(s, shell, std::move(pieces).value());
  if (view.in_space().triangles.empty()) return no_triangle();
  const lifted_scene scene = view.scene();
  std::vector<shell_measure> measures(scene.triangles.size());
  parallel_for(measures.size(), [&](std::size_t t) {
    if (wanted[t] == 0) return;
    narrowing_limits limits;
    limits.relative_width = 0.05;
    limits.negligible = enough;
    limits.most_cells = 2000;
    const auto found =
        narrow(first_cells(scene, static_cast<std::uint32_t>(t), look_at_distance), limits,
               [&](const lifted_cell& cell) { return parts_of(scene, cell, look_at_distance); });
    measures[t].distance = root_above(found.above);
    limits.negligible = std::max(limits.negligible, measures[t].distance);
    if (!scene.triangles[t].collapsed)
      measures[t].distance = std::max(
          measures[t].distance, distance_of_triangle(scene.space, scene.triangles[t].kept, limits));
    measures[t].is_unfolded =
        scene.triangles[t].collapsed || is_unfolded(scene, static_cast<std::uint32_t>(t));
    if (!measures[t].is_unfolded)
      measures[t].fold = fold_over(scene, static_cast<std::uint32_t>(t));
  });
  return measures;
}

}  // namespace asterism::internal
