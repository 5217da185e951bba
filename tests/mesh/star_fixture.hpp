// SPDX-License-Identifier: MIT
//
// Domains, metric fields and stars for the tests of stars and refinement.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/boundary.hpp"
#include "asterism/mesh/domain.hpp"
#include "asterism/mesh/metric_field.hpp"
#include "asterism/mesh/star_kernel.hpp"
#include "asterism/mesh/star_oracle.hpp"
#include "asterism/mesh/star_set.hpp"

namespace asterism::testing {

// Adds a closed ring; counter-clockwise for an outer boundary, clockwise for a hole.
inline void add_ring(domain& d, const std::vector<point>& ring) {
  const auto start = static_cast<index>(d.vertices.size());
  const auto count = static_cast<index>(ring.size());
  for (index i = 0; i < count; ++i) {
    d.vertices.push_back(ring[i]);
    d.segments.push_back({start + i, start + (i + 1) % count, 1});
  }
}

inline domain polygon(const std::vector<point>& ring) {
  domain d;
  add_ring(d, ring);
  return d;
}

inline domain square() { return polygon({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}); }

inline domain square_with_hole() {
  domain d = square();
  add_ring(d, {{-0.3, -0.3}, {-0.3, 0.3}, {0.3, 0.3}, {0.3, -0.3}});
  d.holes.push_back({0, 0});
  return d;
}

// Ten points well inside the square; `seed` replays them.
inline domain square_with_points(std::uint64_t seed) {
  domain d = square();
  std::uint64_t state = seed * 0x9e3779b97f4a7c15u + 1;
  const auto next = [&] {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state >> 33) / 1073741824.0 * 0.9 - 0.9;
  };
  for (int i = 0; i < 10; ++i) {
    const double x = next(), y = next();
    d.vertices.push_back({x, y});
  }
  return d;
}

class formula_field final : public metric_field {
 public:
  using formula = std::function<metric_tensor(const point&)>;
  explicit formula_field(formula f) : formula_(std::move(f)) {}
  result<metric_tensor> at(const point& q) const override { return formula_(q); }

 private:
  formula formula_;
};

inline formula_field constant_field(const metric_tensor& m) {
  return formula_field([m](const point&) { return m; });
}
inline formula_field identity_field() { return constant_field({1, 0, 1}); }
// I + K p p^T and I + K n n^T, n = p turned, on [-1,1]^2.
inline formula_field swirl_field(double k) {
  return formula_field([k](const point& p) {
    return metric_tensor{1 + k * p.x * p.x, k * p.x * p.y, 1 + k * p.y * p.y};
  });
}
inline formula_field sink_field(double k) {
  return formula_field([k](const point& p) {
    return metric_tensor{1 + k * p.y * p.y, -k * p.x * p.y, 1 + k * p.x * p.x};
  });
}

// Sites of a domain and everything needed to make their stars. Not copyable: its parts refer to
// each other.
struct star_setting {
  explicit star_setting(const domain& d, const metric_tensor& metric = {1, 0, 1}) {
    for (const point& q : d.vertices) sites.push_back({q, metric});
    edges = boundary::build(d, kernel).value();
  }
  // Sites alone, no boundary: every star is a full turn.
  explicit star_setting(const std::vector<site>& all) : sites(all) {}
  star_setting(const star_setting&) = delete;
  star_setting& operator=(const star_setting&) = delete;

  site_oracle oracle() const { return {sites, edges, kernel}; }

  filtered_kernel arithmetic;
  star_kernel_on<filtered_kernel> kernel{arithmetic};
  std::vector<site> sites;
  boundary edges;
};

inline star closed_star(const std::vector<index>& neighbours) { return {{{neighbours, true}}}; }

// Turned so that the smallest index is first: closed stars may start anywhere.
inline std::vector<index> ring_of(const star& s) {
  std::vector<index> ring = s.sectors.at(0).neighbours;
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  return ring;
}

}  // namespace asterism::testing
