// SPDX-License-Identifier: MIT
//
// Selects who tests stars against all sites: the mesher or the audit.
#pragma once

namespace asterism::internal {

// The auditor asks of every finished star, from the mesh alone, what `by_mesher` asks of it before.
// So where an audit follows at once the mesher need not, but for stars in doubt: nearly always all
// are final. Where the audit finds that one is not, the mesh is to be made once more, by_mesher.
// `by_auditor_if_calm` leaves to it only stars whose edges both ends measure about alike: guesses
// from a triangulation of given sites, which may be far apart where the metric turns, are wrong
// elsewhere too often.
enum class star_confirmation { by_mesher, by_auditor_if_calm, by_auditor };

}  // namespace asterism::internal
