// SPDX-License-Identifier: MIT
//
// The functions that JavaScript calls in the module of asterism-mesh. A job comes as JSON, which
// api.mjs writes, and is prepared, run and described as the command does it: the files are the
// command's, byte for byte. What came of it is read from the module's memory. One job an instance.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "asterism/apps/job/job_input.hpp"
#include "asterism/apps/job/job_words.hpp"
#include "asterism/core/version.h"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/audit/verify.hpp"
#include "asterism/mesh/c_interface/arrays.hpp"
#include "asterism/mesh/io/file_note.hpp"
#include "asterism/mesh/io/medit.hpp"
#include "asterism/mesh/pipeline/certified_mesh.hpp"
#include "asterism/mesh/pipeline/foreign_mesh.hpp"
#include "asterism/packages/npm/asterism-mesh/given_files.hpp"

#define ASTERISM_FOR_JAVASCRIPT(name) extern "C" __attribute__((export_name(#name), used))

// Writes the tensors wanted at `count` points. Any result but 0 ends the run.
extern "C" __attribute__((import_module("asterism"), import_name("metric"))) int
metric_of_javascript(std::size_t count, const double* points, double* metrics);

namespace {

using namespace asterism;
using namespace asterism::internal;
using json = nlohmann::json;

// Holds the results of the job.
struct job_result {
  mesh made;
  std::vector<unsigned> edges;
  std::vector<int> markers, regions;
  bool complete = false, certified = false, verified = false;
  double worst_angle = 0;
  // Holds the reason where the input was refused, else the results.
  std::string failure, reason, certificate, mesh_file, solution_file;
  std::vector<std::string> witnesses;
  std::string all_witnesses;
};
job_result came;

template <class T>
void take(const json& options, const char* name, std::optional<T>& into) {
  if (options.contains(name)) into = options.at(name).get<T>();
}
template <class T>
void take(const json& options, const char* name, T& into) {
  if (options.contains(name)) into = options.at(name).get<T>();
}

// Reads the options, which have the command's names and defaults.
apps::mesh_job job_of(const json& asked) {
  const json& options = asked.at("options");
  apps::mesh_job job;
  job.domain = asked.at("domain").get<std::string>();
  job.metric = asked.at("metric").get<std::string>();
  take(options, "size", job.size);
  take(options, "gradation", job.gradation);
  take(options, "repairDomain", job.repair);
  take(options, "repairDistance", job.repair_distance);
  take(options, "chordTolerance", job.chord_tolerance);
  take(options, "regions", job.number_regions);
  take(options, "randomPoints", job.random_points);
  take(options, "strict", job.strict);
  mesh_options& refinement = job.refinement;
  take(options, "angleBound", refinement.angle_bound);
  take(options, "metricTolerance", refinement.metric_tolerance);
  take(options, "tol", refinement.tolerance);
  take(options, "maxSites", refinement.max_sites);
  take(options, "improve", refinement.improve_passes);
  take(options, "seed", refinement.seed);
  take(options, "proveVoronoi", refinement.prove_voronoi);
  const std::string strategy = options.value("refine", "fill");
  refinement.strategy = strategy == "voronoi" ? refinement_strategy::voronoi_arcs
                        : strategy == "darts" ? refinement_strategy::poisson_darts
                                              : refinement_strategy::fill;
  refinement.limit_size = job.size.has_value();
  if (asked.at("hasFunction").get<bool>())
    job.field = [](double size, const bounding_box& box) {
      asterism_metric metric;
      asterism_metric_init(&metric);
      metric.size = size;
      metric.batch_function = [](void*, std::size_t count, const double* points, double* metrics) {
        return metric_of_javascript(count, points, metrics);
      };
      return field_of(metric, box);
    };
  return job;
}

void keep_arrays() {
  came.regions = came.made.regions;
  if (came.regions.empty()) came.regions.assign(came.made.triangles.size(), 1);
  for (const boundary_edge& e : came.made.boundary) {
    came.edges.insert(came.edges.end(), {e.a, e.b});
    came.markers.push_back(e.marker);
  }
}

void note_findings(const audit_report& report) {
  for (const audit_finding& found : report.findings) came.witnesses.push_back(found.witness);
  came.worst_angle = report.worst().degrees;
}

std::optional<error> make(const json& asked) {
  const apps::mesh_job job = job_of(asked);
  auto input = apps::prepare(job);
  if (!input) return input.failure();
  mesh_options options = job.refinement;
  options.keep_if_complete = input.value().of_mesh;
  auto run = make_certified_mesh(input.value().shape, *input.value().metric.field, options);
  if (!run) return run.failure();
  certified_mesh& made = run.value();
  made.claim.metric = job.metric;
  made.claim.options = apps::options_of(job, input.value(), made.outcome);
  came.complete = made.outcome.complete;
  came.certified = made.certified();
  came.reason = made.claim.reason;
  note_findings(made.report);
  came.certificate = certificate_text(made.claim);
  came.made = std::move(made.outcome.result);
  came.mesh_file = with_file_note(medit_mesh_text(came.made), mesh_format::medit,
                                  apps::file_note_of(made.claim));
  came.solution_file = medit_solution_text(came.made);
  keep_arrays();
  return std::nullopt;
}

result<mesh> given_mesh() {
  medit_read_options options;
  options.solution = "given.sol";
  return read_medit("given.mesh", options);
}

// Judges a mesh by its certificate, which contains the domain and the bound.
std::optional<error> judge(const json& asked) {
  const auto subject = given_mesh();
  if (!subject) return subject.failure();
  const auto claim =
      parse_certificate(asked.at("certificate").get<std::string>(), "given.certificate.json");
  if (!claim) return claim.failure();
  const verify_report report = verify(subject.value(), claim.value(), {});
  came.verified = report.verified;
  came.witnesses = report.contradictions;
  note_findings(report.audit);
  came.made = subject.value();
  keep_arrays();
  return std::nullopt;
}

// Judges a mesh from elsewhere, against the domain that it covers.
std::optional<error> judge_alone(const json& asked) {
  auto subject = given_mesh();
  if (!subject) return subject.failure();
  auto adopted = adopt_mesh(std::move(subject).value());
  if (!adopted) return adopted.failure();
  const double bound = asked.at("angleBound").get<double>();
  const certify_report report = certify(adopted.value(), bound);
  came.verified = report.certified();
  note_findings(report.audit);
  if (report.certified())
    came.certificate = certificate_text(
        make_certificate(adopted.value().subject, questions_for(adopted.value()), report.audit));
  came.made = adopted.value().subject;
  keep_arrays();
  return std::nullopt;
}

// Runs a job from its text in memory. Returns 0, or 1 where the input was refused.
int run(const char* bytes, std::size_t length, std::optional<error> (*does)(const json&)) {
  std::optional<error> refused;
  try {
    const json asked = json::parse(bytes, bytes + length);
    for (const auto& [name, text] : asked.at("files").items())
      give_file(name, text.get<std::string>());
    refused = does(asked);
  } catch (const std::bad_alloc&) {
    refused = error{"there is not enough memory"};
  } catch (const json::exception& e) {
    refused = error{e.what()};
  }
  came.failure = refused ? refused->message : "";
  for (const std::string& witness : came.witnesses) came.all_witnesses += witness + '\n';
  return refused ? 1 : 0;
}

}  // namespace

ASTERISM_FOR_JAVASCRIPT(allocate) void* allocate_for_javascript(std::size_t bytes) {
  return std::malloc(bytes);
}
ASTERISM_FOR_JAVASCRIPT(mesh) int mesh_for_javascript(const char* job, std::size_t length) {
  return run(job, length, &make);
}
ASTERISM_FOR_JAVASCRIPT(verify) int verify_for_javascript(const char* job, std::size_t length) {
  return run(job, length, &judge);
}
ASTERISM_FOR_JAVASCRIPT(certify) int certify_for_javascript(const char* job, std::size_t length) {
  return run(job, length, &judge_alone);
}
ASTERISM_FOR_JAVASCRIPT(isComplete) int is_complete_for_javascript() { return came.complete; }
ASTERISM_FOR_JAVASCRIPT(isCertified) int is_certified_for_javascript() { return came.certified; }
ASTERISM_FOR_JAVASCRIPT(isVerified) int is_verified_for_javascript() { return came.verified; }
ASTERISM_FOR_JAVASCRIPT(worstAngle) double worst_angle_for_javascript() { return came.worst_angle; }

// Return the bytes of text `which`, and their number.
const std::string& text_number(unsigned which) {
  static const std::string version = ASTERISM_VERSION_TEXT;
  const std::string* const all[] = {&came.failure,   &came.reason,        &came.certificate,
                                    &came.mesh_file, &came.solution_file, &came.all_witnesses,
                                    &version};
  return *all[which];
}
ASTERISM_FOR_JAVASCRIPT(text) const char* text_for_javascript(unsigned which) {
  return text_number(which).data();
}
ASTERISM_FOR_JAVASCRIPT(textLength) std::size_t text_length_for_javascript(unsigned which) {
  return text_number(which).size();
}

// Return the arrays of the mesh, and how many numbers each has.
ASTERISM_FOR_JAVASCRIPT(sites) const double* sites_for_javascript() {
  return came.made.sites.empty() ? nullptr : &came.made.sites.front().position.x;
}
ASTERISM_FOR_JAVASCRIPT(siteCount) std::size_t site_count_for_javascript() {
  return came.made.sites.size();
}
ASTERISM_FOR_JAVASCRIPT(triangles) const unsigned* triangles_for_javascript() {
  return came.made.triangles.empty() ? nullptr : came.made.triangles.front().data();
}
ASTERISM_FOR_JAVASCRIPT(triangleCount) std::size_t triangle_count_for_javascript() {
  return came.made.triangles.size();
}
ASTERISM_FOR_JAVASCRIPT(regions) const int* regions_for_javascript() { return came.regions.data(); }
ASTERISM_FOR_JAVASCRIPT(edges) const unsigned* edges_for_javascript() { return came.edges.data(); }
ASTERISM_FOR_JAVASCRIPT(edgeCount) std::size_t edge_count_for_javascript() {
  return came.markers.size();
}
ASTERISM_FOR_JAVASCRIPT(markers) const int* markers_for_javascript() { return came.markers.data(); }
