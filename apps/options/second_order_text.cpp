// SPDX-License-Identifier: MIT
#include "asterism/apps/options/second_order_text.hpp"

#include <fmt/format.h>

namespace asterism::apps {
namespace {

std::string refused_text(const second_order_report& report) {
  const bool is_certain = !report.folded.empty();
  const vertex_index first = is_certain ? report.folded.front() : report.undecided.front();
  return fmt::format("; {} folded, {} undecided, the first: triangle {}", report.folded.size(),
                     report.undecided.size(), first + 1);
}

}  // namespace

std::string text_of(const second_order_report& report) {
  std::string text = fmt::format(
      "second order: {} triangles, {} curved sides, {} on curves of the "
      "domain",
      report.triangles, report.curved_sides, report.on_curves);
  if (report.kept_straight > 0) text += fmt::format(", {} kept straight", report.kept_straight);
  if (!report.folded.empty() || !report.undecided.empty()) return text + refused_text(report);
  return text + fmt::format(
                    "; no triangle folds, the Jacobian is at least {:.4g} of the straight "
                    "triangle's",
                    report.least_jacobian);
}

}  // namespace asterism::apps
