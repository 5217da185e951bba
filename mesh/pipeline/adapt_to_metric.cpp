// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/adapt_to_metric.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/audit/boundary_distance.hpp"
#include "asterism/mesh/audit/split_edges.hpp"
#include "asterism/mesh/data/same_triangulation.hpp"
#include "asterism/mesh/domain/divide_curves.hpp"
#include "asterism/mesh/domain/mesh_outline.hpp"
#include "asterism/mesh/metric/interpolated_field.hpp"
#include "asterism/mesh/pipeline/foreign_mesh.hpp"
#include "asterism/mesh/pipeline/joined_marks.hpp"
#include "asterism/mesh/pipeline/kept_mesh.hpp"
#include "asterism/mesh/pipeline/outline_chords.hpp"
#include "asterism/mesh/pipeline/periodic_outline.hpp"
#include "asterism/mesh/pipeline/periodic_sides.hpp"

namespace asterism {
using namespace internal;
namespace {

// Returns the mesh with the domain's vertices as the given ones, if these are its first ones.
// Leaves out its notes, which were written when it was read.
std::optional<mesh> as_mesh_of(const mesh& m, const mesh_outline& outline) {
  if (outline.segment_of_edge.empty()) return std::nullopt;
  mesh same = m;
  same.notes.clear();
  same.given = static_cast<vertex_index>(outline.shape.vertices.size());
  for (std::size_t e = 0; e < same.boundary.size(); ++e)
    same.boundary[e].segment = outline.segment_of_edge[e];
  return same;
}

// Decides whether the given mesh stays, in place of a new one.
class keeping {
 public:
  keeping(const std::optional<mesh>& own, const mesh_adaptation_options& options)
      : own_(own), rule_(options.keep) {
    may_stay_ = own_ && rule_ != keep_rule::never &&
                (rule_ == keep_rule::always || has_enough_vertices(*own_, options.refinement)) &&
                (!options.no_split_across || edges_across(*own_).empty());
    if (may_stay_) lengths_ = edge_lengths_of(*own_);
  }

  // True if the given mesh stays without a new one being made.
  bool is_at_once() const {
    return may_stay_ && (rule_ == keep_rule::always || are_as_in_new_mesh(lengths_));
  }
  // True if the given mesh stays because the new mesh made for comparison is no better.
  bool is_as_good_as(const certified_mesh& made) const {
    return may_stay_ && !is_at_once() && made.certified() &&
           are_no_worse(lengths_, edge_lengths_of(made.outcome.result));
  }
  const mesh& own() const { return *own_; }

 private:
  const std::optional<mesh>& own_;
  keep_rule rule_;
  bool may_stay_ = false;
  edge_lengths lengths_;
};

// Takes the given mesh as the outcome if the auditor certifies it in its metric.
void stay(const keeping& kept, const mesh_adaptation_options& options, adapted_mesh& done) {
  auto same = outcome_of_keeping(kept.own(), done.shape, options.refinement);
  if (!same) return;
  done.kept = true;
  done.made = judge_outcome(*std::move(same), done.shape, options.refinement);
  claim_periodic(options.periodic, done.made);
}

// Returns the note on periodic sides whose vertices stay.
std::string note_on_kept(const std::vector<int>& markers) {
  std::string named;
  for (const int marker : markers) named += (named.empty() ? "" : ", ") + std::to_string(marker);
  return "the periodic sides with the markers " + named +
         " keep all their vertices, as some of them bend; new ones are on the straight edges "
         "between";
}

// True if the periodic sides of the mesh match, and do so exactly wherever the corners of its
// domain are exact images. A new mesh would have exact images there.
bool has_periodic_sides(const mesh& m, const domain& shape,
                        const std::vector<periodic_pair>& pairs) {
  return std::all_of(pairs.begin(), pairs.end(), [&](const periodic_pair& one) {
    const auto match = match_periodic(m, one);
    if (!match) return false;
    if (match.value().kind != periodic_kind::matched) return true;
    const auto sides = periodic_sides::find(shape, one);
    return sides && !sides.value().map().is_exact;
  });
}

// Sets the number of vertices wanted and the limit on sites. If no number is named, the limit is at
// most ten times the vertices of the mesh: a metric that asks for more is mostly in the wrong unit,
// and a mesh of millions takes hours.
mesh_options options_for(const mesh& m, const mesh_adaptation_options& asked) {
  mesh_options options = asked.refinement;
  options.limit_size = true;
  constexpr double most = most_sites_unasked, times = 3, more = 1000, growth = 10;
  const bool names_count = options.vertices.has_value();
  const double wanted =
      names_count ? static_cast<double>(*options.vertices) : vertices_of_unit_edges(m).all;
  if (!names_count && wanted >= 1 && wanted < most)
    options.vertices = static_cast<std::size_t>(std::lround(wanted));
  if (asked.keeps_site_limit) return options;
  double room = std::min(times * wanted + more, most);
  if (!names_count) room = std::min(room, growth * static_cast<double>(m.sites.size()));
  options.max_sites = std::max(options.max_sites, static_cast<std::size_t>(room));
  return options;
}

// Returns the domain with chords for the metric of the mesh. There is at most one chord for every
// four vertices wanted: adaptation splits the chords on their curves.
result<domain> divided_for(const mesh& m, const domain& exact,
                           const mesh_adaptation_options& options) {
  constexpr std::size_t part = 4;
  const auto field = make_interpolated_field(m, 1);
  curve_division chords;
  chords.chord_tolerance = options.chord_tolerance;
  chords.field = field.get();
  chords.most_chords = options.refinement.vertices.value_or(m.sites.size()) / part;
  return divide_curves_anew(exact, chords);
}

// Proves how far the boundary is from the former one, where there is one, and puts it in the claim.
// A mesh that is farther than the bound asked for is not complete.
void compare_boundaries(adapted_mesh& done) {
  if (!done.former) return;
  certificate& claim = done.made.claim;
  claim.former = done.former;
  claim.former_distance =
      measure_former_boundary(done.made.outcome.result, done.shape, *done.former);
  done.boundary_distance = claim.former_distance.largest_distance;
  if (!done.former->allowed || done.boundary_distance <= *done.former->allowed) return;
  done.made.outcome.complete = claim.complete = false;
  const auto numbers = numbers_apart(done.boundary_distance, *done.former->allowed);
  claim.reason = "the boundary is up to " + numbers[0] +
                 " away from the one that it took the place of, and " + numbers[1] +
                 " was asked for";
}

outline_options outline_options_of(const mesh_adaptation_options& options) {
  outline_options made;
  made.corner_angle = options.corner_angle;
  made.largest_distance = options.largest_boundary_distance;
  if (options.boundary_part) made.part_of_length = made.part_of_size = *options.boundary_part;
  return made;
}

}  // namespace

result<adapted_mesh> adapt_to_metric(const marked_mesh& from,
                                     const mesh_adaptation_options& options,
                                     const progress_listener& progress) {
  auto adopted = adopt_mesh(from.subject, region_edges::segments, slit_rule::joined);
  if (!adopted) return adopted.failure();
  const mesh& background = adopted.value().subject;
  adapted_mesh done;
  done.cracks = adopted.value().cracks;
  if (options.exact && !done.cracks.empty())
    return error{"the mesh has slits, whose vertices are there twice, and another domain has none",
                 error_code::invalid_mesh};
  if (options.no_split_across && !done.cracks.empty())
    return error{
        "the mesh has slits, beside which inner edges that join two vertices of the boundary are "
        "not looked for: adapt it without splitting such edges",
        error_code::bad_option};
  const mesh_marks marks = joined_marks(from.marks, adopted.value().number);
  std::optional<mesh> own;  // the mesh, as one that may stay
  std::optional<chorded_outline> for_new;
  std::vector<int> kept_sides;
  if (options.exact) {
    const auto divided = divided_for(background, *options.exact, options);
    if (!divided) return divided.failure();
    done.shape = divided.value();
  } else {
    auto outline =
        outline_with_partners(background, marks, outline_options_of(options), options.periodic);
    if (!outline) return outline.failure();
    const mesh_outline& found = outline.value().found;
    kept_sides = outline.value().kept_sides;
    done.shape = found.keeps_all ? adopted.value().shape : found.shape;
    done.boundary_vertices = found.boundary_vertices;
    done.keeps_boundary = found.keeps_all;
    done.boundary_kept = found.keeps_all ? found.boundary_vertices : found.kept;
    done.former = found.former;
    if (has_periodic_sides(background, done.shape, options.periodic))
      own = as_mesh_of(background, found);
    // Adds no chords with periodic sides: the chords of both sides would have to match.
    if (!found.keeps_all && options.periodic.empty()) for_new = with_chords_for(background, found);
  }
  if (const auto failed = check_periodic(done.shape, options.periodic)) return *failed;
  keeping kept(own, options);
  if (kept.is_at_once()) stay(kept, options, done);
  if (done.kept) {
    compare_boundaries(done);
    return done;
  }
  const auto field = make_interpolated_field(background, 1);
  const mesh_options how = options_for(background, options);
  const domain& shape = for_new ? for_new->shape : done.shape;
  auto made =
      make_periodic_mesh(shape, *field, how, options.periodic, progress, options.no_split_across);
  if (!made) return made.failure();
  done.made = std::move(made).value();
  if (kept.is_as_good_as(done.made)) stay(kept, options, done);
  if (!done.kept && for_new) {
    done.shape = std::move(for_new->shape);
    done.former = std::move(for_new->former);
  }
  if (is_same_triangulation(done.made.outcome.result, background)) done.kept = true;
  if (!kept_sides.empty()) done.made.outcome.result.notes.push_back(note_on_kept(kept_sides));
  compare_boundaries(done);
  return done;
}

}  // namespace asterism
