// SPDX-License-Identifier: MIT
#include "asterism/mesh/adapt/sampled_background.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <unordered_map>
#include <utility>
#include <vector>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/gradation/nodal_gradation.hpp"
#include "asterism/mesh/numerics/metric_algebra.hpp"
#include "asterism/mesh/numerics/metric_length.hpp"

namespace asterism::internal::adapting {
namespace {

double length(const metric_tensor& m, const point& p, const point& q) {
  return plain_length(m, {q.x - p.x, q.y - p.y});
}

// Number of faces announced to the field at once. Edges created before the next announcement are
// evaluated one by one: of 13,855 evaluations on a front 2,000 with 32 at once, in 432
// announcements; 2,440 in 218 with 64; 2,870 in 147 with 96; 2,956 in 91 with 160. The sum of both
// is the cost of a field that is called from another language.
constexpr std::size_t announced_together = 32;

class sampling {
 public:
  sampling(editable_mesh m, const metric_field& field, const sampling_limits& limits)
      : m_(std::move(m)), field_(field), limits_(limits) {
    const bounding_box box = m_.shape().box();
    const double extent = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
    longest_ = limits.part_of_domain * extent;
    shortest_ = 0x1p-40 * extent;
  }

  std::optional<sampled_background> run() {
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
    return sampled_background{m_.triangulation(renumbered), longest_left_};
  }

 private:
  bool measure(vertex_index v) {
    const auto there = field_.at(m_.at(v).position);
    if (there) set_metric(v, there.value());
    return there.ok();
  }

  void set_metric(vertex_index v, const metric_tensor& there) {
    m_.set_metric(v, there);
    if (logarithms_.size() <= v) logarithms_.resize(v + 1);
    logarithms_[v] = logarithm(there);
  }

  std::vector<point> places_of_nodes() const {
    std::vector<point> places;
    for (const node& n : m_.nodes()) places.push_back(n.position);
    return places;
  }

  // Returns the middles of those edges of the first faces that were not measured yet; the middle of
  // a shared edge is listed twice.
  std::vector<point> middles_of(const std::deque<vertex_index>& faces, std::size_t count) const {
    std::vector<point> places;
    for (std::size_t k = 0; k < count; ++k) {
      const face& f = m_.faces()[faces[k]];
      if (!f.exists()) continue;
      for (std::size_t i = 0; i < 3; ++i)
        if (edges_.count(name_of(f.v[after(i)], f.v[before(i)])) == 0)
          places.push_back(middle(f.v[after(i)], f.v[before(i)]));
    }
    return places;
  }

  // Returns the midpoint of an edge; the same bits for (b, a).
  point middle(vertex_index a, vertex_index b) const {
    const point &p = m_.at(std::min(a, b)).position, &q = m_.at(std::max(a, b)).position;
    return {p.x + (q.x - p.x) / 2, p.y + (q.y - p.y) / 2};
  }

  static std::uint64_t name_of(vertex_index a, vertex_index b) {
    return std::uint64_t{std::min(a, b)} << 32U | std::max(a, b);
  }

  // Edge of a face, with its lengths in the metrics at its ends and half way.
  struct measured_edge {
    metric_tensor between;
    double length = 0;
    bool is_to_be_halved = false;
  };

  // Measures an edge once, when it is first needed. Returns nothing where the metric fails.
  const measured_edge* measured(vertex_index a, vertex_index b) {
    const auto [at, is_new] = edges_.try_emplace(name_of(a, b));
    measured_edge& e = at->second;
    if (!is_new) return &e;
    const point &p = m_.at(a).position, &q = m_.at(b).position;
    const metric_tensor &from = m_.at(a).metric, &to = m_.at(b).metric;
    const auto sampled = field_.at(middle(a, b));
    if (!sampled) return nullptr;
    e.between = sampled.value();
    e.length = std::max({length(from, p, q), length(to, p, q), length(e.between, p, q)});
    const double in_plane = elementary::hypot(q.x - p.x, q.y - p.y);
    e.is_to_be_halved =
        in_plane > longest_ ||
        (in_plane > shortest_ &&
         (e.length > limits_.longest || (e.length > limits_.shortest && is_off(a, b, e))));
    if (!e.is_to_be_halved) longest_left_ = std::max(longest_left_, e.length);
    return &e;
  }

  // True if the metric half way differs too much from the one interpolated there.
  bool is_off(vertex_index a, vertex_index b, const measured_edge& e) const {
    const tensor_logarithm &from = logarithms_[a], &to = logarithms_[b];
    const metric_tensor interpolated =
        exponential({(from.l11 + to.l11) / 2, (from.l12 + to.l12) / 2, (from.l22 + to.l22) / 2});
    return !(log_distortion(interpolated, e.between) <= limits_.difference);
  }

  metric_tensor mean_of(const face& f) const {
    tensor_logarithm mean;
    for (const vertex_index v : f.v) {
      const tensor_logarithm& l = logarithms_[v];
      mean = {mean.l11 + l.l11 / 3, mean.l12 + l.l12 / 3, mean.l22 + l.l22 / 3};
    }
    return exponential(mean);
  }

  // Returns the longest edge of a face, in the mean of the corners' metrics.
  std::size_t longest_edge(const face& f) const {
    const metric_tensor mean = mean_of(f);
    std::array<double, 3> lengths{};
    for (std::size_t i = 0; i < 3; ++i)
      lengths[i] = length(mean, m_.at(f.v[after(i)]).position, m_.at(f.v[before(i)]).position);
    return static_cast<std::size_t>(std::max_element(lengths.begin(), lengths.end()) -
                                    lengths.begin());
  }

  // Halves the longest edge of the face if any of its edges is to be halved: halving another one
  // would make triangles flat. Returns false where the metric fails.
  bool refine(vertex_index t, std::deque<vertex_index>& waiting) {
    const face f = m_.faces()[t];
    if (!f.exists()) return true;
    bool any = false;
    std::array<metric_tensor, 3> between;
    for (std::size_t i = 0; i < 3; ++i) {
      const measured_edge* e = measured(f.v[after(i)], f.v[before(i)]);
      if (e == nullptr) return false;
      any = any || e->is_to_be_halved;
      between[i] = e->between;
    }
    if (!any) return true;
    const std::size_t longest = longest_edge(f);
    const auto made = m_.split(t, longest, middle(f.v[after(longest)], f.v[before(longest)]));
    if (!made) return true;
    set_metric(*made, between[longest]);
    face_list at;
    m_.around(*made, at);
    waiting.insert(waiting.end(), at.begin(), at.end());
    return true;
  }

  editable_mesh m_;
  const metric_field& field_;
  const sampling_limits& limits_;
  double longest_, shortest_;                 // in the plane
  double longest_left_ = 0;                   // as the metric measures
  std::vector<tensor_logarithm> logarithms_;  // by node
  // Edges that were measured, by their ends, which never change.
  std::unordered_map<std::uint64_t, measured_edge> edges_;
};

}  // namespace

std::optional<sampled_background> sample_background(editable_mesh m, const metric_field& field,
                                                    const sampling_limits& limits) {
  return sampling(std::move(m), field, limits).run();
}

}  // namespace asterism::internal::adapting
