// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/certificate_writer.hpp"

#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "asterism/mesh/io/certificate_json.hpp"
#include "asterism/mesh/io/json_values.hpp"
#include "asterism/mesh/io/text_lines.hpp"

namespace asterism {
using namespace internal;
namespace {

using json = certificate_json;

json counters_json(const tier_counters& counters) {
  json result = json::object();
  for (std::size_t p = 0; p < predicate_count; ++p) {
    json tiers = json::object();
    for (std::size_t t = 0; t < tier_count; ++t)
      tiers[std::string(tier_names[t])] = counters.decided[p][t];
    result[std::string(predicate_names[p])] = std::move(tiers);
  }
  return result;
}

json mesh_json(const certificate& c) {
  return {{"vertices", c.sites},
          {"given", c.given},
          {"triangles", c.triangles},
          {"boundary_edges", c.boundary_subsegments},
          {"fingerprint", digest_text(c.fingerprint)}};
}

json measured_json(const certificate& c) {
  json result = json::object();
  for (const auto& [name, value] : c.measured)
    if (std::isfinite(value)) result[name] = value;
  return result;
}

// Writes null if every triangle has an exempt angle.
json worst_angle_json(double degrees) {
  return degrees < no_angle_to_judge ? json(degrees) : json(nullptr);
}

// Writes the distance between the metric of the mesh and the one wanted.
json delivered_json(const certificate& c) {
  if (!c.delivered) return nullptr;
  const delivered_report& r = *c.delivered;
  return {{"vertices_changed", r.changed},
          {"beyond_tenth", r.beyond_tenth},
          {"median", r.median},
          {"ninetieth", r.ninetieth},
          {"greatest", r.greatest},
          {"complexity_wanted", r.complexity_wanted},
          {"complexity_delivered", r.complexity_delivered},
          {"length_factor", r.length_factor},
          {"worst_angle_as_wanted", worst_angle_json(r.worst_angle_wanted)},
          {"low_triangles_as_wanted", from_one(r.low_wanted)}};
}

json curves_json(const curve_report& curves) {
  return {{"curves", curves.curves},
          {"vertices", curves.vertices},
          {"vertices_off", curves.off_curve},
          {"largest_distance",
           std::isfinite(curves.largest_distance) ? json(curves.largest_distance) : json(nullptr)}};
}

// Writes null for a quantity without a bound.
json bound_json(double x) { return std::isfinite(x) ? json(x) : json(nullptr); }

json regions_json(const std::vector<region_area>& regions) {
  json written = json::array();
  for (const region_area& r : regions) {
    json one = {{"region", r.number}};
    if (r.before) one["area_before"] = bound_json(*r.before);
    if (r.domain) one["area_of_domain"] = bound_json(*r.domain);
    one["area"] = bound_json(r.mesh);
    written.push_back(std::move(one));
  }
  return written;
}

json former_report_json(const former_boundary_report& former) {
  return {{"vertices_gone", former.vertices_gone},
          {"largest_distance",
           std::isfinite(former.largest_distance) ? json(former.largest_distance) : json(nullptr)}};
}

// Writes each segment of the domain that was along the former boundary, with the former vertices on
// it.
json former_json(const former_boundary& former) {
  json segments = json::array();
  for (std::size_t s = 0; s < former.between.size(); ++s)
    if (!former.between[s].empty())
      segments.push_back({{"segment", s + 1}, {"vertices", points_json(former.between[s])}});
  return {{"allowed", former.allowed ? json(*former.allowed) : json(nullptr)},
          {"segments", std::move(segments)}};
}

json pairs_json(const std::vector<periodic_pair>& pairs) {
  json written = json::array();
  for (const periodic_pair& one : pairs) written.push_back({one.first, one.second});
  return written;
}

json audit_json(const certificate& c) {
  json found = json::object();
  for (const auto& [kind, count] : c.found) found[kind] = count;
  json written = {{"certified", c.certified},
                  {"domain_checked", c.domain_checked},
                  {"angles_checked", c.angles_checked},
                  {"stars_checked", c.stars_checked},
                  {"voronoi", voronoi_verdict_names[static_cast<std::size_t>(c.voronoi)]},
                  {"worst_angle", worst_angle_json(c.worst_angle)},
                  {"worst_collateral_angle", worst_angle_json(c.worst_collateral)},
                  {"worst_exempt_angle", worst_angle_json(c.worst_exempt)},
                  {"exempt_corners", from_one(c.exempt_corners)},
                  {"exempt_triangles", from_one(c.exempt_triangles)},
                  {"collateral_triangles", from_one(c.collateral_triangles)},
                  {"low_triangles", from_one(c.low_triangles)},
                  {"largest_boundary_deviation",
                   std::isfinite(c.largest_deviation) ? json(c.largest_deviation) : json(nullptr)},
                  {"findings", std::move(found)},
                  {"witnesses", c.witnesses},
                  {"decided", counters_json(c.audit_counters)}};
  if (c.original && !c.original->curves.empty()) written["curves"] = curves_json(c.curves);
  if (!c.regions.empty()) written["regions"] = regions_json(c.regions);
  if (c.former) written["former_boundary"] = former_report_json(c.former_distance);
  if (!c.periodic_asked.empty()) written["periodic"] = json_of(c.periodic);
  return written;
}

json second_order_json(const second_order_report& r) {
  return {{"triangles", r.triangles}, {"curved_sides", r.curved_sides},
          {"on_curves", r.on_curves}, {"kept_straight", r.kept_straight},
          {"proved", r.proved()},     {"least_jacobian", r.least_jacobian}};
}

// Writes null if the theorem on nets was not measured.
json theorem_json(const certificate& c) {
  if (!c.theorem) return nullptr;
  const theorem_hypotheses& h = *c.theorem;
  return {{"theorem_applies", h.applies},
          {"reason", h.reason},
          {"sigma_eps", bound_json(h.sigma_eps)},
          {"proved_angle", h.proved_angle},
          {"covering_radius", bound_json(h.covering_radius)},
          {"spacing", bound_json(h.spacing)},
          {"longest_subsegment", bound_json(h.longest_subsegment)},
          {"distortion", bound_json(h.distortion)},
          {"variation", bound_json(h.variation)}};
}

json guarantee_json(const guarantee_claim& g) {
  return {{"size_factor", g.size_factor},
          {"field", g.field_variation_bound ? "bounded" : "sampled"},
          {"field_variation", bound_json(g.field_variation)},
          {"field_variation_bound",
           g.field_variation_bound ? json(*g.field_variation_bound) : json(nullptr)},
          {"sigma", bound_json(g.sigma)},
          {"eps", bound_json(g.eps)},
          {"times_least", g.times_least ? json(*g.times_least) : json(nullptr)}};
}

json json_with(const certificate& c, domain_rows rows) {
  json options = json::object();
  for (const auto& [name, value] : c.options) options[name] = value;
  json written = {{"format", certificate_format},
                  {"version", c.version},
                  {"numbering", "from 1"},
                  {"asked",
                   {{"metric", c.metric},
                    {"angle_bound", c.angle_bound ? json(*c.angle_bound) : json(nullptr)},
                    {"options", std::move(options)}}},
                  {"outcome",
                   {{"complete", c.complete},
                    {"reason", c.reason},
                    {"star_repairs", c.star_repairs},
                    {"delivered", delivered_json(c)},
                    {"decided", counters_json(c.mesher_counters)}}},
                  {"mesh", mesh_json(c)},
                  {"measured", measured_json(c)},
                  {"audit", audit_json(c)},
                  {"theorem", theorem_json(c)},
                  {"domain", c.original ? domain_json(*c.original, rows) : json(nullptr)}};
  if (c.guarantee) written["guarantee"] = guarantee_json(*c.guarantee);
  if (c.second_order) written["second_order"] = second_order_json(*c.second_order);
  if (c.former) written["former_boundary"] = former_json(*c.former);
  if (!c.periodic_asked.empty()) written["asked"]["periodic_sides"] = pairs_json(c.periodic_asked);
  return written;
}

// Appends a number in the form of the library that writes the rest: the fewest digits that it
// finds, and null for infinity and NaN.
void append_value(std::string& text, double x) {
  if (!std::isfinite(x)) {
    text += "null";
    return;
  }
  std::array<char, 64> digits;
  char* const end = nlohmann::detail::to_chars(digits.data(), digits.data() + digits.size(), x);
  text.append(digits.data(), end);
}
void append_value(std::string& text, std::size_t n) { append_integer(text, n); }
void append_value(std::string& text, int n) { append_integer(text, n); }

// Appends one item of the list of the domain's vertices or segments: itself a list, two levels
// below the certificate's own.
template <class... Values>
void append_item(std::string& text, bool is_first, const Values&... values) {
  text += is_first ? "\n   [" : ",\n   [";
  bool comma = false;
  const auto append = [&](const auto& value) {
    text += std::exchange(comma, true) ? ",\n    " : "\n    ";
    append_value(text, value);
  };
  (append(values), ...);
  text += "\n   ]";
}

void write_vertices(const domain& d, const byte_sink& put) {
  put("[");
  const auto write = [&](std::size_t i, std::string& lines) {
    append_item(lines, i == 0, d.vertices[i].x, d.vertices[i].y);
  };
  make_lines(d.vertices.size(), write, put);
  put("\n  ]");
}

void write_segments(const domain& d, const byte_sink& put) {
  put("[");
  const auto write = [&](std::size_t i, std::string& lines) {
    const segment& s = d.segments[i];
    const std::size_t a = std::size_t{s.a} + 1, b = std::size_t{s.b} + 1;
    if (needs_sides(s))
      append_item(lines, i == 0, a, b, s.marker, s.internal ? 1 : 0, s.left_region, s.right_region);
    else
      append_item(lines, i == 0, a, b, s.marker);
  };
  make_lines(d.segments.size(), write, put);
  put("\n  ]");
}

// Writes a text that has empty lists of vertices and segments, and fills these. Finds them behind
// the key "domain" of the outermost object: no other line begins in this way, and no value contains
// the end of a line. The lists may be most of a large text, so the text is never held whole.
void write_with_lists(std::string_view text, const domain& d, const byte_sink& put) {
  const std::string_view empty = "[]";
  const std::size_t first = text.find(empty, text.rfind("\n \"domain\": {")),
                    second = text.find(empty, first + empty.size());
  put(text.substr(0, first));
  write_vertices(d, put);
  put(text.substr(first + empty.size(), second - first - empty.size()));
  write_segments(d, put);
  put(text.substr(second + empty.size()));
}

}  // namespace

certificate_json internal::json_of(const std::vector<periodic_match>& matches) {
  json written = json::array();
  for (const periodic_match& one : matches)
    written.push_back({{"sides", {one.sides.first, one.sides.second}},
                       {"kind", periodic_kind_names[static_cast<std::size_t>(one.kind)]},
                       {"turn", one.turn},
                       {"shift", {one.shift.x, one.shift.y}},
                       {"vertices", one.vertices},
                       {"greatest_offset", one.greatest_offset},
                       {"metrics_apart", bound_json(one.metrics_apart)}});
  return written;
}

certificate_json internal::json_of(const certificate& c) {
  return json_with(c, domain_rows::as_needed);
}

void internal::write_certificate_text(const certificate& c, const byte_sink& put) {
  const bool has_lists =
      c.original && !c.original->vertices.empty() && !c.original->segments.empty();
  // Text that is not UTF-8 (a file's name may be anything) is replaced, not refused.
  const std::string text = json_with(c, has_lists ? domain_rows::left_out : domain_rows::as_needed)
                               .dump(1, ' ', false, json::error_handler_t::replace) +
                           "\n";
  if (has_lists)
    write_with_lists(text, *c.original, put);
  else
    put(text);
}

std::string certificate_text(const certificate& c) {
  return bytes_of([&c](const byte_sink& put) { write_certificate_text(c, put); });
}

result<std::filesystem::path> write_certificate(const std::filesystem::path& path,
                                                const certificate& c) {
  const auto written = write_files({certificate_file(path, c)});
  if (!written.ok()) return written.failure();
  return path;
}

output_file internal::certificate_file(const std::filesystem::path& path, const certificate& c) {
  return {.path = path, .rest = [&c](const byte_sink& put) { write_certificate_text(c, put); }};
}

}  // namespace asterism
