// SPDX-License-Identifier: MIT
//
// Divides the curves that two patches share, once for both patches, and the curves that trim
// patches.
#pragma once

#include <vector>

#include "asterism/mesh/surface/face_meshing.hpp"
#include "asterism/mesh/surface/surface_chart.hpp"
#include "asterism/mesh/surface/surface_sides.hpp"

namespace asterism::internal {

// The patches of a surface, with their charts and meshes. All must outlive this object.
struct patch_faces {
  const side_graph& graph;
  const std::vector<surface_chart>& charts;
  const std::vector<face_border>& borders;
  std::vector<face_meshing>& faces;
};

// A place on a curve is a number p from 0 to 1 along the curve. Along a side it is p, or 1 - p if
// the side has the other direction. Both are exact.
inline double own_place(const patch_side& side, double place) {
  return side.backward ? 1 - place : place;
}
// Returns the point of the patch's chart at a place of the side.
point chart_point(const patch_faces& of, const patch_side& side, double place);
// Returns the entry of the curve for this side of the patch.
const patch_side& side_of_patch(const side_curve& curve, std::size_t patch, int side);

class curve_division {
 public:
  // Takes the number of curves, and the largest distance in space of the mesh from the surface.
  curve_division(std::size_t curves, double chord) : places_(curves), chord_(chord) {}

  // Divides the curves that two patches share in parts of about equal length, and those that trim
  // patches so that their chords are near them in space. Marks the patches of changed curves.
  void divide(const patch_faces& of, std::vector<unsigned char>& is_stale);
  // Divides each part of the curves that trim a patch once more, since their polygons cross. Marks
  // the patches of these curves.
  void divide_border(const patch_faces& of, std::size_t patch,
                     std::vector<unsigned char>& is_stale);
  // Adds the places at which a patch's mesh has split a curve, shared or trimming, to the curve,
  // and marks its patches. Returns true if there were any.
  bool take_splits(const patch_faces& of, std::vector<unsigned char>& is_stale);
  // Returns the places on the sides of a patch.
  side_places on_sides_of(const patch_faces& of, std::size_t patch) const;

 private:
  void put(const patch_faces& of, std::size_t curve, std::vector<double> places,
           std::vector<unsigned char>& is_stale);

  std::vector<std::vector<double>> places_;     // on each curve, from its start, ascending
  std::vector<std::vector<double>> kept_ = {};  // of those, the ones that divide_border wants
  double chord_;
};

}  // namespace asterism::internal
