// SPDX-License-Identifier: MIT
#include "asterism/mesh/stars/boundary.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>

namespace asterism::internal {
namespace {

struct ray {
  vertex_index end;
  // True if the subsegment leaves the vertex along this ray, or enters along it; both if it is
  // internal.
  bool leaving = false, entering = false;
};

bool in_upper_half(const point& v, const point& a) {
  return a.y > v.y || (a.y == v.y && a.x > v.x);
}

// Sorts rays counter-clockwise from the positive x direction. The order is exact, and total because
// segments meet only in vertices, which makes the rays distinct.
void sort_rays(std::vector<ray>& rays, const point& v, const std::vector<point>& vertices,
               const star_predicates& kernel) {
  std::sort(rays.begin(), rays.end(), [&](const ray& a, const ray& b) {
    const point &pa = vertices[a.end], &pb = vertices[b.end];
    const bool ha = in_upper_half(v, pa), hb = in_upper_half(v, pb);
    if (ha != hb) return ha;
    return kernel.orientation(v, pa, pb) == sign::positive;
  });
}

// Collects the corners at a vertex; false if inside and outside do not alternate there. The inside
// follows each leaving ray counter-clockwise, up to the next ray, which must enter. A single ray is
// its own next one.
bool pair_rays(const std::vector<ray>& rays, std::vector<boundary_corner>& corners) {
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const ray& next = rays[(i + 1) % rays.size()];
    if (rays[i].leaving != next.entering) return false;
    if (rays[i].leaving) corners.push_back({rays[i].end, next.end});
  }
  return true;
}

}  // namespace

result<boundary> boundary::build(const domain& d, const star_predicates& kernel) {
  boundary b;
  // Counts the vertices up to the last one on a segment; all after it are isolated.
  std::size_t on_segments = 0;
  for (const segment& s : d.segments)
    on_segments = std::max({on_segments, std::size_t{s.a} + 1, std::size_t{s.b} + 1});
  std::vector<std::vector<ray>> rays(on_segments);
  for (std::size_t i = 0; i < d.segments.size(); ++i) {
    const segment& s = d.segments[i];
    const boundary_edge subsegment{s.a, s.b, static_cast<vertex_index>(i), s.marker, s.internal};
    b.add_subsegment(subsegment, false);
    rays[s.a].push_back({s.b, true, s.internal});
    rays[s.b].push_back({s.a, s.internal, true});
    if (!s.internal) continue;
    b.add_subsegment({subsegment.b, subsegment.a, subsegment.segment, subsegment.marker, true},
                     true);
    const std::size_t last = b.subsegments_.size() - 1;
    b.companions_[last - 1].twin = last;
    b.companions_[last].twin = last - 1;
  }
  b.corners_.resize(on_segments);
  for (std::size_t v = 0; v < rays.size(); ++v) {
    sort_rays(rays[v], d.vertices[v], d.vertices, kernel);
    if (!pair_rays(rays[v], b.corners_[v]))
      return error{"vertex " + std::to_string(v + 1) +
                       ": the segments at it do not separate inside from outside",
                   error_code::invalid_domain};
  }
  return b;
}

void boundary::add_subsegment(const boundary_edge& subsegment, bool backward) {
  companions_.push_back({subsegments_.size(), backward});
  subsegments_.push_back(subsegment);
}

std::optional<std::size_t> boundary::twin(std::size_t subsegment) const {
  if (!subsegments_[subsegment].internal) return std::nullopt;
  return companions_[subsegment].twin;
}

const std::vector<boundary_corner>& boundary::corners(vertex_index v) const {
  static const std::vector<boundary_corner> none;
  return v < corners_.size() ? corners_[v] : none;
}

bool boundary::is_subsegment(vertex_index a, vertex_index b) const {
  const auto& at_a = corners(a);
  return std::any_of(at_a.begin(), at_a.end(),
                     [b](const boundary_corner& c) { return c.first == b; });
}

void boundary::split(std::size_t subsegment, vertex_index m) {
  const boundary_edge whole = subsegments_[subsegment];
  // Grows the list in small steps: it has an entry for each site, and most sites may have no
  // corner.
  if (corners_.capacity() <= m) corners_.reserve(m + 1 + m / 8);
  if (corners_.size() <= m) corners_.resize(m + 1);
  corners_[m] = {{whole.b, whole.a}};
  const std::size_t second = subsegments_.size();
  split_one(subsegment, m);
  if (!whole.internal) return;
  // Completes the split of the twin: a -> b and b -> a became a -> m, m -> b and b -> m, m -> a.
  const std::size_t back = companions_[subsegment].twin;
  split_one(back, m);
  corners_[m].push_back({whole.a, whole.b});
  companions_[subsegment].twin = second + 1;
  companions_[second + 1].twin = subsegment;
  companions_[back].twin = second;
  companions_[second].twin = back;
}

void boundary::split_one(std::size_t subsegment, vertex_index m) {
  const boundary_edge whole = subsegments_[subsegment];
  subsegments_[subsegment].b = m;
  add_subsegment({m, whole.b, whole.segment, whole.marker, whole.internal},
                 companions_[subsegment].backward);
  for (boundary_corner& c : corners_[whole.a])
    if (c.first == whole.b) c.first = m;
  for (boundary_corner& c : corners_[whole.b])
    if (c.last == whole.a) c.last = m;
}

std::vector<boundary_edge> boundary::in_order() const {
  std::vector<boundary_edge> ordered;
  std::vector<boundary_edge> by_start;
  std::vector<vertex_index> ends;
  for (std::size_t i = 0; i < subsegments_.size(); ++i)
    if (!companions_[i].backward) by_start.push_back(subsegments_[i]);
  std::sort(by_start.begin(), by_start.end(), [](const boundary_edge& p, const boundary_edge& q) {
    return p.segment != q.segment ? p.segment < q.segment : p.a < q.a;
  });
  for (auto begin = by_start.begin(); begin != by_start.end();) {
    const auto end = std::find_if(
        begin, by_start.end(), [&](const boundary_edge& p) { return p.segment != begin->segment; });
    // Finds the start of a chain: the one vertex that ends no subsegment of it.
    ends.clear();
    for (auto p = begin; p != end; ++p) ends.push_back(p->b);
    std::sort(ends.begin(), ends.end());
    auto at = std::find_if(begin, end, [&](const boundary_edge& p) {
      return !std::binary_search(ends.begin(), ends.end(), p.a);
    });
    for (auto steps = end - begin; steps > 0 && at != end; --steps) {
      ordered.push_back(*at);
      at = std::lower_bound(begin, end, at->b,
                            [](const boundary_edge& p, vertex_index a) { return p.a < a; });
    }
    begin = end;
  }
  return ordered;
}

}  // namespace asterism::internal
