// SPDX-License-Identifier: MIT
#include "asterism/mesh/optimize/mutable_mesh_build.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "asterism/core/elementary.hpp"

namespace asterism::internal::fitting {
namespace {

error not_a_triangulation(const std::string& what) {
  return {"what is to be fitted is no triangulation of the domain: " + what,
          error_code::invalid_mesh};
}

class builder {
 public:
  builder(const domain& d, field_sampler& sampler, const mesh& start)
      : domain_(d), sampler_(sampler), start_(start), net_(d) {}

  result<mutable_triangulation> run() {
    if (auto failure = add_sites()) return *failure;
    if (auto failure = add_places()) return *failure;
    if (auto failure = add_triangles()) return *failure;
    if (auto failure = add_subsegments()) return *failure;
    if (auto failure = check_neighbours()) return *failure;
    return std::move(net_);
  }

 private:
  std::optional<error> add_sites() {
    if (start_.given != domain_.vertices.size() || start_.sites.size() < start_.given)
      return not_a_triangulation(
          fmt::format("it has {} sites of which {} are given, the domain {} vertices",
                      start_.sites.size(), start_.given, domain_.vertices.size()));
    for (const site& s : start_.sites) {
      const auto measured = sampler_.at(s.position);
      if (!measured) return sampler_.failure();
      const bool given = net_.sites().size() < start_.given;
      net_.add_vertex(make_fit_site(s.position, measured->metric, 0),
                      given ? vertex_kind::given : vertex_kind::free, {});
    }
    return std::nullopt;
  }

  std::optional<error> add_places() {
    for (const boundary_edge& e : start_.boundary) {
      if (e.a >= net_.sites().size() || e.b >= net_.sites().size() ||
          e.segment >= domain_.segments.size())
        return not_a_triangulation(
            fmt::format("there is no subsegment {} - {} of segment {}", e.a, e.b, e.segment));
      for (const vertex_index v : {e.a, e.b}) {
        if (net_.kind(v) == vertex_kind::given) continue;
        if (net_.kind(v) == vertex_kind::sliding && net_.place(v).segment != e.segment)
          return not_a_triangulation(fmt::format("site {} is on two segments", v));
        net_.put_on_segment(v, {e.segment, along(e.segment, net_.sites()[v].position)});
      }
    }
    return std::nullopt;
  }

  // Returns how far along the segment the point is, from 0 to 1.
  double along(vertex_index s, const point& q) const {
    const segment& whole = domain_.segments[s];
    const point &a = domain_.vertices[whole.a], &b = domain_.vertices[whole.b];
    const double dx = b.x - a.x, dy = b.y - a.y;
    return ((q.x - a.x) * dx + (q.y - a.y) * dy) / (dx * dx + dy * dy);
  }

  std::optional<error> add_triangles() {
    if (!start_.disagreeing.empty()) return not_a_triangulation("some triangles disagree");
    if (start_.triangles.empty()) return not_a_triangulation("there are no triangles");
    for (const triangle& t : start_.triangles) {
      const auto& [a, b, c] = t;
      const auto said = [&t](const char* what) {
        return not_a_triangulation(fmt::format("triangle {} {} {} {}", t[0], t[1], t[2], what));
      };
      const auto& sites = net_.sites();
      if (std::max({a, b, c}) >= sites.size()) return said("has a vertex that is no site");
      if (!surely_turns_left(sites[a].position, sites[b].position, sites[c].position))
        return said("does not turn left, as far as doubles can tell");
      const vertex_index added = net_.add_triangle();
      net_.set_triangle(added, t, {none, none, none});
      for (const vertex_index s : net_.triangles()[added].next) {
        if (s == none) continue;
        const auto& back = net_.triangles()[s].next;
        if (std::count(back.begin(), back.end(), added) != 1)
          return said("has two edges in common with another one");
      }
    }
    return std::nullopt;
  }

  std::optional<error> add_subsegments() {
    for (const boundary_edge& e : start_.boundary) {
      const bool both_sides = net_.set_subsegment(e.a, e.b, e.segment) &&
                              (!e.internal || net_.set_subsegment(e.b, e.a, e.segment));
      if (!both_sides)
        return not_a_triangulation(
            fmt::format("subsegment {} - {} is no edge of a triangle on its side", e.a, e.b));
    }
    return std::nullopt;
  }

  // Checks that every edge is a subsegment or has a triangle on either side, and that every vertex
  // is in a triangle.
  std::optional<error> check_neighbours() const {
    for (vertex_index t = 0; t < net_.triangles().size(); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        const fit_triangle& here = net_.triangles()[t];
        const vertex_index a = here.v[(i + 1) % 3], b = here.v[(i + 2) % 3];
        const auto where = [&](const char* what) {
          return not_a_triangulation(fmt::format("edge {} - {} {}", a, b, what));
        };
        const auto across = net_.opposite(t, i);
        if (!across && here.segment[i] == none) return where("has a triangle on one side only");
        if (!across) continue;
        const fit_triangle& other = net_.triangles()[across->triangle];
        if (other.next[across->edge] != t || other.v[(across->edge + 1) % 3] != b)
          return where("is in more than two triangles");
      }
    for (vertex_index v = 0; v < net_.sites().size(); ++v)
      if (net_.around(v).empty())
        return not_a_triangulation(fmt::format("site {} is in no triangle", v));
    return std::nullopt;
  }

  const domain& domain_;
  field_sampler& sampler_;
  const mesh& start_;
  mutable_triangulation net_;
};

// Returns, for each vertex, the mean of the logarithms at the vertices of the triangles at it. A
// vertex counts once for each triangle.
std::vector<double> smoothed(const mutable_triangulation& net, const std::vector<double>& logs) {
  std::vector<double> means(logs.size());
  for (vertex_index v = 0; v < logs.size(); ++v) {
    double sum = 0;
    for (const vertex_index t : net.around(v))
      for (const vertex_index u : net.triangles()[t].v) sum += logs[u];
    means[v] = sum / (3 * static_cast<double>(net.around(v).size()));
  }
  return means;
}

}  // namespace

result<mutable_triangulation> build_triangulation(const domain& d, field_sampler& sampler,
                                                  const mesh& start) {
  return builder(d, sampler, start).run();
}

void choose_areas(mutable_triangulation& net) {
  // Number of triangles wanted, as a part of the start's: larger ones are enough to be as good.
  constexpr double part_of_triangles = 0.76;
  constexpr int rounds_of_smoothing = 10;
  const std::vector<fit_triangle>& triangles = net.triangles();
  std::vector<double> areas, logs(net.sites().size());
  for (const fit_triangle& t : triangles)
    areas.push_back(metric_area(net.sites()[t.v[0]], net.sites()[t.v[1]], net.sites()[t.v[2]]));
  for (vertex_index v = 0; v < logs.size(); ++v) {
    double sum = 0;
    for (const vertex_index t : net.around(v)) sum += areas[t];
    logs[v] = elementary::log(sum / static_cast<double>(net.around(v).size()));
  }
  for (int round = 0; round < rounds_of_smoothing; ++round) logs = smoothed(net, logs);
  double wanted = 0;
  for (vertex_index t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t].v;
    wanted += areas[t] / elementary::exp((logs[a] + logs[b] + logs[c]) / 3);
  }
  const double larger =
      elementary::log(wanted / (part_of_triangles * static_cast<double>(triangles.size())));
  for (vertex_index v = 0; v < logs.size(); ++v) net.set_log_area(v, logs[v] + larger);
}

}  // namespace asterism::internal::fitting
