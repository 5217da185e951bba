// SPDX-License-Identifier: MIT
//
// Meshes by the anisotropic Delaunay kernel of Borouchaki, Frey, George and others: a point is
// inserted by taking away all triangles whose circle it is in, as the metrics of the point and of
// corners of the triangle measure that, and joining it to what surrounds them.
//
// Source: Borouchaki, Frey, George, "Unstructured triangular-quadrilateral mesh generation.
// Application to surface meshing", 5th International Meshing Roundtable, 1996, as chapter 2 of the
// thesis describes it. README.md says what is left out.
#include <algorithm>
#include <bit>
#include <cmath>

#include "job.hpp"

namespace {

using baselines::index;
using baselines::metric_mesh;
using baselines::metric_tensor;
using baselines::none;
using baselines::point;

// Longer edges are divided, and no point is nearer to another than the inverse: the range of a unit
// edge.
const double longest = std::sqrt(2.0);
// Lengths halve in a round where the metric changes slowly, so that ten suffice.
constexpr int most_rounds = 60;

// Returns the distance of p from the centre of a triangle's circle, in radii, in one metric: below
// 1 inside.
double nearness(const metric_tensor& m, const point& a, const point& b, const point& c,
                const point& p) {
  const double bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
  // The centre o, relative to a, has b M o = b M b / 2 and c M o = c M c / 2.
  const double b1 = m.m11 * bx + m.m12 * by, b2 = m.m12 * bx + m.m22 * by;
  const double c1 = m.m11 * cx + m.m12 * cy, c2 = m.m12 * cx + m.m22 * cy;
  const double bb = (b1 * bx + b2 * by) / 2, cc = (c1 * cx + c2 * cy) / 2;
  const double d = b1 * c2 - b2 * c1;
  const double ox = (bb * c2 - b2 * cc) / d, oy = (b1 * cc - bb * c1) / d;
  return baselines::length(m, p.x - a.x - ox, p.y - a.y - oy) / baselines::length(m, ox, oy);
}

class kernel {
 public:
  // `number` of metrics: 1: the new point's; 2: also that of the corner opposite to the edge over
  // which the search came; 3: those of all three corners.
  kernel(metric_mesh& mesh, int number) : mesh_(mesh), number_(number) {}

  // Divides long edges until there are none, or no more can be.
  std::string fill() {
    for (int round = 0; round < most_rounds; ++round) {
      std::size_t inserted = 0;
      for (const point& p : candidates()) inserted += insert(p) ? 1 : 0;
      if (inserted == 0) return "no edge takes a point any more";
    }
    return "stopped after " + std::to_string(most_rounds) + " rounds";
  }

 private:
  // Returns the points that cut the long inner edges into unit parts, in an order without a
  // pattern: sorted by the reversed binary digits of their places.
  std::vector<point> candidates() const {
    std::vector<point> found;
    for (index t = 0; t < mesh_.net.triangles().size(); ++t) {
      const baselines::triangle& here = mesh_.net.triangles()[t];
      for (std::size_t k = 0; here.alive() && k < 3; ++k) {
        if (here.across[k] == none || here.across[k] < t) continue;
        const index v = here.corner[(k + 1) % 3], w = here.corner[(k + 2) % 3];
        const point &p = mesh_.net.points()[v], &q = mesh_.net.points()[w];
        if (mesh_.length(v, w) <= longest && !may_hide_detail(p, q)) continue;
        for (const point& one : baselines::equal_pieces(*mesh_.field, p, q, 64))
          found.push_back(one);
      }
    }
    std::vector<point> mixed;
    for (std::size_t step = std::bit_ceil(found.size() + 1); step > 0; step /= 2)
      for (std::size_t i = step; i <= found.size(); i += 2 * step) mixed.push_back(found[i - 1]);
    return mixed;
  }

  // An edge may be longer in the metric of its middle than in those of its ends.
  bool may_hide_detail(const point& p, const point& q) const {
    const metric_tensor m = mesh_.field->at({(p.x + q.x) / 2, (p.y + q.y) / 2});
    return baselines::length(m, q.x - p.x, q.y - p.y) > longest;
  }

  bool in_cavity(const point& p, const metric_tensor& at_p, index t, index opposite) const {
    const baselines::corners& c = mesh_.net.triangles()[t].corner;
    const auto& points = mesh_.net.points();
    const auto in = [&](const metric_tensor& m) {
      return nearness(m, points[c[0]], points[c[1]], points[c[2]], p);
    };
    if (number_ == 1) return in(at_p) < 1;
    if (number_ == 2) return in(at_p) + in(mesh_.tensor[opposite]) < 2;
    return in(at_p) + in(mesh_.tensor[c[0]]) + in(mesh_.tensor[c[1]]) + in(mesh_.tensor[c[2]]) < 4;
  }

  // Returns the triangles that p replaces, found outward from the one that contains it. Removes
  // triangles with an outer edge that p does not see, until there are none.
  std::vector<index> cavity_of(const point& p, const metric_tensor& at_p) const {
    std::vector<index> cavity = mesh_.net.cell_of(p);
    const auto own = static_cast<std::ptrdiff_t>(cavity.size());
    for (std::size_t i = 0; i < cavity.size(); ++i)
      for (const index next : mesh_.net.triangles()[cavity[i]].across) {
        if (next == none || std::find(cavity.begin(), cavity.end(), next) != cavity.end()) continue;
        const baselines::triangle& there = mesh_.net.triangles()[next];
        const auto back = std::find(there.across.begin(), there.across.end(), cavity[i]);
        const index opposite = there.corner[static_cast<std::size_t>(back - there.across.begin())];
        if (in_cavity(p, at_p, next, opposite)) cavity.push_back(next);
      }
    for (;;) {
      const auto hidden = std::find_if(cavity.begin() + own, cavity.end(), [&](index t) {
        return !mesh_.net.sees_border(p, t, cavity);
      });
      if (hidden == cavity.end()) return cavity;
      cavity.erase(hidden);
    }
  }

  bool insert(const point& p) {
    const metric_tensor at_p = mesh_.field->at(p);
    const std::vector<index> cavity = cavity_of(p, at_p);
    for (const index t : cavity)
      for (const index v : mesh_.net.triangles()[t].corner) {
        const point& q = mesh_.net.points()[v];
        const double here = baselines::length(at_p, q.x - p.x, q.y - p.y);
        const double there = baselines::length(mesh_.tensor[v], q.x - p.x, q.y - p.y);
        if ((here + there) / 2 < 1 / longest) return false;
      }
    if (cavity.empty() || mesh_.net.insert(p, cavity) == none) return false;
    mesh_.measure_new();
    return true;
  }

  metric_mesh& mesh_;
  int number_;
};

asterism::result<std::string> mesh(metric_mesh& m,
                                   const std::map<std::string, std::string>& options) {
  const auto named = options.find("--kernel");
  const std::string number = named == options.end() ? "2" : named->second;
  if (number != "1" && number != "2" && number != "3")
    return asterism::error{"--kernel is 1, 2 or 3"};
  m.net.flip_all([&m](index v, index w, index x, index y) {
    return baselines::mean({m.tensor[v], m.tensor[w], m.tensor[x], m.tensor[y]});
  });
  return kernel(m, number[0] - '0').fill();
}

}  // namespace

int main(int count, char** words) { return baselines::run(count, words, {"--kernel"}, mesh); }
