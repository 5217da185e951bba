// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/listed_readers.hpp"
#include "asterism/mesh/io/vtk_cells.hpp"

namespace asterism::internal {
namespace {

using failure = std::optional<error>;
using numbers = std::vector<double>;

enum class number_kind { whole, unsigned_whole, real };
struct number_type {
  std::string_view name;
  std::size_t bytes;
  number_kind kind;
};
constexpr std::array<number_type, 13> number_types = {
    {{"char", 1, number_kind::whole},
     {"unsigned_char", 1, number_kind::unsigned_whole},
     {"short", 2, number_kind::whole},
     {"unsigned_short", 2, number_kind::unsigned_whole},
     {"int", 4, number_kind::whole},
     {"unsigned_int", 4, number_kind::unsigned_whole},
     {"long", 8, number_kind::whole},
     {"unsigned_long", 8, number_kind::unsigned_whole},
     {"vtkidtype", 4, number_kind::whole},
     {"vtktypeint64", 8, number_kind::whole},
     {"vtktypeint32", 4, number_kind::whole},
     {"float", 4, number_kind::real},
     {"double", 8, number_kind::real}}};
constexpr number_type whole_type = number_types[4];

// Returns a number from the file's bytes, the most significant first.
double number_of(std::string_view bytes, const number_type& type) {
  std::uint64_t word = 0;
  for (const char byte : bytes) word = word << 8U | static_cast<unsigned char>(byte);
  if (type.kind == number_kind::real)
    return type.bytes == 8
               ? std::bit_cast<double>(word)
               : static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(word)));
  if (type.kind == number_kind::unsigned_whole) return static_cast<double>(word);
  const std::size_t unused = 64 - 8 * type.bytes;
  return static_cast<double>(static_cast<std::int64_t>(word << unused) >> unused);
}

std::string in_capitals(std::string_view text) {
  std::string upper(text);
  for (char& c : upper)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return upper;
}

class vtk_reader {
 public:
  vtk_reader(std::string_view text, const std::string& file)
      : source_(file, text, '\0'), cells_(made_) {
    made_.file = file;
  }

  failure read();
  listed_mesh take() { return std::move(made_); }

 private:
  // Lists of points, one for each cell.
  struct cell_lists {
    numbers ends, points;
  };
  // An array of cell data with one number for each cell.
  struct cell_array {
    std::string name;
    bool whole_numbers;
    std::size_t line;
    numbers values;
  };

  failure read_header();
  failure read_entry(const word& head);
  failure read_points();
  result<cell_lists> read_lists(const word& head);
  result<cell_lists> read_new_lists(const word& head, std::size_t ends, std::size_t points);
  failure read_cell_types();
  failure read_data(const word& head);
  failure read_attribute(const word& head);
  failure read_field();
  failure skip_metadata();
  failure take_array(const word& name, const number_type& type, std::size_t components,
                     std::size_t tuples);
  result<std::size_t> count(std::string_view what);
  result<number_type> type();
  // Reads this many numbers. If they are not wanted, reads the same number of words of any kind.
  result<numbers> values(std::size_t count, const number_type& type, bool wanted);
  failure add_cells();
  failure add_list(const cell_lists& lists, const numbers* types, int type, std::size_t& cell);
  failure number_cells(std::size_t cells);

  text_scanner source_;
  listed_mesh made_;
  vtk_cells cells_;
  bool binary_ = false, polygons_ = false, points_seen_ = false;
  enum class data_of { nothing, points, cells, field } data_ = data_of::nothing;
  std::size_t tuples_ = 0;
  cell_lists unstructured_, lists_[4];  // vertices, lines, polygons, strips
  numbers types_;
  std::size_t types_line_ = 0;
  std::vector<cell_array> arrays_;
};

failure vtk_reader::read() {
  if (auto failed = read_header()) return failed;
  std::string upper;
  for (word head = source_.next(); !head.empty(); head = source_.next()) {
    // Accepts keywords in any case: FreeFEM writes Scalars.
    upper = in_capitals(head.text);
    if (auto failed = read_entry({upper, head.line})) return failed;
  }
  if (!points_seen_) return source_.failure(source_.line(), "there are no POINTS");
  if (auto failed = add_cells()) return failed;
  if (made_.content.triangles.empty() && made_.quadrilaterals.empty() &&
      made_.content.boundary.empty())
    return source_.failure(source_.line(), "there is no triangle, quadrilateral or line");
  made_.all_edges = true;
  return put_in_order(made_, listed_order::put_right);
}

failure vtk_reader::read_header() {
  if (!source_.rest_of_line().starts_with("# vtk DataFile Version"))
    return source_.failure(1, "'# vtk DataFile Version' wanted on the first line");
  source_.rest_of_line();  // the title
  const word how = source_.next();
  binary_ = how.text == "BINARY";
  if (!binary_ && how.text != "ASCII")
    return source_.failure(how.line, "ASCII or BINARY wanted, not " + quoted_token(how.text));
  return {};
}

failure vtk_reader::read_entry(const word& head) {
  if (head.text == "DATASET") {
    const word kind = source_.next();
    polygons_ = kind.text == "POLYDATA";
    if (polygons_ || kind.text == "UNSTRUCTURED_GRID") return {};
    return source_.failure(kind.line, "a dataset " + quoted_token(kind.text) +
                                          ": UNSTRUCTURED_GRID and POLYDATA can be read");
  }
  if (head.text == "POINTS") return read_points();
  constexpr std::array<std::string_view, 4> lists = {"VERTICES", "LINES", "POLYGONS",
                                                     "TRIANGLE_STRIPS"};
  for (std::size_t k = 0; k < lists.size(); ++k)
    if (head.text == lists[k]) {
      auto read = read_lists(head);
      if (!read) return read.failure();
      lists_[k] = std::move(read).value();
      return {};
    }
  if (head.text == "CELLS") {
    auto read = read_lists(head);
    if (!read) return read.failure();
    unstructured_ = std::move(read).value();
    return {};
  }
  if (head.text == "CELL_TYPES") return read_cell_types();
  if (head.text == "POINT_DATA" || head.text == "CELL_DATA") return read_data(head);
  if (head.text == "METADATA") return skip_metadata();
  return read_attribute(head);
}

// Reads counts of bytes, which may exceed the length of a text; values() bounds the memory
// allocated for them.
result<std::size_t> vtk_reader::count(std::string_view what) {
  constexpr long long most = 1'000'000'000'000'000;
  const word w = source_.next();
  const auto number = to_integer(source_, w, what);
  if (!number) return number.failure();
  if (number.value() < 0 || number.value() > most)
    return source_.failure(w.line, std::string(what) + ": " + quoted_token(w.text) +
                                       " is no number that a file can hold");
  return static_cast<std::size_t>(number.value());
}

result<number_type> vtk_reader::type() {
  const word w = source_.next();
  std::string name(w.text);
  for (char& c : name) c = lower_case(c);
  for (const number_type& known : number_types)
    if (name == known.name) return known;
  return source_.failure(w.line, quoted_token(w.text) + " is no known type of number");
}

result<numbers> vtk_reader::values(std::size_t count, const number_type& type, bool wanted) {
  numbers made;
  if (!binary_) {
    if (count > source_.remaining() / 2 + 1)
      return source_.failure(source_.line(), fmt::format("{} numbers are more than the rest of the "
                                                         "file can hold",
                                                         count));
    if (wanted) made.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      const word w = source_.next();
      if (w.empty()) return source_.failure(w.line, "the file ends within an array");
      if (!wanted) continue;
      const auto value = to_number(source_, w, "number of an array");
      if (!value) return value.failure();
      made.push_back(value.value());
    }
    return made;
  }
  source_.rest_of_line();
  if (count > source_.remaining() / type.bytes)
    return source_.failure(source_.line(), fmt::format("{} numbers of {} bytes are more than the "
                                                       "rest of the file can hold",
                                                       count, type.bytes));
  const std::string_view bytes = source_.take_bytes(count * type.bytes);
  if (!wanted) return made;
  made.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    made.push_back(number_of(bytes.substr(i * type.bytes, type.bytes), type));
  return made;
}

failure vtk_reader::read_points() {
  const std::size_t line = source_.line();
  if (std::exchange(points_seen_, true)) return source_.failure(line, "POINTS a second time");
  const auto points = count("number of points");
  if (!points) return points.failure();
  if (points.value() > std::numeric_limits<vertex_index>::max() / 4)
    return source_.failure(line, "more points than 32-bit numbers can name");
  const auto of = type();
  if (!of) return of.failure();
  const auto places = values(3 * points.value(), of.value(), true);
  if (!places) return places.failure();
  for (std::size_t v = 0; v < points.value(); ++v) {
    const double* const p = &places.value()[3 * v];
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
      return source_.failure(line, fmt::format("point {}: a coordinate is not finite", v + 1));
    if (p[2] != 0) made_.heights.push_back({static_cast<vertex_index>(v), line, p[2]});
    made_.content.sites.push_back({{p[0], p[1]}, {1, 0, 1}});
  }
  return {};
}

// Reads lists of points. Before version 5 each list begins with its length; from version 5 on the
// ends of all lists come first.
result<vtk_reader::cell_lists> vtk_reader::read_lists(const word& head) {
  const auto first = count("number of cells"), second = count("size of the list of cells");
  if (!first) return first.failure();
  if (!second) return second.failure();
  if (in_capitals(text_scanner(source_).next().text) == "OFFSETS")
    return read_new_lists(head, first.value(), second.value());
  const auto all = values(second.value(), whole_type, true);
  if (!all) return all.failure();
  cell_lists made;
  std::size_t at = 0;
  for (std::size_t cell = 0; cell < first.value(); ++cell) {
    const double left = static_cast<double>(all.value().size()) - static_cast<double>(at) - 1;
    if (at >= all.value().size() || !(all.value()[at] >= 0 && all.value()[at] <= left))
      return source_.failure(head.line, fmt::format("{}: the list of cell {} is longer than all",
                                                    head.text, cell + 1));
    const auto points = static_cast<std::size_t>(all.value()[at]);
    for (std::size_t k = 1; k <= points; ++k) made.points.push_back(all.value()[at + k]);
    at += points + 1;
    made.ends.push_back(static_cast<double>(made.points.size()));
  }
  return made;
}

result<vtk_reader::cell_lists> vtk_reader::read_new_lists(const word& head, std::size_t ends,
                                                          std::size_t points) {
  cell_lists made;
  source_.next();
  const auto of_ends = type();
  if (!of_ends) return of_ends.failure();
  auto read = values(ends, of_ends.value(), true);
  if (!read) return read.failure();
  made.ends = std::move(read).value();
  if (in_capitals(source_.next().text) != "CONNECTIVITY")
    return source_.failure(source_.line(), "CONNECTIVITY wanted after OFFSETS");
  const auto of_points = type();
  if (!of_points) return of_points.failure();
  read = values(points, of_points.value(), true);
  if (!read) return read.failure();
  made.points = std::move(read).value();
  const auto size = static_cast<double>(made.points.size());
  if (!made.ends.empty() && (made.ends.front() != 0 || !(made.ends.back() <= size) ||
                             !std::is_sorted(made.ends.begin(), made.ends.end())))
    return source_.failure(head.line, fmt::format("{}: the OFFSETS do not ascend from 0 to the "
                                                  "number of points",
                                                  head.text));
  if (!made.ends.empty()) made.ends.erase(made.ends.begin());
  return made;
}

failure vtk_reader::read_cell_types() {
  types_line_ = source_.line();
  const auto cells = count("number of cells");
  if (!cells) return cells.failure();
  auto read = values(cells.value(), whole_type, true);
  if (!read) return read.failure();
  types_ = std::move(read).value();
  return {};
}

failure vtk_reader::read_data(const word& head) {
  data_ = head.text == "CELL_DATA" ? data_of::cells : data_of::points;
  const auto tuples = count("number of tuples");
  if (!tuples) return tuples.failure();
  tuples_ = tuples.value();
  return {};
}

failure vtk_reader::skip_metadata() {
  source_.rest_of_line();
  while (source_.remaining() > 0)
    if (source_.rest_of_line().empty()) break;
  return {};
}

failure vtk_reader::read_attribute(const word& head) {
  if (head.text == "FIELD") return read_field();
  const bool is_table = head.text == "LOOKUP_TABLE", is_colour = head.text == "COLOR_SCALARS";
  constexpr std::array<std::pair<std::string_view, std::size_t>, 6> widths = {
      {{"VECTORS", 3},
       {"NORMALS", 3},
       {"TENSORS", 9},
       {"TENSORS6", 6},
       {"GLOBAL_IDS", 1},
       {"PEDIGREE_IDS", 1}}};
  const word name = source_.next();
  if (is_table || is_colour) {
    const auto size = count("size of a table of colours");
    if (!size) return size.failure();
    const std::size_t wide = is_table ? 4 : tuples_;
    if (size.value() > 0 && wide > source_.remaining() / size.value())
      return source_.failure(head.line, "a table of colours is longer than the file");
    const auto skipped =
        values(wide * size.value(), binary_ ? number_types[1] : number_types[11], false);
    return skipped ? failure{} : skipped.failure();
  }
  std::size_t components = 0;
  for (const auto& [what, width] : widths)
    if (head.text == what) components = width;
  if (head.text == "TEXTURE_COORDINATES") {
    const auto wide = count("width of coordinates");
    if (!wide) return wide.failure();
    components = wide.value();
  } else if (head.text != "SCALARS" && components == 0) {
    return source_.failure(head.line, quoted_token(head.text) + " is no known entry");
  }
  const auto of = type();
  if (!of) return of.failure();
  if (head.text == "SCALARS") {
    // Accepts SCALARS without its number of components (then 1) and without a LOOKUP_TABLE line.
    components = 1;
    word next = text_scanner(source_).next();
    if (next.line == head.line && in_capitals(next.text) != "LOOKUP_TABLE" && !next.empty()) {
      const auto wide = count("width of scalars");
      if (!wide) return wide.failure();
      components = wide.value();
      next = text_scanner(source_).next();
    }
    if (in_capitals(next.text) == "LOOKUP_TABLE") {
      source_.next();
      source_.next();
    }
  }
  return take_array(name, of.value(), components, tuples_);
}

failure vtk_reader::read_field() {
  source_.next();  // its name
  const auto arrays = count("number of arrays");
  if (!arrays) return arrays.failure();
  for (std::size_t i = 0; i < arrays.value(); ++i) {
    word name = source_.next();
    while (in_capitals(name.text) == "METADATA") {
      if (auto failed = skip_metadata()) return failed;
      name = source_.next();
    }
    const auto components = count("number of components"), tuples = count("number of tuples");
    if (!components) return components.failure();
    if (!tuples) return tuples.failure();
    const auto of = type();
    if (!of) return of.failure();
    if (auto failed = take_array(name, of.value(), components.value(), tuples.value()))
      return failed;
  }
  return {};
}

failure vtk_reader::take_array(const word& name, const number_type& type, std::size_t components,
                               std::size_t tuples) {
  if (tuples > 0 && components > source_.remaining() / tuples)
    return source_.failure(name.line, quoted_token(name.text) + " is longer than the file");
  const bool wanted = data_ == data_of::cells && components == 1;
  auto read = values(components * tuples, type, wanted);
  if (!read) return read.failure();
  if (wanted)
    arrays_.push_back({std::string(name.text), type.kind != number_kind::real, name.line,
                       std::move(read).value()});
  return {};
}

failure vtk_reader::add_list(const cell_lists& lists, const numbers* of_types, int type,
                             std::size_t& cell) {
  std::size_t begin = 0;
  for (std::size_t i = 0; i < lists.ends.size(); ++i) {
    const auto end = static_cast<std::size_t>(lists.ends[i]);
    const double kind = of_types != nullptr ? (*of_types)[i] : type;
    if (!(kind >= 0 && kind < 256 && kind == std::floor(kind)))
      return source_.failure(types_line_,
                             fmt::format("cell {}: {} is no type of a cell", cell + 1, kind));
    const vtk_cell next{static_cast<int>(kind), cell++, types_line_, lists.points.data() + begin,
                        end - begin};
    if (auto failed = cells_.add(next)) return failed;
    begin = end;
  }
  return {};
}

// Adds the cells. Polygons are numbered after the vertices and lines, in whatever order the file
// has them.
failure vtk_reader::add_cells() {
  if (types_line_ == 0) types_line_ = source_.line();
  std::size_t cells = 0;
  if (polygons_) {
    constexpr int kinds[] = {2, 4, 7, 6};
    for (std::size_t k = 0; k < 4; ++k)
      if (auto failed = add_list(lists_[k], nullptr, kinds[k], cells)) return failed;
  } else {
    if (types_.size() != unstructured_.ends.size())
      return source_.failure(types_line_, fmt::format("{} types for {} cells", types_.size(),
                                                      unstructured_.ends.size()));
    if (auto failed = add_list(unstructured_, &types_, 0, cells)) return failed;
  }
  return number_cells(cells);
}

failure vtk_reader::number_cells(std::size_t cells) {
  std::vector<vtk_candidate> candidates;
  for (const cell_array& a : arrays_) candidates.push_back({a.name, a.whole_numbers, a.line});
  const auto chosen = choose_region_array(candidates, made_);
  if (!chosen) return chosen.failure();
  if (!chosen.value()) return {};
  const cell_array& a = arrays_[*chosen.value()];
  if (a.values.size() != cells)
    return source_.failure(a.line, fmt::format("array {}: {} numbers for {} cells",
                                               quoted_token(a.name), a.values.size(), cells));
  constexpr double most = 1e15;  // all whole numbers up to it are doubles
  for (const double x : a.values)
    if (!(std::abs(x) <= most) || x != std::floor(x))
      return source_.failure(
          a.line, fmt::format("array {}: {:g} is no whole number", quoted_token(a.name), x));
  cells_.set_numbers(a.values);
  return {};
}

}  // namespace

result<listed_mesh> read_vtk(std::string_view text, const std::string& file) {
  vtk_reader reader(text, file);
  if (auto failed = reader.read()) return *failed;
  return reader.take();
}

}  // namespace asterism::internal
