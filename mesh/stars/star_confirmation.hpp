// SPDX-License-Identifier: MIT
//
// Selects who tests stars against all sites: the mesher or the audit.
#pragma once

namespace asterism::internal {

// Selects how finished stars are tested against all sites. With `by_mesher` the mesher tests every
// star. The audit makes the same tests for every star, from the mesh alone. So where an audit
// follows, `by_auditor` lets the mesher test only stars in doubt: nearly always all are final. If
// the audit finds one that is not, the mesh must be made again with `by_mesher`.
// `by_auditor_if_lengths_agree` leaves to the audit only stars whose edges have about the same
// length in both ends' metrics: other guesses from a triangulation of given sites, whose edges may
// be long where the metric turns, are wrong too often.
enum class star_confirmation { by_mesher, by_auditor_if_lengths_agree, by_auditor };

}  // namespace asterism::internal
