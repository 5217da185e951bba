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
  edges_around(editable_mesh& m, const local_tests& tests, present_centres& present)
      : m_(m), tests_(tests), present_(present) {}

  // Selects the node to be tried. Until the next call no other node may change.
  void turn_to(vertex_index v) {
    v_ = v;
    m_.around(v, at_);
    own_.clear();
    first_ = 0;
  }
  // Accepts the node as it was tried last. The centres of its faces that all_of() has computed for
  // it, if it was called, are kept as the present ones.
  void accept() {
    for (std::size_t k = 0; k < at_.size(); ++k)
      if (k < own_.size() && own_[k].is_known)
        present_.replace(at_[k], own_[k].centre);
      else
        present_.forget(at_[k]);
    own_.clear();
  }
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
  // Stores the node as the mesh has it, for comparisons with the node as it is tried.
  void remember() { before_ = m_.at(v_); }
  // True if is_enough(now, before) for the edge of each face that lies across from the node: the
  // clearance of the node, as it is tried, from the face beyond, and a function that computes the
  // clearance of the edge for the stored node. That of an edge is no more than this: what fails
  // here fails in all_of(), too, which also computes the centres of the faces at the node.
  template <class Enough>
  bool all_across(const Enough& is_enough) {
    for (std::size_t nth = 0, k = first_; nth < at_.size(); ++nth, k = following(k)) {
      if (is_enough(clearance_across(k), [&] { return clearance_before(k, edge_of_face::across); }))
        continue;
      first_ = k;
      return false;
    }
    return true;
  }
  // True if is_enough(now, before) for each edge: its clearance for the node as it is tried, and a
  // function that computes the clearance for the stored node. Begins with the edges of the face
  // that had one without enough in the last call: that edge often has too little again.
  template <class Enough>
  bool all_of(const Enough& is_enough) {
    own_.assign(at_.size(), {});
    const auto tried = [this](std::size_t k) { return own_centre(k); };
    for (std::size_t nth = 0, k = first_; nth < at_.size(); ++nth, k = following(k))
      for (const edge_of_face edge : {edge_of_face::across, edge_of_face::beside}) {
        if (is_enough(clearance_of(k, edge, tried), [&] { return clearance_before(k, edge); }))
          continue;
        first_ = k;
        return false;
      }
    return true;
  }

 private:
  struct known_centre {
    face_centre centre;
    bool is_known = false;
  };

  // Edge of a face at the node: the one across from the node, or the one at it that belongs to this
  // face and the next one.
  enum class edge_of_face { across, beside };

  std::size_t following(std::size_t k) const { return k + 1 < at_.size() ? k + 1 : 0; }
  // Returns the clearance of the node, as it is tried, from the face across the k-th one at it;
  // infinite at a segment.
  double clearance_across(std::size_t k) {
    const face& f = m_.faces()[at_[k]];
    const std::size_t i = f.corner_of(v_);
    if (f.next[i] == none || f.segment[i] != none) return std::numeric_limits<double>::infinity();
    return clearance(present_.of(f.next[i]), m_.at(v_));
  }
  // Returns the clearance of an edge of the k-th face at the node; infinite at a segment. `own(k)`
  // returns the centre of that face.
  template <class Own>
  double clearance_of(std::size_t k, edge_of_face edge, const Own& own);
  double clearance_before(std::size_t k, edge_of_face edge) {
    const node tried = m_.at(v_);
    m_.at(v_) = before_;
    const double clear =
        clearance_of(k, edge, [this](std::size_t face) { return present_.of(at_[face]); });
    m_.at(v_) = tried;
    return clear;
  }

  // Returns the centre of a face at the node as it is tried, computed once.
  const face_centre& own_centre(std::size_t k) {
    known_centre& c = own_[k];
    if (!c.is_known) {
      m_.note_looked_at(work_weights::faces_for_centre);
      c.centre = tests_.centre_of(at_[k]);
      c.is_known = true;
    }
    return c.centre;
  }

  editable_mesh& m_;
  const local_tests& tests_;
  present_centres& present_;
  vertex_index v_ = none;
  face_list at_;
  std::size_t first_ = 0;          // of these, in all_of
  std::vector<known_centre> own_;  // of the faces around the node; empty before all_of
  node before_;
};

template <class Own>
double edges_around::clearance_of(std::size_t k, edge_of_face edge, const Own& own) {
  const face& f = m_.faces()[at_[k]];
  const std::size_t corner = f.corner_of(v_);
  const std::size_t i = edge == edge_of_face::across ? corner : after(corner);
  if (f.next[i] == none || f.segment[i] != none) return std::numeric_limits<double>::infinity();
  const edge_quad q = tests_.quad_at(at_[k], i);
  const double by_own = clearance(own(k), m_.at(q.d));
  if (edge == edge_of_face::across)
    return std::min(by_own, clearance(present_.of(f.next[i]), m_.at(v_)));
  return std::min(by_own, clearance(own(following(k)), m_.at(q.c)));
}

}  // namespace asterism::internal::adapting
