// SPDX-License-Identifier: MIT
//
// States all that is known of a finished mesh, beside it, so that anybody can check it again.
//
// As a file: JSON, UTF-8, the same bytes for the same run (no times, no machine). Numbers are
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

  // The question; make_certificate leaves these to whoever ran the mesher.
  std::string metric;                          // as --metric takes it
  std::map<std::string, std::string> options;  // by name, as text
  bool complete = false;                       // the mesher reached its goal
  std::string reason;                          // one sentence: why it ended
  tier_counters mesher_counters;               // of the kernel that made the mesh

  // The mesh, as counted and audited.
  std::size_t sites = 0, triangles = 0, boundary_subsegments = 0, given = 0;
  std::uint64_t fingerprint = 0;
  std::size_t star_repairs = 0;  // stars a local search had got wrong, mended before the end
  // Set if the mesh was made by local changes, or in one metric for all sites: its metric against
  // the one wanted.
  std::optional<delivered_report> delivered;
  // Finite measurements of numerics/mesh_statistics.hpp, by the names there.
  std::map<std::string, double> measured;
  std::optional<double> angle_bound;  // degrees
  // The least angle that the bound is asked of, the least of those that are collateral, and the
  // least exempt (audit_report); 180 where there is none, in the file null.
  double worst_angle = 180, worst_collateral = 180, worst_exempt = 180;
  std::vector<vertex_index> exempt_corners;
  // Triangles with an angle of the kind below the bound.
  std::vector<vertex_index> exempt_triangles, collateral_triangles, low_triangles;
  double largest_deviation = 0;
  curve_report curves;                     // in the file if the domain has curves
  former_boundary_report former_distance;  // in the file if there is a former boundary
  // In the file if there is another region than 1. `before` is set by whoever adapted a mesh.
  std::vector<region_area> regions;
  bool domain_checked = false, angles_checked = false, stars_checked = false;
  bool certified = false;
  voronoi_verdict voronoi = voronoi_verdict::not_asked;
  std::map<std::string, std::size_t> found;  // findings by kind, those that occurred
  std::vector<std::string> witnesses;        // "kind: sentence"
  tier_counters audit_counters;
  // Measurements for the theorem on nets, which say whether it applies to the sites. Set for a
  // certified mesh with an angle bound alone.
  std::optional<theorem_hypotheses> theorem;
  // Set if a guarantee was asked for and is kept: the theorem applies then. Left to whoever ran the
  // mesher.
  std::optional<guarantee_claim> guarantee;
  // Proof of the second-order triangles of the files that hold them. Set by whoever wrote these.
  std::optional<second_order_report> second_order;

  std::optional<domain> original;  // the domain that point 2 is repeated against
  // The boundary that the mesh took the place of, where its domain was made of a mesh; left to
  // whoever ran the mesher, as is how far it is.
  std::optional<former_boundary> former;

  // The sides that were to have the same points, a part of the question, and how they match, in the
  // same order; left to whoever ran the mesher. Sides that do not match have no entry.
  std::vector<periodic_pair> periodic_asked;
  std::vector<periodic_match> periodic;
};

// Returns a 64-bit FNV-1a hash of everything a .mesh and its .sol hold: numbers of each, positions
// and metrics bit for bit, triangles and their regions, boundary edges with their markers. It tells
// files apart; it is no protection against forgery, for which verify() repeats the audit.
ASTERISM_EXPORT std::uint64_t mesh_fingerprint(const mesh& subject);

// Makes the certificate of an audited mesh, and measures whether the theorem on nets applies.
// `report` must be of an audit of `subject` with `options`.
ASTERISM_EXPORT certificate make_certificate(const mesh& subject, const audit_options& options,
                                             const audit_report& report);
// Does the same with the theorem as it was measured before; none where it was not asked about.
ASTERISM_EXPORT certificate make_certificate(const mesh& subject, const audit_options& options,
                                             const audit_report& report,
                                             std::optional<theorem_hypotheses> theorem);
// True if a certificate says whether the theorem applies: of a certified mesh with an angle bound.
// A bound of 0 asks for no angle.
ASTERISM_EXPORT bool is_theorem_asked(const audit_options& options, const audit_report& report);

// Returns the text of the file.
ASTERISM_EXPORT std::string certificate_text(const certificate& c);
// Reads the text of a file. `name` is the file's, for messages.
ASTERISM_EXPORT result<certificate> parse_certificate(const std::string& text,
                                                      const std::string& name);

// Writes the file. Errors name it. Nothing is left behind by a failed write.
ASTERISM_EXPORT result<std::filesystem::path> write_certificate(const std::filesystem::path& path,
                                                                const certificate& c);
// Reads a file. Errors name it.
ASTERISM_EXPORT result<certificate> read_certificate(const std::filesystem::path& path);

}  // namespace asterism
