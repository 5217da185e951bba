// SPDX-License-Identifier: MIT
//
// Tells about a run in lines for people; certificates hold some of them too.
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

// Tells what was repaired in a domain, in one line.
std::string text_of(const domain_repairs& done);
// Tells what gradation did, in one line.
std::string text_of(const gradation_report& done);
// Tells what the passes over the finished mesh did, in one line; `sites` are there now.
std::string text_of(const improvement_report& done, std::size_t sites);

// Tells what a guarantee says, in one line.
std::string text_of(const guarantee_claim& kept, const theorem_hypotheses& measured);

// Returns a line on the slits whose vertices are there twice in the files; empty without any.
std::string cracks_text(const crack_markers& cracks);

// Tells how far the metric of the mesh is from the one wanted, in one line.
std::string text_of(const delivered_report& done);

// Writes the line that a mesh job is judged by, its verdict first, to standard output or as if to
// it, and a line of the regions' areas where there are several. `unit_edges` is their part of all,
// if it is asked about.
void write_summary(std::ostream& out, const certified_mesh& made, std::optional<double> unit_edges);

// Writes the names of the files written, and the seconds of wall time since `start`.
void write_files_written(std::ostream& out, const std::vector<std::filesystem::path>& files,
                         std::chrono::steady_clock::time_point start);

// Writes what was found about a mesh that came from elsewhere.
void write_report(std::ostream& out, const certify_report& report, const mesh& m,
                  double angle_bound, bool all_findings);

}  // namespace asterism::apps
