// SPDX-License-Identifier: MIT
//
// Meshes for the tests of formats and pictures: valid ones whose numbers need all their digits.
#pragma once

#include <cmath>
#include <map>
#include <utility>

#include "asterism/mesh/data/mesh.hpp"

namespace asterism::tests {

// Adds the triangles of n x n cells, two of each, and the boundary edges, marked 1 to 4 from below
// to the left. `at(i, j)` is the site in column i of row j.
template <class At>
void add_cells(vertex_index n, const At& at, mesh& m) {
  for (vertex_index j = 0; j < n; ++j)
    for (vertex_index i = 0; i < n; ++i) {
      m.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      m.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  for (vertex_index k = 0; k < n; ++k) {
    m.boundary.push_back({at(k, 0), at(k + 1, 0), 0, 1});
    m.boundary.push_back({at(n, k), at(n, k + 1), 1, 2});
    m.boundary.push_back({at(n - k, n), at(n - k - 1, n), 2, 3});
    m.boundary.push_back({at(0, n - k), at(0, n - k - 1), 3, 4});
  }
}

// Makes n x n cells on [-1,1]^2, each cut into two triangles, with the inner sites moved slightly.
// The given sites are the four corners; the metric is I + 12 p p^T.
inline mesh sample_mesh(vertex_index n) {
  mesh m;
  std::map<std::pair<vertex_index, vertex_index>, vertex_index> number;
  const auto add = [&](vertex_index i, vertex_index j) {
    if (number.count({i, j}) != 0) return;
    const bool inner = i > 0 && j > 0 && i < n && j < n;
    const double shift = inner ? 0.2 / n : 0;
    const point p{-1 + 2.0 * i / n + shift * std::sqrt((i * 7 + j * 3) % 5),
                  -1 + 2.0 * j / n + shift * std::sqrt((i * 2 + j * 5) % 7) / 2};
    number[{i, j}] = static_cast<vertex_index>(m.sites.size());
    m.sites.push_back({p, {1 + 12 * p.x * p.x, 12 * p.x * p.y, 1 + 12 * p.y * p.y}});
  };
  for (const auto& [i, j] : {std::pair{vertex_index{0}, vertex_index{0}}, {n, 0}, {n, n}, {0, n}})
    add(i, j);
  m.given = 4;
  for (vertex_index j = 0; j <= n; ++j)
    for (vertex_index i = 0; i <= n; ++i) add(i, j);
  const auto at = [&](vertex_index i, vertex_index j) { return number.at({i, j}); };
  add_cells(n, at, m);
  return m;
}

// Makes the same mesh, its diagonal an internal segment marked 5, the triangles above it in region
// 2, those below in region -7.
inline mesh divided_mesh(vertex_index n) {
  mesh m = sample_mesh(n);
  for (std::size_t t = 0; t < m.triangles.size(); t += 2) {
    const auto cell = static_cast<vertex_index>(t / 2);
    m.regions.push_back(cell % n >= cell / n ? -7 : 2);
    m.regions.push_back(cell % n > cell / n ? -7 : 2);
    if (cell % n == cell / n)
      m.boundary.push_back({m.triangles[t][0], m.triangles[t][2], 4, 5, true});
  }
  return m;
}

}  // namespace asterism::tests
