// SPDX-License-Identifier: MIT
//
// Describes the outcome of a command for programs: one JSON object, UTF-8, in place of lines of
// text. Names stay as they are; others may be added.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "asterism/apps/text/verify_question.hpp"
#include "asterism/mesh/pipeline/certified_mesh.hpp"
#include "asterism/mesh/pipeline/foreign_mesh.hpp"

namespace asterism::apps {

// Returns the object of `mesh`, with the files written and what to try next ("" for nothing).
std::string summary_json(const certified_mesh& made, int status,
                         const std::vector<std::filesystem::path>& files, const std::string& next);

// Returns the object of `verify`. `scope` states in words what was checked against what.
std::string summary_json(const judgement& judged, int status, const std::string& scope);

// Returns the object of `certify`.
std::string summary_json(const certify_report& report, int status, double angle_bound,
                         const std::optional<second_order_report>& second_order);

}  // namespace asterism::apps
