// SPDX-License-Identifier: MIT
#include "asterism/apps/adapt/adapt_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <utility>

#include "asterism/apps/job/frozen.hpp"
#include "asterism/apps/job/job_words.hpp"
#include "asterism/apps/options/periodic_options.hpp"
#include "asterism/apps/text/page_facts.hpp"
#include "asterism/apps/text/summary.hpp"
#include "asterism/apps/text/transfer_text.hpp"
#include "asterism/mesh/claims/metric_words.hpp"
#include "asterism/mesh/data/bounding_box.hpp"
#include "asterism/mesh/metric/interpolated_field.hpp"
#include "asterism/mesh/pipeline/foreign_mesh.hpp"

namespace asterism::apps {
using namespace internal;
namespace {

// Returns the fields of the solution alone, without those that are only transferred.
solution own_fields(const solution& all, std::size_t own) {
  solution shown{all.vertices, all.fields};
  if (shown.fields.size() > own) shown.fields.resize(own);
  return shown;
}

// Puts the mesh before the adaptation, and the solution on both meshes, onto the page. Shows the
// interpolated solution where no transfer was asked for.
void show_solution(const adapt_job& job, const adapted& made, report_facts& facts) {
  const solution& old = made.wanted.values;
  const std::size_t own = made.wanted.own_fields;
  facts.label = "Adapted";
  facts.before = {{"Before", made.wanted.background, own_fields(old, own), {}}};
  if (old.fields.empty()) return;
  // Leaves out values on a mesh with slits: a page has one vertex at each place, and values of the
  // two sides may differ.
  if (made.values && made.next.cracks.empty()) {
    facts.fields = own_fields(made.values->values, own);
    return;
  }
  auto shown =
      transfer_solution(made.wanted.background, own_fields(old, own), made.written(), job.how);
  if (shown) facts.fields = std::move(shown).value().values;
}

// Writes a line on whether the given mesh stays, where the options do not determine that.
void say_kept(std::ostream& out, const adapt_job& job, const adapted& made) {
  const bool always = job.options.keep == keep_rule::always;
  if (made.next.kept && job.options.keep == keep_rule::never)
    out << "the new mesh is the one given, vertex by vertex\n";
  else if (made.next.kept)
    out << (always ? "the mesh stays as it is, as --keep always wants it\n"
                   : "the mesh meets its metric and stays as it is\n");
  else if (always)
    out << "a new mesh: the one given is not certified in the metric, as one of its domain\n";
}

}  // namespace

report_facts facts_of_page(const adapt_job& job, const std::filesystem::path& certificate_path,
                           const adapted& made) {
  const certified_mesh& next = made.next.made;
  report_facts facts;
  facts.title = job.request.mesh + ", metric of " + next.claim.metric;
  facts.claim = next.claim;
  facts.claim_from = "As the run that made this page judged the mesh it had made.";
  facts.repeat = repeating_command(job.outputs, certificate_path);
  const auto adopted =
      adopt_mesh(made.wanted.background, region_edges::segments, slit_rule::joined);
  if (next.outcome.delivered && adopted)
    facts.wanted =
        tensors_at_sites(*make_interpolated_field(adopted.value().subject, 1), made.written());
  show_solution(job, made, facts);
  return facts;
}

void summarize(std::ostream& out, const adapt_job& job, const adapted& made) {
  write_summary(out, made.next.made, made.next.made.claim.measured.at("unit_edges"));
  if (made.has_frozen()) out << text_of(made.frozen, job.options.refinement.angle_bound) << '\n';
  out << "metric: " << internal::text_of(made.wanted.report) << '\n';
  if (made.next.keeps_boundary)
    out << "domain: all boundary vertices kept, as its parts touch; --domain names one "
           "exactly\n";
  else if (made.next.boundary_vertices > 0)
    out << fmt::format(
        "domain: {} of {} boundary vertices kept; old and new boundary within {:.3g} of each "
        "other\n",
        made.next.boundary_kept, made.next.boundary_vertices, made.next.boundary_distance);
  write_periodic(out, made.next.made.claim);
  out << cracks_text(made.next.cracks);
  say_kept(out, job, made);
  if (made.next.made.outcome.delivered)
    out << "delivered: " << text_of(*made.next.made.outcome.delivered) << '\n';
  if (made.values) out << text_of(made.values->report);
}

adapt_facts facts_of(const adapted& made) {
  return {made.wanted.report, made.next, made.values ? &made.values->report : nullptr,
          made.vertices_wanted};
}

std::string next_step(const adapt_job& job, const adapted& made) {
  const adapted_mesh& next = made.next;
  const mesh_outcome& outcome = next.made.outcome;
  if (outcome.how() == ending::stopped) return "";
  constexpr double most = 0.5, part = 0.5;
  const bool has_bound = std::isfinite(job.request.wishes.greatest_size);
  if (made.wanted.report.complexity_along_ridges > most && !has_bound) {
    const bounding_box box = next.shape.box();
    return fmt::format("--hmax {:.2g}, or an --aspect of 30",
                       part * std::max(box.high.x - box.low.x, box.high.y - box.low.y));
  }
  constexpr double greatest = 0.125, factor = 4, usual = 0.03;
  const double now = job.options.boundary_part.value_or(usual);
  const bool is_polygon = job.domain.empty() && !job.options.largest_boundary_distance;
  const bool has_more = made.vertices_wanted && outcome.sites > *made.vertices_wanted;
  if (is_polygon && !next.shape.curves.empty() && now < greatest &&
      (has_more || !next.made.certified()))
    return fmt::format("--boundary-part {:g}, which lets more vertices of the boundary go",
                       std::min(greatest, factor * now));
  return "";
}

}  // namespace asterism::apps
