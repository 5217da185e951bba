// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric/interpolated_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "asterism/mesh/data/site_box.hpp"
#include "asterism/mesh/metric/sized_field.hpp"
#include "asterism/mesh/numerics/metric_algebra.hpp"
#include "asterism/mesh/search/box_index.hpp"

namespace asterism {
using namespace internal;
namespace {

using weights = std::array<double, 3>;

double doubled_area(const point& a, const point& b, const point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

class sampled_field final : public sized_field {
 public:
  sampled_field(const mesh& m, double size)
      : sized_field(size),
        sites_(m.sites),
        triangles_(m.triangles),
        box_(box_of_sites(m.sites)),
        boxes_(box_) {
    logarithms_.reserve(sites_.size());
    for (const site& s : sites_) logarithms_.push_back(logarithm(s.metric));
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      const auto [a, b, c] = corners(t);
      if (!(doubled_area(a, b, c) > 0)) continue;
      bounding_box around = box_of(a, b);
      around.include(c);
      boxes_.insert(t, around);
    }
    given_.sites = sites_;
    given_.triangles = triangles_;
    const double squared = size_squared();
    for (site& s : given_.sites)
      s.metric = {s.metric.m11 / squared, s.metric.m12 / squared, s.metric.m22 / squared};
  }

  const mesh* background() const override { return &given_; }

 private:
  result<metric_tensor> unsized(const point& q) const override {
    const found best = locate(q);
    for (const vertex_index v : triangles_[best.triangle])
      if (sites_[v].position == q) return sites_[v].metric;
    return mean(triangles_[best.triangle], best.where);
  }

  struct found {
    std::uint32_t triangle = 0;
    weights where{1, 0, 0};
    double depth = -std::numeric_limits<double>::infinity();  // the least weight
  };

  std::array<point, 3> corners(std::uint32_t t) const {
    const triangle& c = triangles_[t];
    return {sites_[c[0]].position, sites_[c[1]].position, sites_[c[2]].position};
  }

  // Looks around the point first, then farther and farther; the whole box, doubled, has triangles
  // in it.
  found locate(const point& q) const {
    const double extent =
        std::max(box_.high.x / 2 - box_.low.x / 2, box_.high.y / 2 - box_.low.y / 2);
    found best = look_around(q, 0);
    constexpr int most_doublings = 64;
    double half = std::ldexp(extent, -50);
    for (int i = 0; i < most_doublings && best.depth == -std::numeric_limits<double>::infinity();
         ++i, half *= 2)
      best = look_around(q, half);
    return best;
  }

  found look_around(const point& q, double half) const {
    found best;
    const bounding_box window{{q.x - half, q.y - half}, {q.x + half, q.y + half}};
    boxes_.visit(window, [&](std::uint32_t t) {
      take_if_deeper(q, t, best);
      return true;
    });
    return best;
  }

  // Takes the triangle if q is deeper inside it than in the best one, or as deep and it is before
  // that. The first weight that is less than the depth there is settles it.
  void take_if_deeper(const point& q, std::uint32_t t, found& best) const {
    const auto [a, b, c] = corners(t);
    const double whole = doubled_area(a, b, c);
    weights w{doubled_area(q, b, c) / whole, 0, 0};
    if (w[0] < best.depth) return;
    w[1] = doubled_area(a, q, c) / whole;
    if (w[1] < best.depth) return;
    w[2] = doubled_area(a, b, q) / whole;
    const double depth = std::min({w[0], w[1], w[2]});
    if (depth > best.depth || (depth == best.depth && t < best.triangle)) best = {t, w, depth};
  }

  metric_tensor mean(const triangle& t, weights w) const {
    double sum = 0;
    for (double& x : w) sum += x = std::max(0.0, x);
    tensor_logarithm l;
    for (std::size_t i = 0; i < 3; ++i) {
      const tensor_logarithm& own = logarithms_[t[i]];
      l.l11 += w[i] / sum * own.l11;
      l.l12 += w[i] / sum * own.l12;
      l.l22 += w[i] / sum * own.l22;
    }
    return exponential(l);
  }

  mesh given_;
  std::vector<site> sites_;
  std::vector<triangle> triangles_;
  std::vector<tensor_logarithm> logarithms_;
  bounding_box box_;
  box_index boxes_;
};

}  // namespace

std::unique_ptr<metric_field> make_sampled_field(const mesh& m, double size) {
  return std::make_unique<sampled_field>(m, size);
}

}  // namespace asterism
