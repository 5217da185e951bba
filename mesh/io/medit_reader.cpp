// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/io/medit.hpp"
#include "asterism/mesh/io/medit_binary.hpp"
#include "asterism/mesh/io/medit_edges.hpp"
#include "asterism/mesh/io/medit_solution.hpp"
#include "asterism/mesh/io/text_scanner.hpp"

namespace asterism {
using namespace internal;

namespace {

using failure = std::optional<error>;

// Sections that mean nothing here: how many words a record of theirs has, in `dimension`
// dimensions.
struct skipped_section {
  std::string_view keyword;
  int words_in_2d, words_in_3d;
};
constexpr std::array<skipped_section, 18> skipped_sections = {{
    {"Ridges", 1, 1},
    {"RequiredTriangles", 1, 1},
    {"Normals", 2, 3},
    {"NormalAtVertices", 2, 2},
    {"NormalAtTriangleVertices", 3, 3},
    {"Tangents", 2, 3},
    {"TangentAtVertices", 2, 2},
    {"TangentAtEdges", 3, 3},
    {"SubDomainFromMesh", 4, 4},
    {"SubDomain", 4, 4},
    {"SubDomainFromGeom", 4, 4},
    {"CrackedEdges", 2, 2},
    {"VertexOnGeometricVertex", 2, 2},
    {"VertexOnGeometricEdge", 3, 3},
    {"EdgeOnGeometricEdge", 2, 2},
    {"VertexOnSupportVertex", 2, 2},
    {"VertexOnSupportEdge", 3, 3},
    {"VertexOnSupportTriangle", 4, 4},
}};

// Keywords of BAMG's that hold one text in quotation marks, or one number and no count.
constexpr std::array<std::string_view, 4> texts = {
    "Identifier", "Geometry", "MeshSupportOfVertices", "IdentityOfMeshSupport"};
constexpr std::array<std::string_view, 2> single_numbers = {"MaximalAngleOfCorner",
                                                            "AngleOfCornerBound"};

template <std::size_t N>
bool is_among(const std::array<std::string_view, N>& all, std::string_view text) {
  return std::find(all.begin(), all.end(), text) != all.end();
}

class medit_reader {
 public:
  medit_reader(text_scanner& source, mesh& m, bool all_edges)
      : source_(source), m_(m), all_edges_(all_edges) {}

  // Reads the header, then sections until End or the end of the file.
  failure read_mesh();
  const mesh_marks& marks() const { return marks_; }

 private:
  failure read_section(const word& keyword);
  failure read_vertices();
  failure read_triangles();
  failure read_edges();
  failure read_required();
  failure read_corners();
  failure read_required_edges();
  failure skip(const word& keyword, int words);
  failure skip_text(const word& keyword);

  // Reads the count of a section that may occur once.
  result<std::size_t> read_count(std::string_view keyword, bool& seen);
  result<double> read_number(std::string_view meaning) {
    return to_number(source_, source_.next(), meaning);
  }
  result<int> read_reference(std::string_view meaning) {
    return to_marker(source_, source_.next(), meaning);
  }
  // Reads a vertex number of the file. Whether it exists is known when all sections have been
  // read.
  result<vertex_index> read_vertex(std::string_view meaning);
  failure check_vertices();
  failure check_required_edges();
  void note_marks();
  bool take_segment_numbers();
  bool take_given_number();
  void find_segments(bool is_own);

  struct use {
    vertex_index vertex;
    std::size_t line;
    std::string_view meaning;
  };

  text_scanner& source_;
  mesh& m_;
  int dimension_ = 2;
  bool all_edges_;
  bool vertices_seen_ = false, triangles_seen_ = false, edges_seen_ = false, required_seen_ = false,
       corners_seen_ = false, required_edges_seen_ = false, names_segments_ = false;
  std::vector<use> uses_;
  std::vector<vertex_index> required_;
  struct named_edge {
    std::size_t number;  // from 0
    std::size_t line;
  };
  std::vector<named_edge> required_edges_;
  mesh_marks marks_;
};

failure medit_reader::read_mesh() {
  const auto dimension = read_medit_header(source_);
  if (!dimension.ok()) return dimension.failure();
  dimension_ = dimension.value();
  while (true) {
    const word keyword = source_.next();
    if (keyword.empty() || keyword.text == "End") break;
    if (auto failed = read_section(keyword)) return failed;
  }
  if (!vertices_seen_) return source_.failure(source_.line(), "there is no section Vertices");
  if (!triangles_seen_) return source_.failure(source_.line(), "there is no section Triangles");
  if (auto failed = check_vertices()) return failed;
  if (auto failed = check_required_edges()) return failed;
  note_marks();
  find_segments(take_segment_numbers());
  if (m_.references == vertex_references(m_)) m_.references.clear();
  if (std::all_of(m_.regions.begin(), m_.regions.end(), [](int region) { return region == 1; }))
    m_.regions.clear();
  if (take_given_number()) return {};
  // Ours are the first ones, in order; what other programs require are no vertices of a domain
  // here.
  bool in_order = true;
  for (std::size_t i = 0; i < required_.size(); ++i) in_order = in_order && required_[i] == i;
  m_.given = in_order ? static_cast<vertex_index>(required_.size()) : 0;
  return {};
}

failure medit_reader::read_section(const word& keyword) {
  if (keyword.text == "Vertices") return read_vertices();
  if (keyword.text == "Triangles") return read_triangles();
  if (keyword.text == "Edges") return read_edges();
  if (keyword.text == "RequiredVertices") return read_required();
  if (keyword.text == "Corners") return read_corners();
  if (keyword.text == "RequiredEdges") return read_required_edges();
  for (const skipped_section& s : skipped_sections)
    if (keyword.text == s.keyword)
      return skip(keyword, dimension_ == 2 ? s.words_in_2d : s.words_in_3d);
  if (is_among(texts, keyword.text)) return skip_text(keyword);
  if (is_among(single_numbers, keyword.text)) {
    const auto value = read_number(keyword.text);
    return value.ok() ? failure{} : value.failure();
  }
  if (keyword.text == "Quadrilaterals" || keyword.text == "Tetrahedra" ||
      keyword.text == "Hexahedra" || keyword.text == "Prisms" || keyword.text == "Pyramids") {
    const auto count = to_count(source_, source_.next(), keyword.text);
    if (!count.ok()) return count.failure();
    if (count.value() == 0) return {};
    return source_.failure(keyword.line,
                           std::string(keyword.text) + ": only triangles can be read");
  }
  return source_.failure(keyword.line, quoted_token(keyword.text) + " is no known section");
}

result<std::size_t> medit_reader::read_count(std::string_view keyword, bool& seen) {
  const word w = source_.next();
  if (seen) return source_.failure(w.line, "a second section " + std::string(keyword));
  seen = true;
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
  // Sections come in any order; what lies beyond the vertices read so far is checked at the end.
  if (v >= m_.sites.size()) uses_.push_back({v, w.line, meaning});
  return v;
}

failure medit_reader::read_vertices() {
  const auto count = read_count("Vertices", vertices_seen_);
  if (!count.ok()) return count.failure();
  m_.sites.reserve(count.value());
  for (std::size_t i = 0; i < count.value(); ++i) {
    const auto x = read_number("x of a vertex");
    if (!x.ok()) return x.failure();
    const auto y = read_number("y of a vertex");
    if (!y.ok()) return y.failure();
    if (dimension_ == 3) {
      const word w = source_.next();
      const auto z = to_number(source_, w, "z of a vertex");
      if (!z.ok()) return z.failure();
      if (z.value() != 0)
        return source_.failure(w.line, "z of a vertex: " + quoted_token(w.text) +
                                           " is not 0: only plane meshes can be read");
    }
    const auto reference = read_reference("reference of a vertex");
    if (!reference.ok()) return reference.failure();
    m_.sites.push_back({{x.value(), y.value()}, {}});
    m_.references.push_back(reference.value());
  }
  return {};
}

failure medit_reader::read_triangles() {
  const auto count = read_count("Triangles", triangles_seen_);
  if (!count.ok()) return count.failure();
  m_.triangles.reserve(count.value());
  for (std::size_t i = 0; i < count.value(); ++i) {
    triangle t{};
    for (vertex_index& corner : t) {
      const auto v = read_vertex("corner of a triangle");
      if (!v.ok()) return v.failure();
      corner = v.value();
    }
    const auto reference = read_reference("reference of a triangle");
    if (!reference.ok()) return reference.failure();
    m_.triangles.push_back(t);
    m_.regions.push_back(reference.value());
  }
  return {};
}

failure medit_reader::read_edges() {
  const auto count = read_count("Edges", edges_seen_);
  if (!count.ok()) return count.failure();
  m_.boundary.reserve(count.value());
  for (std::size_t i = 0; i < count.value(); ++i) {
    const auto a = read_vertex("end of an edge");
    if (!a.ok()) return a.failure();
    const auto b = read_vertex("end of an edge");
    if (!b.ok()) return b.failure();
    const auto marker = read_reference("reference of an edge");
    if (!marker.ok()) return marker.failure();
    m_.boundary.push_back({a.value(), b.value(), static_cast<vertex_index>(i), marker.value()});
  }
  return {};
}

failure medit_reader::read_required() {
  const auto count = read_count("RequiredVertices", required_seen_);
  if (!count.ok()) return count.failure();
  for (std::size_t i = 0; i < count.value(); ++i) {
    const auto v = read_vertex("required vertex");
    if (!v.ok()) return v.failure();
    required_.push_back(v.value());
  }
  return {};
}

// Reads corners as they have to be, and does not use them.
failure medit_reader::read_corners() {
  const auto count = read_count("Corners", corners_seen_);
  if (!count.ok()) return count.failure();
  for (std::size_t i = 0; i < count.value(); ++i) {
    const auto v = read_vertex("corner");
    if (!v.ok()) return v.failure();
    marks_.corners.push_back(v.value());
  }
  return {};
}

failure medit_reader::read_required_edges() {
  const auto count = read_count("RequiredEdges", required_edges_seen_);
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

failure medit_reader::skip(const word& keyword, int words) {
  const auto count = to_count(source_, source_.next(), keyword.text);
  if (!count.ok()) return count.failure();
  for (std::size_t i = 0; i < count.value() * static_cast<std::size_t>(words); ++i)
    if (const auto value = read_number(keyword.text); !value.ok()) return value.failure();
  return {};
}

failure medit_reader::skip_text(const word& keyword) {
  const word first = source_.next();
  if (first.empty() || first.text.front() != '"')
    return source_.failure(first.line, std::string(keyword.text) + ": a text in \" wanted, not " +
                                           quoted_token(first.text));
  word last = first;
  while (last.text.back() != '"' ||
         (last.text.data() == first.text.data() && last.text.size() < 2)) {
    last = source_.next();
    if (last.empty())
      return source_.failure(first.line, std::string(keyword.text) + ": the text has no end");
  }
  return {};
}

// Notes edges by their ends while they are numbered as in the file.
void medit_reader::note_marks() {
  marks_.required_vertices = required_;
  for (const named_edge& e : required_edges_)
    marks_.required_edges.push_back({m_.boundary[e.number].a, m_.boundary[e.number].b});
}

// Decides which edges are segments. A file of ours lists subsegments alone.
void medit_reader::find_segments(bool is_own) {
  edge_marks marks{std::vector<char>(m_.boundary.size(), 0), all_edges_ || is_own};
  for (const named_edge& e : required_edges_) marks.required[e.number] = 1;
  keep_segments(m_, marks);
  // Not for our own files, which list all: a side missing there was taken away.
  if (!names_segments_) list_sides(m_);
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

// Comments are only believed when they fit: one number from 1 for every edge. Returns whether they
// are there and do.
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

// Takes the number of given vertices from a comment, if it is there and fits: no fewer than those
// required, and these among them.
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
    if (std::any_of(required_.begin(), required_.end(),
                    [given](vertex_index v) { return v >= given; }))
      return false;
    m_.given = given;
    return true;
  }
  return false;
}

}  // namespace

result<mesh> read_medit(const std::filesystem::path& path, const medit_read_options& options) {
  const auto text = read_medit_text(path);
  if (!text.ok()) return text.failure();
  text_scanner source(path.string(), text.value());
  mesh m;
  if (auto failed = medit_reader(source, m, options.all_edges).read_mesh())
    return std::move(*failed);
  std::filesystem::path beside = solution_path(path);
  std::error_code ignored;
  if (is_medit_binary(path) && !std::filesystem::exists(beside, ignored))
    beside.replace_extension(".sol");
  const auto& solution = options.solution.empty() ? beside : options.solution;
  if (auto failed = read_medit_solution(solution, m, options)) return std::move(*failed);
  return m;
}

result<mesh_marks> read_medit_marks(const std::filesystem::path& path) {
  const auto text = read_medit_text(path);
  if (!text.ok()) return text.failure();
  text_scanner source(path.string(), text.value());
  mesh m;
  medit_reader reader(source, m, false);
  if (auto failed = reader.read_mesh()) return std::move(*failed);
  return reader.marks();
}

}  // namespace asterism
