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
#include "asterism/mesh/io/medit_edges.hpp"
#include "asterism/mesh/io/vtu_file.hpp"

namespace asterism::internal {
namespace {

using failure = std::optional<error>;
using numbers = std::vector<double>;

constexpr int vertex_cell = 1, line_cell = 3, triangle_cell = 5;

// Names that programs give to the numbers of materials and markers: ours, gmsh's, Medit's,
// FreeFEM's, Elmer's, meshio's.
constexpr std::array<std::string_view, 12> names_of_regions = {
    "region",      "regions",   "gmsh:physical", "medit:ref", "Label",      "CellEntityIds",
    "GeometryIds", "cell_tags", "reference",     "material",  "MaterialID", "materialid"};
// Whole numbers that are no region: counts and numbers of the cells themselves.
constexpr std::array<std::string_view, 7> other_names = {
    "disagreeing",      "vtkGhostType",     "vtkOriginalCellIds", "GlobalCellIds",
    "GlobalElementIds", "gmsh:geometrical", "vtkGhostLevels"};

template <std::size_t N>
bool is_among(const std::array<std::string_view, N>& all, std::string_view name) {
  return std::find(all.begin(), all.end(), name) != all.end();
}

bool holds_integers(const vtu_array& a) {
  return a.tag["type"].starts_with("Int") || a.tag["type"].starts_with("UInt");
}

class vtu_mesh_reader {
 public:
  explicit vtu_mesh_reader(vtu_file& from) : from_(from) {}

  failure read();
  vtu_mesh take() { return std::move(made_); }

 private:
  failure read_points();
  failure read_cells();
  failure read_cell(int type, std::size_t cell, const double* corners, std::size_t count);
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
  vtu_mesh made_;
  const vtu_array *connectivity_ = nullptr, *types_ = nullptr, *regions_ = nullptr;
  std::vector<std::size_t> triangles_, lines_;  // their cells
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
      return refuse(
          *points,
          fmt::format("point {}: z is {:g}, not 0: only plane meshes can be read", v + 1, p[2]));
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

failure vtu_mesh_reader::read_cell(int type, std::size_t cell, const double* corners,
                                   std::size_t count) {
  if (type == vertex_cell) return {};
  const std::size_t wanted = type == line_cell ? 2 : 3;
  if ((type != line_cell && type != triangle_cell) || count != wanted)
    return from_.failure(types_->tag.line,
                         fmt::format("cell {} is of type {} with {} points: triangles (5), lines "
                                     "(3) and points (1) of first order can be read",
                                     cell + 1, type, count));
  triangle t{};
  for (std::size_t i = 0; i < count; ++i) {
    const auto v = vertex(corners[i], *connectivity_);
    if (!v) return v.failure();
    t[i] = v.value();
  }
  mesh& m = made_.content;
  if (type == triangle_cell) {
    triangles_.push_back(cell);
    m.triangles.push_back(t);
  } else {
    lines_.push_back(cell);
    m.boundary.push_back({t[0], t[1], static_cast<vertex_index>(m.boundary.size()), 0, false});
  }
  return {};
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
    if (auto failed = read_cell(static_cast<int>(types.value()[cell]), cell,
                                corners.value().data() + begin, end - begin))
      return failed;
    begin = end;
  }
  return {};
}

// Chooses the array of cell data that numbers the regions. What might be one by its values alone is
// taken where there is no doubt about it, and never dropped.
failure vtu_mesh_reader::choose_regions() {
  for (const std::string_view name : names_of_regions)
    if ((regions_ = from_.find("CellData", name)) != nullptr) return {};
  const vtu_array* other = nullptr;
  for (const vtu_array& a : from_.arrays()) {
    if (a.section != "CellData" || !holds_integers(a) || is_among(other_names, a.name())) continue;
    if (regions_ != nullptr) other = &a;
    if (regions_ == nullptr) regions_ = &a;
  }
  if (other != nullptr)
    return from_.failure(other->tag.line,
                         fmt::format("cell data {} and {} hold whole numbers, and none is named "
                                     "region: name the one that is so",
                                     quoted_token(regions_->name()), quoted_token(other->name())));
  if (regions_ != nullptr)
    made_.content.notes.push_back("the cell data " + quoted_token(regions_->name()) +
                                  " are taken for the regions");
  return {};
}

failure vtu_mesh_reader::read_regions() {
  if (auto failed = choose_regions()) return failed;
  if (regions_ == nullptr) return {};
  const auto width = from_.components(*regions_);
  if (!width) return width.failure();
  if (width.value() != 1) return refuse(*regions_, "one number for each cell is wanted");
  constexpr double least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
  const auto found = whole_numbers(*regions_, from_.cells(), least, most);
  if (!found) return found.failure();
  mesh& m = made_.content;
  for (const std::size_t cell : triangles_)
    m.regions.push_back(static_cast<int>(found.value()[cell]));
  for (std::size_t i = 0; i < lines_.size(); ++i)
    m.boundary[i].marker = static_cast<int>(found.value()[lines_[i]]);
  return {};
}

// Takes the cells away that a run which was not complete wrote beside its triangles.
failure vtu_mesh_reader::read_disagreeing() {
  const vtu_array* const a = from_.find("CellData", "disagreeing");
  if (a == nullptr) return {};
  const auto found = whole_numbers(*a, from_.cells(), 0, 1);
  if (!found) return found.failure();
  mesh& m = made_.content;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    if (found.value()[triangles_[i]] != 0) {
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

// Reads the subsegments of a file of ours: two points, the marker, and the segment from 0.
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
    m.boundary.push_back(
        {from.value(), to.value(), static_cast<vertex_index>(e[3]), static_cast<int>(e[2]), false});
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
      return refuse(
          *a, fmt::format("the tensor {:g} {:g} {:g} of point {} is not positive definite", t[0],
                          t[1], t[2], v + 1));
    made_.content.sites[v].metric = m;
  }
  made_.has_metric = true;
  return {};
}

// Counts the vertices of the domain, where these are the first ones.
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
  mesh& m = made_.content;
  if (m.triangles.empty())
    return from_.failure(from_.piece_line(), "there is no cell of type 5, a triangle");
  keep_segments(m, {std::vector<char>(m.boundary.size(), 1), true});
  list_sides(m);
  if (std::all_of(m.regions.begin(), m.regions.end(), [](int region) { return region == 1; }))
    m.regions.clear();
  return {};
}

}  // namespace

result<vtu_mesh> read_vtu_mesh(std::string_view text, const std::string& file) {
  auto opened = vtu_file::open(text, file);
  if (!opened) return opened.failure();
  vtu_mesh_reader reader(opened.value());
  if (auto failed = reader.read()) return *failed;
  return reader.take();
}

}  // namespace asterism::internal
