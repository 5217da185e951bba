// SPDX-License-Identifier: MIT
//
// Divides the curves that two patches have in common, once for both, and those that trim patches.
#pragma once

#include <vector>

#include "asterism/mesh/surface/face_meshing.hpp"
#include "asterism/mesh/surface/surface_chart.hpp"
#include "asterism/mesh/surface/surface_sides.hpp"

namespace asterism::internal {

// The patches of a surface with their meshes. All must outlive it.
struct patch_faces {
  const side_graph& graph;
  const std::vector<surface_chart>& charts;
  const std::vector<face_border>& borders;
  std::vector<face_meshing>& faces;
};

// A place on a curve is a number from 0 to 1 along the curve, and the same or 1 less it along its
// sides. Both are exact.
inline double own_place(const patch_side& side, double place) {
  return side.backward ? 1 - place : place;
}
// The point of the side's chart.
point chart_point(const patch_faces& of, const patch_side& side, double place);
// Returns the side of the curve that is the given side of the patch.
const patch_side& side_of_patch(const side_curve& curve, std::size_t patch, int side);

class curve_division {
 public:
  // `chord` is the distance asked of the mesh.
  curve_division(std::size_t curves, double chord) : places_(curves), chord_(chord) {}

  // Divides the curves of two patches in parts of about equal length, and those that trim patches
  // so that their chords are near them in space. Marks the patches of those that change.
  void divide(const patch_faces& of, std::vector<unsigned char>& is_stale);
  // Divides each part of the curves that trim a patch once more, and marks the patches that have
  // them: their polygons cross.
  void divide_border(const patch_faces& of, std::size_t patch,
                     std::vector<unsigned char>& is_stale);
  // Takes the places at which the mesh of a patch has divided a curve of two, or one that trims, to
  // that curve, and marks its patches. True if there were any.
  bool take_splits(const patch_faces& of, std::vector<unsigned char>& is_stale);
  // The places on the sides of a patch.
  side_places on_sides_of(const patch_faces& of, std::size_t patch) const;

 private:
  void put(const patch_faces& of, std::size_t curve, std::vector<double> places,
           std::vector<unsigned char>& is_stale);

  std::vector<std::vector<double>> places_;     // on each curve, from its start, ascending
  std::vector<std::vector<double>> kept_ = {};  // of those, the ones that divide_border wants
  double chord_;
};

}  // namespace asterism::internal
