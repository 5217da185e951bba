// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/foreign_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/kernels/work_units.hpp"
#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/audit/auditor.hpp"
#include "asterism/mesh/audit/theorem_hypotheses.hpp"
#include "asterism/mesh/numerics/metric_length.hpp"
#include "asterism/mesh/search/triangle_sides.hpp"
#include "asterism/mesh/stars/boundary.hpp"
#include "asterism/mesh/stars/proximity.hpp"
#include "asterism/mesh/stars/star_oracle.hpp"
#include "asterism/mesh/stars/star_predicates.hpp"
#include "asterism/mesh/stars/star_set.hpp"

namespace asterism {
using namespace internal;
namespace {

void put_boundary_in_order(mesh& m, const triangle_sides& sides) {
  if (m.boundary.empty())
    for (const auto& s : sides.all())
      if (sides.find(s.ends[1], s.ends[0]) == nullptr)
        m.boundary.push_back({s.ends[0], s.ends[1], 0, 0, false});
  for (vertex_index i = 0; i < m.boundary.size(); ++i) {
    boundary_edge& e = m.boundary[i];
    const bool left = sides.find(e.a, e.b) != nullptr, right = sides.find(e.b, e.a) != nullptr;
    if (right && !left) std::swap(e.a, e.b);
    e.internal = left && right;
    e.segment = i;
  }
}

// Makes edges between triangles of different regions segments, where the file lists none there.
void separate_regions(mesh& m, const triangle_sides& sides) {
  if (m.regions.empty()) return;
  std::vector<std::array<vertex_index, 2>> listed;
  for (const boundary_edge& e : m.boundary)
    listed.push_back({std::min(e.a, e.b), std::max(e.a, e.b)});
  std::sort(listed.begin(), listed.end());
  const std::size_t before = m.boundary.size();
  for (const auto& s : sides.all()) {
    const auto [a, b] = s.ends;
    if (a > b || !sides.divides_regions(m.regions, a, b) ||
        std::binary_search(listed.begin(), listed.end(), s.ends))
      continue;
    m.boundary.push_back({a, b, static_cast<vertex_index>(m.boundary.size()), 0, true});
  }
  if (m.boundary.size() == before) return;
  const boundary_edge& first = m.boundary[before];
  const point &p = m.sites[first.a].position, &q = m.sites[first.b].position;
  m.notes.push_back(fmt::format(
      "edges between triangles of different regions that are not listed are segments of marker 0: "
      "{}, the first from ({:g}, {:g}) to ({:g}, {:g}), between regions {} and {}",
      m.boundary.size() - before, p.x, p.y, q.x, q.y,
      m.regions[sides.find(first.a, first.b)->triangle],
      m.regions[sides.find(first.b, first.a)->triangle]));
}

domain domain_of(const mesh& m, const triangle_sides& sides) {
  domain d;
  d.vertices.reserve(m.sites.size());
  for (const site& s : m.sites) d.vertices.push_back(s.position);
  const auto region = [&](vertex_index a, vertex_index b) {
    const auto* const s = sides.find(a, b);
    return s == nullptr || m.regions.empty() ? 1 : m.regions[s->triangle];
  };
  for (const boundary_edge& e : m.boundary)
    d.segments.push_back(
        {e.a, e.b, e.marker, e.internal, region(e.a, e.b), e.internal ? region(e.b, e.a) : 1});
  return d;
}

// Kinds of findings about input that forms no sites or triangles. A mesh with such a finding is
// refused before its stars are built.
constexpr std::array unusable = {
    finding_kind::empty_mesh,        finding_kind::index_out_of_range,
    finding_kind::not_finite,        finding_kind::metric_not_positive_definite,
    finding_kind::repeated_position, finding_kind::repeated_corner};

// Builds the stars as the mesher would have them, on the mesh's own boundary, and counts the
// triangles in them.
void compare_with_stars(const adopted_mesh& adopted, const cancellation& stop,
                        certify_report& report) {
  const mesh& m = adopted.subject;
  tier_counters decided;
  const star_predicates_on<filtered_kernel> kernel(decided);
  const auto edges = boundary::build(adopted.shape, kernel);
  if (!edges) return;
  const proximity near(m.sites, edges.value());
  const site_oracle oracle(m.sites, edges.value(), kernel, nullptr, &near);
  star_set stars;
  constexpr double share = 0.4;  // of the work for a mesh: the verdict does not depend on this
  stars.bound_work(0, share);
  stars.cancel_by(stop);
  stars.construct_all(oracle);
  std::vector<vertex_index> all(m.sites.size());
  std::iota(all.begin(), all.end(), vertex_index{0});
  stars.construct(oracle, all, star_search::thorough);
  stop.charge(work_units(decided));
  if (stars.stars_missing() > 0) return;
  report.compared = true;
  for (vertex_index v = 0; v < stars.size(); ++v) report.unsettled += stars.is_unsettled(v) ? 1 : 0;
  for (vertex_index t = 0; t < m.triangles.size(); ++t) {
    const triangle& c = m.triangles[t];
    std::size_t stars_with_it = 0;
    for (std::size_t i = 0; i < 3; ++i)
      stars_with_it += has_triangle(oracle, c[i], stars[c[i]], c[(i + 1) % 3], c[(i + 2) % 3]);
    ++report.in_stars[stars_with_it];
    if (stars_with_it != 3) report.not_in_all.push_back(t);
  }
}

// True if the stars are worth building. If the number of edges that fail the test of their own four
// vertices is above a tenth of the number of sites, stars reach far and take much work, and would
// only confirm the refusal.
bool is_worth_comparing(const audit_report& audit) {
  constexpr std::size_t part = 10;
  return audit.found[static_cast<std::size_t>(finding_kind::star_neighbour_rejected)] <=
         audit.sites / part;
}

void measure_edges(const mesh& m, certify_report& report) {
  const triangle_sides sides(m);
  for (const auto& s : sides.all()) {
    const auto [a, b] = s.ends;
    if (a > b && sides.find(b, a) != nullptr) continue;
    const double length = edge_length(m.sites[a], m.sites[b]);
    ++report.edges;
    report.unit_edges += is_unit_length(length) ? 1 : 0;
    report.mean_length += length;
  }
  if (report.edges > 0) report.mean_length /= static_cast<double>(report.edges);
}

}  // namespace

result<adopted_mesh> adopt_mesh(mesh from_elsewhere, region_edges between, slit_rule slits,
                                int first_number) {
  joined_cracks cracks;
  if (slits == slit_rule::joined) {
    auto joined = join_cracks(from_elsewhere, first_number);
    if (!joined) return joined.failure();
    cracks = std::move(joined).value();
  }
  audit_options asked;
  asked.first_number = first_number;
  auditor judge(from_elsewhere, asked);
  const audit_report& numbers = judge.check_numbers();
  for (const finding_kind kind : unusable)
    for (const audit_finding& f : numbers.findings)
      if (f.kind == kind) return error{f.witness, error_code::invalid_mesh};
  adopted_mesh adopted{std::move(from_elsewhere),
                       {},
                       std::move(cracks.markers),
                       std::move(cracks.number),
                       first_number};
  mesh& m = adopted.subject;
  if (!m.regions.empty() && m.regions.size() != m.triangles.size())
    return error{
        fmt::format("{} regions are given for {} triangles", m.regions.size(), m.triangles.size()),
        error_code::invalid_mesh};
  const triangle_sides sides(m);
  put_boundary_in_order(m, sides);
  if (between == region_edges::segments) separate_regions(m, sides);
  m.given = static_cast<vertex_index>(m.sites.size());
  adopted.shape = domain_of(m, sides);
  return adopted;
}

audit_options questions_for(const adopted_mesh& adopted) {
  audit_options options;
  options.original = &adopted.shape;
  options.find_exempt_corners = true;
  options.domain_is_the_mesh = true;
  options.first_number = adopted.first_number;
  return options;
}

certify_report certify(const adopted_mesh& adopted, double angle_bound, bool check_voronoi,
                       std::size_t findings_kept, const cancellation& stop) {
  const mesh& m = adopted.subject;
  certify_report report;
  audit_options options = questions_for(adopted);
  options.angle_bound = angle_bound;
  options.check_voronoi = check_voronoi;
  options.findings_kept = findings_kept;
  options.stop = stop;
  report.audit = audit(m, options);
  report.inverted = report.audit.found[static_cast<std::size_t>(finding_kind::orientation)];
  report.below_bound = [&audit = report.audit] {
    std::vector<vertex_index> low = audit.refused_triangles(), all;
    std::set_union(low.begin(), low.end(), audit.exempt_triangles.begin(),
                   audit.exempt_triangles.end(), std::back_inserter(all));
    return all.size();
  }();
  measure_edges(m, report);
  report.regions = measure_regions(m, nullptr);  // the domain is what the mesh says itself
  if (report.certified()) report.theorem = measure_theorem_hypotheses(m, angle_bound, stop);
  if (report.audit.stars_checked && is_worth_comparing(report.audit))
    compare_with_stars(adopted, stop, report);
  return report;
}

}  // namespace asterism
