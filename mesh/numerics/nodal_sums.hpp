// SPDX-License-Identifier: MIT
//
// Integrates over a mesh by values at its vertices, each with a third of the area of the triangles
// at it. The result is the same for any number of threads.
#pragma once

#include <cstddef>
#include <vector>

#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/search/mesh_links.hpp"
#include "asterism/mesh/support/parallel.hpp"

namespace asterism::internal {

inline constexpr std::size_t nodal_chunk = 4096;

// Returns twice the area of a triangle of the mesh, negative for a clockwise one.
double doubled_area(const mesh& m, const triangle& t);

// Returns the area that belongs to each vertex.
std::vector<double> nodal_areas(const mesh& m, const mesh_links& links);

// Returns the sum of value(v) over [0, count): chunk by chunk, then the chunks' sums in order.
template <class Value>
double ordered_sum(std::size_t count, const Value& value) {
  const auto sum_of = [&value](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t v = begin; v < end; ++v) sum += value(v);
    return sum;
  };
  double sum = 0;
  for (const double part : map_chunks<double>(count, nodal_chunk, sum_of)) sum += part;
  return sum;
}

// Calls work(v) for each v in [0, count), in any order.
template <class Work>
void for_each_node(std::size_t count, const Work& work) {
  if (count == 0) return;
  parallel_chunks(count, nodal_chunk, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) work(v);
  });
}

}  // namespace asterism::internal
