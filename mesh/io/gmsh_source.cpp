// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/gmsh_source.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "asterism/core/number_text.hpp"

namespace asterism::internal {
namespace {

// Names a version as the header of a file spells it, and as two numbers.
struct gmsh_dialect {
  std::string_view text;
  int major, minor;
};
constexpr std::array<gmsh_dialect, 7> dialects = {{{"4.1", 4, 1},
                                                   {"4.0", 4, 0},
                                                   {"4", 4, 0},
                                                   {"2.2", 2, 2},
                                                   {"2.1", 2, 1},
                                                   {"2.0", 2, 0},
                                                   {"2", 2, 0}}};

}  // namespace

failure gmsh_source::read_version() {
  if (text_scanner(source_).next().text != "$NOD") return read_format();
  version_ = 1;
  return {};
}

failure gmsh_source::read_format() {
  const word head = source_.next();
  if (head.text != "$MeshFormat")
    return source_.failure(head.line, "$MeshFormat wanted, not " + quoted_token(head.text));
  const word version = source_.next();
  for (const gmsh_dialect& d : dialects)
    if (version.text == d.text) {
      version_ = d.major;
      minor_ = d.minor;
    }
  if (version_ == 0)
    return source_.failure(version.line, "version " + quoted_token(version.text) +
                                             ": 1, 2.0 to 2.2, 4.0 and 4.1 can be read; gmsh "
                                             "-save -format msh41 writes the last");
  const auto kind = integer("kind of file");
  if (!kind.ok()) return kind.failure();
  if (kind.value() != 0)
    return source_.failure(
        version.line, "a binary file: only text can be read; gmsh -save -format msh41 writes it");
  const auto size = integer("size of numbers");
  if (!size.ok()) return size.failure();
  return expect("$EndMeshFormat");
}

failure gmsh_source::expect(const std::string& wanted) {
  const word w = source_.next();
  if (w.text == wanted) return {};
  return source_.failure(w.line, wanted + " wanted, not " + quoted_token(w.text));
}

failure gmsh_source::skip_to_end(const std::string& section, std::size_t line) {
  for (word w = source_.next(); !w.empty(); w = source_.next())
    if (w.text == section) return {};
  return source_.failure(line, section + " is missing");
}

failure gmsh_source::read_numbers(std::size_t count, std::string_view what) {
  for (std::size_t i = 0; i < count; ++i)
    if (const auto x = to_number(source_, source_.next(), what); !x.ok()) return x.failure();
  return {};
}

failure gmsh_source::read_nodes(const word& head) {
  if (std::exchange(has_nodes_, true))
    return source_.failure(head.line, "a second " + std::string(head.text));
  if (version_ == 4) return read_nodes_of_four();
  return read_nodes_of_two(version_ == 1 ? "$ENDNOD" : "$EndNodes");
}

failure gmsh_source::add_node(const word& tag) {
  const auto number = to_integer(source_, tag, "tag of a node");
  if (!number.ok()) return number.failure();
  const auto v = static_cast<vertex_index>(vertex_of_.size());
  if (!vertex_of_.emplace(number.value(), v).second)
    return source_.failure(tag.line, "node " + quoted_token(tag.text) + " is there twice");
  file_.content.sites.emplace_back();
  return {};
}

failure gmsh_source::read_position(site& s) {
  const word x = source_.next(), y = source_.next();
  const auto at = to_point(source_, x, y, "a node");
  if (!at) return at.failure();
  const word w = source_.next();
  const auto z = to_number(source_, w, "z of a node");
  if (!z.ok()) return z.failure();
  if (z.value() != 0)
    file_.heights.push_back(
        {static_cast<vertex_index>(&s - file_.content.sites.data()), w.line, z.value()});
  s = {at.value(), {1, 0, 1}};
  return {};
}

failure gmsh_source::read_nodes_of_two(const std::string& end) {
  const auto nodes = count("number of nodes");
  if (!nodes.ok()) return nodes.failure();
  for (std::size_t i = 0; i < nodes.value(); ++i) {
    if (auto failed = add_node(source_.next())) return failed;
    if (auto failed = read_position(file_.content.sites.back())) return failed;
  }
  return expect(end);
}

failure gmsh_source::read_nodes_of_four() {
  const auto blocks = count("number of blocks");
  if (!blocks.ok()) return blocks.failure();
  if (auto failed = read_numbers(minor_ > 0 ? 3 : 1, "count of nodes")) return failed;
  for (std::size_t i = 0; i < blocks.value(); ++i)
    if (auto failed = read_node_block()) return failed;
  return expect("$EndNodes");
}

failure gmsh_source::read_node_block() {
  // Reads the entity first in version 4.0, where each node's tag stands before its place.
  const auto first = count("entity of nodes"), second = count("entity of nodes");
  if (!first.ok()) return first.failure();
  if (!second.ok()) return second.failure();
  const std::size_t dimension = minor_ > 0 ? first.value() : second.value();
  const auto parametric = integer("parametric");
  if (!parametric.ok()) return parametric.failure();
  const auto nodes = count("number of nodes");
  if (!nodes.ok()) return nodes.failure();
  const std::size_t parameters =
      parametric.value() != 0 ? std::min<std::size_t>(dimension, 3) : std::size_t{0};
  return read_positions_of_block(nodes.value(), parameters);
}

failure gmsh_source::read_positions_of_block(std::size_t nodes, std::size_t parameters) {
  const std::size_t first = file_.content.sites.size();
  if (minor_ > 0)
    for (std::size_t i = 0; i < nodes; ++i)
      if (auto failed = add_node(source_.next())) return failed;
  for (std::size_t i = 0; i < nodes; ++i) {
    if (minor_ == 0)
      if (auto failed = add_node(source_.next())) return failed;
    if (auto failed = read_position(file_.content.sites[first + i])) return failed;
    if (auto failed = read_numbers(parameters, "parameter of a node")) return failed;
  }
  return {};
}

result<vertex_index> gmsh_source::vertex(std::string_view what) {
  const word w = source_.next();
  const auto tag = to_integer(source_, w, what);
  if (!tag.ok()) return tag.failure();
  const auto found = vertex_of_.find(tag.value());
  if (found != vertex_of_.end()) return found->second;
  return source_.failure(w.line,
                         std::string(what) + ": node " + quoted_token(w.text) + " does not exist");
}

}  // namespace asterism::internal
