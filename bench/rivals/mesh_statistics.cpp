// SPDX-License-Identifier: MIT
//
// Measures how well a mesh of the square, made by any program, fits a metric; and writes the input
// with which another mesh generator makes one. Plain doubles: for tables, not for certificates.
//
//   mesh_statistics judge MESH SPEC SIZE     JSON: counts, lengths of edges, angles
//   mesh_statistics metric MESH SPEC SIZE    the tensor at every vertex, as BAMG reads it
//   mesh_statistics size SPEC TRIANGLES      the SIZE with which unit edges give so many triangles
//
// MESH is a .mesh file of Medit's or BAMG's; SPEC and SIZE are --metric and --size of the command.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>
#include <vector>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/domain/built_in_domains.hpp"
#include "asterism/mesh/metric/make_metric_field.hpp"
#include "asterism/mesh/numerics/metric_angle.hpp"

namespace asterism::bench {
using namespace internal;
namespace {

constexpr double angle_bound = 20, root_half = 0.70710678118654752;

[[noreturn]] void fail(const std::string& what) {
  std::cerr << "mesh_statistics: " << what << '\n';
  std::exit(2);
}

template <class T>
T value_of(result<T> made) {
  if (!made.ok()) fail(made.failure().message);
  return std::move(made).value();
}

// Reads vertices and triangles only: both programs' files have these in the same form.
mesh read_mesh(const std::string& path) {
  std::ifstream file(path);
  if (!file) fail("cannot read " + path);
  mesh read;
  std::string word;
  while (file >> word) {
    std::size_t count = 0, reference = 0;
    if (word == "Vertices" && file >> count) {
      read.sites.resize(count);
      for (site& s : read.sites) file >> s.position.x >> s.position.y >> reference;
    } else if (word == "Triangles" && file >> count) {
      read.triangles.resize(count);
      for (triangle& t : read.triangles) {
        for (vertex_index& v : t) {
          file >> v;
          --v;
        }
        file >> reference;
      }
    }
  }
  if (read.triangles.empty()) fail("no triangles in " + path);
  for (const triangle& t : read.triangles)
    for (const vertex_index v : t)
      if (v >= read.sites.size()) fail("a triangle with a vertex that does not exist in " + path);
  return read;
}

void evaluate(mesh& m, const metric_field& field) {
  for (site& s : m.sites) s.metric = value_of(field.at(s.position));
}

double length(const metric_tensor& m, const point& a, const point& b) {
  const double x = b.x - a.x, y = b.y - a.y;
  return std::sqrt(m.m11 * x * x + 2 * m.m12 * x * y + m.m22 * y * y);
}

// Returns the length of the edge if lengths wanted grow geometrically along it. Source: Alauzet,
// "Size gradation control of anisotropic meshes", 2010, section 2.
double length(const site& a, const site& b) {
  const double from_a = length(a.metric, a.position, b.position);
  const double from_b = length(b.metric, a.position, b.position), ratio = from_a / from_b;
  return std::abs(ratio - 1) < 1e-3 ? (from_a + from_b) / 2 : (from_a - from_b) / std::log(ratio);
}

nlohmann::json edges_of(const mesh& m) {
  std::vector<std::array<vertex_index, 2>> edges;
  for (const triangle& t : m.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      edges.push_back({std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])});
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  std::vector<double> lengths;
  lengths.reserve(edges.size());
  for (const auto& e : edges) lengths.push_back(length(m.sites[e[0]], m.sites[e[1]]));
  std::sort(lengths.begin(), lengths.end());
  const auto unit = std::upper_bound(lengths.begin(), lengths.end(), 2 * root_half) -
                    std::lower_bound(lengths.begin(), lengths.end(), root_half);
  const double count = static_cast<double>(lengths.size());
  return {{"edges", lengths.size()},
          {"unit edges", static_cast<double>(unit) / count},
          {"mean length", std::accumulate(lengths.begin(), lengths.end(), 0.0) / count},
          {"shortest", lengths.front()},
          {"longest", lengths.back()}};
}

// Marks the corners of the square whose own angle, in the corner's metric, is below the bound, so
// that no mesh reaches it there.
std::vector<bool> forcing_corners(const mesh& m, const domain& square) {
  std::vector<bool> forcing(m.sites.size());
  const std::size_t n = square.vertices.size();
  for (std::size_t v = 0; v < m.sites.size(); ++v)
    for (std::size_t i = 0; i < n; ++i) {
      const site& s = m.sites[v];
      if (s.position == square.vertices[i])
        forcing[v] = angle_in_metric(s.metric, s.position, square.vertices[(i + 1) % n],
                                     square.vertices[(i + n - 1) % n]) < angle_bound;
    }
  return forcing;
}

nlohmann::json angles_of(const mesh& m, const domain& square) {
  const std::vector<bool> forcing = forcing_corners(m, square);
  double worst = 180, worst_unforced = 180, area = 0;
  std::size_t low = 0, turned_over = 0;
  for (const triangle& t : m.triangles) {
    const point &a = m.sites[t[0]].position, &b = m.sites[t[1]].position,
                &c = m.sites[t[2]].position;
    const double twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    area += twice / 2;
    if (!(twice > 0)) ++turned_over;
    const double angle = smallest_angle(m, t);
    worst = std::min(worst, angle);
    if (forcing[t[0]] || forcing[t[1]] || forcing[t[2]]) continue;
    worst_unforced = std::min(worst_unforced, angle);
    if (angle < angle_bound) ++low;
  }
  return {{"worst angle", worst},
          {"worst angle unforced", worst_unforced},
          {"low", low},
          {"turned over", turned_over},
          {"area", area}};
}

void judge(const std::string& path, const metric_field& field, const domain& square) {
  mesh m = read_mesh(path);
  evaluate(m, field);
  nlohmann::json found = edges_of(m);
  found.update(angles_of(m, square));
  found["vertices"] = m.sites.size();
  found["triangles"] = m.triangles.size();
  std::cout << found.dump() << '\n';
}

void write_metric(const std::string& path, const metric_field& field) {
  mesh m = read_mesh(path);
  evaluate(m, field);
  std::printf("%zu 3\n", m.sites.size());
  for (const site& s : m.sites)
    std::printf("%.17g %.17g %.17g\n", s.metric.m11, s.metric.m12, s.metric.m22);
}

// Divides the area in the metric, by the midpoint rule on an even grid, by that of a triangle with
// unit edges, sqrt(3)/4.
void print_size(const metric_field& field, double triangles) {
  constexpr int n = 2000;
  double sum = 0;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const metric_tensor m = value_of(field.at({(2 * i + 1.0) / n - 1, (2 * j + 1.0) / n - 1}));
      sum += std::sqrt(m.m11 * m.m22 - m.m12 * m.m12);
    }
  const double area = sum * 4 / (1.0 * n * n);
  std::printf("%.6g\n", std::sqrt(area / (std::sqrt(3.0) / 4) / triangles));
}

int run(const std::vector<std::string>& words) {
  const domain shape = square();
  const auto field = [&](const std::string& specification, double size) {
    return value_of(make_metric_field(specification, shape.box(), size));
  };
  if (words.size() == 4 && words[0] == "judge")
    judge(words[1], *field(words[2], value_of(parse_number(words[3]))), shape);
  else if (words.size() == 4 && words[0] == "metric")
    write_metric(words[1], *field(words[2], value_of(parse_number(words[3]))));
  else if (words.size() == 3 && words[0] == "size")
    print_size(*field(words[1], 1), value_of(parse_number(words[2])));
  else
    fail("judge MESH SPEC SIZE, metric MESH SPEC SIZE, or size SPEC TRIANGLES");
  return 0;
}

}  // namespace
}  // namespace asterism::bench

int main(int argc, char** argv) {
  return asterism::bench::run(std::vector<std::string>(argv + 1, argv + argc));
}
