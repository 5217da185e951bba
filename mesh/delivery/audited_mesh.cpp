// SPDX-License-Identifier: MIT
#include "asterism/mesh/delivery/audited_mesh.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "asterism/mesh/delivery/assign_regions.hpp"
#include "asterism/mesh/support/parallel.hpp"

namespace asterism::internal {
namespace {

constexpr std::size_t all_findings = std::numeric_limits<std::size_t>::max();

// Number of open questions above which a star counts as one whose gaps reach far: few stars are
// such, and they have nearly all questions.
constexpr std::size_t many_open = 20;

// Lists the faces that exist.
std::vector<vertex_index> faces_of(const adapting::editable_mesh& m) {
  constexpr std::size_t faces_at_once = 8192;  // for a thread
  return collect_chunks<vertex_index>(
      m.faces().size(), faces_at_once,
      [&m](std::size_t begin, std::size_t end, std::vector<vertex_index>& found) {
        for (std::size_t t = begin; t < end; ++t)
          if (m.faces()[t].exists()) found.push_back(static_cast<vertex_index>(t));
      });
}

}  // namespace

void audited_mesh::take(const adapting::editable_mesh& m) {
  memory_ = {};
  std::vector<vertex_index> renumbered;
  subject_ = m.triangulation(renumbered);
  assign_regions(subject_, *domain_);
  node_of_.assign(subject_.sites.size(), 0);
  for (vertex_index v = 0; v < renumbered.size(); ++v)
    if (renumbered[v] != adapting::none) node_of_[renumbered[v]] = v;
  face_of_ = faces_of(m);
}

bool audited_mesh::has_same_nodes_and_faces(const adapting::editable_mesh& m) const {
  const auto exists = [&m](vertex_index v) { return m.at(v).kind != adapting::node_kind::gone; };
  if (m.count() != node_of_.size() || !std::all_of(node_of_.begin(), node_of_.end(), exists))
    return false;
  return faces_of(m) == face_of_;
}

// Takes places, tensors and corners where nodes and faces have the numbers they had.
void audited_mesh::take_in_place(const adapting::editable_mesh& m) {
  for (vertex_index s = 0; s < node_of_.size(); ++s) {
    const adapting::node& is = m.at(node_of_[s]);
    subject_.sites[s] = {is.position, is.metric};
  }
  const auto site_of = [&](vertex_index v) {
    return static_cast<vertex_index>(std::lower_bound(node_of_.begin(), node_of_.end(), v) -
                                     node_of_.begin());
  };
  for (std::size_t t = 0; t < face_of_.size(); ++t) {
    const adapting::face& is = m.faces()[face_of_[t]];
    if (!has_same_corners(is, subject_.triangles[t]))
      subject_.triangles[t] = {site_of(is.v[0]), site_of(is.v[1]), site_of(is.v[2])};
  }
  assign_regions(subject_, *domain_);
}

void audited_mesh::take_changed(const adapting::editable_mesh& m) {
  if (has_same_nodes_and_faces(m)) return take_in_place(m);
  audit_memory before = std::move(memory_);
  std::vector<double> reaches(m.nodes().size(), std::numeric_limits<double>::infinity());
  for (vertex_index s = 0; s < before.reaches.size(); ++s) reaches[node_of_[s]] = before.reaches[s];
  take(m);
  for (const vertex_index v : node_of_) memory_.reaches.push_back(reaches[v]);
  memory_.power_of_squares = before.power_of_squares;
  memory_.triangulation = before.triangulation;
  memory_.tree = std::move(before.tree);
  memory_.angle_bounds = std::move(before.angle_bounds);
}

void audited_mesh::take_tensors(const adapting::editable_mesh& m) {
  for (vertex_index s = 0; s < node_of_.size(); ++s)
    subject_.sites[s].metric = m.at(node_of_[s]).metric;
}

bool audited_mesh::has_same_corners(const adapting::face& f, const triangle& t) const {
  return f.v[0] == node_of_[t[0]] && f.v[1] == node_of_[t[1]] && f.v[2] == node_of_[t[2]];
}

// Flags the sites that are vertices of the domain or divide a segment.
std::vector<char> audited_mesh::sites_on_segments() const {
  std::vector<char> are_on(subject_.sites.size(), 0);
  std::fill_n(are_on.begin(), subject_.given, char{1});
  for (const boundary_edge& e : subject_.boundary) are_on[e.a] = are_on[e.b] = 1;
  return are_on;
}

mesh_changes audited_mesh::changes(const adapting::editable_mesh& m) const {
  constexpr std::size_t at_once = 8192;  // sites or faces, for a thread
  mesh_changes found;
  const auto has_stayed = [&](vertex_index s) {
    const adapting::node& is = m.at(node_of_[s]);
    return is.kind != adapting::node_kind::gone && is.position == subject_.sites[s].position;
  };
  const auto list_sites = [&](std::size_t begin, std::size_t end, node_list& sites) {
    for (auto s = static_cast<vertex_index>(begin); s < end; ++s)
      if (!has_stayed(s) || !identical(m.at(node_of_[s]).metric, subject_.sites[s].metric))
        sites.push_back(s);
  };
  const auto list_corners = [&](std::size_t begin, std::size_t end, node_list& nodes) {
    auto before = std::lower_bound(face_of_.begin(), face_of_.end(), begin);
    for (auto t = static_cast<vertex_index>(begin); t < end; ++t) {
      const auto nth = static_cast<std::size_t>(before - face_of_.begin());
      const bool had_face = before != face_of_.end() && *before == t;
      if (had_face) ++before;
      const adapting::face& is = m.faces()[t];
      if (is.exists() && !(had_face && has_same_corners(is, subject_.triangles[nth])))
        nodes.insert(nodes.end(), is.v.begin(), is.v.end());
    }
  };
  node_list displaced;  // sites
  for (const vertex_index s : collect_chunks<vertex_index>(node_of_.size(), at_once, list_sites)) {
    if (!has_stayed(s)) displaced.push_back(s);
    if (m.at(node_of_[s]).kind != adapting::node_kind::gone) found.nodes.push_back(node_of_[s]);
  }
  const node_list corners = collect_chunks<vertex_index>(m.faces().size(), at_once, list_corners);
  found.nodes.insert(found.nodes.end(), corners.begin(), corners.end());
  if (displaced.empty()) return found;
  const std::vector<char> are_on = sites_on_segments();
  found.are_inside = std::none_of(displaced.begin(), displaced.end(),
                                  [&](vertex_index s) { return are_on[s] != 0; });
  return found;
}

audit_options audited_mesh::question(std::size_t findings_kept) const {
  audit_options asked;
  asked.angle_bound = options_->angle_bound;
  asked.find_exempt_corners = true;
  asked.original = domain_;
  asked.findings_kept = findings_kept;
  asked.stop = options_->stop;
  return asked;
}

void audited_mesh::keep(auditor& judge) {
  report_ = std::make_shared<audit_report>(judge.report());
  memory_ = judge.take_memory();
}

void audited_mesh::judge(std::size_t findings_kept) {
  auditor judge(subject_, question(findings_kept));
  judge.run();
  keep(judge);
}

void audited_mesh::judge_quickly() {
  auditor judge(subject_, question(all_findings));
  judge.run({hard_questions::left_open, many_for_a_gap_, many_open + 1});
  keep(judge);
}

void audited_mesh::judge_again(node_list changed, hard_questions hard) {
  if (!report_->stars_checked) return judge(all_findings);
  std::sort(changed.begin(), changed.end());
  node_list sites;
  for (vertex_index s = 0; s < node_of_.size(); ++s)
    if (std::binary_search(changed.begin(), changed.end(), node_of_[s])) sites.push_back(s);
  auditor judge(subject_, question(all_findings), {*report_, std::move(memory_)});
  judge.recheck(sites, {hard, many_for_a_gap_, many_open + 1});
  keep(judge);
}

template <class Vertices>
node_list audited_mesh::nodes_of(const Vertices& vertices) const {
  node_list nodes;
  for (const vertex_index s : vertices) nodes.push_back(node_of_[s]);
  return nodes;
}

void audited_mesh::ask_filters(const adapting::editable_mesh& m,
                               const std::function<void(const node_list&)>& refuse) {
  const auto is_as_it_was = [&](vertex_index s) {
    return identical(m.at(node_of_[s]).metric, subject_.sites[s].metric);
  };
  const auto is_asked = [&](const open_question& q) {
    return std::all_of(q.sites.begin(), q.sites.end(), is_as_it_was);
  };
  auditor judge(subject_, question(all_findings), {*report_, std::move(memory_)});
  judge.ask_filters(is_asked, [&](const open_question& q) { refuse(nodes_of(q.sites)); });
  keep(judge);
}

std::vector<node_list> audited_mesh::nodes_found() const {
  std::vector<node_list> all;
  for (const audit_finding& found : report_->findings)
    if (!found.vertices.empty()) all.push_back(nodes_of(found.vertices));
  for (const vertex_index t : report_->refused_triangles())
    all.push_back(nodes_of(subject_.triangles[t]));
  return all;
}

std::vector<node_list> audited_mesh::stars_with_many_open() const {
  std::map<vertex_index, std::vector<const open_question*>> stars;
  for (const open_question& q : memory_.open) stars[q.sites[0]].push_back(&q);
  std::vector<node_list> found;
  for (const auto& [centre, questions] : stars) {
    if (questions.size() <= many_open) continue;
    node_list& nodes = found.emplace_back();
    nodes.push_back(node_of_[centre]);
    for (const open_question* q : questions)
      for (const vertex_index s : {q->sites[2], q->sites[3]}) nodes.push_back(node_of_[s]);
  }
  return found;
}

std::vector<node_list> audited_mesh::nodes_of_open() const {
  std::vector<node_list> all;
  for (const open_question& q : memory_.open) all.push_back(nodes_of(q.sites));
  return all;
}

}  // namespace asterism::internal
