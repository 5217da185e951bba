// SPDX-License-Identifier: MIT
//
// Measures by how much the edges around a node agree, while its tensor or its place is tried in
// several ways: unchanged values are computed once. Internal to mesh/adapt.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "asterism/mesh/adapt/local_tests.hpp"
#include "asterism/mesh/adapt/working_mesh.hpp"
#include "asterism/mesh/support/work_weights.hpp"

namespace asterism::internal::adapting {

class edges_around {
 public:
  // Refers to the mesh and the tests, which must outlive it.
  edges_around(const working_mesh& m, const local_tests& tests) : m_(m), tests_(tests) {}

  // Selects the node to be tried. Until the next call no other node may change.
  void turn_to(vertex_index v) {
    v_ = v;
    m_.around(v, at_);
    beyond_.assign(at_.size(), {});
  }
  // Returns the faces around the node.
  const face_list& faces() const { return at_; }

  // Calls answer(clearance) for each edge that has the node as an end or across from it, until it
  // returns false; clearances are infinite at segments; returns the last answer. Of the edges at
  // the node each face passes one, which it shares with the next face.
  template <class Tell>
  bool tell_clearances(const Tell& tell);
  // Computes the centre of each face across from the node, except across segments.
  template <class Tell>
  void tell_centres_across(const Tell& tell) {
    for (std::size_t k = 0; k < at_.size(); ++k) {
      const face& f = m_.faces()[at_[k]];
      const std::size_t i = f.corner_of(v_);
      if (f.next[i] != none && f.segment[i] == none) tell(centre_at(beyond_, k, f.next[i]));
    }
  }
  // Stores the present clearances, to be compared with later ones.
  void remember() {
    clearances_.clear();
    tell_clearances([this](double clear) {
      clearances_.push_back(clear);
      return true;
    });
  }
  // True if is_enough(now, then) for each edge: its present clearance, and the stored one.
  template <class Enough>
  bool all_of(const Enough& is_enough) {
    std::size_t edge = 0;
    return tell_clearances([&](double now) { return is_enough(now, clearances_[edge++]); });
  }

 private:
  struct known_centre {
    face_centre centre;
    bool is_known = false;
  };

  // Returns the centre of a face, computed once.
  const face_centre& centre_at(std::vector<known_centre>& known, std::size_t nth, vertex_index t) {
    known_centre& c = known[nth];
    if (!c.is_known) {
      m_.note_looked_at(work_weights::faces_for_centre);
      c = {tests_.centre_of(t), true};
    }
    return c.centre;
  }

  const working_mesh& m_;
  const local_tests& tests_;
  vertex_index v_ = none;
  face_list at_;
  // Centres of the faces around the node, and of those across from it, once computed.
  std::vector<known_centre> own_, beyond_;
  std::vector<double> clearances_;
};

template <class Tell>
bool edges_around::tell_clearances(const Tell& tell) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  own_.assign(at_.size(), {});
  const auto is_end = [](std::size_t i, const face& f) {
    return f.next[i] == none || f.segment[i] != none;
  };
  for (std::size_t k = 0; k < at_.size(); ++k) {
    const face& f = m_.faces()[at_[k]];
    const std::size_t i = f.corner_of(v_), next = k + 1 < at_.size() ? k + 1 : 0;
    double clear = infinity;
    if (!is_end(i, f)) {
      const node& d = m_.at(tests_.quad_at(at_[k], i).d);
      clear = std::min(clearance(centre_at(own_, k, at_[k]), d),
                       clearance(centre_at(beyond_, k, f.next[i]), m_.at(v_)));
    }
    if (!tell(clear)) return false;
    clear = infinity;
    if (!is_end(after(i), f)) {
      const edge_quad q = tests_.quad_at(at_[k], after(i));
      clear = std::min(clearance(centre_at(own_, k, at_[k]), m_.at(q.d)),
                       clearance(centre_at(own_, next, at_[next]), m_.at(q.c)));
    }
    if (!tell(clear)) return false;
  }
  return true;
}

}  // namespace asterism::internal::adapting
