// SPDX-License-Identifier: MIT
#include "asterism/mesh/fitting.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "asterism/mesh/fitting_mesh.hpp"
#include "asterism/mesh/fitting_moves.hpp"
#include "asterism/mesh/fitting_surgery.hpp"
#include "asterism/mesh/local/hilbert_order.hpp"
#include "asterism/mesh/refine_quality.hpp"
#include "asterism/mesh/unit_frame.hpp"

namespace asterism {
namespace {

using fitting::fitted_mesh;
using fitting::vertex_kind;

// Angles are aimed at some degrees above the bound. Nine angles of much more than 29 are asked too
// much of any triangulation.
constexpr double degrees_above_bound = 4.5, most_degrees = 29.5;
constexpr int first_sweeps = 60, sweeps_after_surgery = 20, rounds_of_surgery = 6;

class fitter {
 public:
  fitter(fitted_mesh& m, const fitting_options& options)
      : mesh_(m), options_(options), moves_(m, options.enough) {}

  void run() {
    for (const bool stars : {false, true}) {
      mesh_.judge_stars(stars);
      for (int i = 0; i < first_sweeps; ++i)
        if (!sweep(0.4 / (1 + 0.1 * (i % sweeps_after_surgery)))) return;
      if (!operate()) return;
    }
  }

  // In the mesh's own coordinates.
  fitted_domain conclude(std::size_t segments, const bounding_box& box) {
    count_low();
    found_.triangles = mesh_.count();
    found_.moves = moves_.moves();
    found_.flips = moves_.flips();
    found_.stopped = moves_.is_stopped();
    propose(segments, box);
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
      found_.collapses += done.merged;
      found_.insertions += done.split;
      for (int i = 0; i < sweeps_after_surgery; ++i)
        if (!sweep(0.3 / (1 + 0.2 * i))) return false;
      if (done.merged + done.split == 0) break;
    }
    return true;
  }

  site site_of(index v) const { return {mesh_.sites()[v].position, mesh_.sites()[v].metric}; }

  void count_low() {
    found_.low = 0;
    found_.worst_angle = 180;
    for (index t = 0; t < mesh_.triangles().size(); ++t) {
      const auto& v = mesh_.triangles()[t].v;
      if (!mesh_.triangles()[t].exists() || mesh_.is_sharp(t)) continue;
      const double angle = smallest_angle({site_of(v[0]), site_of(v[1]), site_of(v[2])});
      found_.worst_angle = std::min(found_.worst_angle, angle);
      if (angle < options_.angle_bound) ++found_.low;
    }
  }

  void propose(std::size_t segments, const bounding_box& box) {
    std::vector<std::vector<std::pair<double, index>>> on(segments);
    for (index v = 0; v < mesh_.sites().size(); ++v) {
      if (mesh_.around(v).empty()) continue;
      if (mesh_.kind(v) == vertex_kind::free) found_.proposed.interior.push_back(site_of(v));
      if (mesh_.kind(v) == vertex_kind::sliding)
        on[mesh_.place(v).segment].push_back({mesh_.place(v).along, v});
    }
    found_.proposed.divisions.resize(segments);
    for (std::size_t s = 0; s < segments; ++s) {
      std::sort(on[s].begin(), on[s].end());
      for (const auto& [along, v] : on[s]) found_.proposed.divisions[s].push_back(site_of(v));
    }
    sort_along_curve(found_.proposed.interior, box);
    found_.proposed.complete = true;
  }

  fitted_mesh& mesh_;
  const fitting_options& options_;
  fitting::mover moves_;
  fitted_domain found_;
};

void map_outward(std::vector<site>& sites, const unit_frame& frame) {
  for (site& s : sites) s = {frame.outward(s.position), frame.outward(s.metric)};
}

}  // namespace

result<fitted_domain> fit(const domain& d, const metric_field& field, const mesh& start,
                          const fitting_options& options) {
  const unit_frame frame = unit_frame::choose(d, field, true);
  const domain image = frame.inward(d);
  const framed_field framed(field, frame);
  mesh start_in_frame = start;
  for (site& s : start_in_frame.sites) s.position = frame.inward(s.position);
  const double target = std::min(options.angle_bound + degrees_above_bound, most_degrees);
  auto made = fitted_mesh::build(image, framed, start_in_frame, options.angle_bound, target);
  if (!made) return made.failure();
  fitter work(made.value(), options);
  work.run();
  if (made.value().field_failure()) return *made.value().field_failure();
  fitted_domain fitted = work.conclude(d.segments.size(), image.box());
  for (auto& division : fitted.proposed.divisions) map_outward(division, frame);
  map_outward(fitted.proposed.interior, frame);
  return fitted;
}

}  // namespace asterism
