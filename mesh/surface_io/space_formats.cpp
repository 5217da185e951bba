// SPDX-License-Identifier: MIT
//
// Reads .obj, .stl and .ply. Sources: Wavefront's appendix B1; the StL interface specification of
// 3D Systems, 1989; Turk's "The PLY polygon file format", 1994.
#include "asterism/mesh/surface_io/space_formats.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/io/stl_facets.hpp"
#include "asterism/mesh/io/text_scanner.hpp"

namespace asterism::internal {
namespace {

using failure = std::optional<error>;

void add_fan(const std::vector<std::uint32_t>& polygon, std::size_t& polygons, space_mesh& to) {
  if (polygon.size() > 3) ++polygons;
  for (std::size_t k = 2; k < polygon.size(); ++k)
    to.triangles.push_back({polygon[0], polygon[k - 1], polygon[k]});
}

void note_polygons(const std::string& file, std::size_t polygons, space_mesh& to) {
  if (polygons > 0)
    to.notes.push_back(
        fmt::format("{}: {} polygon{} of more than three corners became fans of triangles from the "
                    "first corner",
                    file, polygons, polygons == 1 ? "" : "s"));
}

result<space_point> point_of(const text_scanner& from, const std::vector<word>& words,
                             std::size_t first) {
  if (words.size() < first + 3) return from.failure(words[0].line, "three coordinates are wanted");
  space_point p;
  double* const to[] = {&p.x, &p.y, &p.z};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto number = to_number(from, words[first + k], "a coordinate");
    if (!number) return number.failure();
    *to[k] = number.value();
  }
  return p;
}

// Returns the vertex of a number, which counts from 1, or backwards from -1, the last vertex so
// far.
result<std::uint32_t> obj_vertex(const text_scanner& from, const word& w, std::size_t count) {
  word number = w;
  number.text = w.text.substr(0, w.text.find('/'));
  const auto read = to_integer(from, number, "a vertex");
  if (!read) return read.failure();
  const long long v =
      read.value() < 0 ? read.value() + static_cast<long long>(count) : read.value() - 1;
  if (v < 0 || v >= static_cast<long long>(count))
    return from.failure(
        w.line, fmt::format("vertex {} does not exist; there are {} so far", read.value(), count));
  return static_cast<std::uint32_t>(v);
}

// Makes equal corners one vertex.
class corner_collector {
 public:
  explicit corner_collector(space_mesh& to) : to_(to) {}
  std::uint32_t add(const space_point& p) {
    // Maps 0 and -0 to the same place.
    const std::array<double, 3> key = {p.x + 0.0, p.y + 0.0, p.z + 0.0};
    const auto [at, is_new] =
        number_of_.emplace(key, static_cast<std::uint32_t>(to_.points.size()));
    if (is_new) to_.points.push_back({key[0], key[1], key[2]});
    return at->second;
  }

 private:
  space_mesh& to_;
  std::map<std::array<double, 3>, std::uint32_t> number_of_;
};

// A type of numbers in .ply files.
struct ply_type {
  std::size_t bytes = 0;
  bool is_real = false, is_signed = false;
};

std::optional<ply_type> ply_type_named(std::string_view name) {
  static const std::map<std::string_view, ply_type> types = {
      {"char", {1, false, true}},    {"int8", {1, false, true}},    {"uchar", {1, false, false}},
      {"uint8", {1, false, false}},  {"short", {2, false, true}},   {"int16", {2, false, true}},
      {"ushort", {2, false, false}}, {"uint16", {2, false, false}}, {"int", {4, false, true}},
      {"int32", {4, false, true}},   {"uint", {4, false, false}},   {"uint32", {4, false, false}},
      {"float", {4, true, true}},    {"float32", {4, true, true}},  {"double", {8, true, true}},
      {"float64", {8, true, true}}};
  const auto found = types.find(name);
  if (found == types.end()) return std::nullopt;
  return found->second;
}

struct ply_property {
  std::string name;
  ply_type type;
  std::optional<ply_type> count;  // of a list
};

struct ply_element {
  std::string name;
  std::size_t count = 0, line = 0;
  std::vector<ply_property> properties;
};

enum class ply_order { text, little, big };

class ply_reader {
 public:
  ply_reader(std::string_view bytes, const std::string& file)
      : bytes_(bytes), from_(file, bytes), file_(file) {}

  failure read();
  space_mesh made;

 private:
  failure read_header();
  failure read_header_line(std::string_view line);
  failure read_element(const ply_element& e);
  failure read_record(const ply_element& e, std::size_t number);
  result<double> value(const ply_type& type);
  failure refuse(const std::string& what) const {
    return error{fmt::format("{}:{}: {}", file_, line_, what), error_code::malformed_file};
  }

  std::string_view bytes_;
  text_scanner from_;
  std::string file_;
  std::size_t at_ = 0, line_ = 0, polygons_ = 0;
  ply_order order_ = ply_order::text;
  std::vector<ply_element> elements_;
};

failure ply_reader::read_header_line(std::string_view line) {
  text_scanner words_of("", line);
  std::vector<word> words = words_of.next_line();
  if (words.empty() || words[0].text == "comment" || words[0].text == "obj_info") return {};
  const auto text = [&](std::size_t k) {
    return k < words.size() ? words[k].text : std::string_view();
  };
  if (text(0) == "ply" && line_ == 1) return {};
  if (text(0) == "format") {
    if (text(1) != "ascii" && text(1) != "binary_little_endian" && text(1) != "binary_big_endian")
      return refuse("format " + quoted_token(text(1)) + " is not known");
    order_ = text(1) == "ascii"                  ? ply_order::text
             : text(1) == "binary_little_endian" ? ply_order::little
                                                 : ply_order::big;
    return {};
  }
  if (text(0) == "element" && words.size() == 3) {
    const auto count = to_integer(words_of, words[2], "a number of elements");
    if (!count || count.value() < 0 || count.value() > static_cast<long long>(bytes_.size()))
      return refuse("a number of elements is wanted that the file can hold, not " +
                    quoted_token(text(2)));
    elements_.push_back({std::string(text(1)), static_cast<std::size_t>(count.value()), line_, {}});
    return {};
  }
  if (text(0) == "property" && !elements_.empty() && words.size() >= 3) {
    const bool is_list = text(1) == "list";
    const auto type = ply_type_named(text(is_list ? 3 : 1));
    const auto count = is_list ? ply_type_named(text(2)) : std::nullopt;
    if (!type || (is_list && (!count || words.size() != 5)))
      return refuse("a property of a type that is not known");
    elements_.back().properties.push_back({std::string(words.back().text), *type, count});
    return {};
  }
  return refuse("a line of a header is wanted, not " + quoted_token(text(0)));
}

failure ply_reader::read_header() {
  while (at_ < bytes_.size()) {
    const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
    const std::string_view line = bytes_.substr(at_, end - at_);
    at_ = std::min(end + 1, bytes_.size());
    ++line_;
    if (line_ == 1 && !line.starts_with("ply")) return refuse("this is no .ply file");
    if (line.starts_with("end_header")) {
      from_ = text_scanner(file_, bytes_.substr(at_));
      return {};
    }
    if (auto wrong = read_header_line(line)) return wrong;
  }
  return refuse("end_header is missing");
}

result<double> ply_reader::value(const ply_type& type) {
  if (order_ == ply_order::text) {
    auto number = to_number(from_, from_.next(), "a number");
    if (!number)  // lines of the header come before those counted
      return *refuse("a number after the header cannot be read: " + number.failure().message);
    return number;
  }
  if (bytes_.size() - at_ < type.bytes) return *refuse("the file ends within its elements");
  std::uint64_t bits = 0;
  for (std::size_t k = 0; k < type.bytes; ++k) {
    const std::size_t from = order_ == ply_order::big ? k : type.bytes - 1 - k;
    bits = (bits << 8) | static_cast<unsigned char>(bytes_[at_ + from]);
  }
  at_ += type.bytes;
  if (type.is_real)
    return type.bytes == 4
               ? static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)))
               : std::bit_cast<double>(bits);
  const unsigned shift = static_cast<unsigned>(64 - 8 * type.bytes);
  if (type.is_signed) return static_cast<double>(static_cast<std::int64_t>(bits << shift) >> shift);
  return static_cast<double>(bits);
}

failure ply_reader::read_record(const ply_element& e, std::size_t number) {
  std::map<std::string_view, double> values;
  std::vector<std::uint32_t> polygon;
  for (const ply_property& p : e.properties) {
    double count = 1;
    if (p.count) {
      const auto read = value(*p.count);
      if (!read) return read.failure();
      count = read.value();
      if (!(count >= 0 && count <= static_cast<double>(bytes_.size())))
        return refuse(fmt::format("{} {}: a list of {:g} entries", e.name, number, count));
    }
    const bool is_polygon = p.count && (p.name == "vertex_indices" || p.name == "vertex_index");
    for (double k = 0; k < count; ++k) {
      const auto read = value(p.type);
      if (!read) return read.failure();
      if (!p.count) values[p.name] = read.value();
      if (!is_polygon) continue;
      if (!(read.value() >= 0 && read.value() < static_cast<double>(made.points.size())))
        return refuse(fmt::format("{} {}: vertex {:g}, from 0, does not exist; there are {}",
                                  e.name, number, read.value(), made.points.size()));
      polygon.push_back(static_cast<std::uint32_t>(read.value()));
    }
  }
  if (e.name == "vertex") {
    const space_point p{values["x"], values["y"], values["z"]};
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      return refuse(fmt::format("vertex {}: a coordinate is not finite", number));
    made.points.push_back(p);
  } else if (e.name == "face") {
    add_fan(polygon, polygons_, made);
  }
  return {};
}

failure ply_reader::read_element(const ply_element& e) {
  if (e.name == "vertex")
    for (const char* const axis : {"x", "y", "z"}) {
      bool has = false;
      for (const ply_property& p : e.properties) has = has || (p.name == axis && !p.count);
      if (!has) return refuse(fmt::format("vertices have no {}", axis));
    }
  if (e.properties.empty()) return {};
  for (std::size_t k = 1; k <= e.count; ++k)
    if (auto wrong = read_record(e, k)) return wrong;
  return {};
}

failure ply_reader::read() {
  if (auto wrong = read_header()) return wrong;
  for (const ply_element& e : elements_)
    if (auto wrong = read_element(e)) return wrong;
  note_polygons(file_, polygons_, made);
  return {};
}

}  // namespace

result<space_mesh> parse_obj(std::string_view text, const std::string& file) {
  text_scanner from(file, text);
  space_mesh made;
  std::size_t polygons = 0;
  std::vector<word> words;
  for (from.next_line(words); !words.empty(); from.next_line(words)) {
    if (words[0].text == "v") {
      const auto p = point_of(from, words, 1);
      if (!p) return p.failure();
      made.points.push_back(p.value());
    } else if (words[0].text == "f") {
      std::vector<std::uint32_t> polygon;
      for (std::size_t k = 1; k < words.size(); ++k) {
        const auto v = obj_vertex(from, words[k], made.points.size());
        if (!v) return v.failure();
        polygon.push_back(v.value());
      }
      if (polygon.size() < 3) return from.failure(words[0].line, "a face of two corners or fewer");
      add_fan(polygon, polygons, made);
    }
  }
  note_polygons(file, polygons, made);
  return made;
}

result<space_mesh> parse_stl(std::string_view bytes, const std::string& file) {
  const auto facets = read_stl_facets(bytes, file);
  if (!facets) return facets.failure();
  space_mesh made;
  corner_collector corners(made);
  const std::vector<stl_corner>& all = facets.value().corners;
  for (std::size_t i = 0; i + 2 < all.size(); i += 3) {
    space_triangle t{};
    for (std::size_t k = 0; k < 3; ++k)
      t[k] = corners.add({all[i + k].x, all[i + k].y, all[i + k].z});
    made.triangles.push_back(t);
  }
  return made;
}

result<space_mesh> parse_ply(std::string_view bytes, const std::string& file) {
  ply_reader reader(bytes, file);
  if (auto wrong = reader.read()) return *wrong;
  return std::move(reader.made);
}

}  // namespace asterism::internal
