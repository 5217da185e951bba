// SPDX-License-Identifier: MIT
#include "asterism/apps/job/plain_question.hpp"

#include <utility>

#include "asterism/apps/job/job_input.hpp"
#include "asterism/mesh/claims/field_claims.hpp"
#include "asterism/mesh/domain/plain_form.hpp"

namespace asterism::apps {
using namespace internal;

result<domain> plain_domain(const std::string& name, const note_options& notes,
                            const domain_repair& repair) {
  mesh_job job;
  job.domain = name;
  job.quiet = notes.quiet;
  job.strict = notes.strict;
  job.repair = repair.is_asked;
  job.repair_distance = repair.distance;
  auto prepared = prepare(job);
  if (!prepared) return prepared.failure();
  if (!prepared.value().shape.curves.empty())
    return error{name + ": it has curves, which are divided for each mesh anew",
                 error_code::invalid_domain};
  return plain_form(std::move(prepared.value().shape));
}

std::optional<error> take_metric(mesh& m, const std::string& metric, double size) {
  metric_wording asked;
  asked.name = metric;
  asked.size = size;
  domain around;
  for (const site& s : m.sites) around.vertices.push_back(s.position);
  const auto field = field_of(asked, around);
  if (!field) return field.failure().at("--metric");
  for (site& s : m.sites) {
    const auto tensor = field.value()->at(s.position);
    if (!tensor) return tensor.failure().at("--metric");
    s.metric = tensor.value();
  }
  return std::nullopt;
}

}  // namespace asterism::apps
