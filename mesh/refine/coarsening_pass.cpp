// SPDX-License-Identifier: MIT
#include "asterism/mesh/refine/coarsening_pass.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "asterism/mesh/numerics/mesh_statistics.hpp"
#include "asterism/mesh/numerics/triangle_quality.hpp"
#include "asterism/mesh/refine/coarsening_proposal.hpp"

namespace asterism::internal {
namespace {

// Most tries of one pass, and the number of tries after which half of what is left is given up each
// time.
constexpr std::size_t most_tries = 10, tries_before_halving = 4;

// Measures of a mesh that may not get worse.
struct standing {
  std::size_t sites = 0, exempt = 0;
  double worst_angle = 180;  // away from exempt corners
  double mean_quality = 0;
};

double angle_of(const mesh& m, const triangle& t) {
  return smallest_angle(triangle_sites{m.sites[t[0]], m.sites[t[1]], m.sites[t[2]]});
}

standing standing_of(const mesh& m, const std::vector<triangle>& exempt) {
  const std::set<triangle> excused(exempt.begin(), exempt.end());
  standing s{m.sites.size(), exempt.size(), 180, measure(m).mean_quality};
  for (const triangle& t : m.triangles)
    if (excused.count(t) == 0) s.worst_angle = std::min(s.worst_angle, angle_of(m, t));
  return s;
}

// True if nothing is worse, and there are fewer sites or a higher mean quality. False if a number
// to be compared is NaN.
bool is_better(const standing& before, const standing& after) {
  return after.sites <= before.sites && after.exempt <= before.exempt &&
         after.worst_angle >= before.worst_angle && after.mean_quality >= before.mean_quality &&
         (after.sites < before.sites || after.mean_quality > before.mean_quality);
}

// Finds the sites of the mesh before the pass by the places proposed for them.
class places_before {
 public:
  explicit places_before(const improvement_proposal& p) {
    std::vector<char> gone(p.places.size(), 0);
    for (const vertex_index v : p.removed) gone[v] = 1;
    for (vertex_index v = 0; v < p.places.size(); ++v)
      if (gone[v] == 0) sorted_.emplace_back(p.places[v], v);
    std::sort(sorted_.begin(), sorted_.end(), less);
  }

  // Returns the site at the point; `none` where there is none.
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

// Marks the sites of the mesh before the pass that have triangles spoilt by it: where an angle is
// too small, stars disagree, or a site had to be inserted.
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
  improver(const meshing_context& job, const refine_again& refine, mesh_outcome& outcome)
      : job_(job), options_(job.options), refine_(refine), outcome_(outcome) {}

  void run() {
    improvement_report report;
    now_ = outcome_.result;
    standing_ = standing_of(now_, outcome_.exempt_triangles);
    report.sites_before = standing_.sites;
    report.mean_quality_before = standing_.mean_quality;
    for (std::size_t pass = 0; pass < options_.improve_passes && !report.stopped; ++pass) {
      if (!one_pass(report)) break;
      ++report.passes;
    }
    report.mean_quality_after = standing_.mean_quality;
    outcome_.improved = report;
  }

 private:
  // Makes one pass; true if something was accepted.
  bool one_pass(improvement_report& report) {
    std::vector<char> barred(now_.sites.size(), 0);
    improvement_goal goal;
    goal.least_angle = std::max(options_.angle_bound, standing_.worst_angle);
    goal.mean_quality = standing_.mean_quality;
    goal.largest_radius =
        options_.limit_size ? largest_circumradius : std::numeric_limits<double>::infinity();
    for (std::size_t attempt = 0; attempt < most_tries; ++attempt) {
      report.stopped = options_.stop.is_requested();
      if (report.stopped) return false;
      const improvement_proposal p =
          propose_improvement(now_, job_.shape.segments.size(), job_.field, goal, barred);
      if (p.changes_nothing()) return false;
      ++report.tries;
      auto made = refine_(p.filling, now_.sites.size());
      if (!made) return false;
      report.stopped = made.value().stopped;
      if (report.stopped) return false;
      if (accept(std::move(made).value())) {
        report.removed += p.removed.size();
        report.moved += p.moved.size();
        return true;
      }
      bar_neighbourhoods(p, barred);
      if (quality_fell_ || attempt + 1 >= tries_before_halving) bar_half(p.removed, barred);
      if (attempt + 1 >= tries_before_halving) bar_half(p.moved, barred);
    }
    return false;
  }

  // Replaces the mesh if the one made is complete and better; true if it was. Leaves it in tried_
  // otherwise.
  bool accept(mesh_outcome made) {
    tried_ = made.result;
    const standing after = standing_of(tried_, made.exempt_triangles);
    quality_fell_ = after.mean_quality < standing_.mean_quality;
    if (!made.complete || !is_better(standing_, after)) return false;
    outcome_ = std::move(made);
    now_ = std::move(tried_);
    standing_ = after;
    return true;
  }

  // Bars the sites in spoilt triangles and all that were their neighbours.
  void bar_neighbourhoods(const improvement_proposal& p, std::vector<char>& barred) const {
    const std::vector<char> spoilt =
        spoilt_at(places_before(p), now_.sites.size(), tried_, standing_.worst_angle);
    for (const triangle& t : now_.triangles)
      if (std::any_of(t.begin(), t.end(), [&](vertex_index v) { return spoilt[v] != 0; }))
        for (const vertex_index v : t) barred[v] = 1;
  }

  static void bar_half(const std::vector<vertex_index>& all, std::vector<char>& barred) {
    for (std::size_t i = all.size() / 2; i < all.size(); ++i) barred[all[i]] = 1;
  }

  const meshing_context& job_;
  const mesh_options& options_;
  const refine_again& refine_;
  mesh_outcome& outcome_;
  mesh now_, tried_;
  standing standing_;
  bool quality_fell_ = false;  // in the last try
};

}  // namespace

void improve(const meshing_context& job, const refine_again& refine, mesh_outcome& outcome) {
  if (job.options.improve_passes == 0 || !outcome.complete) return;
  improver(job, refine, outcome).run();
}

}  // namespace asterism::internal
