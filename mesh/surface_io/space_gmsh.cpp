// SPDX-License-Identifier: MIT
//
// gmsh's .msh as text, versions 2.2 and 4.1: nodes in space, and elements of three corners.
#include <fmt/format.h>

#include <array>
#include <optional>
#include <unordered_map>
#include <utility>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/io/text_scanner.hpp"
#include "asterism/mesh/surface_io/space_mesh_reader.hpp"

namespace asterism::internal {
namespace {

using failure = std::optional<error>;

constexpr long long line_element = 1, triangle_element = 2, point_element = 15;

class gmsh_space_reader {
 public:
  explicit gmsh_space_reader(text_scanner& from) : from_(from) {}

  failure read();
  space_mesh made;

 private:
  failure read_format();
  failure read_nodes();
  failure read_node_block();
  failure read_elements();
  failure read_element_block();
  failure read_corners(long long type, std::size_t line);
  failure read_position(long long tag, std::size_t line);
  failure skip_to_end(const word& head);
  result<long long> integer(std::string_view what) { return to_integer(from_, from_.next(), what); }

  text_scanner& from_;
  bool is_four_ = false;
  std::unordered_map<long long, std::uint32_t> vertex_of_;
};

failure gmsh_space_reader::read() {
  while (true) {
    const word head = from_.next();
    if (head.empty()) return {};
    failure wrong;
    if (head.text == "$MeshFormat")
      wrong = read_format();
    else if (head.text == "$Nodes")
      wrong = read_nodes();
    else if (head.text == "$Elements")
      wrong = read_elements();
    else
      wrong = skip_to_end(head);
    if (wrong) return wrong;
  }
}

failure gmsh_space_reader::read_format() {
  const word version = from_.next(), kind = from_.next();
  if (version.text != "4.1" && version.text != "2.2")
    return from_.failure(version.line, "version " + quoted_token(version.text) +
                                           ": 4.1 and 2.2 can be read, as text");
  if (kind.text != "0") return from_.failure(version.line, "a binary file: only text can be read");
  is_four_ = version.text == "4.1";
  from_.next();
  from_.next();
  return {};
}

failure gmsh_space_reader::skip_to_end(const word& head) {
  if (head.text.empty() || head.text.front() != '$')
    return from_.failure(head.line, "a section wanted, not " + quoted_token(head.text));
  const std::string end = "$End" + std::string(head.text.substr(1));
  for (word w = from_.next(); !w.empty(); w = from_.next())
    if (w.text == end) return {};
  return from_.failure(head.line, end + " is missing");
}

failure gmsh_space_reader::read_position(long long tag, std::size_t line) {
  space_point p;
  for (double* const x : {&p.x, &p.y, &p.z}) {
    const auto number = to_number(from_, from_.next(), "a coordinate");
    if (!number) return number.failure();
    *x = number.value();
  }
  if (!vertex_of_.emplace(tag, static_cast<std::uint32_t>(made.points.size())).second)
    return from_.failure(line, fmt::format("node {} stands twice", tag));
  made.points.push_back(p);
  return {};
}

failure gmsh_space_reader::read_node_block() {
  for (int k = 0; k < 3; ++k) from_.next();
  const auto count = to_count(from_, from_.next(), "a number of nodes");
  if (!count) return count.failure();
  std::vector<std::pair<long long, std::size_t>> tags;
  for (std::size_t k = 0; k < count.value(); ++k) {
    const word w = from_.next();
    const auto tag = to_integer(from_, w, "a node");
    if (!tag) return tag.failure();
    tags.emplace_back(tag.value(), w.line);
  }
  for (const auto& [tag, line] : tags)
    if (auto wrong = read_position(tag, line)) return wrong;
  return {};
}

failure gmsh_space_reader::read_nodes() {
  const auto count = to_count(from_, from_.next(), "a number of nodes");
  if (!count) return count.failure();
  if (is_four_)
    for (int k = 0; k < 3; ++k) from_.next();
  for (std::size_t k = 0; k < count.value(); ++k) {
    if (is_four_) {
      if (auto wrong = read_node_block()) return wrong;
      continue;
    }
    const word w = from_.next();
    const auto tag = to_integer(from_, w, "a node");
    if (!tag) return tag.failure();
    if (auto wrong = read_position(tag.value(), w.line)) return wrong;
  }
  from_.next();
  return {};
}

failure gmsh_space_reader::read_corners(long long type, std::size_t line) {
  if (type != triangle_element && type != line_element && type != point_element)
    return from_.failure(line, fmt::format("an element of type {}: triangles (2), lines (1) and "
                                           "points (15) of first order can be read",
                                           type));
  const int corners = type == triangle_element ? 3 : type == line_element ? 2 : 1;
  space_triangle t{};
  for (int k = 0; k < corners; ++k) {
    const word w = from_.next();
    const auto tag = to_integer(from_, w, "a node");
    if (!tag) return tag.failure();
    const auto found = vertex_of_.find(tag.value());
    if (found == vertex_of_.end())
      return from_.failure(w.line, fmt::format("node {} does not exist", tag.value()));
    t[static_cast<std::size_t>(k)] = found->second;
  }
  if (type == triangle_element) made.triangles.push_back(t);
  return {};
}

failure gmsh_space_reader::read_element_block() {
  from_.next();
  from_.next();
  const word w = from_.next();
  const auto type = to_integer(from_, w, "a type of elements");
  if (!type) return type.failure();
  const auto count = to_count(from_, from_.next(), "a number of elements");
  if (!count) return count.failure();
  for (std::size_t k = 0; k < count.value(); ++k) {
    from_.next();
    if (auto wrong = read_corners(type.value(), w.line)) return wrong;
  }
  return {};
}

failure gmsh_space_reader::read_elements() {
  const auto count = to_count(from_, from_.next(), "a number of elements");
  if (!count) return count.failure();
  if (is_four_)
    for (int k = 0; k < 3; ++k) from_.next();
  for (std::size_t k = 0; k < count.value(); ++k) {
    if (is_four_) {
      if (auto wrong = read_element_block()) return wrong;
      continue;
    }
    const word w = from_.next();
    const auto type = integer("a type of elements");
    if (!type) return type.failure();
    const auto tags = to_count(from_, from_.next(), "a number of tags");
    if (!tags) return tags.failure();
    for (std::size_t i = 0; i < tags.value(); ++i) from_.next();
    if (auto wrong = read_corners(type.value(), w.line)) return wrong;
  }
  from_.next();
  return {};
}

}  // namespace

result<space_mesh> parse_space_gmsh(std::string_view text, const std::string& file) {
  text_scanner from(file, text);
  gmsh_space_reader reader(from);
  if (auto wrong = reader.read()) return *wrong;
  return std::move(reader.made);
}

}  // namespace asterism::internal
