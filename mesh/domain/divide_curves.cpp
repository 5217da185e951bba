// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/divide_curves.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/core/number_text.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/domain/curve_path.hpp"
#include "asterism/mesh/domain/curve_separation.hpp"
#include "asterism/mesh/domain/curve_values.hpp"
#include "asterism/mesh/domain/domain_values.hpp"
#include "asterism/mesh/domain/message_names.hpp"
#include "asterism/mesh/domain/point_algebra.hpp"
#include "asterism/mesh/numerics/arc_length.hpp"
#include "asterism/mesh/numerics/constructions.hpp"
#include "asterism/mesh/numerics/triangle_quality.hpp"

namespace asterism {
using namespace internal;
namespace {

using parameters_of_curves = std::vector<std::vector<double>>;

// Least share of a curve that a piece may be: shorter pieces mean that the curve cannot be divided.
constexpr double finest_part = 0x1p-22;
constexpr double part_of_chord = 1.0 / 50;
// Largest distance of a curve from its chord, as a part of the size across. For a formula it equals
// the part of the chord's length that is allowed without a metric, so that it demands no more where
// the metric is isotropic. A metric on a mesh is mostly a solution's, and the boundary's distance
// adds to the solution's error: with 1/100 the drag of a cylinder is off by less than 3e-4 at 3,000
// vertices (docs/results/adaptation.md).
constexpr double part_of_size = 1.0 / 50, part_of_size_on_mesh = 1.0 / 100;
// Least metric length of a piece that is halved for the size across. Where pieces are much shorter
// than edges of the metric, triangles at them have low angles in it: with half a unit all around,
// meshes by local changes were not certified in a metric near the one wanted.
constexpr double least_halved = 0.8;

// True if the piece has at most the least metric length that is halved for the size across.
result<bool> is_short(const curve_path& path, const metric_field& field, double t0, double t1) {
  const point from = path.at(t0), to = path.at(t1);
  const auto metric = field.at(path.at((t0 + t1) / 2));
  if (!metric) return metric.failure();
  return !(squared_length(metric.value(), minus(to, from)) > least_halved * least_halved);
}

// True if the piece is near enough to its chord for the size that the metric wants across, or too
// short to be halved.
result<bool> suits_size_across(const curve_path& path, const curve_division& wanted, double t0,
                               double t1) {
  const metric_field& field = *wanted.field;
  const auto short_already = is_short(path, field, t0, t1);
  if (!short_already || short_already.value()) return short_already;
  const point from = path.at(t0), to = path.at(t1), middle = path.at((t0 + t1) / 2);
  const auto metric = field.at(middle);
  if (!metric) return metric.failure();
  const point chord = minus(to, from);
  const double length = elementary::hypot(chord.x, chord.y);
  const point across{-chord.y / length, chord.x / length};
  const double size = 1 / std::sqrt(squared_length(metric.value(), across));
  const bool is_on_mesh = field.background() != nullptr;
  const double usual = is_on_mesh ? part_of_size_on_mesh : part_of_size;
  return path.height(t0, t1) <= wanted.part_of_size.value_or(usual) * size;
}

result<bool> is_near_enough(const curve_path& path, const curve_division& wanted, double t0,
                            double t1) {
  if (!path.is_straightforward(t0, t1)) return false;
  // Does not halve cubics through a polygon for their turn alone: they are a guess, and their
  // pieces turn as much as the polygon however short they are. If they were halved for their turn,
  // they would become shorter in each round of an adaptation loop.
  if (wanted.field != nullptr && !wanted.is_even) {
    const auto short_already = is_short(path, *wanted.field, t0, t1);
    if (!short_already || short_already.value()) return short_already;
  }
  const double height = path.height(t0, t1);
  if (wanted.chord_tolerance) return height <= *wanted.chord_tolerance;
  const double part = std::max(part_of_chord, wanted.part_of_size.value_or(0));
  if (!(height <= part * distance_between(path.at(t0), path.at(t1)))) return false;
  return wanted.field == nullptr ? true : suits_size_across(path, wanted, t0, t1);
}

// Halves pieces until all are near enough to their chords, or there are more than `most`.
result<std::vector<double>> halved(const domain& d, std::size_t curve, const curve_path& path,
                                   const curve_division& wanted, std::vector<double> start,
                                   std::size_t most) {
  std::vector<double> done{0};
  std::vector<double> waiting(start.rbegin(), start.rend());  // the next parameter last
  waiting.pop_back();
  while (!waiting.empty() && done.size() <= most) {
    const double t0 = done.back(), t1 = waiting.back();
    const auto is_near = is_near_enough(path, wanted, t0, t1);
    if (!is_near) return is_near.failure();
    if (is_near.value()) {
      done.push_back(t1);
      waiting.pop_back();
      continue;
    }
    if (t1 - t0 < finest_part) {
      const domain_names names(d);
      return error{names.at_curve(curve) + names.curve(curve) +
                   (wanted.chord_tolerance
                        ? " is not within the chord tolerance of " +
                              number_text(*wanted.chord_tolerance) + " of four million chords"
                        : " turns too sharply near " + coordinates(path.at(t0)))};
    }
    waiting.push_back((t0 + t1) / 2);
  }
  return done;
}

// Halves the pieces of all curves. Ignores the size across where it would take more pieces than
// allowed.
result<parameters_of_curves> all_halved(const domain& d, const std::vector<curve_path>& paths,
                                        const curve_division& wanted,
                                        const parameters_of_curves& start) {
  constexpr std::size_t any = std::numeric_limits<std::size_t>::max();
  const bool is_limited = wanted.field != nullptr && !wanted.chord_tolerance;
  parameters_of_curves found;
  std::size_t left = is_limited ? wanted.most_chords : any;
  for (std::size_t c = 0; c < paths.size(); ++c) {
    auto finer = halved(d, c, paths[c], wanted, start[c], left);
    if (!finer) return finer.failure();
    const std::size_t pieces = finer.value().size() - 1;
    if (is_limited && pieces >= left) {
      curve_division plain = wanted;
      plain.field = nullptr;
      return all_halved(d, paths, plain, start);
    }
    if (is_limited) left -= pieces;
    found.push_back(std::move(finer).value());
  }
  return found;
}

// Measures the metric length along a curve.
result<arc_length> measured(const curve_path& path, const metric_field& field, double longest) {
  constexpr double fine = 1.0 / 16;  // of the longest: as the fill of a domain measures segments
  return arc_length::measure(
      [&](double t) -> result<double> {
        const auto metric = field.at(path.at(t));
        if (!metric) return metric.failure();
        return std::sqrt(squared_length(metric.value(), path.derivative(t)));
      },
      fine* longest);
}

// Returns parameters at even distances in the metric, each curve by itself; {0, 1} where no metric
// is given, or it asks for too many chords.
result<parameters_of_curves> even_parameters(const std::vector<curve_path>& paths,
                                             const curve_division& wanted) {
  parameters_of_curves found(paths.size(), {0, 1});
  if (wanted.field == nullptr || !wanted.is_even) return found;
  std::vector<arc_length> lengths;
  double chords = 0;
  for (const curve_path& path : paths) {
    auto one = measured(path, *wanted.field, longest_subsegment_of_fill);
    if (!one) return one.failure();
    chords += one.value().total() / longest_subsegment_of_fill;
    lengths.push_back(std::move(one).value());
  }
  if (!(chords <= static_cast<double>(wanted.most_chords))) return found;
  for (std::size_t c = 0; c < paths.size(); ++c) {
    const double total = lengths[c].total();
    const auto pieces =
        static_cast<std::size_t>(std::max(1.0, std::ceil(total / longest_subsegment_of_fill)));
    std::vector<double> parameters{0};
    for (std::size_t i = 1; i < pieces; ++i) {
      const double t =
          lengths[c].parameter_at(total * static_cast<double>(i) / static_cast<double>(pieces));
      if (t > parameters.back() && t < 1) parameters.push_back(t);
    }
    parameters.push_back(1);
    found[c] = std::move(parameters);
  }
  return found;
}

// Adds the vertices of curve `c` to `d`, with its first chord in the place of its segment and the
// other chords at the end.
void put_chords(domain& d, std::size_t c, const curve_path& path,
                const std::vector<double>& parameters) {
  domain_curve& curve = d.curves[c];
  const segment whole = d.segments[curve.segment];
  // Reverses the chords where the segment leads against the curve.
  const bool is_reversed = whole.a != curve.vertices.front();
  const auto& lines = d.origin.curve_lines;
  const std::size_t line = c < lines.size() ? lines[c] : 0;
  const bool knows_lines = line > 0 && d.origin.vertex_file == d.origin.file;
  std::vector<vertex_index> chain{curve.vertices.front()};
  for (std::size_t i = 1; i < parameters.size(); ++i) {
    if (i + 1 == parameters.size()) {
      chain.push_back(curve.vertices.back());
    } else {
      chain.push_back(static_cast<vertex_index>(d.vertices.size()));
      if (knows_lines && d.origin.vertex_lines.size() == d.vertices.size())
        d.origin.vertex_lines.push_back(line);
      d.vertices.push_back(path.at(parameters[i]));
    }
    segment chord = whole;
    chord.a = chain[i - 1];
    chord.b = chain[i];
    if (is_reversed) std::swap(chord.a, chord.b);
    if (i == 1) {
      d.segments[curve.segment] = chord;
      continue;
    }
    if (line > 0 && d.origin.segment_lines.size() == d.segments.size())
      d.origin.segment_lines.push_back(line);
    d.segments.push_back(chord);
  }
  curve.vertices = std::move(chain);
  curve.parameters = parameters;
}

std::vector<curve_path> paths_of(const domain& d) {
  std::vector<curve_path> paths;
  for (const domain_curve& c : d.curves)
    paths.emplace_back(c, d.vertices[c.vertices.front()], d.vertices[c.vertices.back()]);
  return paths;
}

domain with_chords(domain d, const std::vector<curve_path>& paths,
                   const parameters_of_curves& parameters) {
  for (std::size_t c = 0; c < paths.size(); ++c) put_chords(d, c, paths[c], parameters[c]);
  return d;
}

// Removes chords, and the vertices between them, from a domain: each curve leads from its first
// vertex to its last again, in the place of its first chord.
domain without_chords(const domain& d) {
  std::map<std::pair<vertex_index, vertex_index>, std::size_t> curve_of;
  std::vector<char> is_between(d.vertices.size(), 0);
  for (std::size_t c = 0; c < d.curves.size(); ++c) {
    const std::vector<vertex_index>& chain = d.curves[c].vertices;
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      curve_of[std::minmax(chain[i], chain[i + 1])] = c;
      if (i > 0) is_between[chain[i]] = 1;
    }
  }
  domain whole = d;
  whole.origin = {};
  whole.vertices.clear();
  whole.segments.clear();
  std::vector<vertex_index> number(d.vertices.size(), 0);
  for (vertex_index v = 0; v < d.vertices.size(); ++v) {
    number[v] = static_cast<vertex_index>(whole.vertices.size());
    if (is_between[v] == 0) whole.vertices.push_back(d.vertices[v]);
  }
  std::vector<char> is_placed(d.curves.size(), 0);
  for (segment s : d.segments) {
    const auto found = curve_of.find(std::minmax(s.a, s.b));
    if (found != curve_of.end()) {
      const std::size_t c = found->second;
      if (std::exchange(is_placed[c], 1) != 0) continue;
      domain_curve& curve = whole.curves[c];
      const vertex_index first = curve.vertices.front(), last = curve.vertices.back();
      const auto at = std::find(curve.vertices.begin(), curve.vertices.end(), s.a);
      const bool is_forward = at + 1 != curve.vertices.end() && *(at + 1) == s.b;
      s.a = is_forward ? first : last;
      s.b = is_forward ? last : first;
      curve.segment = static_cast<std::uint32_t>(whole.segments.size());
    }
    s.a = number[s.a];
    s.b = number[s.b];
    whole.segments.push_back(s);
  }
  for (domain_curve& c : whole.curves) {
    c.vertices = {number[c.vertices.front()], number[c.vertices.back()]};
    c.parameters = {0, 1};
  }
  return whole;
}

bool is_division(const std::vector<double>& parameters) {
  return parameters.size() >= 2 && parameters.front() == 0 && parameters.back() == 1 &&
         std::is_sorted(parameters.begin(), parameters.end(), std::less_equal<>());
}

}  // namespace

result<domain> divide_curves(const domain& d, const curve_division& wanted) {
  if (d.curves.empty()) return d;
  if (auto failed = check_domain_values(d))
    return std::move(*failed).as(error_code::invalid_domain);
  if (auto failed = check_curve_values(d)) return std::move(*failed).as(error_code::invalid_domain);
  const std::vector<curve_path> paths = paths_of(d);
  const auto even = even_parameters(paths, wanted);
  if (!even) return even.failure();
  auto parameters = all_halved(d, paths, wanted, even.value());
  if (!parameters) return parameters.failure().as(error_code::invalid_domain);
  const auto apart = separate_curves(d, paths, std::move(parameters).value(), finest_part);
  if (!apart) return apart.failure().as(error_code::invalid_domain);
  return with_chords(d, paths, apart.value());
}

result<domain> divide_curves_anew(const domain& d, const curve_division& wanted) {
  if (d.curves.empty()) return d;
  const auto divided = divide_curves(without_chords(d), wanted);
  return divided ? check_domain(divided.value()) : divided;
}

result<domain> divide_curves_at(const domain& d,
                                const std::vector<std::vector<double>>& parameters) {
  if (auto failed = check_curve_values(d)) return std::move(*failed).as(error_code::invalid_domain);
  if (parameters.size() != d.curves.size() ||
      !std::all_of(parameters.begin(), parameters.end(), is_division))
    return error{domain_names(d).at_start() + "the domain has " + std::to_string(d.curves.size()) +
                     " curves, which are to be divided otherwise",
                 error_code::invalid_domain};
  return with_chords(d, paths_of(d), parameters);
}

}  // namespace asterism
