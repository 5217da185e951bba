// SPDX-License-Identifier: MIT
//
// Audits one mesh, and audits it again, in part, after a few places of it were changed. Owns what
// later audits use again: the tree of the sites, and the known reaches of the stars. Internal to
// the library; audit() and verify() are its public doors.
//
//   auditor judge(m, asked);
//   judge.run();
//   if (judge.report().certified) write(judge.make_certificate(account));
//
// Rechecking. The answer to "does the star of v accept w between x and y" depends on these four
// sites, and on the subsegments between v and w, alone. So only questions with a changed site are
// asked again; all other answers stay. A new gap, a new edge, and an edge with a new site across
// belong to a new triangle: their questions are asked if the corners of new triangles are listed as
// changed. The auditor itself compares the mesh with the one before. Where it differs in tensors,
// in a few triangles and in the places of a few inside sites alone, the checks of the triangulation
// are made of these triangles and their corners, and angles are measured in triangles with a
// changed corner.
//
// Open questions. While a mesh is being mended, questions that take long need no answer at once:
// where doubles do not decide whether a star accepts a site, the tensors of both may be changed
// later anyway, or because the question is open. Such questions are left open, and a mesh is not
// certified while there is one.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/mesh/audit/audit_memory.hpp"
#include "asterism/mesh/audit/audit_report.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/audit/past_audit.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal {

namespace audit_detail {
class site_tree;
}

enum class hard_questions { asked, left_open };

// Limits of the work that an audit does on stars.
struct audit_effort {
  hard_questions hard = hard_questions::asked;
  // Number of sites from which a gap of unknown reach counts as a hard question, and may be left
  // open. With fewer sites, each is tested against the gap.
  std::size_t many_for_a_gap = 0;
  // Number of questions left open about one gap from which on the gap itself is left open, and no
  // further site is tested against it.
  std::size_t many_open_at_a_gap = std::numeric_limits<std::size_t>::max();
};

class auditor {
 public:
  // The mesh must outlive the auditor, and so must the domain that the options name. It may be
  // changed before recheck(), not moved.
  auditor(const mesh& subject, audit_options asked);
  // Continues from an audit made before the mesh was changed; the reaches in its memory are indexed
  // by the present numbers of the sites.
  auditor(const mesh& subject, audit_options asked, past_audit before);
  auditor(auditor&&) noexcept;
  ~auditor();

  // Audits the mesh, however damaged it is. A mesh with an open question is not certified.
  const audit_report& run(const audit_effort& effort = {});

  // Audits the mesh again, some sites of which were changed since the last audit. Returns the
  // report of run(), except that the counts of work are of both audits. Requires that the last
  // audit checked all stars to the end, and that `changed` lists a vertex of each of its findings
  // about stars and of each open question, changed or not. Sites may have new tensors. Inside sites
  // may also have moved or been removed, and triangles be new; all corners of new triangles must be
  // in `changed`. Subsegments must be the same.
  const audit_report& recheck(const std::vector<vertex_index>& changed,
                              const audit_effort& effort = {});

  // Checks the numbers of the mesh alone: points and tensors, indices, points and corners that are
  // repeated.
  const audit_report& check_numbers();
  // Checks alone that the mesh is a triangulation with its regions: no angles, and no stars. The
  // report says certified if it is one.
  const audit_report& check_triangulation();
  // Checks angles alone, of a mesh that is known to be a triangulation, and the values,
  // orientations and edges on which that check relies; of the mesh of a past audit with other
  // tensors, the tensors and the angles.
  const audit_report& check_angles();

  // Tries the filters of edge_test on the open questions for which `is_asked` is true, in order.
  // Closes those answered in the mesh's favour. Calls `refuse` for the others: those answered
  // against the mesh, gaps of unknown reach, and questions that only exact numbers answer. The mesh
  // is certified if no finding and no open question is left.
  void ask_filters(const std::function<bool(const open_question&)>& is_asked,
                   const std::function<void(const open_question&)>& refuse);

  const audit_report& report() const { return report_; }
  const std::vector<open_question>& open() const { return memory_.open; }
  const audit_memory& memory() const { return memory_; }
  // Moves the memory, some 24 bytes a site, to the caller; no question is open here then.
  audit_memory take_memory() { return std::exchange(memory_, {}); }

  // Makes the certificate of the mesh as it was audited last. Charges the work to `account`.
  certificate make_certificate(const cancellation& account) const;

 private:
  void ask(const std::vector<vertex_index>* changed, audit_memory* memory,
           const audit_effort& effort);
  // Returns a tree of the mesh's sites with their present metrics; null if no audit made one.
  std::shared_ptr<const audit_detail::site_tree> known_tree() const;

  const mesh* subject_;
  audit_options asked_;
  audit_report report_;
  audit_memory memory_;
  std::shared_ptr<audit_detail::site_tree> tree_;  // of the mesh's sites; null if none was needed
};

}  // namespace asterism::internal
