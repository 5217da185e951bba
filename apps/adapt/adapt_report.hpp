// SPDX-License-Identifier: MIT
//
// Describes a run of `adapt`: on a page, in lines, and by the step to take next.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

#include "asterism/apps/adapt/adapt_job.hpp"
#include "asterism/apps/text/adaptation_json.hpp"
#include "asterism/mesh/draw/report.hpp"

namespace asterism::apps {

// Returns what the page shows: the mesh before the adaptation, and the solution on both meshes.
report_facts facts_of_page(const adapt_job& job, const std::filesystem::path& certificate_path,
                           const adapted& made);

// Returns the facts for programs.
adapt_facts facts_of(const adapted& made);

// Writes the summary.
void summarize(std::ostream& out, const adapt_job& job, const adapted& made);

// Returns an option to add after a run that did not reach its goal; empty where none would help. A
// bound on sizes where most of the complexity is on edges as long as the domain, as it is where the
// solution varies in one direction alone. A greater distance where the boundary bends and leaves
// more vertices than were wanted, or angles below the bound.
std::string next_step(const adapt_job& job, const adapted& made);

}  // namespace asterism::apps
