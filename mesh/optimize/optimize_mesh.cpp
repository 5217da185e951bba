// SPDX-License-Identifier: MIT
#include "asterism/mesh/optimize/optimize_mesh.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "asterism/mesh/metric/unit_frame.hpp"
#include "asterism/mesh/numerics/triangle_quality.hpp"
#include "asterism/mesh/optimize/mutable_mesh.hpp"
#include "asterism/mesh/optimize/smooth_and_swap.hpp"
#include "asterism/mesh/optimize/split_and_collapse.hpp"

namespace asterism::internal {
namespace {

using fitting::mutable_mesh;
using fitting::vertex_kind;
// For each segment its vertices, each with how far along the segment it is.
using divided_segments = std::vector<std::vector<std::pair<double, vertex_index>>>;

// Greatest angle aimed at, in degrees: no triangulation can have nine angles of much more in every
// triangle.
constexpr double most_degrees = 29.5;
constexpr int first_sweeps = 60, sweeps_after_surgery = 20, rounds_of_surgery = 6;

class fitter {
 public:
  fitter(mutable_mesh& m, const domain& d, const fitting_options& options)
      : mesh_(m), domain_(d), options_(options), moves_(m, options.stop) {}

  void run() {
    for (const bool stars : {false, true}) {
      mesh_.judge_stars(stars);
      for (int i = 0; i < first_sweeps; ++i)
        if (!sweep(0.4 / (1 + 0.1 * (i % sweeps_after_surgery)))) return;
      if (!operate()) return;
    }
  }

  // Returns the result, in the mesh's own coordinates.
  fitted_domain conclude() {
    count_low();
    found_.moves = moves_.moves();
    found_.flips = moves_.flips();
    found_.stopped = moves_.is_stopped();
    triangulate(divide());
    return std::move(found_);
  }

 private:
  bool sweep(double step) {
    ++found_.rounds;
    return moves_.sweep(step);
  }

  bool operate() {
    for (int round = 0; round < rounds_of_surgery; ++round) {
      count_low();
      if (found_.low == 0 && !mesh_.judges_stars()) break;
      const auto done = fitting::operate(mesh_, moves_);
      found_.collapses += done.collapsed;
      found_.insertions += done.split;
      for (int i = 0; i < sweeps_after_surgery; ++i)
        if (!sweep(0.3 / (1 + 0.2 * i))) return false;
      if (done.collapsed + done.split == 0) break;
    }
    return true;
  }

  site site_of(vertex_index v) const {
    return {mesh_.sites()[v].position, mesh_.sites()[v].metric};
  }

  void count_low() {
    found_.low = 0;
    found_.worst_angle = 180;
    for (vertex_index t = 0; t < mesh_.triangles().size(); ++t) {
      const auto& v = mesh_.triangles()[t].v;
      if (!mesh_.triangles()[t].exists() || mesh_.is_sharp(t)) continue;
      const double angle = smallest_angle({site_of(v[0]), site_of(v[1]), site_of(v[2])});
      found_.worst_angle = std::min(found_.worst_angle, angle);
      if (angle < options_.angle_bound) ++found_.low;
    }
  }

  // Returns the vertices on each segment, in its direction.
  divided_segments divide() const {
    divided_segments on(domain_.segments.size());
    for (vertex_index v = 0; v < mesh_.sites().size(); ++v)
      if (!mesh_.around(v).empty() && mesh_.kind(v) == vertex_kind::sliding)
        on[mesh_.place(v).segment].push_back({mesh_.place(v).along, v});
    for (auto& division : on) std::sort(division.begin(), division.end());
    return on;
  }

  void triangulate(const divided_segments& on) {
    mesh& m = found_.triangulation;
    std::vector<vertex_index> number(mesh_.sites().size(), fitting::none);
    const auto add = [&](vertex_index v) {
      number[v] = static_cast<vertex_index>(m.sites.size());
      m.sites.push_back(site_of(v));
    };
    m.given = static_cast<vertex_index>(domain_.vertices.size());
    for (vertex_index v = 0; v < m.given; ++v) add(v);
    for (const auto& division : on)
      for (const auto& [along, v] : division) add(v);
    for (vertex_index v = 0; v < mesh_.sites().size(); ++v)
      if (mesh_.kind(v) == vertex_kind::free && !mesh_.around(v).empty()) add(v);
    for (const fitting::fit_triangle& t : mesh_.triangles())
      if (t.exists()) m.triangles.push_back({number[t.v[0]], number[t.v[1]], number[t.v[2]]});
    add_boundary(on, number);
  }

  void add_boundary(const divided_segments& on, const std::vector<vertex_index>& number) {
    for (vertex_index s = 0; s < on.size(); ++s) {
      const segment& whole = domain_.segments[s];
      vertex_index from = whole.a;
      const auto subsegment_to = [&](vertex_index v) {
        found_.triangulation.boundary.push_back(
            {number[from], number[v], s, whole.marker, whole.internal});
        from = v;
      };
      for (const auto& [along, v] : on[s]) subsegment_to(v);
      subsegment_to(whole.b);
    }
  }

  mutable_mesh& mesh_;
  const domain& domain_;
  const fitting_options& options_;
  fitting::mover moves_;
  fitted_domain found_;
};

}  // namespace

result<fitted_domain> fit(const domain& d, const metric_field& field, const mesh& start,
                          const fitting_options& options) {
  const unit_frame frame = unit_frame::choose(d, field, true);
  const domain image = frame.inward(d);
  const framed_field framed(field, frame);
  mesh start_in_frame = start;
  for (site& s : start_in_frame.sites) s.position = frame.inward(s.position);
  const double target = std::min(options.angle_bound + options.degrees_above_bound, most_degrees);
  auto made = mutable_mesh::build(image, framed, start_in_frame, options.angle_bound, target);
  if (!made) return made.failure();
  fitter work(made.value(), image, options);
  work.run();
  if (made.value().field_failure()) return *made.value().field_failure();
  fitted_domain fitted = work.conclude();
  frame.outward(fitted.triangulation);
  return fitted;
}

}  // namespace asterism::internal
