// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/giving_back.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "asterism/kernels/star_gap.hpp"
#include "asterism/mesh/adapt/restoration.hpp"

namespace asterism::internal {
namespace {

// Most audits of a mesh whose tensors alone are changed: those after the first cost little.
constexpr int most_audits = 40;
// Most times that tensors are made alike between those.
constexpr int most_made_alike = 8;

// True if it is not known how far the gap of the face at its corner i reaches, so that the star
// would be held against all sites.
bool sees_all(const adapting::working_mesh& m, const adapting::face& f, std::size_t i) {
  if (f.segment[i] != adapting::none) return false;
  const auto at = [&m](vertex_index v) { return site{m.at(v).position, m.at(v).metric}; };
  const star_gap gap(at(f.v[i]), at(f.v[adapting::after(i)]), at(f.v[adapting::before(i)]));
  return !std::isfinite(gap.reach());
}

// Takes back what was given to one node of such a gap after the other, until it is none, or has
// nothing left; of the star's centre first.
void take_back_at(adapting::working_mesh& m, adapting::restoration& giving, vertex_index t,
                  node_list& taken) {
  const adapting::face f = m.faces()[t];
  for (std::size_t i = 0; i < 3; ++i)
    for (const vertex_index v : {f.v[i], f.v[adapting::after(i)], f.v[adapting::before(i)]}) {
      if (!sees_all(m, f, i)) break;
      giving.take_back({v}, taken);
    }
}

// Takes back what leaves gaps of which no reach is known: the first audit would leave them open,
// and another one follow. Each node is taken back once, so this ends.
void take_back_unbounded(adapting::working_mesh& m, adapting::restoration& giving,
                         const cancellation& stop) {
  constexpr std::size_t as_faces = 20;  // of the time that a face in a list takes
  node_list faces, taken;
  for (vertex_index t = 0; t < m.faces().size(); ++t)
    if (m.faces()[t].exists()) faces.push_back(t);
  while (!faces.empty() && !stop.is_requested()) {
    taken.clear();
    m.note_looked_at(as_faces * faces.size());
    for (const vertex_index t : faces) take_back_at(m, giving, t, taken);
    faces.clear();
    adapting::face_list at;
    for (const vertex_index v : taken) {
      m.around(v, at);
      faces.insert(faces.end(), at.begin(), at.end());
    }
    m.charge_work(stop);
  }
}

}  // namespace

bool give_back(adapting::working_mesh& m, std::vector<metric_tensor> wanted,
               const mesh_options& options, audited_mesh& audited) {
  adapting::restoration giving(m, options.angle_bound, std::move(wanted));
  giving.run(options.stop);
  take_back_unbounded(m, giving, options.stop);
  audited.take(m);
  audited.judge_quickly();
  int made_alike = 0;
  std::size_t least_found = std::numeric_limits<std::size_t>::max();  // when made alike
  for (int audits = 1; audits < most_audits && !audited.is_certified(); ++audits) {
    if (options.stop.told() || !(options.stop.units_left() > 0)) return false;
    node_list looked_at, taken;
    const auto take_back = [&](const node_list& nodes) {
      giving.take_back(nodes, taken);
      looked_at.insert(looked_at.end(), nodes.begin(), nodes.end());
    };
    const std::vector<node_list> found = audited.nodes_found();
    for (const node_list& nodes : found) take_back(nodes);
    audited.ask_filters(m, take_back);
    if (audited.is_certified()) return true;
    audited.add_nodes_of_open(looked_at);
    if (taken.empty() && audited.has_open()) {
      audited.judge_again(looked_at, hard_questions::asked);
      continue;
    }
    // Makes alike what farther sites are in the way of, once all is taken back and something is
    // still found. Stops where that does not lead on: a change may be in the way of others.
    if (taken.empty() && found.size() <= least_found && made_alike++ < most_made_alike) {
      least_found = found.size();
      for (const node_list& nodes : found) giving.make_alike(nodes, taken);
    }
    if (taken.empty()) return false;
    looked_at.insert(looked_at.end(), taken.begin(), taken.end());
    audited.take(m);
    audited.judge_again(looked_at, hard_questions::left_open);
  }
  return audited.is_certified();
}

}  // namespace asterism::internal
