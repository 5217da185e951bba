// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/medit_passed_over.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include "asterism/core/number_text.hpp"

namespace asterism::internal {
namespace {

using failure = std::optional<error>;

// Sections that are skipped, with the number of words of a record, in `dimension`
// dimensions.
struct skipped_section {
  std::string_view keyword;
  int words_in_2d, words_in_3d;
};
constexpr std::array<skipped_section, 16> skipped_sections = {{
    {"Ridges", 1, 1},
    {"RequiredTriangles", 1, 1},
    {"Normals", 2, 3},
    {"NormalAtVertices", 2, 2},
    {"NormalAtTriangleVertices", 3, 3},
    {"Tangents", 2, 3},
    {"TangentAtVertices", 2, 2},
    {"TangentAtEdges", 3, 3},
    {"SubDomainFromMesh", 4, 4},
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
bool is_named_among(const std::array<std::string_view, N>& all, std::string_view text) {
  return std::find(all.begin(), all.end(), text) != all.end();
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

word next_keyword(text_scanner& source) {
  word w = source.next();
  while (!w.empty() && !is_letter(w.text.front())) w = source.next();
  return w;
}

// Skips all records, also those longer than their known length: some programs write normals of a
// plane mesh with three numbers.
failure skip_records(text_scanner& source, const word& keyword, int words, passed_over& passed) {
  const auto count = to_count(source, source.next(), keyword.text);
  if (!count.ok()) return count.failure();
  for (std::size_t i = 0; i < count.value() * static_cast<std::size_t>(words); ++i)
    if (const auto value = to_number(source, source.next(), keyword.text); !value.ok())
      return value.failure();
  passed.next = next_keyword(source);
  return {};
}

failure skip_text(text_scanner& source, const word& keyword) {
  const word first = source.next();
  if (first.empty() || first.text.front() != '"')
    return source.failure(first.line, std::string(keyword.text) + ": a text in \" wanted, not " +
                                          quoted_token(first.text));
  word last = first;
  while (last.text.back() != '"' ||
         (last.text.data() == first.text.data() && last.text.size() < 2)) {
    last = source.next();
    if (last.empty())
      return source.failure(first.line, std::string(keyword.text) + ": the text has no end");
  }
  return {};
}

void skip_unknown(text_scanner& source, const word& keyword, passed_over& passed) {
  constexpr std::size_t longest = 200;
  const std::string name = without_controls(std::string(keyword.text.substr(0, 40)));
  if (passed.names.size() < longest)
    passed.names += (passed.names.empty() ? "" : ", ") + name;
  else if (!passed.names.ends_with("..."))
    passed.names += ", ...";
  passed.next = next_keyword(source);
}

}  // namespace

std::optional<error> pass_over(text_scanner& source, const word& keyword, int dimension,
                               passed_over& passed) {
  for (const skipped_section& s : skipped_sections)
    if (keyword.text == s.keyword)
      return skip_records(source, keyword, dimension == 2 ? s.words_in_2d : s.words_in_3d, passed);
  if (is_named_among(texts, keyword.text)) return skip_text(source, keyword);
  if (is_named_among(single_numbers, keyword.text)) {
    const auto value = to_number(source, source.next(), keyword.text);
    if (!value.ok()) return value.failure();
    passed.corner_bound = value.value();
    return {};
  }
  if (!is_letter(keyword.text.front()))
    return source.failure(keyword.line,
                          quoted_token(keyword.text) + " where a section should begin");
  skip_unknown(source, keyword, passed);
  return {};
}

}  // namespace asterism::internal
