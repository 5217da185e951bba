// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/io/listed_readers.hpp"

namespace asterism::internal {
namespace {

using failure = std::optional<error>;
using words = std::vector<word>;

// VTK's numbers of cells with their numbers of corners, which are all of their nodes.
constexpr long long vertex_type = 1, line_type = 3, triangle_type = 5, quadrilateral_type = 9;

class su2_reader {
 public:
  su2_reader(std::string_view text, const std::string& file) : source_(file, text, '%') {
    made_.file = file;
  }

  failure read();
  listed_mesh take() { return std::move(made_); }

 private:
  struct marker_edges {
    std::string name;
    std::vector<std::array<vertex_index, 2>> edges;
  };
  struct use {
    vertex_index vertex;
    std::size_t line;
  };

  // Splits a line "KEY= value" into its key and the words after the sign.
  bool read_key(std::string& key, words& values);
  failure read_entry(const std::string& key, const words& values, std::size_t line);
  failure read_elements(std::size_t count);
  failure read_points(std::size_t count);
  failure read_marker(const words& values, std::size_t line);
  failure read_marker_elements(std::size_t count, marker_edges& to);
  result<std::size_t> count_of(const std::string& key, const words& values, std::size_t line);
  result<vertex_index> vertex(const word& w);
  failure read_corners(const words& line, std::size_t count, std::array<vertex_index, 4>& corners);
  // Refuses a line that has another number of words beyond its `count` than the first of its list:
  // the number of a point or element ends either all lines or none, so a word is missing or too
  // many, and the others would be taken for what they are not.
  failure check_rest(const words& line, std::size_t count, std::optional<std::size_t>& rest) const;
  void number_markers();
  failure finish();

  text_scanner source_;
  listed_mesh made_;
  bool points_seen_ = false, elements_seen_ = false, passing_ = false;
  std::set<std::string> passed_over_;
  std::vector<use> uses_;
  std::vector<marker_edges> markers_;
};

bool su2_reader::read_key(std::string& key, words& values) {
  const words line = source_.next_line();
  values.clear();
  key.clear();
  if (line.empty()) return false;
  const std::string_view first = line.front().text;
  const std::size_t sign = first.find('=');
  key = std::string(first.substr(0, sign));
  if (sign != std::string_view::npos && sign + 1 < first.size())
    values.push_back({first.substr(sign + 1), line.front().line});
  for (std::size_t i = 1; i < line.size(); ++i) {
    std::string_view text = line[i].text;
    if (values.empty() && sign == std::string_view::npos && text.starts_with('='))
      text.remove_prefix(1);
    if (!text.empty()) values.push_back({text, line[i].line});
  }
  return true;
}

failure su2_reader::read() {
  std::string key;
  words values;
  while (read_key(key, values))
    if (auto failed = read_entry(key, values, source_.line())) return failed;
  return finish();
}

result<std::size_t> su2_reader::count_of(const std::string& key, const words& values,
                                         std::size_t line) {
  if (values.empty()) return source_.failure(line, key + "= wants a number");
  auto count = to_count(source_, values.front(), key);
  if (count && count.value() > std::numeric_limits<vertex_index>::max() / 4)
    return source_.failure(line, key + ": more than 32-bit numbers can name");
  return count;
}

failure su2_reader::read_entry(const std::string& key, const words& values, std::size_t line) {
  if (key == "MARKER_TAG") {
    passing_ = false;
    return read_marker(values, line);
  }
  const bool counts = key == "NDIME" || key == "NELEM" || key == "NPOIN" || key == "NZONE";
  if (!counts) {
    const bool is_known = key == "NMARK" || key == "IZONE";
    const bool is_number = !key.empty() && ((key[0] >= '0' && key[0] <= '9') || key[0] == '-' ||
                                            key[0] == '+' || key[0] == '.');
    // Skips numbers after an entry that is skipped, as they belong to it.
    if (key.empty() || (is_number && !passing_))
      return source_.failure(line, "a line KEY= wanted, not " + quoted_token(key));
    if (!is_number) passing_ = !is_known;
    if (!is_number && !is_known) passed_over_.insert(without_controls(key));
    return {};
  }
  passing_ = false;
  const auto count = count_of(key, values, line);
  if (!count) return count.failure();
  if (key == "NDIME" && count.value() != 2)
    return source_.failure(line, "NDIME= " + quoted_token(values.front().text) +
                                     ": only plane meshes, NDIME= 2, can be read");
  if (key == "NZONE" && count.value() != 1)
    return source_.failure(line, "NZONE= " + quoted_token(values.front().text) +
                                     ": a file of one zone is wanted; write each into its own");
  if (key == "NELEM") return read_elements(count.value());
  if (key == "NPOIN") return read_points(count.value());
  return {};
}

result<vertex_index> su2_reader::vertex(const word& w) {
  const auto number = to_integer(source_, w, "point of an element");
  if (!number) return number.failure();
  if (number.value() < 0 || number.value() > std::numeric_limits<vertex_index>::max() / 4)
    return source_.failure(w.line, "point " + quoted_token(w.text) + " does not exist");
  const auto v = static_cast<vertex_index>(number.value());
  // Notes points beyond those read so far, to be checked at the end: points may follow the
  // elements.
  if (v >= made_.content.sites.size()) uses_.push_back({v, w.line});
  return v;
}

failure su2_reader::read_corners(const words& line, std::size_t count,
                                 std::array<vertex_index, 4>& corners) {
  if (line.size() < count + 1)
    return source_.failure(line.front().line,
                           "an element of this type has " + std::to_string(count) + " points");
  for (std::size_t k = 0; k < count; ++k) {
    const auto v = vertex(line[k + 1]);
    if (!v) return v.failure();
    corners[k] = v.value();
  }
  return {};
}

failure su2_reader::check_rest(const words& line, std::size_t count,
                               std::optional<std::size_t>& rest) const {
  const std::size_t there = line.size() - count;
  if (!rest) rest = there;
  if (there == *rest) return {};
  return source_.failure(line.front().line,
                         fmt::format("{} words, where {} follow from the first line of the list",
                                     line.size(), count + *rest));
}

failure su2_reader::read_elements(std::size_t count) {
  if (std::exchange(elements_seen_, true))
    return source_.failure(source_.line(), "a second NELEM=: a file of one zone is wanted");
  words line;
  std::optional<std::size_t> rest;
  for (std::size_t i = 0; i < count; ++i) {
    source_.next_line(line);
    if (line.empty()) return source_.failure(source_.line(), "the file ends within NELEM=");
    const auto type = to_integer(source_, line.front(), "type of an element");
    if (!type) return type.failure();
    if (type.value() != triangle_type && type.value() != quadrilateral_type)
      return source_.failure(line.front().line,
                             "element of type " + quoted_token(line.front().text) +
                                 ": triangles (5) and quadrilaterals (9) can be read");
    std::array<vertex_index, 4> c{};
    const bool is_triangle = type.value() == triangle_type;
    if (auto failed = read_corners(line, is_triangle ? 3 : 4, c)) return failed;
    if (auto failed = check_rest(line, is_triangle ? 4 : 5, rest)) return failed;
    if (is_triangle)
      made_.content.triangles.push_back({c[0], c[1], c[2]});
    else
      made_.quadrilaterals.push_back({c, 1, line.front().line});
  }
  return {};
}

failure su2_reader::read_points(std::size_t count) {
  if (std::exchange(points_seen_, true))
    return source_.failure(source_.line(), "a second NPOIN=: a file of one zone is wanted");
  words line;
  std::optional<std::size_t> rest;
  for (std::size_t i = 0; i < count; ++i) {
    source_.next_line(line);
    if (line.size() < 2)
      return source_.failure(source_.line(), line.empty() ? "the file ends within NPOIN="
                                                          : "x and y of a point wanted");
    const auto at = to_point(source_, line[0], line[1], "a point");
    if (!at) return at.failure();
    if (auto failed = check_rest(line, 2, rest)) return failed;
    made_.content.sites.push_back({at.value(), {1, 0, 1}});
  }
  return {};
}

failure su2_reader::read_marker(const words& values, std::size_t line) {
  if (values.empty()) return source_.failure(line, "MARKER_TAG= wants a name");
  std::string name(values.front().text);
  for (std::size_t i = 1; i < values.size(); ++i) {
    name += ' ';
    name += values[i].text;
  }
  std::string key;
  words counts;
  if (!read_key(key, counts) || key != "MARKER_ELEMS")
    return source_.failure(source_.line(), "MARKER_ELEMS= wanted after MARKER_TAG=");
  const auto count = count_of(key, counts, source_.line());
  if (!count) return count.failure();
  markers_.push_back({without_controls(name), {}});
  return read_marker_elements(count.value(), markers_.back());
}

failure su2_reader::read_marker_elements(std::size_t count, marker_edges& to) {
  words line;
  std::optional<std::size_t> rest;
  for (std::size_t i = 0; i < count; ++i) {
    source_.next_line(line);
    // Skips the line SEND_TO= between the count and the elements of parallel markers.
    if (!line.empty() && line.front().text.starts_with("SEND_TO")) source_.next_line(line);
    if (line.empty()) return source_.failure(source_.line(), "the file ends within MARKER_ELEMS=");
    const auto type = to_integer(source_, line.front(), "type of an element");
    if (!type) return type.failure();
    if (type.value() == vertex_type) continue;
    if (type.value() != line_type)
      return source_.failure(
          line.front().line,
          "element of type " + quoted_token(line.front().text) + ": markers are of lines (3)");
    std::array<vertex_index, 4> ends{};
    if (auto failed = read_corners(line, 2, ends)) return failed;
    if (auto failed = check_rest(line, 3, rest)) return failed;
    to.edges.push_back({ends[0], ends[1]});
  }
  return {};
}

// Numbers the markers: by the tag where that is a number, else by the least free number.
void su2_reader::number_markers() {
  std::set<int> used;
  std::vector<std::optional<int>> numbers;
  for (const marker_edges& marker : markers_) {
    const auto number = to_marker(source_, {marker.name, 0}, "");
    numbers.push_back(number ? std::optional(number.value()) : std::nullopt);
    if (number) used.insert(number.value());
  }
  int next = 1;
  mesh& m = made_.content;
  for (std::size_t i = 0; i < markers_.size(); ++i) {
    if (!numbers[i]) {
      while (used.count(next) != 0) ++next;
      numbers[i] = next++;
      made_.names.markers[*numbers[i]] = markers_[i].name;
    }
    for (const auto& [a, b] : markers_[i].edges)
      m.boundary.push_back({a, b, static_cast<vertex_index>(m.boundary.size()), *numbers[i]});
  }
}

failure su2_reader::finish() {
  if (!elements_seen_) return source_.failure(source_.line(), "there is no NELEM=");
  if (!points_seen_) return source_.failure(source_.line(), "there is no NPOIN=");
  const std::size_t points = made_.content.sites.size();
  for (const use& u : uses_)
    if (u.vertex >= points)
      return source_.failure(u.line, "point " + std::to_string(u.vertex) +
                                         ", from 0, does not exist; there are " +
                                         std::to_string(points));
  number_markers();
  if (!passed_over_.empty()) {
    std::string keys;
    for (const std::string& key : passed_over_) {
      if (!keys.empty()) keys += ", ";
      keys += key;
    }
    made_.content.notes.push_back(
        source_.file() + ": entries that mean nothing here are passed over: " + quoted_token(keys));
  }
  made_.all_edges = true;
  return put_in_order(made_, listed_order::put_right);
}

}  // namespace

result<listed_mesh> read_su2(std::string_view text, const std::string& file) {
  su2_reader reader(text, file);
  if (auto failed = reader.read()) return *failed;
  return reader.take();
}

}  // namespace asterism::internal
