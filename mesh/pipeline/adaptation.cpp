// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/adaptation.hpp"

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/adapt/agreement.hpp"
#include "asterism/mesh/adapt/nodal_field.hpp"
#include "asterism/mesh/adapt/nodal_gradation.hpp"
#include "asterism/mesh/adapt/unit_mesh.hpp"
#include "asterism/mesh/adapt/working_mesh.hpp"
#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/metric/unit_frame.hpp"
#include "asterism/mesh/pipeline/assign_regions.hpp"
#include "asterism/mesh/pipeline/delivered_metric.hpp"
#include "asterism/mesh/refine/mesh_domain.hpp"
#include "asterism/mesh/search/hilbert_order.hpp"

namespace asterism::internal {
namespace {

using namespace adapting;

// Distortion allowed over an edge of length one: of the metric the mesh is made in, on the graph of
// the background, and of the one delivered, on that of the mesh. Found by experiment
// (docs/design/adaptation.md); the later steps of the ladder are for where the first did not lead
// to agreement.
struct strictness {
  double background, mesh;
};
constexpr std::array<strictness, 4> ladder = {{{4, 2}, {3, 1.7}, {1.8, 1.4}, {1.25, 1.15}}};
// Most audits of one mesh, each after what the one before had found was mended.
constexpr int most_audits = 12;
// Part of the limit on sites that may be wanted. Beyond it the way by way of a fill tells what is
// not possible.
constexpr double part_of_limit = 0.8;

class euclidean_field final : public metric_field {
 public:
  result<metric_tensor> at(const point&) const override { return metric_tensor{1, 0, 1}; }
};

// Returns a triangulation of the domain with hardly more sites than it is given with.
std::optional<mesh> coarse_mesh(const domain& d, const mesh_options& options) {
  mesh_options coarse;
  coarse.angle_bound = 0;
  coarse.strategy = refinement_strategy::voronoi_arcs;
  coarse.max_sites = options.max_sites;
  coarse.stop = options.stop;
  const star_predicates_on<filtered_kernel> stars_on;
  const euclidean_field round;
  auto made = mesh_domain({stars_on, d, round, coarse});
  if (!made || !made.value().complete) return std::nullopt;
  return std::move(made.value().result);
}

class adaptation {
 public:
  adaptation(const domain& d, const metric_field& field, const mesh_options& options)
      : domain_(d), field_(field), options_(options), wanted_(*field.background()) {
    constexpr double vertices_of_unit = 2 / std::numbers::sqrt3;
    count_ = static_cast<std::size_t>(vertices_of_unit * wanted_.complexity());
  }

  std::optional<mesh_outcome> run() {
    const double most = part_of_limit * static_cast<double>(options_.max_sites);
    if (count_ < 1 || static_cast<double>(count_ + domain_.vertices.size()) > most)
      return std::nullopt;
    const auto start = coarse_mesh(domain_, options_);
    if (!start) return std::nullopt;
    order_places();
    for (const strictness& how : ladder) {
      if (!attempt(*start, how)) return std::nullopt;
      if (outcome_.audited->certified || stop_reason()) break;
    }
    if (outcome_.audited->certified) meet_count(*start);
    if (const auto why = stop_reason(); why && !outcome_.audited->certified) return stopped(*why);
    if (!outcome_.audited->certified) return std::nullopt;
    return conclude();
  }

 private:
  std::optional<std::string> stop_reason() const { return options_.stop.poll(); }

  static double off_count(std::size_t sites, std::size_t wanted) {
    return std::abs(elementary::log(static_cast<double>(sites) / static_cast<double>(wanted)));
  }

  // Makes the mesh once more if mending has changed the number of sites by much, with as many more
  // or fewer wanted to begin with. The new mesh stays if it is nearer to the number wanted.
  void meet_count(const mesh& start) {
    constexpr double tolerable = 0.03;
    const std::size_t wanted = count_, got = outcome_.result.sites.size();
    if (off_count(got, wanted) <= tolerable || stop_reason()) return;
    mesh_outcome before = outcome_;
    const double length_factor = length_factor_;
    count_ = wanted * wanted / got;
    const bool made = attempt(start, ladder[0]);
    if (made && outcome_.audited->certified &&
        off_count(outcome_.result.sites.size(), wanted) < off_count(got, wanted))
      return;
    outcome_ = std::move(before);
    length_factor_ = length_factor;
  }

  // Orders the places of the background along a space-filling curve.
  void order_places() {
    std::vector<site> sites;
    for (const point& q : wanted_.places()) sites.push_back({q, {}});
    sort_along_curve(sites, domain_.box());
    for (const site& s : sites) seeds_.push_back(s.position);
  }

  nodal_field graded(double distortion) const {
    nodal_field made = wanted_;
    std::vector<metric_tensor> tensors = wanted_.tensors();
    gradation_limit limit;
    limit.distortion = distortion;
    limit.longest = 20;
    grade(made.places(), made.edges(), limit, tensors);
    made.set_tensors(std::move(tensors));
    return made;
  }

  std::optional<metric_tensor> wanted_at(const point& q) const {
    const auto there = field_.at(q);
    return there ? std::optional(there.value()) : std::nullopt;
  }

  // Makes the mesh and its audit in outcome_. Returns false where it cannot be made.
  bool attempt(const mesh& start, const strictness& how) {
    auto built = working_mesh::build(domain_, start);
    if (!built) return false;
    working_mesh m = std::move(built).value();
    const nodal_field background = graded(how.background);
    unit_mesh_options making;
    making.count = count_;
    making.most_nodes = options_.max_sites;
    making.stop = [this] { return stop_reason().has_value(); };
    unit_mesher maker(
        m, [&background](const point& q, vertex_index& hint) { return background.at(q, hint); },
        making);
    maker.run(seeds_);
    length_factor_ = maker.unit();
    for (vertex_index v = 0; v < m.nodes().size(); ++v) {
      if (m.at(v).kind == node_kind::gone) continue;
      const auto there = wanted_at(m.at(v).position);
      if (!there) return false;
      m.set_metric(v, *there);
    }
    deliver(m, how);
    return true;
  }

  // Makes tensors alike until the auditor has nothing against the mesh.
  void deliver(working_mesh& m, const strictness& how) {
    agreement_options agree;
    agree.angle_bound = options_.angle_bound;
    agree.unit = length_factor_;
    agree.distortion = how.mesh;
    agree.stop = [this] { return stop_reason().has_value(); };
    agree.wanted = [this](const point& q) { return wanted_at(q); };
    agreement agreeing(m, agree);
    for (int audits = 0; audits < most_audits; ++audits) {
      agreeing.run();
      std::vector<vertex_index> renumbered;
      outcome_.result = m.triangulation(renumbered);
      assign_regions(outcome_.result, domain_);
      judge();
      if (outcome_.audited->certified || stop_reason()) return;
      if (!mend(agreeing, renumbered)) return;
    }
  }

  void judge() {
    audit_options asked;
    asked.angle_bound = options_.angle_bound;
    asked.find_exempt_corners = true;
    asked.original = &domain_;
    asked.findings_kept = outcome_.result.sites.size();
    asked.check_stars = !stop_reason();
    outcome_.audited = std::make_shared<audit_report>(audit(outcome_.result, asked));
  }

  // Mends what the audit found; true if there was a star to mend.
  bool mend(agreement& agreeing, const std::vector<vertex_index>& renumbered) const {
    std::vector<vertex_index> node_of(outcome_.result.sites.size());
    for (vertex_index v = 0; v < renumbered.size(); ++v)
      if (renumbered[v] != none) node_of[renumbered[v]] = v;
    bool any = false;
    for (const audit_finding& found : outcome_.audited->findings) {
      if (found.vertices.empty()) continue;
      std::vector<vertex_index> nodes;
      for (const vertex_index v : found.vertices) nodes.push_back(node_of[v]);
      agreeing.disagreed_at(nodes);
      any = true;
    }
    return any;
  }

  void count_up() {
    outcome_.sites = outcome_.result.sites.size();
    outcome_.triangles = outcome_.result.triangles.size();
    outcome_.splits = outcome_.result.boundary.size() - domain_.segments.size();
    outcome_.inserted = outcome_.sites - domain_.vertices.size() - outcome_.splits;
  }

  mesh_outcome stopped(const std::string& why) {
    outcome_.stopped = true;
    outcome_.audited.reset();
    outcome_.ended.how = ending::stopped;
    outcome_.ended.stopped_because = why;
    count_up();
    return std::move(outcome_);
  }

  std::optional<mesh_outcome> conclude() {
    count_up();
    auto compared = compare_with_wanted(outcome_.result, field_, options_.angle_bound);
    if (!compared) return std::nullopt;
    compared.value().length_factor = length_factor_;
    outcome_.delivered = std::move(compared).value();
    outcome_.complete = true;
    outcome_.ended.how = ending::complete;
    outcome_.ended.sites = outcome_.sites;
    const audit_report& found = *outcome_.audited;
    for (const vertex_index v : found.exempt_corners)
      outcome_.exempt.push_back({v, options_.angle_bound});
    for (const vertex_index t : found.exempt_triangles)
      outcome_.exempt_triangles.push_back(outcome_.result.triangles[t]);
    return std::move(outcome_);
  }

  const domain& domain_;
  const metric_field& field_;
  const mesh_options& options_;
  nodal_field wanted_;
  std::size_t count_ = 0;
  std::vector<point> seeds_;
  double length_factor_ = 1;
  mesh_outcome outcome_;
};

}  // namespace

bool wants_adaptation(const metric_field& field, const mesh_options& options) {
  return options.relax && options.limit_size && options.strategy == refinement_strategy::fill &&
         !options.keep_if_complete && !options.tolerance && field.background() != nullptr;
}

std::optional<mesh_outcome> adapt_mesh(const domain& d, const metric_field& field,
                                       const mesh_options& options) {
  if (!unit_frame::choose(d, field, false).is_identity()) return std::nullopt;
  return adaptation(d, field, options).run();
}

}  // namespace asterism::internal
