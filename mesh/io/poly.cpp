// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/poly.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/io/poly_curves.hpp"
#include "asterism/mesh/io/text_scanner.hpp"

namespace asterism::internal {

namespace {

using words = std::vector<word>;
using failure = std::optional<error>;

// Returns the region number in an attribute; none if it is no whole number of 32 bits.
std::optional<int> whole_number(double attribute) {
  constexpr double low = std::numeric_limits<int>::min(), high = std::numeric_limits<int>::max();
  if (!(attribute >= low && attribute <= high) || std::floor(attribute) != attribute)
    return std::nullopt;
  return static_cast<int>(attribute);
}

// Reads one file, a .poly or a .node, into a domain that is being put together.
class poly_reader {
 public:
  poly_reader(text_scanner& source, domain& d) : source_(source), d_(d) {}

  // Reads the vertices; `count` is set to the number of vertices the header announces.
  failure read_vertices(std::size_t& count);
  failure read_segments();
  failure read_holes();
  failure read_regions();
  failure expect_end();
  // Numbers the regions whose attributes are no numbers of regions. Returns these by number.
  std::map<int, double> number_regions();

 private:
  // Reads the header of the vertices: their number, and how many words each line has.
  failure read_vertex_header(std::size_t& count, std::size_t& record_size);
  failure read_vertex(const words& record);
  failure read_segment(const words& record, std::size_t expected_size);
  failure read_region(const words& record);
  failure read_point(const words& record, std::string_view what, point& p);
  // Reads x, word 1 of the record, or y, word 2. Makes the words of an error only for a
  // failure.
  failure read_coordinate(const words& record, std::size_t at, std::string_view what,
                          double& value);
  // Reads a header line with 1 to `most` words; `wanted` names its contents in messages.
  failure read_header(std::string_view wanted, std::size_t most, words& header);
  // Reads the next line, as record `position` (from 0) of `count`: its number must be the next one.
  failure read_record(std::string_view what, std::size_t position, std::size_t count,
                      std::size_t least, std::size_t most, words& record);
  failure check_number(std::string_view what, const word& number, std::size_t position);
  // Returns the error for a record whose number does not follow the one before.
  error wrong_number(const std::string& name, const word& number, std::size_t position) const;
  // Checks that the words from `from` on are numbers; they are not used.
  failure check_unused(const words& record, std::size_t from, std::string_view what);
  failure read_flag(const words& header, std::size_t at, std::string_view what, std::size_t& flag);

  text_scanner& source_;
  domain& d_;
  std::vector<std::pair<std::size_t, double>> other_attributes_;  // of regions
  std::optional<long long> first_number_;  // of this file's vertices, then of its segments
};

failure poly_reader::read_header(std::string_view wanted, std::size_t most, words& header) {
  header = source_.next_line();
  if (header.empty())
    return source_.failure(source_.line(),
                           "the file ends where " + std::string(wanted) + " should follow");
  if (header.size() > most)
    return source_.failure(
        header[most].line,
        quoted_token(header[most].text) + " is too much: this line holds " + std::string(wanted));
  return {};
}

failure poly_reader::read_record(std::string_view what, std::size_t position, std::size_t count,
                                 std::size_t least, std::size_t most, words& record) {
  source_.next_line(record);
  const auto told = [what] { return std::string(what); };
  if (record.empty())
    return source_.failure(source_.line(), "the file ends after " + std::to_string(position) +
                                               " of " + std::to_string(count) + " " + told() +
                                               " lines");
  if (record.size() < least)
    return source_.failure(record[0].line, "a " + told() + " line needs " + std::to_string(least) +
                                               " numbers, this one has " +
                                               std::to_string(record.size()));
  if (record.size() > most)
    return source_.failure(record[most].line, quoted_token(record[most].text) + " is too much: a " +
                                                  told() + " line has " + std::to_string(most) +
                                                  " numbers here");
  return check_number(what, record[0], position);
}

failure poly_reader::check_number(std::string_view what, const word& number, std::size_t position) {
  const auto value = to_integer(source_, number, what);
  const bool is_first = position == 0 && value.ok() && (value.value() == 0 || value.value() == 1);
  if (is_first) first_number_ = value.value();
  const bool follows = position > 0 && value.ok() &&
                       value.value() == *first_number_ + static_cast<long long>(position);
  if (is_first || follows) return {};
  return wrong_number(std::string(what), number, position);
}

error poly_reader::wrong_number(const std::string& name, const word& number,
                                std::size_t position) const {
  const auto value = to_integer(source_, number, name + " number");
  if (!value.ok()) return value.failure();
  if (position == 0)
    return source_.failure(number.line,
                           name + " numbers start at 0 or 1, not at " + quoted_token(number.text));
  const long long expected = *first_number_ + static_cast<long long>(position);
  if (value.value() >= *first_number_ && value.value() < expected)
    return source_.failure(number.line,
                           name + " number " + std::to_string(value.value()) + " occurs twice");
  return source_.failure(number.line, name + " number " + quoted_token(number.text) + " where " +
                                          std::to_string(expected) +
                                          " should follow: numbers go up by one");
}

failure poly_reader::check_unused(const words& record, std::size_t from, std::string_view what) {
  for (std::size_t i = from; i < record.size(); ++i)
    if (const auto value = to_number(source_, record[i], what); !value.ok()) return value.failure();
  return {};
}

failure poly_reader::read_flag(const words& header, std::size_t at, std::string_view what,
                               std::size_t& flag) {
  if (header.size() <= at) return {};
  const auto value = to_integer(source_, header[at], what);
  if (!value.ok()) return value.failure();
  if (value.value() != 0 && value.value() != 1)
    return source_.failure(
        header[at].line,
        std::string(what) + ": " + quoted_token(header[at].text) + " should be 0 or 1");
  flag = static_cast<std::size_t>(value.value());
  return {};
}

failure poly_reader::read_vertex_header(std::size_t& count, std::size_t& record_size) {
  words header;
  if (auto failed = read_header("<vertices> <dimension> <attributes> <markers>", 4, header))
    return failed;
  const auto announced = to_count(source_, header[0], "number of vertices");
  if (!announced.ok()) return announced.failure();
  count = announced.value();
  // Limits the number of vertices, as the mesh adds vertices of its own.
  if (count > std::numeric_limits<vertex_index>::max() / 4)
    return source_.failure(header[0].line, "more vertices than 32-bit numbers can name");
  if (header.size() > 1) {
    const auto dimension = to_integer(source_, header[1], "dimension");
    if (!dimension.ok()) return dimension.failure();
    if (dimension.value() != 2)
      return source_.failure(header[1].line,
                             "dimension: " + quoted_token(header[1].text) + " should be 2");
  }
  std::size_t attributes = 0, markers = 0;
  if (header.size() > 2) {
    const auto given = to_count(source_, header[2], "number of attributes");
    if (!given.ok()) return given.failure();
    attributes = given.value();
  }
  if (auto failed = read_flag(header, 3, "number of vertex markers", markers)) return failed;
  record_size = 3 + attributes + markers;
  return {};
}

failure poly_reader::read_vertices(std::size_t& count) {
  std::size_t size = 0;
  if (auto failed = read_vertex_header(count, size)) return failed;
  words record;
  for (std::size_t i = 0; i < count; ++i) {
    if (auto failed = read_record("vertex", i, count, size, size, record)) return failed;
    if (auto failed = read_vertex(record)) return failed;
  }
  if (count > 0) d_.origin.first_number = static_cast<int>(*first_number_);
  return {};
}

failure poly_reader::read_vertex(const words& record) {
  point p;
  if (auto failed = read_point(record, "vertex", p)) return failed;
  if (auto failed = check_unused(record, 3, "vertex attribute")) return failed;
  d_.vertices.push_back(p);
  d_.origin.vertex_lines.push_back(record[0].line);
  return {};
}

failure poly_reader::read_point(const words& record, std::string_view what, point& p) {
  if (auto failed = read_coordinate(record, 1, what, p.x)) return failed;
  return read_coordinate(record, 2, what, p.y);
}

failure poly_reader::read_coordinate(const words& record, std::size_t at, std::string_view what,
                                     double& value) {
  if (const auto read = to_number(source_, record[at], what); read.ok()) {
    value = read.value();
    return {};
  }
  const std::string meaning = (at == 1 ? "x of " : "y of ") + std::string(what) + " ";
  return to_number(source_, record[at], meaning + std::string(record[0].text)).failure();
}

failure poly_reader::read_segments() {
  words header, record;
  if (auto failed = read_header("<segments> <markers>", 2, header)) return failed;
  const auto count = to_count(source_, header[0], "number of segments");
  if (!count.ok()) return count.failure();
  std::size_t markers = 0;
  if (auto failed = read_flag(header, 1, "number of segment markers", markers)) return failed;
  for (std::size_t i = 0; i < count.value(); ++i) {
    if (auto failed = read_record("segment", i, count.value(), 3 + markers, 3 + markers, record))
      return failed;
    if (auto failed = read_segment(record, 3 + markers)) return failed;
  }
  return {};
}

failure poly_reader::read_segment(const words& record, std::size_t expected_size) {
  const long long first = d_.origin.first_number;
  const auto vertices = static_cast<long long>(d_.vertices.size());
  vertex_index ends[2] = {};
  for (int end = 0; end < 2; ++end) {
    const word& w = record[static_cast<std::size_t>(end) + 1];
    const auto number = to_integer(source_, w, "vertex of segment " + std::string(record[0].text));
    if (!number.ok()) return number.failure();
    if (number.value() < first || number.value() >= first + vertices)
      return source_.failure(w.line, "segment " + std::string(record[0].text) + ": vertex " +
                                         quoted_token(w.text) + " does not exist; there are " +
                                         std::to_string(first) + " to " +
                                         std::to_string(first + vertices - 1));
    ends[end] = static_cast<vertex_index>(number.value() - first);
  }
  int marker = 0;
  if (expected_size > 3) {
    const auto value = to_marker(source_, record[3], "segment marker");
    if (!value.ok()) return value.failure();
    marker = value.value();
  }
  d_.segments.push_back({ends[0], ends[1], marker});
  d_.origin.segment_lines.push_back(record[0].line);
  return {};
}

failure poly_reader::read_holes() {
  words header, record;
  if (auto failed = read_header("<holes>", 1, header)) return failed;
  const auto count = to_count(source_, header[0], "number of holes");
  if (!count.ok()) return count.failure();
  for (std::size_t i = 0; i < count.value(); ++i) {
    if (auto failed = read_record("hole", i, count.value(), 3, 3, record)) return failed;
    point p;
    if (auto failed = read_point(record, "hole", p)) return failed;
    d_.holes.push_back(p);
    d_.origin.hole_lines.push_back(record[0].line);
  }
  return {};
}

failure poly_reader::read_regions() {
  words record;
  const words header = source_.next_line();
  if (header.empty()) return {};
  if (header.size() > 1)
    return source_.failure(
        header[1].line, quoted_token(header[1].text) + " is too much: this line holds <regions>");
  const auto count = to_count(source_, header[0], "number of regions");
  if (!count.ok()) return count.failure();
  for (std::size_t i = 0; i < count.value(); ++i) {
    if (auto failed = read_record("region", i, count.value(), 4, 5, record)) return failed;
    if (auto failed = read_region(record)) return failed;
  }
  return {};
}

failure poly_reader::read_region(const words& record) {
  region_point region;
  if (auto failed = read_point(record, "region", region.at)) return failed;
  const auto attribute = to_number(source_, record[3], "attribute of a region");
  if (!attribute.ok()) return attribute.failure();
  const auto number = whole_number(attribute.value());
  region.number = number.value_or(0);
  // Takes the only number of a line for both attribute and area, as Triangle does.
  if (!number) {
    other_attributes_.emplace_back(d_.regions.size(), attribute.value());
    if (record.size() == 4) region.largest_area = std::max(attribute.value(), 0.0);
  }
  if (record.size() > 4) {
    const auto area = to_number(source_, record[4], "largest area in a region");
    if (!area.ok()) return area.failure();
    region.largest_area = std::max(area.value(), 0.0);
  }
  d_.regions.push_back(region);
  d_.origin.region_lines.push_back(record[0].line);
  return {};
}

std::map<int, double> poly_reader::number_regions() {
  std::map<int, double> named;
  if (other_attributes_.empty()) return named;
  std::set<int> used;
  std::set<std::size_t> others;
  for (const auto& [r, attribute] : other_attributes_) others.insert(r);
  for (std::size_t r = 0; r < d_.regions.size(); ++r)
    if (others.count(r) == 0) used.insert(d_.regions[r].number);
  std::map<double, int> number_of;
  std::string told;
  int next = 1;
  for (const auto& [r, attribute] : other_attributes_) {
    const auto [at, is_new] = number_of.emplace(attribute, 0);
    if (is_new) {
      while (used.count(next) != 0) ++next;
      at->second = next++;
      named[at->second] = attribute;
      constexpr std::size_t longest = 200;
      if (told.size() < longest)
        told += fmt::format("{}{} is region {}", told.empty() ? "" : ", ", number_text(attribute),
                            at->second);
      else if (!told.ends_with("..."))
        told += ", ...";
    }
    d_.regions[r].number = at->second;
  }
  d_.origin.notes.push_back("attributes of regions that are no whole numbers: " + told);
  return named;
}

failure poly_reader::expect_end() {
  const word extra = source_.next();
  if (extra.empty()) return {};
  return source_.failure(extra.line,
                         quoted_token(extra.text) + " is too much: the file should end here");
}

// Follows Triangle's convention for a .poly file without vertices of its own.
failure read_node_file(const std::filesystem::path& poly_path, domain& d) {
  const std::filesystem::path path = std::filesystem::path(poly_path).replace_extension(".node");
  const auto text = read_text_file(path);
  if (!text.ok())
    return error{poly_path.string() + " has no vertices of its own, and " + text.failure().message,
                 text.failure().code};
  text_scanner source(path.string(), text.value());
  poly_reader reader(source, d);
  std::size_t count = 0;
  if (auto failed = reader.read_vertices(count)) return failed;
  d.origin.vertex_file = path.string();
  return reader.expect_end();
}

using attributes = std::map<int, double>;  // by region

failure read_poly_text(const std::filesystem::path& path, text_scanner& source, domain& d,
                       attributes& named) {
  poly_reader reader(source, d);
  std::size_t vertices = 0;
  if (auto failed = reader.read_vertices(vertices)) return failed;
  if (vertices == 0)
    if (auto failed = read_node_file(path, d)) return failed;
  if (auto failed = reader.read_segments()) return failed;
  if (auto failed = reader.read_holes()) return failed;
  if (auto failed = reader.read_regions()) return failed;
  named = reader.number_regions();
  if (auto failed = read_poly_curves(source, d)) return failed;
  return reader.expect_end();
}

result<domain> read_with_attributes(const std::filesystem::path& path, attributes& named) {
  const auto text = read_text_file(path);
  if (!text.ok()) return text.failure();
  text_scanner source(path.string(), text.value());
  if (text_scanner(source).next().empty())
    return error{path.string() + ": the file is empty", error_code::malformed_file};
  domain d;
  d.name = path.string();
  d.origin.file = d.origin.vertex_file = path.string();
  if (auto failed = read_poly_text(path, source, d, named)) return std::move(*failed);
  return d;
}

}  // namespace

result<domain> read_poly(const std::filesystem::path& path) {
  attributes named;
  return read_with_attributes(path, named);
}

std::map<int, std::string> region_names_in_poly(const std::filesystem::path& path) {
  attributes named;
  std::map<int, std::string> names;
  if (!read_with_attributes(path, named)) return names;
  for (const auto& [number, attribute] : named) names[number] = number_text(attribute);
  return names;
}

result<domain> read_nodes(const std::filesystem::path& path) {
  const auto text = read_text_file(path);
  if (!text.ok()) return text.failure();
  text_scanner source(path.string(), text.value());
  domain d;
  d.name = path.string();
  d.origin.file = d.origin.vertex_file = path.string();
  poly_reader reader(source, d);
  std::size_t vertices = 0;
  if (auto failed = reader.read_vertices(vertices)) return std::move(*failed);
  if (auto failed = reader.expect_end()) return std::move(*failed);
  return d;
}

}  // namespace asterism::internal
