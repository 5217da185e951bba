// SPDX-License-Identifier: MIT
//
// Judges the parts of a mesh that nothing is certified of: frozen triangles, and sides of second
// order.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "asterism/apps/text/verify_question.hpp"
#include "asterism/apps/verify/verify_mesh.hpp"
#include "asterism/core/result.hpp"

namespace asterism::apps {

// Takes the triangles of regions out that the certificate says were frozen, and compares them with
// those of the mesh that was adapted.
std::optional<error> take_frozen(const std::optional<certificate>& claim, judged_mesh& subject,
                                 std::vector<std::string>& contradictions);

// Numbers the segments of a mesh whose file has no place for that by those of the domain.
void number_segments(const verify_options& options, const domain& shape, judged_mesh& m);

// Judges the triangles of second order that the file holds, and what the certificate says of them.
// Nothing where the file holds none.
std::optional<second_order_report> judge_second_order(const judged_mesh& subject,
                                                      const std::optional<certificate>& claim,
                                                      const domain* shape,
                                                      std::vector<std::string>& contradictions);

}  // namespace asterism::apps
