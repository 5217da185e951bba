// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface/face_meshing.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/metric/interpolated_field.hpp"
#include "asterism/mesh/numerics/scaled_tensor.hpp"
#include "asterism/mesh/pipeline/make_mesh.hpp"
#include "asterism/mesh/pipeline/outcome_text.hpp"
#include "asterism/mesh/surface/border_field.hpp"

namespace asterism::internal {
namespace {

// Returns the loops with a region inside, each with all holes removed. The sign of each loop's area
// distinguishes them, in doubles: the auditor detects a polygon that is no region.
std::vector<domain_polygon> polygons_of_loops(const domain& d, const face_border& border) {
  std::vector<domain_polygon> outer;
  std::vector<std::vector<std::uint32_t>> holes;
  std::vector<std::vector<std::uint32_t>> of_side(border.sides());
  for (std::uint32_t k = 0; k < d.segments.size(); ++k)
    of_side[static_cast<std::size_t>(d.segments[k].marker) - 1].push_back(k);
  std::vector<bool> seen(border.sides());
  for (std::size_t first = 0; first < border.sides(); ++first) {
    std::vector<std::uint32_t> ring;
    double area = 0;
    const point origin = d.vertices[first];
    for (std::size_t side = first; !seen[side]; side = border.next(side)) {
      seen[side] = true;
      for (const std::uint32_t k : of_side[side]) {
        const point &a = d.vertices[d.segments[k].a], &b = d.vertices[d.segments[k].b];
        area += (a.x - origin.x) * (b.y - origin.y) - (a.y - origin.y) * (b.x - origin.x);
        ring.push_back(k);
      }
    }
    if (ring.empty()) continue;
    if (area > 0)
      outer.push_back({std::nullopt, {std::move(ring)}});
    else
      holes.push_back(std::move(ring));
  }
  for (domain_polygon& p : outer) p.rings.insert(p.rings.end(), holes.begin(), holes.end());
  if (outer.empty()) outer.emplace_back();
  return outer;
}

bool has_same_segments(const domain& a, const domain& b) {
  bool same = a.segments.size() == b.segments.size();
  for (std::size_t k = 0; same && k < a.segments.size(); ++k)
    same = a.segments[k].a == b.segments[k].a && a.segments[k].b == b.segments[k].b &&
           !a.segments[k].internal;
  return same;
}

}  // namespace

face_meshing::face_meshing(const surface_chart& chart, const face_border& border,
                           const surface_sizes& sizes, int cells)
    : chart_(&chart), border_(&border), sizes_(sizes), cells_(cells) {
  find_base();
  log_factor_.assign(base_.size(), 0);
  wanted_.assign(base_.size(), 0);
  is_wanted_.assign(base_.size(), 0);
}

// Place of a point in the background: a cell, and the parameters s and t in it.
struct face_meshing::cell_place {
  int i, k;
  double s, t;
};

face_meshing::cell_place face_meshing::place_of(const point& p) const {
  const point low = chart_->low(), high = chart_->high();
  const double x = std::clamp((p.x - low.x) / (high.x - low.x), 0.0, 1.0) * cells_,
               y = std::clamp((p.y - low.y) / (high.y - low.y), 0.0, 1.0) * cells_;
  const int i = std::min(static_cast<int>(x), cells_ - 1),
            k = std::min(static_cast<int>(y), cells_ - 1);
  return {i, k, x - i, y - k};
}

// Finds the density in a direction that equals the mean density along an edge of length 1
// through p: the density for the curvature at p alone can be much too low where it is zero on a
// curve.
double face_meshing::consistent_density(const point& p, const point& direction,
                                        double density) const {
  constexpr int samples = 4, most_halvings = 24;
  const point low = chart_->low(), high = chart_->high();
  double length = 1 / std::sqrt(density);
  for (int n = 0; n < most_halvings; ++n) {
    double mean = 0;
    for (int k = -samples; k <= samples; ++k) {
      const double step = length * k / (2.0 * samples);
      const point q{std::clamp(p.x + step * direction.x, low.x, high.x),
                    std::clamp(p.y + step * direction.y, low.y, high.y)};
      const cell_place at = place_of(q);
      const auto of = [&](int a, int b) {
        const metric_tensor& m = local_[node_number(a, b)];
        return m.m11 * direction.x * direction.x + 2 * m.m12 * direction.x * direction.y +
               m.m22 * direction.y * direction.y;
      };
      mean += ((1 - at.t) * ((1 - at.s) * of(at.i, at.k) + at.s * of(at.i + 1, at.k)) +
               at.t * ((1 - at.s) * of(at.i, at.k + 1) + at.s * of(at.i + 1, at.k + 1))) /
              (2 * samples + 1);
    }
    if (mean * length * length <= 1) break;
    length *= 0.8;
  }
  return 1 / (length * length);
}

void face_meshing::find_base() {
  const point low = chart_->low(), high = chart_->high();
  const double wide = high.x - low.x, tall = high.y - low.y;
  std::vector<surface_chart::local_metric> asked;
  for (int k = 0; k <= cells_; ++k)
    for (int i = 0; i <= cells_; ++i) {
      asked.push_back(chart_->metric_at(node(i, k), sizes_));
      local_.push_back(asked.back().metric);
    }
  for (int k = 0; k <= cells_; ++k)
    for (int i = 0; i <= cells_; ++i) {
      // Limits the size of triangles to that of the patch.
      metric_tensor m{1 / (wide * wide), 0, 1 / (tall * tall)};
      surface_chart::local_metric& at = asked[node_number(i, k)];
      if (at.known) {
        const double least =
            std::max(at.densities[0], at.densities[1]) / (sizes_.aspect * sizes_.aspect);
        const auto& [e, f] = at.directions;
        const double area = e.x * f.y - e.y * f.x;
        const std::array<point, 2> covector = {point{f.y / area, -f.x / area},
                                               point{-e.y / area, e.x / area}};
        for (std::size_t n = 0; n < 2; ++n) {
          const point& d = at.directions[n];
          // Limits the length of an edge to the patch's extent in its direction.
          const double longest = 1 / std::max(std::abs(d.x) / wide, std::abs(d.y) / tall);
          const double start = std::max({at.densities[n], least, 1 / (longest * longest)});
          const double density = consistent_density(node(i, k), d, start);
          m.m11 += density * covector[n].x * covector[n].x;
          m.m12 += density * covector[n].x * covector[n].y;
          m.m22 += density * covector[n].y * covector[n].y;
        }
      }
      base_.push_back(m);
    }
}

point face_meshing::node(int i, int k) const {
  const point low = chart_->low(), high = chart_->high();
  return {i == cells_ ? high.x : low.x + (high.x - low.x) * i / cells_,
          k == cells_ ? high.y : low.y + (high.y - low.y) * k / cells_};
}

metric_tensor face_meshing::metric_at(const point& p) const {
  const cell_place at = place_of(p);
  metric_tensor m{0, 0, 0};
  double log_factor = 0;
  for (const int b : {0, 1})
    for (const int a : {0, 1}) {
      const std::size_t n = node_number(at.i + a, at.k + b);
      const double share = (a == 0 ? 1 - at.s : at.s) * (b == 0 ? 1 - at.t : at.t);
      m.m11 += share * base_[n].m11;
      m.m12 += share * base_[n].m12;
      m.m22 += share * base_[n].m22;
      log_factor += share * log_factor_[n];
    }
  return times(m, elementary::exp(log_factor));
}

void face_meshing::add_everywhere(double log_factor) {
  for (double& f : log_factor_) f += log_factor;
}

void face_meshing::want(const std::array<point, 3>& triangle, double log_factor) {
  const point low = chart_->low(), high = chart_->high();
  const auto range = [&](double a, double b, double c, double from, double to) {
    const double width = (to - from) / cells_;
    const double first = (std::min({a, b, c}) - from) / width,
                 last = (std::max({a, b, c}) - from) / width;
    return std::pair{std::clamp(static_cast<int>(std::floor(first)), 0, cells_),
                     std::clamp(static_cast<int>(std::ceil(last)), 0, cells_)};
  };
  const auto [i0, i1] = range(triangle[0].x, triangle[1].x, triangle[2].x, low.x, high.x);
  const auto [k0, k1] = range(triangle[0].y, triangle[1].y, triangle[2].y, low.y, high.y);
  for (int k = k0; k <= k1; ++k)
    for (int i = i0; i <= i1; ++i) {
      const auto n = static_cast<std::size_t>(k * (cells_ + 1) + i);
      if (is_wanted_[n] == 0 || log_factor > wanted_[n]) wanted_[n] = log_factor;
      is_wanted_[n] = 1;
    }
}

void face_meshing::apply() {
  for (std::size_t n = 0; n < wanted_.size(); ++n) {
    if (is_wanted_[n] != 0) log_factor_[n] += wanted_[n];
    wanted_[n] = 0, is_wanted_[n] = 0;
  }
}

mesh face_meshing::background() const {
  mesh m;
  for (int k = 0; k <= cells_; ++k)
    for (int i = 0; i <= cells_; ++i) {
      const auto n = static_cast<std::size_t>(k * (cells_ + 1) + i);
      m.sites.push_back({node(i, k), times(base_[n], elementary::exp(log_factor_[n]))});
    }
  const auto row = static_cast<vertex_index>(cells_ + 1);
  for (vertex_index k = 0; k + 1 < row; ++k)
    for (vertex_index i = 0; i + 1 < row; ++i) {
      const vertex_index a = k * row + i;
      m.triangles.push_back({a, a + 1, a + row + 1});
      m.triangles.push_back({a, a + row + 1, a + row});
    }
  return m;
}

double face_meshing::expected_vertices() const {
  const point low = chart_->low(), high = chart_->high();
  double sum = 0;
  for (std::size_t n = 0; n < base_.size(); ++n) {
    const metric_tensor& m = base_[n];
    sum +=
        std::sqrt(std::max(0.0, m.m11 * m.m22 - m.m12 * m.m12)) * elementary::exp(log_factor_[n]);
  }
  return 2 / std::numbers::sqrt3 * sum / static_cast<double>(base_.size()) * (high.x - low.x) *
         (high.y - low.y);
}

void face_meshing::free_around(const std::vector<unsigned char>& marked) {
  std::map<std::pair<vertex_index, vertex_index>, vertex_index> opposite;
  const auto edge = [](const triangle& t, std::size_t k) {
    return std::pair{t[k], t[(k + 1) % 3]};
  };
  for (const triangle& t : plane_.triangles)
    for (std::size_t k = 0; k < 3; ++k) opposite[edge(t, k)] = t[(k + 2) % 3];
  is_freed_.assign(plane_.sites.size(), 0);
  for (std::size_t n = 0; n < marked.size(); ++n) {
    if (marked[n] == 0) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [from, to] = edge(plane_.triangles[n], k);
      is_freed_[from] = 1;
      if (const auto beside = opposite.find({to, from}); beside != opposite.end())
        is_freed_[beside->second] = 1;
    }
  }
}

std::vector<face_meshing::placed> face_meshing::vertices_on_sides(const side_places& places,
                                                                  bool keep) const {
  std::vector<placed> all;
  for (std::size_t side = 0; side < border_->sides(); ++side)
    for (const double place : places.at[side])
      all.push_back({border_->at(side, place), on_side{static_cast<int>(side), place}});
  const auto corners = static_cast<vertex_index>(border_->sides());
  for (vertex_index v = corners; keep && v < plane_.sites.size(); ++v) {
    const auto on = side_of(v);
    if (on && !places.is_common[static_cast<std::size_t>(on->side)] && is_freed_[v] == 0)
      all.push_back({plane_.sites[v].position, on});
  }
  std::stable_sort(all.begin(), all.end(), [](const placed& a, const placed& b) {
    if (a.on->side != b.on->side) return a.on->side < b.on->side;
    return a.on->place < b.on->place;
  });
  return all;
}

std::vector<face_meshing::placed> face_meshing::vertices_inside() const {
  std::vector<placed> all;
  const auto corners = static_cast<vertex_index>(border_->sides());
  for (vertex_index v = corners; v < plane_.sites.size(); ++v)
    if (is_freed_[v] == 0 && !side_of(v)) all.push_back({plane_.sites[v].position, std::nullopt});
  return all;
}

result<std::string> face_meshing::make(const side_places& places,
                                       const surface_mesh_options& options) {
  is_freed_.resize(plane_.sites.size(), 0);
  const bool keep = (keeps_ || demand_ != plane_demand::angles) && !plane_.sites.empty();
  auto made = make_once(places, keep, options);
  if (keep && (!made || !made.value().empty())) made = make_once(places, false, options);
  is_freed_.clear();
  return made;
}

// Returns the domain of the plane mesh. Its vertices are the corners, then those on the sides in
// the order of `on_sides`; its segments run around the border, with the side's number, from 1, as
// marker.
domain face_meshing::polygons(const std::vector<placed>& on_sides) const {
  domain d;
  const std::size_t sides = border_->sides();
  for (std::size_t k = 0; k < sides; ++k) d.vertices.push_back(border_->corner(k));
  std::vector<std::vector<vertex_index>> along(sides);
  for (const placed& one : on_sides) {
    along[static_cast<std::size_t>(one.on->side)].push_back(
        static_cast<vertex_index>(d.vertices.size()));
    d.vertices.push_back(one.at);
  }
  for (std::size_t side = 0; side < sides; ++side) {
    if (!border_->runs_around(side)) std::reverse(along[side].begin(), along[side].end());
    const int marker = static_cast<int>(side) + 1;
    auto from = static_cast<vertex_index>(side);
    for (const vertex_index v : along[side]) {
      d.segments.push_back({from, v, marker});
      from = v;
    }
    d.segments.push_back({from, static_cast<vertex_index>(border_->next(side)), marker});
  }
  if (border_->is_trimmed()) d.polygons = polygons_of_loops(d, *border_);
  return d;
}

bool face_meshing::is_simple(const side_places& places) const {
  if (!border_->is_trimmed()) return true;
  const domain d = polygons(vertices_on_sides(places, false));
  const auto shape = check_domain(d);
  return shape && has_same_segments(shape.value(), d);
}

result<std::string> face_meshing::make_once(const side_places& places, bool keep,
                                            const surface_mesh_options& options) {
  const std::vector<placed> on_sides = vertices_on_sides(places, keep);
  domain d = polygons(on_sides);
  const std::size_t given = d.vertices.size();
  if (keep)
    for (const placed& one : vertices_inside()) d.vertices.push_back(one.at);
  auto shape = check_domain(d);
  if (border_->is_trimmed() && (!shape || !has_same_segments(shape.value(), d)))
    return error{
        "its loops do not enclose a region on their left: an outer loop must run "
        "counter-clockwise in (u, v), the loop of a hole clockwise, and none may meet "
        "itself or another" +
            (shape ? std::string() : " (" + shape.failure().message + ")"),
        error_code::invalid_input};
  if (!shape) return shape.failure();
  const mesh wanted = background();
  const auto field = make_interpolated_field(wanted);
  mesh_options how;
  how.angle_bound = demand_ == plane_demand::angles ? options.angle_bound : 0;
  how.limit_size = demand_ != plane_demand::stars || !keep;
  how.max_sites = options.most_sites;
  how.stop = options.stop;
  const border_field graded(*field, d);
  const metric_field& asked =
      border_->is_trimmed() ? static_cast<const metric_field&>(graded) : *field;
  auto made = make_mesh(shape.value(), asked, how);
  if (!made) return made.failure();
  plane_ = std::move(made.value().result);
  made_with_ = demand_;
  // Counts corners and points on sides alone as given: vertices kept from the mesh before are
  // ordinary sites.
  plane_.given = static_cast<vertex_index>(given);
  given_on_.clear();
  for (const placed& one : on_sides) given_on_.push_back(*one.on);
  find_splits(shape.value());
  is_freed_.assign(plane_.sites.size(), 0);
  if (made.value().complete) return std::string();
  return ending_text(made.value());
}

void face_meshing::find_splits(const domain& shape) {
  split_on_.clear();
  if (!border_->is_trimmed()) return;
  const auto corners = static_cast<vertex_index>(border_->sides());
  for (const boundary_edge& e : plane_.boundary) {
    if (e.a < plane_.given || e.segment >= shape.segments.size()) continue;
    const segment& whole = shape.segments[e.segment];
    const point &a = shape.vertices[whole.a], &b = shape.vertices[whole.b],
                p = plane_.sites[e.a].position;
    const double x = b.x - a.x, y = b.y - a.y;
    const double share = ((p.x - a.x) * x + (p.y - a.y) * y) / (x * x + y * y);
    const double from = whole.a < corners ? 0 : given_on_[whole.a - corners].place,
                 to = whole.b < corners ? 1 : given_on_[whole.b - corners].place;
    split_on_[e.a] = on_side{whole.marker - 1, from + share * (to - from)};
  }
}

std::vector<border_place> face_meshing::border_places() const {
  std::vector<border_place> all;
  if (!border_->is_trimmed()) return all;
  for (std::uint32_t k = 0; k < border_->sides(); ++k) all.push_back({k, 0});
  for (const on_side& on : given_on_)
    all.push_back({static_cast<std::uint32_t>(on.side), on.place});
  return all;
}

std::optional<on_side> face_meshing::side_of(vertex_index site) const {
  const std::size_t corners = border_->sides();
  if (site < corners) return std::nullopt;
  if (site < corners + given_on_.size()) return given_on_[site - corners];
  if (border_->is_trimmed()) {
    const auto found = split_on_.find(site);
    return found == split_on_.end() ? std::nullopt : std::optional(found->second);
  }
  const point low = chart_->low(), high = chart_->high(), p = plane_.sites[site].position;
  const double x = (p.x - low.x) / (high.x - low.x), y = (p.y - low.y) / (high.y - low.y);
  if (p.y == low.y) return on_side{0, x};
  if (p.x == high.x) return on_side{1, y};
  if (p.y == high.y) return on_side{2, x};
  if (p.x == low.x) return on_side{3, y};
  return std::nullopt;
}

}  // namespace asterism::internal
