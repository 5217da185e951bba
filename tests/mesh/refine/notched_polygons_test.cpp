// SPDX-License-Identifier: MIT
//
// Polygons with coordinates of one decimal and right angles across from slanted sides. The Voronoi
// vertex of such a corner and the ends of such a side is the middle of the side. The middle is no
// double; rounded, it may be outside of the domain, where no site may be.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "asterism/core/random.hpp"
#include "asterism/mesh/mesher.hpp"
#include "fixtures/domain_kinds.hpp"
#include "fixtures/judged_mesh.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::testing;

namespace {

// A point in units of a tenth, so that decisions about it are exact.
struct tenths {
  int x = 0, y = 0;
};

// Returns the interior angle at a corner of a counter-clockwise ring, in degrees up to 360.
double corner_of(const std::vector<tenths>& ring, std::size_t i) {
  const std::size_t n = ring.size();
  const tenths q = ring[i], next = ring[(i + 1) % n], last = ring[(i + n - 1) % n];
  const double ux = next.x - q.x, uy = next.y - q.y, wx = last.x - q.x, wy = last.y - q.y;
  const double turn = std::atan2(ux * wy - uy * wx, ux * wx + uy * wy) * 180 / std::numbers::pi;
  return turn > 0 ? turn : turn + 360;
}

domain polygon_of(const std::vector<tenths>& ring) {
  std::vector<point> corners;
  corners.reserve(ring.size());
  for (const tenths& q : ring) corners.push_back({q.x / 10.0, q.y / 10.0});
  return polygon(corners);
}

bool is_simple(const std::vector<tenths>& ring) {
  domain_repairs repairs;
  return check_domain(polygon_of(ring), &repairs).ok() && !repairs.any();
}

class notched_polygon {
 public:
  explicit notched_polygon(std::uint64_t seed) : random_(seed) {}

  // Draws polygons until one has a notch and no corner below `least` degrees.
  std::vector<tenths> draw(double least) {
    while (true) {
      draw_outline();
      const bool notched = is_simple(ring_) && add_notches();
      bool blunt = notched;
      for (std::size_t i = 0; blunt && i < ring_.size(); ++i) blunt = corner_of(ring_, i) >= least;
      if (blunt) return ring_;
    }
  }

 private:
  // Draws corners in the order of their directions from a point inside.
  void draw_outline() {
    const int corners = random_.integer(3, 12), reach = random_.integer(50, 1000);
    const tenths middle{random_.integer(0, 10000), random_.integer(0, 10000)};
    ring_.clear();
    for (int i = 0; i < corners; ++i) {
      const double turn = 2 * std::numbers::pi * (i + random_.real()) / corners;
      const double far = reach * random_.real(0.2, 1);
      ring_.push_back({middle.x + static_cast<int>(std::lround(far * std::cos(turn))),
                       middle.y + static_cast<int>(std::lround(far * std::sin(turn)))});
    }
  }

  bool add_notches() {
    bool any = false;
    for (int tries = random_.integer(3, 12); tries > 0; --tries)
      any = add_notch(random_.below(ring_.size())) || any;
    return any;
  }

  // Puts a reflex right angle between a corner and a point near the side that follows it. Its legs
  // are along the axes, or rotated by an angle with a rational tangent. Returns false where the
  // ring would intersect itself.
  bool add_notch(std::size_t i) {
    const tenths here = ring_[i], next = ring_[(i + 1) % ring_.size()];
    const double part = random_.real();
    tenths far{here.x + static_cast<int>(part * (next.x - here.x)) + random_.integer(-30, 30),
               here.y + static_cast<int>(part * (next.y - here.y)) + random_.integer(-30, 30)};
    tenths right{here.x, far.y};
    if (random_.chance(3)) {
      const int x = random_.integer(-7, 7), y = random_.integer(-7, 7);
      const int one = random_.integer(1, 12), other = random_.integer(-12, 12);
      right = {here.x + one * x, here.y + one * y};
      far = {right.x - other * y, right.y + other * x};
    } else if (random_.chance(2)) {
      right = {far.x, here.y};
    }
    std::vector<tenths> longer = ring_;
    longer.insert(longer.begin() + static_cast<std::ptrdiff_t>(i) + 1, {far, right});
    const bool taken = is_simple(longer) && corner_of(longer, i + 2) > 180;
    if (taken) ring_ = std::move(longer);
    return taken;
  }

  splitmix64 random_;
  std::vector<tenths> ring_;
};

}  // namespace

TEST_CASE("a Voronoi vertex that was rounded beyond a slanted side has the side split") {
  // The right angle at (546.9, 612.5), with legs of 1.8 and 0.1.
  const domain d = accepted(
      polygon({{545.1, 612.5}, {559.3, 568.8}, {579.1, 589.4}, {546.9, 612.5}, {546.9, 612.6}}));
  make_and_check(d, identity_field(), {});
}

TEST_CASE("polygons with right angles across from slanted sides are meshed at 20 degrees") {
  constexpr std::uint64_t seeds = 1000;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    INFO("replay: notched_polygon(" << seed << ").draw(20)");
    make_and_check(accepted(polygon_of(notched_polygon(seed).draw(20))), identity_field(), {});
  }
}

TEST_CASE("so are they where candidates on arcs have the whole work, and at 28 degrees") {
  for (std::uint64_t seed = 2001; seed <= 2200; ++seed) {
    INFO("replay: notched_polygon(" << seed << ").draw(28)");
    mesh_options options;
    options.angle_bound = 28;
    options.strategy =
        seed % 2 == 0 ? refinement_strategy::voronoi_arcs : refinement_strategy::fill;
    make_and_check(accepted(polygon_of(notched_polygon(seed).draw(28))), identity_field(), options);
  }
}
