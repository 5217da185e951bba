// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/optimize/mutable_mesh.hpp"

namespace asterism::internal::fitting {
namespace {

// Triangles come out larger than those of the start by this much: it takes fewer to be as good.
constexpr double part_of_triangles = 0.76;
constexpr int most_smoothing = 10;
constexpr double degrees_to_spare = 0.5;

error not_a_triangulation(const std::string& what) {
  return {"what is to be fitted is no triangulation of the domain: " + what};
}

double angle_seen(const fit_site& from, const point& a, const point& b) {
  const point u = from.seen(a.x - from.position.x, a.y - from.position.y);
  const point w = from.seen(b.x - from.position.x, b.y - from.position.y);
  return elementary::atan2(u.x * w.y - u.y * w.x, u.x * w.x + u.y * w.y) * 180 / std::numbers::pi;
}

}  // namespace

result<fitted_mesh> fitted_mesh::build(const domain& d, const metric_field& field,
                                       const mesh& start, double angle_bound, double target_angle) {
  fitted_mesh made(d, field);
  const auto cotangent = [](double degrees) {
    return 1 / elementary::tan(degrees * std::numbers::pi / 180);
  };
  made.wanted_ = {cotangent(target_angle),
                  cotangent(std::min(target_angle, angle_bound + degrees_to_spare))};
  if (auto failure = made.add_sites(start)) return *failure;
  if (auto failure = made.add_places(start)) return *failure;
  if (auto failure = made.add_triangles(start)) return *failure;
  if (auto failure = made.add_subsegments(start)) return *failure;
  made.find_sharp_corners(angle_bound);
  made.choose_areas();
  for (vertex_index t = 0; t < made.triangles_.size(); ++t) {
    made.sharp_[t] = made.touches_sharp_corner(made.triangles_[t].v) ? 1 : 0;
    made.judge(t);
  }
  return made;
}

std::optional<error> fitted_mesh::add_sites(const mesh& start) {
  if (start.given != domain_->vertices.size() || start.sites.size() < start.given)
    return not_a_triangulation(
        fmt::format("it has {} sites of which {} are given, the domain {} "
                    "vertices",
                    start.sites.size(), start.given, domain_->vertices.size()));
  for (const site& s : start.sites) {
    const auto made = site_at(s.position, 0);
    if (!made) return *field_failure_;
    sites_.push_back(*made);
  }
  around_.resize(sites_.size());
  places_.resize(sites_.size());
  kinds_.assign(sites_.size(), vertex_kind::free);
  std::fill_n(kinds_.begin(), start.given, vertex_kind::given);
  return std::nullopt;
}

std::optional<error> fitted_mesh::add_places(const mesh& start) {
  for (const boundary_edge& e : start.boundary) {
    if (e.a >= sites_.size() || e.b >= sites_.size() || e.segment >= domain_->segments.size())
      return not_a_triangulation(
          fmt::format("there is no piece {} - {} of segment {}", e.a, e.b, e.segment));
    const segment& whole = domain_->segments[e.segment];
    const point &a = domain_->vertices[whole.a], &b = domain_->vertices[whole.b];
    const double dx = b.x - a.x, dy = b.y - a.y;
    for (const vertex_index v : {e.a, e.b}) {
      if (kinds_[v] == vertex_kind::given) continue;
      const point& q = sites_[v].position;
      const double along = ((q.x - a.x) * dx + (q.y - a.y) * dy) / (dx * dx + dy * dy);
      if (kinds_[v] == vertex_kind::sliding && places_[v].segment != e.segment)
        return not_a_triangulation(fmt::format("site {} is on two segments", v));
      kinds_[v] = vertex_kind::sliding;
      places_[v] = {e.segment, along};
    }
  }
  return std::nullopt;
}

std::optional<error> fitted_mesh::add_triangles(const mesh& start) {
  if (!start.disagreeing.empty()) return not_a_triangulation("some triangles disagree");
  if (start.triangles.empty()) return not_a_triangulation("there are no triangles");
  for (const triangle& t : start.triangles) {
    const auto& [a, b, c] = t;
    const auto said = [&t](const char* what) {
      return not_a_triangulation(fmt::format("triangle {} {} {} {}", t[0], t[1], t[2], what));
    };
    if (std::max({a, b, c}) >= sites_.size()) return said("has a vertex that is no site");
    if (!surely_turns_left(sites_[a].position, sites_[b].position, sites_[c].position))
      return said("does not turn left, as far as doubles can tell");
    const vertex_index added = add_triangle();
    triangles_[added].v = t;
    link(added);
    for (const vertex_index s : triangles_[added].next)
      if (s != none && std::count(triangles_[s].next.begin(), triangles_[s].next.end(), added) != 1)
        return said("has two edges in common with another one");
    for (const vertex_index u : t) around_[u].push_back(added);
    ++count_;
  }
  return std::nullopt;
}

bool fitted_mesh::set_subsegment(vertex_index a, vertex_index b, vertex_index segment) {
  for (const vertex_index t : around_[a]) {
    fit_triangle& here = triangles_[t];
    const std::size_t i = here.corner_of(a);
    if (here.v[(i + 1) % 3] != b) continue;
    here.segment[(i + 2) % 3] = segment;
    return true;
  }
  return false;
}

// Afterwards every edge is a subsegment, or has a triangle on either side.
std::optional<error> fitted_mesh::add_subsegments(const mesh& start) {
  for (const boundary_edge& e : start.boundary) {
    const bool both_sides =
        set_subsegment(e.a, e.b, e.segment) && (!e.internal || set_subsegment(e.b, e.a, e.segment));
    if (!both_sides)
      return not_a_triangulation(
          fmt::format("piece {} - {} is no edge of a triangle on its side", e.a, e.b));
  }
  for (const fit_triangle& t : triangles_)
    for (std::size_t i = 0; i < 3; ++i) {
      const vertex_index a = t.v[(i + 1) % 3], b = t.v[(i + 2) % 3];
      const auto where = [&](const char* what) {
        return not_a_triangulation(fmt::format("edge {} - {} {}", a, b, what));
      };
      if (t.segment[i] == none && t.next[i] == none)
        return where("has a triangle on one side only");
      if (t.next[i] == none) continue;
      const fit_triangle& other = triangles_[t.next[i]];
      const std::size_t j = (other.corner_of(a) + 1) % 3;
      if (&triangles_[other.next[j]] != &t || other.v[(j + 1) % 3] != b)
        return where("is in more than two triangles");
    }
  for (vertex_index v = 0; v < sites_.size(); ++v)
    if (around_[v].empty()) return not_a_triangulation(fmt::format("site {} is in no triangle", v));
  return std::nullopt;
}

// The corner that begins at the triangle's edge from its vertex `at` to the next one, a subsegment.
std::optional<sharp_corner> fitted_mesh::corner_from(vertex_index t, std::size_t at,
                                                     double angle_bound) const {
  const vertex_index v = triangles_[t].v[at];
  const point& o = sites_[v].position;
  const point first = sites_[triangles_[t].v[(at + 1) % 3]].position;
  double angle = 0;
  for (std::size_t turns = 0; turns < around_[v].size(); ++turns) {
    const fit_triangle& here = triangles_[t];
    const std::size_t i = here.corner_of(v);
    const point& last = sites_[here.v[(i + 2) % 3]].position;
    angle += angle_seen(sites_[v], sites_[here.v[(i + 1) % 3]].position, last);
    if (!(angle < angle_bound)) return std::nullopt;
    if (here.segment[(i + 1) % 3] != none)
      return sharp_corner{v, {first.x - o.x, first.y - o.y}, {last.x - o.x, last.y - o.y}};
    t = here.next[(i + 1) % 3];
  }
  return std::nullopt;
}

void fitted_mesh::find_sharp_corners(double angle_bound) {
  for (vertex_index v = 0; v < domain_->vertices.size(); ++v)
    for (const vertex_index t : around_[v]) {
      const std::size_t at = triangles_[t].corner_of(v);
      if (triangles_[t].segment[(at + 2) % 3] == none) continue;
      if (const auto corner = corner_from(t, at, angle_bound)) sharp_corners_.push_back(*corner);
    }
}

// Edges do not cross segments, so the middle of a triangle's corner tells on which side of them it
// is.
bool fitted_mesh::touches_sharp_corner(const std::array<vertex_index, 3>& v) const {
  if (sharp_corners_.empty()) return false;
  const auto cross = [](const point& a, const point& b) { return a.x * b.y - a.y * b.x; };
  for (std::size_t i = 0; i < 3; ++i) {
    if (kinds_[v[i]] != vertex_kind::given) continue;
    const auto [first, last] = std::equal_range(
        sharp_corners_.begin(), sharp_corners_.end(), sharp_corner{v[i], {}, {}},
        [](const sharp_corner& a, const sharp_corner& b) { return a.vertex < b.vertex; });
    const point &o = sites_[v[i]].position, &p = sites_[v[(i + 1) % 3]].position,
                &q = sites_[v[(i + 2) % 3]].position;
    const point middle{(p.x - o.x) + (q.x - o.x), (p.y - o.y) + (q.y - o.y)};
    if (std::any_of(first, last, [&](const sharp_corner& c) {
          return cross(c.first, middle) > 0 && cross(middle, c.last) > 0;
        }))
      return true;
  }
  return false;
}

// Of each vertex that of the triangles around it, smoothed so that single ones do not count; then
// all enlarged so that it takes `part_of_triangles` as many.
void fitted_mesh::choose_areas() {
  std::vector<double> areas, logs(sites_.size());
  for (const fit_triangle& t : triangles_)
    areas.push_back(metric_area(sites_[t.v[0]], sites_[t.v[1]], sites_[t.v[2]]));
  for (vertex_index v = 0; v < sites_.size(); ++v) {
    double sum = 0;
    for (const vertex_index t : around_[v]) sum += areas[t];
    logs[v] = elementary::log(sum / static_cast<double>(around_[v].size()));
  }
  for (int step = 0; step < most_smoothing; ++step) {
    const std::vector<double> before = logs;
    for (vertex_index v = 0; v < sites_.size(); ++v) {
      double sum = 0;
      for (const vertex_index t : around_[v])
        for (const vertex_index u : triangles_[t].v) sum += before[u];
      logs[v] = sum / (3 * static_cast<double>(around_[v].size()));
    }
  }
  double wanted = 0;
  for (vertex_index t = 0; t < triangles_.size(); ++t) {
    const auto& [a, b, c] = triangles_[t].v;
    wanted += areas[t] / elementary::exp((logs[a] + logs[b] + logs[c]) / 3);
  }
  const double larger =
      elementary::log(wanted / (part_of_triangles * static_cast<double>(triangles_.size())));
  for (vertex_index v = 0; v < sites_.size(); ++v) sites_[v].log_area = logs[v] + larger;
}

}  // namespace asterism::internal::fitting
