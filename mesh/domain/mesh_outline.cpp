// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/mesh_outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/core/number_text.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/domain/curve_path.hpp"
#include "asterism/mesh/domain/outline_curves.hpp"
#include "asterism/mesh/domain/outline_points.hpp"
#include "asterism/mesh/numerics/metric_length.hpp"
#include "asterism/mesh/search/triangle_sides.hpp"

namespace asterism {
using namespace internal;
namespace {

constexpr vertex_index none = std::numeric_limits<vertex_index>::max();
// Greatest distance from a line at which vertices count as on the line, as a part of the largest
// coordinate.
constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();

// A run of boundary edges between two kept vertices: the vertices, and the edges after them.
struct run {
  std::vector<vertex_index> vertices, edges;
};

// True if two domains have the same regions, with areas that differ at most by the share `part`,
// the area `swept` and the rounding error of the whole area.
bool are_near(const region_sizes& wanted, const region_sizes& found, double part, double swept) {
  constexpr double rounding_of_sums = 1e-12;
  double whole = 0;
  for (const auto& [region, size] : wanted) whole += size;
  return std::equal(
      wanted.begin(), wanted.end(), found.begin(), found.end(), [&](const auto& w, const auto& f) {
        return w.first == f.first &&
               std::abs(f.second - w.second) <= part * w.second + swept + rounding_of_sums * whole;
      });
}

class outliner {
 public:
  outliner(const mesh& m, const mesh_marks& marks, const outline_options& options)
      : mesh_(m),
        sides_(m.regions.empty() ? mesh() : m),
        at_(m.sites.size()),
        kept_(m.sites.size(), 0),
        smooth_(m.sites.size(), 0),
        options_(options) {
    for (vertex_index e = 0; e < m.boundary.size(); ++e)
      for (const vertex_index v : {m.boundary[e].a, m.boundary[e].b}) at_[v].push_back(e);
    for (const point& p : positions())
      greatest_ = std::max({greatest_, std::abs(p.x), std::abs(p.y)});
    find_smooth(marks);
    choose(marks);
    find_runs();
  }

  std::optional<mesh_outline> outline(bool simplify_curves) const;
  double greatest() const { return greatest_; }

 private:
  std::vector<point> positions() const {
    std::vector<point> all;
    for (const site& s : mesh_.sites) all.push_back(s.position);
    return all;
  }
  const point& where(vertex_index v) const { return mesh_.sites[v].position; }
  void find_smooth(const mesh_marks& marks);
  void choose(const mesh_marks& marks);
  double turn(vertex_index v) const;
  bool turns(vertex_index v) const;
  bool stands_out(vertex_index v) const;
  bool is_corner(vertex_index v) const;
  void find_runs();
  run follow(vertex_index from, vertex_index edge, std::vector<char>& used) const;
  double distance(vertex_index v, vertex_index a, vertex_index b) const;
  double farthest(const run& r, std::size_t i, std::size_t j) const;
  bool goes_forward(const run& r, std::size_t i, std::size_t j) const;
  bool is_polygon(const run& r) const;
  double allowed_off(vertex_index a, vertex_index b) const;
  bool may_be_piece(const run& r, std::size_t i, std::size_t j, bool simplify_curves) const;
  bool divides_regions(const run& r) const;
  std::vector<std::size_t> pieces(const run& r, bool simplify_curves) const;
  std::vector<point> between(const run& r, std::size_t i, std::size_t j) const;
  double width(const run& r, std::size_t i, std::size_t j,
               const std::array<point, 2>& control) const;
  void add_curve(const run& r, std::size_t i, std::size_t j,
                 const std::vector<vertex_index>& number, domain& shape) const;

  const mesh& mesh_;
  triangle_sides sides_;                       // of no triangle where there are no regions
  std::vector<std::vector<vertex_index>> at_;  // boundary edges at each vertex
  std::vector<char> kept_, smooth_;
  std::vector<std::array<vertex_index, 2>> required_;  // edges, sorted
  std::vector<run> runs_;
  outline_options options_;
  double greatest_ = 0;
};

// Marks the vertices through which a cubic may lead.
void outliner::find_smooth(const mesh_marks& marks) {
  for (vertex_index v = 0; v < smooth_.size(); ++v)
    smooth_[v] = at_[v].size() == 2 && !turns(v) &&
                 mesh_.boundary[at_[v][0]].internal == mesh_.boundary[at_[v][1]].internal;
  std::vector<vertex_index> standing_out;
  for (vertex_index v = 0; v < smooth_.size(); ++v)
    if (smooth_[v] != 0 && stands_out(v)) standing_out.push_back(v);
  for (const vertex_index v : standing_out) smooth_[v] = 0;
  for (const vertex_index v : marks.corners) smooth_[v] = 0;
  for (const auto& e : marks.required_edges)
    required_.push_back({std::min(e[0], e[1]), std::max(e[0], e[1])});
  std::sort(required_.begin(), required_.end());
}

void outliner::choose(const mesh_marks& marks) {
  for (const auto* list : {&marks.corners, &marks.required_vertices})
    for (const vertex_index v : *list) kept_[v] = 1;
  for (const auto& e : marks.required_edges)
    for (const vertex_index v : e) kept_[v] = 1;
  for (vertex_index v = 0; v < kept_.size(); ++v)
    if (!at_[v].empty() && is_corner(v)) kept_[v] = 1;
}

bool outliner::is_corner(vertex_index v) const {
  if (at_[v].size() != 2) return true;
  const boundary_edge &e = mesh_.boundary[at_[v][0]], &f = mesh_.boundary[at_[v][1]];
  return e.marker != f.marker || e.internal != f.internal || turns(v);
}

// Returns the absolute angle, in radians, between the two edges at a vertex.
double outliner::turn(vertex_index v) const {
  const boundary_edge &e = mesh_.boundary[at_[v][0]], &f = mesh_.boundary[at_[v][1]];
  const vertex_index p = e.a == v ? e.b : e.a, q = f.a == v ? f.b : f.a;
  const double x = where(v).x - where(p).x, y = where(v).y - where(p).y,
               u = where(q).x - where(v).x, w = where(q).y - where(v).y;
  return elementary::atan2(std::abs(x * w - y * u), x * u + y * w);
}

// True if the two edges at a vertex turn by more than the corner angle.
bool outliner::turns(vertex_index v) const {
  return turn(v) * 180 / std::numbers::pi > options_.corner_angle;
}

// True if the boundary turns more than four times as much at a smooth vertex as at either of its
// two neighbours, both smooth: there one curve meets another. Where an arc meets a straight side
// the polygon turns by half of what it turns along the arc, so a factor of four allows for chords
// of unequal length. A cubic with the other curve's direction at its end would turn by the whole
// angle near it, and be divided there into chords much shorter than edges of the metric.
bool outliner::stands_out(vertex_index v) const {
  constexpr double factor = 4;
  double most = 0;
  for (const vertex_index e : at_[v]) {
    const vertex_index w = mesh_.boundary[e].a == v ? mesh_.boundary[e].b : mesh_.boundary[e].a;
    if (smooth_[w] == 0) return false;
    most = std::max(most, turn(w));
  }
  return turn(v) > factor * most;
}

// Follows edges from a vertex to the next kept vertex.
run outliner::follow(vertex_index from, vertex_index edge, std::vector<char>& used) const {
  run r;
  vertex_index v = from;
  while (edge != none) {
    used[edge] = 1;
    r.vertices.push_back(v);
    r.edges.push_back(edge);
    const boundary_edge& e = mesh_.boundary[edge];
    v = e.a == v ? e.b : e.a;
    if (kept_[v] != 0) break;
    const vertex_index other = at_[v][0] == edge ? at_[v][1] : at_[v][0];
    edge = used[other] != 0 ? none : other;
  }
  r.vertices.push_back(v);
  return r;
}

void outliner::find_runs() {
  std::vector<char> used(mesh_.boundary.size(), 0);
  const auto start_at = [&](vertex_index v) {
    for (const vertex_index e : at_[v])
      // Follows runs in the direction of the first edge; edges that enter v are followed from their
      // other end.
      if (used[e] == 0 && mesh_.boundary[e].a == v) runs_.push_back(follow(v, e, used));
  };
  for (vertex_index v = 0; v < kept_.size(); ++v)
    if (kept_[v] != 0) start_at(v);
  // Follows internal runs that are listed against their direction from both ends.
  for (vertex_index v = 0; v < kept_.size(); ++v)
    if (kept_[v] != 0)
      for (const vertex_index e : at_[v])
        if (used[e] == 0) runs_.push_back(follow(v, e, used));
  // Keeps three vertices of closed curves without any kept one, a third of the way apart.
  for (vertex_index e = 0; e < used.size(); ++e) {
    if (used[e] != 0) continue;
    std::vector<char> tried = used;
    const vertex_index from = mesh_.boundary[e].a;
    const run whole = follow(from, e, tried);
    const std::size_t n = whole.edges.size();
    for (const std::size_t k : {std::size_t{0}, n / 3, 2 * n / 3}) kept_[whole.vertices[k]] = 1;
    for (const std::size_t k : {std::size_t{0}, n / 3, 2 * n / 3})
      runs_.push_back(follow(whole.vertices[k], whole.edges[k], used));
  }
}

double outliner::distance(vertex_index v, vertex_index a, vertex_index b) const {
  const double x = where(b).x - where(a).x, y = where(b).y - where(a).y;
  const double u = where(v).x - where(a).x, w = where(v).y - where(a).y;
  const double s = std::clamp((u * x + w * y) / (x * x + y * y), 0.0, 1.0);
  return elementary::hypot(u - s * x, w - s * y);
}

double outliner::farthest(const run& r, std::size_t i, std::size_t j) const {
  double most = 0;
  for (std::size_t k = i + 1; k < j; ++k)
    most = std::max(most, distance(r.vertices[k], r.vertices[i], r.vertices[j]));
  return most;
}

// True if every edge between two vertices of the run leads forward along the line between them.
bool outliner::goes_forward(const run& r, std::size_t i, std::size_t j) const {
  const point &a = where(r.vertices[i]), &b = where(r.vertices[j]);
  for (std::size_t k = i; k < j; ++k) {
    const point &p = where(r.vertices[k]), &q = where(r.vertices[k + 1]);
    if (!((q.x - p.x) * (b.x - a.x) + (q.y - p.y) * (b.y - a.y) > 0)) return false;
  }
  return true;
}

// True if the run is of a side that stays a polygon. All edges of a run have the same marker.
bool outliner::is_polygon(const run& r) const {
  return std::find(options_.polygons.begin(), options_.polygons.end(),
                   mesh_.boundary[r.edges.front()].marker) != options_.polygons.end();
}

// Returns the greatest distance allowed between dropped vertices and the piece between two kept
// ones.
double outliner::allowed_off(vertex_index a, vertex_index b) const {
  if (options_.largest_distance) return *options_.largest_distance - rounding * greatest_;
  const point d{where(b).x - where(a).x, where(b).y - where(a).y};
  const double piece = elementary::hypot(d.x, d.y);
  const point across{-d.y / piece, d.x / piece};
  const double per_length = std::max(plain_length(mesh_.sites[a].metric, across),
                                     plain_length(mesh_.sites[b].metric, across));
  return std::min(options_.part_of_length * piece, options_.part_of_size / per_length);
}

// True if all vertices of the run between two of its vertices may be dropped.
bool outliner::may_be_piece(const run& r, std::size_t i, std::size_t j,
                            bool simplify_curves) const {
  constexpr std::size_t most_dropped = 256;
  const vertex_index a = r.vertices[i], b = r.vertices[j];
  if (a == b) return false;
  const double off = farthest(r, i, j);
  if (off <= rounding * greatest_) return true;
  if (!simplify_curves || j - i > most_dropped) return false;
  const point d{where(b).x - where(a).x, where(b).y - where(a).y};
  const double measured =
      (plain_length(mesh_.sites[a].metric, d) + plain_length(mesh_.sites[b].metric, d)) / 2;
  return measured <= 1 && off <= allowed_off(a, b) && goes_forward(r, i, j);
}

// Returns the places of the vertices of the run between two of its vertices.
std::vector<point> outliner::between(const run& r, std::size_t i, std::size_t j) const {
  std::vector<point> places;
  for (std::size_t k = i + 1; k < j; ++k) places.push_back(where(r.vertices[k]));
  return places;
}

// Returns the width of a strip along the line between two vertices of the run that contains the run
// between them, the cubic, and any polygon with vertices on the cubic. It bounds the distance of
// these from each other.
double outliner::width(const run& r, std::size_t i, std::size_t j,
                       const std::array<point, 2>& control) const {
  const point &a = where(r.vertices[i]), &b = where(r.vertices[j]);
  const point d{b.x - a.x, b.y - a.y};
  const double piece = elementary::hypot(d.x, d.y);
  double low = 0, high = 0;
  const auto include = [&](const point& p, double part) {
    const double off = part * (d.x * (p.y - a.y) - d.y * (p.x - a.x)) / piece;
    low = std::min(low, off);
    high = std::max(high, off);
  };
  for (std::size_t k = i + 1; k < j; ++k) include(where(r.vertices[k]), 1);
  // Uses that the Bernstein weights of a cubic's two inner control points sum to at most 3/4.
  for (const point& p : control) include(p, 0.75);
  return high - low;
}

// Draws the cubic of a piece of the outer boundary, the last segment of `shape`, if there is one
// that is near enough to the polygon.
void outliner::add_curve(const run& r, std::size_t i, std::size_t j,
                         const std::vector<vertex_index>& number, domain& shape) const {
  const vertex_index a = r.vertices[i], b = r.vertices[j];
  if (mesh_.boundary[r.edges[i]].internal || is_polygon(r)) return;
  if (std::binary_search(required_.begin(), required_.end(),
                         std::array{std::min(a, b), std::max(a, b)}))
    return;
  const auto control =
      outline_curves(mesh_, at_, smooth_).control(r.vertices.data() + i, j - i + 1);
  if (!control) return;
  domain_curve cubic;
  cubic.kind = curve_kind::cubic;
  cubic.control = *control;
  cubic.vertices = {number[a], number[b]};
  cubic.parameters = {0, 1};
  cubic.segment = static_cast<std::uint32_t>(shape.segments.size() - 1);
  const curve_path path(cubic, where(a), where(b));
  if (!path.is_straightforward(0, 1) || path.height(0, 1) <= rounding * greatest_) return;
  if (options_.largest_distance && !(width(r, i, j, *control) <= allowed_off(a, b))) return;
  shape.curves.push_back(std::move(cubic));
}

// True if the run is between two regions. Its first edge decides for all of them: where other
// regions meet, three segments end in a vertex, and a run begins.
bool outliner::divides_regions(const run& r) const {
  const boundary_edge& e = mesh_.boundary[r.edges.front()];
  return e.internal && sides_.divides_regions(mesh_.regions, e.a, e.b);
}

// Returns the indices in the run of the vertices that stay. Between regions a vertex is dropped
// only if, up to rounding, it is on the line between its neighbours that stay: another change would
// move area from one region to the other.
std::vector<std::size_t> outliner::pieces(const run& r, bool simplify_curves) const {
  simplify_curves = simplify_curves && !divides_regions(r);
  const std::size_t last = r.vertices.size() - 1;
  // Tries the whole run of a polygon at once, as vertices that its partner keeps end the run: going
  // along it the other way, a part of it may be no piece.
  if (may_be_piece(r, 0, last, simplify_curves && is_polygon(r))) return {0, last};
  // Largest number of edges in a straight piece: each longer piece that is tried is tested in full.
  // So a longer straight run keeps one vertex after each such number of edges.
  constexpr std::size_t most_straight = 4096;
  std::vector<std::size_t> stay{0};
  for (std::size_t i = 0; i < last;) {
    std::size_t j = i + 1;
    while (j < last && j - i < most_straight && may_be_piece(r, i, j + 1, simplify_curves)) ++j;
    stay.push_back(i = j);
  }
  return stay;
}

std::optional<mesh_outline> outliner::outline(bool simplify_curves) const {
  mesh_outline made;
  std::vector<char> stays = kept_;
  std::vector<std::vector<std::size_t>> all;
  for (const run& r : runs_) {
    all.push_back(pieces(r, simplify_curves));
    for (const std::size_t k : all.back()) stays[r.vertices[k]] = 1;
  }
  std::vector<vertex_index> number(stays.size(), none);
  bool are_first = true;
  for (vertex_index v = 0; v < stays.size(); ++v) {
    if (stays[v] == 0) continue;
    number[v] = static_cast<vertex_index>(made.shape.vertices.size());
    are_first = are_first && number[v] == v;
    made.shape.vertices.push_back(where(v));
  }
  std::vector<vertex_index> segment_of(mesh_.boundary.size(), none);
  // Bounds the area between a piece and its curve by that of a strip: length times distance.
  double swept = 0;
  for (std::size_t i = 0; i < runs_.size(); ++i)
    for (std::size_t k = 0; k + 1 < all[i].size(); ++k) {
      const run& r = runs_[i];
      const std::size_t begin = all[i][k], end = all[i][k + 1];
      const boundary_edge& e = mesh_.boundary[r.edges[begin]];
      for (std::size_t j = begin; j < end; ++j)
        segment_of[r.edges[j]] = static_cast<vertex_index>(made.shape.segments.size());
      made.shape.segments.push_back(
          {number[r.vertices[begin]], number[r.vertices[end]], e.marker, e.internal});
      made.former.between.push_back(between(r, begin, end));
      const double off = farthest(r, begin, end);
      made.greatest_distance = std::max(made.greatest_distance, off);
      swept += off * elementary::hypot(where(r.vertices[end]).x - where(r.vertices[begin]).x,
                                       where(r.vertices[end]).y - where(r.vertices[begin]).y);
      if (simplify_curves) add_curve(r, begin, end, number, made.shape);
    }
  drop_curves_in_the_way(made.shape);
  if (!add_hole_points(made.shape)) return std::nullopt;
  add_region_points(mesh_, made.shape);
  const auto checked = check_domain(made.shape);
  if (!checked) return std::nullopt;
  if (!are_near(sizes_of_regions(mesh_), enclosed_sizes(checked.value()),
                simplify_curves ? 0.01 : 1e-9, swept))
    return std::nullopt;
  const auto same = [](const segment& s, const segment& t) {
    return s.a == t.a && s.b == t.b && s.marker == t.marker && s.internal == t.internal;
  };
  if (are_first && checked.value().vertices == made.shape.vertices &&
      std::equal(made.shape.segments.begin(), made.shape.segments.end(),
                 checked.value().segments.begin(), checked.value().segments.end(), same))
    made.segment_of_edge = std::move(segment_of);
  made.former.allowed = options_.largest_distance;
  made.part_of_size = options_.part_of_size;
  if (!bring_to_order(made.shape, checked.value(), made.former.between)) return std::nullopt;
  made.shape = checked.value();
  for (std::size_t v = 0; v < at_.size(); ++v) {
    if (at_[v].empty()) continue;
    ++made.boundary_vertices;
    made.kept += stays[v] != 0 ? 1 : 0;
  }
  return made;
}

}  // namespace

result<mesh_outline> outline_of_mesh(const mesh& m, const mesh_marks& marks,
                                     const outline_options& options) {
  if (!(options.corner_angle > 0 && options.corner_angle <= 180))
    return error{"the corner angle must be above 0 and at most 180 degrees",
                 error_code::bad_option};
  for (const double part : {options.part_of_length, options.part_of_size})
    if (!(part > 0 && part <= 0.125))
      return error{"the part of a size that the boundary may be away is above 0 and at most 1/8",
                   error_code::bad_option};
  const auto is_there = [&](vertex_index v) { return v < m.sites.size(); };
  for (const auto* list : {&marks.corners, &marks.required_vertices})
    if (!std::all_of(list->begin(), list->end(), is_there))
      return error{"a mark names a vertex that does not exist", error_code::invalid_mesh};
  for (const auto& e : marks.required_edges)
    if (!is_there(e[0]) || !is_there(e[1]))
      return error{"a mark names a vertex that does not exist", error_code::invalid_mesh};
  const outliner found(m, marks, options);
  // Refuses distances below rounding errors: split points are rounded, and so are the points that
  // they are computed from.
  const double least = 0x1p-40 * found.greatest();
  if (options.largest_distance && !(*options.largest_distance >= least))
    return error{"a distance of the old and the new boundary of " +
                     number_text(*options.largest_distance) + " is less than roundings make of " +
                     "coordinates as large: at least " + number_text(least) + " is wanted",
                 error_code::bad_option};
  for (const bool simplify_curves : {true, false})
    if (auto outline = found.outline(simplify_curves)) return *std::move(outline);
  mesh_outline whole;
  whole.keeps_all = true;
  whole.former.allowed = options.largest_distance;
  whole.former.between.resize(m.boundary.size());
  return whole;
}

}  // namespace asterism
