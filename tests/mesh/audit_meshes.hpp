// SPDX-License-Identifier: MIT
//
// Small meshes built by hand, which the tests of the auditor then spoil.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "asterism/mesh/audit.hpp"
#include "asterism/mesh/mesh.hpp"

namespace asterism::test {

inline constexpr metric_tensor round_metric = {1, 0, 1};

// splitmix64, for coordinates that are the same everywhere.
class small_generator {
 public:
  explicit small_generator(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(next() >> 11) * 0x1p-53;
  }

 private:
  std::uint64_t state_;
};

struct patch {
  mesh m;
  domain d;
  int n = 0;
  std::vector<index> number;  // of lattice point (i, j), at i + j (n + 1)

  index at(int i, int j) const { return number[static_cast<std::size_t>(i + j * (n + 1))]; }
};

// A parallelogram of n x n cells with corners (0,0), (n,0), (3n/2, 7n/8), (n/2, 7n/8), each cell
// cut into two nearly equilateral triangles; inner points moved by up to `jitter`. The corners are
// the vertices given. Delaunay for jitter up to 0.1.
patch make_patch(int n, double jitter = 0.05, const metric_tensor& metric = round_metric);

// The same under the linear map that takes p to (p.x, stretch p.y), in the metric that undoes it.
patch stretched(patch p, double stretch);

// Sites with the round metric, triangles counted from 0, and every edge without a neighbour as
// boundary.
mesh make_mesh_of(const std::vector<point>& points, const std::vector<triangle>& triangles);

bool found(const audit_report& report, finding_kind kind);
// All witnesses of the kind, a line each.
std::string witnesses(const audit_report& report, finding_kind kind);
// Names of the kinds found, for messages of failing tests.
std::string kinds(const audit_report& report);

}  // namespace asterism::test
