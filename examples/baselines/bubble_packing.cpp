// SPDX-License-Identifier: MIT
//
// Meshes by packing elliptic bubbles, as Shimada, Yamada and Itoh do: first on vertices, then on
// segments, then inside, where forces between bubbles move them and bubbles are added and removed
// until they are evenly packed; their centres are triangulated at the end.
//
// Source: Shimada, Yamada, Itoh, "Anisotropic triangulation of parametric surfaces via close
// packing of ellipsoids", International Journal of Computational Geometry and Applications 10(4),
// 2000, as chapter 2 of the thesis describes it. README.md says what is left out.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "job.hpp"

namespace {

using baselines::index;
using baselines::metric_mesh;
using baselines::metric_tensor;
using baselines::none;
using baselines::point;

// Distances are in units of the sum of two radii: bubbles touch at distance 1.
constexpr double reach = 1.5;  // no force beyond this distance
// Reach of the lists of neighbours, which are made anew for each packing.
constexpr double wide_reach = 2.2;
// 0.7 of critical damping: six neighbours act as a spring of about 3.
constexpr double damping = 2.4;
constexpr double time_step = 0.3;  // a twelfth of the period of that spring
constexpr int steps_a_packing = 20;
constexpr int most_packings = 40;
constexpr double still = 0.01;  // the speed of the fastest bubble when the packing has settled
// Six neighbours that touch have overlaps of 6 in all. One neighbour more or less is tolerated.
constexpr double crowded = 8, sparse = 4.5;

// Returns the cubic that is 0 at 1 and at 1.5, and 9/8 with slope 0 at 0: it pushes below 1 and
// pulls above.
double force(double w) { return w < reach ? ((1.25 * w - 2.375) * w) * w + 1.125 : 0; }

// A bubble that is not on the border, or a trial place of it within a time step.
struct motion {
  double x = 0, y = 0, vx = 0, vy = 0;
  motion moved(const motion& rate, double by) const {
    return {x + by * rate.x, y + by * rate.y, vx + by * rate.vx, vy + by * rate.vy};
  }
};

class packing {
 public:
  explicit packing(metric_mesh& mesh) : mesh_(mesh), held_(mesh.fixed) {
    for (index v = 0; v < held_; ++v) {
      const point& p = mesh.net.points()[v];
      bubbles_.push_back({p.x, p.y});
    }
    tensor_ = mesh.tensor;
  }

  std::string pack() {
    bubbles_.reserve(1000);
    place_first();
    double speed = 0;
    std::size_t changed = 1;
    int packings = 0;
    for (; packings < most_packings && (changed > 0 || speed > still); ++packings) {
      find_neighbours();
      changed = packings % 2 == 1 || packings + 5 > most_packings ? 0 : change_population();
      if (changed > 0) find_neighbours();
      for (int i = 0; i < steps_a_packing; ++i) speed = step();
      drop_escaped();
    }
    const bool settled = speed <= still;
    triangulate();
    return settled ? "the bubbles rest" : "the bubbles still move";
  }

 private:
  static metric_tensor at(const baselines::metric& field, const motion& b) {
    return field.at({b.x, b.y});
  }

  double distance(index i, index j) const {
    const double dx = bubbles_[i].x - bubbles_[j].x, dy = bubbles_[i].y - bubbles_[j].y;
    return (baselines::length(tensor_[i], dx, dy) + baselines::length(tensor_[j], dx, dy)) / 2;
  }

  void add(double x, double y) {
    bubbles_.push_back({x, y});
    tensor_.push_back(mesh_.field->at({x, y}));
  }

  // Quarters the domain's box until a cell's size in the metric is at most a bubble's share of a
  // packing.
  void place_first() {
    const auto& points = mesh_.net.points();
    double left = points[0].x, right = left, low = points[0].y, high = low;
    for (index v = 0; v < held_; ++v) {
      left = std::min(left, points[v].x), right = std::max(right, points[v].x);
      low = std::min(low, points[v].y), high = std::max(high, points[v].y);
    }
    place_in(left, low, right - left, high - low, 0);
  }

  void place_in(double x, double y, double width, double height, int depth) {
    const point centre{x + width / 2, y + height / 2};
    const metric_tensor m = mesh_.field->at(centre);
    const double area = std::sqrt(m.m11 * m.m22 - m.m12 * m.m12) * width * height;
    // Cells that are not divided further then have areas from 2 down to a quarter of it.
    if (depth < 12 && (depth < 4 || area > 2)) {
      for (int i = 0; i < 4; ++i)
        place_in(x + (i % 2) * width / 2, y + (i / 2) * height / 2, width / 2, height / 2,
                 depth + 1);
      return;
    }
    if (area > 0.5 && !mesh_.net.cell_of(centre).empty()) add(centre.x, centre.y);
  }

  // Finds pairs within the wide reach, by a sweep along x.
  void find_neighbours() {
    near_.assign(bubbles_.size(), {});
    std::vector<index> order(bubbles_.size());
    std::iota(order.begin(), order.end(), index{0});
    std::sort(order.begin(), order.end(),
              [&](index a, index b) { return bubbles_[a].x < bubbles_[b].x; });
    for (std::size_t i = 0; i < order.size(); ++i) {
      const metric_tensor& m = tensor_[order[i]];
      // Beyond this x the length in the bubble's own metric is more than twice the wide reach, and
      // the mean of two lengths is at least half of one.
      const double window = 2 * wide_reach * std::sqrt(m.m22 / (m.m11 * m.m22 - m.m12 * m.m12));
      for (std::size_t j = i + 1; j < order.size(); ++j) {
        if (bubbles_[order[j]].x - bubbles_[order[i]].x > window) break;
        if (distance(order[i], order[j]) > wide_reach) continue;
        near_[order[i]].push_back(order[j]);
        near_[order[j]].push_back(order[i]);
      }
    }
  }

  // Removes bubbles with too much overlap, and puts one into the widest gap around each with too
  // little. Returns the number of changes.
  std::size_t change_population() {
    std::vector<bool> gone(bubbles_.size(), false);
    std::vector<point> fresh;
    for (index i = 0; i < bubbles_.size(); ++i) {
      double overlap = 0;
      for (const index j : near_[i])
        if (!gone[j]) overlap += std::max(0.0, 3 - 2 * distance(i, j));
      if (i >= held_ && overlap > crowded) gone[i] = true;
      if (overlap < sparse)
        if (const point p = beside(i); has_room(p, i, fresh)) fresh.push_back(p);
    }
    const std::size_t removed = keep([&](index i) { return !gone[i]; });
    for (const point& p : fresh) add(p.x, p.y);
    return removed + fresh.size();
  }

  // Returns the point at distance 1 from a bubble in its metric, in the middle of its widest gap.
  point beside(index i) const {
    const metric_tensor& m = tensor_[i];
    // M = L L^T, and L^T maps displacements to the frame in which the bubble is round.
    const double l11 = std::sqrt(m.m11), l21 = m.m12 / l11, l22 = std::sqrt(m.m22 - l21 * l21);
    std::vector<double> angles;
    for (const index j : near_[i]) {
      const double dx = bubbles_[j].x - bubbles_[i].x, dy = bubbles_[j].y - bubbles_[i].y;
      if (distance(i, j) < reach) angles.push_back(std::atan2(l22 * dy, l11 * dx + l21 * dy));
    }
    std::sort(angles.begin(), angles.end());
    double widest = 0, middle = 0;
    for (std::size_t k = 0; k < angles.size(); ++k) {
      const double turn = k + 1 < angles.size() ? 0 : 2 * std::numbers::pi;
      const double gap = angles[(k + 1) % angles.size()] + turn - angles[k];
      if (gap > widest) widest = gap, middle = angles[k] + gap / 2;
    }
    const double dy = std::sin(middle) / l22, dx = (std::cos(middle) - l21 * dy) / l11;
    return {bubbles_[i].x + dx, bubbles_[i].y + dy};
  }

  bool has_room(const point& p, index beside, const std::vector<point>& fresh) const {
    if (mesh_.net.cell_of(p).empty()) return false;
    const metric_tensor m = mesh_.field->at(p);
    const auto far = [&](double x, double y) {
      return baselines::length(m, x - p.x, y - p.y) > 0.7;
    };
    return std::all_of(near_[beside].begin(), near_[beside].end(),
                       [&](index j) { return far(bubbles_[j].x, bubbles_[j].y); }) &&
           std::all_of(fresh.begin(), fresh.end(), [&](const point& q) { return far(q.x, q.y); });
  }

  // Returns velocity and acceleration of a bubble at its place, with the others where they are.
  motion rate(index i, const motion& b) const {
    motion made{b.vx, b.vy, -damping * b.vx, -damping * b.vy};
    for (const index j : near_[i]) {
      const double dx = b.x - bubbles_[j].x, dy = b.y - bubbles_[j].y;
      const double w =
          (baselines::length(tensor_[i], dx, dy) + baselines::length(tensor_[j], dx, dy)) / 2;
      if (w == 0) continue;
      const double f = force(w) / w;
      made.vx += f * dx;
      made.vy += f * dy;
    }
    return made;
  }

  // Moves all bubbles by one step of the Runge-Kutta method of order four. Returns the greatest
  // speed.
  double step() {
    std::vector<motion> next = bubbles_;
    double greatest = 0;
    for (index i = held_; i < bubbles_.size(); ++i) {
      const motion& b = bubbles_[i];
      const motion a1 = rate(i, b), a2 = rate(i, b.moved(a1, time_step / 2)),
                   a3 = rate(i, b.moved(a2, time_step / 2)), a4 = rate(i, b.moved(a3, time_step));
      next[i] = b.moved(a1, time_step / 6)
                    .moved(a2, time_step / 3)
                    .moved(a3, time_step / 3)
                    .moved(a4, time_step / 6);
    }
    bubbles_ = std::move(next);
    for (index i = held_; i < bubbles_.size(); ++i) {
      tensor_[i] = at(*mesh_.field, bubbles_[i]);
      greatest = std::max(greatest, baselines::length(tensor_[i], bubbles_[i].vx, bubbles_[i].vy));
    }
    return greatest;
  }

  // Keeps the bubbles for which `wanted` is true. Returns how many were removed.
  std::size_t keep(const std::function<bool(index)>& wanted) {
    std::size_t kept = held_;
    for (index i = held_; i < bubbles_.size(); ++i) {
      if (!wanted(i)) continue;
      bubbles_[kept] = bubbles_[i];
      tensor_[kept++] = tensor_[i];
    }
    const std::size_t gone = bubbles_.size() - kept;
    bubbles_.resize(kept);
    tensor_.resize(kept);
    return gone;
  }

  void drop_escaped() {
    keep([this](index i) { return !mesh_.net.cell_of({bubbles_[i].x, bubbles_[i].y}).empty(); });
  }

  // Edges are flipped by the metric at the barycentre of the quadrilateral.
  void triangulate() {
    const baselines::metric_of_edge rule = [this](index v, index w, index x, index y) {
      const auto& p = mesh_.net.points();
      return mesh_.field->at(
          {(p[v].x + p[w].x + p[x].x + p[y].x) / 4, (p[v].y + p[w].y + p[x].y + p[y].y) / 4});
    };
    mesh_.net.flip_all(rule);
    for (index i = held_; i < bubbles_.size(); ++i) {
      const point p{bubbles_[i].x, bubbles_[i].y};
      const index v = mesh_.net.insert(p, mesh_.net.cell_of(p));
      if (v != none) mesh_.net.flip_from(mesh_.net.around(v), rule, 1000);
    }
    mesh_.measure_new();
    mesh_.net.flip_all(rule);
  }

  metric_mesh& mesh_;
  index held_;  // bubbles on the border and the domain's vertices, which do not move
  std::vector<motion> bubbles_;
  std::vector<metric_tensor> tensor_;
  std::vector<std::vector<index>> near_;
};

}  // namespace

int main(int count, char** words) {
  return baselines::run(count, words, {}, [](metric_mesh& mesh, const auto&) {
    return asterism::result<std::string>(packing(mesh).pack());
  });
}
