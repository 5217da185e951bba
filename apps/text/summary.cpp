// SPDX-License-Identifier: MIT
#include "asterism/apps/text/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>
#include <string>
#include <utility>

#include "asterism/apps/base/terminal.hpp"
#include "asterism/apps/options/second_order_text.hpp"
#include "asterism/apps/text/verdict_text.hpp"
#include "asterism/core/elementary.hpp"
#include "asterism/mesh/support/one_line.hpp"

namespace asterism::apps {
using namespace internal;
namespace {

void write_triangles(std::ostream& out, const certify_report& report, const mesh& m, bool all) {
  const std::size_t most = std::min(findings_kept(all), report.not_in_all.size());
  for (std::size_t i = 0; i < most; ++i) {
    const triangle& t = m.triangles[report.not_in_all[i]];
    out << "not of the stars: triangle " << report.not_in_all[i] + 1 << " of vertices " << t[0] + 1
        << ", " << t[1] + 1 << ", " << t[2] + 1 << '\n';
  }
  if (report.not_in_all.size() > most)
    out << "not of the stars: " << report.not_in_all.size() - most
        << " more (--all-findings lists them)\n";
}

// Returns the verdict on the result of a run: the first words of its line.
std::string verdict_of(const certified_mesh& made) {
  if (made.certified()) return in_colour("certified", ink::green, 1);
  if (made.outcome.delivered && made.report.certified)
    return in_colour("certified", ink::yellow, 1) + " in the metric delivered, NOT complete";
  return in_colour("NOT certified", ink::red, 1) + ", incomplete";
}

// Returns the mean length of edges, where most have no metric length near 1; else nothing. Of a
// domain whose sides are shorter than the size no mesh has such edges, and a metric that was made
// without a size may have any lengths.
std::string mean_length_text(double part, double mean) {
  return part < 0.5 && mean > 0 ? fmt::format(" (mean length in the metric {:.3g}, not 1)", mean)
                                : "";
}

// Returns the share of edges with a metric length near 1.
std::string unit_edges_text(double part, const std::map<std::string, double>& measured) {
  const auto mean = measured.find("mean_length");
  return fmt::format("{:.2f}% unit edges", part * 100) +
         mean_length_text(part, mean == measured.end() ? 0 : mean->second);
}

// Returns a change of lengths, from the logarithm of its factor: in percent up to 99 %, and as a
// factor beyond.
std::string change_text(double logarithm) {
  const double factor = elementary::exp(logarithm);
  // Writes 99 % and more as a factor: with two digits 99.5 % would be 1e+02 %.
  if (factor >= 1.99) return fmt::format("{:.3g} times", factor);
  return fmt::format("{:.2g} %", 100 * (factor - 1));
}

}  // namespace

std::string text_of(const domain_repairs& done) {
  return fmt::format(
      "within {:.3g}: {} crossings made vertices, {} vertices joined, {} segments bent to "
      "vertices, "
      "{} cut off, {} holes dropped; nothing moved by more than about {:.3g}",
      done.distance, done.crossings, done.joined_vertices + done.merged_vertices,
      done.bent_segments, done.trimmed_segments, done.dropped_holes, done.greatest_move);
}

std::string text_of(const gradation_report& done) {
  std::string text = std::to_string(done.changed) + " of " + std::to_string(done.nodes) +
                     " nodes changed, density at most times " +
                     fmt::format("{:.4g}", done.largest_growth);
  // Leaves out sizes of cells for a gradation on the nodes of a mesh, which has none.
  if (done.largest_cell > 0)
    text += fmt::format(", cells from {:.4g} to {:.4g}", done.smallest_cell, done.largest_cell);
  text += ", " + std::to_string(done.sweeps) + " sweeps";
  if (!done.resolved) text += "; the grid could not be made as fine as it should be";
  if (!done.settled) text += "; NOT settled";
  return text;
}

std::string text_of(const improvement_report& done, std::size_t sites) {
  return std::to_string(done.passes) + " passes of " + std::to_string(done.tries) + " tries, " +
         std::to_string(done.removed) + " removed, " + std::to_string(done.moved) + " moved, " +
         std::to_string(done.sites_before) + " to " + std::to_string(sites) +
         " sites, mean quality " +
         fmt::format("{:.4f} to {:.4f}", done.mean_quality_before, done.mean_quality_after) +
         (done.stopped ? "; stopped" : "");
}

std::string text_of(const guarantee_claim& kept, const theorem_hypotheses& measured) {
  std::string text = fmt::format(
      "edges {:.4g} times shorter than asked for; the theorem on nets applies: angles of {} "
      "degrees are proved at eps {:.4g} and sigma {:.4g}",
      kept.size_factor, measured.proved_angle, kept.eps, kept.sigma);
  text += kept.field_variation_bound
              ? fmt::format("; the field varies by at most {:.4g}", *kept.field_variation_bound)
              : std::string("; the field was sampled, and is not known between the samples");
  if (kept.times_least)
    text += fmt::format("; at most {:.3g} times the least sites inside{}", *kept.times_least,
                        kept.field_variation_bound ? "" : ", if it varies no faster there");
  return text;
}

std::string cracks_text(const crack_markers& cracks) {
  if (cracks.empty()) return "";
  std::string text = "slits: vertices are there once for each side, along edges of the markers";
  bool is_first = true;
  for (const auto& [number, sides] : cracks) {
    text += fmt::format("{} {}", std::exchange(is_first, false) ? "" : ",", sides.left);
    if (sides.right != sides.left) text += fmt::format(" and {}", sides.right);
  }
  return text + '\n';
}

std::string text_of(const delivered_report& done) {
  return fmt::format(
      "{:.1f} % of the sites have lengths changed by more than 10 %, median {:.1f} %, 90 % below "
      "{:.1f} %, greatest {}; complexity {:.6g} of {:.6g} wanted; {} {} below the bound in the "
      "metric wanted",
      100 * done.beyond_tenth, 100 * (elementary::exp(done.median) - 1),
      100 * (elementary::exp(done.ninetieth) - 1), change_text(done.greatest),
      done.complexity_delivered, done.complexity_wanted, done.low_wanted.size(),
      done.low_wanted.size() == 1 ? "triangle is" : "triangles are");
}

void write_summary(std::ostream& out, const certified_mesh& made,
                   std::optional<double> unit_edges) {
  const mesh_outcome& outcome = made.outcome;
  const audit_report& report = made.report;
  out << verdict_of(made) << ": " << report.sites << " sites, " << report.triangles
      << " triangles, " << angles_text(report);
  if (made.claim.angle_bound) out << fmt::format(" (bound {:.6g})", *made.claim.angle_bound);
  out << ", " << outcome.disagreeing << " disagreeing, "
      << (report.angles_checked ? report.low_triangles.size() : outcome.low_angle) << " low-angle";
  if (outcome.too_large > 0) out << ", " << outcome.too_large << " too large";
  if (outcome.ended.stars_missing > 0)
    out << ", " << outcome.ended.stars_missing << " stars never made";
  if (unit_edges) out << ", " << unit_edges_text(*unit_edges, made.claim.measured);
  if (report.voronoi != voronoi_verdict::not_asked)
    out << ", dual of the Voronoi diagram: "
        << voronoi_verdict_names[static_cast<std::size_t>(report.voronoi)];
  out << deviation_text(report) << curves_text(report) << '\n';
  if (!made.claim.regions.empty()) out << regions_text(made.claim.regions) << '\n';
  if (made.claim.second_order) out << text_of(*made.claim.second_order) << '\n';
}

void write_files_written(std::ostream& out, const std::vector<std::filesystem::path>& files,
                         std::chrono::steady_clock::time_point start) {
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  out << "written in " << fmt::format("{:.2f}", taken.count()) << " seconds: ";
  for (std::size_t i = 0; i < files.size(); ++i)
    out << (i == 0 ? "" : ", ") << printable(files[i].string());
  out << '\n';
}

namespace {

std::string unit_part_text(const certify_report& report) {
  if (report.edges == 0) return "";
  const double part = static_cast<double>(report.unit_edges) / static_cast<double>(report.edges);
  return fmt::format(" ({:.1f}%)", 100 * part) + mean_length_text(part, report.mean_length);
}

}  // namespace

void write_report(std::ostream& out, const certify_report& report, const mesh& m,
                  double angle_bound, bool all_findings) {
  out << (report.certified() ? in_colour("certified", ink::green, 1)
                             : in_colour("NOT certified", ink::red, 1))
      << ": " << m.sites.size() << " sites, " << m.triangles.size() << " triangles, "
      << m.boundary.size() << " boundary edges\n";
  write_findings(out, report.audit);
  write_triangles(out, report, m, all_findings);
  if (report.compared)
    out << "triangles in the stars of all three vertices: " << report.in_stars[3]
        << ", of some: " << report.in_stars[1] + report.in_stars[2]
        << ", of none: " << report.in_stars[0] << '\n';
  else
    out << "stars: not compared, "
        << (!report.is_triangulation()   ? "this is no triangulation\n"
            : report.audit.stars_checked ? "for this they are too far from agreeing\n"
                                         : "there was no time\n");
  if (report.audit.stars_cut_short) out << cut_short_text(report.audit) << '\n';
  if (report.unsettled > 0) out << "stars that did not settle: " << report.unsettled << '\n';
  out << "inverted or flat: " << report.inverted << '\n'
      << angles_text(report.audit) << ", triangles below " << angle_bound << ": "
      << report.below_bound << " (exempt: " << report.audit.exempt_triangles.size()
      << ", collateral: " << report.audit.collateral_triangles.size() << ")\n"
      << "edges of metric length 0.71 to 1.41: " << report.unit_edges << " of " << report.edges
      << unit_part_text(report) << '\n';
  if (report.audit.voronoi != voronoi_verdict::not_asked)
    out << "dual of the Voronoi diagram: "
        << voronoi_verdict_names[static_cast<std::size_t>(report.audit.voronoi)] << '\n';
  if (!report.regions.empty()) out << regions_text(report.regions) << '\n';
}

}  // namespace asterism::apps
