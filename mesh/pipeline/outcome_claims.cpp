// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/outcome_claims.hpp"

#include "asterism/mesh/pipeline/outcome_text.hpp"

namespace asterism::internal {
namespace {

// True if the reason is that of a mesh in one metric for all sites that meets all demands
// (pipeline/outcome_text.cpp). The cause that such a reason states is not checked here.
bool is_of_one_metric(const std::string& reason) {
  return reason.starts_with("stars cannot agree in the metric given (") &&
         reason.find("; they agree in one metric for all, which differs from it at ") !=
             std::string::npos;
}

// True if the reason is one that a completed run states: the reason of `certify` for an unchanged
// mesh, or a reason of the mesher.
bool is_reason_of_completed(const certificate& claim) {
  if (claim.options.count("mesh") != 0 && claim.reason == certified_as_it_came) return true;
  if (claim.delivered && is_of_one_metric(claim.reason)) return true;
  mesh_outcome completed;
  completed.complete = true;
  completed.delivered = claim.delivered;
  for (const bool nothing_added : {false, true}) {
    completed.ended.nothing_added = nothing_added;
    if (claim.reason == ending_text(completed)) return true;
  }
  return false;
}

}  // namespace

std::vector<std::string> contradictions_in_outcome(const certificate& claim) {
  if (!claim.complete || claim.metric.empty() || is_reason_of_completed(claim)) return {};
  return {"\"outcome.complete\" is true, and \"outcome.reason\" is not that of a completed run: " +
          claim.reason};
}

}  // namespace asterism::internal
