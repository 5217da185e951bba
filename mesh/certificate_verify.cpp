// SPDX-License-Identifier: MIT
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

}  // namespace asterism
