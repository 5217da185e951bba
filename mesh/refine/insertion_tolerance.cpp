// SPDX-License-Identifier: MIT
#include "asterism/mesh/refine/insertion_tolerance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/numerics/triangle_quality.hpp"
#include "asterism/mesh/stars/nearest_distances.hpp"

namespace asterism::internal {
namespace {

constexpr double degree = std::numbers::pi / 180;

// Constants of Voronoi arcs: the first tolerance, as a part of the shortest distance; the first
// tolerance divided by the last (ten halvings); and the first tolerance divided by the finest
// distance of sites. These constants hardly matter: starts of 0.05 to 0.4, ladders of 16 to 1024
// and finest parts of 32 to 1024 give the same meshes of the square in swirl:12 and sink:12 and of
// the airfoil. The constants only end attempts at triangles that no site can mend.
constexpr double arc_fraction = 0.2;
constexpr double arc_ladder = 1024;
constexpr double arc_finest_part = 256;
// Constants after a fill, when defects are mended at points nearly as far from all sites as the
// fill's own. The start is 0.6 of the fill's distance, the factor between steps 0.75, and the start
// over the finest 32. Chosen for few disagreeing triangles in a metric that varies too fast: on the
// square in polar-1 with size 0.5 these constants leave 317. With 0.3 or 0.9 in place of 0.6, 821
// or 530 are left, with 0.5 or 0.9 in place of 0.75, 827 or 513, with 8 in place of 32, 702; and
// with a fill_ladder of 16 the run ends before its stars are made. In metrics that vary less
// (airfoil and square with sizes) a start of 0.3, or a factor of 0.5, would save 2 to 5 % of the
// sites.
constexpr double fill_fraction = 0.6;
constexpr double fill_ladder = 128;  // start over floor
constexpr double finest_part = 32;   // start over finest
constexpr double fill_shrink = 0.75;
// Constants of darts: the start as a part of the median distance, and the start over the floor. A
// start at half of the median takes 92 and 115 sites on the square with 30 points in swirl:3 and
// sink:3; a start at a quarter takes 216 and 148, at the whole 75 and 152. The number of steps, as
// for arcs, only limits attempts that insert no site.
constexpr double dart_fraction = 0.5;
constexpr double dart_ladder = 1024;

// Returns the least distance that the domain forces between sites, in the metrics of its vertices,
// at most `most`: the shortest distance from a vertex to a site, or to a subsegment that does not
// end at the vertex, and the width of a sharp corner between its subsegments.
double smallest_feature(const refine_state& state, vertex_index vertices, double most) {
  double least =
      shortest_distance(state.sites(), vertices, state.edges(), *state.oracle().near(), most);
  // Takes the width of a sharp corner at the end of the shorter of its two first subsegments.
  for (const domain_corner& c : state.segments().corners())
    if (c.is_sharp())
      for (const std::size_t subsegment : state.segments().subsegments_at(c))
        least = std::min(least, state.segments().subsegment_length(subsegment, c.vertex) *
                                    elementary::sin(c.angle * degree));
  return least;
}

}  // namespace

tolerance_range choose_tolerance(const refine_state& state, vertex_index vertices,
                                 const mesh_options& options) {
  const bool darts = options.strategy == refinement_strategy::poisson_darts;
  if (options.tolerance) {
    const double given = *options.tolerance;
    return {given, darts ? given / dart_ladder : given};
  }
  if (options.strategy == refinement_strategy::fill && options.limit_size) {
    const double start = fill_fraction * largest_circumradius, finest = start / finest_part;
    return {start, std::min(start, smallest_feature(state, vertices, start)) / fill_ladder,
            fill_shrink, finest};
  }
  // Takes 1 as the greatest distance with a size limit: edges will be about 1 long, however far
  // apart the given sites are.
  const double most = options.limit_size ? 1 : std::numeric_limits<double>::infinity();
  const auto all = static_cast<vertex_index>(state.sites().size());
  const proximity& near = *state.oracle().near();
  const double shortest = shortest_distance(state.sites(), all, state.edges(), near, most);
  if (darts) {
    const double start = dart_fraction * median_distance(state.sites(), near, most);
    return {start, std::min(start, shortest) / dart_ladder};
  }
  tolerance_range arcs{arc_fraction * shortest, arc_fraction * shortest / arc_ladder};
  arcs.finest = arcs.start / arc_finest_part;
  return arcs;
}

}  // namespace asterism::internal
