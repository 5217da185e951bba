// SPDX-License-Identifier: MIT
//
// Writes summaries of a run in lines of text; certificates hold some of them too.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "asterism/mesh/audit/audit_report.hpp"
#include "asterism/mesh/audit/guarantee_claim.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/outcome.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/domain/cracks.hpp"
#include "asterism/mesh/metric/graded_field.hpp"
#include "asterism/mesh/pipeline/certified_mesh.hpp"
#include "asterism/mesh/pipeline/foreign_mesh.hpp"

namespace asterism::apps {

// Returns one line on the repairs of a domain.
std::string text_of(const domain_repairs& done);
// Returns one line on the effect of gradation.
std::string text_of(const gradation_report& done);
// Returns one line on the passes that improved the finished mesh; `sites` is the present number.
std::string text_of(const improvement_report& done, std::size_t sites);

// Returns one line on a guarantee.
std::string text_of(const guarantee_claim& kept, const theorem_hypotheses& measured);

// Returns a line on the slits whose vertices the files contain twice; empty without any.
std::string cracks_text(const crack_markers& cracks);

// Returns one line on the distance of the mesh's metric from the one wanted.
std::string text_of(const delivered_report& done);

// Writes the line that a mesh job is judged by, its verdict first, to standard output or a given
// stream, and a line of the regions' areas where there are several. `unit_edges` is their share of
// all edges, where that is to be shown.
void write_summary(std::ostream& out, const certified_mesh& made, std::optional<double> unit_edges);

// Writes the names of the files written, and the seconds of wall time since `start`.
void write_files_written(std::ostream& out, const std::vector<std::filesystem::path>& files,
                         std::chrono::steady_clock::time_point start);

// Writes the results for a mesh that came from elsewhere.
void write_report(std::ostream& out, const certify_report& report, const mesh& m,
                  double angle_bound, bool all_findings);

}  // namespace asterism::apps
