// SPDX-License-Identifier: MIT
#include "asterism/mesh/adapt/unit_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "asterism/mesh/numerics/quick_logarithm.hpp"
#include "asterism/mesh/support/free_memory.hpp"
#include "asterism/mesh/support/parallel.hpp"
#include "asterism/mesh/support/prefetch.hpp"
#include "asterism/mesh/support/work_weights.hpp"

namespace asterism::internal::adapting {
namespace {

constexpr double area_of_face = std::numbers::sqrt3 / 4;  // with edges of length one

}  // namespace

// True if a corner of t is nearer to the place than nodes may be, in the metric of either. A corner
// does not count if the edge to it would be split twice in any case: across a jump of the metric
// every node is near in the coarser side's metric.
bool unit_mesh_remesher::is_crowded(vertex_index t, const node& there) const {
  constexpr double room = 0.8, far = 4;  // units
  const double least = room * room * unit_ * unit_;
  const face& f = m_.faces()[t];
  return std::any_of(f.v.begin(), f.v.end(), [&](vertex_index v) {
    const node& n = m_.at(v);
    const double x = n.position.x - there.position.x, y = n.position.y - there.position.y;
    const bool is_near = squared(there.metric, x, y) < least || squared(n.metric, x, y) < least;
    return is_near && !(length_between(there, n) > far * unit_);
  });
}

// Returns the area in the metric of the nodes, and the number of faces. Adds up chunks of a fixed
// size, so that the number of threads does not change the sum.
std::pair<double, std::size_t> unit_mesh_remesher::measured_area() const {
  std::vector<double> logarithms(m_.nodes().size(), 0);  // of the nodes' densities
  m_.each_node([&](vertex_index v) { logarithms[v] = quick_log(m_.at(v).root); });
  m_.note_looked_at(work_weights::faces_for_count * m_.faces().size());
  constexpr std::size_t chunk = 8192;
  using sum_and_count = std::pair<double, std::size_t>;
  const auto measured_in = [&](std::size_t begin, std::size_t end) {
    sum_and_count sum{0, 0};
    auto& [area, faces] = sum;
    for (std::size_t t = begin; t < end; ++t) {
      if (t + triangles_ahead < end) m_.prefetch_corners(t + triangles_ahead);
      const face& f = m_.faces()[t];
      if (!f.exists()) continue;
      const node &a = m_.at(f.v[0]), &b = m_.at(f.v[1]), &c = m_.at(f.v[2]);
      const double twice = (b.position.x - a.position.x) * (c.position.y - a.position.y) -
                           (b.position.y - a.position.y) * (c.position.x - a.position.x);
      // Interpolates densities geometrically, as tensors are. An arithmetic mean would count the
      // density at one corner of a coarse face in the whole face.
      area +=
          twice / 2 * quick_exp((logarithms[f.v[0]] + logarithms[f.v[1]] + logarithms[f.v[2]]) / 3);
      ++faces;
    }
    return sum;
  };
  sum_and_count whole{0, 0};
  for (const auto& [area, faces] :
       map_chunks<sum_and_count>(m_.faces().size(), chunk, measured_in)) {
    whole.first += area;
    whole.second += faces;
  }
  return whole;
}

// Returns the sum of the lengths of the boundary's edges.
double unit_mesh_remesher::boundary_length() const {
  double sum = 0;
  m_.note_looked_at(m_.faces().size());
  for (const face& f : m_.faces())
    for (std::size_t i = 0; f.exists() && i < 3; ++i)
      if (f.next[i] == none) sum += m_.length(f.v[after(i)], f.v[before(i)]);
  return sum;
}

// Returns the length for which equilateral faces would give the wanted number of nodes, with as
// many edges on the boundary as it is lengths long. No shorter than that with which the boundary
// alone has that number: where the domain is thinner than one row of equilateral faces, each edge
// of the boundary has a face.
double unit_mesh_remesher::unit_for_boundary(double area) const {
  const double half = boundary_length() / 2, faces = area / (2 * area_of_face);
  const auto count = static_cast<double>(options_.count);
  return std::max((half + std::sqrt(half * half + 4 * faces * count)) / (2 * count),
                  2 * half / count);
}

// Sets the unit to the length for which equilateral faces would give the wanted number of nodes,
// from the area in the metric of the nodes. Where most nodes are on the boundary their number is
// computed, too: as it is now, it would leave no faces for the inside where there are too many.
void unit_mesh_remesher::measure_unit() {
  if (options_.count == 0) return;
  const auto [area, faces] = measured_area();
  // Uses that twice the number of nodes less the number of faces depends on the boundary alone
  // (Euler).
  const double boundary = 2 * static_cast<double>(m_.count()) - static_cast<double>(faces);
  const auto count = static_cast<double>(options_.count);
  const double wanted = std::max(1.0, 2 * count - boundary);
  constexpr double most_nodes = 0.75;
  const double fitting = boundary > most_nodes * count ? unit_for_boundary(area)
                                                       : std::sqrt(area / (wanted * area_of_face));
  const double unit = crowding_ * fitting;
  constexpr double most = 2;  // in one step: a coarse mesh measures badly
  if (std::isfinite(unit) && unit > 0) unit_ = std::clamp(unit, unit_ / most, unit_ * most);
}

// Splits the longest or merges the shortest edges until the number of nodes is as wanted. Ends
// where merging makes little progress: edges whose merges leave bad shapes stay.
void unit_mesh_remesher::meet_count() {
  constexpr int most = 4;
  constexpr std::size_t parts = 200;  // of the count: half a percent more or less is as wanted
  std::size_t before = no_limit;      // number of nodes too many or too few
  for (int round = 0; round < most && !is_stopped(); ++round) {
    const std::size_t now = m_.count(), wanted = options_.count;
    const std::size_t off = now > wanted ? now - wanted : wanted - now;
    const bool is_in_vain = now > wanted && off > before - before / 4;
    if (off * parts <= wanted || is_in_vain) return;
    if (now > wanted)
      merge_short(unit_, off);
    else
      split_long(unit_, off);
    merge_and_move(0, 1);
    before = off;
  }
}

// Corrects the crowding factor by a count of nodes that is off.
void unit_mesh_remesher::correct_crowding(double log_ratio, double power) {
  constexpr double least = 0.8, most = 1.6;
  crowding_ = std::clamp(crowding_ * quick_exp(power * log_ratio), least, most);
}

// Returns the logarithm of the number of nodes over the wanted number.
double unit_mesh_remesher::log_of_count() const {
  if (options_.count == 0) return 0;
  return quick_log(static_cast<double>(m_.count()) / static_cast<double>(options_.count));
}

// Splits, merges, flips and moves in turn, with the unit that gives the wanted number of nodes.
// Adds rounds while the count is off by more than is tolerable.
void unit_mesh_remesher::fit(const effort& how) {
  constexpr int most_rounds = 10;
  // Power of the ratio of counts by which the crowding factor is corrected. The number of nodes
  // would follow the square of the unit if all edges had length one, but edges a little shorter are
  // not merged. Where these are most, it hardly changes: so with many nodes the power is doubled
  // once if the count is off to the same side again. Doubled twice, it overshoots: the count then
  // swings from side to side.
  constexpr double usual_power = 0.75, most_power = 1.5;
  const double growth = wants_few() ? 1 : 2;
  double power = usual_power, off = 0;  // logarithm of the ratio
  for (int round = 0; round < most_rounds && !is_stopped(); ++round) {
    if (round >= how.rounds && std::abs(off) < how.tolerable) break;
    measure_unit();
    if (split_all_long((round == 0 ? how.longest_at_first : how.longest) * unit_)) measure_unit();
    merge_and_move(unit_ / std::numbers::sqrt2, how.sweeps);
    if (options_.count == 0) continue;
    const double before = std::exchange(off, log_of_count());
    power = before * off > 0 ? std::min(growth * power, most_power) : usual_power;
    correct_crowding(off, power);
  }
}

void unit_mesh_remesher::make_states() {
  face_states_.resize(m_.faces().size());
  node_states_.resize(m_.nodes().size());
}

void unit_mesh_remesher::release() {
  free_memory(face_states_, node_states_, flips_in_vain_, due_, merges_in_vain_);
}

void unit_mesh_remesher::forget_shapes() {
  face_states_.clear();
  flips_in_vain_.clear();
  for (const vertex_index t : due_) state_of(t).is_due = true;
  merges_in_vain_.clear();
}

void unit_mesh_remesher::run(metric_at field, const std::vector<point>& seeds) {
  field_ = std::move(field);
  forget_shapes();
  for (vertex_index v = 0; v < m_.nodes().size(); ++v) measure(v);
  seed(seeds);
  // Leaves the count off by a few percent, as the mesh is fitted again: merging the shortest edges
  // for the last of them is mostly in vain here.
  constexpr double longest = std::numbers::sqrt2;
  constexpr effort usual{2, 2, longest, longest, 0.05}, rough{1, 1, longest, longest, 0.05};
  fit(wants_few() ? usual : rough);
}

void unit_mesh_remesher::refit(metric_at field) {
  field_ = std::move(field);
  forget_shapes();
  m_.each_node([this](vertex_index v) { measure(v); });
  note_change_of_all();
  // Starts with many nodes from the crowding factor that refitting needs in most meshes, corrected
  // by the count that the first fit left: then one round is enough in most.
  constexpr double usual = 1.085, power = 0.6;
  crowding_ = wants_few() ? std::sqrt(crowding_) : usual * quick_exp(power * log_of_count());
  // Splits edges first that are a tenth longer than one already. Their halves are merged or moved,
  // which spreads nodes more evenly than edges of up to the square root of 2 do: errors of
  // interpolation are less, in fewer rounds (docs/design/adaptation_experiments.md).
  constexpr effort careful{1, 2, 1.1, 1.25, 0.015};
  fit(careful);
  if (options_.count > 0) meet_count();
}

void unit_mesh_remesher::meet_count(metric_at field) {
  field_ = std::move(field);
  forget_shapes();
  if (options_.count > 0) meet_count();
}

}  // namespace asterism::internal::adapting
