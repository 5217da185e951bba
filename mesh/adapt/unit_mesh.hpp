// SPDX-License-Identifier: MIT
//
// Makes a triangulation with edges of length one and triangles as equilateral as their sites'
// metrics allow: from nodes of the background, by splits, merges, flips and moves in turn.
//
// Each flip and each move lowers an energy, and the numbers of splits and merges are bounded, so
// the run ends. Works in doubles; the result is a proposal. Internal to mesh/adapt.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "asterism/mesh/adapt/editable_mesh.hpp"
#include "asterism/mesh/adapt/mesh_blocks.hpp"
#include "asterism/mesh/adapt/node_ring.hpp"
#include "asterism/mesh/adapt/shape_energy.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal::adapting {

// Function that returns the metric at a point; `hint` speeds up the next look-up near it
// (background_metric.hpp).
using metric_at = std::function<metric_tensor(const point& q, vertex_index& hint)>;

struct unit_mesh_options {
  // Number of nodes wanted; 0, the default, means the number that edges of length one need.
  std::size_t count = 0;
  std::size_t most_nodes = 1000000;
  cancellation stop;
};

// Function that returns whether a mesh may have a face with these corners.
using face_test = std::function<bool(const node& a, const node& b, const node& c)>;

// An edge and its length, which was computed when it was an edge of `face`.
struct measured_edge {
  double length = 0;
  vertex_index a = none, b = none, face = none;
};

class unit_mesh_remesher {
 public:
  unit_mesh_remesher(editable_mesh& m, unit_mesh_options options)
      : m_(m), options_(std::move(options)) {}

  // Makes a new mesh in this metric, to be refitted later. `seeds` are the places of the first
  // nodes, ordered so that near ones follow each other.
  void run(metric_at field, const std::vector<point>& seeds);
  // Changes the present mesh to fit another metric.
  void refit(metric_at field);
  // Changes the present mesh, whose nodes have the tensors of this field, for better shapes and
  // fewer nodes, whatever the lengths of its edges: merges nodes where the mean energy of shape
  // stays nearly as low, flips edges and moves free nodes. Nothing is split, no node on a segment
  // changes, and every face that is made passes the test `allowed`.
  void improve(metric_at field, face_test allowed);
  // Splits the longest edges, or merges the shortest, until the number of nodes is as wanted.
  void meet_count(metric_at field);
  // Splits edges that are much too long in this metric and not short in the mesh's own, longest
  // first, until the mesh has `most_nodes` nodes. Returns the nodes of faces that have changed;
  // none where no edge was split.
  std::vector<vertex_index> split_left_long(metric_at wanted, std::size_t most_nodes);
  // Splits a few edges of length 1.5 and more in the metric, longest first. Where the metric turns
  // fast more nodes than wanted would be needed to bring all edges near length one. Returns the
  // nodes of faces that have changed.
  std::vector<vertex_index> split_outliers(metric_at wanted);
  // Frees the states of faces and nodes and the queues of changes to try, which the next change
  // makes anew: other steps need the room.
  void release();
  // Returns the length, in the metric, to which edges were fitted.
  double unit() const { return unit_; }

 private:
  static constexpr std::size_t no_limit = ~std::size_t{0};

  struct length_limits {
    double wanted, own;  // in the metric wanted, the mesh's own
  };

  std::vector<vertex_index> split_longer(metric_at wanted, const length_limits& limits,
                                         std::size_t most_nodes);

  // Effort of a fit: least number of rounds, sweeps of moves in each, greatest length of an edge
  // that is not split (units) in the first round and in later ones, and the share by which the
  // count may be off in the end.
  struct effort {
    int rounds, sweeps;
    double longest_at_first, longest, tolerable;
  };
  void fit(const effort& how);
  // True if so few nodes are wanted that a first mesh fitted in one round of one sweep loses the
  // finest parts of a metric more often.
  bool wants_few() const {
    constexpr std::size_t few = 1000;
    return options_.count < few;
  }
  void correct_crowding(double log_ratio, double power);
  double log_of_count() const;
  bool is_crowded(vertex_index t, const node& there) const;
  std::pair<double, std::size_t> measured_area() const;
  double boundary_length() const;
  double unit_for_boundary(double area) const;
  void measure_unit();
  void meet_count();
  // True if the run is to stop; called between passes, and charges their work.
  bool is_stopped() {
    m_.charge_work(options_.stop);
    return options_.stop.is_requested();
  }
  void measure(vertex_index v) { m_.set_metric(v, field_(m_.at(v).position, m_.at(v).hint)); }
  // Returns the energy of a face's shape, without its size; computed once for an unchanged face.
  double shape_of(vertex_index t) {
    double& shape = state_of(t).shape;
    if (shape < 0) shape = computed_shape(m_.faces()[t]);
    return shape;
  }
  double computed_shape(const face& f) const {
    return shape_energy(m_.at(f.v[0]), m_.at(f.v[1]), m_.at(f.v[2]), 0);
  }
  // Returns the energy of a face, size included.
  double energy(vertex_index t) { return with_size(m_.faces()[t], shape_of(t)); }
  // Returns the energy of a face without keeping that of its shape, for tests by several threads.
  double present_energy(vertex_index t) const {
    const double known = t < face_states_.size() ? face_states_[t].shape : shape_not_known;
    return with_size(m_.faces()[t], known < 0 ? computed_shape(m_.faces()[t]) : known);
  }
  // Returns the energy of a face whose shape has this energy.
  double with_size(const face& f, double shape) const {
    return unit_ <= 0 ? shape
                      : shape + size_energy(m_.at(f.v[0]), m_.at(f.v[1]), m_.at(f.v[2]), unit_);
  }
  // Forgets all computed energies, and all tests in vain. Must be called after a change of the mesh
  // from outside.
  void forget_shapes();

  // Functions defined in unit_mesh_blocks.cpp.
  struct block_state;
  void begin_block(const unit_mesh_remesher& whole, const mesh_blocks::block& part);
  block_state end_block(const unit_mesh_remesher& whole, const mesh_blocks::block& part,
                        std::size_t done);
  std::size_t join(mesh_blocks& blocks, const std::vector<block_state>& states);
  using block_work = std::function<std::size_t(unit_mesh_remesher& part, std::size_t block)>;
  // Function that returns the number of changes that it expects in each block of a cut.
  using block_preparation = std::function<std::vector<std::size_t>(const mesh_blocks&)>;
  std::size_t in_blocks(const block_work& work, const block_preparation& prepare = {});
  bool split_all_long(double longest);
  void merge_and_move(double shortest, int sweeps);
  void move_all(int sweeps);
  // True if the node was inside a block of some cut so far: changes on the frames skip it.
  bool was_inside(vertex_index v) const { return v < is_inside_.size() && is_inside_[v] != 0; }

  // Functions defined in unit_mesh_seeds.cpp.
  void seed(const std::vector<point>& seeds);
  std::optional<vertex_index> insert_seed(const located_place& at, node& there);
  std::optional<vertex_index> insert_on_side(vertex_index t, std::size_t edge, node& there);
  class metrics_ahead;
  std::vector<point> insert_seeds(std::span<const point> seeds, metrics_ahead* known = nullptr);
  std::vector<point> insert_in_blocks(const std::vector<point>& seeds);

  // Functions defined in unit_mesh_improvement.cpp.
  struct worthwhile_merge;
  std::optional<worthwhile_merge> best_merge(vertex_index v, double mean);
  double mean_energy();
  std::size_t merge_where_better();

  // Functions defined in unit_mesh_lengths.cpp.
  using face_numbers = std::vector<vertex_index>;
  std::size_t split_long(double longest, std::size_t most = no_limit,
                         const face_numbers* looked_at = nullptr);
  std::optional<node> node_on_edge(const measured_edge& e, vertex_index t, std::size_t edge) const;
  std::vector<std::optional<node>> nodes_on_edges(std::span<const measured_edge> edges) const;
  bool is_crowded_on_edge(const measured_edge& e, vertex_index t, std::size_t edge,
                          const node& there) const;
  std::size_t merge_short(double shortest, std::size_t most = no_limit);
  // Outcome of the test of an edge: which end is to be merged into which. No merge is wanted where
  // the edge is not short, or an end of it is gone or was inside a block.
  enum class merging : unsigned char { not_wanted, in_vain, first_into_second, second_into_first };
  // True if both ends of the edge are there, and may be merged by the present cut into blocks.
  bool is_mergeable(const measured_edge& e) const {
    return m_.at(e.a).kind != node_kind::gone && m_.at(e.b).kind != node_kind::gone &&
           !was_inside(e.a) && !was_inside(e.b);
  }
  // True if no face at the ends of the edge has changed since this change.
  bool is_unchanged(const measured_edge& e, std::uint32_t since) {
    return node_state_of(e.a).change <= since && node_state_of(e.b).change <= since;
  }
  bool is_known_in_vain(const measured_edge& e, std::vector<measured_edge>::const_iterator& next);
  bool is_merge_good(vertex_index v, vertex_index w, double longest) const;
  merging test_merge(const measured_edge& e, double shortest) const;
  std::vector<merging> test_merges(std::span<const measured_edge> edges, double shortest) const;
  void merge(vertex_index v, vertex_index w);

  // Functions defined in unit_mesh_flips.cpp.
  void flip_all();
  void smooth();
  void settle_around(vertex_index v);
  bool flip_if_better(vertex_index t, std::size_t edge);
  bool is_near(const node& n, const point& goal) const;
  bool try_move(vertex_index v, const point& to, const face_list& at, const node_ring& ring,
                double most, node_ring::energies& then);
  void note_change(vertex_index t);
  void note_change_of_all();
  bool is_allowed(const node& a, const node& b, const node& c) const {
    return !allowed_ || allowed_(a, b, c);
  }

  editable_mesh& m_;
  metric_at field_;
  unit_mesh_options options_;
  face_test allowed_;  // empty: all faces are
  // Least part of the energy around a node that a move must gain to be made: each move queues the
  // neighbours for moves as well. Chosen by experiment.
  double least_gain_ = 1e-3;
  double unit_ = 1;  // 0 where size does not count
  // Factor by which the unit exceeds that of equilateral triangles for the same number of nodes;
  // adjusted from round to round.
  double crowding_ = 1.05;
  static constexpr double shape_not_known = -1;
  static constexpr std::uint32_t never = ~std::uint32_t{0};
  struct face_state {
    double shape = shape_not_known;
    std::uint32_t change = 0;  // number of the face's last change
    bool is_due = false;       // its edges are to be tested for flips
  };
  struct node_state {
    std::uint32_t change = 0;  // number of the last change of a face at the node
    bool is_restless = false;  // it is to be tested for a move
  };
  face_state& state_of(vertex_index t) {
    if (face_states_.size() <= t) make_states();
    return face_states_[t];
  }
  node_state& node_state_of(vertex_index v) {
    if (node_states_.size() <= v) make_states();
    return node_states_[v];
  }
  // Makes states for all nodes and faces of the mesh.
  void make_states();
  // True if flips in vain are remembered: in blocks, and in meshes that have none. In a large mesh,
  // where most flips are tested in blocks, the list would take longer to make than it saves.
  bool remembers_flips() const { return !mesh_blocks::are_worth_it(m_); }
  // Returns the numbers of changes at which flips of a face's edges were tested in vain.
  std::array<std::uint32_t, 3>& in_vain_at(vertex_index t) {
    if (flips_in_vain_.size() <= t) flips_in_vain_.resize(m_.faces().size(), {never, never, never});
    return flips_in_vain_[t];
  }
  bool is_flip_in_vain(vertex_index t, std::size_t edge, vertex_index s);
  void note_flip_in_vain(vertex_index t, std::size_t edge, vertex_index s, std::size_t beyond);
  std::vector<face_state> face_states_;
  std::vector<node_state> node_states_;
  // For each edge of a face the number of changes of the face across when a flip of the edge was
  // tested in vain. Both faces of an edge have the test. May be shorter than the list of faces.
  std::vector<std::array<std::uint32_t, 3>> flips_in_vain_;
  std::uint32_t changes_ = 0;      // of faces, so far
  std::vector<vertex_index> due_;  // faces that are, in order
  // Faces changed since the list was made, in the order of the changes; none where it is not
  // wanted.
  std::optional<face_numbers> changed_;
  // Edges that merge_short() tested in vain, shortest first, the number of changes when that call
  // began, and its unit.
  std::vector<measured_edge> merges_in_vain_;
  std::uint32_t merges_tested_at_ = 0;
  double merges_tested_by_ = 0;
  std::vector<char> is_inside_;  // nodes that were inside a block of a cut so far
  unsigned cuts_ = 0;            // number of cuts into blocks so far
};

}  // namespace asterism::internal::adapting
