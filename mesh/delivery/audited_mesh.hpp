// SPDX-License-Identifier: MIT
//
// Holds the mesh of a triangulation that is being mended, and the auditor's findings about it, by
// the triangulation's nodes. Internal to the pipeline.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "asterism/mesh/adapt/editable_mesh.hpp"
#include "asterism/mesh/audit/auditor.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/options.hpp"

namespace asterism::internal {

using node_list = std::vector<vertex_index>;

// Lists the differences of a triangulation from the mesh of it that was taken to be audited.
struct mesh_changes {
  node_list nodes;  // that are elsewhere or have other tensors, and those of new faces
  // True if only inside nodes were removed or moved: sight across the boundary is the same then.
  bool are_inside = true;
};

class audited_mesh {
 public:
  // References must outlive the object and its copies.
  audited_mesh(const domain& shape, const mesh_options& options)
      : domain_(&shape), options_(&options) {}

  const mesh& subject() const { return subject_; }
  const std::shared_ptr<audit_report>& report() const { return report_; }
  // Returns the last audit; requires that there is one.
  past_audit last_audit() const { return {*report_, memory_}; }
  // True if the last mesh that was audited is certified; false before there is one.
  bool is_certified() const { return report_ && report_->certified; }
  // True if the last audit left hard questions open.
  bool has_open() const { return !memory_.open.empty(); }

  // True if a quick audit of a mesh with this number of sites would test gaps of unknown reach
  // against all sites: it does so if sites and such gaps are few.
  bool asks_unbounded(std::size_t sites) const { return sites < many_for_a_gap_; }
  // Leaves gaps of unknown reach open from now on, however few sites there are.
  void leave_unbounded() { many_for_a_gap_ = 0; }

  // Takes the present mesh of the triangulation to be audited.
  void take(const adapting::editable_mesh& m);
  // Takes the present mesh, which has only nodes of the last one that was taken and audited, and
  // its boundary: the known reaches of their stars are kept.
  void take_changed(const adapting::editable_mesh& m);
  // Copies the present tensors into the mesh that was taken, since when nothing else has changed.
  void take_tensors(const adapting::editable_mesh& m);
  // Returns what has changed since the mesh was taken. No node may be new.
  mesh_changes changes(const adapting::editable_mesh& m) const;

  // Audits the mesh; an audit that keeps all findings is never cut short.
  void judge(std::size_t findings_kept);
  // Audits the mesh, keeping all findings, but leaves hard questions open.
  void judge_quickly();
  // Audits the mesh again after changes to these nodes alone. They include all corners of new
  // faces; at the boundary only tensors may have changed. They include one node of each finding
  // about a star and of each open question.
  void judge_again(node_list changed, hard_questions hard);
  // Decides open questions by filters, except those about a tensor that was changed in m since the
  // mesh was taken. Calls refuse(nodes) for each question decided against the mesh.
  void ask_filters(const adapting::editable_mesh& m,
                   const std::function<void(const node_list&)>& refuse);

  // Returns the nodes of each finding, a list for each: of findings about stars, and of triangles
  // with an angle below the bound.
  std::vector<node_list> nodes_found() const;
  // Returns the stars that have many open questions, a list of nodes for each: its centre, and the
  // neighbours that the questions are about.
  std::vector<node_list> stars_with_many_open() const;
  // Returns the nodes of each open question.
  std::vector<node_list> nodes_of_open() const;

 private:
  audit_options question(std::size_t findings_kept) const;
  template <class Vertices>
  node_list nodes_of(const Vertices& vertices) const;
  void keep(auditor& judge);
  bool has_same_corners(const adapting::face& f, const triangle& t) const;
  bool has_same_nodes_and_faces(const adapting::editable_mesh& m) const;
  void take_in_place(const adapting::editable_mesh& m);
  std::vector<char> sites_on_segments() const;

  const domain* domain_;
  const mesh_options* options_;
  mesh subject_;
  node_list node_of_;  // of each site, ascending
  node_list face_of_;  // of each triangle, ascending
  std::shared_ptr<audit_report> report_;
  std::size_t many_for_a_gap_ = 1000;
  audit_memory memory_;
};

}  // namespace asterism::internal
