// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/outcome_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/core/number_text.hpp"
#include "asterism/mesh/delivery/shortest_given_edge.hpp"
#include "asterism/mesh/numerics/constructions.hpp"

namespace asterism {
namespace {
using internal::format_number;
using internal::number_text;
using internal::squared_distance;

std::string place_text(const point& at) {
  return fmt::format("({}, {})", format_number(at.x), format_number(at.y));
}

// Returns a clause on the places of bad triangles; empty if none are known.
std::string places_text(const refinement_ending& e, std::size_t first) {
  std::string text;
  if (e.steep)
    text += fmt::format(
        "; at {} of them, one at {}, the metric varies faster than sites {} apart can resolve (a "
        "gradation of it might do)",
        e.steep->triangles, place_text(e.steep->at), format_number(e.steep->spacing));
  if (e.sharpest)
    text += fmt::format("; the sharpest corner beside them is vertex {} at {}, {} degrees",
                        e.sharpest->vertex + first, place_text(e.sharpest->at),
                        format_number(e.sharpest->angle));
  return text;
}

std::string stuck_text(const refinement_ending& e, std::size_t first) {
  const char* tried =
      e.strategy == refinement_strategy::poisson_darts ? "darts" : "candidates on Voronoi arcs";
  return fmt::format(
      "stuck: {} bad triangles are left, and no {} farther than the tolerance {} from every site "
      "can be inserted{}",
      e.bad_triangles, tried, format_number(e.tolerance), places_text(e, first));
}

std::string crowded_text(const crowded_site& crowded) {
  if (crowded.has_one_metric)
    return fmt::format(
        "the metric, the same everywhere, wants triangles too thin for sites to be spread in this "
        "domain: {} were proposed (a bound on their aspect "
        "might do); only the given vertices are meshed",
        crowded.sites);
  return fmt::format(
      "the metric varies too fast for sites to be spread: of {} proposed, the one at {} has {} "
      "neighbours (a gradation of it might do); only the given vertices are meshed",
      crowded.sites, place_text(crowded.where), crowded.neighbours);
}

// Returns the text of the ending alone, whatever size was delivered.
std::string plain_text(const refinement_ending& e, std::size_t first) {
  switch (e.how) {
    case ending::site_limit:
      return fmt::format("the limit of {} sites was reached", e.max_sites);
    case ending::collateral:
      return fmt::format(
          "all stars agree, but {} triangles beside corners of the domain below the bound have "
          "another angle below it, which splitting did not mend{}",
          e.bad_triangles, places_text(e, first));
    case ending::stuck:
      return stuck_text(e, first);
    case ending::too_steep:
      return fmt::format(
          "given up: {} bad triangles are left after {} sites more than there were when the first "
          "could not be mended{}",
          e.bad_triangles, e.sites_since, places_text(e, first));
    case ending::overworked:
      return fmt::format(
          "given up: {} bad triangles are left after the most work that is done for so many "
          "sites{}",
          e.bad_triangles, places_text(e, first));
    case ending::stopped:
      return "stopped: " + e.stopped_because;
    default:
      return "all stars agree and every triangle meets the bound";
  }
}

// Returns a clause that the limit on sites made edges longer than wanted; nothing where it did not.
std::string size_text(const refinement_ending& e) {
  if (!(e.length_factor > 1)) return "";
  const std::string wanted =
      e.sites_wanted > 0 ? fmt::format(": the size wanted takes about {:.3g}", e.sites_wanted) : "";
  return fmt::format("the limit of {} sites was reached{}; with edges {:.3g} times as long, ",
                     e.max_sites, wanted, e.length_factor);
}

// Returns the text of the ending of one refinement, in which numbers count from `first`.
std::string text_of(const refinement_ending& e, std::size_t first) {
  if (e.how == ending::crowded && e.crowded) return crowded_text(*e.crowded);
  const std::string missing =
      e.stars_missing > 0
          ? fmt::format("; the stars of {} of {} sites were never made", e.stars_missing, e.sites)
          : "";
  return size_text(e) + (e.nothing_added ? "nothing to add: " : "") + plain_text(e, first) +
         missing;
}

// Returns the length of the shortest edge, as its first end measures it, and the place of that end.
std::pair<double, point> shortest_edge(const mesh& m) {
  std::pair<double, point> least{std::numeric_limits<double>::infinity(), {}};
  for (const triangle& t : m.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const site &p = m.sites[t[i]], &q = m.sites[t[(i + 1) % 3]];
      const double length = std::sqrt(squared_distance(p, q.position));
      if (length < least.first) least = {length, p.position};
    }
  return least;
}

// Returns a clause on the distance of the metric from the one wanted, with the measures of both.
std::string distances_text(const mesh_outcome& outcome) {
  const delivered_report& report = *outcome.delivered;
  constexpr double rounding = 1e-6;
  if (report.greatest < rounding) return "which differs from it by less than 1e-6 of any length";
  return fmt::format(
      "which differs from it at {} of {} sites, with lengths up to {:.4g} times as long or as "
      "short, and {:.4g} at half of them{}",
      report.changed, outcome.sites, internal::elementary::exp(report.greatest),
      internal::elementary::exp(report.median),
      outcome.intolerable ? ", so that it is another one altogether" : "");
}

std::string low_text(const mesh_outcome& outcome) {
  const delivered_report& report = *outcome.delivered;
  const std::string worst = report.worst_angle_wanted < 180
                                ? fmt::format(", the worst {:.2f}", report.worst_angle_wanted)
                                : "";
  return fmt::format("as the metric given measures them {} triangles are below {} degrees{}",
                     report.low_wanted.size(), outcome.one_metric->angle_bound, worst);
}

// Returns a clause that two given vertices are a rounding apart; nothing where none are.
std::string rounding_text(const std::optional<close_vertices>& close, std::size_t first) {
  if (!close) return "";
  return fmt::format("; vertices {} and {} at {} are {} apart, which leaves no room for triangles",
                     close->a + first, close->b + first, place_text(close->at),
                     format_number(close->length));
}

// Returns the text of how the run ended in the metric as given.
std::string text_as_given(const constant_metric_report& report, std::size_t first) {
  return text_of(report.as_given, first) + rounding_text(report.too_close, first);
}

// Explains a mesh made without demands on angles and sizes, in a given metric that is the same
// everywhere. Another metric cannot help; the obstacle is a limit, which is named, or details of
// the domain far smaller than the rest, near which the shortest edge is.
std::string text_without_demands(const mesh_outcome& outcome, std::size_t first) {
  const auto [length, at] = shortest_edge(outcome.result);
  return fmt::format(
      "no mesh was found that meets the demands ({}), though the metric is the same everywhere; "
      "the one delivered is made with no demands on angles and sizes, and its shortest edge, "
      "{:.4g} long, is at {}: {}",
      text_as_given(*outcome.one_metric, first), length, place_text(at),
      text_of(outcome.ended, first));
}

std::string one_metric_text(const mesh_outcome& outcome, std::size_t first) {
  const constant_metric_report& report = *outcome.one_metric;
  if (report.is_as_given || !outcome.delivered) return text_without_demands(outcome, first);
  return fmt::format(
      "stars cannot agree in the metric given ({}); they agree in one metric for "
      "all{}, {}: {}; {}",
      text_as_given(report, first),
      report.has_demands ? "" : ", with no demands on angles and sizes", distances_text(outcome),
      text_of(outcome.ended, first), low_text(outcome));
}

// Returns the distance in all its digits, since it is suggested as a tolerance: rounded, it might
// be less.
std::string intolerable_text(const mesh_outcome& outcome, std::size_t first) {
  using measure = intolerable_distance::measure;
  const intolerable_distance& distance = *outcome.intolerable;
  const std::string ended = text_of(outcome.ended, first);
  if (distance.of == measure::density)
    return fmt::format(
        "{}, in a metric that is another one than the one wanted: on the whole it is {:.4g} times "
        "as {}; a metric tolerance of {} is kept by this mesh, and a smaller size or a gradation "
        "brings the two nearer",
        ended, distance.found,
        outcome.delivered &&
                outcome.delivered->complexity_delivered < outcome.delivered->complexity_wanted
            ? "thin"
            : "dense",
        number_text(distance.greatest));
  if (distance.of == measure::median)
    return fmt::format(
        "{}, in a metric that is another one than the one wanted: half of the sites find some "
        "length more than {:.4g} times as long or as short; a metric tolerance of {} is kept by "
        "this mesh, and a smaller size or a gradation brings the two nearer",
        ended, internal::elementary::exp(distance.found), number_text(distance.greatest));
  const std::string found = format_number(distance.found);
  const std::string beyond =
      " from the one wanted, where " + format_number(distance.allowed) +
      " is tolerated; a metric tolerance of " + number_text(distance.found) +
      " is kept by this mesh, and a smaller size or a gradation brings the two nearer";
  if (outcome.delivered) return ended + ", in a metric delivered that is " + found + beyond;
  return "stars agree in a metric " + found + beyond + "; in the one wanted: " + ended;
}

}  // namespace

std::string ending_text(const refinement_ending& ended, int first_number) {
  return text_of(ended, static_cast<std::size_t>(first_number));
}

std::string ending_text(const mesh_outcome& outcome, int first_number) {
  const auto first = static_cast<std::size_t>(first_number);
  if (outcome.one_metric) return one_metric_text(outcome, first);
  if (outcome.intolerable) return intolerable_text(outcome, first);
  std::string ended = text_of(outcome.ended, first);
  if (outcome.complete && outcome.delivered && outcome.delivered->changed > 0)
    return ended + ", in the metric delivered";
  if (!outcome.stopped_in_one_metric)
    return ended + rounding_text(internal::too_close_in(outcome), first);
  return text_of(*outcome.stopped_in_one_metric, first) +
         ", in one metric for all; before that, in the metric given, " + ended;
}

}  // namespace asterism
