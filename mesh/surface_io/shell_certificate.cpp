// SPDX-License-Identifier: MIT
//
// Writes and reads certificates as JSON. Catches the exceptions by which nlohmann's library reports
// errors.
#include "asterism/mesh/surface_io/shell_certificate.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <type_traits>
#include <utility>

#include "asterism/core/version.h"
#include "asterism/mesh/io/json_places.hpp"
#include "asterism/mesh/io/text_lines.hpp"
#include "asterism/mesh/io/text_scanner.hpp"
#include "asterism/mesh/surface_audit/shell_numbers.hpp"
#include "asterism/mesh/surface_io/surface_json.hpp"

namespace asterism::internal {
namespace {

using nlohmann::json;

constexpr std::string_view beginning = "{\"kind\": \"surface\",";

// Writes an infinite bound as null.
template <class Number>
void append_member(std::string& text, const char* name, Number x) {
  text += fmt::format(",\n \"{}\": ", name);
  if constexpr (std::is_integral_v<Number>)
    append_integer(text, x);
  else if (std::isfinite(x))
    append_number(text, x);
  else
    text += "null";
}

std::string quoted(const std::string& s) {
  return json(s).dump(-1, ' ', false, json::error_handler_t::replace);
}

// Appends the rows of a list, one a line.
template <class Line>
void append_rows(std::string& text, const char* name, std::size_t count, const Line& line) {
  text += fmt::format(",\n   \"{}\": [", name);
  append_lines(text, count, [&](std::size_t k, std::string& to) {
    to += k == 0 ? "\n    [" : ",\n    [";
    line(k, to);
    to += ']';
  });
  text += ']';
}

template <class First, class... Rest>
void append_list(std::string& text, First first, Rest... rest) {
  append_integer(text, first);
  ((text += ", ", append_integer(text, rest)), ...);
}

void append_face(std::string& text, const shell_face& face) {
  const mesh& m = face.plane;
  text += fmt::format("  {{\"patch\": {}, \"scale\": [{}, {}], \"reversed\": {}, \"given\": {}",
                      face.patch + 1, face.scale_u, face.scale_v, face.reversed, m.given);
  append_rows(text, "sites", m.sites.size(), [&](std::size_t k, std::string& to) {
    const auto& [p, t] = m.sites[k];
    for (const double x : {p.x, p.y, t.m11, t.m12, t.m22}) {
      append_number(to, x);
      to += ", ";
    }
    append_integer(to, face.vertex[k] + 1);
  });
  append_rows(text, "triangles", m.triangles.size(), [&](std::size_t k, std::string& to) {
    const triangle& t = m.triangles[k];
    append_list(to, t[0] + 1, t[1] + 1, t[2] + 1);
  });
  append_rows(text, "boundary", m.boundary.size(), [&](std::size_t k, std::string& to) {
    const boundary_edge& e = m.boundary[k];
    append_list(to, e.a + 1, e.b + 1, e.segment + 1, e.marker);
  });
  if (!face.border.empty())
    append_rows(text, "border", face.border.size(), [&](std::size_t k, std::string& to) {
      append_integer(to, face.border[k].curve + 1);
      append_number(to += ", ", face.border[k].place);
    });
  text += '}';
}

error malformed(const std::string& what) { return {what, error_code::malformed_file}; }

// Reads a whole number; other values, and those beyond the type, become its greatest, which is
// never valid.
template <class Whole>
Whole whole_of(const json& from) {
  constexpr Whole none = std::numeric_limits<Whole>::max();
  if (!from.is_number_integer()) return none;
  if (from.is_number_unsigned() && !std::in_range<std::int64_t>(from.get<std::uint64_t>()))
    return none;
  const auto number = from.get<std::int64_t>();
  return std::in_range<Whole>(number) ? static_cast<Whole>(number) : none;
}

// Reads an index that counts from 1; one out of range becomes one that the audit refuses.
std::uint32_t index_of(const json& from) {
  const auto number = whole_of<std::int64_t>(from);
  return number < 1 || number > 0xFFFFFFFFLL ? ~0U : static_cast<std::uint32_t>(number - 1);
}

void read_face(const json& from, shell_face& face) {
  face.patch = index_of(from.at("patch"));
  face.scale_u = whole_of<int>(from.at("scale").at(0));
  face.scale_v = whole_of<int>(from.at("scale").at(1));
  face.reversed = from.at("reversed").get<bool>();
  mesh& m = face.plane;
  m.given = whole_of<vertex_index>(from.at("given"));
  for (const json& row : from.at("sites")) {
    const auto x = [&](std::size_t k) { return row.at(k).get<double>(); };
    m.sites.push_back({{x(0), x(1)}, {x(2), x(3), x(4)}});
    face.vertex.push_back(index_of(row.at(5)));
  }
  for (const json& row : from.at("triangles"))
    m.triangles.push_back({index_of(row.at(0)), index_of(row.at(1)), index_of(row.at(2))});
  for (const json& row : from.at("boundary"))
    m.boundary.push_back({index_of(row.at(0)), index_of(row.at(1)), index_of(row.at(2)),
                          whole_of<int>(row.at(3)), false});
  if (from.contains("border"))
    for (const json& row : from.at("border"))
      face.border.push_back({index_of(row.at(0)), row.at(1).get<double>()});
}

// Reads null as an infinite bound.
void read_number(const json& from, double& x) {
  x = from.is_null() ? INFINITY : from.get<double>();
}
template <class Whole>
void read_number(const json& from, Whole& x) {
  x = whole_of<Whole>(from);
}

void read_report(const json& from, shell_certificate& c) {
  shell_report& r = c.report;
  c.complete = from.at("complete").get<bool>();
  c.reason = from.at("reason").get<std::string>();
  c.asked.chord = from.at("chord").get<double>();
  c.asked.angle_bound = from.at("angle_bound").get<double>();
  // Accepts certificates written before this option existed.
  c.asked.no_crossings = from.value("no_crossings", false);
  r.certified = from.at("certified").get<bool>();
  const auto read = [&](const char* key, const char* /*in words*/, auto member) {
    read_number(from.at(key), r.*member);
  };
  visit_numbers(read);
  if (from.contains("trims")) visit_trim_numbers(read);
}

}  // namespace

bool is_shell_certificate(std::string_view text) { return text.starts_with(beginning); }

std::string shell_certificate_text(const shell_certificate& c) {
  const shell_report& r = c.report;
  std::string text(beginning);
  text += "\n \"version\": \"" ASTERISM_VERSION_TEXT "\"";
  text += fmt::format(",\n \"certified\": {},\n \"complete\": {},\n \"reason\": {}", r.certified,
                      c.complete, quoted(c.reason));
  append_member(text, "chord", c.asked.chord);
  append_member(text, "angle_bound", c.asked.angle_bound);
  text += fmt::format(",\n \"no_crossings\": {}", c.asked.no_crossings);
  const auto append = [&](const char* key, const char* /*in words*/, auto member) {
    append_member(text, key, r.*member);
  };
  visit_numbers(append);
  if (r.trims > 0) visit_trim_numbers(append);
  text += ",\n \"surface\": " + surface_text(c.of);
  text += ",\n \"faces\": [\n";
  for (std::size_t f = 0; f < c.shell.faces.size(); ++f) {
    if (f > 0) text += ",\n";
    append_face(text, c.shell.faces[f]);
  }
  return text + "]}\n";
}

result<shell_certificate> parse_shell_certificate(const std::string& text,
                                                  const std::string& file) {
  constexpr std::size_t most_nested = 24;
  if (const auto line = line_nested_beyond(text, most_nested))
    return malformed(fmt::format("{}:{}: nested too deeply", file, *line));
  try {
    const json whole = json::parse(text);
    shell_certificate c;
    read_report(whole, c);
    auto of = parse_surface(whole.at("surface").dump(), file);
    if (!of) return of.failure();
    c.of = std::move(of).value();
    for (const json& from : whole.at("faces")) read_face(from, c.shell.faces.emplace_back());
    return c;
  } catch (const json::parse_error& wrong) {
    return malformed(fmt::format("{}:{}: this is not JSON", file, line_of_byte(text, wrong.byte)));
  } catch (const json::exception& wrong) {
    return malformed(file + ": " + without_controls(wrong.what()));
  }
}

}  // namespace asterism::internal
