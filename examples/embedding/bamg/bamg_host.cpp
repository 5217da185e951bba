// SPDX-License-Identifier: MIT
//
// bamg_host METRIC ROUNDS OUT: adapts a grid of the square [-1,1]^2 to a metric by BAMG, ROUNDS
// times, each from the mesh before, and writes the last one to OUT.mesh, with the metric in
// OUT.sol. Compiled by compare.py together with the sources of BAMG, as they are or with the exact
// swap. Prints, a line a round: vertices, triangles, flips made, flips refused, seconds in BAMG.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <string>
#include <vector>

using namespace std;  // as the headers of BAMG expect
#include "Mesh2.h"
#include "metrics.hpp"

long verbosity = 0;
namespace bamg {
extern long NbFlips, NbUnSwap;
}

namespace {

struct triangle_mesh {
  struct edge {
    int from, to, side;
  };
  std::vector<double> x, y;
  std::vector<int> corners;  // three for a triangle
  std::vector<edge> boundary;
};

triangle_mesh grid(int n) {
  triangle_mesh mesh;
  const auto at = [n](int i, int j) { return j * (n + 1) + i; };
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      mesh.x.push_back(-1 + 2.0 * i / n);
      mesh.y.push_back(-1 + 2.0 * j / n);
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      for (const int v :
           {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1)})
        mesh.corners.push_back(v);
  for (int i = 0; i < n; ++i) {
    mesh.boundary.push_back({at(i, 0), at(i + 1, 0), 1});
    mesh.boundary.push_back({at(n, i), at(n, i + 1), 2});
    mesh.boundary.push_back({at(n - i, n), at(n - i - 1, n), 3});
    mesh.boundary.push_back({at(0, n - i), at(0, n - i - 1), 4});
  }
  return mesh;
}

// Holds the background mesh in BAMG's types, with the metric at its vertices.
bamg::Triangles* to_bamg(const triangle_mesh& mesh, const metric_function& metric) {
  const bamg::Int4 nv = mesh.x.size(), nt = mesh.corners.size() / 3;
  auto* const to = new bamg::Triangles(nv);
  to->nbv = nv;
  to->nbt = nt;
  to->nbe = mesh.boundary.size();
  to->name = new char[8]{"grid"};
  to->edges = new bamg::Edge[to->nbe];
  for (bamg::Int4 i = 0; i < nv; ++i) {
    to->vertices[i].r = bamg::R2(mesh.x[i], mesh.y[i]);
    to->vertices[i].ReferenceNumber = 0;
    const auto m = metric(mesh.x[i], mesh.y[i]);
    to->vertices[i].m = bamg::MetricAnIso(m[0], m[1], m[2]);
  }
  for (bamg::Int4 i = 0; i < nt; ++i) {
    const int* const v = &mesh.corners[3 * i];
    to->triangles[i] = bamg::Triangle(to, v[0], v[1], v[2]);
    to->triangles[i].color = 0;
  }
  for (bamg::Int4 i = 0; i < to->nbe; ++i) {
    to->edges[i].v[0] = to->vertices + mesh.boundary[i].from;
    to->edges[i].v[1] = to->vertices + mesh.boundary[i].to;
    to->edges[i].ref = mesh.boundary[i].side;
    to->edges[i].on = 0;
  }
  to->ConsGeometry(-1);
  to->Gh.AfterRead();
  to->SetIntCoor();
  to->FillHoleInMesh();
  to->ReMakeTriangleContainingTheVertex();
  return to;
}

triangle_mesh from_bamg(bamg::Triangles& from) {
  triangle_mesh mesh;
  from.ReNumberingTheTriangleBySubDomain(true);
  for (bamg::Int4 i = 0; i < from.nbv; ++i) {
    mesh.x.push_back(from.vertices[i].r.x);
    mesh.y.push_back(from.vertices[i].r.y);
  }
  for (bamg::Int4 i = 0; i < from.nbt; ++i)
    if (from.triangles[i].link)
      for (int k = 0; k < 3; ++k) mesh.corners.push_back(from.Number(from.triangles[i][k]));
  for (bamg::Int4 i = 0; i < from.nbe; ++i)
    mesh.boundary.push_back({int(from.Number(from.edges[i][0])), int(from.Number(from.edges[i][1])),
                             int(from.edges[i].ref)});
  return mesh;
}

FILE* opened(const std::string& path) {
  FILE* const out = fopen(path.c_str(), "w");
  if (!out) exit(2);
  return out;
}

void write(const triangle_mesh& mesh, const std::string& path) {
  FILE* const out = opened(path);
  fprintf(out, "MeshVersionFormatted 2\nDimension 2\nVertices\n%zu\n", mesh.x.size());
  for (size_t i = 0; i < mesh.x.size(); ++i) fprintf(out, "%.17g %.17g 0\n", mesh.x[i], mesh.y[i]);
  fprintf(out, "Triangles\n%zu\n", mesh.corners.size() / 3);
  for (size_t i = 0; i < mesh.corners.size(); i += 3)
    fprintf(out, "%d %d %d 0\n", mesh.corners[i] + 1, mesh.corners[i + 1] + 1,
            mesh.corners[i + 2] + 1);
  fprintf(out, "End\n");
  fclose(out);
}

void write_metric(const triangle_mesh& mesh, const metric_function& metric,
                  const std::string& path) {
  FILE* const out = opened(path);
  fprintf(out, "MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n%zu\n1 3\n", mesh.x.size());
  for (size_t i = 0; i < mesh.x.size(); ++i) {
    const auto m = metric(mesh.x[i], mesh.y[i]);
    fprintf(out, "%.17g %.17g %.17g\n", m[0], m[1], m[2]);
  }
  fprintf(out, "End\n");
  fclose(out);
}

triangle_mesh adapted(const triangle_mesh& mesh, const metric_function& metric) {
  bamg::Triangles* const background = to_bamg(mesh, metric);
  bamg::NbFlips = bamg::NbUnSwap = 0;
  const clock_t start = clock();
  bamg::Triangles fine(200000, *background, 0);  // most vertices
  fine.SplitInternalEdgeWithBorderVertices();
  fine.SmoothingVertex(3, 1.0);
  const double seconds = double(clock() - start) / CLOCKS_PER_SEC;
  triangle_mesh result = from_bamg(fine);
  printf("%zu %zu %ld %ld %.3f\n", result.x.size(), result.corners.size() / 3, bamg::NbFlips,
         bamg::NbUnSwap, seconds);
  fflush(stdout);
  // `fine` refers to the background as long as it exists, so the background is kept until the
  // program ends.
  return result;
}

}  // namespace

int main(int count, char** words) {
  if (count != 4) return 2;
  const metric_function metric = metric_named(words[1]);
  if (!metric) return 2;
  triangle_mesh mesh = grid(64);
  for (int round = 0; round < atoi(words[2]); ++round) mesh = adapted(mesh, metric);
  write(mesh, std::string(words[3]) + ".mesh");
  write_metric(mesh, metric, std::string(words[3]) + ".sol");
  return 0;
}
