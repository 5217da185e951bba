// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/json_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

namespace asterism::internal {
namespace {

using json = certificate_json;

json segment_json(const segment& s, domain_rows rows) {
  json written = {std::size_t{s.a} + 1, std::size_t{s.b} + 1, s.marker};
  if (rows == domain_rows::with_sides || needs_sides(s))
    for (const int more : {s.internal ? 1 : 0, s.left_region, s.right_region})
      written.push_back(more);
  return written;
}

json curve_json(const domain_curve& c) {
  json written = {{"kind", curve_kind_names[static_cast<std::size_t>(c.kind)]}};
  if (c.kind == curve_kind::arc) {
    written["centre"] = {c.centre.x, c.centre.y};
    written["clockwise"] = c.clockwise;
  } else {
    written["control"] = points_json({c.control[0], c.control[1]});
  }
  written["vertices"] = from_one(c.vertices);
  written["parameters"] = c.parameters;
  return written;
}

segment segment_of(const json& s) {
  const bool usable = s.is_array() && (s.size() == 3 || s.size() == 6) &&
                      std::all_of(s.begin(), s.end(),
                                  [](const json& number) { return number.is_number_integer(); });
  if (!usable)
    throw malformed("segments", "\"segments\" holds " + shown(s) + ", which is no segment");
  segment made{index_of(s[0], "segments"), index_of(s[1], "segments"), s[2].get<int>()};
  if (s.size() == 3) return made;
  made.internal = s[3].get<int>() != 0;
  made.left_region = s[4].get<int>();
  made.right_region = s[5].get<int>();
  return made;
}

domain_curve curve_of(const json& object, std::size_t vertices) {
  domain_curve c;
  const auto kind = value_of<std::string>(object, "kind");
  const auto place = std::find(curve_kind_names.begin(), curve_kind_names.end(), kind);
  if (place == curve_kind_names.end())
    throw malformed("kind", "\"kind\" holds \"" + kind + "\", which is no kind of curve");
  c.kind = static_cast<curve_kind>(place - curve_kind_names.begin());
  if (c.kind == curve_kind::arc) {
    const auto centre = value_of<std::array<double, 2>>(object, "centre");
    c.centre = {centre[0], centre[1]};
    c.clockwise = value_of<bool>(object, "clockwise");
  } else {
    const std::vector<point> control = points_of(object, "control");
    if (control.size() != 2) throw malformed("control", "\"control\" is not two points");
    c.control = {control[0], control[1]};
  }
  c.vertices = indices_of(object, "vertices");
  for (const vertex_index v : c.vertices)
    if (v >= vertices) throw malformed("curves", "a curve names a vertex the domain does not have");
  c.parameters = value_of<std::vector<double>>(object, "parameters");
  return c;
}

}  // namespace

std::string shortened(std::string text) {
  constexpr std::size_t longest = 60;
  if (text.size() <= longest) return text;
  return text.substr(0, longest) + "...";
}

std::string shown(const json& value) { return shortened(value.dump()); }

const json& member(const json& object, const std::string& key) {
  const auto place = object.find(key);
  if (place == object.end()) throw malformed(key, "\"" + key + "\" is missing");
  return *place;
}

std::size_t count_of(const json& object, const std::string& key) {
  if (!member(object, key).is_number_unsigned())
    throw malformed(key, "\"" + key + "\" is not a count");
  return value_of<std::size_t>(object, key);
}

vertex_index index_of(const json& number, const std::string& key) {
  if (!number.is_number_unsigned() || number.get<std::uint64_t>() < 1 ||
      number.get<std::uint64_t>() > std::numeric_limits<vertex_index>::max())
    throw malformed(key,
                    "\"" + key + "\" holds " + shown(number) + ", which counts nothing from 1");
  return static_cast<vertex_index>(number.get<std::uint64_t>() - 1);
}

const json& array_of(const json& object, const std::string& key) {
  const json& list = member(object, key);
  if (!list.is_array()) throw malformed(key, "\"" + key + "\" is not a list");
  return list;
}

std::vector<vertex_index> indices_of(const json& object, const std::string& key) {
  std::vector<vertex_index> result;
  for (const json& number : array_of(object, key)) result.push_back(index_of(number, key));
  return result;
}

std::vector<point> points_of(const json& object, const std::string& key) {
  std::vector<point> result;
  for (const json& p : array_of(object, key)) {
    if (!p.is_array() || p.size() != 2 || !p[0].is_number() || !p[1].is_number())
      throw malformed(key, "\"" + key + "\" holds " + shown(p) + ", which is no point");
    result.push_back({p[0].get<double>(), p[1].get<double>()});
  }
  return result;
}

std::uint64_t digest_in(const json& object, const std::string& key) {
  const auto text = value_of<std::string>(object, key);
  std::uint64_t value = 0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  if (text.size() != 16 || end.ec != std::errc() || end.ptr != text.data() + text.size())
    throw malformed(key, "\"" + key + "\" is not sixteen hexadecimal digits");
  return value;
}

domain domain_of(const json& object) {
  domain d;
  d.vertices = points_of(object, "vertices");
  for (const json& s : array_of(object, "segments")) {
    const segment read_segment = segment_of(s);
    if (read_segment.a >= d.vertices.size() || read_segment.b >= d.vertices.size())
      throw malformed("segments",
                      "segment " + shown(s) + " names a vertex the domain does not have");
    d.segments.push_back(read_segment);
  }
  if (!object.contains("curves")) return d;
  for (const json& c : array_of(object, "curves"))
    d.curves.push_back(curve_of(c, d.vertices.size()));
  return d;
}

std::vector<std::size_t> from_one(const std::vector<vertex_index>& numbers) {
  std::vector<std::size_t> result;
  result.reserve(numbers.size());
  for (const vertex_index i : numbers) result.push_back(std::size_t{i} + 1);
  return result;
}

json points_json(const std::vector<point>& points) {
  json result = json::array();
  for (const point& p : points) result.push_back({p.x, p.y});
  return result;
}

std::string digest_text(std::uint64_t digest) { return fmt::format("{:016x}", digest); }

bool needs_sides(const segment& s) {
  return s.internal || s.left_region != 1 || s.right_region != 1;
}

json domain_json(const domain& d, domain_rows rows) {
  json segments = json::array(), curves = json::array();
  const bool with_lists = rows != domain_rows::left_out;
  if (with_lists)
    for (const segment& s : d.segments) segments.push_back(segment_json(s, rows));
  for (const domain_curve& c : d.curves) curves.push_back(curve_json(c));
  json written = {{"vertices", with_lists ? points_json(d.vertices) : json::array()},
                  {"segments", std::move(segments)}};
  if (!curves.empty()) written["curves"] = std::move(curves);
  return written;
}

}  // namespace asterism::internal
