// SPDX-License-Identifier: MIT
//
// Writes a sample mesh as sample.mesh, sample.sol and sample.vtu into the directory given, and its
// numbers as hexadecimal floats into expected.txt, for read_with_meshio.py to compare.
#include <cstdio>
#include <filesystem>

#include "asterism/mesh/io/write_mesh.hpp"
#include "asterism/tests/mesh/io/sample_mesh.hpp"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::filesystem::path directory = argv[1];
  const asterism::mesh m = asterism::tests::divided_mesh(7);
  for (const char* name : {"sample.mesh", "sample.vtu"})
    if (!asterism::write_mesh(directory / name, m).ok()) return 1;
  std::FILE* out = std::fopen((directory / "expected.txt").c_str(), "w");
  if (out == nullptr) return 1;
  for (const asterism::site& s : m.sites)
    std::fprintf(out, "site %a %a %a %a %a\n", s.position.x, s.position.y, s.metric.m11,
                 s.metric.m12, s.metric.m22);
  for (const asterism::triangle& t : m.triangles)
    std::fprintf(out, "triangle %u %u %u\n", t[0], t[1], t[2]);
  for (const int region : m.regions) std::fprintf(out, "region %d\n", region);
  for (const asterism::boundary_edge& e : m.boundary)
    std::fprintf(out, "edge %u %u %d\n", e.a, e.b, e.marker);
  return std::fclose(out) == 0 ? 0 : 1;
}
