// SPDX-License-Identifier: MIT
#include "asterism/mesh/c_interface/mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "asterism/kernels/c_question.hpp"
#include "asterism/mesh/audit/verify.hpp"
#include "asterism/mesh/c_interface/arrays.hpp"
#include "asterism/mesh/c_interface/message_buffer.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/domain/divide_curves.hpp"
#include "asterism/mesh/pipeline/certified_mesh.hpp"
#include "asterism/mesh/pipeline/counted_mesh.hpp"
#include "asterism/mesh/pipeline/foreign_mesh.hpp"
#include "asterism/mesh/pipeline/outcome_text.hpp"

using namespace asterism;
using namespace asterism::internal;

static_assert(std::is_same_v<vertex_index, unsigned> && sizeof(site) == 5 * sizeof(double) &&
              sizeof(triangle) == 3 * sizeof(unsigned));

struct asterism_mesh {
  certified_mesh made;
  std::string certificate, reason;
  std::vector<int> regions, markers;
  std::vector<unsigned> edges;

  const mesh& content() const { return made.outcome.result; }
};

namespace {

// Number of the first vertex, triangle and edge in messages, as in the arrays.
constexpr int first_number = 0;

result<mesh_options> options_of(const asterism_mesh_options& given) {
  mesh_options options;
  options.angle_bound = given.angle_bound;
  options.limit_size = given.limit_size != 0;
  options.max_sites = given.max_sites;
  options.prove_voronoi = given.prove_voronoi != 0;
  if (!(given.angle_bound >= 0 && given.angle_bound < 60))
    return error{"the angle bound must be at least 0 and below 60 degrees"};
  if (!std::isfinite(given.metric_tolerance))
    return error{"metric_tolerance must be a finite number"};
  if (given.metric_tolerance >= 0) options.metric_tolerance = given.metric_tolerance;
  if (given.vertices > 0) {
    if (given.vertices < 3 || given.vertices > given.max_sites)
      return error{"vertices must be from 3 to max_sites"};
    options.vertices = given.vertices;
    options.limit_size = true;
  }
  if (given.stop != nullptr)
    options.stop = [stop = given.stop, context = given.stop_context] {
      return stop(context) != 0 ? std::optional<std::string>("the caller stopped it")
                                : std::nullopt;
    };
  return options;
}

std::unique_ptr<asterism_mesh> package(certified_mesh made) {
  auto mesh = std::make_unique<asterism_mesh>();
  mesh->made = std::move(made);
  mesh->certificate = certificate_text(mesh->made.claim);
  mesh->reason = ending_text(mesh->made.outcome, first_number);
  mesh->regions = mesh->content().regions;
  if (mesh->regions.empty()) mesh->regions.assign(mesh->content().triangles.size(), 1);
  for (const boundary_edge& e : mesh->content().boundary) {
    mesh->edges.insert(mesh->edges.end(), {e.a, e.b});
    mesh->markers.push_back(e.marker);
  }
  return mesh;
}

// Returns the domain put in order, its curves divided.
result<domain> accepted(const asterism_domain& arrays, const mesh_options& options) {
  const auto drawn = domain_of(arrays);
  if (!drawn) return drawn;
  const auto divided = divide_curves(drawn.value());
  if (!divided) return divided;
  auto shape = check_domain(divided.value());
  if (!shape) return shape;
  const std::size_t given = shape.value().vertices.size();
  if (given > options.max_sites) return error{"the domain has more vertices than max_sites allows"};
  if (shape.value().curves.empty() && given > options.vertices.value_or(given))
    return error{"vertices: the domain has " + std::to_string(given) + " already"};
  return shape;
}

// Returns the function that makes this metric for any size. A size is the factor by which it makes
// all edges longer.
field_in_box metric_of(const asterism_metric& metric) {
  return [&metric](double size, const bounding_box& box) {
    asterism_metric sized = metric;
    sized.size = size * (metric.size == 0 ? 1 : metric.size);
    return field_of(sized, box);
  };
}

asterism_status create(const asterism_domain& domain, const asterism_metric& metric,
                       const asterism_mesh_options& wanted, asterism_mesh** out,
                       const message_buffer& message) {
  const auto options = options_of(wanted);
  if (!options) return message.refuse(options.failure());
  if (!(wanted.chord_tolerance >= 0 && std::isfinite(wanted.chord_tolerance)))
    return message.refuse({"chord_tolerance must be a finite number, at least 0"});
  auto shape = accepted(domain, options.value());
  if (!shape) return message.refuse(shape.failure());
  mesh_source source{std::move(shape).value(), metric_of(metric)};
  if (wanted.chord_tolerance > 0) source.chord_tolerance = wanted.chord_tolerance;
  auto made = make_counted_mesh(source, options.value(),
                                [](const mesh_input& input, const mesh_options& how) {
                                  return make_certified_mesh(input.shape, *input.metric.field, how);
                                });
  if (!made) return message.refuse(made.failure());
  *out = package(std::move(made.value().made)).release();
  return ASTERISM_OK;
}

// Returns the first finding or contradiction that refuses a mesh.
std::string first_reason(const verify_report& report) {
  if (!report.contradictions.empty()) return report.contradictions.front();
  if (!report.audit.findings.empty()) return report.audit.findings.front().witness;
  return report.verified ? "" : "it is not certified";
}

std::string first_reason(const certify_report& report) {
  if (report.certified()) return "";
  if (!report.audit.findings.empty()) return report.audit.findings.front().witness;
  if (!report.not_in_all.empty())
    return "triangle " + std::to_string(report.not_in_all.front()) +
           " is not in the stars of all its vertices; there are " +
           std::to_string(report.not_in_all.size()) + " of them";
  return std::to_string(report.unsettled) + " stars met the bound of their construction";
}

template <class T>
const T* give(const std::vector<T>& values, size_t per_row, size_t* count) {
  if (count != nullptr) *count = values.size() / per_row;
  return values.data();
}

}  // namespace

void asterism_domain_init(asterism_domain* domain) {
  if (domain != nullptr) *domain = {};
}
void asterism_metric_init(asterism_metric* metric) {
  if (metric != nullptr) *metric = {};
}
void asterism_mesh_options_init(asterism_mesh_options* options) {
  if (options == nullptr) return;
  const mesh_options defaults;
  *options = {};
  options->angle_bound = defaults.angle_bound;
  options->max_sites = defaults.max_sites;
  options->metric_tolerance = -1;
}

asterism_status asterism_mesh_create(const asterism_domain* domain, const asterism_metric* metric,
                                     const asterism_mesh_options* options, asterism_mesh** out,
                                     char* message, size_t capacity) {
  const message_buffer told(message, capacity);
  if (domain == nullptr || metric == nullptr || out == nullptr) return ASTERISM_NULL_POINTER;
  asterism_mesh_options wanted;
  asterism_mesh_options_init(&wanted);
  if (options != nullptr) wanted = *options;
  return without_exceptions([&] { return create(*domain, *metric, wanted, out, told); });
}

void asterism_mesh_free(asterism_mesh* mesh) { delete mesh; }

int asterism_mesh_is_complete(const asterism_mesh* mesh) { return mesh->made.outcome.complete; }
const char* asterism_mesh_reason(const asterism_mesh* mesh) { return mesh->reason.c_str(); }
int asterism_mesh_is_certified(const asterism_mesh* mesh) { return mesh->made.certified(); }
double asterism_mesh_worst_angle(const asterism_mesh* mesh) {
  return mesh->made.report.worst().degrees;
}
const char* asterism_mesh_certificate(const asterism_mesh* mesh) {
  return mesh->certificate.c_str();
}

const double* asterism_mesh_sites(const asterism_mesh* mesh, size_t* count) {
  const std::vector<site>& sites = mesh->content().sites;
  if (count != nullptr) *count = sites.size();
  return sites.empty() ? nullptr : &sites.front().position.x;
}
const unsigned* asterism_mesh_triangles(const asterism_mesh* mesh, size_t* count) {
  const std::vector<triangle>& triangles = mesh->content().triangles;
  if (count != nullptr) *count = triangles.size();
  return triangles.empty() ? nullptr : triangles.front().data();
}
const int* asterism_mesh_regions(const asterism_mesh* mesh, size_t* count) {
  return give(mesh->regions, 1, count);
}
const unsigned* asterism_mesh_boundary(const asterism_mesh* mesh, size_t* count) {
  return give(mesh->edges, 2, count);
}
const int* asterism_mesh_boundary_markers(const asterism_mesh* mesh, size_t* count) {
  return give(mesh->markers, 1, count);
}

asterism_status asterism_mesh_verify(const asterism_mesh* mesh, const char* certificate,
                                     int* verified, char* message, size_t capacity) {
  const message_buffer told(message, capacity);
  if (mesh == nullptr || verified == nullptr) return ASTERISM_NULL_POINTER;
  return without_exceptions([&] {
    const auto claim =
        parse_certificate(certificate != nullptr ? certificate : mesh->certificate, "certificate");
    if (!claim) return told.refuse(claim.failure());
    audit_options asked;
    asked.first_number = first_number;
    const verify_report report = verify(mesh->content(), claim.value(), asked);
    *verified = report.verified ? 1 : 0;
    told.write(first_reason(report));
    return ASTERISM_OK;
  });
}

asterism_status asterism_certify(size_t site_count, const double* sites, size_t triangle_count,
                                 const unsigned* triangles, double angle_bound, int* certified,
                                 char* message, size_t capacity) {
  const message_buffer told(message, capacity);
  if (certified == nullptr || (sites == nullptr && site_count > 0) ||
      (triangles == nullptr && triangle_count > 0))
    return ASTERISM_NULL_POINTER;
  if (!(angle_bound >= 0 && angle_bound < 60)) return ASTERISM_OUT_OF_RANGE;
  return without_exceptions([&] {
    auto adopted =
        mesh_of({site_count, sites, 5}, {site_count, sites + 2, 5}, {triangle_count, triangles});
    if (!adopted) return told.refuse(adopted.failure());
    const certify_report report = certify(adopted.value(), angle_bound);
    *certified = report.certified() ? 1 : 0;
    told.write(first_reason(report));
    return ASTERISM_OK;
  });
}
