// SPDX-License-Identifier: MIT
#include "asterism/mesh/search/mesh_links.hpp"

#include <algorithm>

#include "asterism/mesh/support/parallel.hpp"

namespace asterism::internal {
namespace {

constexpr std::size_t chunk = 8192;

// Lists the vertices that triangles at v have in addition to v, each once, ascending.
void gather_neighbours(const std::vector<triangle>& triangles, std::span<const incidence> around,
                       std::vector<vertex_index>& found) {
  found.clear();
  for (const incidence& at : around) {
    const triangle& t = triangles[at.triangle];
    found.push_back(t[(at.corner + 1) % 3]);
    found.push_back(t[(at.corner + 2) % 3]);
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
}

}  // namespace

mesh_links::mesh_links(std::size_t vertices, const std::vector<triangle>& triangles, lists wanted)
    : first_corner_(vertices + 1, 0),
      first_neighbour_(vertices + 1, 0),
      across_(triangles.size()),
      on_boundary_(vertices, 0) {
  list_corners(triangles);
  find_across(triangles);
  if (wanted == lists::all) list_neighbours(triangles);
}

void mesh_links::list_corners(const std::vector<triangle>& triangles) {
  for (const triangle& t : triangles)
    for (const vertex_index v : t) ++first_corner_[v + 1];
  for (std::size_t v = 1; v < first_corner_.size(); ++v) first_corner_[v] += first_corner_[v - 1];
  corners_.resize(3 * triangles.size());
  std::vector<std::size_t> next(first_corner_.begin(), first_corner_.end() - 1);
  for (vertex_index t = 0; t < triangles.size(); ++t)
    for (std::uint32_t i = 0; i < 3; ++i) corners_[next[triangles[t][i]]++] = {t, i};
}

void mesh_links::find_across(const std::vector<triangle>& triangles) {
  parallel_chunks(triangles.size(), chunk, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        const vertex_index a = triangles[t][(i + 1) % 3], b = triangles[t][(i + 2) % 3];
        across_[t][i] = no_triangle;
        // Finds the triangle across the edge a -> b: the one with the edge b -> a.
        for (const incidence& at : around(b))
          if (triangles[at.triangle][(at.corner + 1) % 3] == a) across_[t][i] = at.triangle;
      }
  });
  parallel_chunks(vertices(), chunk, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const auto at_v = around(static_cast<vertex_index>(v));
      on_boundary_[v] = at_v.empty() ? 1 : 0;
      for (const incidence& at : at_v)
        for (std::size_t i = 1; i < 3; ++i)
          if (across_[at.triangle][(at.corner + i) % 3] == no_triangle) on_boundary_[v] = 1;
    }
  });
}

void mesh_links::list_neighbours(const std::vector<triangle>& triangles) {
  parallel_chunks(vertices(), chunk, [&](std::size_t, std::size_t begin, std::size_t end) {
    std::vector<vertex_index> found;
    for (std::size_t v = begin; v < end; ++v) {
      gather_neighbours(triangles, around(static_cast<vertex_index>(v)), found);
      first_neighbour_[v + 1] = found.size();
    }
  });
  for (std::size_t v = 1; v < first_neighbour_.size(); ++v)
    first_neighbour_[v] += first_neighbour_[v - 1];
  neighbours_.resize(first_neighbour_.back());
  parallel_chunks(vertices(), chunk, [&](std::size_t, std::size_t begin, std::size_t end) {
    std::vector<vertex_index> found;
    for (std::size_t v = begin; v < end; ++v) {
      gather_neighbours(triangles, around(static_cast<vertex_index>(v)), found);
      std::copy(found.begin(), found.end(),
                neighbours_.begin() + static_cast<std::ptrdiff_t>(first_neighbour_[v]));
    }
  });
}

}  // namespace asterism::internal
