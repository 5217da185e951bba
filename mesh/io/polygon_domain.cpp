// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/polygon_domain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/domain/message_names.hpp"
#include "asterism/mesh/domain/planar_graph.hpp"

namespace asterism::internal {
namespace {

// Appends the ring's vertices and segments; returns the indices of the segments.
std::vector<std::uint32_t> add_ring(const ring& corners, int marker, domain& d) {
  const auto first = static_cast<vertex_index>(d.vertices.size());
  std::size_t n = corners.size();
  while (n > 1 && corners[n - 1] == corners[0]) --n;
  std::vector<std::uint32_t> added;
  if (n < 2) return added;
  d.vertices.insert(d.vertices.end(), corners.begin(),
                    corners.begin() + static_cast<std::ptrdiff_t>(n));
  for (vertex_index k = 0; k < n; ++k) {
    added.push_back(static_cast<std::uint32_t>(d.segments.size()));
    d.segments.push_back({first + k, first + (k + 1) % static_cast<vertex_index>(n), marker});
  }
  return added;
}

// True if the area is certainly not 0, in doubles with an error bound. With u half an epsilon, a
// product of two differences is off by 3u of its size, the difference of two by u more, each of n
// sums by u, and the sum of the sizes itself by (n + 3)u: less than (2n + 8)u of that in all.
// Underflow is far less.
bool surely_has_area(const ring& corners) {
  double area = 0, terms = 0;
  const point& o = corners[0];
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const double x = corners[i].x - o.x, y = corners[i].y - o.y, u = corners[i + 1].x - o.x,
                 w = corners[i + 1].y - o.y;
    area += x * w - y * u;
    terms += std::abs(x * w) + std::abs(y * u);
  }
  const double off =
      (static_cast<double>(corners.size()) + 8) * std::numeric_limits<double>::epsilon() * terms;
  return std::isfinite(terms) && terms > std::numeric_limits<double>::min() / 0x1p-60 &&
         std::abs(area) > off;
}

// True if the ring runs along each of its edges an even number of times: it then separates nothing.
// A ring that crosses itself is not refused.
bool encloses_nothing(const ring& corners) {
  if (corners.size() < 3) return true;
  if (surely_has_area(corners)) return false;
  domain alone;
  add_ring(corners, 0, alone);
  domain_repairs unasked;
  const auto graph = build_plane_graph(alone, unasked);
  return graph && std::all_of(graph.value().edges.begin(), graph.value().edges.end(),
                              [](const covered_edge& e) { return e.covered % 2 == 0; });
}

// Returns a sentence of the form "what: 3, the first: ...".
std::string text_of(const std::string& what, const occurrences& of) {
  return what + ": " + std::to_string(of.count) + (of.count == 1 ? ", " : ", the first: ") +
         of.first;
}

void note(const std::string& what, const occurrences& of, domain& d) {
  if (of.count > 0) d.origin.notes.push_back(d.name + ": " + text_of(what, of));
}

// Returns the refusal of a file in which nothing is left to mesh, with its contents.
error nothing_left(const polygons_read& read, const occurrences& flat, const std::string& name) {
  std::string beside;
  const auto add = [&](const std::string& what, const occurrences& of) {
    if (of.count > 0) beside += "; " + text_of(what, of);
  };
  add("points and lines", read.others);
  add("empty geometries", read.empty);
  add("rings without area", flat);
  return {
      name + ": there is no polygon " + (flat.count > 0 ? "with an area " : "") + "in it" + beside,
      error_code::malformed_file};
}

}  // namespace

result<domain> domain_of_polygons(const polygons_read& read, const std::string& name) {
  domain d;
  d.name = name;
  d.polygons.reserve(read.polygons.size());
  occurrences flat, open;
  for (std::size_t k = 0; k < read.polygons.size(); ++k) {
    const polygon& from = read.polygons[k];
    domain_polygon& made = d.polygons.emplace_back();
    made.region = from.region;
    for (std::size_t i = 0; i < from.rings.size(); ++i) {
      if (encloses_nothing(from.rings[i])) {
        flat.add([&] { return domain_names(d).ring(k, i) + (i == 0 ? ", and all of it" : ""); });
        if (i == 0) break;
        continue;
      }
      if (from.rings[i].front() != from.rings[i].back())
        open.add([&] { return domain_names(d).ring(k, i); });
      made.rings.push_back(add_ring(from.rings[i], static_cast<int>(k) + 1, d));
    }
  }
  if (d.segments.empty()) return nothing_left(read, flat, name);
  note("empty geometries passed over", read.empty, d);
  note("points and lines passed over", read.others, d);
  note("points whose coordinates beyond x and y were dropped", read.heights, d);
  note("rings without area dropped", flat, d);
  note("rings that do not end where they begin, closed by a segment", open, d);
  return d;
}

}  // namespace asterism::internal
