// SPDX-License-Identifier: MIT
#include "asterism/mesh/adapt/sampled_background.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>
#include <vector>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/adapt/nodal_gradation.hpp"
#include "asterism/mesh/numerics/metric_algebra.hpp"

namespace asterism::internal::adapting {
namespace {

double length(const metric_tensor& m, const point& p, const point& q) {
  return std::sqrt(std::max(0.0, squared(m, q.x - p.x, q.y - p.y)));
}

// How many faces are announced to the field at once. Those that change before their turn are asked
// about one by one: of 41,158 questions on a front 1,483 with 16 at once, in 860 announcements;
// 2,316 in 290 with 48; 3,129 in 112 with 128; 6,227 in 13 with all that wait.
constexpr std::size_t announced_together = 32;

class sampling {
 public:
  sampling(working_mesh m, const metric_field& field, const sampling_limits& limits)
      : m_(std::move(m)), field_(field), limits_(limits) {
    const bounding_box box = m_.shape().box();
    const double extent = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
    longest_ = limits.part_of_domain * extent;
    shortest_ = 0x1p-40 * extent;
  }

  std::optional<mesh> run() {
    field_.expect([this] { return places_of_nodes(); });
    for (vertex_index v = 0; v < m_.nodes().size(); ++v)
      if (!measure(v)) return std::nullopt;
    std::deque<vertex_index> waiting;
    for (vertex_index t = 0; t < m_.faces().size(); ++t) waiting.push_back(t);
    constexpr std::size_t asked_between = 1024;
    std::size_t expected = 0;  // of those that wait, the first
    for (std::size_t i = 1; !waiting.empty() && m_.nodes().size() < limits_.most_nodes; ++i) {
      if (i % asked_between == 0 && limits_.stop.is_requested()) break;
      if (expected == 0) {
        expected = std::min(waiting.size(), announced_together);
        field_.expect([&] { return middles_of(waiting, expected); });
      }
      const vertex_index t = waiting.front();
      waiting.pop_front();
      --expected;
      if (!refine(t, waiting)) return std::nullopt;
    }
    std::vector<vertex_index> renumbered;
    return m_.triangulation(renumbered);
  }

 private:
  bool measure(vertex_index v) {
    const auto there = field_.at(m_.at(v).position);
    if (there) m_.set_metric(v, there.value());
    return there.ok();
  }

  std::vector<point> places_of_nodes() const {
    std::vector<point> places;
    for (const node& n : m_.nodes()) places.push_back(n.position);
    return places;
  }

  // Returns the middles of the edges of the first faces; edges that two of them share come twice.
  std::vector<point> middles_of(const std::deque<vertex_index>& faces, std::size_t count) const {
    std::vector<point> places;
    for (std::size_t k = 0; k < count; ++k) {
      const face& f = m_.faces()[faces[k]];
      if (!f.exists()) continue;
      for (std::size_t i = 0; i < 3; ++i)
        places.push_back(middle(m_.at(f.v[after(i)]).position, m_.at(f.v[before(i)]).position));
    }
    return places;
  }

  static point middle(const point& p, const point& q) {
    return {p.x + (q.x - p.x) / 2, p.y + (q.y - p.y) / 2};
  }

  // Edge of a face, as the metric at its ends and half way measures it.
  struct measured_edge {
    metric_tensor between;
    double length = 0;
    bool is_to_be_halved = false;
  };

  // Returns nothing where the metric fails.
  std::optional<measured_edge> measured(const node& a, const node& b) const {
    const point &p = a.position, &q = b.position;
    const auto sampled = field_.at(middle(p, q));
    if (!sampled) return std::nullopt;
    measured_edge e{sampled.value(), 0, false};
    e.length = std::max({length(a.metric, p, q), length(b.metric, p, q), length(e.between, p, q)});
    const double in_plane = elementary::hypot(q.x - p.x, q.y - p.y);
    e.is_to_be_halved =
        in_plane > longest_ ||
        (in_plane > shortest_ && (e.length > limits_.longest ||
                                  (e.length > limits_.shortest && is_off(a.metric, b.metric, e))));
    return e;
  }

  // True if the metric half way is too far from the one interpolated there.
  bool is_off(const metric_tensor& a, const metric_tensor& b, const measured_edge& e) const {
    const tensor_logarithm from = logarithm(a), to = logarithm(b);
    const metric_tensor interpolated =
        exponential({(from.l11 + to.l11) / 2, (from.l12 + to.l12) / 2, (from.l22 + to.l22) / 2});
    return !(log_distortion(interpolated, e.between) <= limits_.difference);
  }

  metric_tensor mean_of(const face& f) const {
    tensor_logarithm mean;
    for (const vertex_index v : f.v) {
      const tensor_logarithm l = logarithm(m_.at(v).metric);
      mean = {mean.l11 + l.l11 / 3, mean.l12 + l.l12 / 3, mean.l22 + l.l22 / 3};
    }
    return exponential(mean);
  }

  // Halves the longest edge of the face if one of the three is to be halved. The longest as one
  // metric measures all three, since triangles would get flat otherwise. Returns false where the
  // metric fails.
  bool refine(vertex_index t, std::deque<vertex_index>& waiting) {
    const face f = m_.faces()[t];
    if (!f.exists()) return true;
    const metric_tensor mean = mean_of(f);
    bool any = false;
    std::size_t longest = 0;
    double greatest = 0;
    metric_tensor between;
    for (std::size_t i = 0; i < 3; ++i) {
      const node &a = m_.at(f.v[after(i)]), &b = m_.at(f.v[before(i)]);
      const auto e = measured(a, b);
      if (!e) return false;
      any = any || e->is_to_be_halved;
      const double l = length(mean, a.position, b.position);
      if (i > 0 && !(l > greatest)) continue;
      longest = i;
      greatest = l;
      between = e->between;
    }
    if (!any) return true;
    const point &p = m_.at(f.v[after(longest)]).position, &q = m_.at(f.v[before(longest)]).position;
    const auto made = m_.split(t, longest, middle(p, q));
    if (!made) return true;
    m_.set_metric(*made, between);
    face_list at;
    m_.around(*made, at);
    waiting.insert(waiting.end(), at.begin(), at.end());
    return true;
  }

  working_mesh m_;
  const metric_field& field_;
  const sampling_limits& limits_;
  double longest_, shortest_;  // in the plane
};

}  // namespace

std::optional<mesh> sample_background(working_mesh m, const metric_field& field,
                                      const sampling_limits& limits) {
  return sampling(std::move(m), field, limits).run();
}

}  // namespace asterism::internal::adapting
