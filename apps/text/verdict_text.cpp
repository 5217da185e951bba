// SPDX-License-Identifier: MIT
#include "asterism/apps/text/verdict_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace asterism::apps {

std::size_t findings_kept(bool all) {
  return all ? std::numeric_limits<std::size_t>::max() : audit_options{}.findings_kept;
}

void write_findings(std::ostream& out, const audit_report& report) {
  std::array<std::size_t, finding_kind_count> told{};
  for (const audit_finding& f : report.findings) {
    const auto kind = static_cast<std::size_t>(f.kind);
    ++told[kind];
    out << finding_kind_names[kind] << ": " << f.witness << '\n';
  }
  for (std::size_t kind = 0; kind < finding_kind_count; ++kind)
    if (report.found[kind] > told[kind])
      out << finding_kind_names[kind] << ": " << report.found[kind] - told[kind]
          << " more (--all-findings lists them)\n";
}

std::string worst_angle_text(double degrees) {
  if (degrees >= 180) return "no angle to judge";
  return fmt::format("worst angle {:.2f} degrees", degrees);
}

std::string angles_text(const audit_report& report) {
  std::string text = worst_angle_text(report.worst().degrees);
  if (!report.exempt_corners.empty())
    text += fmt::format(", {} of {} triangles exempt at {} corners", report.exempt_triangles.size(),
                        report.triangles, report.exempt_corners.size());
  if (!report.exempt_triangles.empty())
    text += fmt::format(", the sharpest {:.2f}", report.worst_exempt.degrees);
  if (!report.collateral_triangles.empty())
    text += fmt::format(", {} collateral beside sharp corners, the worst {:.2f}",
                        report.collateral_triangles.size(), report.worst_collateral.degrees);
  return text;
}

std::string deviation_text(const audit_report& report) {
  if (!(report.largest_deviation_ulps > 1)) return "";
  return fmt::format("; points of split segments off them by up to {:.3g} ({:.2f} ulps)",
                     report.largest_deviation, report.largest_deviation_ulps);
}

std::string curves_text(const audit_report& report) {
  const curve_report& curves = report.curves;
  if (curves.curves == 0) return "";
  return fmt::format("; within {:.3g} of its {} curves, {} vertices on them{}",
                     curves.largest_distance, curves.curves, curves.vertices,
                     curves.off_curve > 0 ? fmt::format(", {} on chords", curves.off_curve) : "");
}

std::string regions_text(const std::vector<region_area>& regions) {
  if (regions.empty()) return "";
  constexpr std::size_t most = 10;
  const bool was_adapted =
      std::any_of(regions.begin(), regions.end(), [](const auto& r) { return r.before; });
  const bool is_compared = was_adapted || regions.front().domain.has_value();
  std::string text = "areas of regions" + std::string(was_adapted   ? " before and after: "
                                                      : is_compared ? " in domain and mesh: "
                                                                    : ": ");
  for (std::size_t i = 0; i < std::min(most, regions.size()); ++i) {
    const region_area& r = regions[i];
    const double before = was_adapted ? r.before.value_or(0) : r.domain.value_or(0);
    text += fmt::format("{}{} (", i == 0 ? "" : ", ", r.number);
    text += is_compared ? fmt::format("{:.12g}, {:.12g})", before, r.mesh)
                        : fmt::format("{:.12g})", r.mesh);
  }
  if (regions.size() > most) text += fmt::format(", and {} more", regions.size() - most);
  return text;
}

std::string former_text(const std::optional<certificate>& claim) {
  if (!claim || !claim->former) return "";
  return fmt::format("; within {:.3g} of the boundary before, both ways",
                     claim->former_distance.largest_distance);
}

std::string periodic_text(const std::vector<periodic_match>& matches) {
  std::string text;
  for (const periodic_match& one : matches)
    text += (text.empty() ? "; periodic: " : "; ") + asterism::text_of(one);
  return text;
}

std::string cut_short_text(const audit_report& report) {
  if (!report.stars_cut_short) return "";
  return "not all stars were looked at, as a tenth of the sites or more was refused already";
}

std::string theorem_text(const theorem_hypotheses& measured) {
  if (!measured.applies) return "does not apply: " + measured.reason;
  return fmt::format("applies: at sigma eps {:.4g} angles of {} degrees are proved",
                     measured.sigma_eps, measured.proved_angle);
}

std::string voronoi_text(const audit_report& report) {
  if (report.voronoi == voronoi_verdict::not_asked) return "";
  return fmt::format("; dual of the Voronoi diagram: {}",
                     voronoi_verdict_names[static_cast<std::size_t>(report.voronoi)]);
}

}  // namespace asterism::apps
