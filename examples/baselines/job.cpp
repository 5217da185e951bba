// SPDX-License-Identifier: MIT
#include "job.hpp"

#include <algorithm>
#include <asterism/mesh/io/medit.hpp>
#include <asterism/mesh/metric/interpolated_field.hpp>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <numeric>

namespace baselines {
namespace {

using asterism::error;
using asterism::result;
using asterism::vertex_index;

// Holds the border's points, with its segments cut into parts, and for each point the segment that
// begins there.
struct border {
  std::vector<point> points;
  std::vector<std::size_t> segment;
  std::vector<index> given;  // number of the domain's vertex there, or none
};

result<job> read_job(int count, const char* const* words, const std::set<std::string>& own) {
  std::map<std::string, std::string> options;
  if (count < 2) return error{"usage: DOMAIN --metric SPEC --size H -o OUT.mesh"};
  for (int i = 2; i < count; i += 2) {
    const std::string name = words[i];
    if (name != "--metric" && name != "--size" && name != "-o" && !own.contains(name))
      return error{"no option " + name};
    if (i + 1 == count) return error{name + " wants a value"};
    options[name] = words[i + 1];
  }
  const double size = options.contains("--size") ? std::atof(options["--size"].c_str()) : 1;
  if (!(size > 0) || !options.contains("--metric") || !options.contains("-o"))
    return error{"wanted: --metric SPEC, a positive --size and -o OUT.mesh"};
  const auto read = asterism::load_domain(words[1]);
  if (!read) return read.failure();
  auto checked = asterism::check_domain(read.value());
  if (!checked) return checked.failure();
  auto field = make_field(options["--metric"], checked.value().box(), size);
  if (!field) return field.failure();
  return job{std::move(checked).value(), std::make_unique<metric>(std::move(field).value()),
             options["-o"], options};
}

result<border> cut_border(const job& wanted) {
  const asterism::domain& domain = wanted.domain;
  std::map<vertex_index, std::size_t> from;
  for (std::size_t s = 0; s < domain.segments.size(); ++s)
    if (domain.segments[s].internal || !from.emplace(domain.segments[s].a, s).second)
      return error{"the domain is not one polygon: it has segments inside, or touches itself"};
  border made;
  std::size_t used = 0, at = 0;
  do {
    const asterism::segment& s = domain.segments[at];
    const point &a = domain.vertices[s.a], &b = domain.vertices[s.b];
    made.points.push_back(a);
    made.given.push_back(s.a);
    for (const point& p : equal_pieces(*wanted.field, a, b, 4096)) {
      made.points.push_back(p);
      made.given.push_back(none);
    }
    made.segment.resize(made.points.size(), at);
    at = from.at(s.b);
    ++used;
  } while (at != 0);
  if (used != domain.segments.size()) return error{"the domain is not one polygon: it has holes"};
  return made;
}

// Triangulates the border, then inserts the domain's other vertices.
result<metric_mesh> start(const job& wanted, border& frame) {
  auto net = triangulation::of_polygon(frame.points);
  if (!net) return error{"the border crosses itself, cut in pieces"};
  metric_mesh mesh{std::move(*net), {}, wanted.field.get()};
  std::vector<bool> seen(wanted.domain.vertices.size(), false);
  for (const index v : frame.given)
    if (v != none) seen[v] = true;
  for (index v = 0; v < seen.size(); ++v) {
    if (seen[v]) continue;
    const point& p = wanted.domain.vertices[v];
    if (mesh.net.insert(p, mesh.net.cell_of(p)) == none) return error{"an inner vertex is lost"};
    frame.given.push_back(v);
  }
  mesh.measure_new();
  mesh.fixed = mesh.net.points().size();
  return mesh;
}

// Lists the domain's vertices first, in their order, then the others.
asterism::mesh result_of(const job& wanted, const border& frame, const metric_mesh& made) {
  const index own = wanted.domain.vertices.size(), border_size = frame.points.size();
  asterism::mesh out;
  out.given = static_cast<vertex_index>(own);
  out.sites.resize(own);
  std::vector<vertex_index> number(made.net.points().size());
  for (index v = 0; v < number.size(); ++v) {
    if (made.net.removed(v)) continue;
    const index place =
        v < frame.given.size() && frame.given[v] != none ? frame.given[v] : out.sites.size();
    if (place == out.sites.size()) out.sites.emplace_back();
    out.sites[place] = {made.net.points()[v], made.tensor[v]};
    number[v] = static_cast<vertex_index>(place);
  }
  for (const triangle& t : made.net.triangles())
    if (t.alive())
      out.triangles.push_back({number[t.corner[0]], number[t.corner[1]], number[t.corner[2]]});
  for (index i = 0; i < border_size; ++i) {
    const std::size_t s = frame.segment[i];
    out.boundary.push_back({number[i], number[(i + 1) % border_size], static_cast<vertex_index>(s),
                            wanted.domain.segments[s].marker, false});
  }
  return out;
}

result<std::string> make(int count, const char* const* words, const std::set<std::string>& own,
                         const method& method_of_program) {
  const auto read = read_job(count, words, own);
  if (!read) return read.failure();
  const job& wanted = read.value();
  auto frame = cut_border(wanted);
  if (!frame) return frame.failure();
  auto begun = start(wanted, frame.value());
  if (!begun) return begun.failure();
  metric_mesh& mesh = begun.value();
  const auto said = method_of_program(mesh, wanted.options);
  if (!said) return said;
  if (const auto& failure = wanted.field->failure()) return *failure;
  const asterism::mesh out = result_of(wanted, frame.value(), mesh);
  const auto written = asterism::write_mesh(wanted.output, out);
  if (!written) return written.failure();
  return std::to_string(out.sites.size()) + " vertices, " + std::to_string(out.triangles.size()) +
         " triangles: " + said.value();
}

}  // namespace

result<std::unique_ptr<asterism::metric_field>> make_field(const std::string& specification,
                                                           const asterism::bounding_box& box,
                                                           double size) {
  if (!specification.ends_with(".mesh"))
    return asterism::make_metric_field(specification, box, size);
  const auto given = asterism::read_medit(specification);
  if (!given) return given.failure();
  return asterism::make_interpolated_field(given.value(), size);
}

metric_tensor metric::at(const point& p) const {
  const auto answer = field_->at(p);
  if (answer) return answer.value();
  if (!failure_) failure_ = answer.failure();
  return {1, 0, 1};
}

double length(const metric_tensor& m, double dx, double dy) {
  return std::sqrt(std::max(0.0, m.m11 * dx * dx + 2 * m.m12 * dx * dy + m.m22 * dy * dy));
}

metric_tensor mean(const std::vector<metric_tensor>& tensors) {
  metric_tensor sum;
  const double n = static_cast<double>(tensors.size());
  for (const metric_tensor& m : tensors)
    sum = {sum.m11 + m.m11 / n, sum.m12 + m.m12 / n, sum.m22 + m.m22 / n};
  return sum;
}

std::vector<point> equal_pieces(const metric& field, const point& a, const point& b, int parts) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  std::vector<double> until = {0};  // the length from a to the end of each part
  for (int i = 0; i < parts; ++i) {
    const double t = (i + 0.5) / parts;
    until.push_back(until.back() + length(field.at({a.x + t * dx, a.y + t * dy}), dx, dy) / parts);
  }
  const int pieces = std::max(1, static_cast<int>(std::lround(until.back())));
  std::vector<point> made;
  for (int i = 1; i < pieces; ++i) {
    const double wanted = until.back() * i / pieces;
    const auto after = std::upper_bound(until.begin(), until.end(), wanted);
    const double part = static_cast<double>(after - until.begin()) - 1;
    const double t = (part + (wanted - after[-1]) / (after[0] - after[-1])) / parts;
    made.push_back({a.x + t * dx, a.y + t * dy});
  }
  return made;
}

double metric_mesh::length(index v, index w) const {
  const point &p = net.points()[v], &q = net.points()[w];
  return (baselines::length(tensor[v], q.x - p.x, q.y - p.y) +
          baselines::length(tensor[w], q.x - p.x, q.y - p.y)) /
         2;
}

void metric_mesh::measure_new() {
  while (tensor.size() < net.points().size())
    tensor.push_back(field->at(net.points()[tensor.size()]));
}

int run(int count, const char* const* words, const std::set<std::string>& own,
        const method& method_of_program) {
  const auto said = make(count, words, own, method_of_program);
  if (said)
    std::cout << said.value() << '\n';
  else
    std::cerr << words[0] << ": " << said.failure().message << '\n';
  return said ? 0 : 2;
}

}  // namespace baselines
