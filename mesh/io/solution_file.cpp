// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/solution_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/file_output.hpp"
#include "asterism/mesh/io/gmsh_solution.hpp"
#include "asterism/mesh/io/medit_binary.hpp"
#include "asterism/mesh/io/medit_solution.hpp"
#include "asterism/mesh/io/solution_output.hpp"
#include "asterism/mesh/io/text_lines.hpp"
#include "asterism/mesh/io/text_scanner.hpp"
#include "asterism/mesh/io/vtu_solution.hpp"

namespace asterism {
using namespace internal;
namespace {

using failure = std::optional<error>;

constexpr const char* sections_text =
    "behind SolAtVertices stand the number of vertices, the number of fields, the type of each (1 "
    "scalar, 2 vector, 3 tensor) and the values, vertex after vertex";

// Returns the number of values that a field of this kind has in a file of this dimension.
std::size_t numbers_of(field_kind kind, int dimension) {
  if (dimension == 2 || kind == field_kind::scalar) return components_of(kind);
  return kind == field_kind::vector ? 3 : 6;
}

class values_reader {
 public:
  values_reader(text_scanner& source, std::size_t vertices, solution& made)
      : source_(source), vertices_(vertices), made_(made) {}

  failure read_medit();
  failure read_bamg(bool with_types);

 private:
  failure read_count();
  failure read_kind();
  failure read_values(int dimension);
  result<double> read_number(std::size_t field, std::size_t v);
  failure check_end();

  text_scanner& source_;
  std::size_t vertices_;
  solution& made_;
};

failure values_reader::read_count() {
  const word w = source_.next();
  const auto count = to_integer(source_, w, "number of vertices");
  if (!count) return count.failure();
  if (!std::cmp_equal(count.value(), vertices_))
    return source_.failure(w.line, fmt::format("values at {} vertices, and the mesh has {}",
                                               count.value(), vertices_));
  made_.vertices = vertices_;
  return {};
}

failure values_reader::read_kind() {
  const word w = source_.next();
  const auto type = to_integer(source_, w, "type of a field");
  if (!type) return type.failure();
  if (type.value() < 1 || type.value() > 3)
    return source_.failure(w.line, "type of a field: " + quoted_token(w.text) +
                                       " is not 1 (scalar), 2 (vector) or 3 (symmetric tensor)");
  made_.fields.push_back(
      {std::to_string(made_.fields.size() + 1), static_cast<field_kind>(type.value()), {}});
  return {};
}

result<double> values_reader::read_number(std::size_t field, std::size_t v) {
  const word w = source_.next();
  // Makes the words for the place of an error only for a failure.
  if (auto value = to_number(source_, w, ""); value) return value;
  return to_number(source_, w, fmt::format("field {}, vertex {}", field + 1, v + 1));
}

failure values_reader::read_values(int dimension) {
  for (std::size_t v = 0; v < made_.vertices; ++v)
    for (std::size_t f = 0; f < made_.fields.size(); ++f) {
      solution_field& field = made_.fields[f];
      const std::size_t count = numbers_of(field.kind, dimension);
      for (std::size_t i = 0; i < count; ++i) {
        const std::size_t line = source_.line();
        const auto value = read_number(f, v);
        if (!value) return value.failure();
        if (i < components_of(field.kind))
          field.values.push_back(value.value());
        else if (field.kind == field_kind::vector && value.value() != 0)
          return source_.failure(
              line, fmt::format("field {}, vertex {}: the vector has a third component, {}", f + 1,
                                v + 1, value.value()));
      }
    }
  return {};
}

failure values_reader::check_end() {
  const word more = source_.next();
  if (more.empty() || more.text == "End") return {};
  return source_.failure(more.line, quoted_token(more.text) + " after the last value");
}

failure values_reader::read_medit() {
  const auto dimension = read_medit_header(source_);
  if (!dimension) return dimension.failure();
  const word keyword = source_.next();
  if (keyword.text != "SolAtVertices")
    return source_.failure(
        keyword.line,
        (keyword.empty() ? std::string("the file ends") : quoted_token(keyword.text)) +
            " where the section SolAtVertices should be: " + sections_text);
  if (auto failed = read_count()) return failed;
  const word w = source_.next();
  const auto fields = to_count(source_, w, "number of fields");
  if (!fields) return fields.failure();
  if (fields.value() == 0)
    return source_.failure(
        w.line, std::string("SolAtVertices: there are no fields, and one or more are wanted: ") +
                    sections_text);
  for (std::size_t i = 0; i < fields.value(); ++i)
    if (auto failed = read_kind()) return failed;
  if (auto failed = read_values(dimension.value())) return failed;
  return check_end();
}

failure values_reader::read_bamg(bool with_types) {
  const word first = source_.next();
  if (first.text != "2")
    return source_.failure(first.line, "dimension: 2 wanted, not " + quoted_token(first.text));
  const auto fields = to_count(source_, source_.next(), "number of fields");
  if (!fields) return fields.failure();
  for (std::size_t i = 0; i < fields.value(); ++i) {
    if (!with_types)
      made_.fields.push_back({std::to_string(i + 1), field_kind::scalar, {}});
    else if (auto failed = read_kind())
      return failed;
  }
  if (auto failed = read_count()) return failed;
  const word where = source_.next();
  if (where.text != "2")
    return source_.failure(
        where.line, "place of the values: 2 (at vertices) wanted, not " + quoted_token(where.text));
  if (auto failed = read_values(2)) return failed;
  return check_end();
}

// True if the file's ending is in capital letters: BAMG distinguishes .BB, with types, from .bb.
bool has_types(const std::filesystem::path& path) { return path.extension() == ".BB"; }

failure check_fields(const solution& s, const std::string& file) {
  if (s.fields.empty())
    return error{file +
                     ": there is no field in it; values at the vertices are wanted, as "
                     "floating-point numbers: scalars, or vectors of the plane",
                 error_code::malformed_file};
  if (s.fields.size() == 1 && s.fields[0].kind == field_kind::tensor)
    return error{file +
                     ": one symmetric tensor a vertex is a metric, and a solution is wanted; "
                     "--metric takes it",
                 error_code::malformed_file};
  return {};
}

// Leaves out the values of vertices that are not in the mesh.
void leave_out(solution& s, const std::vector<vertex_index>& left_out) {
  if (left_out.empty()) return;
  for (solution_field& f : s.fields) {
    const std::size_t width = components_of(f.kind);
    std::size_t kept = 0;
    auto next = left_out.begin();
    for (std::size_t v = 0; v < s.vertices; ++v) {
      if (next != left_out.end() && *next == v) {
        ++next;
        continue;
      }
      for (std::size_t i = 0; i < width; ++i) f.values[kept * width + i] = f.values[v * width + i];
      ++kept;
    }
    f.values.resize(kept * width);
  }
  s.vertices -= left_out.size();
}

const char* const suffixes[3][3] = {{"", "", ""}, {".x", ".y", ""}, {".xx", ".xy", ".yy"}};

std::string name_of(const solution_field& f, std::size_t component) {
  return f.name + suffixes[components_of(f.kind) - 1][component];
}

nodal_values component_of(const solution_field& f, std::size_t component, std::size_t vertices) {
  nodal_values made{name_of(f, component), {}};
  made.values.reserve(vertices);
  for (std::size_t v = 0; v < vertices; ++v)
    made.values.push_back(f.values[v * components_of(f.kind) + component]);
  return made;
}

// Returns the names of fields, and those of the components of vectors.
std::string names_of(const solution& s) {
  std::string all;
  for (const solution_field& f : s.fields) {
    all += (all.empty() ? "" : ", ") + quoted_token(f.name);
    if (f.kind == field_kind::vector)
      all += " with " + quoted_token(name_of(f, 0)) + " and " + quoted_token(name_of(f, 1));
  }
  return all;
}

// Appends a line with all components of all fields for each vertex.
void append_values(std::string& contents, const solution& s) {
  append_lines(contents, s.vertices, [&](std::size_t v, std::string& line) {
    for (const solution_field& f : s.fields)
      for (std::size_t i = 0; i < components_of(f.kind); ++i) {
        append_number(line, f.values[v * components_of(f.kind) + i]);
        line += ' ';
      }
    line.back() = '\n';
  });
}

}  // namespace

result<solution> read_solution(const std::filesystem::path& path, const mesh& m) {
  return read_solution(path, m, {});
}

result<solution> read_solution(const std::filesystem::path& path, const mesh& m,
                               const std::vector<vertex_index>& left_out) {
  auto made = read_fields(path, m, left_out);
  if (!made) return made;
  if (auto failed = check_fields(made.value(), path.string())) return *failed;
  return made;
}

result<solution> internal::read_fields(const std::filesystem::path& path, const mesh& m,
                                       const std::vector<vertex_index>& left_out) {
  const std::string file = path.string();
  const bool is_vtu = has_ending(file, ".vtu"), is_bamg = has_ending(file, ".bb");
  const bool is_gmsh = has_ending(file, ".msh") || has_ending(file, ".msh2");
  if (!is_vtu && !is_bamg && !is_gmsh && !has_ending(file, ".sol") && !has_ending(file, ".solb"))
    return error{file + ": a solution is a file whose name ends in .sol, .solb, .bb, .msh or .vtu",
                 error_code::bad_option};
  const auto text = read_medit_text(path);
  if (!text) return text.failure();
  solution made;
  if (is_vtu) {
    auto read = read_vtu_solution(text.value(), file, m, left_out);
    if (!read) return read;
    made = std::move(read).value();
  } else if (is_gmsh) {
    auto read = read_gmsh_solution(text.value(), file);
    if (!read) return read;
    made = std::move(read).value();
    // Accepts a file without fields: a .msh may be another program's mesh.
    if (made.fields.empty()) made.vertices = m.sites.size() + left_out.size();
    if (made.vertices != m.sites.size() + left_out.size())
      return error{fmt::format("{}: values at {} nodes, and the mesh has {}", file, made.vertices,
                               m.sites.size() + left_out.size()),
                   error_code::malformed_file};
  } else {
    text_scanner source(file, text.value());
    values_reader reader(source, m.sites.size() + left_out.size(), made);
    if (auto failed = is_bamg ? reader.read_bamg(has_types(path)) : reader.read_medit())
      return *failed;
  }
  leave_out(made, left_out);
  return made;
}

result<std::vector<nodal_values>> select_values(const solution& from,
                                                const std::vector<std::string>& names) {
  std::vector<nodal_values> found;
  std::vector<char> used(names.size(), 0);
  for (const solution_field& f : from.fields)
    for (std::size_t c = 0; c < components_of(f.kind); ++c) {
      bool wanted = names.empty() && f.kind != field_kind::tensor;
      for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == f.name || names[i] == name_of(f, c)) {
          wanted = true;
          used[i] = 1;
        }
      if (!wanted) continue;
      if (f.kind == field_kind::tensor)
        return error{"field " + quoted_token(f.name) +
                     " is a symmetric tensor, and a scalar or vector is wanted"};
      found.push_back(component_of(f, c, from.vertices));
    }
  for (std::size_t i = 0; i < names.size(); ++i)
    if (used[i] == 0)
      return error{"there is no field " + quoted_token(names[i]) + "; there are " + names_of(from)};
  if (found.empty()) return error{"there is no scalar or vector field"};
  std::sort(found.begin(), found.end(),
            [](const nodal_values& a, const nodal_values& b) { return a.name < b.name; });
  return found;
}

std::string medit_fields_text(const solution& s) {
  std::string contents =
      fmt::format("MeshVersionFormatted 2\n\nDimension 2\n\nSolAtVertices\n{}\n{}", s.vertices,
                  s.fields.size());
  for (const solution_field& f : s.fields) contents += fmt::format(" {}", components_of(f.kind));
  contents += '\n';
  append_values(contents, s);
  return contents + "\nEnd\n";
}

std::string bamg_fields_text(const solution& s) {
  std::size_t scalars = 0;
  for (const solution_field& f : s.fields) scalars += components_of(f.kind);
  std::string contents = fmt::format("2 {} {} 2\n", scalars, s.vertices);
  append_values(contents, s);
  return contents;
}

namespace internal {

result<std::filesystem::path> check_solution_output(const std::filesystem::path& path) {
  if (!has_ending(path.string(), ".sol") && !has_ending(path.string(), ".bb") &&
      !has_ending(path.string(), ".solb"))
    return error{path.string() + ": a solution is written as .sol, .solb or .bb",
                 error_code::bad_option};
  return check_writable(path);
}

std::string solution_text(const std::filesystem::path& path, const solution& s) {
  if (is_medit_binary(path)) return medit_binary_of_text(medit_fields_text(s));
  return has_ending(path.string(), ".bb") ? bamg_fields_text(s) : medit_fields_text(s);
}

}  // namespace internal

result<std::filesystem::path> write_solution(const std::filesystem::path& path, const solution& s) {
  for (const solution_field& f : s.fields)
    if (f.values.size() != s.vertices * components_of(f.kind))
      return error{"field " + quoted_token(f.name) +
                   " has not as many numbers as its vertices take"};
  if (auto place = check_solution_output(path); !place) return place;
  const auto written = write_files({{path, solution_text(path, s)}});
  if (!written) return written.failure();
  return written.value().front();
}

}  // namespace asterism
