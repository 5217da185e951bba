// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/outline_chords.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "asterism/mesh/domain/divide_curves.hpp"
#include "asterism/mesh/metric/interpolated_field.hpp"
#include "asterism/mesh/pipeline/kept_mesh.hpp"

namespace asterism::internal {
namespace {

// True if the segments of one domain begin the list of another, in order and direction, each whole
// or as the first chord of its curve.
bool begins_with(const domain& divided, const domain& whole) {
  if (divided.segments.size() < whole.segments.size() ||
      divided.curves.size() != whole.curves.size())
    return false;
  std::size_t others = 0;
  for (std::size_t s = 0; s < whole.segments.size(); ++s) {
    const segment &now = divided.segments[s], &before = whole.segments[s];
    // Compares vertices by number: vertices of the whole domain keep their numbers, as new vertices
    // come after them.
    const bool starts = now.a == before.a, ends = now.b == before.b;
    if (now.internal != before.internal || !(starts || ends)) return false;
    others += starts && ends ? 0 : 1;
  }
  return others <= divided.curves.size();
}

}  // namespace

chorded_outline with_chords_for(const mesh& m, const mesh_outline& found) {
  chorded_outline made{found.shape, found.former};
  if (found.keeps_all || found.shape.curves.empty()) return made;
  constexpr double part = 0.25;
  const auto field = make_interpolated_field(m, 1);
  curve_division chords;
  chords.field = field.get();
  chords.part_of_size = found.part_of_size;
  chords.is_even = false;  // pieces are at most as long as an edge wanted
  constexpr double most = 1e7;
  chords.most_chords =
      static_cast<std::size_t>(part * std::min(vertices_of_unit_edges(m).inside, most));
  auto divided = divide_curves_anew(found.shape, chords);
  if (!divided || !begins_with(divided.value(), found.shape)) return made;
  // Keeps a ragged boundary undivided: divided, it took 15,852 triangles where 7,000 were wanted.
  const std::size_t more = divided.value().segments.size() - found.shape.segments.size();
  if (more > chords.most_chords) return made;
  made.shape = std::move(divided).value();
  made.former.between.resize(made.shape.segments.size());
  return made;
}

}  // namespace asterism::internal
