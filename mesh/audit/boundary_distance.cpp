// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/boundary_distance.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "asterism/mesh/audit/number.hpp"
#include "asterism/mesh/audit/roots.hpp"
#include "asterism/mesh/support/infinity.hpp"

namespace asterism {
namespace {

using namespace internal::audit_detail;

// Returns the square of the distance from p to the point a + t (b - a), exactly.
rational squared_distance(const point& p, const point& a, const point& b, double t) {
  const rational after(t), before = rational(1) - after;
  const vector2<rational> way{before * rational(a.x) + after * rational(b.x) - rational(p.x),
                              before * rational(a.y) + after * rational(b.y) - rational(p.y)};
  return dot(way, way);
}

// Walks along two polygons with the same ends at once, and finds the greatest distance of the two
// places on the way. It is an upper bound of the distance of the polygons, however the walk goes
// on, as long as neither place moves back: between two stops both places move at constant speed, so
// that their distance is a convex function of time.
class common_walk {
 public:
  common_walk(const std::vector<point>& one, const std::vector<point>& other)
      : one_(one), other_(other) {}

  rational greatest_square() {
    while (at_one_.next + 1 < one_.size() || at_other_.next + 1 < other_.size()) {
      const bool other_is_last = at_other_.next + 1 == other_.size();
      const bool is_one_first =
          at_one_.next + 1 < one_.size() &&
          (other_is_last || along(one_[at_one_.next]) <= along(other_[at_other_.next]));
      if (is_one_first)
        stop(one_, at_one_, other_, at_other_);
      else
        stop(other_, at_other_, one_, at_one_);
    }
    return greatest_;
  }

 private:
  // A place on a polygon: the index of the next vertex, and the part of the edge before it that is
  // passed.
  struct place {
    std::size_t next = 1;
    double part = 0;
  };

  // Advances one place to the next vertex of `to`, and the other along its present edge of `beside`
  // to the point about level with that vertex. Updates the greatest distance by that of the two.
  void stop(const std::vector<point>& to, place& at, const std::vector<point>& beside,
            place& at_beside) {
    const point &p = to[at.next], &a = beside[at_beside.next - 1], &b = beside[at_beside.next];
    const double from = along(a), part = (along(p) - from) / (along(b) - from);
    if (part > at_beside.part) at_beside.part = std::min(part, 1.0);  // not where it is no number
    const rational square = squared_distance(p, a, b, at_beside.part);
    if (square > greatest_) greatest_ = square;
    at = {at.next + 1, 0};
  }

  // Returns how far p is along the line between the ends of the first polygon, in doubles and
  // scaled by the line's length: it only chooses where to measure.
  double along(const point& p) const {
    const point &a = one_.front(), &b = one_.back();
    return (p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y);
  }

  const std::vector<point>&one_, &other_;
  place at_one_, at_other_;
  rational greatest_ = 0;
};

bool are_finite(const std::vector<point>& points) {
  return std::all_of(points.begin(), points.end(),
                     [](const point& p) { return std::isfinite(p.x) && std::isfinite(p.y); });
}

// Vertices of the domain along joined segments: each is joined to the next by a segment.
using way = std::vector<vertex_index>;
using ends = std::pair<vertex_index, vertex_index>;

ends ends_of(vertex_index a, vertex_index b) { return std::minmax(a, b); }

// Joins the chords of each divided curve: the way of the first chord becomes that along all of
// them, the ways of the other chords become empty.
void join_chords(const domain& shape, std::vector<way>& ways) {
  std::map<ends, std::size_t> segment_at;
  for (std::size_t s = 0; s < shape.segments.size(); ++s)
    segment_at[ends_of(shape.segments[s].a, shape.segments[s].b)] = s;
  for (const domain_curve& c : shape.curves) {
    way along(c.vertices.begin(), c.vertices.end());
    if (along.size() < 3 || along.front() == along.back()) continue;
    std::vector<std::size_t> chords;
    for (std::size_t i = 0; i + 1 < along.size(); ++i) {
      const auto found = segment_at.find(ends_of(along[i], along[i + 1]));
      if (found != segment_at.end() && ways[found->second].size() == 2)
        chords.push_back(found->second);
    }
    if (chords.size() + 1 != along.size()) continue;
    if (shape.segments[chords.front()].a != along.front()) std::reverse(along.begin(), along.end());
    for (const std::size_t chord : chords) ways[chord].clear();
    ways[chords.front()] = std::move(along);
  }
}

// Returns for each segment the vertices along which the former boundary is listed: its ends, or all
// vertices of a divided curve.
std::vector<way> ways_along(const domain& shape) {
  std::vector<way> ways;
  for (const segment& s : shape.segments) ways.push_back({s.a, s.b});
  join_chords(shape, ways);
  return ways;
}

class comparison {
 public:
  comparison(const mesh& subject, const domain& shape)
      : mesh_(subject), shape_(shape), leaving_(subject.sites.size()) {
    for (const boundary_edge& e : subject.boundary)
      if (e.a < leaving_.size() && e.b < leaving_.size()) leaving_[e.a].push_back(e.b);
  }

  bool has_vertices() const {
    if (mesh_.given != shape_.vertices.size() || mesh_.given > mesh_.sites.size()) return false;
    for (vertex_index v = 0; v < mesh_.given; ++v)
      if (!(mesh_.sites[v].position == shape_.vertices[v])) return false;
    return true;
  }

  // Returns an upper bound of the distance between two polygons: the part of the mesh's boundary
  // along the domain's vertices in `along`, and the former boundary with the vertices `between` its
  // ends.
  double distance(const way& along, const std::vector<point>& between) const {
    std::vector<point> now;
    for (std::size_t i = 0; i + 1 < along.size(); ++i) {
      const auto next = chain(along[i], along[i + 1]);
      if (!next) return internal::infinity;
      now.insert(now.end(), next->begin() + (i == 0 ? 0 : 1), next->end());
    }
    std::vector<point> before{shape_.vertices[along.front()]};
    before.insert(before.end(), between.begin(), between.end());
    before.push_back(shape_.vertices[along.back()]);
    if (!are_finite(now) || !are_finite(before)) return internal::infinity;
    return root_rounded_up(common_walk(now, before).greatest_square());
  }

 private:
  // Returns the boundary vertices of the mesh from one vertex of the domain to the next one given.
  std::optional<std::vector<point>> chain(vertex_index from, vertex_index to) const {
    for (const vertex_index first : leaving_[from]) {
      std::vector<point> along{mesh_.sites[from].position};
      vertex_index v = first;
      // Bounds the walk by the number of edges: the boundary of a damaged mesh may close without a
      // vertex of the domain.
      while (v >= mesh_.given && leaving_[v].size() == 1 && along.size() <= mesh_.boundary.size()) {
        along.push_back(mesh_.sites[v].position);
        v = leaving_[v].front();
      }
      if (v != to) continue;
      along.push_back(mesh_.sites[v].position);
      return along;
    }
    return std::nullopt;
  }

  const mesh& mesh_;
  const domain& shape_;
  std::vector<std::vector<vertex_index>> leaving_;
};

// True if the ends of all segments and curves are vertices of the domain, in range.
bool has_ends(const domain& d) {
  const auto is_there = [&d](vertex_index v) { return v < d.vertices.size(); };
  return std::all_of(d.segments.begin(), d.segments.end(),
                     [&](const segment& s) { return is_there(s.a) && is_there(s.b); }) &&
         std::all_of(d.curves.begin(), d.curves.end(), [&](const domain_curve& c) {
           return std::all_of(c.vertices.begin(), c.vertices.end(), is_there);
         });
}

}  // namespace

former_boundary_report measure_former_boundary(const mesh& subject, const domain& shape,
                                               const former_boundary& former) {
  former_boundary_report report;
  for (const std::vector<point>& one : former.between) report.vertices_gone += one.size();
  const comparison compared(subject, shape);
  if (former.between.size() != shape.segments.size() || !compared.has_vertices() ||
      !has_ends(shape)) {
    report.largest_distance = internal::infinity;
    return report;
  }
  const std::vector<way> ways = ways_along(shape);
  for (std::size_t s = 0; s < ways.size(); ++s) {
    const std::vector<point>& between = former.between[s];
    const double distance = !ways[s].empty()  ? compared.distance(ways[s], between)
                            : between.empty() ? 0
                                              : internal::infinity;
    report.largest_distance = std::max(report.largest_distance, distance);
  }
  return report;
}

}  // namespace asterism
