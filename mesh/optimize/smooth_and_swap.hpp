// SPDX-License-Identifier: MIT
//
// Moves vertices and flips edges, only where the energy falls: in sweeps over all, or around one
// place.
//
// A vertex is tried at random places around it, from a fixed sequence of its own, so that changes
// elsewhere do not affect what it tries. One that gains nothing a few times rests until something
// around it changes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "asterism/mesh/optimize/mutable_mesh.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal::fitting {

class mover {
 public:
  // Works on `m`. Both must outlive it. `cancelled` is polled now and then; it ends a sweep.
  mover(mutable_mesh& m, const cancellation& cancelled) : mesh_(&m), cancelled_(&cancelled) {}

  // Visits every vertex that does not rest once, then flips wherever triangles changed. False if it
  // was cancelled or the field failed.
  bool sweep(double step);
  // Visits, in a few rounds, the vertices and those they reach over `depth` edges. Returns the
  // change of energy.
  double relax(std::span<const vertex_index> seeds, int depth);

  // Returns the vertices and those that triangles connect them to over `depth` edges.
  std::vector<vertex_index> ring(std::span<const vertex_index> seeds, int depth);
  void wake(std::span<const vertex_index> vertices);
  // Polls for cancellation; stays true once cancelled or once the field failed.
  bool is_cancelled();
  bool is_stopped() const { return stopped_; }

  std::size_t moves() const { return moves_; }
  std::size_t flips() const { return flips_; }

 private:
  double visit(vertex_index v, double step, std::span<const double> parts);
  double flip_changed_edges(vertex_index t);
  void flip_all();

  mutable_mesh* mesh_;
  const cancellation* cancelled_;
  std::vector<std::uint32_t> tries_;  // by vertex, like the next two
  std::vector<char> rests_;
  std::vector<std::uint32_t> mark_;
  std::uint32_t last_mark_ = 0;
  std::size_t visits_ = 0, moves_ = 0, flips_ = 0;
  bool stopped_ = false;
};

}  // namespace asterism::internal::fitting
