// SPDX-License-Identifier: MIT
#include "asterism/mesh/transfer/locate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <string>
#include <utility>

#include "asterism/mesh/data/site_box.hpp"
#include "asterism/mesh/numerics/nodal_sums.hpp"
#include "asterism/mesh/transfer/triangle_finder.hpp"

namespace asterism::internal {
namespace {

class locator {
 public:
  locator(const mesh& in, const mesh_links& links, const mesh& of, const mesh_links& of_links)
      : links_(links), of_(of), of_links_(of_links), finder_(in, links) {}

  result<located_vertices> run() {
    found_.triangle = finder_.find_all(positions_of(of_.sites), box_of_sites(of_.sites));
    choose_sides();
    for (const vertex_index v : missing()) ++found_.outside, outside_.push_back(v);
    if (auto failed = follow_neighbours()) return *failed;
    return std::move(found_);
  }

 private:
  std::vector<vertex_index> missing() const {
    std::vector<vertex_index> all;
    for (vertex_index v = 0; v < found_.triangle.size(); ++v)
      if (found_.triangle[v] == no_triangle) all.push_back(v);
    return all;
  }

  // True if the triangle t, which contains q, extends from q towards the point m.
  bool leads(vertex_index t, const point& q, const point& m) const {
    const auto c = finder_.corners(t);
    for (std::size_t i = 0; i < 3; ++i) {
      const point &a = c[i], &b = c[(i + 1) % 3];
      if (finder_.kernel().orientation(a, b, q) == sign::zero &&
          finder_.kernel().orientation(a, b, m) == sign::negative)
        return false;
    }
    return true;
  }

  // Lists the triangles that contain q and are joined to t by edges that contain it.
  std::vector<vertex_index> fan_of(vertex_index t, const point& q) const {
    std::vector<vertex_index> fan{t};
    for (std::size_t k = 0; k < fan.size(); ++k) {
      const auto c = finder_.corners(fan[k]);
      for (std::size_t i = 0; i < 3; ++i) {
        const vertex_index next = links_.across(fan[k], i);
        if (next != no_triangle &&
            finder_.kernel().orientation(c[(i + 1) % 3], c[(i + 2) % 3], q) == sign::zero &&
            std::find(fan.begin(), fan.end(), next) == fan.end())
          fan.push_back(next);
      }
    }
    return fan;
  }

  // True if t extends from v towards the middle of one of v's own triangles.
  bool is_on_side_of(vertex_index v, vertex_index t) const {
    const point& q = of_.sites[v].position;
    for (const incidence& at : of_links_.around(v)) {
      const triangle& own = of_.triangles[at.triangle];
      point m{0, 0};
      for (const vertex_index w : own) {
        m.x += of_.sites[w].position.x / 3;
        m.y += of_.sites[w].position.y / 3;
      }
      if (leads(t, q, m)) return true;
    }
    return false;
  }

  // Locates vertices on a slit again: both sides of the slit are at the same place, so the side of
  // the vertex's own triangles is chosen.
  void choose_sides() {
    std::vector<char> is_wrong(of_.sites.size(), 0);
    for_each_node(of_.sites.size(), [&](std::size_t i) {
      const auto v = static_cast<vertex_index>(i);
      const vertex_index t = found_.triangle[v];
      if (t == no_triangle || !of_links_.on_boundary(v) || is_on_side_of(v, t)) return;
      const std::vector<vertex_index> fan = fan_of(t, of_.sites[v].position);
      is_wrong[v] =
          std::any_of(fan.begin(), fan.end(), [&](vertex_index s) { return is_on_side_of(v, s); })
              ? 0
              : 1;
    });
    for (vertex_index v = 0; v < is_wrong.size(); ++v) {
      if (is_wrong[v] == 0) continue;
      finder_.make_boxes();
      const vertex_index other = finder_.first_with(
          of_.sites[v].position, [&](vertex_index t) { return is_on_side_of(v, t); });
      if (other != no_triangle) found_.triangle[v] = other;
    }
  }

  double distance_to(vertex_index t, const point& q) const {
    const auto c = finder_.corners(t);
    if (finder_.exit_from(t, q, 0) == 3) return 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
      const point &a = c[i], &b = c[(i + 1) % 3];
      const double x = b.x - a.x, y = b.y - a.y;
      const double s = std::clamp(((q.x - a.x) * x + (q.y - a.y) * y) / (x * x + y * y), 0.0, 1.0);
      const double dx = q.x - a.x - s * x, dy = q.y - a.y - s * y;
      least = std::min(least, std::sqrt(dx * dx + dy * dy));
    }
    return least;
  }

  // Searches the triangles joined to `from`, the nearest to q first, as long as nearer ones may be
  // found.
  std::pair<double, vertex_index> nearest_from(vertex_index from, const point& q) const {
    constexpr std::size_t most = 512;
    using entry = std::pair<double, vertex_index>;
    std::priority_queue<entry, std::vector<entry>, std::greater<>> open;
    std::vector<vertex_index> seen{from};
    entry best{distance_to(from, q), from};
    open.push(best);
    while (!open.empty() && seen.size() < most && best.first > 0) {
      const vertex_index t = open.top().second;
      open.pop();
      for (std::size_t i = 0; i < 3; ++i) {
        const vertex_index next = links_.across(t, i);
        if (next == no_triangle || std::find(seen.begin(), seen.end(), next) != seen.end())
          continue;
        seen.push_back(next);
        const entry e{distance_to(next, q), next};
        best = std::min(best, e);
        open.push(e);
      }
    }
    return best;
  }

  // Assigns to each vertex outside the mesh a triangle near the triangle of a neighbour, beginning
  // with vertices beside located ones.
  std::optional<error> follow_neighbours() {
    std::vector<vertex_index> waiting = outside_;
    while (!waiting.empty()) {
      std::vector<std::pair<vertex_index, vertex_index>> done;
      std::vector<vertex_index> later;
      for (const vertex_index v : waiting) {
        std::pair<double, vertex_index> best{std::numeric_limits<double>::infinity(), no_triangle};
        for (const vertex_index w : of_links_.neighbours(v))
          if (found_.triangle[w] != no_triangle)
            best = std::min(best, nearest_from(found_.triangle[w], of_.sites[v].position));
        if (best.second == no_triangle) {
          later.push_back(v);
        } else {
          done.emplace_back(v, best.second);
          found_.greatest_distance = std::max(found_.greatest_distance, best.first);
        }
      }
      if (done.empty())
        return error{"vertex " + std::to_string(waiting[0] + 1) +
                     " of the new mesh is in a part that the old mesh does not touch"};
      for (const auto& [v, t] : done) found_.triangle[v] = t;
      waiting = std::move(later);
    }
    return std::nullopt;
  }

  const mesh_links& links_;
  const mesh& of_;
  const mesh_links& of_links_;
  located_vertices found_;
  std::vector<vertex_index> outside_;
  triangle_finder finder_;
};

}  // namespace

result<located_vertices> locate_vertices(const mesh& in, const mesh_links& links, const mesh& of,
                                         const mesh_links& of_links) {
  return locator(in, links, of, of_links).run();
}

}  // namespace asterism::internal
