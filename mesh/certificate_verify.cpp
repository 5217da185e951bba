// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>
#include <string_view>

#include "asterism/mesh/certificate.hpp"

namespace asterism {
namespace {

void compare(std::vector<std::string>& contradictions, std::string_view what, std::size_t claimed,
             std::size_t counted) {
  if (claimed != counted)
    contradictions.push_back("the certificate is of a mesh with " + std::to_string(claimed) + " " +
                             std::string(what) + ", this one has " + std::to_string(counted));
}

std::vector<std::string> contradictions_of(const mesh& subject, const certificate& claim,
                                           const audit_report& audited) {
  std::vector<std::string> all;
  compare(all, "vertices", claim.sites, audited.sites);
  compare(all, "given vertices", claim.given, audited.given);
  compare(all, "triangles", claim.triangles, audited.triangles);
  compare(all, "boundary edges", claim.boundary_pieces, audited.boundary_pieces);
  if (all.empty() && claim.fingerprint != mesh_fingerprint(subject))
    all.emplace_back("the certificate is of another mesh: the fingerprints differ");
  if (!claim.certified)
    all.emplace_back("the certificate itself says that its mesh was not certified");
  if (!claim.complete)
    all.push_back("the certificate itself says that its mesh was not completed: " + claim.reason);
  if (claim.complete && claim.relaxed && !claim.relaxed->low_triangles.empty())
    all.push_back("the certificate says that its mesh was completed, and lists " +
                  std::to_string(claim.relaxed->low_triangles.size()) +
                  " triangles that are below the bound in the metric asked for");
  return all;
}

}  // namespace

verify_report verify(const mesh& subject, const std::optional<certificate>& claim,
                     audit_options options) {
  if (claim) {
    if (!options.angle_bound) options.angle_bound = claim->angle_bound;
    if (options.original == nullptr && claim->original) options.original = &*claim->original;
    if (options.exempt_corners.empty()) options.exempt_corners = claim->exempt_corners;
    if (claim->voronoi == voronoi_verdict::proved) options.check_voronoi = true;
  } else {
    options.find_exempt_corners = true;
  }
  verify_report report;
  report.audit = audit(subject, options);
  if (claim) report.contradictions = contradictions_of(subject, *claim, report.audit);
  report.verified = report.audit.certified && report.contradictions.empty() &&
                    (!options.check_voronoi || report.audit.voronoi == voronoi_verdict::proved);
  return report;
}

std::optional<std::string> contradiction_in_low_triangles(const mesh& subject,
                                                          const certificate& claim,
                                                          const metric_field& asked) {
  if (!claim.relaxed || !claim.angle_bound) return std::nullopt;
  mesh as_asked = subject;
  for (site& s : as_asked.sites) {
    const auto metric = asked.at(s.position);
    if (!metric) return "the metric asked for fails: " + metric.failure().message;
    s.metric = metric.value();
  }
  audit_options options;
  options.angle_bound = claim.angle_bound;
  options.find_exempt_corners = true;
  options.check_stars = false;
  const std::vector<index> low = audit(as_asked, options).low_triangles;
  if (low == claim.relaxed->low_triangles) return std::nullopt;
  std::vector<index> in_one;
  std::set_symmetric_difference(low.begin(), low.end(), claim.relaxed->low_triangles.begin(),
                                claim.relaxed->low_triangles.end(), std::back_inserter(in_one));
  return "as the metric asked for measures them " + std::to_string(low.size()) +
         " triangles are below the bound, and the certificate lists " +
         std::to_string(claim.relaxed->low_triangles.size()) +
         (in_one.empty() ? " in another order"
                         : "; triangle " + std::to_string(std::size_t{in_one[0]} + 1) +
                               " is the first that differs");
}

}  // namespace asterism
