// SPDX-License-Identifier: MIT
#include "asterism/mesh/transfer/supermesh.hpp"

#include <algorithm>
#include <cstdint>

#include "asterism/mesh/numerics/nodal_sums.hpp"
#include "asterism/mesh/support/parallel.hpp"
#include "asterism/mesh/transfer/triangle_overlap.hpp"

namespace asterism::internal {
namespace {

numbered_triangle numbered(const mesh& m, vertex_index t) {
  const triangle& v = m.triangles[t];
  return {v, {m.sites[v[0]].position, m.sites[v[1]].position, m.sites[v[2]].position}};
}

// Integrates the product of two linear functions over a triangle, by their values at its corners.
double product_integral(double doubled, const std::array<double, 3>& f,
                        const std::array<double, 3>& g) {
  const double sum_f = f[0] + f[1] + f[2], sum_g = g[0] + g[1] + g[2];
  return doubled / 24 * (sum_f * sum_g + f[0] * g[0] + f[1] * g[1] + f[2] * g[2]);
}

class clipper {
 public:
  clipper(const mesh& from, const mesh_links& links, const std::vector<nodal_values>& fields,
          const mesh& to, const located_vertices& located,
          const std::vector<std::vector<double>>& at_vertices)
      : from_(from), links_(links), fields_(fields), to_(to), located_(located), at_(at_vertices) {
    made_.mass.resize(to.triangles.size());
    made_.load.assign(fields.size(), std::vector<local_load>(to.triangles.size()));
  }

  supermesh run() {
    constexpr std::size_t chunk = 8192;
    const auto clip_chunk = [this](std::size_t begin, std::size_t end) {
      workspace w;
      w.seen.assign(from_.triangles.size(), no_triangle);
      totals sums;
      for (std::size_t t = begin; t < end; ++t) clip(static_cast<vertex_index>(t), w, sums);
      return sums;
    };
    for (const totals& part : map_chunks<totals>(to_.triangles.size(), chunk, clip_chunk)) {
      made_.common_area += part.area;
      made_.partly_covered += part.partly;
      made_.pieces += part.pieces;
    }
    return std::move(made_);
  }

 private:
  struct totals {
    double area = 0;
    std::size_t partly = 0, pieces = 0;
  };
  struct workspace {
    std::vector<vertex_index> seen;  // by old triangle: the new one that met it last
    std::vector<vertex_index> open;
    std::vector<double> values;  // of each field at the corners of a piece
  };

  void clip(vertex_index t, workspace& w, totals& sums) {
    const numbered_triangle new_one = numbered(to_, t);
    w.open.clear();
    for (const vertex_index v : new_one.v) visit(located_.triangle[v], t, w);
    double covered = 0;
    bool is_first = true;
    while (!w.open.empty()) {
      const vertex_index s = w.open.back();
      w.open.pop_back();
      const numbered_triangle old_one = numbered(from_, s);
      const overlap_signs signs(old_one, new_one);
      // Visits edge i, which leads from corner i to the next one, opposite the third.
      for (std::size_t i = 0; i < 3; ++i)
        if (const vertex_index n = links_.across(s, (i + 2) % 3);
            n != no_triangle && signs.goes_on(i))
          visit(n, t, w);
      visit_at_corners(s, t, signs, w);
      const overlap common = common_part(old_one, new_one, signs);
      if (common.count < 3) continue;
      ++sums.pieces;
      covered += add_piece(s, t, common, is_first);
      is_first = false;
    }
    sums.area += covered;
    const double area = doubled_area(to_, to_.triangles[t]) / 2;
    if (covered >= (1 - 1e-6) * area) return;
    ++sums.partly;
    take_corners(t, area);
  }

  // Visits the triangles that share the place of a corner with s, if it is on an edge or a vertex
  // of s: the triangle found for a corner may only touch the new one.
  void visit_at_corners(vertex_index s, vertex_index t, const overlap_signs& signs,
                        workspace& w) const {
    for (std::size_t c = 0; c < 3; ++c) {
      std::array<bool, 3> on{};
      bool is_in = true;
      for (std::size_t e = 0; e < 3; ++e) {
        on[e] = signs.new_against[e][c] == sign::zero;
        is_in = is_in && signs.new_against[e][c] != sign::negative;
      }
      if (!is_in) continue;
      for (std::size_t e = 0; e < 3; ++e) {
        if (!on[e]) continue;
        if (const vertex_index n = links_.across(s, (e + 2) % 3); n != no_triangle) visit(n, t, w);
        if (!on[(e + 1) % 3]) continue;  // both edges at the end of this one: it is that corner
        for (const incidence& at : links_.around(from_.triangles[s][(e + 1) % 3]))
          visit(at.triangle, t, w);
      }
    }
  }

  static void visit(vertex_index s, vertex_index t, workspace& w) {
    if (w.seen[s] == t) return;
    w.seen[s] = t;
    w.open.push_back(s);
  }

  // Adds the integrals over a common part, as a fan around its first corner. Returns its area.
  double add_piece(vertex_index s, vertex_index t, const overlap& common, bool is_first) {
    const auto& c = common.corners;
    double area = 0;
    for (std::size_t k = 1; k + 1 < common.count; ++k) {
      const point &p = c[0].at, &q = c[k].at, &r = c[k + 1].at;
      const double doubled = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
      area += doubled / 2;
      std::array<std::array<double, 3>, 3> hats{};
      for (std::size_t i = 0; i < 3; ++i)
        hats[i] = {c[0].in_new[i], c[k].in_new[i], c[k + 1].in_new[i]};
      local_mass& m = made_.mass[t];
      for (std::size_t i = 0; i < 3; ++i) {
        m[i] += product_integral(doubled, hats[i], hats[i]);
        m[3 + i] += product_integral(doubled, hats[(i + 1) % 3], hats[(i + 2) % 3]);
      }
      for (std::size_t f = 0; f < fields_.size(); ++f) {
        const std::array<double, 3> u = {value(f, s, c[0]), value(f, s, c[k]),
                                         value(f, s, c[k + 1])};
        local_load& load = made_.load[f][t];
        for (std::size_t i = 0; i < 3; ++i)
          load.of_corner[i] += product_integral(doubled, u, hats[i]);
      }
    }
    for (std::size_t f = 0; f < fields_.size(); ++f)
      for (std::size_t k = 0; k < common.count; ++k) {
        const double u = value(f, s, c[k]);
        local_load& load = made_.load[f][t];
        const bool begins = is_first && k == 0;
        load.least = begins ? u : std::min(load.least, u);
        load.greatest = begins ? u : std::max(load.greatest, u);
      }
    return area;
  }

  double value(std::size_t f, vertex_index s, const overlap_corner& c) const {
    const triangle& v = from_.triangles[s];
    const std::vector<double>& u = fields_[f].values;
    const auto [low, high] = std::minmax({u[v[0]], u[v[1]], u[v[2]]});
    return std::clamp(c.in_old[0] * u[v[0]] + c.in_old[1] * u[v[1]] + c.in_old[2] * u[v[2]], low,
                      high);
  }

  void take_corners(vertex_index t, double area) {
    const triangle& v = to_.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) {
      made_.mass[t][i] = area / 6;
      made_.mass[t][3 + i] = area / 12;
    }
    for (std::size_t f = 0; f < fields_.size(); ++f) {
      const std::array<double, 3> u = {at_[f][v[0]], at_[f][v[1]], at_[f][v[2]]};
      local_load& load = made_.load[f][t];
      for (std::size_t i = 0; i < 3; ++i)
        load.of_corner[i] = area / 12 * (u[0] + u[1] + u[2] + u[i]);
      load.least = std::min({u[0], u[1], u[2]});
      load.greatest = std::max({u[0], u[1], u[2]});
    }
  }

  const mesh& from_;
  const mesh_links& links_;
  const std::vector<nodal_values>& fields_;
  const mesh& to_;
  const located_vertices& located_;
  const std::vector<std::vector<double>>& at_;
  supermesh made_;
};

}  // namespace

supermesh intersect_meshes(const mesh& from, const mesh_links& links,
                           const std::vector<nodal_values>& fields, const mesh& to,
                           const located_vertices& located,
                           const std::vector<std::vector<double>>& at_vertices) {
  return clipper(from, links, fields, to, located, at_vertices).run();
}

}  // namespace asterism::internal
