// SPDX-License-Identifier: MIT
//
// Meshes by the pliant method of Bossen and Heckbert: vertices repel near neighbours and attract
// far ones, edges are flipped, vertices inserted and taken away, all in one loop over the vertices
// that are still on the move.
//
// Source: Bossen, Heckbert, "A pliant method for anisotropic mesh generation", 5th International
// Meshing Roundtable, 1996, as chapter 2 of the thesis describes it. README.md says what is left
// out.
#include <algorithm>
#include <cmath>
#include <random>

#include "job.hpp"

namespace {

using baselines::index;
using baselines::metric_mesh;
using baselines::none;
using baselines::point;

// Part of the sum of forces by which a vertex moves: a fifth of an edge for a single neighbour.
constexpr double step = 0.2;
constexpr double still = 0.02;  // a vertex that moved less than this in its metric rests
// Longer edges are divided, and a vertex nearer than the second length to a neighbour is removed.
// The first leaves two edges in the range of unit edges. The second is so small that an inserted
// vertex is not removed before it has moved.
const double longest = std::sqrt(2.0);
constexpr double shortest = 0.55;
// Moves of each vertex in the mean, after which the loop ends.
constexpr std::size_t visits_a_vertex = 100;

// Returns the force: it pushes below the wanted length and pulls beyond it, less far away.
double force(double distance) {
  const double fourth = std::pow(distance, 4);
  return (1 - fourth) * std::exp(-fourth);
}

class pliant_mesh {
 public:
  explicit pliant_mesh(metric_mesh& mesh) : mesh_(mesh) {}

  std::string settle() {
    mesh_.net.flip_all(rule_);
    for (index v = 0; v < mesh_.fixed; ++v) activate(v);
    std::size_t visits = 0;
    while (!active_.empty() && visits < visits_a_vertex * (mesh_.net.points().size() - removed_)) {
      visit(take_one());
      ++visits;
    }
    return active_.empty() ? "every vertex rests" : std::to_string(active_.size()) + " still move";
  }

 private:
  void activate(index v) {
    is_active_.resize(mesh_.net.points().size(), false);
    if (is_active_[v]) return;
    is_active_[v] = true;
    active_.push_back(v);
  }

  index take_one() {
    std::swap(active_[random_() % active_.size()], active_.back());
    const index v = active_.back();
    active_.pop_back();
    is_active_[v] = false;
    return v;
  }

  void visit(index v) {
    if (mesh_.net.removed(v)) return;
    const double moved = v < mesh_.fixed ? 0 : move(v);
    if (moved > still) activate(v);
    if (v >= mesh_.fixed && remove_if_crowded(v)) return;
    divide_longest(v);
  }

  // Moves a vertex. Returns the distance in its metric. Halves a step that would turn a triangle
  // over, up to five times.
  double move(index v) {
    const point p = mesh_.net.points()[v];
    double dx = 0, dy = 0;
    for (const index w : mesh_.net.neighbours(v)) {
      const point& q = mesh_.net.points()[w];
      const double l = mesh_.length(v, w), f = step * force(l) / l;
      dx += f * (p.x - q.x);
      dy += f * (p.y - q.y);
    }
    for (int halved = 0; halved < 6; ++halved, dx /= 2, dy /= 2) {
      if (!mesh_.net.move(v, {p.x + dx, p.y + dy})) continue;
      mesh_.measure_again(v);
      flip(mesh_.net.around(v));
      return baselines::length(mesh_.tensor[v], dx, dy);
    }
    return 0;
  }

  bool remove_if_crowded(index v) {
    const std::vector<index> near = mesh_.net.neighbours(v);
    const bool crowded = std::any_of(near.begin(), near.end(),
                                     [&](index w) { return mesh_.length(v, w) < shortest; });
    if (!crowded || !mesh_.net.remove(v)) return false;
    ++removed_;
    for (const index w : near) {
      activate(w);
      flip(mesh_.net.around(w));
    }
    return true;
  }

  // Inserts the middle of the longest edge at v inside the domain, if it is too long.
  void divide_longest(index v) {
    index longest_to = none;
    double length = longest;
    for (const index w : mesh_.net.neighbours(v)) {
      if (mesh_.net.on_border(v) && mesh_.net.on_border(w) && is_border_edge(v, w)) continue;
      if (mesh_.length(v, w) <= length) continue;
      length = mesh_.length(v, w);
      longest_to = w;
    }
    if (longest_to == none) return;
    const point &p = mesh_.net.points()[v], &q = mesh_.net.points()[longest_to];
    const point middle{(p.x + q.x) / 2, (p.y + q.y) / 2};
    const index made = mesh_.net.insert(middle, mesh_.net.cell_of(middle));
    if (made == none) return;
    mesh_.measure_new();
    flip(mesh_.net.around(made));
    activate(made);
    for (const index w : mesh_.net.neighbours(made)) activate(w);
  }

  bool is_border_edge(index v, index w) const {
    const std::vector<index> ring = mesh_.net.neighbours(v);  // from border to border
    return w == ring.front() || w == ring.back();
  }

  void flip(std::vector<index> from) { mesh_.net.flip_from(std::move(from), rule_, 100); }

  metric_mesh& mesh_;
  // Returns the mean metric of the four vertices, as Bossen and Heckbert do.
  const baselines::metric_of_edge rule_ = [this](index v, index w, index x, index y) {
    return baselines::mean({mesh_.tensor[v], mesh_.tensor[w], mesh_.tensor[x], mesh_.tensor[y]});
  };
  std::vector<index> active_;
  std::size_t removed_ = 0;
  std::vector<bool> is_active_;
  std::minstd_rand random_{1};  // an engine whose numbers the standard defines
};

}  // namespace

int main(int count, char** words) {
  return baselines::run(count, words, {}, [](metric_mesh& mesh, const auto&) {
    return asterism::result<std::string>(pliant_mesh(mesh).settle());
  });
}
