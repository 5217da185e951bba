// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/checked_triangulation.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

namespace asterism::internal::audit_detail {
namespace {

std::vector<point> places_of(const mesh& m) {
  std::vector<point> places;
  places.reserve(m.sites.size());
  for (const site& s : m.sites) places.push_back(s.position);
  return places;
}

// Compares bits: zeros of either sign are equal as numbers.
bool has_place(const site& s, const point& place) {
  return std::memcmp(&s.position, &place, sizeof place) == 0;
}

bool is_same(const boundary_edge& e, const boundary_edge& f) {
  return e.a == f.a && e.b == f.b && e.segment == f.segment && e.marker == f.marker &&
         e.internal == f.internal;
}

}  // namespace

checked_triangulation::checked_triangulation(const mesh& subject, const domain* original,
                                             triangulation_lists lists, const audit_report& report)
    : places_(places_of(subject)),
      given_(subject.given),
      triangles_(subject.triangles),
      regions_(subject.regions),
      boundary_(subject.boundary),
      original_(original),
      lists_(std::move(lists)),
      domain_checked_(report.domain_checked),
      largest_deviation_(report.largest_deviation),
      largest_deviation_ulps_(report.largest_deviation_ulps),
      curves_(report.curves) {}

bool checked_triangulation::has_lists_of(const mesh& subject) const {
  return subject.given == given_ && subject.disagreeing.empty() &&
         std::equal(subject.sites.begin(), subject.sites.end(), places_.begin(), places_.end(),
                    has_place) &&
         subject.triangles == triangles_ && subject.regions == regions_ &&
         std::equal(subject.boundary.begin(), subject.boundary.end(), boundary_.begin(),
                    boundary_.end(), is_same);
}

void checked_triangulation::enter_measurements(audit_report& report) const {
  report.domain_checked = domain_checked_;
  report.largest_deviation = largest_deviation_;
  report.largest_deviation_ulps = largest_deviation_ulps_;
  report.curves = curves_;
}

}  // namespace asterism::internal::audit_detail
