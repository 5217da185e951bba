// SPDX-License-Identifier: MIT
//
// Moves the sites of a fill toward the middle of their neighbours.
#include "asterism/mesh/fill/relaxation.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/fill/domain_locator.hpp"
#include "asterism/mesh/fill/fill.hpp"
#include "asterism/mesh/mesher.hpp"
#include "asterism/mesh/numerics/constructions.hpp"

using namespace asterism;
using namespace asterism::internal;

namespace {

filled_domain filled(const domain& d, const char* metric, double size) {
  const auto field = make_metric_field(metric, d.box(), size);
  REQUIRE(field.ok());
  auto made = fill(d, *field.value(), {});
  REQUIRE(made.ok());
  REQUIRE(made.value().complete);
  return std::move(made).value();
}

// Returns the sites in the order of the numbers that the lists of neighbours use.
std::vector<site> all_sites(const domain& d, const char* metric, double size,
                            const filled_domain& of) {
  const auto field = make_metric_field(metric, d.box(), size);
  std::vector<site> sites;
  for (const point& q : d.vertices) sites.push_back({q, field.value()->at(q).value()});
  for (const auto& division : of.divisions)
    sites.insert(sites.end(), division.begin(), division.end());
  sites.insert(sites.end(), of.interior.begin(), of.interior.end());
  return sites;
}

}  // namespace

TEST_CASE("sites that moved keep the distance of the fill, in one metric") {
  const domain d = square();
  const filled_domain made = filled(d, "identity", 0.05);
  const std::vector<site> sites = all_sites(d, "identity", 0.05, made);
  const std::size_t first = sites.size() - made.interior.size();
  double least = 1;
  for (std::size_t v = first; v < sites.size(); ++v)
    for (std::size_t w = 0; w < sites.size(); ++w)
      if (v != w) least = std::min(least, squared_distance(sites[v], sites[w].position));
  CHECK(std::sqrt(least) > 0.75 - 1e-9);
}

TEST_CASE("edges between sites that moved are hardly longer than between sites on a lattice") {
  for (const char* metric : {"identity", "sink:12", "swirl:12"}) {
    CAPTURE(metric);
    const domain d = square();
    const double size = 0.04;
    const filled_domain made = filled(d, metric, size);
    const std::vector<site> sites = all_sites(d, metric, size, made);
    double edges = 0, sum = 0, sectors = 0;
    for (std::size_t v = sites.size() - made.interior.size(); v < sites.size(); ++v)
      for (const vertex_index w : made.stars[v]) {
        sum += std::sqrt(squared_distance(sites[v], sites[w].position));
        edges += 1;
      }
    // Sums the areas of stars. A third of each belongs to its centre.
    double area = 0;
    for (std::size_t v = sites.size() - made.interior.size(); v < sites.size(); ++v) {
      const auto star = made.stars[v];
      if (star.empty()) continue;
      const metric_tensor& m = sites[v].metric;
      const point& at = sites[v].position;
      double here = 0;
      for (std::size_t i = 0; i < star.size(); ++i) {
        const point &p = sites[star[i]].position, &q = sites[star[(i + 1) % star.size()]].position;
        here += ((p.x - at.x) * (q.y - at.y) - (p.y - at.y) * (q.x - at.x)) / 2;
      }
      area += here / 3 * std::sqrt(m.m11 * m.m22 - m.m12 * m.m12);
      sectors += 1;
    }
    // In an equilateral lattice with edges L each site has an area of sqrt(3)/2 L^2. The ratio was
    // 1.06 before sites moved.
    const double mean = sum / edges, of_lattice = std::sqrt(area / sectors * 2 / std::sqrt(3.0));
    CHECK(mean * mean / (of_lattice * of_lattice) < 1.045);
    CHECK(mean > of_lattice);
  }
}

TEST_CASE("sites that moved are inside the domain, and those of segments are where they were") {
  const domain d = airfoil().value();
  const domain_locator locator(d);
  const filtered_kernel kernel;
  for (const char* metric : {"identity", "sink:12", "swirl:24"}) {
    CAPTURE(metric);
    const filled_domain made = filled(d, metric, 0.1);
    REQUIRE(made.divisions.size() == d.segments.size());
    CHECK(std::all_of(made.interior.begin(), made.interior.end(),
                      [&](const site& s) { return locator.contains(kernel, s.position); }));
    for (std::size_t i = 0; i < d.segments.size(); ++i) {
      const point &a = d.vertices[d.segments[i].a], &b = d.vertices[d.segments[i].b];
      for (const site& s : made.divisions[i]) {
        const double turned =
            (b.x - a.x) * (s.position.y - a.y) - (b.y - a.y) * (s.position.x - a.x);
        CHECK(std::abs(turned) < 1e-12);
      }
    }
  }
}
