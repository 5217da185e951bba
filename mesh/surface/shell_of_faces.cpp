// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface/shell_of_faces.hpp"

#include <array>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace asterism::internal {
namespace {

constexpr std::uint32_t none = ~0U;

class shell_maker {
 public:
  shell_maker(const surface& s, const patch_faces& of)
      : surface_(s), of_(of), corner_(of.graph.corners, none) {
    find_trimmed_corners();
  }

  void add_face(std::size_t p);
  surface_shell take() { return std::move(made_); }

 private:
  std::uint32_t add(const space_point& p) {
    // Turns -0 into 0, so that equal places are equal bits.
    made_.points.push_back({p.x + 0.0, p.y + 0.0, p.z + 0.0});
    return static_cast<std::uint32_t>(made_.points.size() - 1);
  }
  std::uint32_t vertex_of(std::size_t p, vertex_index site);
  void find_trimmed_corners();

  const surface& surface_;
  const patch_faces& of_;
  surface_shell made_;
  std::vector<std::uint32_t> corner_;
  std::vector<std::optional<space_point>> trimmed_corner_;  // by number of the corner
  std::map<std::pair<std::size_t, double>, std::uint32_t> on_curve_;
};

// Takes for a corner of several trimmed faces the least of its points on them, which differ by
// gaps and rounding: the order of the faces then makes no difference.
void shell_maker::find_trimmed_corners() {
  const auto less = [](const space_point& a, const space_point& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  };
  trimmed_corner_.resize(of_.graph.corners);
  for (std::size_t p = 0; p < of_.graph.corner_of.size(); ++p) {
    if (surface_.patches[p].loops.empty()) continue;
    for (std::size_t k = 0; k < of_.graph.corner_of[p].size(); ++k) {
      const space_point at = of_.charts[p].lift(of_.borders[p].corner(k));
      std::optional<space_point>& least = trimmed_corner_[of_.graph.corner_of[p][k]];
      if (!least || less(at, *least)) least = at;
    }
  }
}

std::uint32_t shell_maker::vertex_of(std::size_t p, vertex_index site) {
  const surface_patch& patch = surface_.patches[p];
  const auto& corner_of = of_.graph.corner_of[p];
  if (site < corner_of.size()) {
    std::uint32_t& known = corner_[corner_of[site]];
    if (known == none && !patch.loops.empty()) known = add(*trimmed_corner_[corner_of[site]]);
    const std::size_t i = site == 1 || site == 2 ? patch.count_u - 1 : 0,
                      j = site >= 2 ? patch.count_v - 1 : 0;
    if (known == none) known = add(patch.at(i, j).at);
    return known;
  }
  const face_meshing& face = of_.faces[p];
  if (const auto on = face.side_of(site)) {
    const std::size_t c = of_.graph.curve_of[p][static_cast<std::size_t>(on->side)];
    const side_curve& curve = of_.graph.curves[c];
    if (curve.is_point) return corner_[corner_of[static_cast<std::size_t>(on->side)]];
    if (curve.sides.size() == 2 || curve.is_trim) {
      const double place = own_place(side_of_patch(curve, p, on->side), on->place);
      const auto [known, is_new] = on_curve_.emplace(std::pair{c, place}, 0);
      const surface_chart& chart = of_.charts[curve.sides[0].patch];
      if (is_new) known->second = add(chart.lift(chart_point(of_, curve.sides[0], place)));
      return known->second;
    }
  }
  return add(of_.charts[p].lift(face.plane().sites[site].position));
}

void shell_maker::add_face(std::size_t p) {
  shell_face face;
  face.patch = static_cast<std::uint32_t>(p);
  face.scale_u = of_.charts[p].scale_u(), face.scale_v = of_.charts[p].scale_v();
  face.reversed = of_.graph.reversed[p];
  face.plane = of_.faces[p].plane();
  for (vertex_index v = 0; v < face.plane.sites.size(); ++v) face.vertex.push_back(vertex_of(p, v));
  face.border = of_.faces[p].border_places();
  made_.faces.push_back(std::move(face));
}

}  // namespace

surface_shell shell_of_faces(const surface& s, const patch_faces& of) {
  shell_maker maker(s, of);
  for (std::size_t p = 0; p < of.faces.size(); ++p) maker.add_face(p);
  return maker.take();
}

}  // namespace asterism::internal
