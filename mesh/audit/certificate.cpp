// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/certificate.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "asterism/core/version.h"
#include "asterism/mesh/audit/theorem_hypotheses.hpp"

namespace asterism {
namespace {

constexpr std::uint64_t fnv_prime = 0x100000001b3U;

// Powers of the hash's prime: entry n is the factor by which n zero bytes multiply the hash.
constexpr std::array<std::uint64_t, 9> fnv_powers = [] {
  std::array<std::uint64_t, 9> powers{1};
  for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = powers[i - 1] * fnv_prime;
  return powers;
}();

// Hashes words byte by byte, the lowest first. Leading zero bytes, most bytes of an index, are
// hashed by one multiplication.
class fnv1a {
 public:
  void add(std::uint64_t word) {
    std::size_t left = 8;
    for (; word != 0; word >>= 8, --left) hash_ = (hash_ ^ (word & 0xff)) * fnv_prime;
    hash_ *= fnv_powers[left];
  }
  void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325U;
};

// True if some triangle has a region other than 1. Regions that are all 1 mean the same as no
// regions.
bool has_regions(const mesh& subject) {
  return std::any_of(subject.regions.begin(), subject.regions.end(),
                     [](int region) { return region != 1; });
}

}  // namespace

std::uint64_t mesh_fingerprint(const mesh& subject) {
  fnv1a hash;
  for (const std::size_t count : {subject.sites.size(), std::size_t{subject.given},
                                  subject.triangles.size(), subject.boundary.size()})
    hash.add(std::uint64_t{count});
  for (const site& s : subject.sites)
    for (const double x : {s.position.x, s.position.y, s.metric.m11, s.metric.m12, s.metric.m22})
      hash.add(x);
  for (const triangle& t : subject.triangles)
    for (const vertex_index v : t) hash.add(std::uint64_t{v});
  for (const boundary_edge& e : subject.boundary) {
    hash.add(std::uint64_t{e.a});
    hash.add(std::uint64_t{e.b});
    hash.add(static_cast<std::uint64_t>(e.marker));
    hash.add(std::uint64_t{e.internal});
  }
  for (const int reference : subject.references) hash.add(static_cast<std::uint64_t>(reference));
  if (has_regions(subject))
    for (const int region : subject.regions) hash.add(static_cast<std::uint64_t>(region));
  return hash.value();
}

bool is_theorem_asked(const audit_options& options, const audit_report& report) {
  return report.certified && options.angle_bound.value_or(0) > 0;
}

certificate make_certificate(const mesh& subject, const audit_options& options,
                             const audit_report& report) {
  std::optional<theorem_hypotheses> theorem;
  if (is_theorem_asked(options, report))
    theorem = measure_theorem_hypotheses(subject, *options.angle_bound, options.stop);
  return make_certificate(subject, options, report, std::move(theorem));
}

certificate make_certificate(const mesh& subject, const audit_options& options,
                             const audit_report& report,
                             std::optional<theorem_hypotheses> theorem) {
  certificate c;
  c.version = ASTERISM_VERSION_TEXT;
  c.sites = report.sites;
  c.triangles = report.triangles;
  c.boundary_subsegments = report.boundary_subsegments;
  c.given = report.given;
  c.fingerprint = mesh_fingerprint(subject);
  c.angle_bound = options.angle_bound;
  c.worst_angle = report.worst().degrees;
  c.worst_collateral = report.worst_collateral.degrees;
  c.worst_exempt = report.worst_exempt.degrees;
  c.exempt_corners = report.exempt_corners;
  c.exempt_triangles = report.exempt_triangles;
  c.collateral_triangles = report.collateral_triangles;
  c.low_triangles = report.low_triangles;
  c.largest_deviation = report.largest_deviation;
  c.curves = report.curves;
  c.regions = measure_regions(subject, options.original);
  c.domain_checked = report.domain_checked;
  c.angles_checked = report.angles_checked;
  c.stars_checked = report.stars_checked;
  c.certified = report.certified;
  c.voronoi = report.voronoi;
  for (std::size_t kind = 0; kind < finding_kind_count; ++kind)
    if (report.found[kind] != 0) c.found.emplace(finding_kind_names[kind], report.found[kind]);
  // Keeps the number of findings that an audit keeps by default, however many this report kept.
  std::array<std::size_t, finding_kind_count> kept{};
  for (const audit_finding& f : report.findings) {
    const auto kind = static_cast<std::size_t>(f.kind);
    if (kept[kind]++ < audit_options{}.findings_kept)
      c.witnesses.push_back(std::string(finding_kind_names[kind]) + ": " + f.witness);
  }
  c.audit_counters = report.counters;
  c.theorem = std::move(theorem);
  if (options.original != nullptr) c.original = *options.original;
  return c;
}

}  // namespace asterism
