// SPDX-License-Identifier: MIT
#include "asterism/mesh/delivery/local_adaptation.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/adapt/consistency_repair.hpp"
#include "asterism/mesh/adapt/editable_mesh.hpp"
#include "asterism/mesh/adapt/mesh_gradation.hpp"
#include "asterism/mesh/adapt/unit_mesh.hpp"
#include "asterism/mesh/adapt/vertex_smoothing.hpp"
#include "asterism/mesh/delivery/audited_mesh.hpp"
#include "asterism/mesh/delivery/constant_metric_fallback.hpp"
#include "asterism/mesh/delivery/fitting_goal.hpp"
#include "asterism/mesh/delivery/restore_tensors.hpp"
#include "asterism/mesh/gradation/nodal_gradation.hpp"
#include "asterism/mesh/metric/background_metric.hpp"
#include "asterism/mesh/search/hilbert_order.hpp"
#include "asterism/mesh/support/free_memory.hpp"
#include "asterism/mesh/support/parallel.hpp"
#include "asterism/mesh/support/shared_count.hpp"

namespace asterism::internal {
namespace {

using namespace adapting;

// Distortions allowed over an edge of length one: `background` on the graph of the background, for
// the metric in which the mesh is made, and `mesh` on the graph of the mesh, for the metric
// delivered. Chosen by experiment (docs/design/adaptation.md). Later steps of the ladder are used
// where the first did not lead to agreement.
struct strictness {
  double background, mesh;
  // Distortion in place of `mesh` where that value changes nearly all tensors, or where stars need
  // many more edges than the unit mesh has, so that nodes must be merged: where a metric turns
  // fast, stars agree only at a smaller distortion.
  double turning;
};
constexpr std::array<strictness, 4> ladder = {
    {{4, 2.5, 2}, {3, 1.7, 1.7}, {1.8, 1.4, 1.4}, {1.25, 1.15, 1.15}}};
// Largest number of audits of one mesh; each follows the mending of the findings before.
constexpr int most_repairs = 12;
constexpr std::size_t every_finding = std::numeric_limits<std::size_t>::max();

class local_adaptation {
 public:
  explicit local_adaptation(const adaptation_job& job)
      : domain_(job.shape),
        field_(job.field),
        options_(job.options),
        start_(job.start),
        wanted_(job.wanted),
        goal_(job.shape, job.wanted, job.count, job.options.max_sites),
        is_field_itself_(job.is_field_itself),
        made_(job.shape, options_) {}

  std::optional<mesh_outcome> run() {
    if (goal_.count() < 1) return std::nullopt;
    order_places();
    options_.stop.expect(goal_.count());
    // Filters noise only of metrics given at nodes: a formula has none. With more sites, turns from
    // node to node are mostly features, and errors of fine waves grow if these are filtered
    // (docs/design/adaptation.md).
    if (is_field_itself_ && goal_.wants_few()) goal_.leave_out_noise(options_.stop);
    const cancellation whole = options_.stop;
    constexpr double for_ladder = 0.8;  // of the work; what is left is for one metric
    options_.stop = whole.part(for_ladder);
    if (!climb_ladder()) return std::nullopt;
    constexpr double for_nodes = 0.5;  // of the work that is left
    options_.stop = whole.part(for_nodes);
    if (!is_certified() && !stop_reason()) add_nodes_to_nearest();
    options_.stop = whole;
    if (!is_certified() && !stop_reason()) adapt_in_one_metric();
    if (is_certified()) meet_count(start_);
    if (const auto why = stop_reason(); why && !is_certified() && made_.report())
      return stopped(*why);
    if (!is_certified()) return std::nullopt;
    return conclude();
  }

 private:
  // Makes meshes by stricter and stricter steps until one is certified. Tries a step as long as the
  // meshes made so far have, together, no more nodes than the limit for one mesh: a step's cost is
  // proportional to its nodes. Returns false where a step makes no mesh, with work left.
  bool climb_ladder() {
    std::size_t made = 0;
    goal_.make_room_where_needed(options_.stop);
    for (std::size_t step = 0; step < ladder.size() && made <= options_.max_sites; ++step) {
      bool is_made = attempt(start_, ladder[step]);
      if (give_up_room_at_chords(is_made)) is_made = attempt(start_, ladder[step]);
      if (std::exchange(wants_room_, false)) {
        goal_.make_room_for_segments(0, options_.stop);
        is_made = attempt(start_, ladder[step]);
      }
      if (is_made && !is_certified() && take_all_room()) is_made = attempt(start_, ladder[step]);
      if (!is_made) return is_overworked();
      made += std::max(goal_.count(), made_.subject().sites.size());
      if (is_certified() || stop_reason() || is_overworked()) break;
      // Skips to the strictest step where mending made no progress: a slightly stricter one does
      // not help.
      if (std::exchange(repair_gave_up_, false)) step = std::max(step, ladder.size() - 2);
    }
    return true;
  }

  std::optional<std::string> stop_reason() const { return options_.stop.told(); }

  bool is_certified() const { return made_.is_certified(); }

  // True if the work limit of this run is reached.
  bool is_overworked() const { return !(options_.stop.units_left() > 0); }

  static double off_count(std::size_t sites, std::size_t wanted) {
    return std::abs(elementary::log(static_cast<double>(sites) / static_cast<double>(wanted)));
  }

  // Makes the mesh once more if mending has changed the number of sites by much, with the number
  // wanted corrected by the difference. The new mesh stays if it is nearer to the number wanted.
  void meet_count(const mesh& start) {
    constexpr double tolerable = 0.04;
    const std::size_t wanted = goal_.count(), got = made_.subject().sites.size();
    if (off_count(got, wanted) <= tolerable || stop_reason() || is_overworked()) return;
    const audited_mesh before = made_;
    const double length_factor = length_factor_;
    goal_.set_count(wanted * wanted / got);
    const bool made = attempt(start, ladder[0]);
    if (made && is_certified() &&
        off_count(made_.subject().sites.size(), wanted) < off_count(got, wanted))
      return;
    made_ = before;
    length_factor_ = length_factor;
  }

  // Orders the places of the background along a space-filling curve.
  void order_places() {
    seeds_ = wanted_.places();
    sort_along_curve(std::span(seeds_), domain_.box());
  }

  // Goes back to the metric without room at chords if no mesh was certified with it, since fewer
  // vertices are wanted than the room needs. Returns whether it did.
  bool give_up_room_at_chords(bool is_made) {
    const bool is_kept = stop_reason() || is_overworked() || (is_made && is_certified());
    if (!is_kept) return goal_.give_up_room_at_chords();
    goal_.keep_room_at_chords();
    return false;
  }

  bool take_all_room() {
    return !stop_reason() && !is_overworked() && goal_.take_all_room(options_.stop);
  }

  // Returns the field as a function that charges its searches to the mesh.
  static metric_at field_by(const background_metric& field, const editable_mesh& m) {
    return [&field, &m](const point& q, vertex_index& hint) {
      std::size_t looked_at = 0;
      const metric_tensor there = field.at(q, hint, looked_at);
      m.note_looked_at(looked_at);
      return there;
    };
  }

  std::optional<metric_tensor> wanted_at(const point& q) const {
    const auto there = field_.at(q);
    return there ? std::optional(there.value()) : std::nullopt;
  }

  // Makes room to remember the metrics wanted at so many nodes, and at a few more: a list that
  // grows would double.
  void make_room_for_lookups(std::size_t nodes) {
    constexpr std::size_t part = 64;  // of the nodes: repairs and splits add fewer
    if (looked_up_.capacity() < nodes) looked_up_.reserve(nodes + nodes / part);
    resize_in_threads(looked_up_, nodes);
  }

  // Returns the metric wanted at a node, remembered from the last time unless the node has moved.
  // Several threads may call it for different nodes.
  std::optional<metric_tensor> wanted_of(const editable_mesh& m, vertex_index v) {
    const point& q = m.at(v).position;
    std::optional<site>& last = looked_up_[v];
    if (last && last->position == q) return last->metric;
    // The field may search the same triangles.
    wanted_.begin_near(q, m.at(v).hint);
    const auto there = wanted_at(q);
    if (there) last = site{q, *there};
    return there;
  }

  // Sets the nodes' tensors to those interpolated on the background: the wanted metric except for
  // rounding, and computed faster.
  void take_interpolated(editable_mesh& m) const {
    const metric_at fitted = field_by(goal_.metric(), m);
    m.each_node([&](vertex_index v) { m.set_metric(v, fitted(m.at(v).position, m.at(v).hint)); });
  }

  // Sets the node's tensor to that of the fitted metric where it differs from the wanted metric;
  // both are interpolated by the same operations.
  void take_other(editable_mesh& m, vertex_index v) const {
    std::size_t looked_at = 0;
    const auto without =
        goal_.metric().where_other(wanted_, m.at(v).position, m.at(v).hint, looked_at);
    m.note_looked_at(looked_at);
    if (without) m.set_metric(v, *without);
  }

  // Sets the nodes' tensors to the wanted metric there, or to that of the fitted metric. Returns
  // false where the field fails.
  bool take_wanted(editable_mesh& m) {
    std::atomic<bool> is_known = true;
    make_room_for_lookups(m.nodes().size());
    m.each_node([&](vertex_index v) {
      const auto there = wanted_of(m, v);
      if (!there) return is_known.store(false);
      m.set_metric(v, *there);
      if (goal_.is_other()) take_other(m, v);
    });
    return is_known;
  }

  // Makes the mesh and its audit in made_. Returns false where the mesh cannot be made within the
  // work that is left.
  bool attempt(const mesh& start, const strictness& how) {
    edges_agree_ = false;
    auto built = editable_mesh::build(domain_, start);
    if (!built) return false;
    editable_mesh m = std::move(built).value();
    unit_mesh_options making;
    making.count = goal_.count();
    // Limits the number of nodes that splitting may reach: if edges are still too long with that
    // many, the metric is too thin for splitting to end.
    constexpr std::size_t times_as_many = 4, at_least = 1000;
    making.most_nodes = std::min(options_.max_sites,
                                 times_as_many * goal_.count() + at_least + start_.sites.size());
    making.stop = options_.stop;
    unit_mesh_remesher maker(m, making);
    make_first(m, maker, how.background);
    // Merges the shortest edges, measured in the metric of the nodes, where splits have added too
    // many nodes: a metric that turns fast needs more splits. Skipped where many nodes are given,
    // as ends of chords are: given nodes may be nearer to each other than the metric wants, and
    // need the nodes that splits add beside them.
    constexpr double tolerable = 0.015;
    if (!fit_to_own(m, maker, how, making.most_nodes)) return false;
    if (off_count(m.count(), goal_.count()) > tolerable && !stop_reason() && !are_many_given(m)) {
      edges_agree_ = false;
      const background_metric own = field_of(m);
      maker.meet_count(field_by(own, m));
      if (is_overworked()) return false;
      look_up_anew(m, wanted_);
      if (!take_wanted(m)) return false;
      grade_mesh(m, how.turning, maker.unit(), options_.stop);
    }
    length_factor_ = maker.unit();
    if (is_overworked()) return false;
    deliver(m, maker);
    return made_.report() != nullptr;
  }

  // Makes the first mesh, in the metric graded on the background. That is not kept: the mesher gets
  // another metric before it changes the mesh again.
  void make_first(const editable_mesh& m, unit_mesh_remesher& maker, double distortion) const {
    const background_metric background = goal_.graded(distortion, options_.stop);
    maker.run(field_by(background, m), seeds_);
  }

  // True if at least a quarter of the nodes are vertices of the domain, which stay where they are.
  static bool are_many_given(const editable_mesh& m) {
    constexpr std::ptrdiff_t part = 4;
    const auto given = std::count_if(m.nodes().begin(), m.nodes().end(),
                                     [](const node& n) { return n.kind == node_kind::given; });
    return part * given > static_cast<std::ptrdiff_t>(m.count());
  }

  // Grades the nodes' tensors on the mesh's graph. Returns the distortion that was used.
  double grade_as_needed(editable_mesh& m, const strictness& how, double unit) const {
    constexpr double changed = 0.1;        // log distortion: lengths by a tenth
    constexpr std::size_t nearly_all = 4;  // one node in this number may be unlike
    std::vector<metric_tensor> before;
    resize_in_threads(before, m.nodes().size());
    m.each_node([&](vertex_index v) { before[v] = m.at(v).metric; });
    grade_mesh(m, how.mesh, unit, options_.stop);
    shared_count alike;
    m.each_node([&](vertex_index v) {
      if (!(log_distortion(before[v], m.at(v).metric) > changed)) alike.add(1);
    });
    if (nearly_all * alike.take() > m.count()) return how.mesh;
    grade_mesh(m, how.turning, unit, options_.stop);
    return how.turning;
  }

  // Fits the mesh to the wanted metric as graded on its own graph, and splits the edges that are
  // still long. Returns false where the wanted metric fails, or the work limit is reached.
  bool fit_to_own(editable_mesh& m, unit_mesh_remesher& maker, const strictness& how,
                  std::size_t most_nodes) {
    if (is_field_itself_)
      take_interpolated(m);
    else if (!take_wanted(m))
      return false;
    const double distortion = grade_as_needed(m, how, maker.unit());
    const background_metric own = field_of(m);
    maker.refit(field_by(own, m));
    if (is_overworked()) return false;
    look_up_anew(m, wanted_);
    if (!take_wanted(m)) return false;
    grade_mesh(m, distortion, maker.unit(), options_.stop);
    split_left_long(m, maker, most_nodes);
    return true;
  }

  repair_options asked_of_agreement(double unit) const {
    repair_options agree;
    agree.angle_bound = options_.angle_bound;
    agree.unit = unit;
    agree.stop = options_.stop;
    agree.wanted = [this](const point& q) { return wanted_at(q); };
    return agree;
  }

  // Splits edges that are still too long for stars to agree, which the unit mesh left.
  void split_left_long(editable_mesh& m, unit_mesh_remesher& maker, std::size_t most_nodes) {
    repair_options agree = asked_of_agreement(maker.unit());
    // Bounds the rounds: these are enough to find the edges that stars need. Stars that still
    // disagree are repaired when the mesh is delivered.
    agree.most_rounds = 12;
    agree.angle_bound = 0;  // low angles are mended then, too
    constexpr int rounds = 3;
    const metric_at wanted = field_by(wanted_, m);
    consistency_repair agreeing(m, agree);
    for (int i = 0; i < rounds && !stop_reason(); ++i) {
      agreeing.run();
      const std::vector<vertex_index> changed = maker.split_left_long(wanted, most_nodes);
      edges_agree_ = changed.empty() && agreeing.report().disagreeing == 0;
      if (changed.empty()) return;
      agreeing.changed_at(changed);
    }
  }

  // Clips tensors until the mesh is certified, then restores the wanted ones where that is
  // possible. A mesh whose edges agree is nearly always certified. So the first audit follows the
  // restoration; one precedes it only if the restored mesh is not certified.
  void deliver(editable_mesh& m, unit_mesh_remesher& maker) {
    const repair_options agree = asked_of_agreement(length_factor_);
    consistency_repair agreeing(m, agree);
    if (std::exchange(edges_agree_, false)) agreeing.edges_agree();
    agreeing.run();
    constexpr std::size_t very_few = 100;  // one node in this number
    wants_room_ = !goal_.has_room() &&
                  very_few * (agreeing.report().disagreeing + agreeing.report().low) > m.count() &&
                  goal_.may_want_room();
    if (wants_room_) return;
    if (!stop_reason() && !are_many_given(m)) {
      agreeing.changed_at(maker.split_outliers(field_by(wanted_, m)));
      agreeing.run();
    }
    maker.release();
    settle(m, agreeing);
    constexpr std::size_t few = 20;  // one node in this number
    const std::size_t left = agreeing.report().disagreeing + agreeing.report().low;
    if (few * left <= m.nodes().size()) {
      if (give_back(m, agreeing, left == 0)) return;
    }
    mend(m, agreeing);
    if (!is_certified()) return;
    const audited_mesh certified = made_;
    if (!give_back(m, agreeing)) made_ = certified;
  }

  // Moves the nodes of a mesh whose edges agree to places where more nodes can have their wanted
  // tensors.
  void settle(editable_mesh& m, consistency_repair& agreeing) {
    if (agreeing.report().disagreeing + agreeing.report().low > 0 || options_.angle_bound <= 0)
      return;
    vertex_smoothing settled(m, options_.angle_bound, length_factor_, field_by(wanted_, m));
    if (settled.is_in_vain()) return made_.leave_unbounded();  // there are many then
    settled.run(options_.stop);
    bound_gaps(m, agreeing, options_.stop);
  }

  // Clips tensors until the audit of the mesh has no finding.
  void mend(editable_mesh& m, consistency_repair& agreeing) {
    constexpr int most_in_vain = 3, most_since_least = 4;
    std::size_t least = every_finding;
    int in_vain = 0, since_least = 0;
    for (int audits = 0; audits < most_repairs && !is_overworked(); ++audits) {
      made_.take(m);
      made_.judge(made_.subject().sites.size());
      if (is_certified() || stop_reason() || is_overworked()) return;
      const std::size_t left = made_.report()->total_found();
      keep_if_nearest(m, left);
      const bool are_many = 20 * left > made_.subject().sites.size();
      in_vain = are_many && 10 * left > 9 * least ? in_vain + 1 : 0;
      since_least = left < least ? 0 : since_least + 1;
      if (since_least == most_since_least) return;
      least = std::min(least, left);
      repair_gave_up_ = in_vain == most_in_vain;
      if (repair_gave_up_) return;
      const std::vector<node_list> found = made_.nodes_found();
      if (found.empty()) return;
      for (const node_list& at : found) agreeing.disagreed_at(at);
      agreeing.run();
    }
  }

  // Keeps the mesh if it has few findings, and fewer than the meshes before.
  void keep_if_nearest(const editable_mesh& m, std::size_t left) {
    constexpr std::size_t few = 100;  // one site in this number
    if (few * left > made_.subject().sites.size() || (nearest_ && left >= nearest_->left)) return;
    nearest_.emplace(nearly_certified{m, left, length_factor_});
  }

  // Mends the mesh that had the fewest findings by new nodes at its low angles. A face on a short
  // segment whose third node is far away has one, whatever its tensors, until there is a node
  // between. Leaves the outcome as it was if the mesh is not certified in the end.
  void add_nodes_to_nearest() {
    constexpr int most_times = 4;
    if (!nearest_ || options_.angle_bound <= 0) return;
    const audited_mesh before = made_;
    editable_mesh m = std::move(nearest_->made);
    const double length_factor = std::exchange(length_factor_, nearest_->length_factor);
    const repair_options agree = asked_of_agreement(length_factor_);
    consistency_repair agreeing(m, agree);
    for (int i = 0; i < most_times && !is_certified() && !stop_reason(); ++i) {
      if (is_overworked() || m.count() >= options_.max_sites) break;
      if (agreeing.add_at_low_faces() == 0) break;
      agreeing.run();
      mend(m, agreeing);
    }
    if (is_certified() && made_.subject().sites.size() <= options_.max_sites) {
      const audited_mesh certified = made_;
      if (!give_back(m, agreeing)) made_ = certified;
      return;
    }
    made_ = before;
    length_factor_ = length_factor;
  }

  // Restores the wanted tensors at the nodes where the auditor accepts them. Takes whether all
  // edges and angles pass their tests. Returns whether the resulting mesh is certified.
  bool give_back(editable_mesh& m, consistency_repair& agreeing, bool all_pass = false) {
    std::vector<metric_tensor> tensors(m.nodes().size());
    std::atomic<bool> is_known = true;
    make_room_for_lookups(m.nodes().size());
    m.each_node([&](vertex_index v) {
      const auto there = wanted_of(m, v);
      if (!there) return is_known.store(false);
      tensors[v] = *there;
    });
    if (!is_known) return false;
    free_memory(looked_up_);  // audits need the room
    return internal::give_back(m, std::move(tensors), options_, agreeing, all_pass, made_);
  }

  // Makes the mesh in one metric for all sites, of the wanted metric's complexity, in which stars
  // agree whatever the sites (docs/math/delivered-metric.md), and restores wanted tensors. Leaves
  // the outcome as it was if that is not certified: an angle may be low, or a limit met.
  void adapt_in_one_metric() {
    const auto metric = one_metric_for(wanted_, start_);
    if (!metric) return;
    const auto made = mesh_in_one_metric(domain_, *metric, options_, goal_.count());
    if (!made) return;
    auto built = editable_mesh::build(domain_, made->made);
    if (!built) return;
    const audited_mesh before = made_;
    const double length_factor = std::exchange(length_factor_, made->length_factor);
    editable_mesh m = std::move(built).value();
    const editable_mesh alike = m;
    const repair_options agree = asked_of_agreement(length_factor_);
    consistency_repair agreeing(m, agree);
    if (give_back(m, agreeing)) return;
    made_.take(alike);
    made_.judge(every_finding);
    if (is_certified()) return;
    made_ = before;
    length_factor_ = length_factor;
  }

  mesh_outcome counted() const {
    mesh_outcome outcome;
    outcome.result = made_.subject();
    outcome.sites = outcome.result.sites.size();
    outcome.triangles = outcome.result.triangles.size();
    outcome.splits = outcome.result.boundary.size() - domain_.segments.size();
    outcome.inserted = outcome.sites - domain_.vertices.size() - outcome.splits;
    return outcome;
  }

  mesh_outcome stopped(const std::string& why) const {
    mesh_outcome outcome = counted();
    outcome.stopped = true;
    outcome.ended.how = ending::stopped;
    outcome.ended.stopped_because = why;
    return outcome;
  }

  mesh_outcome conclude() const {
    mesh_outcome outcome = counted();
    outcome.delivered.emplace().length_factor = length_factor_;
    outcome.complete = true;
    outcome.ended.how = ending::complete;
    outcome.ended.max_sites = options_.max_sites;
    outcome.ended.sites = outcome.sites;
    outcome.audited = std::make_shared<const past_audit>(made_.last_audit());
    const audit_report& report = outcome.audited->report;
    for (const vertex_index v : report.exempt_corners)
      outcome.exempt.push_back({v, options_.angle_bound});
    for (const vertex_index t : report.exempt_triangles)
      outcome.exempt_triangles.push_back(outcome.result.triangles[t]);
    return outcome;
  }

  // A mesh with findings.
  struct nearly_certified {
    editable_mesh made;
    std::size_t left = 0;  // findings
    double length_factor = 1;
  };

  const domain& domain_;
  const metric_field& field_;
  mesh_options options_;  // with the work that the step at hand may do
  const mesh& start_;
  const background_metric& wanted_;
  fitting_goal goal_;  // metric and count that the mesh is made for
  bool is_field_itself_;
  std::vector<point> seeds_;
  std::vector<std::optional<site>> looked_up_;  // metric wanted of each node, where it was
  double length_factor_ = 1;
  bool edges_agree_ = false;     // of the mesh that is being made
  bool wants_room_ = false;      // angles beside short segments were low
  bool repair_gave_up_ = false;  // mending of the last mesh was given up
  audited_mesh made_;            // the last mesh
  std::optional<nearly_certified> nearest_;
};

}  // namespace

std::optional<mesh_outcome> adapt_by_local_changes(const adaptation_job& job) {
  return local_adaptation(job).run();
}

}  // namespace asterism::internal
