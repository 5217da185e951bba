// SPDX-License-Identifier: MIT
//
// Judges the parts of a mesh that are not certified: frozen triangles, and sides of second
// order.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "asterism/apps/text/verify_question.hpp"
#include "asterism/apps/verify/verify_mesh.hpp"
#include "asterism/core/result.hpp"

namespace asterism::apps {

// Removes the triangles of regions that were frozen, by the certificate, and compares them with
// those of the mesh that was adapted.
std::optional<error> take_frozen(const std::optional<certificate>& claim, judged_mesh& subject,
                                 std::vector<std::string>& contradictions);

// Numbers the boundary edges of a mesh by the segments of the domain, for files without a place for
// that.
void number_segments(const verify_options& options, const domain& shape, judged_mesh& m);

// Judges the triangles of second order in the file, and the certificate's claims about them. Does
// nothing if the file has none.
std::optional<second_order_report> judge_second_order(const judged_mesh& subject,
                                                      const std::optional<certificate>& claim,
                                                      const domain* shape,
                                                      std::vector<std::string>& contradictions);

}  // namespace asterism::apps
