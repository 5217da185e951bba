// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/io/bamg_bends.hpp"
#include "asterism/mesh/io/listed_readers.hpp"
#include "asterism/mesh/io/medit.hpp"
#include "asterism/mesh/io/medit_binary.hpp"
#include "asterism/mesh/io/medit_edges.hpp"
#include "asterism/mesh/io/medit_passed_over.hpp"
#include "asterism/mesh/io/medit_solution.hpp"
#include "asterism/mesh/io/plain_lines.hpp"
#include "asterism/mesh/io/text_scanner.hpp"

namespace asterism {
using namespace internal;

namespace {

using failure = std::optional<error>;

// Elements by keyword: the number of corners, which are the first of its vertices, and the number
// of vertices.
struct element_section {
  std::string_view keyword, meaning;
  std::size_t corners, vertices;
};
constexpr std::array<element_section, 10> element_sections = {{
    {"Triangles", "corner of a triangle", 3, 3},
    {"TrianglesP2", "vertex of a triangle", 3, 6},
    {"TrianglesP3", "vertex of a triangle", 3, 10},
    {"TrianglesP4", "vertex of a triangle", 3, 15},
    {"Quadrilaterals", "corner of a quadrilateral", 4, 4},
    {"QuadrilateralsQ2", "vertex of a quadrilateral", 4, 9},
    {"QuadrilateralsQ3", "vertex of a quadrilateral", 4, 16},
    {"Edges", "end of an edge", 2, 2},
    {"EdgesP2", "vertex of an edge", 2, 3},
    {"EdgesP3", "vertex of an edge", 2, 4},
}};
// The least length of a line with three numbers: no more lines than that are made room for.
constexpr std::size_t least_bytes_of_line = 6;
constexpr std::array<std::string_view, 5> solid_sections = {"Tetrahedra", "Hexahedra", "Prisms",
                                                            "Pyramids", "TetrahedraP2"};

class medit_reader {
 public:
  medit_reader(text_scanner& source, listed_mesh& made)
      : source_(source), made_(made), m_(made.content) {}

  // Reads the header, then sections until End or the end of the file.
  failure read_mesh();
  // Puts the mesh in order once its metric has been read. A file of this library is kept as it is.
  failure finish(listed_order how);
  bool lists_triangles() const { return lists_triangles_; }

 private:
  failure read_section(const word& keyword);
  failure read_vertices();
  failure read_elements(const element_section& kind);
  // Read the section where it has a line for each element, and return true; or leave the mesh and
  // the scanner as they were.
  bool read_plain_vertices(std::size_t count);
  bool read_plain_triangles(std::size_t count);
  void add_element(const element_section& kind, const std::array<vertex_index, 4>& corners,
                   int reference, std::size_t line);
  // Appends the vertices that a section lists, Corners or RequiredVertices, to `marked`.
  failure read_marked(std::string_view keyword, std::string_view meaning,
                      std::vector<vertex_index>& marked);
  failure read_required_edges();
  failure read_parts(std::string_view keyword);
  failure refuse_solids(const word& keyword);

  // Reads the count of a section that may occur once.
  result<std::size_t> read_count(std::string_view keyword);
  result<int> read_reference(std::string_view meaning) {
    return made_.wide.read(source_, source_.next(), meaning);
  }
  // Reads a vertex number of the file. Its range is checked after all sections were
  // read.
  result<vertex_index> read_vertex(std::string_view meaning);
  failure check_vertices();
  failure check_required_edges();
  failure check_parts();
  void note_marks();
  bool take_segment_numbers();
  bool take_given_number();

  struct use {
    vertex_index vertex;
    std::size_t line;
    std::string_view meaning;
  };

  text_scanner& source_;
  listed_mesh& made_;
  mesh& m_;
  int dimension_ = 2;
  bool names_segments_ = false, lists_triangles_ = false, has_bamg_curves_ = false;
  std::set<std::string_view> seen_;
  passed_over passed_;
  std::vector<use> uses_;
  struct named_edge {
    std::size_t number;  // from 0
    std::size_t line;
  };
  std::vector<named_edge> required_edges_;
  struct part {
    long long kind, edge;
    bool left;
    int region;
    std::size_t line;
  };
  std::vector<part> parts_;
};

failure medit_reader::read_mesh() {
  std::optional<double> corner_bound;
  const auto dimension = read_medit_header(source_, &corner_bound);
  if (!dimension.ok()) return dimension.failure();
  dimension_ = dimension.value();
  has_bamg_curves_ = corner_bound.has_value();
  passed_.corner_bound = corner_bound.value_or(passed_.corner_bound);
  while (true) {
    const word keyword = passed_.next ? *std::exchange(passed_.next, {}) : source_.next();
    if (keyword.empty() || keyword.text == "End") break;
    if (auto failed = read_section(keyword)) return failed;
  }
  if (seen_.count("Vertices") == 0)
    return source_.failure(source_.line(), "there is no section Vertices");
  if (auto failed = check_vertices()) return failed;
  if (auto failed = check_required_edges()) return failed;
  if (auto failed = check_parts()) return failed;
  note_marks();
  if (has_bamg_curves_ && !lists_triangles_)
    if (auto note = note_of_bamg_bends(m_, made_.marks.corners, passed_.corner_bound))
      m_.notes.push_back(*note);
  if (!passed_.names.empty())
    m_.notes.push_back(source_.file() +
                       ": sections that mean nothing here are passed over: " + passed_.names);
  return {};
}

failure medit_reader::finish(listed_order how) {
  const bool is_own = take_segment_numbers();
  made_.all_edges = made_.all_edges || is_own;
  made_.lists_sides = names_segments_;
  if (auto failed = put_in_order(made_, names_segments_ ? listed_order::as_listed : how))
    return failed;
  if (take_given_number()) return {};
  // Takes required vertices as given if they are the first ones, in order, as this library writes
  // them; other programs require vertices that are not the domain's.
  const std::vector<vertex_index>& required = made_.marks.required_vertices;
  bool in_order = true;
  for (std::size_t i = 0; i < required.size(); ++i) in_order = in_order && required[i] == i;
  m_.given = in_order ? static_cast<vertex_index>(required.size()) : 0;
  return {};
}

failure medit_reader::read_section(const word& keyword) {
  has_bamg_curves_ = has_bamg_curves_ || is_about_bamg_curves(keyword.text);
  if (keyword.text == "Vertices") return read_vertices();
  for (const element_section& kind : element_sections)
    if (keyword.text == kind.keyword) return read_elements(kind);
  if (keyword.text == "RequiredVertices")
    return read_marked(keyword.text, "required vertex", made_.marks.required_vertices);
  if (keyword.text == "Corners") return read_marked(keyword.text, "corner", made_.marks.corners);
  if (keyword.text == "RequiredEdges") return read_required_edges();
  if (keyword.text == "SubDomain" || keyword.text == "SubDomainFromGeom")
    return read_parts(keyword.text);
  if (std::find(solid_sections.begin(), solid_sections.end(), keyword.text) != solid_sections.end())
    return refuse_solids(keyword);
  return pass_over(source_, keyword, dimension_, passed_);
}

failure medit_reader::refuse_solids(const word& keyword) {
  const auto count = to_count(source_, source_.next(), keyword.text);
  if (!count.ok()) return count.failure();
  if (count.value() == 0) return {};
  return source_.failure(keyword.line, std::string(keyword.text) +
                                           ": only meshes of triangles and quadrilaterals in the "
                                           "plane can be read");
}

result<std::size_t> medit_reader::read_count(std::string_view keyword) {
  const word w = source_.next();
  if (!seen_.insert(keyword).second)
    return source_.failure(w.line, "a second section " + std::string(keyword));
  auto count = to_count(source_, w, keyword);
  if (count.ok() && count.value() > std::numeric_limits<vertex_index>::max() / 4)
    return source_.failure(w.line, std::string(keyword) + ": more than 32-bit numbers can name");
  return count;
}

result<vertex_index> medit_reader::read_vertex(std::string_view meaning) {
  const word w = source_.next();
  const auto value = to_integer(source_, w, meaning);
  if (!value.ok()) return value.failure();
  if (value.value() < 1 || value.value() > std::numeric_limits<vertex_index>::max())
    return source_.failure(
        w.line, std::string(meaning) + ": vertex " + quoted_token(w.text) + " does not exist");
  const auto v = static_cast<vertex_index>(value.value() - 1);
  // Notes vertex numbers beyond those read so far, to be checked at the end: sections come in any
  // order.
  if (v >= m_.sites.size()) uses_.push_back({v, w.line, meaning});
  return v;
}

failure medit_reader::read_vertices() {
  const auto count = read_count("Vertices");
  if (!count.ok()) return count.failure();
  if (read_plain_vertices(count.value())) return {};
  m_.sites.reserve(count.value());
  for (std::size_t i = 0; i < count.value(); ++i) {
    const word x = source_.next(), y = source_.next();
    const auto at = to_point(source_, x, y, "a vertex");
    if (!at.ok()) return at.failure();
    if (dimension_ == 3) {
      const word w = source_.next();
      const auto z = to_number(source_, w, "z of a vertex");
      if (!z.ok()) return z.failure();
      if (z.value() != 0)
        made_.heights.push_back({static_cast<vertex_index>(i), w.line, z.value()});
    }
    const auto reference = read_reference("reference of a vertex");
    if (!reference.ok()) return reference.failure();
    m_.sites.push_back({at.value(), {}});
    m_.references.push_back(reference.value());
  }
  return {};
}

bool medit_reader::read_plain_vertices(std::size_t count) {
  if (dimension_ != 2 || count > source_.remaining() / least_bytes_of_line) return false;
  m_.sites.resize(count);
  m_.references.resize(count);
  const auto take = [this](std::size_t v, number_line& line) {
    long long reference = 0;
    point& at = m_.sites[v].position;
    if (!line.take(at.x) || !line.take(at.y) || !line.take(reference)) return false;
    m_.references[v] = static_cast<int>(reference);
    return wide_references::is_plain(reference);
  };
  if (take_plain_lines(source_, count, take)) return true;
  m_.sites.clear();
  m_.references.clear();
  return false;
}

bool medit_reader::read_plain_triangles(std::size_t count) {
  if (count > source_.remaining() / least_bytes_of_line) return false;
  const std::size_t before = m_.triangles.size();
  m_.triangles.resize(before + count);
  m_.regions.resize(before + count);
  const auto take = [this, before](std::size_t t, number_line& line) {
    for (vertex_index& corner : m_.triangles[before + t]) {
      long long v = 0;
      if (!line.take(v) || v < 1 || static_cast<unsigned long long>(v) > m_.sites.size())
        return false;
      corner = static_cast<vertex_index>(v - 1);
    }
    long long reference = 0;
    if (!line.take(reference)) return false;
    m_.regions[before + t] = static_cast<int>(reference);
    return wide_references::is_plain(reference);
  };
  if (take_plain_lines(source_, count, take)) return true;
  m_.triangles.resize(before);
  m_.regions.resize(before);
  return false;
}

failure medit_reader::read_elements(const element_section& kind) {
  const auto count = read_count(kind.keyword);
  if (!count.ok()) return count.failure();
  if (kind.corners == 3) m_.triangles.reserve(m_.triangles.size() + count.value());
  if (kind.corners == 2) m_.boundary.reserve(m_.boundary.size() + count.value());
  if (kind.vertices > kind.corners) made_.second_order += count.value();
  lists_triangles_ = lists_triangles_ || kind.corners > 2;
  if (kind.vertices == 3 && kind.corners == 3 && read_plain_triangles(count.value())) return {};
  const std::string reference_of =
      kind.corners == 2 ? "reference of an edge"
                        : (kind.corners == 3 ? "reference of a triangle" : "reference of a cell");
  for (std::size_t i = 0; i < count.value(); ++i) {
    std::array<vertex_index, 4> corners{};
    for (std::size_t k = 0; k < kind.vertices; ++k) {
      const auto v = read_vertex(kind.meaning);
      if (!v.ok()) return v.failure();
      if (k < kind.corners) corners[k] = v.value();
    }
    const auto reference = read_reference(reference_of);
    if (!reference.ok()) return reference.failure();
    add_element(kind, corners, reference.value(), source_.line());
  }
  return {};
}

void medit_reader::add_element(const element_section& kind,
                               const std::array<vertex_index, 4>& corners, int reference,
                               std::size_t line) {
  if (kind.corners == 2)
    m_.boundary.push_back(
        {corners[0], corners[1], static_cast<vertex_index>(m_.boundary.size()), reference});
  if (kind.corners == 4) made_.quadrilaterals.push_back({corners, reference, line});
  if (kind.corners != 3) return;
  m_.triangles.push_back({corners[0], corners[1], corners[2]});
  m_.regions.push_back(reference);
}

failure medit_reader::read_marked(std::string_view keyword, std::string_view meaning,
                                  std::vector<vertex_index>& marked) {
  const auto count = read_count(keyword);
  if (!count.ok()) return count.failure();
  for (std::size_t i = 0; i < count.value(); ++i) {
    const auto v = read_vertex(meaning);
    if (!v.ok()) return v.failure();
    marked.push_back(v.value());
  }
  return {};
}

failure medit_reader::read_required_edges() {
  const auto count = read_count("RequiredEdges");
  if (!count.ok()) return count.failure();
  for (std::size_t i = 0; i < count.value(); ++i) {
    const word w = source_.next();
    const auto number = to_integer(source_, w, "required edge");
    if (!number.ok()) return number.failure();
    if (number.value() < 1)
      return source_.failure(w.line,
                             "required edge: edge " + quoted_token(w.text) + " does not exist");
    required_edges_.push_back({static_cast<std::size_t>(number.value() - 1), w.line});
  }
  return {};
}

// Reads parts of a geometry, each as the number 2, an edge, one of its sides, and the part's
// number. They are used only if there are no triangles.
failure medit_reader::read_parts(std::string_view keyword) {
  const auto count = read_count(keyword);
  if (!count.ok()) return count.failure();
  for (std::size_t i = 0; i < count.value(); ++i) {
    long long numbers[3] = {};
    const std::size_t line = source_.line();
    for (long long& number : numbers) {
      const auto value = to_integer(source_, source_.next(), keyword);
      if (!value.ok()) return value.failure();
      number = value.value();
    }
    const auto region = read_reference(keyword);
    if (!region.ok()) return region.failure();
    parts_.push_back({numbers[0], numbers[1], numbers[2] > 0, region.value(), line});
  }
  return {};
}

// Takes the parts of the domain, each given by an edge beside it, if the file lists edges alone.
failure medit_reader::check_parts() {
  if (lists_triangles_) return {};
  for (const part& p : parts_) {
    if (p.kind != 2 || p.edge < 1 || p.edge > static_cast<long long>(m_.boundary.size()))
      return source_.failure(p.line,
                             "a sub-domain is given by 2 and an edge that exists, its side "
                             "and a number");
    made_.parts.push_back({static_cast<std::size_t>(p.edge - 1), p.left, p.region});
  }
  return {};
}

// Records edges by their ends while they are numbered as in the file.
void medit_reader::note_marks() {
  for (const named_edge& e : required_edges_) {
    made_.required_edges.push_back(e.number);
    made_.marks.required_edges.push_back({m_.boundary[e.number].a, m_.boundary[e.number].b});
  }
}

failure medit_reader::check_required_edges() {
  for (const named_edge& e : required_edges_)
    if (e.number >= m_.boundary.size())
      return source_.failure(e.line, "required edge: edge " + std::to_string(e.number + 1) +
                                         " does not exist; there are " +
                                         std::to_string(m_.boundary.size()));
  return {};
}

failure medit_reader::check_vertices() {
  for (const use& u : uses_)
    if (u.vertex >= m_.sites.size())
      return source_.failure(
          u.line, std::string(u.meaning) + ": vertex " + std::to_string(std::size_t{u.vertex} + 1) +
                      " does not exist; there are " + std::to_string(m_.sites.size()));
  return {};
}

// Takes the segment numbers in comments if there is one for every edge, each at least 1. Returns
// whether that holds.
bool medit_reader::take_segment_numbers() {
  constexpr std::string_view mark = "segments";
  std::vector<vertex_index> numbers;
  for (const std::string_view comment : source_.comments()) {
    if (!comment.starts_with(mark)) continue;
    names_segments_ = true;
    text_scanner words("", comment.substr(mark.size()));
    for (word w = words.next(); !w.empty(); w = words.next()) {
      const auto number = to_integer(words, w, "");
      if (!number.ok() || number.value() < 1 ||
          number.value() > std::numeric_limits<vertex_index>::max())
        return false;
      numbers.push_back(static_cast<vertex_index>(number.value() - 1));
    }
  }
  if (numbers.size() != m_.boundary.size()) return false;
  for (std::size_t i = 0; i < numbers.size(); ++i) m_.boundary[i].segment = numbers[i];
  return true;
}

// Takes the number of given vertices from a comment, if there is one and it is valid: the given
// vertices include the required ones.
bool medit_reader::take_given_number() {
  constexpr std::string_view mark = "given ";
  for (const std::string_view comment : source_.comments()) {
    if (!comment.starts_with(mark)) continue;
    text_scanner words("", comment.substr(mark.size()));
    const word w = words.next();
    const auto number = to_integer(words, w, "");
    if (!number.ok() || number.value() < 0 ||
        static_cast<std::uint64_t>(number.value()) > m_.sites.size())
      return false;
    const auto given = static_cast<vertex_index>(number.value());
    const auto& required = made_.marks.required_vertices;
    if (std::any_of(required.begin(), required.end(),
                    [given](vertex_index v) { return v >= given; }))
      return false;
    m_.given = given;
    return true;
  }
  return false;
}

failure read_metric_beside(const std::filesystem::path& path, listed_mesh& m,
                           const medit_read_options& options) {
  std::filesystem::path beside = solution_path(path);
  std::error_code ignored;
  if (is_medit_binary(path) && !std::filesystem::exists(beside, ignored))
    beside.replace_extension(".sol");
  const auto& file = options.solution.empty() ? beside : options.solution;
  const auto read = read_medit_solution(file, m.content, options);
  if (!read) return read.failure();
  m.has_metric = read.value();
  return {};
}

bool lists_edges_alone(const listed_mesh& m) {
  return m.content.triangles.empty() && m.quadrilaterals.empty() && !m.content.boundary.empty();
}

// Reads a mesh with its metric, whose rows are those of the vertices as listed.
result<listed_mesh> read_listed(const std::filesystem::path& path,
                                const medit_read_options& options, listed_order how) {
  const auto text = read_medit_text(path);
  if (!text.ok()) return text.failure();
  text_scanner source(path.string(), text.value());
  listed_mesh made;
  made.file = path.string();
  made.all_edges = options.all_edges;
  medit_reader reader(source, made);
  if (auto failed = reader.read_mesh()) return std::move(*failed);
  if (how == listed_order::as_listed && !reader.lists_triangles())
    return source.failure(source.line(), "there is no section Triangles");
  // Reads no metric for edges alone, which are a domain.
  medit_read_options metric = options;
  metric.without_solution = options.without_solution || lists_edges_alone(made);
  if (auto failed = read_metric_beside(path, made, metric)) return std::move(*failed);
  if (auto failed = reader.finish(how)) return std::move(*failed);
  return made;
}

}  // namespace

namespace internal {

result<listed_mesh> read_listed_medit(const std::filesystem::path& path,
                                      const medit_read_options& options) {
  return read_listed(path, options, listed_order::put_right);
}

}  // namespace internal

result<mesh> read_medit(const std::filesystem::path& path, const medit_read_options& options) {
  auto read = read_listed(path, options, listed_order::as_listed);
  if (!read) return read.failure();
  return std::move(read.value().content);
}

result<mesh_marks> read_medit_marks(const std::filesystem::path& path) {
  medit_read_options options;
  options.without_solution = true;
  auto read = read_listed(path, options, listed_order::as_listed);
  if (!read) return read.failure();
  return std::move(read.value().marks);
}

}  // namespace asterism
