// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/vtu_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/core/number_text.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/io/vtk_cells.hpp"
#include "asterism/mesh/io/vtu_file.hpp"
#include "asterism/mesh/support/tensor_text.hpp"

namespace asterism::internal {
namespace {

using failure = std::optional<error>;
using numbers = std::vector<double>;

bool holds_integers(const vtu_array& a) {
  return a.tag["type"].starts_with("Int") || a.tag["type"].starts_with("UInt");
}

class vtu_mesh_reader {
 public:
  vtu_mesh_reader(vtu_file& from, const std::string& file) : from_(from), cells_(made_) {
    made_.file = file;
  }

  failure read();
  listed_mesh take() { return std::move(made_); }

 private:
  failure read_points();
  failure read_cells();
  failure choose_regions();
  failure read_regions();
  failure read_disagreeing();
  failure read_boundary();
  failure read_metric();
  failure read_given();
  result<numbers> whole_numbers(const vtu_array& a, std::size_t count, double least, double most);
  result<vertex_index> vertex(double number, const vtu_array& a) const;
  error refuse(const vtu_array& a, const std::string& what) const {
    return from_.failure(a.tag.line, "array " + quoted_token(a.name()) + ": " + what);
  }

  vtu_file& from_;
  listed_mesh made_;
  vtk_cells cells_;
  const vtu_array *connectivity_ = nullptr, *types_ = nullptr, *regions_ = nullptr;
};

failure vtu_mesh_reader::read_points() {
  const vtu_array* const points = from_.find("Points");
  if (points == nullptr) return from_.failure(from_.piece_line(), "there is no array of Points");
  const auto width = from_.components(*points);
  if (!width) return width.failure();
  if (width.value() < 2) return refuse(*points, "points have no y");
  const std::size_t w = width.value();
  const auto found = from_.numbers(*points, w * from_.points());
  if (!found) return found.failure();
  for (std::size_t v = 0; v < from_.points(); ++v) {
    const double* const p = &found.value()[v * w];
    for (std::size_t i = 0; i < w; ++i)
      if (!std::isfinite(p[i]))
        return refuse(*points, fmt::format("point {}: a coordinate is not finite", v + 1));
    if (w > 2 && p[2] != 0)
      made_.heights.push_back({static_cast<vertex_index>(v), points->tag.line, p[2]});
    made_.content.sites.push_back({{p[0], p[1]}, {1, 0, 1}});
  }
  return {};
}

result<numbers> vtu_mesh_reader::whole_numbers(const vtu_array& a, std::size_t count, double least,
                                               double most) {
  auto found = from_.numbers(a, count);
  if (!found) return found;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = found.value()[i];
    if (!(x >= least && x <= most) || x != std::floor(x))
      return refuse(a, fmt::format("number {} is {:g}, and a whole number from {:.0f} to {:.0f} is "
                                   "wanted",
                                   i + 1, x, least, most));
  }
  return found;
}

result<vertex_index> vtu_mesh_reader::vertex(double number, const vtu_array& a) const {
  if (number >= 0 && number < static_cast<double>(from_.points()))
    return static_cast<vertex_index>(number);
  return refuse(
      a, fmt::format("point {:.0f}, from 0, does not exist; there are {}", number, from_.points()));
}

failure vtu_mesh_reader::read_cells() {
  const vtu_array* offsets_of = nullptr;
  for (const auto& [name, array] : {std::pair{"connectivity", &connectivity_},
                                    std::pair{"offsets", &offsets_of}, std::pair{"types", &types_}})
    if ((*array = from_.find("Cells", name)) == nullptr)
      return from_.failure(from_.piece_line(),
                           "there is no array " + quoted_token(name) + " of Cells");
  constexpr double largest = 1e15;  // all whole numbers up to it are doubles
  const auto offsets = whole_numbers(*offsets_of, from_.cells(), 0, largest);
  if (!offsets) return offsets.failure();
  const auto types = whole_numbers(*types_, from_.cells(), 0, 255);
  if (!types) return types.failure();
  const numbers& ends = offsets.value();
  if (!std::is_sorted(ends.begin(), ends.end()))
    return refuse(*offsets_of, "the numbers do not ascend");
  const std::size_t all = ends.empty() ? 0 : static_cast<std::size_t>(ends.back());
  const auto corners = whole_numbers(*connectivity_, all, 0, largest);
  if (!corners) return corners.failure();
  std::size_t begin = 0;
  for (std::size_t cell = 0; cell < from_.cells(); ++cell) {
    const auto end = static_cast<std::size_t>(ends[cell]);
    const vtk_cell next{static_cast<int>(types.value()[cell]), cell, types_->tag.line,
                        corners.value().data() + begin, end - begin};
    if (auto failed = cells_.add(next)) return failed;
    begin = end;
  }
  return {};
}

// Chooses the array of cell data that numbers the regions, as vtk_cells.hpp
// describes.
failure vtu_mesh_reader::choose_regions() {
  std::vector<const vtu_array*> arrays;
  std::vector<vtk_candidate> candidates;
  for (const vtu_array& a : from_.arrays())
    if (a.section == "CellData") {
      arrays.push_back(&a);
      candidates.push_back({a.name(), holds_integers(a), a.tag.line});
    }
  const auto chosen = choose_region_array(candidates, made_);
  if (!chosen) return chosen.failure();
  if (chosen.value()) regions_ = arrays[*chosen.value()];
  return {};
}

failure vtu_mesh_reader::read_regions() {
  if (auto failed = choose_regions()) return failed;
  if (regions_ == nullptr) return {};
  const auto width = from_.components(*regions_);
  if (!width) return width.failure();
  if (width.value() != 1) return refuse(*regions_, "one number for each cell is wanted");
  constexpr double most = 1e15;  // all whole numbers up to it are doubles
  const auto found = whole_numbers(*regions_, from_.cells(), -most, most);
  if (!found) return found.failure();
  cells_.set_numbers(found.value());
  return {};
}

// Removes the cells that an incomplete run wrote in addition to its triangles.
failure vtu_mesh_reader::read_disagreeing() {
  const vtu_array* const a = from_.find("CellData", "disagreeing");
  if (a == nullptr) return {};
  const auto found = whole_numbers(*a, from_.cells(), 0, 1);
  if (!found) return found.failure();
  mesh& m = made_.content;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < cells_.triangles().size(); ++i) {
    if (found.value()[cells_.triangles()[i]] != 0) {
      m.disagreeing.push_back(m.triangles[i]);
      continue;
    }
    m.triangles[kept] = m.triangles[i];
    if (!m.regions.empty()) m.regions[kept] = m.regions[i];
    ++kept;
  }
  m.triangles.resize(kept);
  if (!m.regions.empty()) m.regions.resize(kept);
  return {};
}

// Reads the subsegments of a file of this library: two points, the marker, and the segment from 0.
failure vtu_mesh_reader::read_boundary() {
  const vtu_array* const a = from_.find("FieldData", "boundary");
  if (a == nullptr || a->tag["NumberOfComponents"] != "4" || !holds_integers(*a)) return {};
  std::size_t count = 0;
  for (const char digit : a->tag["NumberOfTuples"]) {
    if (digit < '0' || digit > '9' || count > 1'000'000'000'000)
      return refuse(*a, "NumberOfTuples is no count");
    count = 10 * count + static_cast<std::size_t>(digit - '0');
  }
  constexpr double least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
  const auto found = whole_numbers(*a, 4 * count, least, most);
  if (!found) return found.failure();
  mesh& m = made_.content;
  m.boundary.clear();
  for (std::size_t i = 0; i < count; ++i) {
    const double* const e = &found.value()[4 * i];
    const auto from = vertex(e[0], *a), to = vertex(e[1], *a);
    if (!from) return from.failure();
    if (!to) return to.failure();
    if (e[3] < 0) return refuse(*a, fmt::format("the segment {:.0f} does not exist", e[3]));
    m.boundary.push_back({from.value(), to.value(), static_cast<vertex_index>(e[3]),
                          made_.wide.number(static_cast<long long>(e[2])), false});
  }
  return {};
}

failure vtu_mesh_reader::read_metric() {
  const vtu_array* const a = from_.find("PointData", "metric");
  if (a == nullptr || a->tag["NumberOfComponents"] != "3") return {};
  const auto found = from_.numbers(*a, 3 * from_.points());
  if (!found) return found.failure();
  const filtered_kernel kernel;
  for (std::size_t v = 0; v < from_.points(); ++v) {
    const double* const t = &found.value()[3 * v];
    const metric_tensor m{t[0], t[1], t[2]};
    if (!std::isfinite(t[0]) || !std::isfinite(t[1]) || !std::isfinite(t[2]) ||
        !kernel.is_positive_definite(m))
      return refuse(*a, fmt::format("the tensor {} of point {} is not positive definite",
                                    tensor_text(m), v + 1));
    made_.content.sites[v].metric = m;
  }
  made_.has_metric = true;
  return {};
}

// Counts the vertices of the domain, if they are the first ones of the mesh.
failure vtu_mesh_reader::read_given() {
  const vtu_array* const a = from_.find("PointData", "given");
  if (a == nullptr || !holds_integers(*a)) return {};
  const auto found = from_.numbers(*a, from_.points());
  if (!found) return found.failure();
  const numbers& flags = found.value();
  const auto first_other = std::find(flags.begin(), flags.end(), 0.0);
  if (std::all_of(first_other, flags.end(), [](double flag) { return flag == 0; }))
    made_.content.given = static_cast<vertex_index>(first_other - flags.begin());
  return {};
}

failure vtu_mesh_reader::read() {
  if (from_.points() > std::numeric_limits<vertex_index>::max() / 4)
    return from_.failure(from_.piece_line(), "more points than 32-bit numbers can name");
  for (const auto part :
       {&vtu_mesh_reader::read_points, &vtu_mesh_reader::read_cells, &vtu_mesh_reader::read_regions,
        &vtu_mesh_reader::read_disagreeing, &vtu_mesh_reader::read_boundary,
        &vtu_mesh_reader::read_metric, &vtu_mesh_reader::read_given})
    if (auto failed = (this->*part)()) return failed;
  const mesh& m = made_.content;
  if (m.triangles.empty() && made_.quadrilaterals.empty() && m.boundary.empty())
    return from_.failure(from_.piece_line(),
                         "there is no cell of type 5, a triangle, nor any other that is read");
  made_.all_edges = true;
  return put_in_order(made_, listed_order::put_right);
}

}  // namespace

result<listed_mesh> read_vtu_mesh(std::string_view text, const std::string& file) {
  auto opened = vtu_file::open(text, file);
  if (!opened) return opened.failure();
  vtu_mesh_reader reader(opened.value(), file);
  if (auto failed = reader.read()) return *failed;
  return reader.take();
}

}  // namespace asterism::internal
