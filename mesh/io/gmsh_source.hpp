// SPDX-License-Identifier: MIT
//
// Reads the parts common to all sections of a gmsh file (mesh/io/gmsh.hpp): its words, its version,
// its nodes.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "asterism/core/result.hpp"
#include "asterism/mesh/io/listed_mesh.hpp"
#include "asterism/mesh/io/text_scanner.hpp"

namespace asterism::internal {

using failure = std::optional<error>;

class gmsh_source {
 protected:
  // Reads on from the position of `source`, which must outlive this object.
  explicit gmsh_source(text_scanner& source) : source_(source) { file_.file = source.file(); }

  // Reads the header. A file of version 1 has no header: its first section has the nodes.
  failure read_version();
  // Reads the section of the nodes, with the name in `head`, into the sites and heights of the
  // file.
  failure read_nodes(const word& head);
  bool has_nodes() const { return has_nodes_; }
  // Reads the tag of a node, and returns its vertex.
  result<vertex_index> vertex(std::string_view what);

  result<long long> integer(std::string_view what) {
    return to_integer(source_, source_.next(), what);
  }
  result<std::size_t> count(std::string_view what) {
    return to_count(source_, source_.next(), what);
  }
  failure read_numbers(std::size_t count, std::string_view what);
  failure skip_to_end(const std::string& section, std::size_t line);
  failure expect(const std::string& wanted);

  text_scanner& source_;
  listed_mesh file_;
  int version_ = 0, minor_ = 0;
  std::unordered_map<long long, vertex_index> vertex_of_;  // by the tags of nodes

 private:
  failure read_format();
  failure read_nodes_of_two(const std::string& end);
  failure read_nodes_of_four();
  failure read_node_block();
  failure read_positions_of_block(std::size_t nodes, std::size_t parameters);
  failure add_node(const word& tag);
  failure read_position(site& s);

  bool has_nodes_ = false;
};

}  // namespace asterism::internal
