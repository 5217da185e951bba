// SPDX-License-Identifier: MIT
//
// Points 0 and 1: finite numbers, indices in range, no repetitions, counter-clockwise triangles.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "asterism/mesh/audit/checks.hpp"
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

// A triangle's corners in ascending order and its number, in two words: two comparisons order it.
using sorted_triangle = std::pair<std::uint64_t, std::uint64_t>;

sorted_triangle sorted(const triangle& t, vertex_index number) {
  const auto [low, high] = std::minmax({t[0], t[1], t[2]});
  const vertex_index middle = t[0] ^ t[1] ^ t[2] ^ low ^ high;
  return {std::uint64_t{low} << 32U | middle, std::uint64_t{high} << 32U | number};
}

bool have_same_corners(const sorted_triangle& a, const sorted_triangle& b) {
  return a.first == b.first && a.second >> 32U == b.second >> 32U;
}

std::vector<sorted_triangle> sorted_triangles(const audit_context& context) {
  constexpr std::size_t triangles_at_once = 4096;  // for a thread
  std::vector<sorted_triangle> all(context.triangles.size());
  parallel_chunks(all.size(), triangles_at_once,
                  [&](std::size_t, std::size_t begin, std::size_t end) {
                    for (std::size_t i = begin; i < end; ++i) {
                      const vertex_index t = context.triangles[i];
                      all[i] = sorted(context.subject.triangles[t], t);
                    }
                  });
  parallel_sort(all.begin(), all.end());
  return all;
}

void check_repeated_triangles(audit_context& context) {
  const auto in_order = sorted_triangles(context);
  for (std::size_t i = 1; i < in_order.size(); ++i) {
    if (!have_same_corners(in_order[i - 1], in_order[i])) continue;
    const auto number = [&](std::size_t k) {
      return static_cast<vertex_index>(in_order[k].second);
    };
    context.found(finding_kind::repeated_triangle, triangle_text(context, number(i)) +
                                                       " has the vertices of triangle " +
                                                       number_of(context, number(i - 1)));
  }
}

}  // namespace

void check_sites(audit_context& context) {
  const auto& sites = context.subject.sites;
  context.placed.assign(sites.size(), 0);
  context.measured.assign(sites.size(), 0);
  for (vertex_index v = 0; v < sites.size(); ++v) {
    const metric_tensor& m = sites[v].metric;
    context.placed[v] = finite(sites[v].position);
    if (!context.placed[v])
      context.found(finding_kind::not_finite, vertex_text(context, v) + " is not finite");
    if (!finite(m))
      context.found(finding_kind::not_finite, "the " + metric_text(context, v) + " is not finite");
    else if (!context.kernel().is_positive_definite(m))
      context.found(finding_kind::metric_not_positive_definite,
                    "the " + metric_text(context, v) + " is not positive definite");
    else
      context.measured[v] = context.placed[v];
  }
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
      const vertex_index t = context.triangles[i];
      const triangle& c = context.subject.triangles[t];
      const sign turn =
          tally.kernel().orientation(context.at(c[0]), context.at(c[1]), context.at(c[2]));
      if (turn == sign::positive) continue;
      tally.found(finding_kind::orientation,
                  triangle_text(context, t) +
                      (turn == sign::zero ? " is flat" : " is not counter-clockwise"));
    }
  };
  check_in_parallel(context, context.triangles.size(), check);
}

}  // namespace asterism::internal::audit_detail
