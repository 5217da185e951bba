// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/adaptation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/adapt/agreement.hpp"
#include "asterism/mesh/adapt/mesh_gradation.hpp"
#include "asterism/mesh/adapt/nodal_field.hpp"
#include "asterism/mesh/adapt/nodal_gradation.hpp"
#include "asterism/mesh/adapt/restoration.hpp"
#include "asterism/mesh/adapt/unit_mesh.hpp"
#include "asterism/mesh/adapt/working_mesh.hpp"
#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/audit/audit_again.hpp"
#include "asterism/mesh/pipeline/assign_regions.hpp"
#include "asterism/mesh/pipeline/background.hpp"
#include "asterism/mesh/pipeline/delivered_metric.hpp"
#include "asterism/mesh/refine/coarser_mesh.hpp"
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
// How often the mesh is fitted to the metric as its own graph has graded it. Once makes what is
// left to mend a tenth of what it is without; twice costs time and error, and gains nothing.
constexpr int refits = 1;
// Most audits of one mesh, each after what the one before had found was mended.
constexpr int most_audits = 12;
// The same of a mesh whose tensors alone are changed, where audits after the first cost little.
constexpr int most_audits_again = 40;
// Metric wanted, at the nodes of a background.
struct metric_at_nodes {
  nodal_field nodes;
  bool is_field_itself;  // rather than samples of it
  std::size_t count;     // of vertices wanted
};

class adaptation {
 public:
  adaptation(const domain& d, const metric_field& field, const mesh_options& options,
             const mesh& start, metric_at_nodes wanted)
      : domain_(d),
        field_(field),
        options_(options),
        start_(start),
        wanted_(std::move(wanted.nodes)),
        is_field_itself_(wanted.is_field_itself),
        count_(wanted.count) {}

  std::optional<mesh_outcome> run() {
    if (count_ < 1) return std::nullopt;
    order_places();
    for (const strictness& how : ladder) {
      if (!attempt(start_, how)) return std::nullopt;
      if (outcome_.audited->certified || stop_reason()) break;
    }
    if (outcome_.audited->certified) meet_count(start_);
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
    constexpr double tolerable = 0.04;
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

  // Gives the nodes what is interpolated between the background's: the metric wanted but for
  // rounding, and looked up sooner.
  void take_interpolated(working_mesh& m) const {
    for (vertex_index v = 0; v < m.nodes().size(); ++v)
      if (m.at(v).kind != node_kind::gone)
        m.set_metric(v, wanted_.at(m.at(v).position, m.at(v).hint));
  }

  // Gives the nodes the metric wanted where they are. Returns false where it fails.
  bool take_wanted(working_mesh& m) const {
    for (vertex_index v = 0; v < m.nodes().size(); ++v) {
      if (m.at(v).kind == node_kind::gone) continue;
      const auto there = wanted_at(m.at(v).position);
      if (!there) return false;
      m.set_metric(v, *there);
    }
    return true;
  }

  // Makes the mesh and its audit in outcome_. Returns false where it cannot be made.
  bool attempt(const mesh& start, const strictness& how) {
    auto built = working_mesh::build(domain_, start);
    if (!built) return false;
    working_mesh m = std::move(built).value();
    const nodal_field background = graded(how.background);
    unit_mesh_options making;
    making.count = count_;
    // Ends splitting: if edges are still too long with so many more nodes, the metric is too thin
    // for it to get anywhere.
    constexpr std::size_t times_as_many = 4, at_least = 1000;
    making.most_nodes =
        std::min(options_.max_sites, times_as_many * count_ + at_least + start_.sites.size());
    making.stop = options_.stop;
    unit_mesher maker(m, making);
    maker.run([&background](const point& q, vertex_index& hint) { return background.at(q, hint); },
              seeds_);
    for (int i = 0; i < refits; ++i) {
      if (is_field_itself_)
        take_interpolated(m);
      else if (!take_wanted(m))
        return false;
      grade_mesh(m, how.mesh, maker.unit());
      const nodal_field own = field_of(m);
      maker.refit([&own](const point& q, vertex_index& hint) { return own.at(q, hint); });
    }
    length_factor_ = maker.unit();
    if (!take_wanted(m)) return false;
    grade_mesh(m, how.mesh, length_factor_);
    deliver(m);
    return true;
  }

  // Makes tensors alike until the mesh is certified, and gives back what need not be alike. Nearly
  // always neighbours that agree make a mesh that is certified; so it is not audited before tensors
  // have been given back, unless that goes wrong.
  void deliver(working_mesh& m) {
    agreement_options agree;
    agree.angle_bound = options_.angle_bound;
    agree.unit = length_factor_;
    agree.stop = options_.stop;
    agree.wanted = [this](const point& q) { return wanted_at(q); };
    agreement agreeing(m, agree);
    agreeing.run();
    const working_mesh alike = m;
    if (give_back(m)) return;
    m = alike;
    mend(m, agreeing);
    if (!outcome_.audited->certified) return;
    mesh_outcome certified = outcome_;
    if (!give_back(m)) outcome_ = std::move(certified);
  }

  // Makes tensors alike until the auditor has nothing against the mesh.
  void mend(working_mesh& m, agreement& agreeing) {
    for (int audits = 0; audits < most_audits; ++audits) {
      const std::vector<vertex_index> nodes = take(m);
      judge();
      if (outcome_.audited->certified || stop_reason()) return;
      const std::vector<std::vector<vertex_index>> found = nodes_found(nodes);
      if (found.empty()) return;
      for (const std::vector<vertex_index>& at : found) agreeing.disagreed_at(at);
      agreeing.run();
    }
  }

  // Gives tensors wanted back to the nodes, as many as the auditor lets pass. Returns whether the
  // outcome then is a certified mesh.
  bool give_back(working_mesh& m) {
    std::vector<metric_tensor> tensors;
    for (const node& n : m.nodes()) {
      const auto there = n.kind == node_kind::gone ? n.metric : wanted_at(n.position);
      if (!there) return false;
      tensors.push_back(*there);
    }
    restoration giving(m, options_.angle_bound, std::move(tensors));
    giving.run(options_.stop);
    std::vector<vertex_index> nodes = take(m);
    judge();
    for (int audits = 1; audits < most_audits_again; ++audits) {
      if (outcome_.audited->certified) return true;
      if (stop_reason()) return false;
      std::vector<vertex_index> looked_at, taken;
      for (const std::vector<vertex_index>& at : nodes_found(nodes)) {
        giving.take_back(at, taken);
        looked_at.insert(looked_at.end(), at.begin(), at.end());
      }
      if (taken.empty()) return false;
      looked_at.insert(looked_at.end(), taken.begin(), taken.end());
      nodes = take(m);
      judge_again(sites_of(looked_at, nodes));
    }
    return outcome_.audited->certified;
  }

  // Makes the outcome's mesh. Returns the nodes that its sites are.
  std::vector<vertex_index> take(const working_mesh& m) {
    std::vector<vertex_index> renumbered;
    outcome_.result = m.triangulation(renumbered);
    assign_regions(outcome_.result, domain_);
    std::vector<vertex_index> node_of(outcome_.result.sites.size());
    for (vertex_index v = 0; v < renumbered.size(); ++v)
      if (renumbered[v] != none) node_of[renumbered[v]] = v;
    return node_of;
  }

  // Returns the sites that the nodes are, ascending, each once.
  static std::vector<vertex_index> sites_of(std::vector<vertex_index> nodes,
                                            const std::vector<vertex_index>& node_of) {
    std::sort(nodes.begin(), nodes.end());
    std::vector<vertex_index> sites;
    for (vertex_index s = 0; s < node_of.size(); ++s)
      if (std::binary_search(nodes.begin(), nodes.end(), node_of[s])) sites.push_back(s);
    return sites;
  }

  audit_options question() const {
    audit_options asked;
    asked.angle_bound = options_.angle_bound;
    asked.find_exempt_corners = true;
    asked.original = &domain_;
    // All are told, for what is found is what is mended, and no audit is cut short.
    asked.findings_kept = std::numeric_limits<std::size_t>::max();
    asked.stop = options_.stop;
    return asked;
  }

  void judge() {
    outcome_.audited = std::make_shared<audit_report>(audit(outcome_.result, question()));
  }

  // Audits the mesh of which only these sites' tensors were changed since.
  void judge_again(const std::vector<vertex_index>& changed) {
    const audit_report& before = *outcome_.audited;
    if (!before.stars_checked) return judge();
    outcome_.audited =
        std::make_shared<audit_report>(audit_again(outcome_.result, question(), before, changed));
  }

  // Returns the nodes that the audit's findings are about, a list for each: of stars, and of
  // triangles with an angle below the bound.
  std::vector<std::vector<vertex_index>> nodes_found(
      const std::vector<vertex_index>& node_of) const {
    std::vector<std::vector<vertex_index>> all;
    const auto add = [&](const auto& vertices) {
      std::vector<vertex_index>& nodes = all.emplace_back();
      for (const vertex_index v : vertices) nodes.push_back(node_of[v]);
    };
    for (const audit_finding& found : outcome_.audited->findings)
      if (!found.vertices.empty()) add(found.vertices);
    for (const vertex_index t : outcome_.audited->refused_triangles())
      add(outcome_.result.triangles[t]);
    return all;
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

  mesh_outcome conclude() {
    count_up();
    outcome_.delivered.emplace().length_factor = length_factor_;
    outcome_.complete = true;
    outcome_.ended.how = ending::complete;
    outcome_.ended.max_sites = options_.max_sites;
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
  const mesh& start_;
  nodal_field wanted_;
  bool is_field_itself_;
  std::size_t count_;
  std::vector<point> seeds_;
  double length_factor_ = 1;
  mesh_outcome outcome_;
};

// Number of vertices of a mesh whose edges have length 1, for each unit of its area.
constexpr double vertices_of_unit = 2 / std::numbers::sqrt3;

mesh in_frame(const unit_frame& frame, const mesh& m) {
  mesh image = m;
  for (site& s : image.sites) s = {frame.inward(s.position), frame.inward(s.metric)};
  return image;
}

}  // namespace

bool may_adapt(const mesh_options& options) {
  return options.relax && options.strategy == refinement_strategy::fill && !options.tolerance;
}

metric_delivery::metric_delivery(const domain& d, const metric_field& field,
                                 const mesh_options& options)
    : field_(field), options_(options), image_(d, field, options) {}

// Makes the coarse mesh and the background, once; false where there are none.
bool metric_delivery::prepare() {
  if (prepared_) return start_ && background_;
  prepared_ = true;
  start_ = coarse_mesh(image_.shape(), image_.field(), options_);
  if (!start_) return false;
  if (const mesh* const given = field_.background()) {
    background_ = in_frame(image_.frame(), *given);
    return true;
  }
  constexpr double any_length = std::numeric_limits<double>::infinity();
  auto sampled = sample_field(image_.shape(), *start_, image_.field(), any_length, options_.stop);
  if (!sampled) return false;
  background_ = std::move(sampled->nodes);
  longest_ = sampled->longest;
  return true;
}

bool metric_delivery::is_first_choice() const {
  return options_.limit_size && !options_.keep_if_complete &&
         (field_.background() != nullptr || options_.vertices);
}

bool metric_delivery::varies_fast() {
  constexpr double most_that_is_met = 0.6;
  return options_.limit_size && field_.background() == nullptr && prepare() &&
         sampled_variation(*background_) > most_that_is_met;
}

// Returns how often the number of sites is to be halved: until there is room for them, or, without
// a size, until there are as many as `few`.
std::optional<int> metric_delivery::halvings(double vertices, std::size_t few) const {
  constexpr double part_of_limit = 0.8;
  const double most = part_of_limit * static_cast<double>(options_.max_sites);
  if (!(vertices > 0) || !std::isfinite(vertices)) return std::nullopt;
  const double times = elementary::log2(vertices / static_cast<double>(few));
  if (!options_.limit_size) return static_cast<int>(std::lround(times));
  return std::max(0, static_cast<int>(std::ceil(elementary::log2(vertices / most))));
}

// Returns the metric wanted, in the field divided by 2^halved: a formula with samples as dense as
// the sites will be, unless the ones that there are will do.
std::optional<nodal_field> metric_delivery::wanted_in(const metric_field& coarser, int halved,
                                                      const nodal_field& sampled) const {
  constexpr double as_sites = 1;
  const bool is_formula = field_.background() == nullptr;
  if (halved == 0 && (!is_formula || longest_ <= as_sites)) return sampled;
  if (is_formula) {
    auto fine = sample_field(image_.shape(), *start_, coarser, as_sites, options_.stop);
    if (!fine) return std::nullopt;
    return nodal_field(fine->nodes);
  }
  mesh background = *background_;
  const double factor = elementary::exp2(-halved);
  for (site& s : background.sites)
    s.metric = {s.metric.m11 * factor, s.metric.m12 * factor, s.metric.m22 * factor};
  return nodal_field(background);
}

std::optional<mesh_outcome> metric_delivery::make(std::size_t few) {
  if (!prepare()) return std::nullopt;
  const nodal_field sampled(*background_);
  const auto halved = halvings(vertices_of_unit * sampled.complexity(), few);
  if (!halved) return std::nullopt;
  const coarser_field coarser(image_.field(), *halved);
  auto wanted = wanted_in(coarser, *halved, sampled);
  if (!wanted) return std::nullopt;
  const double count = *halved == 0 && options_.vertices ? static_cast<double>(*options_.vertices)
                                                         : vertices_of_unit * wanted->complexity();
  if (!(count < static_cast<double>(options_.max_sites))) return std::nullopt;
  auto made = adaptation(image_.shape(), coarser, options_, *start_,
                         {std::move(*wanted), field_.background() != nullptr,
                          static_cast<std::size_t>(count)})
                  .run();
  if (!made) return std::nullopt;
  return in_given_units(std::move(*made), *halved);
}

std::optional<mesh_outcome> metric_delivery::in_given_units(mesh_outcome made, int halved) {
  restore_lengths(halved, made);
  image_.outward(made);
  if (halved != 0 || !image_.frame().is_identity()) made.audited.reset();
  if (!made.complete) return made;
  const double length_factor = made.delivered->length_factor;
  auto compared = compare_with_wanted(made.result, field_, options_.angle_bound);
  if (!compared) return std::nullopt;
  made.delivered = std::move(compared).value();
  made.delivered->length_factor = length_factor;
  if (options_.limit_size) report_coarser(halved, false, options_, made);
  return made;
}

}  // namespace asterism::internal
