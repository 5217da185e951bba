// SPDX-License-Identifier: MIT
//
// delaunay_bench FILE: triangulates the vertices of a Medit mesh by CGAL, in the order of the file.
// Prints processor seconds of the triangulation alone, and its number of triangles.
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <ctime>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace {

using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using triangulation = CGAL::Delaunay_triangulation_2<kernel>;

std::vector<kernel::Point_2> read_vertices(const std::string& name) {
  std::ifstream file(name);
  std::string word;
  while (file >> word && word != "Vertices") {
  }
  std::size_t count = 0;
  file >> count;
  std::vector<kernel::Point_2> points;
  double x = 0, y = 0;
  int reference = 0;
  while (points.size() < count && file >> x >> y >> reference) points.emplace_back(x, y);
  return points;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: delaunay_bench FILE.mesh\n";
    return 2;
  }
  const std::vector<kernel::Point_2> points = read_vertices(argv[1]);
  if (points.empty()) {
    std::cerr << "delaunay_bench: " << argv[1] << ": no vertices\n";
    return 2;
  }
  const std::clock_t start = std::clock();
  const triangulation t(points.begin(), points.end());
  const std::clock_t end = std::clock();
  std::cout << static_cast<double>(end - start) / CLOCKS_PER_SEC << ' ' << t.number_of_faces()
            << '\n';
  return 0;
}
