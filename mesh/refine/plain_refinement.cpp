// SPDX-License-Identifier: MIT
#include "asterism/mesh/refine/plain_refinement.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

#include "asterism/core/plane_algebra.hpp"
#include "asterism/kernels/vertex_hints.hpp"
#include "asterism/mesh/numerics/ill_conditioned_metric.hpp"
#include "asterism/mesh/stars/mean_metric_net.hpp"

namespace asterism::internal {
namespace {

// Returns the Voronoi vertex of three sites that is near them; none where Newton's method finds
// none, or a metric is thin.
std::optional<point> near_vertex(const triangle_sites& t) {
  if (std::any_of(t.begin(), t.end(), [](const site& s) { return is_thin(s.metric); }))
    return std::nullopt;
  const auto d = numeric::voronoi_vertex_near(t[0], t[1], t[2]);
  if (!d) return std::nullopt;
  const auto seen = apply(t[0].metric, *d);
  const bool is_near = dot(seen, between(t[0].position, t[1].position)) > 0 &&
                       dot(seen, between(t[0].position, t[2].position)) > 0;
  if (!is_near) return std::nullopt;
  return point{t[0].position.x + d->x, t[0].position.y + d->y};
}

class plain_refinement {
 public:
  plain_refinement(refine_state& state, const angle_requirement& angle, double tolerance,
                   const cancellation& cancelled, mean_metric_net& net)
      : state_(state),
        angle_(angle),
        tolerance_(tolerance),
        cancelled_(cancelled),
        net_(net),
        on_boundary_(state.sites().size(), 0),
        at_tight_corner_(state.sites().size(), 0) {
    for (const boundary_edge& e : state.edges().subsegments())
      on_boundary_[e.a] = on_boundary_[e.b] = 1;
    for (const domain_corner& c : state.segments().corners())
      if (c.angle < 2 * angle.degrees()) at_tight_corner_[c.vertex] = 1;
  }

  void run() {
    for (std::uint32_t face = 0; face < net_.faces(); ++face) judge(face);
    constexpr std::size_t at_a_time = 64;
    for (std::size_t tried = 0; !bad_.empty() && !state_.is_full(); ++tried) {
      if (tried % at_a_time == 0 && (state_.is_overworked() || cancelled_.is_requested())) return;
      const bad_face worst = bad_.top();
      bad_.pop();
      if (net_.corners(worst.face) != worst.where) continue;  // it has gone
      mend(worst);
      if (state_.field_failure()) return;
    }
  }

 private:
  struct bad_face {
    double angle;
    triangle where;
    std::uint32_t face;
    // Orders as a queue wants it that gives the smallest angle first.
    bool operator<(const bad_face& other) const {
      return std::tie(angle, where) > std::tie(other.angle, other.where);
    }
  };

  // Puts a face with a low angle into the queue, unless it is for the stars: at a corner that must
  // not be divided, or with nothing but the boundary around.
  void judge(std::uint32_t face) {
    if (!net_.is_inside(face)) return;
    const triangle t = net_.corners(face);
    const auto is_marked = [&](const std::vector<char>& marks) {
      return [&marks](vertex_index v) { return v < marks.size() && marks[v] != 0; };
    };
    if (std::any_of(t.begin(), t.end(), is_marked(at_tight_corner_)) ||
        std::all_of(t.begin(), t.end(), is_marked(on_boundary_)))
      return;
    const triangle_sites sites = sites_of(t);
    if (angle_.is_low(sites)) bad_.push({smallest_angle(sites), t, face});
  }

  triangle_sites sites_of(const triangle& t) const {
    return {state_.sites()[t[0]], state_.sites()[t[1]], state_.sites()[t[2]]};
  }

  void mend(const bad_face& worst) {
    state_.count_triangle_tried();
    const auto q = near_vertex(sites_of(worst.where));
    const auto at = q ? net_.locate(*q, worst.face) : std::nullopt;
    const auto s = at ? state_.site_at(*q) : std::nullopt;
    if (!s || !state_.is_farther(*s, tolerance_) || !state_.encroached_by(*s).empty()) return;
    state_.add_interior_later(*s);
    around_.clear();
    net_.insert(*s, *at, around_);
    for (const std::uint32_t face : around_) judge(face);
  }

  refine_state& state_;
  const angle_requirement& angle_;
  double tolerance_;
  const cancellation& cancelled_;
  mean_metric_net& net_;
  std::vector<char> on_boundary_, at_tight_corner_;  // by site, of those there were
  std::priority_queue<bad_face> bad_;
  std::vector<std::uint32_t> around_;  // scratch
};

}  // namespace

neighbour_lists refine_plainly(refine_state& state, const angle_requirement& angle,
                               double tolerance, const cancellation& cancelled) {
  auto net = mean_metric_net::make(state.oracle(), cancelled);
  if (!net) return {};
  plain_refinement(state, angle, tolerance, cancelled, *net).run();
  return net->settled_neighbours();
}

}  // namespace asterism::internal
