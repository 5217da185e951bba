// SPDX-License-Identifier: MIT
//
// Points 0 and 1: finite numbers, indices in range, no repetitions, counter-clockwise triangles.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "asterism/mesh/audit/checks.hpp"
#include "asterism/mesh/support/sort_by_counting.hpp"
#include "asterism/mesh/support/tensor_text.hpp"

namespace asterism::internal::audit_detail {
namespace {

bool finite(const point& p) { return std::isfinite(p.x) && std::isfinite(p.y); }
bool finite(const metric_tensor& m) {
  return std::isfinite(m.m11) && std::isfinite(m.m12) && std::isfinite(m.m22);
}

std::string metric_text(const audit_context& context, vertex_index v) {
  const metric_tensor& m = context.subject.sites[v].metric;
  return "metric tensor " + tensor_text(m) + " of " + vertex_text(context, v);
}

// Sorts copies of the points: the mesh has them in any order, and each access would read another
// place of memory.
void check_positions(audit_context& context) {
  struct numbered_point {
    point at;
    vertex_index number;
  };
  std::vector<numbered_point> order;
  order.reserve(context.placed.size());
  for (vertex_index v = 0; v < context.placed.size(); ++v)
    if (context.placed[v]) order.push_back({context.at(v), v});
  parallel_sort(order.begin(), order.end(), [](const numbered_point& a, const numbered_point& b) {
    if (lexicographically_less(a.at, b.at)) return true;
    return a.at == b.at && a.number < b.number;
  });
  for (std::size_t i = 1; i < order.size(); ++i)
    if (order[i - 1].at == order[i].at)
      context.found(finding_kind::repeated_position,
                    vertex_text(context, order[i - 1].number) + " and " +
                        vertex_text(context, order[i].number) + " are at the same point");
}

// True when every index is in range and no two are equal and all positions are finite.
template <class Corners>
bool usable(audit_context& context, const Corners& corners, const char* kind, std::size_t number) {
  const auto what = [&] {
    std::string text = kind;
    text += ' ';
    text += number_of(context, number);
    return text;
  };
  for (const vertex_index v : corners) {
    if (v < context.subject.sites.size()) continue;
    context.found(finding_kind::index_out_of_range,
                  what() + " names vertex " + number_of(context, v) + " of " +
                      std::to_string(context.subject.sites.size()));
    return false;
  }
  Corners sorted = corners;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end()) {
    context.found(finding_kind::repeated_corner,
                  what() + " names " + vertex_text(context, *twice) + " twice");
    return false;
  }
  return std::all_of(corners.begin(), corners.end(),
                     [&](vertex_index v) { return context.placed[v] != 0; });
}

// Lists all triangles where each has three different corners with a place, and returns true;
// otherwise nothing is listed. Works in several threads.
bool list_all_triangles(audit_context& context) {
  constexpr std::size_t triangles_at_once = 4096;  // for a thread
  const std::vector<triangle>& triangles = context.subject.triangles;
  const auto is_usable = [&](const triangle& t) {
    for (const vertex_index v : t)
      if (v >= context.placed.size() || context.placed[v] == 0) return false;
    return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
  };
  context.triangles.resize(triangles.size());
  std::vector<char> are_usable(chunk_count(triangles.size(), triangles_at_once), 1);
  parallel_chunks(triangles.size(), triangles_at_once,
                  [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                    for (std::size_t t = begin; t < end; ++t) {
                      context.triangles[t] = static_cast<vertex_index>(t);
                      if (!is_usable(triangles[t])) are_usable[chunk] = 0;
                    }
                  });
  if (std::all_of(are_usable.begin(), are_usable.end(), [](char c) { return c != 0; })) return true;
  context.triangles.clear();
  return false;
}

void check_indices(audit_context& context) {
  const mesh& m = context.subject;
  const bool are_usable = list_all_triangles(context);
  for (vertex_index t = 0; t < m.triangles.size() && !are_usable; ++t)
    if (usable(context, m.triangles[t], "triangle", t)) context.triangles.push_back(t);
  for (vertex_index e = 0; e < m.boundary.size(); ++e)
    if (usable(context, std::array{m.boundary[e].a, m.boundary[e].b}, "boundary edge", e))
      context.subsegments.push_back(e);
  if (m.given > m.sites.size())
    context.found(finding_kind::index_out_of_range, std::to_string(m.given) +
                                                        " vertices are said to be given, of " +
                                                        std::to_string(m.sites.size()));
}

// A triangle among those with one least corner: the other two in ascending order, packed into one
// number that takes one comparison in place of two, and the triangle's number.
struct sorted_triangle {
  std::uint64_t corners;
  vertex_index number;
};

vertex_index least_corner(const triangle& t) { return std::min({t[0], t[1], t[2]}); }

sorted_triangle sorted(const triangle& t, vertex_index number) {
  const auto [low, high] = std::minmax({t[0], t[1], t[2]});
  const vertex_index middle = t[0] ^ t[1] ^ t[2] ^ low ^ high;
  return {std::uint64_t{middle} << 32U | high, number};
}

// Finds triangles with the same corners next to each other: sorts them by counting for the least
// corner, and by comparisons among those that have the same one. The cost for triangles that share
// it, however many, has the bound of std::sort.
void check_repeated_triangles(audit_context& context) {
  const auto& triangles = context.subject.triangles;
  const auto& listed = context.triangles;
  std::vector<sorted_triangle> all(listed.size());
  const std::vector<std::size_t> start = sort_by_counting(
      listed.size(), context.placed.size(),
      [&](std::size_t i) { return std::size_t{least_corner(triangles[listed[i]])}; },
      [&](std::size_t at, std::size_t i) { all[at] = sorted(triangles[listed[i]], listed[i]); });
  const auto at = [&all](std::size_t i) { return all.begin() + static_cast<std::ptrdiff_t>(i); };
  const auto check = [&](audit_tally& tally, std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      std::sort(at(start[v]), at(start[v + 1]), [](const auto& a, const auto& b) {
        return a.corners < b.corners || (a.corners == b.corners && a.number < b.number);
      });
      for (std::size_t i = start[v] + 1; i < start[v + 1]; ++i)
        if (all[i - 1].corners == all[i].corners)
          tally.found(finding_kind::repeated_triangle, triangle_text(context, all[i].number) +
                                                           " has the vertices of triangle " +
                                                           number_of(context, all[i - 1].number));
    }
  };
  check_in_parallel(context, context.placed.size(), check);
}

void check_site(audit_context& context, audit_tally& tally, vertex_index v) {
  const auto& [position, metric] = context.subject.sites[v];
  context.placed[v] = finite(position);
  if (!context.placed[v])
    tally.found(finding_kind::not_finite, vertex_text(context, v) + " is not finite");
  if (!finite(metric))
    tally.found(finding_kind::not_finite, "the " + metric_text(context, v) + " is not finite");
  else if (!tally.kernel().is_positive_definite(metric))
    tally.found(finding_kind::metric_not_positive_definite,
                "the " + metric_text(context, v) + " is not positive definite");
  else
    context.measured[v] = context.placed[v];
}

void check_orientation(const audit_context& context, audit_tally& tally, vertex_index t) {
  const auto& [a, b, c] = context.subject.triangles[t];
  const sign turn = tally.kernel().orientation(context.at(a), context.at(b), context.at(c));
  if (turn == sign::positive) return;
  tally.found(
      finding_kind::orientation,
      triangle_text(context, t) + (turn == sign::zero ? " is flat" : " is not counter-clockwise"));
}

}  // namespace

void check_sites(audit_context& context) {
  const std::size_t sites = context.subject.sites.size();
  context.placed.assign(sites, 0);
  context.measured.assign(sites, 0);
  check_in_parallel(context, sites, [&](audit_tally& tally, std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v)
      check_site(context, tally, static_cast<vertex_index>(v));
  });
}

void check_input(audit_context& context) {
  const mesh& m = context.subject;
  if (m.triangles.empty()) context.found(finding_kind::empty_mesh, "the mesh has no triangle");
  if (!m.disagreeing.empty())
    context.found(finding_kind::disagreeing_triangles,
                  "the mesh carries " + std::to_string(m.disagreeing.size()) +
                      " triangles on which the stars disagree");
  check_sites(context);
  check_positions(context);
  check_indices(context);
}

void check_values(audit_context& context) {
  check_input(context);
  check_repeated_triangles(context);
}

void check_orientations(audit_context& context) {
  const auto check = [&](audit_tally& tally, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      context.prefetch_corners(i + triangles_ahead);
      check_orientation(context, tally, context.triangles[i]);
    }
  };
  check_in_parallel(context, context.triangles.size(), check);
}

void check_values_again(audit_context& context, const triangulation_changes& changes) {
  for (const vertex_index v : changes.moved)
    if (!finite(context.at(v)))
      return context.found(finding_kind::not_finite, vertex_text(context, v) + " is not finite");
  const std::vector<vertex_index>& some = changes.triangles;
  const auto check = [&](audit_tally& tally, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) check_orientation(context, tally, some[i]);
  };
  const auto is_usable = [&](vertex_index t) {
    return usable(context, context.subject.triangles[t], "triangle", t);
  };
  if (std::all_of(some.begin(), some.end(), is_usable))
    check_in_parallel(context, some.size(), check);
}

}  // namespace asterism::internal::audit_detail
