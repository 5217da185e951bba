// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/boundary_distance.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "asterism/mesh/audit/number.hpp"
#include "asterism/mesh/audit/roots.hpp"
#include "asterism/mesh/support/infinity.hpp"

namespace asterism {
namespace {

using namespace internal::audit_detail;

// Returns the square of the distance from p to the point of the segment from a to b at t.
rational squared_distance(const point& p, const point& a, const point& b, double t) {
  const rational after(t), before = rational(1) - after;
  const vector2<rational> way{before * rational(a.x) + after * rational(b.x) - rational(p.x),
                              before * rational(a.y) + after * rational(b.y) - rational(p.y)};
  return dot(way, way);
}

// Walks along two polygons with the same ends at once, and finds the greatest distance of the two
// places on the way. It is an upper bound of the distance of the polygons, however the walk goes
// on, as long as it never goes back: between two stops both places move evenly, so that their
// distance is a convex function of time.
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
  // Place on a polygon: so far on the way from the vertex before `next` to that.
  struct place {
    std::size_t next = 1;
    double part = 0;
  };

  // Stops at the next vertex of `to`, and beside it on `beside`.
  void stop(const std::vector<point>& to, place& at, const std::vector<point>& beside,
            place& at_beside) {
    const point &p = to[at.next], &a = beside[at_beside.next - 1], &b = beside[at_beside.next];
    const double from = along(a), part = (along(p) - from) / (along(b) - from);
    if (part > at_beside.part) at_beside.part = std::min(part, 1.0);  // not where it is no number
    const rational square = squared_distance(p, a, b, at_beside.part);
    if (square > greatest_) greatest_ = square;
    at = {at.next + 1, 0};
  }

  // Returns how far a point is along the line between the ends, in doubles: it only tells where to
  // stop.
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

  // Returns an upper bound of the distance of what the mesh made of a segment and of its former
  // vertices.
  double distance(const segment& s, const std::vector<point>& between) const {
    if (s.a >= mesh_.given || s.b >= mesh_.given) return internal::infinity;
    const auto now = chain(s);
    if (!now) return internal::infinity;
    std::vector<point> before{shape_.vertices[s.a]};
    before.insert(before.end(), between.begin(), between.end());
    before.push_back(shape_.vertices[s.b]);
    if (!are_finite(*now) || !are_finite(before)) return internal::infinity;
    return root_rounded_up(common_walk(*now, before).greatest_square());
  }

 private:
  // Returns the boundary of the mesh from one end of a segment to the other, past no other vertex
  // of the domain.
  std::optional<std::vector<point>> chain(const segment& s) const {
    for (const vertex_index first : leaving_[s.a]) {
      std::vector<point> along{mesh_.sites[s.a].position};
      vertex_index v = first;
      // Bounded: a damaged mesh may go round without ever meeting a vertex of the domain.
      while (v >= mesh_.given && leaving_[v].size() == 1 && along.size() <= mesh_.boundary.size()) {
        along.push_back(mesh_.sites[v].position);
        v = leaving_[v].front();
      }
      if (v != s.b) continue;
      along.push_back(mesh_.sites[v].position);
      return along;
    }
    return std::nullopt;
  }

  const mesh& mesh_;
  const domain& shape_;
  std::vector<std::vector<vertex_index>> leaving_;
};

}  // namespace

former_boundary_report measure_former_boundary(const mesh& subject, const domain& shape,
                                               const former_boundary& former) {
  former_boundary_report report;
  for (const std::vector<point>& one : former.between) report.vertices_gone += one.size();
  const comparison compared(subject, shape);
  if (former.between.size() != shape.segments.size() || !compared.has_vertices()) {
    report.largest_distance = internal::infinity;
    return report;
  }
  for (std::size_t s = 0; s < former.between.size(); ++s)
    report.largest_distance =
        std::max(report.largest_distance, compared.distance(shape.segments[s], former.between[s]));
  return report;
}

}  // namespace asterism
