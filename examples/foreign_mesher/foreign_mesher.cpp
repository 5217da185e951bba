// SPDX-License-Identifier: MIT
//
// A mesh generator that is not ours, with its own points, triangles and loop, and every geometric
// decision asked of the filtered kernel: points are inserted one by one into a triangulation, and
// edges flipped until each passes edge_test. That is Lawson's Delaunay algorithm when all metrics
// are equal; with a metric that varies it is a heuristic that need not end, so flips are bounded.
#include <array>
#include <asterism/kernels/filtered_kernel.hpp>
#include <cstddef>
#include <iostream>
#include <vector>

namespace foreign {

using vertex_index = std::size_t;
constexpr vertex_index none = static_cast<vertex_index>(-1);

// Corners counter-clockwise; across[k] is the triangle opposite to corner[k].
struct triangle {
  std::array<vertex_index, 3> corner;
  std::array<vertex_index, 3> across{none, none, none};
};

class mesher {
 public:
  // The first three sites are a triangle, counter-clockwise, that contains all others.
  explicit mesher(std::vector<asterism::site> sites) : sites_(std::move(sites)) {
    triangles_.push_back({{0, 1, 2}});
  }

  // False when the flips reached their bound.
  bool run() {
    for (vertex_index p = 3; p < sites_.size(); ++p)
      if (!insert(p)) return false;
    return true;
  }

  bool is_sound() const {
    // By Euler's formula, with a triangle as hull.
    bool sound = triangles_.size() == 2 * sites_.size() - 5;
    for (const triangle& t : triangles_)
      sound = sound && side(t.corner[0], t.corner[1], t.corner[2]) == asterism::sign::positive;
    return sound;
  }

  // Counts edges that fail the test although they could be flipped.
  int failing_edges() const {
    int failing = 0;
    for (vertex_index t = 0; t < triangles_.size(); ++t)
      for (vertex_index k = 0; k < 3; ++k)
        if (triangles_[t].across[k] != none && t < triangles_[t].across[k])
          failing += should_flip(t, k) ? 1 : 0;
    return failing;
  }

  const asterism::tier_counters& counters() const { return decided_; }
  std::size_t triangles() const { return triangles_.size(); }
  long flips() const { return flips_; }

 private:
  asterism::sign side(vertex_index a, vertex_index b, vertex_index c) const {
    return kernel_.orientation(sites_[a].position, sites_[b].position, sites_[c].position);
  }

  static vertex_index corner_across(const triangle& t, vertex_index neighbour) {
    for (vertex_index k = 0; k < 3; ++k)
      if (t.across[k] == neighbour) return k;
    return none;
  }

  void replace_across(vertex_index of, vertex_index old_neighbour, vertex_index new_neighbour) {
    if (of == none) return;
    triangles_[of].across[corner_across(triangles_[of], old_neighbour)] = new_neighbour;
  }

  // Returns the triangle with p inside or on its border. Tests all triangles, since speed does not
  // matter here.
  vertex_index locate(vertex_index p) const {
    for (vertex_index t = 0; t < triangles_.size(); ++t) {
      const auto& c = triangles_[t].corner;
      bool inside = true;
      for (vertex_index k = 0; k < 3; ++k)
        inside = inside && side(c[(k + 1) % 3], c[(k + 2) % 3], p) != asterism::sign::negative;
      if (inside) return t;
    }
    return none;
  }

  // Splits the triangle in three. A point on an edge makes one of them flat, and that edge is
  // flipped first.
  bool insert(vertex_index p) {
    const vertex_index t = locate(p);
    if (t == none) return false;
    const triangle old = triangles_[t];
    const vertex_index second = triangles_.size(), third = second + 1;
    const auto [a, b, c] = old.corner;
    triangles_[t] = {{a, b, p}, {second, third, old.across[2]}};
    triangles_.push_back({{b, c, p}, {third, t, old.across[0]}});
    triangles_.push_back({{c, a, p}, {t, second, old.across[1]}});
    replace_across(old.across[0], t, second);
    replace_across(old.across[1], t, third);
    return restore({t, second, third});
  }

  // Tests the edge opposite to corner k of t, with the corner beyond it.
  bool should_flip(vertex_index t, vertex_index k) const {
    const triangle& here = triangles_[t];
    const vertex_index other = here.across[k];
    if (other == none) return false;
    const vertex_index x = here.corner[k], v = here.corner[(k + 1) % 3],
                       w = here.corner[(k + 2) % 3];
    const vertex_index y = triangles_[other].corner[corner_across(triangles_[other], t)];
    if (side(x, v, y) != asterism::sign::positive || side(y, w, x) != asterism::sign::positive)
      return false;                                          // the quadrilateral is not convex
    if (side(x, v, w) == asterism::sign::zero) return true;  // a flat triangle
    return !kernel_.edge_test(sites_[v], sites_[w], sites_[x], sites_[y]) &&
           kernel_.edge_test(sites_[x], sites_[y], sites_[v], sites_[w]);
  }

  bool restore(std::vector<vertex_index> waiting) {
    const long most = flips_ + 100 + 10 * static_cast<long>(triangles_.size());
    while (!waiting.empty()) {
      const vertex_index t = waiting.back();
      waiting.pop_back();
      for (vertex_index k = 0; k < 3; ++k) {
        if (!should_flip(t, k)) continue;
        if (++flips_ > most) return false;
        waiting.push_back(triangles_[t].across[k]);
        waiting.push_back(t);
        flip(t, k);
        break;
      }
    }
    return true;
  }

  // x v w and v y w become x v y and x y w... with x the corner k of t.
  void flip(vertex_index t, vertex_index k) {
    const vertex_index u = triangles_[t].across[k];
    const triangle here = triangles_[t], there = triangles_[u];
    const vertex_index j = corner_across(there, t);
    const vertex_index x = here.corner[k], v = here.corner[(k + 1) % 3],
                       w = here.corner[(k + 2) % 3], y = there.corner[j];
    const vertex_index beyond_xv = here.across[(k + 2) % 3], beyond_wx = here.across[(k + 1) % 3];
    const vertex_index beyond_vy = there.across[(j + 1) % 3], beyond_yw = there.across[(j + 2) % 3];
    triangles_[t] = {{x, v, y}, {beyond_vy, u, beyond_xv}};
    triangles_[u] = {{x, y, w}, {beyond_yw, beyond_wx, t}};
    replace_across(beyond_vy, u, t);
    replace_across(beyond_wx, t, u);
  }

  std::vector<asterism::site> sites_;
  std::vector<triangle> triangles_;
  long flips_ = 0;
  asterism::tier_counters decided_;
  asterism::filtered_kernel kernel_{decided_};
};

}  // namespace foreign

namespace {

// A grid, with four points on each cell's circle, in a triangle far around it.
std::vector<asterism::site> grid(int size, double variation) {
  std::vector<asterism::site> sites = {
      {{-64, -64}, {1, 0, 1}}, {{128, -64}, {1, 0, 1}}, {{0, 128}, {1, 0, 1}}};
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j) {
      const double x = i, y = j, bend = variation * x;
      sites.push_back({{x, y}, {1 + bend * bend, bend, 1}});
    }
  return sites;
}

bool mesh(const char* name, double variation, bool must_end) {
  foreign::mesher mesher(grid(16, variation));
  const bool ended = mesher.run();
  const auto& counters = mesher.counters();
  std::cout << name << ": " << mesher.triangles() << " triangles, " << mesher.flips()
            << " flips, edge tests that needed exact arithmetic: "
            << counters.at(asterism::predicate::edge_test, asterism::tier::exact)
            << (ended ? "\n" : ", flips did not end\n");
  return !must_end || (ended && mesher.is_sound() && mesher.failing_edges() == 0);
}

}  // namespace

int main() {
  const bool right = mesh("one metric", 0, true) & mesh("varying metric", 0.01, false);
  return right ? 0 : 1;
}
