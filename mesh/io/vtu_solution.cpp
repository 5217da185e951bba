// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/vtu_solution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/data/site_box.hpp"
#include "asterism/mesh/io/vtu_file.hpp"

namespace asterism::internal {
namespace {

using failure = std::optional<error>;

// Compares points to single precision, in which the file may have been written.
failure check_points(vtu_file& from, const mesh& m, const std::vector<vertex_index>& left_out) {
  const vtu_array* const points = from.find("Points");
  if (points == nullptr) return {};
  const auto width = from.components(*points);
  if (!width) return width.failure();
  if (width.value() < 2) return from.failure(points->tag.line, "points have no y");
  const auto found = from.numbers(*points, width.value() * from.points());
  if (!found) return found.failure();
  const bounding_box box = box_of_sites(m.sites);
  const double most = std::max(
      {std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
  auto skipped = left_out.begin();
  std::size_t next = 0;
  for (std::size_t v = 0; v < from.points(); ++v) {
    if (skipped != left_out.end() && *skipped == v) {
      ++skipped;
      continue;
    }
    const double x = found.value()[v * width.value()], y = found.value()[v * width.value() + 1];
    const point& p = m.sites[next++].position;
    if (std::abs(x - p.x) <= 1e-6 * most && std::abs(y - p.y) <= 1e-6 * most) continue;
    return from.failure(points->tag.line,
                        fmt::format("point {} is at ({:g}, {:g}), and the mesh's vertex at "
                                    "({:g}, {:g})",
                                    v + 1, x, y, p.x, p.y));
  }
  return {};
}

// Adds a symmetric tensor of the plane, given as nine entries by rows. Skips other tensors, and the
// metric.
failure add_tensor(vtu_file& from, const vtu_array& a, solution& made) {
  constexpr std::size_t width = 9;
  const auto found = from.numbers(a, width * made.vertices);
  if (!found) return found.failure();
  solution_field field{std::string(a.tag["Name"]), field_kind::tensor, {}};
  if (field.name == "metric") return {};
  field.values.reserve(3 * made.vertices);
  for (std::size_t v = 0; v < made.vertices; ++v) {
    const double* const x = found.value().data() + v * width;
    for (std::size_t i = 0; i < width; ++i)
      if (!std::isfinite(x[i]))
        return from.failure(a.tag.line, fmt::format("array {}, vertex {}: a number is not finite",
                                                    quoted_token(field.name), v + 1));
    if (x[1] != x[3] || x[2] != 0 || x[5] != 0 || x[6] != 0 || x[7] != 0) return {};
    field.values.insert(field.values.end(), {x[0], x[1], x[4]});
  }
  made.fields.push_back(std::move(field));
  return {};
}

// Skips integers, and vectors out of the plane: they are no fields of a solution.
failure add_field(vtu_file& from, const vtu_array& a, solution& made) {
  if (!a.tag["type"].starts_with("Float")) return {};
  const auto width = from.components(a);
  if (!width) return width.failure();
  if (width.value() == 9) return add_tensor(from, a, made);
  if (width.value() > 3) return {};
  const auto found = from.numbers(a, width.value() * made.vertices);
  if (!found) return found.failure();
  solution_field field{
      std::string(a.tag["Name"]), width.value() == 1 ? field_kind::scalar : field_kind::vector, {}};
  const std::size_t kept = components_of(field.kind);
  field.values.reserve(kept * made.vertices);
  for (std::size_t v = 0; v < made.vertices; ++v)
    for (std::size_t i = 0; i < width.value(); ++i) {
      const double x = found.value()[v * width.value() + i];
      if (!std::isfinite(x))
        return from.failure(a.tag.line, fmt::format("array {}, vertex {}: a number is not finite",
                                                    quoted_token(field.name), v + 1));
      if (i < kept)
        field.values.push_back(x);
      else if (x != 0)
        return {};
    }
  made.fields.push_back(std::move(field));
  return {};
}

}  // namespace

result<solution> read_vtu_solution(std::string_view text, const std::string& file, const mesh& m,
                                   const std::vector<vertex_index>& left_out) {
  auto opened = vtu_file::open(text, file);
  if (!opened) return opened.failure();
  vtu_file& from = opened.value();
  const std::size_t listed = m.sites.size() + left_out.size();
  if (from.points() != listed)
    return from.failure(
        from.piece_line(),
        fmt::format("values at {} points, and the mesh has {} vertices", from.points(), listed));
  if (auto failed = check_points(from, m, left_out)) return *failed;
  solution made;
  made.vertices = from.points();
  for (const vtu_array& a : from.arrays())
    if (a.section == "PointData")
      if (auto failed = add_field(from, a, made)) return *failed;
  return made;
}

}  // namespace asterism::internal
