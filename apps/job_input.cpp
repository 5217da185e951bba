// SPDX-License-Identifier: MIT
#include "asterism/apps/job_input.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "asterism/apps/notes.hpp"
#include "asterism/apps/repair_hint.hpp"
#include "asterism/apps/summary.hpp"
#include "asterism/mesh/domain/built_in_domains.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/domain/convex_hull.hpp"
#include "asterism/mesh/domain/divide_curves.hpp"
#include "asterism/mesh/domain/repair_domain.hpp"
#include "asterism/mesh/io/edges_domain.hpp"
#include "asterism/mesh/io/load_domain.hpp"
#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/mesh/metric/interpolated_field.hpp"
#include "asterism/mesh/metric/local_sizes.hpp"
#include "asterism/mesh/metric/make_metric_field.hpp"
#include "asterism/mesh/pipeline/domain_background.hpp"
#include "asterism/mesh/pipeline/layer_rows.hpp"
#include "asterism/mesh/pipeline/read_triangulation.hpp"
#include "asterism/mesh/pipeline/scaled_metric.hpp"

namespace asterism::apps {
using namespace internal;
namespace {

note_options notes_of(const mesh_job& job) { return {job.quiet, job.strict}; }

// Returns the function that makes the metric for any size; it reads a mesh only once.
result<field_of_size> metric_of(const mesh_job& job, const domain& shape) {
  if (job.field)
    return field_of_size(
        [make = job.field, box = shape.box()](double size) { return make(size, box); });
  if (!is_metric_on_mesh(job.metric))
    return field_of_size([spec = job.metric, box = shape.box()](double size) {
      return make_metric_field(spec, box, size);
    });
  auto background = read_metric_on_mesh(job.metric, job.domain);
  if (!background) return background.failure();
  return field_of_size([given = std::move(background.value().subject)](
                           double size) -> result<std::unique_ptr<metric_field>> {
    return make_sampled_field(given, size);
  });
}

// Returns the size wanted where no place has one of its own.
std::optional<double> size_elsewhere(const mesh_job& job, const size_wishes& sizes,
                                     const domain& shape) {
  if (job.size || job.complexity || job.refinement.vertices || sizes.is_empty()) return job.size;
  return size_where_none_is_wished(sizes, shape);
}

result<prepared_input> with_metric(const mesh_job& job, const size_wishes& sizes, domain shape) {
  const auto metric = metric_of(job, shape);
  if (!metric) return metric.failure();
  scale_demand wanted;
  wanted.size = size_elsewhere(job, sizes, shape);
  wanted.gradation = job.gradation;
  wanted.complexity = job.complexity;
  wanted.sizes = sizes;
  if (job.refinement.vertices)
    wanted.complexity = job.vertices_factor * complexity_of_vertices(*job.refinement.vertices);
  auto made = make_scaled_metric(shape, metric.value(), wanted);
  if (!made) return made.failure();
  return prepared_input{std::move(shape),
                        std::move(made.value().field),
                        made.value().gradation,
                        made.value().size,
                        {},
                        made.value().complexity,
                        made.value().background_fingerprint,
                        sizes};
}

// Adds to a refusal that an option mends it, or may mend it, if there is such an option.
error with_remedy(const error& refusal, const domain& d) {
  const repair_hint hint = try_repair(d);
  switch (hint.answer) {
    case repair_answer::mends:
      return {refusal.message + "; --repair-domain mends it: " + hint.changes, refusal.code};
    case repair_answer::not_known:
      return {refusal.message +
                  "; --repair-domain may mend it, and takes long: so much crosses that it was not "
                  "tried to its end",
              refusal.code};
    case repair_answer::fails:
      break;
  }
  if (const auto closed = with_convex_hull(d); closed && check_domain(closed.value()))
    return {refusal.message + "; --convex-hull closes it by the convex hull of its vertices",
            refusal.code};
  return refusal;
}

error without_repair(const error& refusal) {
  return {refusal.message +
              "; --repair-domain mends no domain with curves, because what moves would "
              "leave its curve: this one is for whoever made the file",
          refusal.code};
}

// Returns the domain put in order, its curves divided, also for the field where one is given. A
// domain with curves is not repaired, even if that is asked for.
result<domain> checked_domain(const mesh_job& job, const domain& loaded, const metric_field* field,
                              domain_repairs& repairs) {
  const bool has_curves = !loaded.curves.empty();
  if (job.repair && !has_curves) return repair_domain(loaded, job.repair_distance, &repairs);
  curve_division chords;
  chords.chord_tolerance = job.chord_tolerance;
  chords.field = field;
  chords.most_chords = job.refinement.max_sites;
  const auto divided = divide_curves(loaded, chords);
  auto checked = divided ? check_domain(divided.value(), &repairs) : divided;
  if (checked || (!divided && !job.repair)) return checked;
  return job.repair ? without_repair(checked.failure()) : with_remedy(checked.failure(), loaded);
}

// Takes the areas that the domain wants of triangles in its regions as sizes there. A triangle is
// too large when its corners are farther than 0.75 from its centre, so that none has more than 3/4
// sqrt(3) 0.75^2 = 0.7308 of the square of the size.
std::optional<error> take_areas(domain& d, size_wishes& sizes) {
  constexpr double greatest_area = 0.7308;
  std::map<int, double> known;
  for (region_point& r : d.regions) {
    const double area = std::exchange(r.largest_area, 0);
    const auto [at, is_new] = known.emplace(r.number, area);
    if (!is_new && at->second != area)
      return error{"--sizes-of-file: two points of region " + std::to_string(r.number) + " in " +
                   d.name +
                   " want triangles of other areas; regions of other sizes need other "
                   "numbers"};
    if (is_new && area > 0) sizes.regions.push_back({r.number, std::sqrt(area / greatest_area)});
  }
  if (!sizes.regions.empty()) return std::nullopt;
  return error{"--sizes-of-file: " + d.name + " wants no areas of triangles in regions"};
}

result<domain> put_in_order(const mesh_job& job, domain& loaded, domain_repairs& repairs,
                            size_wishes& sizes) {
  if (job.convex_hull) {
    auto closed = close_by_hull(std::move(loaded));
    if (!closed) return closed;
    loaded = std::move(closed).value();
  }
  if (job.number_regions) loaded.number_all_regions = true;
  if (job.sizes_of_file)
    if (auto refused = take_areas(loaded, sizes)) return *refused;
  if (job.chord_tolerance && loaded.curves.empty())
    return error{"--chord-tolerance: " + job.domain + " has no curves"};
  auto checked = checked_domain(job, loaded, nullptr, repairs);
  if (!checked) return checked;
  for (const auto& notes : {loaded.origin.notes, repairs.messages})
    if (auto refused = say_notes(notes, notes_of(job))) return *refused;
  return checked;
}

result<domain> load_and_check(const mesh_job& job, domain& loaded, domain_repairs& repairs,
                              size_wishes& sizes) {
  auto read = load_domain(job.domain);
  if (!read) return read.failure();
  loaded = std::move(read).value();
  return put_in_order(job, loaded, repairs, sizes);
}

// Returns what a mesh covers, with its vertices, boundary edges and regions; its metric is not
// used.
result<domain> domain_of_mesh(const mesh_job& job, mesh read, crack_markers& cracks) {
  if (job.repair)
    return error{"--repair-domain: " + job.domain + " is a mesh, whose edges are kept as they are"};
  if (job.sizes_of_file)
    return error{"--sizes-of-file: " + job.domain + " is a mesh, which has no areas of regions"};
  if (job.number_regions)
    return error{"--regions: " + job.domain + " is a mesh, which has its regions already"};
  if (job.convex_hull)
    return error{"--convex-hull: " + job.domain + " is a mesh, which has its boundary already"};
  auto adopted = checked_triangulation(std::move(read), job.domain, slit_rule::joined);
  if (!adopted) return adopted.failure();
  cracks = std::move(adopted.value().cracks);
  if (auto refused = say_notes(adopted.value().subject.notes, notes_of(job))) return *refused;
  return std::move(adopted.value().shape);
}

// Reads the domain of a mesh file: what its triangles cover, or what its edges bound where it has
// no triangles.
result<domain> read_mesh_domain(const mesh_job& job, domain& loaded, domain_repairs& repairs,
                                size_wishes& sizes, bool& of_mesh, crack_markers& cracks) {
  auto read = read_mesh_file(job.domain, {.without_solution = true});
  if (!read) return read.failure();
  of_mesh = !has_edges_alone(read.value());
  if (of_mesh) return domain_of_mesh(job, std::move(read.value().content), cracks);
  auto bounded = domain_of_edges(std::move(read).value(), job.domain);
  if (!bounded) return bounded;
  loaded = std::move(bounded).value();
  return put_in_order(job, loaded, repairs, sizes);
}

// Refuses a limit that the vertices of the domain alone exceed.
std::optional<error> check_counts(const mesh_job& job, std::size_t given) {
  if (job.keeps_site_limit && given > job.refinement.max_sites)
    return error{"--max-sites " + std::to_string(job.refinement.max_sites) + ": the domain has " +
                 std::to_string(given) + " vertices already"};
  if (job.refinement.vertices && given > *job.refinement.vertices)
    return error{"--vertices " + std::to_string(*job.refinement.vertices) + ": the domain has " +
                 std::to_string(given) + " already"};
  if (job.keeps_site_limit && job.refinement.vertices &&
      *job.refinement.vertices > job.refinement.max_sites)
    return error{"--vertices " + std::to_string(*job.refinement.vertices) +
                 ": more than --max-sites " + std::to_string(job.refinement.max_sites)};
  return std::nullopt;
}

}  // namespace

result<domain> close_by_hull(domain d) {
  auto closed = with_convex_hull(std::move(d));
  if (!closed) return error{"--convex-hull: " + closed.failure().message, closed.failure().code};
  return closed;
}

result<prepared_input> prepare(const mesh_job& job) {
  domain_repairs repairs;
  domain loaded;
  size_wishes sizes = job.sizes;
  if (job.metric != "identity" && !job.size && !job.complexity && !job.refinement.vertices &&
      (!sizes.is_empty() || job.sizes_of_file))
    return error{"sizes at places with --metric " + job.metric +
                 ": --size says how long edges are in that"};
  bool of_mesh = false;
  crack_markers cracks;
  auto checked = is_mesh_file(job.domain)
                     ? read_mesh_domain(job, loaded, repairs, sizes, of_mesh, cracks)
                     : load_and_check(job, loaded, repairs, sizes);
  if (!checked) return checked.failure();
  // Curves are divided for the metric once it is known. What is placed in the domain's box is made
  // anew then: in the box of the chords that are meshed, which the certificate holds.
  if (job.refinement.limit_size && !checked.value().curves.empty()) {
    const auto rough = with_metric(job, sizes, checked.value());
    if (!rough) return rough.failure();
    checked = checked_domain(job, loaded, rough.value().field.get(), repairs);
    if (!checked) return checked.failure();
  }
  auto populated = add_random_points(checked.value(), job.random_points, job.refinement.seed);
  if (!populated) return populated.failure();
  if (auto refused = check_counts(job, populated.value().vertices.size())) return *refused;
  auto prepared = with_metric(job, sizes, std::move(populated).value());
  if (prepared && !sizes.layers.empty()) {
    const prepared_input& rough = prepared.value();
    auto rows = with_layer_rows(rough.shape, sizes, *rough.field,
                                job.refinement.max_sites - rough.shape.vertices.size());
    if (!rows) return rows.failure();
    prepared = with_metric(job, sizes, std::move(rows).value());
  }
  if (!prepared) return prepared;
  if (const auto note = note_on_uncovered(prepared.value().shape, *prepared.value().field))
    if (auto refused = say_notes({*note}, notes_of(job))) return *refused;
  prepared.value().repairs = std::move(repairs);
  prepared.value().of_mesh = of_mesh;
  if (job.repair) prepared.value().before_repair = std::move(loaded);
  prepared.value().cracks = std::move(cracks);
  return prepared;
}

}  // namespace asterism::apps
