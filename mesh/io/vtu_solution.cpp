// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/vtu_solution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/data/site_box.hpp"
#include "asterism/mesh/io/text_scanner.hpp"
#include "asterism/mesh/io/vtu_numbers.hpp"
#include "asterism/mesh/io/xml_tags.hpp"

namespace asterism::internal {
namespace {

using failure = std::optional<error>;

// An array of the file: where it is described, and where its numbers are.
struct data_array {
  xml_tag tag;
  std::string_view content;
  std::size_t content_line = 0;
};

class vtu_reader {
 public:
  vtu_reader(std::string_view text, const std::string& file, const mesh& m)
      : tags_(file, text), file_(file), mesh_(m), file_bytes_(text.size()) {}

  result<solution> read();

 private:
  failure collect();
  failure enter(const xml_tag& tag);
  failure read_encoding(const xml_tag& tag);
  failure read_piece(const xml_tag& tag);
  result<std::size_t> components(const data_array& a) const;
  result<std::vector<double>> numbers(const data_array& a, std::size_t count);
  result<std::vector<double>> text_numbers(const data_array& a, std::size_t count) const;
  result<std::string_view> appended_at(const data_array& a) const;
  failure account_for(const data_array& a, std::size_t count);
  failure check_points();
  failure add_field(const data_array& a);

  xml_scanner tags_;
  std::string file_;
  const mesh& mesh_;
  vtu_encoding how_;
  std::string compressor_;
  std::string_view section_;
  std::size_t pieces_ = 0;
  std::vector<data_array> arrays_, points_;
  std::string_view appended_;
  bool has_appended_ = false, raw_ = false;
  std::size_t file_bytes_, read_bytes_ = 0;
  solution made_;
};

result<std::size_t> whole_number(std::string_view text) {
  std::size_t value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || read.ec != std::errc() || read.ptr != text.data() + text.size())
    return error{quoted_token(text) + " is no whole number"};
  return value;
}

failure vtu_reader::read_encoding(const xml_tag& tag) {
  if (tag["type"] != "UnstructuredGrid")
    return tags_.failure(tag.line,
                         "type \"UnstructuredGrid\" wanted, not " + quoted_token(tag["type"]));
  compressor_ = std::string(tag["compressor"]);
  how_.zlib = compressor_ == "vtkZLibDataCompressor";
  how_.big_endian = tag["byte_order"] == "BigEndian";
  how_.wide_header = tag["header_type"] == "UInt64";
  return {};
}

failure vtu_reader::read_piece(const xml_tag& tag) {
  if (++pieces_ > 1) return tags_.failure(tag.line, "a second piece: only one can be read");
  const auto count = whole_number(tag["NumberOfPoints"]);
  if (!count) return tags_.failure(tag.line, "NumberOfPoints: " + count.failure().message);
  if (count.value() != mesh_.sites.size())
    return tags_.failure(tag.line, fmt::format("values at {} points, and the mesh has {} vertices",
                                               count.value(), mesh_.sites.size()));
  made_.vertices = count.value();
  return {};
}

failure vtu_reader::enter(const xml_tag& tag) {
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
  if (tag.name == "DataArray" && (section_ == "PointData" || section_ == "Points")) {
    const data_array found{tag, tags_.content(), tags_.line()};
    (section_ == "Points" ? points_ : arrays_).push_back(found);
  }
  return {};
}

failure vtu_reader::collect() {
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
    if (!t.closes_itself &&
        (t.name == "PointData" || t.name == "Points" || t.name == "CellData" || t.name == "Cells"))
      section_ = t.name;
  }
  if (pieces_ == 0) return tags_.failure(tags_.line(), "there is no Piece with points");
  return {};
}

result<std::size_t> vtu_reader::components(const data_array& a) const {
  const std::string_view said = a.tag["NumberOfComponents"];
  if (said.empty()) return std::size_t{1};
  auto count = whole_number(said);
  if (!count || count.value() == 0 || count.value() > 9)
    return tags_.failure(a.tag.line,
                         "NumberOfComponents: " + quoted_token(said) + " is not 1 to 9");
  return count;
}

result<std::vector<double>> vtu_reader::text_numbers(const data_array& a, std::size_t count) const {
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

result<std::string_view> vtu_reader::appended_at(const data_array& a) const {
  const auto offset = whole_number(a.tag["offset"]);
  if (!has_appended_ || !offset || offset.value() >= appended_.size())
    return tags_.failure(a.tag.line, "array " + quoted_token(a.tag["Name"]) +
                                         ": its offset leads to no appended data");
  return appended_.substr(offset.value());
}

// Counts the bytes of arrays, of which a file has not more than it can hold: where several arrays
// are at one place, memory would not be in proportion to the file. Deflate makes 258 bytes of two
// bits at most, so 1032 of one byte.
failure vtu_reader::account_for(const data_array& a, std::size_t count) {
  constexpr std::size_t most_expansion = 1032;
  const std::size_t can_hold = file_bytes_ * (how_.zlib ? most_expansion : 1);
  read_bytes_ += count * vtu_bytes_of(a.tag["type"]).value_or(0);
  if (read_bytes_ <= can_hold) return {};
  return tags_.failure(a.tag.line,
                       fmt::format("array {}: with those before it {} bytes of numbers, more than "
                                   "a file of {} bytes can hold",
                                   quoted_token(a.tag["Name"]), read_bytes_, file_bytes_));
}

result<std::vector<double>> vtu_reader::numbers(const data_array& a, std::size_t count) {
  const std::string_view format = a.tag["format"];
  if (format == "ascii" || format.empty()) return text_numbers(a, count);
  if (!compressor_.empty() && !how_.zlib)
    return tags_.failure(a.tag.line, "data compressed by " + quoted_token(compressor_) +
                                         " cannot be read: write the file with zlib, or without");
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

// The points of the file may have been written in single precision.
failure vtu_reader::check_points() {
  if (points_.empty()) return {};
  const auto width = components(points_[0]);
  if (!width) return width.failure();
  if (width.value() < 2) return tags_.failure(points_[0].tag.line, "points have no y");
  const auto found = numbers(points_[0], width.value() * made_.vertices);
  if (!found) return found.failure();
  const bounding_box box = box_of_sites(mesh_.sites);
  const double most = std::max(
      {std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
  for (std::size_t v = 0; v < made_.vertices; ++v) {
    const double x = found.value()[v * width.value()], y = found.value()[v * width.value() + 1];
    const point& p = mesh_.sites[v].position;
    if (std::abs(x - p.x) <= 1e-6 * most && std::abs(y - p.y) <= 1e-6 * most) continue;
    return tags_.failure(points_[0].tag.line,
                         fmt::format("point {} is at ({:g}, {:g}), and the mesh's vertex at "
                                     "({:g}, {:g})",
                                     v + 1, x, y, p.x, p.y));
  }
  return {};
}

// Integers, and vectors out of the plane, are no fields of a solution.
failure vtu_reader::add_field(const data_array& a) {
  if (!a.tag["type"].starts_with("Float")) return {};
  const auto width = components(a);
  if (!width) return width.failure();
  if (width.value() > 3) return {};
  const auto found = numbers(a, width.value() * made_.vertices);
  if (!found) return found.failure();
  solution_field field{
      std::string(a.tag["Name"]), width.value() == 1 ? field_kind::scalar : field_kind::vector, {}};
  const std::size_t kept = components_of(field.kind);
  field.values.reserve(kept * made_.vertices);
  for (std::size_t v = 0; v < made_.vertices; ++v)
    for (std::size_t i = 0; i < width.value(); ++i) {
      const double x = found.value()[v * width.value() + i];
      if (!std::isfinite(x))
        return tags_.failure(a.tag.line, fmt::format("array {}, vertex {}: a number is not finite",
                                                     quoted_token(field.name), v + 1));
      if (i < kept)
        field.values.push_back(x);
      else if (x != 0)
        return {};
    }
  made_.fields.push_back(std::move(field));
  return {};
}

result<solution> vtu_reader::read() {
  if (auto failed = collect()) return *failed;
  if (auto failed = check_points()) return *failed;
  for (const data_array& a : arrays_)
    if (auto failed = add_field(a)) return *failed;
  return std::move(made_);
}

}  // namespace

result<solution> read_vtu_solution(std::string_view text, const std::string& file, const mesh& m) {
  return vtu_reader(text, file, m).read();
}

}  // namespace asterism::internal
