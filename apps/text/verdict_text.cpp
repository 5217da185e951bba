// SPDX-License-Identifier: MIT
#include "asterism/apps/text/verdict_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/support/one_line.hpp"

namespace asterism::apps {
using namespace internal;
namespace {

// A number in a sentence, or the text before one.
struct sentence_part {
  std::string text;
  std::optional<double> number = std::nullopt;
};

bool is_of_number(char c) {
  return (c >= '0' && c <= '9') || c == '.' || c == 'e' || c == '-' || c == '+';
}

std::vector<sentence_part> parts_of(std::string_view sentence) {
  std::vector<sentence_part> parts;
  std::size_t done = 0;
  for (std::size_t at = 0; at < sentence.size();) {
    const bool begins_word = at == 0 || sentence[at - 1] == ' ' || sentence[at - 1] == '(';
    std::size_t end = at;
    while (begins_word && end < sentence.size() && is_of_number(sentence[end])) ++end;
    const std::string word(sentence.substr(at, end - at));
    if (const auto number = parse_number(word)) {
      parts.push_back({std::string(sentence.substr(done, at - done))});
      parts.push_back({word, number.value()});
      done = end;
    }
    at = std::max(end, at + 1);
  }
  parts.push_back({std::string(sentence.substr(done))});
  return parts;
}

// Removes the place of a vertex where the sentence has stated it before.
std::string with_places_once(std::string sentence) {
  std::set<std::string> told;
  const std::string_view mark = "vertex ";
  for (std::size_t at = sentence.find(mark); at != std::string::npos;
       at = sentence.find(mark, at + 1)) {
    const std::size_t open = sentence.find(" (", at);
    const std::size_t after = sentence.find_first_not_of("0123456789", at + mark.size());
    if (open == std::string::npos || open != after) continue;
    const std::size_t close = sentence.find(')', open);
    if (close != std::string::npos && !told.insert(sentence.substr(at, open - at)).second)
      sentence.erase(open, close + 1 - open);
  }
  return sentence;
}

// Returns a finding's sentence with the digits that people read: six of each number with a fraction
// or an exponent, unless another number of the sentence has the same six, and the place of each
// vertex once. Whole numbers keep all digits, since they name vertices, triangles and regions.
// Certificates and --json have all digits of all numbers.
std::string short_witness(const std::string& witness) {
  std::vector<sentence_part> parts = parts_of(with_places_once(one_line(witness)));
  std::map<std::string, std::set<double>> alike;
  for (const sentence_part& part : parts)
    if (part.number) alike[fmt::format("{:.6g}", *part.number)].insert(*part.number);
  std::string text;
  for (const sentence_part& part : parts) {
    const std::string rounded = part.number ? fmt::format("{:.6g}", *part.number) : "";
    const bool is_shorter = part.number && rounded.size() < part.text.size() &&
                            part.text.find_first_of(".e") != std::string::npos;
    text += is_shorter && alike[rounded].size() == 1 ? rounded : part.text;
  }
  return text;
}

// One angle as some of its triangle's vertices measure it: the sentence before their numbers, the
// numbers, and the sentence behind them.
struct measured_angle {
  std::string before;
  std::vector<std::string> vertices;
  std::string after;
};

std::optional<measured_angle> angle_of(const std::string& sentence) {
  const std::string_view mark = " degrees in the metric of vertex ";
  const std::size_t at = sentence.find(mark);
  if (at == std::string::npos) return std::nullopt;
  const std::size_t number = at + mark.size();
  const std::size_t end =
      std::min(sentence.find_first_not_of("0123456789", number), sentence.size());
  return measured_angle{
      sentence.substr(0, at), {sentence.substr(number, end - number)}, sentence.substr(end)};
}

std::string text_of(const measured_angle& angle) {
  const std::vector<std::string>& v = angle.vertices;
  std::string text = angle.before + " degrees in the " +
                     (v.size() == 1 ? "metric of vertex " : "metrics of vertices ") + v.front();
  for (std::size_t i = 1; i < v.size(); ++i) text += (i + 1 < v.size() ? ", " : " and ") + v[i];
  return text + angle.after;
}

// Returns the sentences, with one for successive ones that give an angle the same degrees, as its
// vertices do where the metric is constant.
std::vector<std::string> with_angles_once(const std::vector<std::string>& sentences) {
  std::vector<std::string> all;
  std::optional<measured_angle> last;
  for (const std::string& sentence : sentences) {
    const auto angle = angle_of(sentence);
    if (angle && last && angle->before == last->before && angle->after == last->after) {
      last->vertices.push_back(angle->vertices.front());
      all.back() = text_of(*last);
    } else {
      last = angle;
      all.push_back(sentence);
    }
  }
  return all;
}

}  // namespace

std::size_t findings_kept(bool all) {
  return all ? std::numeric_limits<std::size_t>::max() : audit_options{}.findings_kept;
}

void write_findings(std::ostream& out, const audit_report& report) {
  std::array<std::size_t, finding_kind_count> told{};
  std::vector<std::string> lines;
  for (const audit_finding& f : report.findings) {
    const auto kind = static_cast<std::size_t>(f.kind);
    ++told[kind];
    lines.push_back(std::string(finding_kind_names[kind]) + ": " + short_witness(f.witness));
  }
  for (const std::string& line : with_angles_once(lines)) out << line << '\n';
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
