// SPDX-License-Identifier: MIT
//
// Measures by how much the edges around a node agree, while its tensor or its place is tried in
// several ways: unchanged values are computed once. Internal to mesh/adapt.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "asterism/mesh/adapt/editable_mesh.hpp"
#include "asterism/mesh/adapt/local_tests.hpp"
#include "asterism/mesh/adapt/present_centres.hpp"
#include "asterism/mesh/support/work_weights.hpp"

namespace asterism::internal::adapting {

class edges_around {
 public:
  // Refers to the mesh, the tests and the centres, which must outlive this object.
  edges_around(const editable_mesh& m, const local_tests& tests, present_centres& present)
      : m_(m), tests_(tests), present_(present) {}

  // Selects the node to be tried. Until the next call no other node may change.
  void turn_to(vertex_index v) {
    v_ = v;
    m_.around(v, at_);
  }
  // Accepts the node as it was tried: the known centres of its faces are no longer valid.
  void accept() { present_.forget(at_); }
  // Returns the faces around the node.
  const face_list& faces() const { return at_; }

  // Computes the centre of each face across from the node, except across segments, until a call
  // returns false.
  template <class Visit>
  void visit_centres_across(const Visit& visit) {
    for (std::size_t k = 0; k < at_.size(); ++k) {
      const face& f = m_.faces()[at_[k]];
      const std::size_t i = f.corner_of(v_);
      if (f.next[i] == none || f.segment[i] != none) continue;
      if (!visit(present_.of(f.next[i]))) return;
    }
  }
  // Stores the clearances of the edges for the node as the mesh has it, for a comparison with those
  // of the node as it is tried.
  void remember() {
    clearances_.clear();
    visit_clearances([this](std::size_t k) { return present_.of(at_[k]); },
                     [this](double clear) {
                       clearances_.push_back(clear);
                       return true;
                     });
  }
  // True if is_enough(now, then) for each edge: its present clearance, and the stored one.
  template <class Enough>
  bool all_of(const Enough& is_enough) {
    std::size_t edge = 0;
    own_.assign(at_.size(), {});
    return visit_clearances([this](std::size_t k) { return own_centre(k); },
                            [&](double now) { return is_enough(now, clearances_[edge++]); });
  }

 private:
  struct known_centre {
    face_centre centre;
    bool is_known = false;
  };

  // Calls visit(clearance) for each edge that has the node as an end or across from it, until a
  // call returns false; returns the last result. Clearances are infinite at segments. An edge at
  // the node, which two faces share, is visited once. `own(k)` returns the centre of the k-th face
  // at the node.
  template <class Own, class Visit>
  bool visit_clearances(const Own& own, const Visit& visit);

  // Returns the centre of a face at the node as it is tried, computed once.
  const face_centre& own_centre(std::size_t k) {
    known_centre& c = own_[k];
    if (!c.is_known) {
      m_.note_looked_at(work_weights::faces_for_centre);
      c = {tests_.centre_of(at_[k]), true};
    }
    return c.centre;
  }

  const editable_mesh& m_;
  const local_tests& tests_;
  present_centres& present_;
  vertex_index v_ = none;
  face_list at_;
  std::vector<known_centre> own_;  // of the faces around the node
  std::vector<double> clearances_;
};

template <class Own, class Visit>
bool edges_around::visit_clearances(const Own& own, const Visit& visit) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto is_end = [](std::size_t i, const face& f) {
    return f.next[i] == none || f.segment[i] != none;
  };
  for (std::size_t k = 0; k < at_.size(); ++k) {
    const face& f = m_.faces()[at_[k]];
    const std::size_t i = f.corner_of(v_), next = k + 1 < at_.size() ? k + 1 : 0;
    double clear = infinity;
    if (!is_end(i, f)) {
      const node& d = m_.at(tests_.quad_at(at_[k], i).d);
      clear = std::min(clearance(own(k), d), clearance(present_.of(f.next[i]), m_.at(v_)));
    }
    if (!visit(clear)) return false;
    clear = infinity;
    if (!is_end(after(i), f)) {
      const edge_quad q = tests_.quad_at(at_[k], after(i));
      clear = std::min(clearance(own(k), m_.at(q.d)), clearance(own(next), m_.at(q.c)));
    }
    if (!visit(clear)) return false;
  }
  return true;
}

}  // namespace asterism::internal::adapting
