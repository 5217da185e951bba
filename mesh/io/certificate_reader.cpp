// SPDX-License-Identifier: MIT
//
// Reads certificates from JSON. Catches the exceptions by which nlohmann's library reports errors.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "asterism/mesh/io/certificate_json.hpp"
#include "asterism/mesh/io/certificate_writer.hpp"
#include "asterism/mesh/io/json_places.hpp"
#include "asterism/mesh/io/json_values.hpp"
#include "asterism/mesh/io/text_scanner.hpp"

namespace asterism {
using namespace internal;
namespace {

using json = certificate_json;

// Reads an angle, which is null if there was no angle to judge; older certificates have a number in
// that case.
double worst_angle_of(const json& object, const std::string& key) {
  return member(object, key).is_null() ? no_angle_to_judge : value_of<double>(object, key);
}

double bound_of(const json& object, const std::string& key) {
  return member(object, key).is_null() ? std::numeric_limits<double>::infinity()
                                       : value_of<double>(object, key);
}

tier_counters counters_of(const json& object, const std::string& key) {
  tier_counters counters;
  const json& all = member(object, key);
  for (std::size_t p = 0; p < predicate_count; ++p) {
    const json& tiers = member(all, std::string(predicate_names[p]));
    for (std::size_t t = 0; t < tier_count; ++t)
      counters.decided[p][t] = count_of(tiers, std::string(tier_names[t]));
  }
  return counters;
}

void read_mesh(const json& object, certificate& c) {
  c.sites = count_of(object, "vertices");
  c.given = count_of(object, "given");
  c.triangles = count_of(object, "triangles");
  c.boundary_subsegments = count_of(object, "boundary_edges");
  c.fingerprint = digest_in(object, "fingerprint");
}

// Reads the verdict on the Voronoi diagram. Older certificates have none: not_asked.
voronoi_verdict voronoi_of(const json& object) {
  if (!object.contains("voronoi")) return voronoi_verdict::not_asked;
  const auto text = value_of<std::string>(object, "voronoi");
  const auto place = std::find(voronoi_verdict_names.begin(), voronoi_verdict_names.end(), text);
  if (place == voronoi_verdict_names.end())
    throw malformed("voronoi", "\"voronoi\" holds \"" + text + "\", which is no verdict");
  return static_cast<voronoi_verdict>(place - voronoi_verdict_names.begin());
}

std::optional<delivered_report> delivered_of(const json& outcome) {
  if (!outcome.contains("delivered") || outcome["delivered"].is_null()) return std::nullopt;
  const json& object = outcome["delivered"];
  delivered_report r;
  r.changed = count_of(object, "vertices_changed");
  r.beyond_tenth = value_of<double>(object, "beyond_tenth");
  r.median = value_of<double>(object, "median");
  r.ninetieth = value_of<double>(object, "ninetieth");
  r.greatest = value_of<double>(object, "greatest");
  r.complexity_wanted = value_of<double>(object, "complexity_wanted");
  r.complexity_delivered = value_of<double>(object, "complexity_delivered");
  r.length_factor = value_of<double>(object, "length_factor");
  r.worst_angle_wanted = worst_angle_of(object, "worst_angle_as_wanted");
  r.low_wanted = indices_of(object, "low_triangles_as_wanted");
  return r;
}

std::optional<theorem_hypotheses> theorem_of(const json& object) {
  if (object.is_null()) return std::nullopt;
  theorem_hypotheses h;
  h.applies = value_of<bool>(object, "theorem_applies");
  h.reason = value_of<std::string>(object, "reason");
  h.sigma_eps = bound_of(object, "sigma_eps");
  h.proved_angle = value_of<double>(object, "proved_angle");
  h.covering_radius = bound_of(object, "covering_radius");
  h.spacing = bound_of(object, "spacing");
  h.longest_subsegment = bound_of(object, "longest_subsegment");
  h.distortion = bound_of(object, "distortion");
  h.variation = bound_of(object, "variation");
  return h;
}

guarantee_claim guarantee_of(const json& object) {
  guarantee_claim g;
  g.size_factor = value_of<double>(object, "size_factor");
  g.field_variation = bound_of(object, "field_variation");
  if (!member(object, "field_variation_bound").is_null())
    g.field_variation_bound = value_of<double>(object, "field_variation_bound");
  if (value_of<std::string>(object, "field") != (g.field_variation_bound ? "bounded" : "sampled"))
    throw malformed("field", "\"field\" does not go with \"field_variation_bound\"");
  g.sigma = bound_of(object, "sigma");
  g.eps = bound_of(object, "eps");
  if (!member(object, "times_least").is_null())
    g.times_least = value_of<double>(object, "times_least");
  return g;
}

region_area region_of(const json& object) {
  region_area r;
  r.number = value_of<int>(object, "region");
  if (object.contains("area_before")) r.before = bound_of(object, "area_before");
  if (object.contains("area_of_domain")) r.domain = bound_of(object, "area_of_domain");
  r.mesh = bound_of(object, "area");
  return r;
}

// Reads the former boundary along the segments of a domain.
former_boundary former_of(const json& object, std::size_t segments) {
  former_boundary former;
  if (!member(object, "allowed").is_null()) former.allowed = value_of<double>(object, "allowed");
  former.between.resize(segments);
  for (const json& one : array_of(object, "segments")) {
    const vertex_index s = index_of(member(one, "segment"), "segment");
    if (s >= segments)
      throw malformed("segment", "the former boundary names a segment the domain does not have");
    former.between[s] = points_of(one, "vertices");
  }
  return former;
}

periodic_pair pair_of(const json& object, const std::string& key) {
  if (!object.is_array() || object.size() != 2 || !object[0].is_number_integer() ||
      !object[1].is_number_integer())
    throw malformed(key,
                    "\"" + key + "\" holds " + shown(object) + ", which is no pair of markers");
  return {object[0].get<int>(), object[1].get<int>()};
}

periodic_match match_of(const json& object) {
  periodic_match match;
  match.sides = pair_of(member(object, "sides"), "sides");
  const auto kind = value_of<std::string>(object, "kind");
  const auto place = std::find(periodic_kind_names.begin(), periodic_kind_names.end(), kind);
  if (place == periodic_kind_names.end())
    throw malformed("kind", "\"kind\" holds \"" + kind + "\", which is no way for sides to match");
  match.kind = static_cast<periodic_kind>(place - periodic_kind_names.begin());
  match.turn = value_of<double>(object, "turn");
  const auto shift = value_of<std::array<double, 2>>(object, "shift");
  match.shift = {shift[0], shift[1]};
  match.vertices = count_of(object, "vertices");
  match.greatest_offset = value_of<double>(object, "greatest_offset");
  match.metrics_apart = bound_of(object, "metrics_apart");
  return match;
}

void read_audit(const json& object, certificate& c) {
  c.certified = value_of<bool>(object, "certified");
  c.domain_checked = value_of<bool>(object, "domain_checked");
  c.angles_checked = value_of<bool>(object, "angles_checked");
  c.stars_checked = value_of<bool>(object, "stars_checked");
  c.voronoi = voronoi_of(object);
  c.worst_angle = worst_angle_of(object, "worst_angle");
  c.worst_collateral = worst_angle_of(object, "worst_collateral_angle");
  c.worst_exempt = worst_angle_of(object, "worst_exempt_angle");
  c.exempt_corners = indices_of(object, "exempt_corners");
  c.exempt_triangles = indices_of(object, "exempt_triangles");
  c.collateral_triangles = indices_of(object, "collateral_triangles");
  c.low_triangles = indices_of(object, "low_triangles");
  const json& deviation = member(object, "largest_boundary_deviation");
  c.largest_deviation = deviation.is_null()
                            ? std::numeric_limits<double>::infinity()
                            : value_of<double>(object, "largest_boundary_deviation");
  c.found = value_of<std::map<std::string, std::size_t>>(object, "findings");
  c.witnesses = value_of<std::vector<std::string>>(object, "witnesses");
  c.audit_counters = counters_of(object, "decided");
  if (object.contains("regions"))
    for (const json& r : array_of(object, "regions")) c.regions.push_back(region_of(r));
  if (object.contains("former_boundary")) {
    const json& former = member(object, "former_boundary");
    c.former_distance = {count_of(former, "vertices_gone"), bound_of(former, "largest_distance")};
  }
  if (object.contains("periodic"))
    for (const json& one : array_of(object, "periodic")) c.periodic.push_back(match_of(one));
  if (!object.contains("curves")) return;
  const json& curves = member(object, "curves");
  c.curves = {count_of(curves, "curves"), count_of(curves, "vertices"),
              count_of(curves, "vertices_off"), bound_of(curves, "largest_distance")};
}

// Reads the proof of second-order triangles: a certificate has such a proof only if all triangles
// are proved.
second_order_report second_order_of(const json& object) {
  second_order_report r;
  r.triangles = count_of(object, "triangles");
  r.curved_sides = count_of(object, "curved_sides");
  r.on_curves = count_of(object, "on_curves");
  r.kept_straight = count_of(object, "kept_straight");
  r.least_jacobian = value_of<double>(object, "least_jacobian");
  return r;
}

certificate certificate_of(const json& root) {
  const bool is_named = root.is_object() && root.contains("format") && root["format"].is_string();
  if (!is_named || root["format"].get<std::string>() != certificate_format)
    throw malformed("format", "this is not an \"" + std::string(certificate_format) + "\"");
  certificate c;
  c.version = value_of<std::string>(root, "version");
  const json& asked = member(root, "asked");
  c.metric = value_of<std::string>(asked, "metric");
  if (!member(asked, "angle_bound").is_null())
    c.angle_bound = value_of<double>(asked, "angle_bound");
  c.options = value_of<std::map<std::string, std::string>>(asked, "options");
  if (asked.contains("periodic_sides"))
    for (const json& one : array_of(asked, "periodic_sides"))
      c.periodic_asked.push_back(pair_of(one, "periodic_sides"));
  const json& outcome = member(root, "outcome");
  c.complete = value_of<bool>(outcome, "complete");
  c.reason = value_of<std::string>(outcome, "reason");
  c.mesher_counters = counters_of(outcome, "decided");
  c.star_repairs = outcome.contains("star_repairs") ? count_of(outcome, "star_repairs") : 0;
  c.delivered = delivered_of(outcome);
  read_mesh(member(root, "mesh"), c);
  if (root.contains("measured"))
    c.measured = value_of<std::map<std::string, double>>(root, "measured");
  read_audit(member(root, "audit"), c);
  c.theorem = theorem_of(member(root, "theorem"));
  if (root.contains("guarantee")) c.guarantee = guarantee_of(member(root, "guarantee"));
  if (!member(root, "domain").is_null()) c.original = domain_of(member(root, "domain"));
  if (root.contains("second_order")) c.second_order = second_order_of(member(root, "second_order"));
  if (root.contains("former_boundary"))
    c.former =
        former_of(member(root, "former_boundary"), c.original ? c.original->segments.size() : 0);
  return c;
}

// Removes an empty entry on relaxed metrics, which earlier versions wrote. Refuses a certificate
// whose metric was relaxed: nothing can confirm it.
json without_relaxation(json root) {
  if (!root.is_object()) return root;
  if (root.contains("outcome") && root["outcome"].is_object() &&
      root["outcome"].contains("relaxed")) {
    if (!root["outcome"]["relaxed"].is_null())
      throw malformed(
          "outcome.relaxed",
          "the mesh is of a metric that an earlier version relaxed all over, which this "
          "one does not judge: make it again, or verify it without the certificate");
    root["outcome"].erase("relaxed");
  }
  if (root.contains("asked") && root["asked"].is_object() && root["asked"].contains("options") &&
      root["asked"]["options"].is_object())
    root["asked"]["options"].erase("relax");
  return root;
}

std::string quoted(const std::string& name) {
  return fmt::format("\"{}\"", shortened(without_controls(name)));
}

struct difference {
  std::string name, what;
};

std::string joined(const std::string& name, const std::string& member) {
  return name.empty() ? member : name + "." + member;
}

// Returns the first field that only one of `read` and `written` has, or that has different values
// in the two.
std::optional<difference> first_difference(const json& read, const json& written,
                                           const std::string& name) {
  if (read.is_object() && written.is_object()) {
    for (const auto& [key, value] : written.items()) {
      if (!read.contains(key)) return difference{joined(name, key), "is missing"};
      if (auto inner = first_difference(read[key], value, joined(name, key))) return inner;
    }
    for (const auto& [key, value] : read.items())
      if (!written.contains(key))
        return difference{joined(name, key), "is no field of a certificate"};
    return std::nullopt;
  }
  if (read.type_name() == std::string_view(written.type_name()) && read == written)
    return std::nullopt;
  return difference{name, "is not what it should be"};
}

}  // namespace

result<certificate> parse_certificate(const std::string& text, const std::string& name) {
  const json_places places = find_json_places(text);
  const auto refuse = [&name](std::size_t line, const std::string& what) {
    return error{
        line > 0 ? fmt::format("{}:{}: {}", name, line, what) : fmt::format("{}: {}", name, what),
        error_code::malformed_file};
  };
  if (const auto& deep = places.too_deep) return refuse(deep->line, "this is no certificate");
  if (const auto& large = places.beyond_doubles)
    return refuse(large->line, quoted(large->name) + " is beyond the range of doubles");
  if (const auto& twice = places.repeated)
    return refuse(twice->line, quoted(twice->name) + " is there twice");
  try {
    const json root = without_relaxation(json::parse(text));
    certificate read = certificate_of(root);
    // Compares the text with that of the certificate that was read: a difference is a part that was
    // not read, or that is written differently.
    if (const auto odd = first_difference(root, json_of(read), ""))
      return refuse(places.line_of(odd->name), quoted(odd->name) + " " + odd->what);
    return read;
  } catch (const malformed& e) {
    return refuse(places.line_of(e.name), e.what());
  } catch (const json::parse_error& e) {
    return refuse(line_of_byte(text, e.byte), "this is not JSON");
  } catch (const json::exception&) {
    return refuse(0, "this is no certificate");
  }
}

result<certificate> read_certificate(const std::filesystem::path& path) {
  const auto text = read_text_file(path);
  if (!text) return text.failure();
  return parse_certificate(text.value(), path.string());
}

}  // namespace asterism
