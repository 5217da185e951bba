// SPDX-License-Identifier: MIT
//
// Remembers the Voronoi vertices of the faces of a mesh as it is, while nodes are tried elsewhere
// or with other tensors: each is computed once until a node of its face changes for good. Internal
// to mesh/adapt.
#pragma once

#include <cstddef>
#include <vector>

#include "asterism/mesh/adapt/editable_mesh.hpp"
#include "asterism/mesh/adapt/local_tests.hpp"
#include "asterism/mesh/support/free_memory.hpp"
#include "asterism/mesh/support/parallel.hpp"
#include "asterism/mesh/support/work_weights.hpp"

namespace asterism::internal::adapting {

class present_centres {
 public:
  // Refers to the mesh and the tests, which must outlive this object.
  present_centres(const editable_mesh& m, const local_tests& tests) : m_(m), tests_(tests) {
    forget_all();
  }

  // Computes the Voronoi vertices that are not known, with all threads. Until the next change
  // several threads may call of().
  void find_all() {
    constexpr std::size_t faces_at_once = 2048;
    parallel_chunks(m_.faces().size(), faces_at_once,
                    [this](std::size_t, std::size_t begin, std::size_t end) {
                      for (std::size_t t = begin; t < end; ++t)
                        if (m_.faces()[t].exists()) of(static_cast<vertex_index>(t));
                    });
  }
  // Returns the Voronoi vertex of a face.
  const face_centre& of(vertex_index t) {
    if (is_known_[t] == 0) {
      m_.note_looked_at(work_weights::faces_for_centre);
      centres_[t] = tests_.centre_of(t);
      is_known_[t] = 1;
    }
    return centres_[t];
  }
  // Forgets the Voronoi vertex of a face that has changed.
  void forget(vertex_index t) { is_known_[t] = 0; }
  // Stores the new Voronoi vertex of a face that has changed.
  void replace(vertex_index t, const face_centre& centre) {
    centres_[t] = centre;
    is_known_[t] = 1;
  }
  void forget_all() {
    centres_.resize(m_.faces().size());
    is_known_.assign(m_.faces().size(), 0);
  }
  // Frees the lists, 25 bytes a face; forget_all() makes them anew.
  void release() { free_memory(centres_, is_known_); }

 private:
  const editable_mesh& m_;
  const local_tests& tests_;
  std::vector<face_centre> centres_;
  std::vector<char> is_known_;
};

}  // namespace asterism::internal::adapting
