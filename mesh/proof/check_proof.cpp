// SPDX-License-Identifier: MIT
#include "asterism/mesh/proof/check_proof.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/proof/check_corners.hpp"
#include "asterism/mesh/proof/check_filled.hpp"
#include "asterism/mesh/proof/meeting_witness.hpp"
#include "asterism/mesh/proof/proof_words.hpp"
#include "asterism/mesh/proof/star_pairs.hpp"
#include "asterism/mesh/support/parallel.hpp"

namespace asterism::internal {
namespace {

using namespace proof_detail;

std::optional<error> check_numbers(const mesh& subject, const mesh_proof& proof) {
  const std::size_t sites = subject.sites.size();
  for (const double x :
       {proof.low.x, proof.low.y, proof.high.x, proof.high.y, proof.squared_radius})
    if (!std::isfinite(x)) return not_shown("the rectangle or the radius is not finite");
  if (!(proof.low.x < proof.high.x && proof.low.y < proof.high.y) || subject.triangles.empty())
    return not_shown("the rectangle or the mesh is empty");
  for (std::size_t v = 0; v < sites; ++v) {
    const metric_tensor& m = subject.sites[v].metric;
    const bool is_definite = decide([&](auto zero) {
      const tensor<decltype(zero)> metric(m);
      return exceeds_zero(metric.m11) & exceeds_zero(metric.determinant());
    });
    if (!is_definite) return not_shown("the metric of " + vertex_number(v) + " is not definite");
  }
  const auto are_corners = [](const std::vector<triangle>& triangles, std::size_t most) {
    return std::all_of(triangles.begin(), triangles.end(), [&](const triangle& t) {
      return std::all_of(t.begin(), t.end(), [&](vertex_index v) { return v < most; });
    });
  };
  if (!are_corners(subject.triangles, sites) || !are_corners(proof.outside, sites + 4))
    return not_shown("a triangle has a corner that is none");
  for (const boundary_edge& e : subject.boundary)
    if (e.a >= sites || e.b >= sites) return not_shown("an edge has an end that is none");
  return std::nullopt;
}

// Assigns the witnesses of a list to the questions of a sequence in order, and decides them in
// parallel. Returns the number of the first question whose witness fails, or the number of all
// questions.
template <class Witness, class Asked, class Holds>
std::size_t first_failure(std::size_t count, const std::vector<Witness>& witnesses,
                          const Asked& is_asked, const Holds& holds) {
  constexpr std::size_t chunk = 1024;
  const std::size_t chunks = chunk_count(count, chunk);
  std::vector<std::size_t> start(chunks + 1, 0), failed(chunks, count);
  parallel_chunks(count, chunk, [&](std::size_t nth, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      start[nth + 1] += is_asked(static_cast<std::uint32_t>(i)) ? 1 : 0;
  });
  for (std::size_t i = 0; i < chunks; ++i) start[i + 1] += start[i];
  if (start.back() != witnesses.size()) return 0;
  parallel_chunks(count, chunk, [&](std::size_t nth, std::size_t begin, std::size_t end) {
    std::size_t next = start[nth];
    for (std::size_t i = begin; i < end && failed[nth] == count; ++i) {
      const auto number = static_cast<std::uint32_t>(i);
      if (is_asked(number) && !holds(number, witnesses[next++])) failed[nth] = i;
    }
  });
  return chunks == 0 ? count : *std::min_element(failed.begin(), failed.end());
}

bool is_in_one_metric(const plane& all, std::uint32_t edge) {
  const edge_sites e = sites_of_edge(all, edge);
  return have_one_metric(e.v, e.w, e.x, e.y);
}

std::optional<error> check_kept(const plane& all, const mesh_proof& proof) {
  const std::size_t count = 3 * all.inner_count();
  const auto failure = [&](std::size_t e) {
    const auto edge = static_cast<std::uint32_t>(e);
    return not_shown("the edge from " + vertex_number(all.corner(edge)) + " to " +
                     vertex_number(all.corner(edge, 1)) + " is not shown to be kept");
  };
  for (std::uint32_t edge = 0; edge < count; ++edge) {
    if (!is_edge_asked(all, edge) || !is_in_one_metric(all, edge)) continue;
    const edge_sites e = sites_of_edge(all, edge);
    if (!is_kept_in_one_metric(e.v, e.w, e.x, e.y)) return failure(edge);
  }
  const std::size_t failed = first_failure(
      count, proof.edges,
      [&](std::uint32_t e) { return is_edge_asked(all, e) && !is_in_one_metric(all, e); },
      [&](std::uint32_t e, const proof_point& witness) {
        const edge_sites sites = sites_of_edge(all, e);
        return decide([&](auto zero) {
                 return is_kept<decltype(zero)>(sites, as_grid_point(witness));
               }) ||
               is_kept_at_meeting(all, proof.exceptions, e);
      });
  if (failed == count) return std::nullopt;
  return failure(failed);
}

// Looks up the exceptions of a proof, which must be sorted, and checks them.
class exception_list {
 public:
  exception_list(const plane& all, const std::vector<proof_exception>& exceptions)
      : all_(all), exceptions_(exceptions) {}

  bool operator()(std::uint32_t gap, vertex_index w) const {
    if (is_refused_at_meeting(all_, exceptions_, gap, w)) return true;
    const proof_exception* found = exception_of(exceptions_, gap, w);
    if (found == nullptr) return false;
    if (found->why == proof_exception::reason::hidden) return is_hidden(gap, w, *found);
    const bool by_site = found->why == proof_exception::reason::by_site;
    if (!by_site && found->why != proof_exception::reason::by_gap) return false;
    const gap_sites g = sites_of_gap(all_, gap);
    const site& other = all_.subject.sites[w];
    const std::vector<grid_point> points = points_of(*found);
    const gap_row row{points, found->turn};
    const gap_sites asked = by_site ? gap_sites{other, g.y, g.x} : g;
    return is_sound(asked, row) && refuses(asked, row, by_site ? g.v : other);
  }

 private:
  bool is_hidden(std::uint32_t gap, vertex_index w, const proof_exception& e) const {
    if (e.points.size() != 1) return false;
    const auto a = static_cast<vertex_index>(e.points[0][0]),
               b = static_cast<vertex_index>(e.points[0][1]);
    const vertex_index v = all_.corner(gap);
    const bool is_listed = std::any_of(
        all_.subject.boundary.begin(), all_.subject.boundary.end(),
        [&](const boundary_edge& s) { return (s.a == a && s.b == b) || (s.a == b && s.b == a); });
    return is_listed && are_apart(v, w, a, b) && are_apart(a, b, v, w);
  }
  // True if c and d are strictly on different sides of the line through a and b.
  bool are_apart(vertex_index a, vertex_index b, vertex_index c, vertex_index d) const {
    const filtered_kernel kernel;
    const auto side = [&](vertex_index p) {
      return kernel.orientation(all_.position(a), all_.position(b), all_.position(p));
    };
    return side(c) * side(d) == sign::negative;
  }

  const plane& all_;
  const std::vector<proof_exception>& exceptions_;
};

std::optional<error> check_gaps(const plane& all, const mesh_proof& proof) {
  const std::size_t count = 3 * all.inner_count();
  gap_rows rows(count);
  for (const proof_exception& e : proof.exceptions)
    if (e.why == proof_exception::reason::row && e.site == proof_exception::nobody && e.gap < count)
      rows.set(e.gap, e);
  std::size_t next = 0;
  for (std::uint32_t gap = 0; gap < count && next < proof.gaps.size(); ++gap)
    if (is_gap_asked(all, gap)) rows.set(gap, proof.gaps[next++]);
  const std::size_t failed = first_failure(
      count, proof.gaps, [&](std::uint32_t gap) { return is_gap_asked(all, gap); },
      [&](std::uint32_t gap, const proof_gap&) {
        const gap_sites g = sites_of_gap(all, gap);
        return rows.with(gap, [&](const gap_row& row) {
          return is_sound(g, row) && is_within(g, row, proof.squared_radius);
        });
      });
  if (failed != count)
    return not_shown("the gap at " + vertex_number(all.corner(static_cast<std::uint32_t>(failed))) +
                     " of triangle " + std::to_string(failed / 3 + 1) + " is not shown to end");
  return check_pairs(all, rows, proof.squared_radius, exception_list(all, proof.exceptions));
}

}  // namespace

std::optional<error> check_proof(const proof_question& asked, const mesh_proof& proof) {
  if (auto failed = check_numbers(asked.subject, proof)) return failed;
  const std::array<point, 4> corners = {proof.low, point{proof.high.x, proof.low.y}, proof.high,
                                        point{proof.low.x, proof.high.y}};
  const plane all = make_plane(asked.subject, corners, proof.outside);
  if (auto failed = check_filled(all)) return failed;
  if (auto failed = check_shape(all, asked, proof)) return failed;
  if (auto failed = check_corners(all, asked)) return failed;
  if (auto failed = check_kept(all, proof)) return failed;
  if (has_one_metric(asked.subject)) return std::nullopt;
  return check_gaps(all, proof);
}

}  // namespace asterism::internal
