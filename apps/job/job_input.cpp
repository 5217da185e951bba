// SPDX-License-Identifier: MIT
#include "asterism/apps/job/job_input.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "asterism/apps/base/notes.hpp"
#include "asterism/apps/job/repair_hint.hpp"
#include "asterism/apps/text/summary.hpp"
#include "asterism/mesh/delivery/domain_background.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/domain/convex_hull.hpp"
#include "asterism/mesh/domain/divide_curves.hpp"
#include "asterism/mesh/domain/repair_domain.hpp"
#include "asterism/mesh/io/edges_domain.hpp"
#include "asterism/mesh/io/load_domain.hpp"
#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/mesh/metric/interpolated_field.hpp"
#include "asterism/mesh/metric/make_metric_field.hpp"
#include "asterism/mesh/pipeline/read_triangulation.hpp"

namespace asterism::apps {
using namespace internal;
namespace {

note_options notes_of(const mesh_job& job) { return {job.quiet, job.strict}; }

// Returns the function that makes the metric for any size; it reads a mesh only once.
result<field_in_box> metric_of(const mesh_job& job) {
  if (job.field) return job.field;
  if (!is_metric_on_mesh(job.metric))
    return field_in_box([spec = job.metric](double size, const bounding_box& box) {
      return make_metric_field(spec, box, size);
    });
  auto background = read_metric_on_mesh(job.metric, job.domain);
  if (!background) return background.failure();
  auto given = std::make_shared<const mesh>(std::move(background.value().subject));
  return field_in_box(
      [given = std::move(given)](double size,
                                 const bounding_box&) -> result<std::unique_ptr<metric_field>> {
        return make_interpolated_field(*given, size);
      });
}

// Adds to the message of a refusal the option that mends the input, or may mend it, if there is
// one.
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

// Returns the domain put in order, with its curves divided. A domain with curves is not repaired,
// even if that is asked for.
result<domain> checked_domain(const mesh_job& job, const domain& loaded, domain_repairs& repairs) {
  const bool has_curves = !loaded.curves.empty();
  if (job.repair && !has_curves) return repair_domain(loaded, job.repair_distance, &repairs);
  curve_division chords;
  chords.chord_tolerance = job.chord_tolerance;
  chords.most_chords = job.refinement.max_sites;
  const auto divided = divide_curves(loaded, chords);
  auto checked = divided ? check_domain(divided.value(), &repairs) : divided;
  if (checked || (!divided && !job.repair)) return checked;
  return job.repair ? without_repair(checked.failure()) : with_remedy(checked.failure(), loaded);
}

// Converts the limits on areas of triangles in a domain's regions to sizes there. A triangle is too
// large when its corners are farther than 0.75 from its centre, so that none has more than 3/4
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
  auto checked = checked_domain(job, loaded, repairs);
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

// Returns the domain that a mesh covers, with the mesh's vertices, boundary edges and regions; its
// metric is not used.
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

// Reads the domain of a mesh file: the area its triangles cover, or that its edges bound where it
// has no triangles.
result<domain> read_mesh_domain(const mesh_job& job, domain& loaded, prepared_input& prepared) {
  auto read = read_mesh_file(job.domain, {.without_solution = true});
  if (!read) return read.failure();
  prepared.of_mesh = !has_edges_alone(read.value());
  if (prepared.of_mesh)
    return domain_of_mesh(job, std::move(read.value().content), prepared.cracks);
  auto bounded = domain_of_edges(std::move(read).value(), job.domain);
  if (!bounded) return bounded;
  loaded = std::move(bounded).value();
  return put_in_order(job, loaded, prepared.repairs, prepared.sizes);
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

void make_room(std::size_t given, mesh_options& options) {
  constexpr std::size_t times = 10;
  options.max_sites = std::max(options.max_sites, times * given);
}

result<prepared_input> prepare(const mesh_job& job) {
  prepared_input prepared;
  domain loaded;
  prepared.sizes = job.sizes;
  if (job.metric != "identity" && !job.size && !job.complexity && !job.refinement.vertices &&
      (!job.sizes.is_empty() || job.sizes_of_file))
    return error{"sizes at places with --metric " + job.metric +
                 ": --size says how long edges are in that"};
  auto checked = is_mesh_file(job.domain)
                     ? read_mesh_domain(job, loaded, prepared)
                     : load_and_check(job, loaded, prepared.repairs, prepared.sizes);
  if (!checked) return checked.failure();
  if (checked.value().curves.empty())
    if (auto refused = check_counts(job, checked.value().vertices.size() + job.random_points))
      return *refused;
  auto metric = metric_of(job);
  if (!metric) return metric.failure();
  mesh_source source{std::move(checked).value(),
                     std::move(metric).value(),
                     {job.size, job.complexity, job.gradation, {}, prepared.sizes},
                     job.chord_tolerance,
                     job.random_points};
  mesh_options options = job.refinement;
  if (!job.keeps_site_limit) make_room(source.shape.vertices.size() + job.random_points, options);
  auto made = prepare_mesh_input(source, options);
  if (!made) return made.failure();
  static_cast<mesh_input&>(prepared) = std::move(made).value();
  if (auto refused = check_counts(job, prepared.given)) return *refused;
  if (const auto note = note_on_uncovered(prepared.shape, *prepared.metric.field))
    if (auto refused = say_notes({*note}, notes_of(job))) return *refused;
  if (job.refinement.vertices && job.pieces == 0) prepared.source = std::move(source);
  if (job.repair) prepared.before_repair = std::move(loaded);
  return prepared;
}

}  // namespace asterism::apps
