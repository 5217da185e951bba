// SPDX-License-Identifier: MIT
//
// Audits a mesh whose stars were all looked at before, and of which some tensors were changed
// since. Internal to the library.
//
// The answer to "does the star of v accept w between x and y" depends on these four sites, and on
// the subsegments between v and w, alone. So only those questions are asked again of which a site
// was changed; the answers to the others are the ones there were.
#pragma once

#include <vector>

#include "asterism/mesh/audit/audit.hpp"

namespace asterism::internal {

// Returns what audit() would report, but for the counts of work, which are of both audits.
// Requires: `before` is an audit of the same mesh but for the tensors of the sites in `changed`,
// with the same options; it looked at all stars, without cutting anything short; and all vertices
// of its findings about stars are in `changed`, be they changed or not.
audit_report audit_again(const mesh& subject, const audit_options& options,
                         const audit_report& before, const std::vector<vertex_index>& changed);

}  // namespace asterism::internal
