// SPDX-License-Identifier: MIT
//
// Opens a VTK unstructured grid (.vtu) of one piece: finds its arrays, and decodes those that are
// asked for. Source: "VTK File Formats", the XML section (docs.vtk.org).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/io/vtu_numbers.hpp"
#include "asterism/mesh/io/xml_tags.hpp"

namespace asterism::internal {

// An array of the file: its section, its form, and the place of its numbers.
struct vtu_array {
  xml_tag tag;
  std::string_view section;  // Points, PointData, Cells, CellData or FieldData
  std::string_view content;
  std::size_t content_line = 0;

  std::string_view name() const { return tag["Name"]; }
};

// A file's text, which must outlive it, and its arrays. Numbers that are not finite are decoded as
// they are.
class vtu_file {
 public:
  // Reads the tags of a text. Fails, naming the line, if it is no such file.
  static result<vtu_file> open(std::string_view text, const std::string& file);

  std::size_t points() const { return points_; }
  std::size_t cells() const { return cells_; }
  std::size_t piece_line() const { return piece_line_; }
  // Returns all arrays, in the order of the file.
  const std::vector<vtu_array>& arrays() const { return arrays_; }
  // Returns the first array of a section, of this name if it is not empty; null if there is none.
  const vtu_array* find(std::string_view section, std::string_view name = {}) const;

  // Returns the number of values of each point or cell, 1 to 9.
  result<std::size_t> components(const vtu_array& a) const;
  // Returns the numbers. Fails if the array has another number of them, or if the arrays decoded so
  // far exceed the size of the file: several may claim one place.
  result<std::vector<double>> numbers(const vtu_array& a, std::size_t count);

  error failure(std::size_t line, const std::string& what) const {
    return tags_.failure(line, what);
  }

 private:
  vtu_file(std::string_view text, const std::string& file)
      : tags_(file, text), file_(file), file_bytes_(text.size()) {}

  std::optional<error> collect();
  std::optional<error> enter(const xml_tag& tag);
  std::optional<error> read_encoding(const xml_tag& tag);
  result<std::size_t> count_of(const xml_tag& tag, std::string_view attribute) const;
  std::optional<error> read_piece(const xml_tag& tag);
  std::optional<error> account_for(const vtu_array& a, std::size_t count);
  result<std::vector<double>> text_numbers(const vtu_array& a, std::size_t count) const;
  result<std::string_view> appended_at(const vtu_array& a) const;

  xml_scanner tags_;
  std::string file_;
  vtu_encoding how_;
  std::string compressor_;
  std::string_view section_;
  std::size_t pieces_ = 0, points_ = 0, cells_ = 0, piece_line_ = 0;
  std::vector<vtu_array> arrays_;
  std::string_view appended_;
  bool has_appended_ = false, raw_ = false;
  std::size_t file_bytes_, read_bytes_ = 0;
};

}  // namespace asterism::internal
