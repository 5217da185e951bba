// SPDX-License-Identifier: MIT
//
// metric_delaunay POINTS: the Delaunay triangulation of points in one metric by CGAL, twice: with
// metric_traits, and as people do without, by mapping the points with F, F^T F = M, and
// triangulating their images. Prints triangles, edges that are not Delaunay in the metric and
// triangles inverted, both by exact tests on the points as given, and seconds. Exit status 1 if the
// first is wrong anywhere.
//
// CGAL's Delaunay_triangulation_2 is under the GPL 3 or later, and so is a program that contains
// it; this one is an example, built for tests alone.
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>
#include <utility>
#include <vector>

#include "metric_traits.hpp"

namespace {

using asterism::metric_tensor;
using asterism::point;
using plane = CGAL::Exact_predicates_inexact_constructions_kernel;
using plane_point = plane::Point_2;

template <class Traits>
using triangulation = CGAL::Delaunay_triangulation_2<
    Traits,
    CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_with_info_2<int, Traits>>>;

// Points of a lattice whose cells are squares in the metric. A quarter of the points are moved by
// one unit in the last place, so that many are on one ellipse, or nearly.
std::vector<point> lattice_points(std::size_t count) {
  std::mt19937_64 random(7);  // the same numbers everywhere
  const int size = static_cast<int>(std::sqrt(double(count)));
  std::vector<point> points;
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j) {
      point p = {(4 * i + j) / 16.0 + 1, (i + 2 * j) / 16.0 + 1};
      if (random() % 4 == 0) p.x = std::nextafter(p.x, random() % 2 == 0 ? 0 : 1e9);
      points.push_back(p);
    }
  return points;
}

// In the metric (4, 1) and (1, 2) have length 7 and are orthogonal.
constexpr metric_tensor metric = {5, -6, 17};

struct report {
  std::size_t triangles = 0, inverted = 0, wrong_edges = 0;
  double seconds = 0;
};

// Tests a triangulation exactly on the points for which the vertices' numbers stand.
template <class Triangulation>
void check(const Triangulation& made, const std::vector<point>& points, report& found) {
  const asterism::filtered_kernel kernel;
  const auto at = [&](auto vertex) { return points[static_cast<std::size_t>(vertex->info())]; };
  for (auto face = made.finite_faces_begin(); face != made.finite_faces_end(); ++face) {
    const point a = at(face->vertex(0)), b = at(face->vertex(1)), c = at(face->vertex(2));
    ++found.triangles;
    if (kernel.orientation(a, b, c) != asterism::sign::positive) ++found.inverted;
    for (int k = 0; k < 3; ++k) {
      const auto other = face->neighbor(k);
      if (made.is_infinite(other) || &*other < &*face) continue;  // each edge once
      const point p = at(made.mirror_vertex(face, k));
      if (kernel.in_circle(metric, a, b, c, p) == asterism::sign::positive) ++found.wrong_edges;
    }
  }
}

template <class Traits>
report triangulate(const std::vector<point>& points, const std::vector<plane_point>& placed,
                   const Traits& traits) {
  std::vector<std::pair<plane_point, int>> numbered;
  for (std::size_t i = 0; i < placed.size(); ++i) numbered.emplace_back(placed[i], int(i));
  report found;
  const std::clock_t start = std::clock();
  triangulation<Traits> made(traits);
  made.insert(numbered.begin(), numbered.end());
  found.seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
  check(made, points, found);
  return found;
}

void print(const char* who, const report& r) {
  std::printf("%s: %zu triangles, %zu inverted, %zu edges not Delaunay, %.3f s\n", who, r.triangles,
              r.inverted, r.wrong_edges, r.seconds);
}

}  // namespace

int main(int count, char** words) {
  const int wanted = count > 1 ? std::atoi(words[1]) : 10000;
  if (wanted < 4 || wanted > 10000000) return 2;
  const auto points = lattice_points(static_cast<std::size_t>(wanted));
  std::vector<plane_point> given, mapped;
  const double f11 = std::sqrt(metric.m11), f12 = metric.m12 / f11;
  const double f22 = std::sqrt(metric.m22 - f12 * f12);
  for (const point& p : points) {
    given.emplace_back(p.x, p.y);
    mapped.emplace_back(f11 * p.x + f12 * p.y, f22 * p.y);
  }
  const report exact = triangulate(points, given, embedding::metric_traits(metric));
  const report rounded = triangulate(points, mapped, plane());
  print("metric_traits", exact);
  print("mapped points", rounded);
  return exact.inverted + exact.wrong_edges == 0 ? 0 : 1;
}
