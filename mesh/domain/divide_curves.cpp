// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/divide_curves.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/core/number_text.hpp"
#include "asterism/mesh/domain/curve_path.hpp"
#include "asterism/mesh/domain/curve_separation.hpp"
#include "asterism/mesh/domain/curve_values.hpp"
#include "asterism/mesh/domain/domain_values.hpp"
#include "asterism/mesh/domain/message_names.hpp"
#include "asterism/mesh/numerics/arc_length.hpp"
#include "asterism/mesh/numerics/constructions.hpp"
#include "asterism/mesh/numerics/triangle_quality.hpp"

namespace asterism {
using namespace internal;
namespace {

using parameters_of_curves = std::vector<std::vector<double>>;

// Pieces shorter than this part of their curve mean that it cannot be divided.
constexpr double finest_part = 0x1p-22;
constexpr double part_of_chord = 1.0 / 50;

double distance(const point& a, const point& b) { return elementary::hypot(a.x - b.x, a.y - b.y); }

bool is_near_enough(const curve_path& path, const curve_division& wanted, double t0, double t1) {
  if (!path.is_straightforward(t0, t1)) return false;
  const double allowed = wanted.chord_tolerance
                             ? *wanted.chord_tolerance
                             : part_of_chord * distance(path.at(t0), path.at(t1));
  return path.height(t0, t1) <= allowed;
}

// Halves pieces until all are near enough to their chords.
result<std::vector<double>> halved(const domain& d, std::size_t curve, const curve_path& path,
                                   const curve_division& wanted, std::vector<double> start) {
  std::vector<double> done{0};
  std::vector<double> waiting(start.rbegin(), start.rend());  // the next parameter last
  waiting.pop_back();
  while (!waiting.empty()) {
    const double t0 = done.back(), t1 = waiting.back();
    if (is_near_enough(path, wanted, t0, t1)) {
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

// Measures a curve in the metric.
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
  if (wanted.field == nullptr) return found;
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

// Puts new vertices for curve `c` into `d`, its first chord in the place of its segment
// and the others at the end.
void put_chords(domain& d, std::size_t c, const curve_path& path,
                const std::vector<double>& parameters) {
  domain_curve& curve = d.curves[c];
  const segment whole = d.segments[curve.segment];
  // The segment may lead against the curve; its chords do so too.
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
  auto parameters = even_parameters(paths, wanted);
  if (!parameters) return parameters.failure();
  for (std::size_t c = 0; c < paths.size(); ++c) {
    auto finer = halved(d, c, paths[c], wanted, std::move(parameters.value()[c]));
    if (!finer) return finer.failure().as(error_code::invalid_domain);
    parameters.value()[c] = std::move(finer).value();
  }
  const auto apart = separate_curves(d, paths, std::move(parameters).value(), finest_part);
  if (!apart) return apart.failure().as(error_code::invalid_domain);
  return with_chords(d, paths, apart.value());
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
