// SPDX-License-Identifier: MIT
#include "asterism/mesh/adapt/tensor_restoration.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include "asterism/mesh/adapt/mesh_gradation.hpp"
#include "asterism/mesh/gradation/nodal_gradation.hpp"
#include "asterism/mesh/numerics/metric_algebra.hpp"
#include "asterism/mesh/support/work_weights.hpp"

namespace asterism::internal::adapting {
namespace {

// True if the clearance of an edge is at least the one to keep, or at least half of its former one.
template <class Before>
bool has_room(double now, const Before& clearance_before) {
  if (now >= clearance_kept) return true;
  const double before = clearance_before();
  return now >= (before > 0 ? before / 2 : before);
}

// The way from one tensor to another, interpolated by logarithms.
struct tensor_way {
  tensor_way(const metric_tensor& a, const metric_tensor& b)
      : from(logarithm(a)), to(logarithm(b)) {}

  // Returns the tensor at `share` of the way.
  metric_tensor at(double share) const {
    const double rest = 1 - share;
    return exponential({rest * from.l11 + share * to.l11, rest * from.l12 + share * to.l12,
                        rest * from.l22 + share * to.l22});
  }

  tensor_logarithm from, to;
};

bool is_usable(const metric_tensor& m) {
  return std::isfinite(m.m11) && std::isfinite(m.m22) && plain_root_of_determinant(m) > 0;
}

}  // namespace

tensor_restoration::tensor_restoration(editable_mesh& m, double angle_bound,
                                       std::vector<metric_tensor> wanted)
    : m_(m),
      tests_(m, angle_bound),
      present_(m, tests_),
      edges_(m, tests_, present_),
      has_angles_(angle_bound > 0),
      wanted_(std::move(wanted)),
      awake_(m.nodes().size(), 1),
      kept_(m.nodes().size(), 0) {
  before_.reserve(m.nodes().size());
  for (const node& n : m.nodes()) before_.push_back(n.metric);
}

void tensor_restoration::run(const cancellation& stop) {
  constexpr int most_sweeps = 8;
  // Number of nodes of which one must have the wanted tensor after the first sweep. If fewer have
  // it, the metric turns nearly everywhere, and audits would undo most steps towards the wanted
  // tensors.
  constexpr std::size_t nodes_for_one = 10;
  present_.forget_all();
  bool any = true;
  for (int sweep = 0; any && sweep < most_sweeps && !stop.is_requested(); ++sweep) {
    const bool is_first = sweep == 0;
    any = give_once(is_first);
    m_.charge_work(stop);
    if (!is_first) continue;
    if (nodes_for_one * wanted_count() < m_.count()) break;
    any = true;
    awake_.assign(awake_.size(), 1);
  }
  present_.release();  // audits follow, and need the room
}

// Tries each node that may still change; returns true if any changed.
bool tensor_restoration::give_once(bool whole_alone) {
  bool any = false;
  for (vertex_index v = 0; v < m_.nodes().size(); ++v) {
    if (!awake_[v] || kept_[v] || m_.at(v).kind == node_kind::gone) continue;
    awake_[v] = 0;
    if (identical(m_.at(v).metric, wanted_[v]) || !give(v, whole_alone)) continue;
    for (const vertex_index t : edges_.faces())
      for (const vertex_index u : m_.faces()[t].v) awake_[u] = 1;
    any = true;
  }
  return any;
}

// Returns the number of nodes that have the wanted tensor.
std::size_t tensor_restoration::wanted_count() const {
  std::size_t count = 0;
  for (vertex_index v = 0; v < m_.nodes().size(); ++v)
    if (m_.at(v).kind != node_kind::gone && identical(m_.at(v).metric, wanted_[v])) ++count;
  return count;
}

// Moves the tensor towards the wanted one; returns false if no step is possible.
bool tensor_restoration::give(vertex_index v, bool whole_alone) {
  const metric_tensor now = m_.at(v).metric;
  // Tries only the whole step where less than a hundredth of the way is left.
  constexpr double short_way = 0.01;
  const auto is_short = [&] { return !(log_distortion(now, wanted_[v]) > short_way); };
  const auto is_enough = [](double clear, const auto& before) { return has_room(clear, before); };
  std::optional<tensor_way> way;
  edges_.turn_to(v);
  edges_.remember();
  for (const double share : {1.0, 0.5, 0.2}) {
    if (share < 1 && !way && (whole_alone || is_short())) break;
    if (share < 1 && !way) way.emplace(now, wanted_[v]);
    const metric_tensor tried = share < 1 ? way->at(share) : wanted_[v];
    if (!is_usable(tried)) continue;
    m_.set_metric(v, tried);
    // Tests last what takes most: the centres of the faces at the node.
    if (!edges_.all_across(is_enough) || has_low_face(edges_.faces()) || !edges_.all_of(is_enough))
      continue;
    edges_.accept();
    return true;
  }
  m_.set_metric(v, now);
  return false;
}

// True if a face has an angle below the bound that is not exempt.
bool tensor_restoration::has_low_face(const face_list& faces) const {
  return has_angles_ && std::any_of(faces.begin(), faces.end(), [this](vertex_index t) {
           return tests_.is_low(t) && !tests_.is_exempt(t);
         });
}

// Lists the nodes of edges around v that do not agree, and of faces there with low angles.
void tensor_restoration::list_disagreeing(vertex_index v, std::vector<vertex_index>& out) const {
  face_list at;
  m_.around(v, at);
  for (const vertex_index t : at) {
    const face& f = m_.faces()[t];
    if (has_angles_ && tests_.is_low(t) && !tests_.is_exempt(t))
      out.insert(out.end(), f.v.begin(), f.v.end());
    const std::size_t i = f.corner_of(v);
    for (const std::size_t e : {i, after(i)}) {
      if (f.next[e] == none || f.segment[e] != none) continue;
      m_.note_looked_at(work_weights::faces_for_edge_test);
      const edge_quad q = tests_.quad_at(t, e);
      if (tests_.worst_clearance(q) > least_clearance) continue;
      out.insert(out.end(), {q.a, q.b, q.c, q.d});
    }
  }
}

// Ends because the change of each node is undone at most once.
void tensor_restoration::take_back(const std::vector<vertex_index>& nodes,
                                   std::vector<vertex_index>& taken) {
  std::vector<vertex_index> waiting = nodes;
  while (!waiting.empty()) {
    const vertex_index v = waiting.back();
    waiting.pop_back();
    if (kept_[v]) continue;
    kept_[v] = 1;
    if (identical(m_.at(v).metric, before_[v])) continue;
    m_.set_metric(v, before_[v]);
    taken.push_back(v);
    list_disagreeing(v, waiting);
  }
}

void tensor_restoration::undo() {
  m_.each_node([this](vertex_index v) {
    if (has_given(v)) m_.set_metric(v, before_[v]);
  });
}

void tensor_restoration::keep(const std::vector<vertex_index>& nodes) {
  for (const vertex_index v : nodes) {
    before_[v] = m_.at(v).metric;
    kept_[v] = 1;
  }
}

}  // namespace asterism::internal::adapting
