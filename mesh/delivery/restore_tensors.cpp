// SPDX-License-Identifier: MIT
#include "asterism/mesh/delivery/restore_tensors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "asterism/kernels/star_gap.hpp"
#include "asterism/mesh/adapt/tensor_restoration.hpp"
#include "asterism/mesh/audit/gap_reach.hpp"
#include "asterism/mesh/support/parallel.hpp"
#include "asterism/mesh/support/work_weights.hpp"

namespace asterism::internal {
namespace {

// Largest number of audits of a mesh in which only tensors change: those after the first cost
// little.
constexpr int most_audits = 40;
// Largest number of repairs of the mesh while the tensors of one mesh are restored. The first of
// them leave the boundary as it is: a change of it would need a whole audit.
constexpr int most_mended = 8, most_with_boundary_held = 4;

// True if the reach of the gap at corner i of the face is unknown: an audit would test the star
// against all sites. As in an audit, a bound that takes few operations is tried first; it suffices
// for most gaps.
bool has_unknown_reach(const adapting::editable_mesh& m, const adapting::face& f, std::size_t i) {
  if (f.segment[i] != adapting::none) return false;
  const auto at = [&m](vertex_index v) { return site{m.at(v).position, m.at(v).metric}; };
  const site v = at(f.v[i]), x = at(f.v[adapting::after(i)]), y = at(f.v[adapting::before(i)]);
  if (audit_detail::has_quick_reach(v, x, y)) return false;
  if (std::isfinite(audit_detail::quick_reach(v, x, y))) return false;
  return !std::isfinite(star_gap(v, x, y).reach());
}

// Undoes the changes of the nodes of a gap of unknown reach, one after the other, the star's centre
// first, until the reach is known or no change is left.
void take_back_at(adapting::editable_mesh& m, adapting::tensor_restoration& giving, vertex_index t,
                  node_list& taken) {
  const adapting::face f = m.faces()[t];
  if (std::none_of(f.v.begin(), f.v.end(), [&](vertex_index v) { return giving.has_given(v); }))
    return;
  for (std::size_t i = 0; i < 3; ++i)
    for (const vertex_index v : {f.v[i], f.v[adapting::after(i)], f.v[adapting::before(i)]}) {
      if (!has_unknown_reach(m, f, i)) break;
      giving.take_back({v}, taken);
    }
}

// Undoes the changes that leave gaps of unknown reach: the first audit would leave them open, and
// need another one. Each node is undone once, so this ends.
void take_back_unbounded(adapting::editable_mesh& m, adapting::tensor_restoration& giving,
                         const cancellation& stop) {
  node_list faces, taken;
  for (vertex_index t = 0; t < m.faces().size(); ++t)
    if (m.faces()[t].exists()) faces.push_back(t);
  while (!faces.empty() && !stop.is_requested()) {
    taken.clear();
    m.note_looked_at(work_weights::faces_for_taking_back * faces.size());
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

// Restores the tensors of one mesh as far as an auditor accepts them.
class giver {
 public:
  giver(adapting::editable_mesh& m, std::vector<metric_tensor> wanted, const mesh_options& options,
        adapting::consistency_repair& agreeing, bool others_pass, audited_mesh& audited)
      : m_(m),
        options_(options),
        agreeing_(agreeing),
        others_pass_(others_pass),
        audited_(audited),
        giving_(m, options.angle_bound, std::move(wanted)) {}

  // True if the mesh is certified in the end; else the tensors are as before.
  bool run() {
    if (restore()) return true;
    giving_.undo();
    agreeing_.restart(others_pass_ && times_mended_ == 0);
    return false;
  }

 private:
  // True if the mesh is certified in the end.
  bool restore() {
    giving_.run(options_.stop);
    if (!audited_.asks_unbounded(m_.count())) take_back_unbounded(m_, giving_, options_.stop);
    audited_.take(m_);
    audited_.judge_quickly();
    for (int audits = 1; audits < most_audits && !audited_.is_certified(); ++audits)
      if (options_.stop.told() || !(options_.stop.units_left() > 0) || !go_on()) return false;
    return audited_.is_certified();
  }

  // Undoes the nodes of the last audit's findings, or repairs the mesh, and audits the changes.
  // Returns false where neither helps.
  bool go_on() {
    node_list taken;
    const auto take_back = [&](const node_list& nodes) { giving_.take_back(nodes, taken); };
    const std::vector<node_list> found = audited_.nodes_found();
    for (const node_list& nodes : found) take_back(nodes);
    for (const node_list& star : audited_.stars_with_many_open()) {
      const std::size_t before = taken.size();
      take_back({star.front()});
      if (taken.size() == before) take_back({star.begin() + 1, star.end()});
    }
    audited_.ask_filters(m_, take_back);
    if (audited_.is_certified()) return true;
    std::vector<node_list> questions = audited_.nodes_of_open();
    questions.insert(questions.end(), found.begin(), found.end());
    if (taken.empty() && audited_.has_open()) {
      audited_.judge_again(one_of_each(questions, {}), hard_questions::asked);
      return true;
    }
    if (taken.empty()) return mend(found);
    audited_.take_tensors(m_);
    judge_changed(one_of_each(questions, taken), taken);
    return true;
  }

  // Returns one node of each question that involves no node in `but`: as that node counts as
  // changed, the next audit answers the question again.
  static node_list one_of_each(const std::vector<node_list>& questions, node_list but) {
    std::sort(but.begin(), but.end());
    const auto is_in = [&but](vertex_index v) {
      return std::binary_search(but.begin(), but.end(), v);
    };
    node_list some;
    for (const node_list& nodes : questions)
      if (std::none_of(nodes.begin(), nodes.end(), is_in)) some.push_back(nodes.front());
    return some;
  }

  // Repairs the mesh where no change is left to undo: makes the tensors of sites that violate each
  // other's stars more alike, as rounds of agreement do for neighbours. Stops when findings do not
  // become fewer, since one repair may cause the next finding.
  bool mend(const std::vector<node_list>& found) {
    if (found.size() > least_found_ || times_mended_++ >= most_mended) return false;
    least_found_ = found.size();
    agreeing_.restart(others_pass_);
    for (const node_list& nodes : found) agreeing_.disagreed_at(nodes);
    agreeing_.hold_boundary(times_mended_ <= most_with_boundary_held);
    agreeing_.run();
    agreeing_.hold_boundary(false);
    const mesh_changes changes = audited_.changes(m_);
    if (changes.nodes.empty()) return false;
    giving_.keep(changes.nodes);
    if (changes.are_inside) {
      audited_.take_changed(m_);
      judge_changed(one_of_each(found, {}), changes.nodes);
    } else {
      audited_.take(m_);
      audited_.judge_quickly();
    }
    return true;
  }

  void judge_changed(node_list looked_at, const node_list& changed) {
    looked_at.insert(looked_at.end(), changed.begin(), changed.end());
    audited_.judge_again(std::move(looked_at), hard_questions::left_open);
  }

  adapting::editable_mesh& m_;
  const mesh_options& options_;
  adapting::consistency_repair& agreeing_;
  bool others_pass_;  // all edges and angles, but for those that an audit finds
  audited_mesh& audited_;
  adapting::tensor_restoration giving_;
  int times_mended_ = 0;
  std::size_t least_found_ = std::numeric_limits<std::size_t>::max();  // when mended
};

// Lists the faces with one of these nodes, in order.
node_list faces_with(const adapting::editable_mesh& m, const node_list& nodes) {
  std::vector<char> is_one(m.nodes().size(), 0);
  for (const vertex_index v : nodes) is_one[v] = 1;
  node_list faces;
  for (vertex_index t = 0; t < m.faces().size(); ++t) {
    const adapting::face& f = m.faces()[t];
    if (f.exists() && is_one[f.v[0]] + is_one[f.v[1]] + is_one[f.v[2]] > 0) faces.push_back(t);
  }
  return faces;
}

// Lists the nodes of those of the faces that are at gaps of unknown reach, a list for each gap.
std::vector<node_list> nodes_at_unknown_reach(const adapting::editable_mesh& m,
                                              const node_list& faces) {
  constexpr std::size_t chunk = 2048;
  const auto append = [&](std::size_t begin, std::size_t end, std::vector<node_list>& found) {
    for (std::size_t k = begin; k < end; ++k) {
      const adapting::face& f = m.faces()[faces[k]];
      for (std::size_t i = 0; i < 3; ++i)
        if (has_unknown_reach(m, f, i)) found.push_back({f.v.begin(), f.v.end()});
    }
  };
  return collect_chunks<node_list>(faces.size(), chunk, append);
}

}  // namespace

void bound_gaps(adapting::editable_mesh& m, adapting::consistency_repair& agreeing,
                const cancellation& stop) {
  constexpr int rounds = 2;
  constexpr std::size_t few = 20;  // one node in this number
  node_list faces(m.faces().size());
  std::iota(faces.begin(), faces.end(), vertex_index{0});
  std::erase_if(faces, [&m](vertex_index t) { return !m.faces()[t].exists(); });
  for (int round = 0; round < rounds && !stop.is_requested(); ++round) {
    const std::vector<node_list> found = nodes_at_unknown_reach(m, faces);
    m.note_looked_at(work_weights::faces_for_three_gaps * faces.size());
    m.charge_work(stop);
    if (found.empty() || few * found.size() > m.count()) return;
    agreeing.forget_touched();
    for (const node_list& nodes : found) agreeing.disagreed_at(nodes);
    agreeing.run();
    faces = faces_with(m, agreeing.touched());  // the reach at others is known
  }
}

bool give_back(adapting::editable_mesh& m, std::vector<metric_tensor> wanted,
               const mesh_options& options, adapting::consistency_repair& agreeing,
               bool others_pass, audited_mesh& audited) {
  return giver(m, std::move(wanted), options, agreeing, others_pass, audited).run();
}

}  // namespace asterism::internal
