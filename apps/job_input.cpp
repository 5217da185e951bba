// SPDX-License-Identifier: MIT
#include "asterism/apps/job_input.hpp"

#include <iostream>
#include <string>
#include <utility>

#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/domain/built_in_domains.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/load_domain.hpp"
#include "asterism/mesh/io/medit.hpp"
#include "asterism/mesh/metric/interpolated_field.hpp"
#include "asterism/mesh/metric/make_metric_field.hpp"
#include "asterism/mesh/pipeline/foreign_mesh.hpp"

namespace asterism::apps {
using namespace internal;
namespace {

// Reads a mesh that is a triangulation, with whatever metric is beside it.
result<adopted_mesh> read_triangulation(const std::string& path, bool metric_wanted) {
  medit_read_options how;
  how.identity_without_solution = !metric_wanted;
  auto read = read_medit(path, how);
  if (!read) return read.failure();
  auto adopted = adopt_mesh(std::move(read).value());
  if (!adopted) return error{path + ": " + adopted.failure().message};
  audit_options options;
  options.check_stars = false;
  options.angle_bound = 0;
  const audit_report found = audit(adopted.value().subject, options);
  if (!found.certified)
    return error{path + " is no triangulation: " + found.findings.at(0).witness};
  return adopted;
}

using made_field = result<std::unique_ptr<metric_field>>;

made_field make_field(const mesh_job& job, const domain& shape) {
  const double size = job.size.value_or(1);
  if (!has_ending(job.metric, ".mesh")) return make_metric_field(job.metric, shape.box(), size);
  const auto background = read_triangulation(job.metric, true);
  if (!background) return background.failure();
  return make_sampled_field(background.value().subject, size);
}

result<prepared_input> with_metric(const mesh_job& job, domain shape) {
  auto field = make_field(job, shape);
  if (!field) return field.failure();
  if (!job.gradation)
    return prepared_input{std::move(shape), std::move(field).value(), std::nullopt};
  gradation_options options;
  options.beta = *job.gradation;
  auto graded = grade_metric(std::move(field).value(), shape.box(), options);
  if (!graded) return graded.failure();
  return prepared_input{std::move(shape), std::move(graded.value().field), graded.value().report};
}

result<domain> load_and_check(const mesh_job& job) {
  auto loaded = load_domain(job.domain);
  if (!loaded) return loaded.failure();
  if (job.number_regions) loaded.value().number_all_regions = true;
  domain_repairs repairs;
  auto checked = check_domain(loaded.value(), &repairs);
  if (checked && !job.quiet)
    for (const std::string& message : repairs.messages)
      std::cerr << "asterism: note: " << message << '\n';
  return checked;
}

// Returns what a mesh covers, with its vertices, boundary edges and regions; its metric is not
// used.
result<domain> domain_of_mesh(const mesh_job& job) {
  if (job.number_regions)
    return error{"--regions: " + job.domain + " is a mesh, which has its regions already"};
  auto adopted = read_triangulation(job.domain, false);
  if (!adopted) return adopted.failure();
  return std::move(adopted.value().shape);
}

}  // namespace

bool is_mesh(const mesh_job& job) { return has_ending(job.domain, ".mesh"); }

result<prepared_input> prepare(const mesh_job& job) {
  const auto checked = is_mesh(job) ? domain_of_mesh(job) : load_and_check(job);
  if (!checked) return checked.failure();
  auto populated = add_random_points(checked.value(), job.random_points, job.refinement.seed);
  if (!populated) return populated.failure();
  const std::size_t given = populated.value().vertices.size();
  if (given > job.refinement.max_sites)
    return error{"--max-sites " + std::to_string(job.refinement.max_sites) + ": the domain has " +
                 std::to_string(given) + " vertices already"};
  return with_metric(job, std::move(populated).value());
}

}  // namespace asterism::apps
