// SPDX-License-Identifier: MIT
//
// Gives the vertices of any mesh the tensors of a metric field, so that meshes of programs that
// keep none can be judged in the metric they were asked for: MESH SPEC OUT.mesh.
#include <asterism/mesh/io/medit.hpp>
#include <iostream>

#include "job.hpp"

namespace {

asterism::result<asterism::mesh> sampled(const std::string& name,
                                         const std::string& specification) {
  auto read = asterism::read_medit(name, {.without_solution = true});
  if (!read) return read;
  asterism::domain vertices;
  for (const asterism::site& s : read.value().sites) vertices.vertices.push_back(s.position);
  const auto field = baselines::make_field(specification, vertices.box(), 1);
  if (!field) return field.failure();
  for (asterism::site& s : read.value().sites) {
    const auto tensor = field.value()->at(s.position);
    if (!tensor) return tensor.failure();
    s.metric = tensor.value();
  }
  return read;
}

int complain(const asterism::error& failure) {
  std::cerr << failure.message << '\n';
  return 2;
}

}  // namespace

int main(int count, char** words) {
  if (count != 4) return complain({"usage: sample_metric MESH SPEC OUT.mesh"});
  const auto made = sampled(words[1], words[2]);
  if (!made) return complain(made.failure());
  const auto written = asterism::write_mesh(words[3], made.value());
  return written ? 0 : complain(written.failure());
}
