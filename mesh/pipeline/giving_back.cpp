// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/giving_back.hpp"

#include <limits>
#include <utility>

#include "asterism/mesh/adapt/restoration.hpp"

namespace asterism::internal {
namespace {

// Most audits of a mesh whose tensors alone are changed: those after the first cost little.
constexpr int most_audits = 40;
// Most times that tensors are made alike between those.
constexpr int most_made_alike = 8;

}  // namespace

bool give_back(adapting::working_mesh& m, std::vector<metric_tensor> wanted,
               const mesh_options& options, audited_mesh& audited) {
  adapting::restoration giving(m, options.angle_bound, std::move(wanted));
  giving.run(options.stop);
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
