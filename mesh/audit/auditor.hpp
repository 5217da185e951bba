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
// sites, and on the subsegments between v and w, alone. So only those questions are asked again of
// which a site was changed; the answers to the others are the ones there were. A gap that there was
// not is one of a new triangle, and an edge that there was not, or that has another site across, is
// one of it: their questions are asked where the new triangle's corners count as changed.
//
// Open questions. A mesh that is being mended need not be asked at once what takes long to answer:
// where doubles do not tell whether a star accepts a site, its tensors may be changed for another
// reason, or for that one. Such questions are left open, and a mesh is not certified while there is
// one.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "asterism/mesh/audit/audit_report.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/audit/star_memory.hpp"
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
};

class auditor {
 public:
  // The mesh must outlive the auditor, and so must the domain that the options name. It may be
  // changed before recheck(), not moved.
  auditor(const mesh& subject, audit_options asked);
  // Continues from the report and the memory of an audit made before the mesh was changed; the
  // reaches in it are indexed by the present numbers of the sites.
  auditor(const mesh& subject, audit_options asked, audit_report before, star_memory memory);
  auditor(auditor&&) noexcept;
  ~auditor();

  // Audits the mesh, however damaged it is. A mesh with an open question is not certified.
  const audit_report& run(const audit_effort& effort = {});

  // Audits the mesh again, some sites of which were changed since the last audit. Returns what
  // run() would report but for the counts of work, which are of both audits. Requires: the last
  // audit looked at all stars, without cutting anything short; and of each of its findings about
  // stars, and of each question that is still open, a vertex is in `changed`, be it changed or not.
  // Sites may have other tensors; inside, they may also be elsewhere, or be gone, and triangles be
  // others, all corners of which are in `changed`. Subsegments are the same.
  const audit_report& recheck(const std::vector<vertex_index>& changed,
                              const audit_effort& effort = {});

  // Checks the numbers of the mesh alone: points and tensors, indices and repetitions.
  const audit_report& check_numbers();

  // Tries the filters of edge_test on the open questions for which `is_asked` is true, in order.
  // Closes those answered in the mesh's favour. Calls `refuse` for all others, which includes gaps
  // of unknown reach and questions that only exact numbers answer. The mesh is certified if no
  // finding and no open question is left.
  void ask_filters(const std::function<bool(const open_question&)>& is_asked,
                   const std::function<void(const open_question&)>& refuse);

  const audit_report& report() const { return report_; }
  const std::vector<open_question>& open() const { return memory_.open; }
  const star_memory& memory() const { return memory_; }

  // Makes the certificate of the mesh as it was audited last. Charges the work to `account`.
  certificate make_certificate(const cancellation& account) const;

 private:
  void ask(const std::vector<vertex_index>* changed, star_memory* memory,
           const audit_effort& effort);

  const mesh* subject_;
  audit_options asked_;
  audit_report report_;
  star_memory memory_;
  std::unique_ptr<audit_detail::site_tree> tree_;  // of the mesh's sites; null if none was needed
};

}  // namespace asterism::internal
