// SPDX-License-Identifier: MIT
//
// Audits a mesh whose stars were all looked at before, and of which some tensors, or some sites and
// triangles inside, were changed since. Internal to the library.
//
// The answer to "does the star of v accept w between x and y" depends on these four sites, and on
// the subsegments between v and w, alone. So only those questions are asked again of which a site
// was changed; the answers to the others are the ones there were. A gap that there was not is one
// of a new triangle, and an edge that there was not, or that has another site across, is one of it:
// their questions are asked where the new triangle's corners count as changed.
//
// A mesh that is being mended need not be asked at once what takes long to answer: where doubles do
// not tell whether a star accepts a site, its tensors may be changed for another reason, or for
// that one. Such questions are handed back, and a mesh is not certified while there is one.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "asterism/mesh/audit/audit.hpp"

namespace asterism::internal {

// Question about a star that was left open: whether it accepts a neighbour, as it is to, or another
// site, as it is not to, or any other site in a gap of which no reach is known.
struct open_question {
  enum class about { neighbour, other_site, gap };

  // The centre of the star; the site, of a gap the centre again; the neighbours before and after
  // it.
  std::array<vertex_index, 4> sites;
  about what;
};

// Tells the next audit of the same mesh what this one found out.
struct star_memory {
  std::vector<open_question> open;  // questions that are left
  // How far each site's star reaches, in its own metric; empty where that is not known.
  std::vector<double> reaches;
  // Power of the factor of two of squares of these lengths: a metric of very large numbers is asked
  // about in other units, which depend on the largest.
  int power_of_squares = 0;
  // Number of sites from which on a gap of which no reach is known is a hard question. Fewer are
  // held against it one by one.
  std::size_t many_for_a_gap = 0;
};

enum class hard_questions { asked, left_open };

// Audits a mesh as audit() does, but leaves questions about stars open that are hard. Unless there
// is none the mesh is not certified.
audit_report audit_quickly(const mesh& subject, const audit_options& options, star_memory& memory);

// Audits the numbers of a mesh alone: points and tensors, indices and repetitions.
audit_report audit_numbers(const mesh& subject);

// Asks the filters of edge_test those open questions for which `is_asked`, in their order. What
// they find in order leaves the list; of others `refuse` is told, among them gaps, and what only
// exact numbers could answer. The report is certified then if nothing is found and nothing open.
void ask_filters(const mesh& subject, const cancellation& stop,
                 const std::function<bool(const open_question&)>& is_asked,
                 const std::function<void(const open_question&)>& refuse,
                 std::vector<open_question>& open, audit_report& report);

// Returns what audit() would report, or audit_quickly() where hard questions are left open, but for
// the counts of work, which are of both audits.
// Requires: `before` is an audit of the same mesh but for the sites in `changed`, with the same
// options, and `memory` its memory, or a new one; it looked at all stars, without cutting anything
// short; and of each of its findings about stars, and of each question that is still open, a vertex
// is in `changed`, be it changed or not. Sites may have other tensors; inside, they may also be
// elsewhere, or be gone, and triangles be others, all corners of which are in `changed`.
// Subsegments are the same. The memory has the reaches of the sites as they are numbered now.
audit_report audit_again(const mesh& subject, const audit_options& options,
                         const audit_report& before, const std::vector<vertex_index>& changed,
                         star_memory& memory, hard_questions hard);

}  // namespace asterism::internal
