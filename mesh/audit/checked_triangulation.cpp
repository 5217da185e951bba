// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/checked_triangulation.hpp"

#include <algorithm>
#include <utility>

#include "asterism/mesh/support/parallel.hpp"
#include "asterism/mesh/support/sort_unique.hpp"

namespace asterism::internal::audit_detail {
namespace {

std::vector<point> places_of(const mesh& m) {
  std::vector<point> places;
  reserve_in_threads(places, m.sites.size());
  for (const site& s : m.sites) places.push_back(s.position);
  return places;
}

bool has_place(const site& s, const point& place) { return same_bits(s.position, place); }

bool is_same(const boundary_edge& e, const boundary_edge& f) {
  return e.a == f.a && e.b == f.b && e.segment == f.segment && e.marker == f.marker &&
         e.internal == f.internal;
}

constexpr std::size_t items_at_once = 8192;  // sites or triangles, for a thread

}  // namespace

checked_triangulation::checked_triangulation(const mesh& subject, const domain* original,
                                             triangulation_lists lists, const audit_report& report)
    : places_(places_of(subject)),
      given_(subject.given),
      triangles_(copy_in_threads(subject.triangles)),
      regions_(copy_in_threads(subject.regions)),
      boundary_(subject.boundary),
      original_(original),
      lists_(std::move(lists)),
      domain_checked_(report.domain_checked),
      largest_deviation_(report.largest_deviation),
      largest_deviation_ulps_(report.largest_deviation_ulps),
      curves_(report.curves) {}

bool checked_triangulation::has_boundary_of(const mesh& subject) const {
  return subject.given == given_ && subject.disagreeing.empty() &&
         std::equal(subject.boundary.begin(), subject.boundary.end(), boundary_.begin(),
                    boundary_.end(), is_same);
}

bool checked_triangulation::has_lists_of(const mesh& subject) const {
  return has_boundary_of(subject) && subject.triangles == triangles_ &&
         subject.regions == regions_ &&
         std::equal(subject.sites.begin(), subject.sites.end(), places_.begin(), places_.end(),
                    has_place);
}

bool checked_triangulation::is_inside(vertex_index v) const {
  return v >= given_ && lists_.side_start[v] == lists_.side_start[v + 1];
}

// Lists the sites with another position; nothing where one is not inside.
std::optional<std::vector<vertex_index>> checked_triangulation::moved_in(
    const mesh& subject) const {
  auto moved = collect_chunks<vertex_index>(
      places_.size(), items_at_once,
      [&](std::size_t begin, std::size_t end, std::vector<vertex_index>& found) {
        for (std::size_t v = begin; v < end; ++v)
          if (!has_place(subject.sites[v], places_[v]))
            found.push_back(static_cast<vertex_index>(v));
      });
  const bool are_inside =
      std::all_of(moved.begin(), moved.end(), [this](vertex_index v) { return is_inside(v); });
  return are_inside ? std::optional(std::move(moved)) : std::nullopt;
}

std::optional<triangulation_changes> checked_triangulation::changes_to(
    const mesh& subject, const domain* original) const {
  constexpr std::size_t few = 16;  // one triangle in this number: updates of more save little
  if (original != original_ || subject.sites.size() != places_.size() ||
      subject.triangles.size() != triangles_.size() || subject.regions != regions_ ||
      !has_boundary_of(subject))
    return std::nullopt;
  auto moved = moved_in(subject);
  if (!moved) return std::nullopt;
  triangulation_changes changes{std::move(*moved), {}, {}};
  std::vector<char> has_moved(places_.size(), 0);
  for (const vertex_index v : changes.moved) has_moved[v] = 1;
  changes.triangles = collect_chunks<vertex_index>(
      triangles_.size(), items_at_once,
      [&](std::size_t begin, std::size_t end, std::vector<vertex_index>& found) {
        for (std::size_t t = begin; t < end; ++t) {
          const triangle& was = triangles_[t];
          const bool moves = (has_moved[was[0]] | has_moved[was[1]] | has_moved[was[2]]) != 0;
          if (moves || was != subject.triangles[t]) found.push_back(static_cast<vertex_index>(t));
        }
      });
  if (few * changes.triangles.size() > triangles_.size()) return std::nullopt;
  for (const vertex_index t : changes.triangles)
    for (const triangle& c : {triangles_[t], subject.triangles[t]})
      changes.corners.insert(changes.corners.end(), c.begin(), c.end());
  sort_unique(changes.corners);
  return changes;
}

void checked_triangulation::take_changes(const mesh& subject,
                                         const triangulation_changes& changes) {
  for (const vertex_index v : changes.moved) places_[v] = subject.sites[v].position;
  for (const vertex_index t : changes.triangles) triangles_[t] = subject.triangles[t];
}

void checked_triangulation::enter_measurements(audit_report& report) const {
  report.domain_checked = domain_checked_;
  report.largest_deviation = largest_deviation_;
  report.largest_deviation_ulps = largest_deviation_ulps_;
  report.curves = curves_;
}

}  // namespace asterism::internal::audit_detail
