// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/vtu_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/io/text_scanner.hpp"

namespace asterism::internal {
namespace {

using failure_or_none = std::optional<error>;

constexpr std::array<std::string_view, 5> known_sections = {"PointData", "Points", "CellData",
                                                            "Cells", "FieldData"};

bool is_section(std::string_view name) {
  return std::find(known_sections.begin(), known_sections.end(), name) != known_sections.end();
}

result<std::size_t> whole_number(std::string_view text) {
  std::size_t value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || read.ec != std::errc() || read.ptr != text.data() + text.size())
    return error{quoted_token(text) + " is no whole number"};
  return value;
}

}  // namespace

result<vtu_file> vtu_file::open(std::string_view text, const std::string& file) {
  vtu_file opened(text, file);
  if (auto failed = opened.collect()) return *failed;
  return opened;
}

const vtu_array* vtu_file::find(std::string_view section, std::string_view name) const {
  for (const vtu_array& a : arrays_)
    if (a.section == section && (name.empty() || a.name() == name)) return &a;
  return nullptr;
}

failure_or_none vtu_file::read_encoding(const xml_tag& tag) {
  if (tag["type"] != "UnstructuredGrid")
    return tags_.failure(tag.line,
                         "type \"UnstructuredGrid\" wanted, not " + quoted_token(tag["type"]));
  compressor_ = std::string(tag["compressor"]);
  how_.zlib = compressor_ == "vtkZLibDataCompressor";
  how_.big_endian = tag["byte_order"] == "BigEndian";
  how_.wide_header = tag["header_type"] == "UInt64";
  return {};
}

// Reads a count of at most 32 bits, so that no product with it wraps.
result<std::size_t> vtu_file::count_of(const xml_tag& tag, std::string_view attribute) const {
  constexpr std::size_t most = std::size_t{1} << 30;
  const auto count = whole_number(tag[attribute]);
  if (!count)
    return tags_.failure(tag.line, std::string(attribute) + ": " + count.failure().message);
  if (count.value() > most)
    return tags_.failure(
        tag.line, fmt::format("{}: {} are more than can be numbered", attribute, count.value()));
  return count;
}

failure_or_none vtu_file::read_piece(const xml_tag& tag) {
  if (++pieces_ > 1) return tags_.failure(tag.line, "a second piece: only one can be read");
  const auto points = count_of(tag, "NumberOfPoints");
  if (!points) return points.failure();
  points_ = points.value();
  piece_line_ = tag.line;
  if (tag["NumberOfCells"].empty()) return {};
  const auto cells = count_of(tag, "NumberOfCells");
  if (!cells) return cells.failure();
  cells_ = cells.value();
  return {};
}

failure_or_none vtu_file::enter(const xml_tag& tag) {
  if (tag.name == "VTKFile") return read_encoding(tag);
  if (tag.name == "Piece") return read_piece(tag);
  if (tag.name == "AppendedData") {
    raw_ = tag["encoding"] == "raw";
    if (!raw_ && tag["encoding"] != "base64")
      return tags_.failure(tag.line,
                           "appended data are raw or base64, not " + quoted_token(tag["encoding"]));
    const std::string_view rest = tags_.rest();
    const std::size_t mark = rest.find('_');
    if (mark == std::string_view::npos)
      return tags_.failure(tag.line, "appended data begin with '_', and there is none");
    appended_ = rest.substr(mark + 1);
    has_appended_ = true;
    return {};
  }
  if (tag.name == "DataArray" && !section_.empty())
    arrays_.push_back({tag, section_, tags_.content(), tags_.line()});
  return {};
}

failure_or_none vtu_file::collect() {
  bool is_vtk = false;
  while (!has_appended_) {
    const auto tag = tags_.next();
    if (!tag) return tag.failure();
    const xml_tag& t = tag.value();
    if (t.name.empty()) break;
    is_vtk = is_vtk || t.name == "VTKFile";
    if (!is_vtk) return tags_.failure(t.line, quoted_token(t.name) + " where VTKFile should be");
    if (t.closes) {
      if (t.name == section_) section_ = {};
      continue;
    }
    if (auto failed = enter(t)) return failed;
    if (!t.closes_itself && is_section(t.name)) section_ = t.name;
  }
  if (pieces_ == 0) return tags_.failure(tags_.line(), "there is no Piece with points");
  return {};
}

result<std::size_t> vtu_file::components(const vtu_array& a) const {
  const std::string_view said = a.tag["NumberOfComponents"];
  if (said.empty()) return std::size_t{1};
  auto count = whole_number(said);
  if (!count || count.value() == 0 || count.value() > 9)
    return tags_.failure(a.tag.line,
                         "NumberOfComponents: " + quoted_token(said) + " is not 1 to 9");
  return count;
}

result<std::vector<double>> vtu_file::text_numbers(const vtu_array& a, std::size_t count) const {
  text_scanner words(file_, a.content);
  std::vector<double> found;
  const std::string name(a.tag["Name"]);
  for (std::size_t i = 0; i < count; ++i) {
    const word w = words.next();
    const std::size_t line = a.content_line + w.line - 1;
    const auto place = [&] {
      return fmt::format("array {}, number {}", quoted_token(name), i + 1);
    };
    if (w.empty()) return tags_.failure(line, place() + ": the array ends here");
    if (w.text == "nan" || w.text == "-nan" || w.text == "inf" || w.text == "-inf") {
      found.push_back(std::nan(""));
      continue;
    }
    const auto value = parse_number(w.text);
    if (!value) return tags_.failure(line, place() + ": " + value.failure().message);
    found.push_back(value.value());
  }
  if (const word more = words.next(); !more.empty())
    return tags_.failure(a.content_line + more.line - 1,
                         fmt::format("array {}: {} after the last of {} numbers",
                                     quoted_token(name), quoted_token(more.text), count));
  return found;
}

result<std::string_view> vtu_file::appended_at(const vtu_array& a) const {
  const auto offset = whole_number(a.tag["offset"]);
  if (!has_appended_ || !offset || offset.value() >= appended_.size())
    return tags_.failure(a.tag.line, "array " + quoted_token(a.tag["Name"]) +
                                         ": its offset leads to no appended data");
  return appended_.substr(offset.value());
}

// Counts the bytes of arrays, and limits them by the size of the file: if several arrays claim one
// place, memory would not be proportional to the file. Deflate makes 258 bytes of two bits at most,
// so 1032 of one byte.
failure_or_none vtu_file::account_for(const vtu_array& a, std::size_t count) {
  constexpr std::size_t most_expansion = 1032;
  const std::size_t can_hold = file_bytes_ * (how_.zlib ? most_expansion : 1);
  const std::size_t each = vtu_bytes_of(a.tag["type"]).value_or(0);
  const std::size_t left = can_hold - read_bytes_;
  if (each == 0 || count <= left / each) {
    read_bytes_ += count * each;
    return {};
  }
  return tags_.failure(a.tag.line,
                       fmt::format("array {}: with those before it {:.0f} bytes of numbers, more "
                                   "than a file of {} bytes can hold",
                                   quoted_token(a.name()),
                                   static_cast<double>(read_bytes_) +
                                       static_cast<double>(count) * static_cast<double>(each),
                                   file_bytes_));
}

result<std::vector<double>> vtu_file::numbers(const vtu_array& a, std::size_t count) {
  const std::string_view format = a.tag["format"];
  const bool is_text = format == "ascii" || format.empty();
  if (!is_text && !compressor_.empty() && !how_.zlib)
    return tags_.failure(a.tag.line, "data compressed by " + quoted_token(compressor_) +
                                         " cannot be read: write the file with zlib, or without");
  if (is_text) return text_numbers(a, count);
  if (auto failed = account_for(a, count)) return *failed;
  std::string_view text = a.content;
  if (format == "appended") {
    const auto there = appended_at(a);
    if (!there) return there.failure();
    text = there.value();
  } else if (format != "binary") {
    return tags_.failure(a.tag.line, "format " + quoted_token(format) + " is not known");
  }
  auto found = vtu_binary_numbers(text, a.tag["type"], count, how_, raw_ && format == "appended");
  if (!found)
    return tags_.failure(a.tag.line,
                         "array " + quoted_token(a.tag["Name"]) + ": " + found.failure().message);
  return found;
}

}  // namespace asterism::internal
