// SPDX-License-Identifier: MIT
//
// States everything proved and measured of a finished mesh, in a file beside it, so that it can be
// checked again.
//
// The file is JSON, UTF-8, the same bytes for the same run (no times, no machine). Numbers are
// written so that they read back to the same doubles; vertices, triangles and boundary edges are
// counted from 1, as in a .mesh file, though the fields below count from 0.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/kernels/tier_counters.hpp"
#include "asterism/mesh/audit/audit_report.hpp"
#include "asterism/mesh/audit/curved_triangles.hpp"
#include "asterism/mesh/audit/guarantee_claim.hpp"
#include "asterism/mesh/audit/periodic_match.hpp"
#include "asterism/mesh/audit/region_areas.hpp"
#include "asterism/mesh/audit/theorem_report.hpp"
#include "asterism/mesh/data/delivered_report.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/former_boundary.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/metric_field.hpp"

namespace asterism {

// A certificate in memory. Indices count from 0.
struct certificate {
  std::string version;  // of the program that made it

  // The question: what was asked of the mesher and how. make_certificate leaves these empty for the
  // caller.
  std::string metric;                          // as --metric takes it
  std::map<std::string, std::string> options;  // by name, as text
  bool complete = false;                       // the mesher reached its goal
  std::string reason;                          // one sentence: why it ended
  tier_counters mesher_counters;               // of the kernel that made the mesh

  // Measurements of the mesh, as counted and audited.
  std::size_t sites = 0, triangles = 0, boundary_subsegments = 0, given = 0;
  std::uint64_t fingerprint = 0;
  std::size_t star_repairs = 0;  // stars a local search had got wrong, mended before the end
  // Distance of the mesh's metric from the one wanted. Set if the mesh was made by local changes,
  // or in one metric for all sites.
  std::optional<delivered_report> delivered;
  // Finite measurements of numerics/mesh_statistics.hpp, by the names that are used there.
  std::map<std::string, double> measured;
  std::optional<double> angle_bound;  // degrees
  // Least angles in degrees: of those that must meet the bound, of the collateral and of the exempt
  // ones (audit_report); 180, and null in the file, where there is none.
  double worst_angle = 180, worst_collateral = 180, worst_exempt = 180;
  std::vector<vertex_index> exempt_corners;
  // Numbers of triangles with an angle of the kind below the bound.
  std::vector<vertex_index> exempt_triangles, collateral_triangles, low_triangles;
  double largest_deviation = 0;
  curve_report curves;                     // in the file if the domain has curves
  former_boundary_report former_distance;  // in the file if there is a former boundary
  // Areas of the regions, in the file if some region has another number than 1. The caller that
  // adapted a mesh sets `before`, the area before the adaptation.
  std::vector<region_area> regions;
  bool domain_checked = false, angles_checked = false, stars_checked = false;
  bool certified = false;
  voronoi_verdict voronoi = voronoi_verdict::not_asked;
  std::map<std::string, std::size_t> found;  // findings by kind, those that occurred
  std::vector<std::string> witnesses;        // "kind: sentence"
  tier_counters audit_counters;
  // Measurements that tell whether the theorem on nets applies to the sites. Set only for a
  // certified mesh with an angle bound.
  std::optional<theorem_hypotheses> theorem;
  // Set if a guarantee was asked for and is kept, which means that the theorem applies. Left to the
  // caller that ran the mesher.
  std::optional<guarantee_claim> guarantee;
  // Proof of the second-order triangles in the files written beside. Set by the writer of these.
  std::optional<second_order_report> second_order;

  std::optional<domain> original;  // the domain that point 2 is repeated against
  // The former boundary that the domain was made of, and the distance of the mesh's boundary from
  // it; left to the caller that ran the mesher.
  std::optional<former_boundary> former;

  // Pairs of sides that were to have the same points, a part of the question, and how each pair
  // matches, in the same order; pairs that do not match have no entry. Left to the caller that ran
  // the mesher.
  std::vector<periodic_pair> periodic_asked;
  std::vector<periodic_match> periodic;
};

// Returns a 64-bit FNV-1a hash of everything a .mesh and its .sol hold: numbers of each, positions
// and metrics bit for bit, triangles and their regions, boundary edges with their markers. It tells
// files apart; it is no protection against forgery, for which verify() repeats the audit.
ASTERISM_EXPORT std::uint64_t mesh_fingerprint(const mesh& subject);

// Makes the certificate of an audited mesh, and measures whether the theorem on nets applies.
// `report` must come from an audit of `subject` with `options`.
ASTERISM_EXPORT certificate make_certificate(const mesh& subject, const audit_options& options,
                                             const audit_report& report);
// Makes the certificate with hypotheses of the theorem that were measured before; none if the audit
// had no angle bound.
ASTERISM_EXPORT certificate make_certificate(const mesh& subject, const audit_options& options,
                                             const audit_report& report,
                                             std::optional<theorem_hypotheses> theorem);
// True if the certificate of this report states whether the theorem applies: if the mesh is
// certified with an angle bound above 0.
ASTERISM_EXPORT bool is_theorem_asked(const audit_options& options, const audit_report& report);

// Returns the JSON text of the certificate's file.
ASTERISM_EXPORT std::string certificate_text(const certificate& c);
// Reads a certificate from its JSON text. `name` is the file's, for messages.
ASTERISM_EXPORT result<certificate> parse_certificate(const std::string& text,
                                                      const std::string& name);

// Writes the certificate to a file. Errors name it. A failed write leaves no file behind.
ASTERISM_EXPORT result<std::filesystem::path> write_certificate(const std::filesystem::path& path,
                                                                const certificate& c);
// Reads the certificate in a file. Errors name it.
ASTERISM_EXPORT result<certificate> read_certificate(const std::filesystem::path& path);

}  // namespace asterism
