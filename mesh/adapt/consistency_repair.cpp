// SPDX-License-Identifier: MIT
#include "asterism/mesh/adapt/consistency_repair.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/adapt/mesh_gradation.hpp"
#include "asterism/mesh/adapt/unit_mesh.hpp"
#include "asterism/mesh/numerics/metric_algebra.hpp"
#include "asterism/mesh/support/infinity.hpp"
#include "asterism/mesh/support/parallel.hpp"
#include "asterism/mesh/support/work_weights.hpp"

namespace asterism::internal::adapting {
namespace {

constexpr std::size_t faces_checked_at_once = 2048;  // for a thread
// Degrees above the angle bound at which mending an angle aims.
constexpr double degrees_above = 4;
// Greatest length, in units, of an edge that a merge may make: twice the shortest length that is
// not merged.
constexpr double longest_edge = std::numbers::sqrt2;
// Number of directions, evenly spread over a full turn, in which a node is tried elsewhere.
constexpr std::size_t direction_count = 8;

// Returns the first place from `from` on, before `end`, whose flag is set; else `end`. Passes over
// eight flags at once: few faces are due in most rounds.
std::size_t next_set(const std::vector<char>& flags, std::size_t from, std::size_t end) {
  std::uint64_t eight = 0;
  for (; from + sizeof eight <= end; from += sizeof eight) {
    std::memcpy(&eight, flags.data() + from, sizeof eight);
    if (eight != 0) break;
  }
  while (from < end && flags[from] == 0) ++from;
  return from;
}

std::array<point, direction_count> find_directions() {
  std::array<point, direction_count> all;
  for (std::size_t k = 0; k < direction_count; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / direction_count;
    all[k] = {elementary::cos(angle), elementary::sin(angle)};
  }
  return all;
}

}  // namespace

consistency_repair::consistency_repair(editable_mesh& m, const repair_options& options)
    : m_(m),
      options_(options),
      tests_(m, options.angle_bound),
      aim_(cotangent_of(options.angle_bound + degrees_above)) {
  restart(false);
}

void consistency_repair::restart(bool others_pass) {
  active_.assign(m_.nodes().size(), others_pass ? 0 : 1);
  edges_agree_ = false;
  touched_.clear();
  report_ = {};
}

void consistency_repair::run() {
  for (std::size_t i = 0; i < options_.most_rounds; ++i) {
    if (options_.stop.is_requested()) return;
    const bool is_mended = !round();
    m_.charge_work(options_.stop);
    if (is_mended) return;
    ++report_.rounds;
  }
}

bool consistency_repair::is_active(vertex_index t) const {
  const face& f = m_.faces()[t];
  return active_[f.v[0]] + active_[f.v[1]] + active_[f.v[2]] > 0;
}

// Tests all active nodes once and mends their defects; returns true if anything had to be mended.
bool consistency_repair::round() {
  next_.assign(m_.nodes().size(), 0);
  report_.disagreeing = report_.low = 0;
  find_due_faces();
  if (!std::exchange(edges_agree_, false)) mend_edges();
  find_low_faces();
  visit(in_question_, 0, m_.faces().size(), [this](vertex_index t) {
    if (is_active(t)) check_angles(t);
  });
  active_ = next_;
  return report_.disagreeing + report_.low > 0;
}

void consistency_repair::mend_edges() {
  find_clear_edges();
  visit(in_question_, 0, m_.faces().size(), [this](vertex_index t) {
    for (std::size_t i = 0; i < 3 && m_.faces()[t].exists(); ++i)
      if (is_to_test(t, i)) check_edge(t, i);
  });
}

// True if an edge of a face is tested with this face, and has an active node at one of its two
// faces.
bool consistency_repair::is_to_test(vertex_index t, std::size_t i) const {
  const face& f = m_.faces()[t];
  const vertex_index s = f.next[i];
  return s != none && s >= t && f.segment[i] == none && (is_active(t) || is_active(s));
}

void consistency_repair::add_due_face(vertex_index t) {
  is_due_[t] = 1;
  for (const vertex_index s : m_.faces()[t].next)
    if (s != none) is_due_[s] = 1;
}

// Puts the edges and angles of a face in question, and the edges of its neighbours, if they are
// due.
void consistency_repair::question(vertex_index t) {
  in_question_[t] = is_due_[t];
  for (const vertex_index s : m_.faces()[t].next)
    if (s != none) in_question_[s] = is_due_[s];
}

// Marks a node that was changed in this round, or a neighbour of which was.
void consistency_repair::touch(vertex_index v) {
  if (std::exchange(next_[v], char{1}) != 0) return;
  touched_.push_back(v);
  face_list at;
  m_.around(v, at);
  for (const vertex_index t : at) question(t);
}

// Visits the faces around active nodes if these are few, else all faces.
void consistency_repair::find_due_faces() {
  constexpr std::ptrdiff_t few = 8;  // one node in this number
  is_due_.assign(m_.faces().size(), 0);
  in_question_ = is_due_;
  const auto active = std::count(active_.begin(), active_.end(), 1);
  if (few * active > static_cast<std::ptrdiff_t>(active_.size())) {
    for (vertex_index t = 0; t < m_.faces().size(); ++t)
      if (m_.faces()[t].exists() && is_active(t)) add_due_face(t);
    return;
  }
  face_list at;
  for (std::size_t v = 0; (v = next_set(active_, v, active_.size())) < active_.size(); ++v) {
    if (m_.nodes()[v].kind == node_kind::gone) continue;
    m_.around(static_cast<vertex_index>(v), at);
    for (const vertex_index t : at) add_due_face(t);
  }
}

// Calls act(t) for each face with a flag and an index from `begin` to before `end`, in order, those
// included that get one meanwhile.
template <class Act>
void consistency_repair::visit(const std::vector<char>& flags, std::size_t begin, std::size_t end,
                               const Act& act) {
  for (std::size_t t = begin; (t = next_set(flags, t, end)) < end; ++t)
    if (m_.faces()[t].exists()) act(static_cast<vertex_index>(t));
}

// Marks the edges that agree, which are nearly all edges and take most of a round's time, and puts
// the faces with other ones in question. Takes one stretch of faces after the other, so that their
// Voronoi vertices stay in the cache.
void consistency_repair::find_clear_edges() {
  constexpr std::size_t stretch = 65536;  // faces
  const std::size_t faces = m_.faces().size();
  clear_edges_.assign(faces, 0);
  centres_.resize(std::min(stretch, faces));
  for (std::size_t begin = 0; begin < faces; begin += stretch) {
    const std::size_t end = std::min(faces, begin + stretch);
    if (next_set(is_due_, begin, end) < end) find_clear_edges(begin, end);
  }
}

// Marks the edges that agree of the faces from `begin` to before `end`, in several threads, as no
// node or face changes meanwhile. Computes the Voronoi vertices of these faces once; those of faces
// across that are elsewhere, which are few, at each edge.
void consistency_repair::find_clear_edges(std::size_t begin, std::size_t end) {
  const auto each = [&](const auto& act) {
    parallel_chunks(
        end - begin, faces_checked_at_once,
        [&](std::size_t, std::size_t from, std::size_t to) { act(begin + from, begin + to); });
  };
  each([&](std::size_t from, std::size_t to) {
    visit(is_due_, from, to, [&](vertex_index t) { centres_[t - begin] = tests_.centre_of(t); });
  });
  const auto centre_of = [&](vertex_index t) {
    return t >= begin && t < end ? centres_[t - begin] : tests_.centre_of(t);
  };
  const auto agrees = [&](vertex_index t, std::size_t i) {
    const edge_quad q = tests_.quad_at(t, i);
    return clearance(centres_[t - begin], m_.at(q.d)) > least_clearance &&
           clearance(centre_of(m_.faces()[t].next[i]), m_.at(q.c)) > least_clearance;
  };
  each([&](std::size_t from, std::size_t to) {
    std::size_t tested = 0;
    visit(is_due_, from, to, [&](vertex_index t) {
      for (unsigned i = 0; i < 3; ++i) {
        if (!is_to_test(t, i)) continue;
        ++tested;
        if (agrees(t, i))
          clear_edges_[t] |= static_cast<unsigned char>(1U << i);
        else
          in_question_[t] = 1;
      }
    });
    m_.note_looked_at(work_weights::faces_for_edge_test * tested);
  });
}

// Puts the faces with an angle below the bound in question, with several threads.
void consistency_repair::find_low_faces() {
  if (options_.angle_bound <= 0) return;
  const auto find_low = [this](vertex_index t) {
    if (is_active(t) && tests_.is_low(t)) in_question_[t] = 1;
  };
  parallel_chunks(m_.faces().size(), faces_checked_at_once,
                  [&](std::size_t, std::size_t begin, std::size_t end) {
                    visit(is_due_, begin, end, find_low);
                  });
}

void consistency_repair::disagreed_at(const std::vector<vertex_index>& nodes) {
  constexpr double part = 0.5;
  next_.assign(m_.nodes().size(), 0);
  clip_distortion_at(nodes, part);
  for (const vertex_index v : nodes) active_[v] = 1;
  touched_.insert(touched_.end(), nodes.begin(), nodes.end());
}

void consistency_repair::changed_at(const std::vector<vertex_index>& nodes) {
  active_.resize(m_.nodes().size(), 0);
  for (const vertex_index v : nodes) active_[v] = 1;
}

std::size_t consistency_repair::add_at_low_faces() {
  std::vector<vertex_index> added;
  for (vertex_index t = 0; t < m_.faces().size(); ++t) {
    if (!m_.faces()[t].exists() || !tests_.is_low(t) || tests_.is_exempt(t)) continue;
    if (const auto made = add_at_shortest_edge(t)) added.push_back(*made);
  }
  changed_at(added);
  return added.size();
}

// Adds the node that makes an equilateral triangle with the shortest edge of the face, measured in
// the metric of an end, with the tensor of that end. The smallest angle is opposite to that edge.
// Adds nothing across a segment, or at less than half the edge's length from another node.
std::optional<vertex_index> consistency_repair::add_at_shortest_edge(vertex_index t) {
  constexpr double height = std::numbers::sqrt3 / 2, least = 0.5;  // of the edge's length
  const std::array<vertex_index, 3> v = m_.faces()[t].v;
  const auto opposite = [&](std::size_t i) { return m_.length(v[after(i)], v[before(i)]); };
  std::size_t shortest = 0;
  for (const std::size_t i : {1U, 2U})
    if (opposite(i) < opposite(shortest)) shortest = i;
  const node a = m_.at(v[after(shortest)]), b = m_.at(v[before(shortest)]);
  const double x = b.position.x - a.position.x, y = b.position.y - a.position.y;
  // The edge's normal in the metric, to its left and as long as the edge: the metric times the
  // edge, turned by a right angle, over the root of the determinant.
  const double part = height / a.root;
  const metric_tensor& q = a.metric;
  const point where{a.position.x + x / 2 - part * (q.m12 * x + q.m22 * y),
                    a.position.y + y / 2 + part * (q.m11 * x + q.m12 * y)};
  const located_place at = m_.locate(where, t, walls::segments);
  if (at.face == none || at.beyond) return std::nullopt;
  const double nearest = least * least * squared(q, x, y);
  for (const vertex_index u : m_.faces()[at.face].v) {
    const point& p = m_.at(u).position;
    if (squared(q, p.x - where.x, p.y - where.y) < nearest) return std::nullopt;
  }
  const auto made = m_.insert(at.face, where);
  if (!made) return std::nullopt;
  m_.at(*made).hint = a.hint;
  m_.set_metric(*made, q);
  return made;
}

void consistency_repair::check_edge(vertex_index t, std::size_t i) {
  const edge_quad q = tests_.quad_at(t, i);
  const bool is_as_found =
      !is_touched(q.a) && !is_touched(q.b) && !is_touched(q.c) && !is_touched(q.d);
  if (is_as_found && (clear_edges_[t] >> i & 1U) != 0) return;
  m_.note_looked_at(work_weights::faces_for_edge_test);
  const double now = tests_.worst_clearance(q);
  if (now > least_clearance) return;
  ++report_.disagreeing;
  for (const vertex_index v : {q.a, q.b, q.c, q.d}) touch(v);
  if (m_.can_flip(t, i)) {
    const double then = tests_.worst_clearance({q.d, q.c, q.a, q.b});
    const bool is_tie = std::abs(now) <= least_clearance && std::abs(then) <= least_clearance;
    if (is_tie && (move_off_circle(q.d, q.a, q.b, q.c) || move_off_circle(q.c, q.b, q.a, q.d)))
      return;
    if (then > now) {
      const vertex_index s = m_.faces()[t].next[i];
      m_.flip(t, i);
      for (const vertex_index made : {t, s}) {
        add_due_face(made);
        question(made);
      }
      ++report_.flips;
      if (then > least_clearance) return;
    }
  }
  constexpr double part = 0.7;
  clip_distortion_at({q.a, q.b, q.c, q.d}, part);
}

// Moves d away from the Voronoi vertex of the face a, b, c, where the four nodes are on one circle,
// as those of a square of a grid are: neither a flip nor equal tensors would give the edge ab a
// clearance. Returns false, and moves nothing, if d is not inside the domain or angles became
// worse.
bool consistency_repair::move_off_circle(vertex_index d, vertex_index a, vertex_index b,
                                         vertex_index c) {
  constexpr double part = 0.05;  // of the radius: a clearance of a tenth
  const node here = m_.at(d);
  const face_centre z = tests_.centre_of({a, b, c});
  if (here.kind != node_kind::free || !(z.squared_radius > 0)) return false;
  face_list at;
  m_.around(d, at);
  const double before = defect_at(at, infinity);
  const auto asked = options_.wanted(here.position);
  const point to{here.position.x + part * (here.position.x - z.at.x),
                 here.position.y + part * (here.position.y - z.at.y)};
  m_.move(d, to);
  if (asked && identical(*asked, here.metric))
    if (const auto there = options_.wanted(to)) m_.set_metric(d, *there);
  if (defect_at(at, infinity) > before ||
      !(tests_.worst_clearance({a, b, c, d}) > least_clearance)) {
    m_.at(d) = here;
    return false;
  }
  ++report_.moves;
  m_.neighbours(d, at);
  for (const vertex_index u : at) touch(u);
  return true;
}

void consistency_repair::check_angles(vertex_index t) {
  const std::array<vertex_index, 3> at = m_.faces()[t].v;
  if (options_.angle_bound <= 0 || !tests_.is_low(t) || tests_.is_exempt(t)) return;
  ++report_.low;
  for (const vertex_index v : at) touch(v);
  constexpr double part = 0.7;
  if (report_.rounds % 2 == 1)
    clip_distortion_at({at[0], at[1], at[2]}, part);
  else
    for (const vertex_index v : at) move_away(v);
  constexpr std::size_t rounds_without_merging = 6;
  if (report_.rounds < rounds_without_merging || m_.faces()[t].v != at) return;
  if (report_.rounds % 3 == 0 && merge_away(t)) return;
  follow_shape(t);
}

double consistency_repair::excess(const node& a, const node& b, const node& c) const {
  if (!turns_left(a.position, b.position, c.position)) return infinity;
  double sum = 0;
  for (const node* n : {&a, &b, &c}) {
    const double beyond = std::max(0.0, greatest_cotangent(n->metric, n->root, a, b, c) - aim_);
    sum += beyond * beyond;
  }
  return sum;
}

// Merges a node of a low triangle into the neighbour that leaves the least defect, if that is much
// less than the present one; returns true if it did.
bool consistency_repair::merge_away(vertex_index t) {
  constexpr double enough = 0.5;
  const double longest = longest_edge * options_.unit;
  // Largest number of neighbours of a node that is merged: trying one costs the square of that
  // number.
  constexpr std::size_t most_neighbours = 64;
  double best = 0;
  vertex_index from = none, into = none;
  face_list at, ring;
  for (const vertex_index v : m_.faces()[t].v) {
    if (!may_move(v)) continue;
    m_.around(v, at);
    const double now = defect_at(at, infinity);
    m_.neighbours(v, ring);
    if (ring.size() > most_neighbours) continue;
    for (const vertex_index w : ring) {
      if (!m_.can_merge(v, w, at)) continue;
      if (std::any_of(ring.begin(), ring.end(),
                      [&](vertex_index u) { return u != w && m_.length(w, u) > longest; }))
        continue;
      double then = 0;
      for (const vertex_index s : at) {
        const face& f = m_.faces()[s];
        const std::size_t i = f.corner_of(v);
        const vertex_index a = f.v[after(i)], b = f.v[before(i)];
        if (a != w && b != w) then += excess(m_.at(w), m_.at(a), m_.at(b));
      }
      if (!(then < enough * now && now - then > best)) continue;
      best = now - then;
      from = v;
      into = w;
    }
  }
  if (from == none) return false;
  m_.neighbours(from, ring);
  m_.merge(from, into);
  is_due_.assign(m_.faces().size(), 1);
  in_question_ = is_due_;
  ++report_.merges;
  for (const vertex_index u : ring) touch(u);
  return true;
}

// Moves the tensors of a low triangle's nodes towards the tensor in which it is equilateral, until
// the log distortion from it is at most `enough`.
void consistency_repair::follow_shape(vertex_index t) {
  constexpr double enough = 0.5;  // log 1.65: angles of 23 degrees and more
  const face& f = m_.faces()[t];
  const node &a = m_.at(f.v[0]), &b = m_.at(f.v[1]), &c = m_.at(f.v[2]);
  const double ux = b.position.x - a.position.x, uy = b.position.y - a.position.y;
  const double wx = c.position.x - a.position.x, wy = c.position.y - a.position.y;
  const double vx = wx - ux, vy = wy - uy;
  // A triangle is equilateral in the metric that is the inverse of the sum of e e^T over its edge
  // vectors e, and in multiples of that metric.
  const metric_tensor shape{uy * uy + wy * wy + vy * vy, -(ux * uy + wx * wy + vx * vy),
                            ux * ux + wx * wx + vx * vx};
  const double root = plain_root_of_determinant(shape);
  if (!(root > 0)) return;
  for (const vertex_index v : f.v) {
    const double factor = m_.at(v).root / root;
    metric_tensor goal{factor * shape.m11, factor * shape.m12, factor * shape.m22},
        own = m_.at(v).metric;
    const double apart = log_distortion(own, goal);
    if (!(apart > enough)) continue;
    // Clips by twice the excess: the clip takes half of it from each tensor, and the change of
    // `goal` is dropped.
    if (!clip_distortion(own, goal, std::max(0.0, 2 * enough - apart))) continue;
    m_.set_metric(v, own);
    touch(v);
    ++report_.alike;
  }
}

// Returns the defect of these faces: how far their angles are below the aim, which is a few degrees
// above the bound. Stops once the sum reaches `most`, and returns a number no less than that.
double consistency_repair::defect_at(const face_list& at, double most) const {
  double sum = 0;
  for (const vertex_index t : at) {
    const face& f = m_.faces()[t];
    sum += excess(m_.at(f.v[0]), m_.at(f.v[1]), m_.at(f.v[2]));
    if (!(sum < most)) break;
  }
  return sum;
}

double consistency_repair::longest_around(vertex_index v) const {
  face_list ring;
  m_.neighbours(v, ring);
  double longest = 0;
  for (const vertex_index u : ring) longest = std::max(longest, m_.length(v, u));
  return longest;
}

// True if the node may be moved, or merged into another one.
bool consistency_repair::may_move(vertex_index v) const {
  const node_kind kind = m_.at(v).kind;
  return kind == node_kind::free || (kind == node_kind::sliding && !holds_boundary_);
}

// Moves v to the place with the least defect, of several tried around it.
void consistency_repair::move_away(vertex_index v) {
  if (!may_move(v)) return;
  const node here = m_.at(v);
  face_list at;
  m_.around(v, at);
  double least = defect_at(at, infinity);
  const double most = std::max(longest_edge * options_.unit, longest_around(v));
  node best = here;
  const auto asked = options_.wanted(here.position);
  const bool is_wanted = asked && identical(*asked, here.metric);
  const unit_displacements unit = unit_circle(here.metric);
  static const std::array<point, direction_count> directions = find_directions();
  for (const double step : {0.3, 0.12, 0.04})
    for (const point& direction : directions) {
      const double length = options_.unit * step;
      const double x = length * direction.x, y = length * direction.y;
      point to{here.position.x + x * unit.first.x + y * unit.second.x,
               here.position.y + x * unit.first.y + y * unit.second.y};
      m_.at(v) = here;
      if (here.kind == node_kind::sliding) to = m_.on_segment(v, to);
      m_.move(v, to);
      if (is_wanted)
        if (const auto there = options_.wanted(to)) m_.set_metric(v, *there);
      const double defect = defect_at(at, least);
      if (!(defect < least)) continue;
      if (longest_around(v) > most) continue;
      least = defect;
      best = m_.at(v);
    }
  m_.at(v) = best;
  if (best.position == here.position) return;
  ++report_.moves;
  face_list ring;
  m_.neighbours(v, ring);
  for (const vertex_index u : ring) touch(u);
}

// Clips the tensors of all pairs of these nodes to `part` of the greatest log distortion of a pair.
void consistency_repair::clip_distortion_at(const std::vector<vertex_index>& nodes, double part) {
  adapting::clip_distortion_at(m_, nodes, part,
                               [this](vertex_index, vertex_index) { ++report_.alike; });
}

}  // namespace asterism::internal::adapting
