// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/improved_mesh.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "asterism/mesh/adapt/editable_mesh.hpp"
#include "asterism/mesh/adapt/unit_mesh.hpp"
#include "asterism/mesh/numerics/mesh_statistics.hpp"
#include "asterism/mesh/numerics/triangle_quality.hpp"
#include "asterism/mesh/refine/mesh_domain.hpp"

namespace asterism::internal {
namespace {

using adapting::node;
using adapting::node_kind;

constexpr std::size_t most_tries = 10;  // of one pass

// Numbers of a mesh that an improvement must not make worse.
struct mesh_quality {
  std::size_t sites = 0, exempt = 0;
  double worst_angle = 180;  // away from exempt corners
  double mean_quality = 0;
};

double angle_of(const mesh& m, const triangle& t) {
  return smallest_angle(triangle_sites{m.sites[t[0]], m.sites[t[1]], m.sites[t[2]]});
}

mesh_quality quality_of(const mesh& m, const std::vector<triangle>& exempt) {
  const std::set<triangle> excused(exempt.begin(), exempt.end());
  mesh_quality s{m.sites.size(), exempt.size(), 180, measure(m).mean_quality};
  for (const triangle& t : m.triangles)
    if (excused.count(t) == 0) s.worst_angle = std::min(s.worst_angle, angle_of(m, t));
  return s;
}

// True if nothing is worse, and there are fewer sites or a higher mean quality. False if a number
// to be compared is NaN.
bool is_better(const mesh_quality& before, const mesh_quality& after) {
  return after.sites <= before.sites && after.exempt <= before.exempt &&
         after.worst_angle >= before.worst_angle && after.mean_quality >= before.mean_quality &&
         (after.sites < before.sites || after.mean_quality > before.mean_quality);
}

// Sites that local changes propose, and the proposed place of each site of the mesh.
struct proposed_sites {
  filled_domain filling;
  // Proposed place of each site of the mesh, its own if it stays, and a flag that is 1 if the site
  // is removed.
  std::vector<point> places;
  std::vector<char> gone;
};

// Finds the sites of the mesh before the pass by the places proposed for them.
class places_before {
 public:
  explicit places_before(const proposed_sites& p) {
    for (vertex_index v = 0; v < p.places.size(); ++v)
      if (p.gone[v] == 0) sorted_.emplace_back(p.places[v], v);
    std::sort(sorted_.begin(), sorted_.end(), less);
  }

  // Returns the site whose proposed place is this point; `none` if there is none.
  vertex_index find(const point& q) const {
    const auto at =
        std::lower_bound(sorted_.begin(), sorted_.end(), std::pair(q, vertex_index{0}), less);
    return at != sorted_.end() && at->first == q ? at->second : none;
  }

  static constexpr vertex_index none = std::numeric_limits<vertex_index>::max();

 private:
  using entry = std::pair<point, vertex_index>;
  static bool less(const entry& a, const entry& b) {
    return lexicographically_less(a.first, b.first);
  }
  std::vector<entry> sorted_;
};

// Marks the sites, by their numbers before the pass, at triangles that the pass made worse: where
// an angle is too small, stars disagree, or a site had to be inserted.
std::vector<char> spoilt_at(const places_before& places, std::size_t count_before,
                            const mesh& after, double worst_before) {
  std::vector<char> spoilt(count_before, 0);
  const auto visit = [&](const triangle& t, bool bad) {
    std::array<vertex_index, 3> before{};
    for (std::size_t i = 0; i < 3; ++i) before[i] = places.find(after.sites[t[i]].position);
    if (std::find(before.begin(), before.end(), places_before::none) == before.end() && !bad)
      return;
    for (const vertex_index v : before)
      if (v != places_before::none) spoilt[v] = 1;
  };
  for (const triangle& t : after.triangles) visit(t, angle_of(after, t) < worst_before);
  for (const triangle& t : after.disagreeing) visit(t, true);
  return spoilt;
}

class improver {
 public:
  improver(const meshing_context& job, mesh_outcome& outcome)
      : job_(job), options_(job.options), outcome_(outcome) {}

  void run() {
    improvement_report report;
    now_ = outcome_.result;
    quality_ = quality_of(now_, outcome_.exempt_triangles);
    report.sites_before = quality_.sites;
    report.mean_quality_before = quality_.mean_quality;
    for (std::size_t pass = 0; pass < options_.improve_passes && !report.stopped; ++pass) {
      if (!one_pass(report)) break;
      ++report.passes;
    }
    report.mean_quality_after = quality_.mean_quality;
    outcome_.improved = report;
  }

 private:
  // Makes one pass; returns true if a mesh of it was accepted.
  bool one_pass(improvement_report& report) {
    std::vector<char> barred(now_.sites.size(), 0);
    for (std::size_t attempt = 0; attempt < most_tries; ++attempt) {
      report.stopped = options_.stop.is_requested();
      if (report.stopped) return false;
      const auto p = propose(barred);
      if (!p) return false;
      const auto removed = static_cast<std::size_t>(std::count(p->gone.begin(), p->gone.end(), 1));
      const std::size_t moved = moved_in(*p);
      if (removed + moved == 0) return false;
      ++report.tries;
      auto made = refined(p->filling);
      if (!made) return false;
      report.stopped = made.value().stopped;
      if (report.stopped) return false;
      if (accept(std::move(made).value())) {
        report.removed += removed;
        report.moved += moved;
        return true;
      }
      if (!bar_neighbourhoods(*p, barred)) return false;
    }
    return false;
  }

  // Proposes sites by local changes that keep the metric field, and keep barred sites in place.
  // Returns nothing where the mesh is no triangulation in doubles.
  std::optional<proposed_sites> propose(const std::vector<char>& barred) const {
    auto built = adapting::editable_mesh::build(job_.shape, now_);
    if (!built) return std::nullopt;
    adapting::editable_mesh m = std::move(built).value();
    for (vertex_index v = 0; v < now_.sites.size(); ++v)
      if (m.at(v).kind == node_kind::sliding || barred[v] != 0) m.at(v).kind = node_kind::given;
    adapting::unit_mesh_options making;
    making.stop = options_.stop;
    adapting::unit_mesh_remesher maker(m, making);
    maker.improve([this](const point& q, vertex_index&) { return tensor_at(q); },
                  [this](const node& a, const node& b, const node& c) { return may_be(a, b, c); });
    return sites_of(m);
  }

  // Returns the field's tensor; where the field fails, one by which every face is refused.
  metric_tensor tensor_at(const point& q) const {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const auto there = job_.field.at(q);
    return there ? there.value() : metric_tensor{nan, nan, nan};
  }

  // True if the face has no angle below the mesh's worst, and is at most a little too large. Faces
  // are tested before flips and moves around them; refinement divides faces that are too large in
  // the end.
  bool may_be(const node& a, const node& b, const node& c) const {
    constexpr double larger = 1.05;
    const triangle_sites t{site{a.position, a.metric}, site{b.position, b.metric},
                           site{c.position, c.metric}};
    return smallest_angle(t) >= std::max(options_.angle_bound, quality_.worst_angle) &&
           (!options_.limit_size || metric_circumradius(t) <= larger * largest_circumradius);
  }

  proposed_sites sites_of(const adapting::editable_mesh& m) const {
    proposed_sites p;
    p.filling.complete = true;
    p.filling.divisions.resize(job_.shape.segments.size());
    const std::vector<boundary_edge>& subsegments = now_.boundary;
    for (std::size_t i = 0; i + 1 < subsegments.size(); ++i)
      if (subsegments[i].segment == subsegments[i + 1].segment)
        p.filling.divisions[subsegments[i].segment].push_back(now_.sites[subsegments[i].b]);
    std::vector<char> on_boundary(now_.sites.size(), 0);
    for (const boundary_edge& e : subsegments) on_boundary[e.a] = on_boundary[e.b] = 1;
    for (vertex_index v = 0; v < now_.sites.size(); ++v) {
      const node& n = m.at(v);
      p.places.push_back(n.position);
      p.gone.push_back(n.kind == node_kind::gone ? 1 : 0);
      if (v >= now_.given && on_boundary[v] == 0 && p.gone[v] == 0)
        p.filling.interior.push_back({n.position, n.metric});
    }
    return p;
  }

  std::size_t moved_in(const proposed_sites& p) const {
    std::size_t moved = 0;
    for (vertex_index v = 0; v < now_.sites.size(); ++v)
      moved += p.gone[v] == 0 && !(p.places[v] == now_.sites[v].position) ? 1 : 0;
    return moved;
  }

  // Refines the proposal, limited to the present number of sites. Counts the work from zero, as for
  // one mesh.
  result<mesh_outcome> refined(const filled_domain& proposed) const {
    tier_counters own;
    const auto own_kernel = job_.kernel.fork(own);
    mesh_options limited = options_;
    limited.max_sites = now_.sites.size();
    auto made = mesh_from_sites(job_.on(*own_kernel).with(limited), {proposed});
    job_.kernel.counters() += own;
    return made;
  }

  // Replaces the mesh if the new one is complete and better; returns true if so. Otherwise leaves
  // the new one in tried_.
  bool accept(mesh_outcome made) {
    tried_ = made.result;
    const mesh_quality after = quality_of(tried_, made.exempt_triangles);
    if (!made.complete || !is_better(quality_, after)) return false;
    outcome_ = std::move(made);
    now_ = std::move(tried_);
    quality_ = after;
    return true;
  }

  // Bars the sites in spoilt triangles and all that were their neighbours. Returns whether that
  // barred further sites.
  bool bar_neighbourhoods(const proposed_sites& p, std::vector<char>& barred) const {
    const std::vector<char> spoilt =
        spoilt_at(places_before(p), now_.sites.size(), tried_, quality_.worst_angle);
    bool any = false;
    for (const triangle& t : now_.triangles)
      if (std::any_of(t.begin(), t.end(), [&](vertex_index v) { return spoilt[v] != 0; }))
        for (const vertex_index v : t) any = std::exchange(barred[v], 1) == 0 || any;
    return any;
  }

  const meshing_context& job_;
  const mesh_options& options_;
  mesh_outcome& outcome_;
  mesh now_, tried_;
  mesh_quality quality_;
};

}  // namespace

void improve(const meshing_context& job, mesh_outcome& outcome) {
  if (job.options.improve_passes == 0 || !outcome.complete || outcome.ended.nothing_added) return;
  improver(job, outcome).run();
}

}  // namespace asterism::internal
