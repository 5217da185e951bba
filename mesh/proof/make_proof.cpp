// SPDX-License-Identifier: MIT
#include "asterism/mesh/proof/make_proof.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <string>
#include <utility>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/proof/exterior.hpp"
#include "asterism/mesh/proof/meeting_witness.hpp"
#include "asterism/mesh/proof/witness_search.hpp"
#include "asterism/mesh/support/parallel.hpp"

namespace asterism::internal {
namespace {

using namespace proof_detail;

constexpr std::size_t chunk = 1024;

error no_proof(const std::string& of) {
  return {"no witness is found of " + of, error_code::invalid_mesh};
}

std::string number_of(std::size_t index) { return std::to_string(index + 1); }

// Sets the corners to those of a box three times the mesh's size, so that the balls of sites near
// the boundary do not meet its border.
void choose_rectangle(const mesh& subject, mesh_proof& proof) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  point low{infinity, infinity}, high{-infinity, -infinity};
  for (const site& s : subject.sites) {
    low = {std::min(low.x, s.position.x), std::min(low.y, s.position.y)};
    high = {std::max(high.x, s.position.x), std::max(high.y, s.position.y)};
  }
  const double margin = std::max(high.x - low.x, high.y - low.y);
  proof.low = {low.x - margin, low.y - margin};
  proof.high = {high.x + margin, high.y + margin};
}

// Finds a point for each question for which `is_asked`, in parallel. Returns the first question for
// which none is found.
template <class Asked, class Find, class Points>
std::optional<std::uint32_t> find_points(std::size_t count, const Asked& is_asked, const Find& find,
                                         Points& points) {
  std::vector<std::optional<std::uint32_t>> missing(chunk_count(count, chunk));
  parallel_chunks(count, chunk, [&](std::size_t nth, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && !missing[nth]; ++i) {
      const auto number = static_cast<std::uint32_t>(i);
      if (!is_asked(number)) continue;
      const auto found = find(number);
      if (found)
        points[i] = *found;
      else
        missing[nth] = number;
    }
  });
  for (const auto& one : missing)
    if (one) return one;
  return std::nullopt;
}

bool is_edge_in_need(const plane& all, std::uint32_t edge) {
  if (!is_edge_asked(all, edge)) return false;
  const edge_sites e = sites_of_edge(all, edge);
  return !have_one_metric(e.v, e.w, e.x, e.y);
}

std::optional<error> add_edges(const plane& all, mesh_proof& proof) {
  const std::size_t count = 3 * all.inner_count();
  std::vector<proof_point> points(count);
  std::vector<char> asked(count, 0);
  const auto is_asked = [&](std::uint32_t e) { return (asked[e] = is_edge_in_need(all, e)) != 0; };
  std::mutex adding;
  const auto find = [&](std::uint32_t e) -> std::optional<proof_point> {
    if (const auto found = find_edge_point(all, e)) return found;
    auto meeting = find_edge_meeting(all, e);
    if (!meeting) return std::nullopt;
    const std::lock_guard lock(adding);
    proof.exceptions.push_back(std::move(*meeting));
    return proof_point{};
  };
  const auto missing = find_points(count, is_asked, find, points);
  if (missing)
    return no_proof("the edge from vertex " + number_of(all.corner(*missing)) + " to vertex " +
                    number_of(all.corner(*missing, 1)) + ", which both ends keep");
  for (std::size_t e = 0; e < count; ++e)
    if (asked[e]) proof.edges.push_back(points[e]);
  return std::nullopt;
}

// Finds the rows of all gaps, and adds those of more than three points to the exceptions. Returns
// the first gap for which none is found.
std::optional<std::uint32_t> find_rows(const plane& all, gap_rows& rows, mesh_proof& proof) {
  std::vector<proof_gap> plain(rows.size());
  std::mutex adding;
  const auto find = [&](std::uint32_t gap) -> std::optional<proof_gap> {
    const gap_sites sites = sites_of_gap(all, gap);
    if (const auto row = find_row(sites)) return row;
    auto wide = find_wide_row(sites);
    if (!wide) return std::nullopt;
    wide->why = proof_exception::reason::row;
    wide->gap = gap;
    wide->site = proof_exception::nobody;
    const std::lock_guard lock(adding);
    proof.exceptions.push_back(std::move(*wide));
    return proof_gap{};
  };
  const auto missing = find_points(
      rows.size(), [&](std::uint32_t gap) { return is_gap_asked(all, gap); }, find, plain);
  for (std::uint32_t gap = 0; gap < plain.size(); ++gap) rows.set(gap, plain[gap]);
  for (const proof_exception& wide : proof.exceptions)
    if (wide.why == proof_exception::reason::row) rows.set(wide.gap, wide);
  return missing;
}

// Returns the square of the least radius within which all rows are, rounded up.
double squared_radius_of(const plane& all, const gap_rows& rows) {
  double greatest = 0;
  for (std::uint32_t gap = 0; gap < rows.size(); ++gap)
    if (is_gap_asked(all, gap))
      greatest = std::max(greatest, rows.with(gap, [&](const gap_row& row) {
        return squared_reach(sites_of_gap(all, gap), row);
      }));
  return greatest * (1 + 0x1p-40);
}

// Sorts exceptions and removes repeated ones: those of the same gap and site are equal.
void put_in_order(std::vector<proof_exception>& exceptions) {
  const auto key = [](const proof_exception& e) { return std::pair(e.site, e.gap); };
  std::sort(exceptions.begin(), exceptions.end(),
            [&](const auto& l, const auto& r) { return key(l) < key(r); });
  const auto last = std::unique(exceptions.begin(), exceptions.end(),
                                [&](const auto& l, const auto& r) { return key(l) == key(r); });
  exceptions.erase(last, exceptions.end());
}

std::optional<error> add_gaps(const plane& all, mesh_proof& proof) {
  gap_rows rows(3 * all.inner_count());
  if (const auto missing = find_rows(all, rows, proof))
    return no_proof("how far the gap at vertex " + number_of(all.corner(*missing)) +
                    " of triangle " + number_of(*missing / 3) + " reaches");
  proof.squared_radius = squared_radius_of(all, rows);
  std::mutex adding;
  put_in_order(proof.exceptions);
  const std::vector<proof_exception> known = proof.exceptions;
  const auto except = [&](std::uint32_t gap, vertex_index w) {
    if (is_refused_at_meeting(all, known, gap, w)) return true;
    auto found = find_exception(all, gap, w);
    if (!found) return false;
    const std::lock_guard lock(adding);
    proof.exceptions.push_back(std::move(*found));
    return true;
  };
  if (auto failed = check_pairs(all, rows, proof.squared_radius, except))
    return error{"no proof is found: " + failed->message, failed->code};
  put_in_order(proof.exceptions);
  for (std::uint32_t gap = 0; gap < rows.size(); ++gap)
    if (is_gap_asked(all, gap)) proof.gaps.push_back(rows.plain(gap));
  return std::nullopt;
}

// Returns the first triangle from `begin` to before `end` that contains the point, also on an edge;
// the number of all triangles if none does.
std::uint32_t triangle_around(const plane& all, const point& p, std::size_t begin,
                              std::size_t end) {
  const filtered_kernel kernel;
  for (std::size_t t = begin; t < end; ++t) {
    const auto at = [&](std::size_t i) -> const point& {
      return all.position(all.triangles[t][i]);
    };
    bool is_in = true;
    for (std::size_t i = 0; i < 3 && is_in; ++i)
      is_in = kernel.orientation(at(i), at((i + 1) % 3), p) != sign::negative;
    if (is_in) return static_cast<std::uint32_t>(t);
  }
  return static_cast<std::uint32_t>(all.triangles.size());
}

std::optional<error> add_places(const plane& all, const domain& shape, mesh_proof& proof) {
  const std::size_t inner = all.inner_count(), count = all.triangles.size();
  for (const point& hole : shape.holes)
    proof.places.push_back(triangle_around(all, hole, inner, count));
  for (const region_point& region : shape.regions)
    proof.places.push_back(triangle_around(all, region.at, 0, inner));
  for (const std::uint32_t t : proof.places)
    if (t == count) return no_proof("where a hole or region point of the domain is");
  return std::nullopt;
}

}  // namespace

result<mesh_proof> make_proof(const mesh& subject, const domain* shape) {
  mesh_proof proof;
  choose_rectangle(subject, proof);
  const std::array<point, 4> corners = {proof.low, point{proof.high.x, proof.low.y}, proof.high,
                                        point{proof.low.x, proof.high.y}};
  auto outside = triangulate_outside(subject, corners);
  if (!outside) return outside.failure();
  proof.outside = std::move(outside).value();
  const plane all = make_plane(subject, corners, proof.outside);
  if (shape != nullptr)
    if (auto failed = add_places(all, *shape, proof)) return *failed;
  if (auto failed = add_edges(all, proof)) return *failed;
  if (!has_one_metric(subject))
    if (auto failed = add_gaps(all, proof)) return *failed;
  return proof;
}

}  // namespace asterism::internal
