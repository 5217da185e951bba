// SPDX-License-Identifier: MIT
#include "asterism/mesh/draw/picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/draw/cairo_functions.hpp"
#include "asterism/mesh/draw/canvas.hpp"
#include "asterism/mesh/draw/fine_triangles.hpp"
#include "asterism/mesh/draw/picture_colours.hpp"
#include "asterism/mesh/draw/picture_legend.hpp"
#include "asterism/mesh/numerics/metric_angle.hpp"

namespace asterism {
using namespace internal;

namespace {

constexpr colour thin_ink{0.30, 0.33, 0.38};
constexpr colour bold_ink{0.07, 0.09, 0.13};
constexpr colour disagreeing_fill{0.84, 0.15, 0.16, 0.75};
constexpr colour low_angle_fill{0.98, 0.80, 0.38, 0.65};
constexpr colour given_fill{0.12, 0.42, 0.72};
constexpr colour mark_line{0.75, 0.0, 0.13};
constexpr colour ellipse_line{0.10, 0.55, 0.45, 0.9};
constexpr colour ellipse_fill{0.10, 0.55, 0.45, 0.13};

// Maps the plane, whose y points upwards, to the page, whose y points downwards.
struct page {
  bounding_box box;
  double scale = 1, margin = 0, foot = 0;  // the foot has the legend
  int width = 0, height = 0;

  point at(const point& p) const {
    return {margin + (p.x - box.low.x) * scale, margin + (box.high.y - p.y) * scale};
  }
  // Returns the unit of lengths on the page: a thousandth of its width.
  double unit() const { return width / 1000.0; }
  double line_width() const { return 0.9 * unit(); }
};

// Returns the page without its foot and height.
result<page> lay_out(const mesh& m, const picture_options& options) {
  if (auto wrong = fault_of_width(options.width)) return *wrong;
  if (m.sites.empty()) return error{"there is nothing to draw: the mesh has no sites"};
  page p;
  p.box = {m.sites[0].position, m.sites[0].position};
  for (const site& s : m.sites) {
    const auto [x, y] = s.position;
    if (!std::isfinite(x) || !std::isfinite(y)) return error{"a site is not finite"};
    p.box.include(s.position);
  }
  p.width = options.width;
  p.margin = 0.03 * options.width;
  p.scale = (options.width - 2 * p.margin) / (p.box.high.x - p.box.low.x);
  if (!(p.scale > 0) || !std::isfinite(p.scale) ||
      !std::isfinite((p.box.high.y - p.box.low.y) * p.scale))
    return error{"the mesh has no width to draw, or too large a one"};
  return p;
}

// Gives the page its height, with room for the legend.
std::optional<error> add_foot(page& p, const picture_legend& legend) {
  p.foot = legend_height(legend, p.width);
  const double height = (p.box.high.y - p.box.low.y) * p.scale + 2 * p.margin + p.foot;
  if (height > largest_extent) return error{"the picture would be more than 20000 high"};
  p.height = std::max(1, static_cast<int>(std::ceil(height)));
  return std::nullopt;
}

void trace(canvas& on, const page& p, const mesh& m, const triangle& t) {
  on.begin_path();
  for (const vertex_index v : t) on.line_to(p.at(m.sites[v].position));
  on.close_path();
}

void fill_triangles(canvas& on, const page& p, const mesh& m, double angle_bound,
                    const std::vector<colour>& colours, bool hard_edges) {
  on.use(low_angle_fill);
  if (colours.empty())
    for (const triangle& t : m.triangles)
      if (smallest_angle(m, t) < angle_bound) trace(on, p, m, t);
  on.fill();
  on.set_hard_edges(hard_edges);
  for (std::size_t t = 0; t < colours.size(); ++t) {
    trace(on, p, m, m.triangles[t]);
    on.use(colours[t]);
    on.fill();
  }
  on.set_hard_edges(false);
  on.use(disagreeing_fill);
  // Draws the triangles one by one: triangles may overlap, and their colours are mixed there.
  for (const triangle& t : m.disagreeing) {
    trace(on, p, m, t);
    on.fill();
  }
}

// Draws each edge once, so that lines shared by two triangles are no darker than others; edges of
// hidden triangles alone are left out.
void stroke_edges(canvas& on, const page& p, const mesh& m, const std::vector<bool>& hidden) {
  std::set<std::pair<vertex_index, vertex_index>> edges;
  const auto add = [&](const triangle& t) {
    for (std::size_t i = 0; i < 3; ++i) edges.insert(std::minmax(t[i], t[(i + 1) % 3]));
  };
  for (std::size_t t = 0; t < m.triangles.size(); ++t)
    if (hidden.empty() || !hidden[t]) add(m.triangles[t]);
  for (const triangle& t : m.disagreeing) add(t);
  on.use(thin_ink);
  on.set_line_width(p.line_width());
  for (const auto& [a, b] : edges) {
    on.move_to(p.at(m.sites[a].position));
    on.line_to(p.at(m.sites[b].position));
  }
  on.stroke();
}

void stroke_boundary(canvas& on, const page& p, const mesh& m, const std::vector<colour>& colours) {
  on.use(bold_ink);
  const double wider = colours.empty() ? 1 : 1.8;
  for (const bool internal : {false, true}) {
    on.set_line_width((internal ? 1.8 : 2.6) * wider * p.unit());
    for (std::size_t i = 0; i < m.boundary.size(); ++i) {
      const boundary_edge& e = m.boundary[i];
      if (e.internal != internal) continue;
      on.move_to(p.at(m.sites[e.a].position));
      on.line_to(p.at(m.sites[e.b].position));
      if (colours.empty()) continue;
      on.use(colours[i]);
      on.stroke();
    }
    on.stroke();
  }
}

// Semi-axes of the unit ball, longest first, and the direction of the longest.
struct ellipse {
  double longest = 0, shortest = 0, angle = 0;
};

std::optional<ellipse> unit_ball(const metric_tensor& m) {
  const double mean = (m.m11 + m.m22) / 2;
  const double spread = elementary::hypot((m.m11 - m.m22) / 2, m.m12);
  const double greatest = mean + spread;
  // Computes the lesser eigenvalue from the determinant: mean - spread loses all digits of very
  // flat ellipses.
  const double least = (m.m11 * m.m22 - m.m12 * m.m12) / greatest;
  if (!(least > 0) || !std::isfinite(greatest)) return {};
  const double angle = 0.5 * elementary::atan2(2 * m.m12, m.m11 - m.m22) + std::numbers::pi / 2;
  return ellipse{1 / std::sqrt(least), 1 / std::sqrt(greatest), angle};
}

// Chooses sites at least `distance` apart on the page, those of lower index first.
std::vector<vertex_index> sites_apart(const page& p, const mesh& m, double distance) {
  const auto square_of = [&](double length) { return static_cast<int>(length / distance); };
  // Looks for chosen sites in a grid of squares of side `distance`: each holds a few at most, and
  // sites beyond the adjacent squares are not too near.
  std::map<std::pair<int, int>, std::vector<point>> chosen_in;
  const auto is_free = [&](const point& at) {
    const int column = square_of(at.x), row = square_of(at.y);
    for (int i = column - 1; i <= column + 1; ++i)
      for (int j = row - 1; j <= row + 1; ++j) {
        const auto found = chosen_in.find({i, j});
        if (found == chosen_in.end()) continue;
        for (const point& q : found->second)
          if (elementary::hypot(q.x - at.x, q.y - at.y) < distance) return false;
      }
    return true;
  };
  std::vector<vertex_index> chosen;
  for (std::size_t v = 0; v < m.sites.size(); ++v) {
    const point at = p.at(m.sites[v].position);
    if (!is_free(at)) continue;
    chosen_in[{square_of(at.x), square_of(at.y)}].push_back(at);
    chosen.push_back(static_cast<vertex_index>(v));
  }
  return chosen;
}

void draw_ellipse(canvas& on, const point& centre, const ellipse& e, double scale,
                  double line_width) {
  // Draws at least a hairline: a semi-axis of 0 would be an error to cairo.
  on.add_ellipse(centre, e.longest * scale, std::max(e.shortest * scale, 0.25 * line_width),
                 -e.angle);
  on.use(ellipse_fill);
  on.fill_and_keep();
  on.use(ellipse_line);
  on.set_line_width(line_width);
  on.stroke();
}

void draw_ellipses(canvas& on, const page& p, const mesh& m) {
  const double distance = p.width / 18.0;
  std::vector<std::pair<vertex_index, ellipse>> balls;
  double longest = 0;
  for (const vertex_index v : sites_apart(p, m, distance)) {
    const auto ball = unit_ball(m.sites[v].metric);
    if (!ball) continue;
    balls.emplace_back(v, *ball);
    longest = std::max(longest, ball->longest);
  }
  for (const auto& [v, ball] : balls)
    draw_ellipse(on, p.at(m.sites[v].position), ball, 0.48 * distance / longest, 1.5 * p.unit());
}

void draw_dot(canvas& on, const point& at, double radius, const colour& c) {
  on.add_circle(at, radius);
  on.use(c);
  on.fill();
}

// Returns the length on the page of the shortest edge at each site; infinite for sites of no
// triangle.
std::vector<double> shortest_edges(const page& p, const mesh& m) {
  std::vector<double> shortest(m.sites.size(), std::numeric_limits<double>::infinity());
  for (const triangle& t : m.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const vertex_index a = t[i], b = t[(i + 1) % 3];
      const point from = p.at(m.sites[a].position), to = p.at(m.sites[b].position);
      const double length = elementary::hypot(to.x - from.x, to.y - from.y);
      shortest[a] = std::min(shortest[a], length);
      shortest[b] = std::min(shortest[b], length);
    }
  return shortest;
}

// Given sites are larger, blue, with a rim in the colour of the paper. Where the mesh is fine dots
// are smaller, or they would hide its triangles.
void draw_sites(canvas& on, const page& p, const mesh& m) {
  const std::vector<double> room = shortest_edges(p, m);
  const auto radius = [&](std::size_t v) { return std::min(2.8 * p.unit(), 0.13 * room[v]); };
  for (std::size_t v = m.given; v < m.sites.size(); ++v)
    draw_dot(on, p.at(m.sites[v].position), radius(v), bold_ink);
  for (std::size_t v = 0; v < m.given && v < m.sites.size(); ++v) {
    draw_dot(on, p.at(m.sites[v].position), 2.3 * radius(v), paper);
    draw_dot(on, p.at(m.sites[v].position), 1.8 * radius(v), given_fill);
  }
}

// True if the sites are drawn as dots. On a larger mesh dots would look like dirt, and show no more
// than its lines do; a mesh without triangles may have vertices that are on no line.
bool has_dots(const mesh& m, const picture_options& options) {
  constexpr std::size_t most_dotted = 300;
  return options.sites && (m.triangles.empty() || m.sites.size() <= most_dotted);
}

// Draws rings, with a rim in the colour of the paper; leaves out places that are not on the
// page.
void draw_marks(canvas& on, const page& p, const std::vector<point>& marks) {
  for (const point& mark : marks) {
    const point at = p.at(mark);
    if (!(at.x >= 0 && at.x <= p.width && at.y >= 0 && at.y <= p.height)) continue;
    for (const auto& [ink, width] : {std::pair{paper, 4.0}, std::pair{mark_line, 2.0}}) {
      on.add_circle(at, 8 * p.unit());
      on.use(ink);
      on.set_line_width(width * p.unit());
      on.stroke();
    }
  }
}

}  // namespace

std::optional<error> missing_for_pictures() {
  const auto library = load_cairo();
  if (library.ok()) return std::nullopt;
  return library.failure();
}

result<std::string> draw_picture(const mesh& m, picture_format format,
                                 const picture_options& options) {
  auto layout = lay_out(m, options);
  if (!layout.ok()) return layout.failure();
  page& p = layout.value();
  std::vector<bool> hidden = hidden_by_lines(m, p.line_width() / p.scale);
  const bool is_fine = are_most(m, hidden);
  if (!is_fine) hidden.clear();
  picture_options shown = options;
  // Chooses colours where lines hide most triangles: without colours these would be a grey area.
  if (is_fine && shown.colours == picture_by::nothing) shown.colours = most_telling(m);
  const auto coloured = colours_of(m, shown);
  if (!coloured) return coloured.failure();
  const auto& colours = coloured.value();
  if (auto wrong = add_foot(p, colours.legend)) return *wrong;
  return paint_file(format, p.width, p.height, [&](canvas& on) {
    on.use(paper);
    on.paint();
    fill_triangles(on, p, m, options.angle_bound, colours.triangles, is_fine);
    stroke_edges(on, p, m, hidden);
    stroke_boundary(on, p, m, colours.boundary);
    if (options.ellipses) draw_ellipses(on, p, m);
    if (has_dots(m, options)) draw_sites(on, p, m);
    draw_marks(on, p, options.marks);
    draw_legend(on, colours.legend, {p.margin, p.height - p.foot}, p.width);
  });
}

}  // namespace asterism
