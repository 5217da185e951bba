// SPDX-License-Identifier: MIT
//
// Reads and writes JSON. Catches the exceptions by which nlohmann's library reports errors.
#include "asterism/mesh/surface_io/surface_json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/mesh/io/json_places.hpp"
#include "asterism/mesh/io/text_lines.hpp"
#include "asterism/mesh/io/text_scanner.hpp"

namespace asterism::internal {
namespace {

using nlohmann::json;
using failure = std::optional<error>;

// Deepest nesting that is read, more than lists in patches need; deeper texts are no surface.
constexpr std::size_t most_nested = 16;

error refuse(const std::string& what) { return {what, error_code::malformed_file}; }

failure read_numbers(const json& from, const std::string& name, std::vector<double>& to) {
  if (!from.is_array()) return refuse(name + ": a list of numbers is wanted");
  for (const json& x : from) {
    if (!x.is_number())
      return refuse(fmt::format("{}: entry {} is no number", name, to.size() + 1));
    to.push_back(x.get<double>());
  }
  return {};
}

failure read_degrees(const json& from, surface_patch& p) {
  const json* const degrees = from.contains("degree") ? &from["degree"] : nullptr;
  if (degrees == nullptr || !degrees->is_array() || degrees->size() != 2 ||
      !(*degrees)[0].is_number_integer() || !(*degrees)[1].is_number_integer())
    return refuse("\"degree\" must be a list of two whole numbers, of u and of v");
  for (const json& d : *degrees)
    if (!(d.get<double>() >= 0 && d.get<double>() <= 1000))
      return refuse("\"degree\" " + d.dump() + " is out of range");
  p.degree_u = (*degrees)[0].get<int>();
  p.degree_v = (*degrees)[1].get<int>();
  return {};
}

failure read_row(const json& row, std::size_t number, surface_patch& p) {
  if (!row.is_array() || row.empty())
    return refuse(fmt::format("row {} of \"control\" is no list of points", number));
  if (p.count_v != 0 && row.size() != p.count_v)
    return refuse(fmt::format("row {} of \"control\" has {} points, the first {}", number,
                              row.size(), p.count_v));
  p.count_v = row.size();
  for (std::size_t j = 0; j < row.size(); ++j) {
    std::vector<double> x;
    const std::string name = fmt::format("control point {}, {}", number, j + 1);
    if (auto wrong = read_numbers(row[j], name, x)) return wrong;
    if (x.size() != 3) return refuse(fmt::format("{} has {} numbers, not 3", name, x.size()));
    p.control.push_back({{x[0], x[1], x[2]}, 1});
  }
  return {};
}

failure read_control(const json& from, surface_patch& p) {
  if (!from.contains("control") || !from["control"].is_array() || from["control"].empty())
    return refuse("\"control\" must be a list of rows of points");
  for (const json& row : from["control"])
    if (auto wrong = read_row(row, ++p.count_u, p)) return wrong;
  return {};
}

failure read_weights(const json& from, surface_patch& p) {
  if (!from.contains("weights")) return {};
  const json& rows = from["weights"];
  if (!rows.is_array() || rows.size() != p.count_u)
    return refuse(fmt::format("\"weights\" must be {} rows, as many as \"control\"", p.count_u));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::vector<double> w;
    if (auto wrong = read_numbers(rows[i], fmt::format("row {} of \"weights\"", i + 1), w))
      return wrong;
    if (w.size() != p.count_v)
      return refuse(
          fmt::format("row {} of \"weights\" has {} numbers, not {}", i + 1, w.size(), p.count_v));
    for (std::size_t j = 0; j < w.size(); ++j) p.control[i * p.count_v + j].weight = w[j];
  }
  return {};
}

failure read_trim_points(const json& from, trim_curve& c) {
  if (!from.contains("control") || !from["control"].is_array())
    return refuse("\"control\" must be a list of points [u, v]");
  for (const json& row : from["control"]) {
    std::vector<double> x;
    const std::string name = fmt::format("control point {}", c.control.size() + 1);
    if (auto wrong = read_numbers(row, name, x)) return wrong;
    if (x.size() != 2) return refuse(fmt::format("{} has {} numbers, not 2", name, x.size()));
    c.control.push_back({x[0], x[1], 1});
  }
  if (!from.contains("weights")) return {};
  std::vector<double> w;
  if (auto wrong = read_numbers(from["weights"], "weights", w)) return wrong;
  if (w.size() != c.control.size())
    return refuse(fmt::format("{} weights for {} control points", w.size(), c.control.size()));
  for (std::size_t k = 0; k < w.size(); ++k) c.control[k].weight = w[k];
  return {};
}

failure read_flag(const json& from, const char* name, bool& to) {
  if (!from.contains(name)) return {};
  if (!from[name].is_boolean()) return refuse(fmt::format("\"{}\" must be true or false", name));
  to = from[name].get<bool>();
  return {};
}

failure read_trim(const json& from, trim_curve& c) {
  if (!from.is_object()) return refuse("an object is wanted");
  for (const auto& [key, value] : from.items())
    if (key != "degree" && key != "knots" && key != "control" && key != "weights" &&
        key != "edge" && key != "backward" && key != "point")
      return refuse("\"" + without_controls(key) + "\" is no part of a trimming curve");
  if (from.contains("degree")) {
    if (!from["degree"].is_number_integer() || !(std::abs(from["degree"].get<double>()) <= 1000))
      return refuse("\"degree\" must be a whole number");
    c.degree = from["degree"].get<int>();
  }
  if (auto wrong = read_trim_points(from, c)) return wrong;
  if (from.contains("knots"))
    if (auto wrong = read_numbers(from["knots"], "knots", c.knots)) return wrong;
  if (from.contains("edge")) {
    if (!from["edge"].is_string() || from["edge"].get<std::string>().empty())
      return refuse("\"edge\" must be a name");
    c.edge = from["edge"].get<std::string>();
  }
  if (auto wrong = read_flag(from, "backward", c.backward)) return wrong;
  if (auto wrong = read_flag(from, "point", c.is_point)) return wrong;
  // Gives a curve of straight lines without knots the knot k at its point k.
  if (c.degree == 1 && c.knots.empty() && c.control.size() > 2) {
    const auto last = static_cast<double>(c.control.size() - 1);
    c.knots = {0, 0};
    for (double k = 1; k < last; ++k) c.knots.push_back(k);
    c.knots.insert(c.knots.end(), {last, last});
  }
  return {};
}

failure read_loops(const json& from, std::vector<trim_loop>& loops) {
  if (!from.is_array() || from.empty()) return refuse("\"loops\" must be a list of loops");
  for (const json& curves : from) {
    trim_loop& loop = loops.emplace_back();
    const std::string name = fmt::format("loop {}", loops.size());
    if (!curves.is_array()) return refuse(name + ": a list of curves is wanted");
    for (const json& curve : curves)
      if (auto wrong = read_trim(curve, loop.emplace_back()))
        return wrong->at(fmt::format("{}: curve {}", name, loop.size()));
  }
  return {};
}

failure read_patch(const json& from, surface_patch& p) {
  if (!from.is_object()) return refuse("an object is wanted");
  for (const auto& [key, value] : from.items()) {
    if (key != "name" && key != "degree" && key != "knots_u" && key != "knots_v" &&
        key != "control" && key != "weights" && key != "loops")
      return refuse("\"" + without_controls(key) + "\" is no part of a patch");
  }
  if (from.contains("name") && from["name"].is_string()) p.name = from["name"].get<std::string>();
  if (auto wrong = read_degrees(from, p)) return wrong;
  if (auto wrong = read_control(from, p)) return wrong;
  if (auto wrong = read_weights(from, p)) return wrong;
  if (from.contains("knots_u"))
    if (auto wrong = read_numbers(from["knots_u"], "knots_u", p.knots_u)) return wrong;
  if (from.contains("knots_v"))
    if (auto wrong = read_numbers(from["knots_v"], "knots_v", p.knots_v)) return wrong;
  return from.contains("loops") ? read_loops(from["loops"], p.loops) : failure();
}

result<surface> read_all(const json& whole) {
  if (!whole.is_object() || !whole.contains("patches") || !whole["patches"].is_array())
    return refuse("an object with a list \"patches\" is wanted");
  surface s;
  if (whole.contains("name") && whole["name"].is_string())
    s.name = whole["name"].get<std::string>();
  for (const json& from : whole["patches"]) {
    surface_patch p;
    if (auto wrong = read_patch(from, p))
      return wrong->at(fmt::format("patch {}", s.patches.size() + 1));
    s.patches.push_back(std::move(p));
  }
  return s;
}

void append_list(std::string& text, const std::vector<double>& numbers) {
  text += '[';
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0) text += ", ";
    append_number(text, numbers[i]);
  }
  text += ']';
}

template <class Item>
void append_rows(std::string& text, const surface_patch& p, const Item& item) {
  text += '[';
  for (std::size_t i = 0; i < p.count_u; ++i) {
    text += i == 0 ? "[" : ",\n     [";
    for (std::size_t j = 0; j < p.count_v; ++j) {
      if (j > 0) text += ", ";
      item(p.at(i, j));
    }
    text += ']';
  }
  text += ']';
}

std::string quoted_name(const std::string& name) {
  return json(name).dump(-1, ' ', false, json::error_handler_t::replace);
}

void append_trim(std::string& text, const trim_curve& c) {
  text += fmt::format("{{\"degree\": {}", c.degree);
  if (!c.edge.empty()) text += ", \"edge\": " + quoted_name(c.edge);
  if (c.backward) text += ", \"backward\": true";
  if (c.is_point) text += ", \"point\": true";
  if (!c.knots.empty()) append_list(text += ", \"knots\": ", c.knots);
  text += ", \"control\": [";
  bool weighted = false;
  std::vector<double> weights;
  for (const trim_point& p : c.control) {
    if (!weights.empty()) text += ", ";
    append_list(text, {p.u, p.v});
    weights.push_back(p.weight);
    weighted = weighted || p.weight != 1;
  }
  text += ']';
  if (weighted) append_list(text += ", \"weights\": ", weights);
  text += '}';
}

void append_loops(std::string& text, const surface_patch& p) {
  if (p.loops.empty()) return;
  text += ",\n   \"loops\": [";
  for (const trim_loop& loop : p.loops) {
    text += &loop == &p.loops.front() ? "[\n     " : ",\n    [\n     ";
    for (const trim_curve& c : loop) {
      if (&c != &loop.front()) text += ",\n     ";
      append_trim(text, c);
    }
    text += ']';
  }
  text += ']';
}

void append_patch(std::string& text, const surface_patch& p) {
  text += "  {";
  if (!p.name.empty()) text += "\"name\": " + quoted_name(p.name) + ", ";
  text += fmt::format("\"degree\": [{}, {}]", p.degree_u, p.degree_v);
  if (!p.knots_u.empty()) append_list(text += ",\n   \"knots_u\": ", p.knots_u);
  if (!p.knots_v.empty()) append_list(text += ",\n   \"knots_v\": ", p.knots_v);
  text += ",\n   \"control\":\n    ";
  append_rows(text, p, [&](const control_point& c) {
    append_list(text, {c.at.x, c.at.y, c.at.z});
  });
  bool weighted = false;
  for (const control_point& c : p.control) weighted = weighted || c.weight != 1;
  if (weighted) {
    text += ",\n   \"weights\":\n    ";
    append_rows(text, p, [&](const control_point& c) { append_number(text, c.weight); });
  }
  append_loops(text, p);
  text += '}';
}

}  // namespace

result<surface> parse_surface(std::string_view text, const std::string& file) {
  const auto place = [&](const error& failure) { return failure.at(file); };
  if (const auto line = line_nested_beyond(text, most_nested))
    return refuse(fmt::format("{}:{}: nested too deeply", file, *line));
  const json_places places = find_json_places(text);
  if (places.beyond_doubles)
    return refuse(fmt::format("{}:{}: a number beyond the range of doubles", file,
                              places.beyond_doubles->line));
  if (places.repeated)
    return refuse(fmt::format("{}:{}: {} stands twice", file, places.repeated->line,
                              without_controls(places.repeated->name)));
  try {
    auto read = read_all(json::parse(text));
    if (!read) return place(read.failure());
    return read;
  } catch (const json::parse_error& wrong) {
    return refuse(fmt::format("{}:{}: this is not JSON", file, line_of_byte(text, wrong.byte)));
  } catch (const json::exception& wrong) {
    return place(refuse(without_controls(wrong.what())));
  }
}

result<surface> read_surface(const std::filesystem::path& path) {
  const auto text = read_text_file(path);
  if (!text) return text.failure();
  return parse_surface(text.value(), path.string());
}

std::string surface_text(const surface& s) {
  std::string text = "{";
  if (!s.name.empty()) text += "\"name\": " + quoted_name(s.name) + ",\n ";
  text += "\"patches\": [\n";
  for (std::size_t i = 0; i < s.patches.size(); ++i) {
    if (i > 0) text += ",\n";
    append_patch(text, s.patches[i]);
  }
  return text + "]}\n";
}

}  // namespace asterism::internal
