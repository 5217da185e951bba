// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/split_across.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/mesh/adapt/consistency_repair.hpp"
#include "asterism/mesh/adapt/editable_mesh.hpp"
#include "asterism/mesh/audit/split_edges.hpp"
#include "asterism/mesh/delivery/audited_mesh.hpp"
#include "asterism/mesh/delivery/delivered_metric.hpp"
#include "asterism/mesh/delivery/restore_tensors.hpp"
#include "asterism/mesh/delivery/tolerated_metric.hpp"
#include "asterism/mesh/stars/work_limit.hpp"

namespace asterism::internal {
namespace {

using namespace adapting;

class across_splitter {
 public:
  // Works on one mesh; references must outlive the object.
  across_splitter(const domain& d, const metric_field& field, const mesh_options& options,
                  double unit)
      : domain_(d), field_(field), options_(options), made_(domain_, options_) {
    options_.stop = with_run_work(options.stop);
    agree_.angle_bound = options.angle_bound;
    agree_.unit = unit;
    agree_.stop = options_.stop;
    agree_.wanted = [this](const point& q) { return wanted_at(q); };
  }

  // Returns a certified mesh without edges that join boundary vertices across the domain, or none.
  std::optional<mesh> run(const mesh& start) {
    constexpr int most_attempts = 8;
    mesh now = start;
    for (int attempt = 0; attempt < most_attempts && !is_stopped(); ++attempt) {
      auto built = editable_mesh::build(domain_, now);
      if (!built) return std::nullopt;
      editable_mesh m = std::move(built).value();
      if (!split_and_agree(m) || !certify(m)) return std::nullopt;
      now = made_.subject();
      if (edges_across(now).empty()) return now;
    }
    return std::nullopt;
  }

 private:
  bool is_stopped() const {
    return options_.stop.told().has_value() || !(options_.stop.units_left() > 0);
  }

  std::optional<metric_tensor> wanted_at(const point& q) const {
    const auto there = field_.at(q);
    return there ? std::optional(there.value()) : std::nullopt;
  }

  // Returns a flag for each node: whether it is an end of an edge with a face on one side alone.
  static std::vector<char> outer_nodes(const editable_mesh& m) {
    std::vector<char> is_outer(m.nodes().size(), 0);
    for (const face& f : m.faces())
      for (std::size_t i = 0; f.exists() && i < 3; ++i)
        if (f.next[i] == none) is_outer[f.v[after(i)]] = is_outer[f.v[before(i)]] = 1;
    return is_outer;
  }

  // Returns the place at which an edge is split: its middle, or the nearest point of its curve.
  static std::optional<point> middle_of(const editable_mesh& m, vertex_index t, std::size_t i) {
    const face& f = m.faces()[t];
    const point &a = m.at(f.v[after(i)]).position, &b = m.at(f.v[before(i)]).position;
    const point middle{a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2};
    return f.segment[i] == none ? std::optional(middle) : m.place_on_edge(t, i, middle);
  }

  // Splits all inner edges that join two boundary nodes. Returns the new nodes, or none where an
  // edge cannot be split, or the metric fails.
  std::optional<node_list> split_all(editable_mesh& m) const {
    const std::vector<char> is_outer = outer_nodes(m);
    const auto is_across = [&](const face& f, std::size_t i) {
      const vertex_index a = f.v[after(i)], b = f.v[before(i)];
      return f.next[i] != none && a < is_outer.size() && b < is_outer.size() && is_outer[a] != 0 &&
             is_outer[b] != 0;
    };
    node_list added;
    for (vertex_index t = 0; t < m.faces().size(); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        if (!m.faces()[t].exists() || !is_across(m.faces()[t], i)) continue;
        const auto where = middle_of(m, t, i);
        const auto metric = where ? wanted_at(*where) : std::nullopt;
        const auto node = metric ? m.split(t, i, *where) : std::nullopt;
        if (!node) return std::nullopt;
        m.set_metric(*node, *metric);
        added.push_back(*node);
        i = 3;  // the face is another one now; its other edges are seen in the next round
      }
    return added;
  }

  // Alternates splits and repairs of stars, whose flips may make new edges of this kind, until
  // there are none.
  bool split_and_agree(editable_mesh& m) const {
    constexpr int most_rounds = 40;
    consistency_repair agreeing(m, agree_);
    for (int round = 0; round < most_rounds && !is_stopped(); ++round) {
      const auto added = split_all(m);
      if (!added) return false;
      if (added->empty()) return true;
      if (m.count() > options_.max_sites) return false;
      agreeing.changed_at(*added);
      agreeing.run();
    }
    return false;
  }

  // Restores the wanted tensors as far as the auditor accepts, or else repairs the mesh with its
  // present ones. Returns whether it is certified.
  bool certify(editable_mesh& m) {
    constexpr int most_repairs = 12;
    std::vector<metric_tensor> wanted;
    for (const node& n : m.nodes()) {
      const auto there =
          n.kind == node_kind::gone ? std::optional(n.metric) : wanted_at(n.position);
      if (!there) return false;
      wanted.push_back(*there);
    }
    editable_mesh given = m;
    consistency_repair agreeing_of_given(given, agree_);
    if (give_back(given, std::move(wanted), options_, agreeing_of_given, false, made_)) return true;
    consistency_repair agreeing(m, agree_);
    for (int repair = 0; repair < most_repairs && !is_stopped(); ++repair) {
      made_.take(m);
      made_.judge(std::numeric_limits<std::size_t>::max());
      if (made_.is_certified()) return true;
      const std::vector<node_list> found = made_.nodes_found();
      if (found.empty()) return false;
      for (const node_list& at : found) agreeing.disagreed_at(at);
      agreeing.run();
    }
    return false;
  }

  const domain& domain_;
  const metric_field& field_;
  mesh_options options_;
  repair_options agree_;
  audited_mesh made_;
};

// Replaces the mesh of the outcome by another one of the same domain. Returns false where the field
// fails.
bool replace_mesh(mesh_outcome& of, mesh m, const domain& d, const metric_field& field,
                  const mesh_options& options) {
  auto compared = compare_with_wanted(m, field, options.angle_bound);
  if (!compared) return false;
  of.result = std::move(m);
  of.sites = of.result.sites.size();
  of.triangles = of.result.triangles.size();
  of.splits = of.result.boundary.size() - d.segments.size();
  of.inserted = of.sites - d.vertices.size() - of.splits;
  of.ended.sites = of.sites;
  of.audited.reset();
  const bool is_wanted = !of.delivered && compared.value().changed == 0;
  compared.value().length_factor = of.delivered ? of.delivered->length_factor : 1;
  of.delivered = is_wanted ? std::nullopt : std::optional(std::move(compared).value());
  of.intolerable = excess_of(of, options);
  if (of.intolerable) of.complete = false;
  return true;
}

}  // namespace

certified_mesh split_across(certified_mesh made, const domain& d, const metric_field& field,
                            const mesh_options& options) {
  if (!made.certified()) return made;
  const auto found = edges_across(made.outcome.result);
  if (found.empty()) return made;
  const double unit = made.outcome.delivered ? made.outcome.delivered->length_factor : 1;
  if (auto without = across_splitter(d, field, options, unit).run(made.outcome.result)) {
    mesh_outcome after = made.outcome;
    if (replace_mesh(after, *std::move(without), d, field, options))
      if (auto judged = judge_outcome(std::move(after), d, options); judged.certified())
        return judged;
  }
  made.outcome.complete = made.claim.complete = false;
  made.claim.reason = fmt::format(
      "{} inner edges join two vertices of the boundary, {} and {} the first, and splitting them "
      "did not end in a certified mesh",
      found.size(), found[0][0] + 1, found[0][1] + 1);
  return made;
}

}  // namespace asterism::internal
