// SPDX-License-Identifier: MIT
//
// Selects who tests stars against all sites: the mesher or the audit.
#pragma once

namespace asterism::internal {

// Selects how finished stars are tested against all sites. The auditor asks of every finished star,
// from the mesh alone, the same question that `by_mesher` makes the mesher ask. So where an audit
// follows, the mesher need only test stars in doubt: nearly always all are final. If the audit
// finds one that is not, the mesh must be made again, by_mesher. `by_auditor_if_calm` leaves to the
// audit only stars whose edges have about the same length in both ends' metrics: other guesses from
// a triangulation of given sites, which may be far apart where the metric turns, are wrong too
// often.
enum class star_confirmation { by_mesher, by_auditor_if_calm, by_auditor };

}  // namespace asterism::internal
