// SPDX-License-Identifier: MIT
#include "asterism/mesh/gradation/gradation_sweep.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/numerics/eight_directions.hpp"
#include "asterism/mesh/numerics/metric_length.hpp"
#include "asterism/mesh/support/sort_unique.hpp"

namespace asterism::internal {

namespace {

// A leaf is fine enough when logarithms of tensors are linear over it up to 0.1 (lengths up to 5
// percent) and vary by at most 1 from its middle (lengths by 1.65), or when it is no longer than an
// edge.
constexpr double largest_defect = 0.1, largest_variation = 1, longest_diagonal = 1;

// Largest variation, in logarithms, of the given field in a leaf with an altered node: beyond it
// the leaf may contain a jump of the field, which must not reappear between the nodes.
constexpr double largest_mixed = 0.2;

// Relative excess of a squared length over its limit that is ignored. Over a unit of length the
// limit grows by 2 sigma, 0.19 for beta = 1.1; the larger slack is for interpolated metrics, whose
// error is about a quarter of the largest defect.
constexpr double slack_at_nodes = 0.005, slack_between_nodes = 0.03;

// Points that a node visits in addition to its neighbours, in units of its own metric. A path over
// edges of the grid repeatedly crosses a thin layer that it should follow, and so allows too long
// edges; a smaller circle takes more sweeps to the same end.
constexpr double circle_radius = 1;

tensor_logarithm mean(const tensor_logarithm& a, const tensor_logarithm& b) {
  return {(a.l11 + b.l11) / 2, (a.l12 + b.l12) / 2, (a.l22 + b.l22) / 2};
}

// Returns the part of `d`, at most 1, that leads from q to the border of the box around q.
double part_inside(const point& q, const point& d, const bounding_box& box) {
  double t = 1;
  if (d.x > 0) t = std::min(t, (box.high.x - q.x) / d.x);
  if (d.x < 0) t = std::min(t, (box.low.x - q.x) / d.x);
  if (d.y > 0) t = std::min(t, (box.high.y - q.y) / d.y);
  if (d.y < 0) t = std::min(t, (box.low.y - q.y) / d.y);
  return t;
}

error ended_early() { return {"gradation was ended before it was done"}; }

}  // namespace

gradation_sweep::gradation_sweep(const metric_field& field, gradation_grid& grid,
                                 const gradation_options& options)
    : field_(field), grid_(grid), options_(options), sigma_(elementary::log(options.beta)) {
  box_.low = grid.position(grid.cells().front().corners[0]);
  box_.high = grid.position(grid.cells().back().corners[2]);
  report_.beta = options.beta;
}

// True if the run is to end; the stop is polled every 256 steps. A step is a sample or a visit of a
// node's surroundings, some microseconds.
bool gradation_sweep::is_ended() {
  constexpr std::size_t between_questions = 256;
  if (!ended_ && ++steps_ % between_questions == 0) ended_ = options_.stop.is_requested();
  return ended_;
}

std::optional<error> gradation_sweep::sample() {
  ++time_;
  field_.expect([this] {
    std::vector<point> places;
    for (std::size_t n = nodes_.size(); n < grid_.nodes(); ++n)
      places.push_back(grid_.position(static_cast<std::uint32_t>(n)));
    return places;
  });
  for (std::size_t n = nodes_.size(); n < grid_.nodes(); ++n) {
    if (is_ended()) return ended_early();
    const auto m = field_.at(grid_.position(static_cast<std::uint32_t>(n)));
    if (!m.ok())
      return error{"gradation asks for the metric everywhere in the domain's box: " +
                   m.failure().message};
    node fresh{m.value(), m.value(), logarithm(m.value()), {}, time_, 0, false};
    fresh.now_log = fresh.given_log;
    nodes_.push_back(fresh);
  }
  return std::nullopt;
}

bool gradation_sweep::is_resolved(const gradation_grid::cell& leaf, bool by_given) const {
  const auto log_of = [&](std::uint32_t n) -> const tensor_logarithm& {
    return by_given ? nodes_[n].given_log : nodes_[n].now_log;
  };
  const tensor_logarithm& middle = log_of(leaf.middle);
  const gradation_grid::rim rim = grid_.rim_of(leaf);
  double variation = 0;
  for (std::size_t i = 0; i < rim.size; ++i)
    if (rim.node[i] < nodes_.size())  // others came up with the last splits
      variation = std::max(variation, difference(log_of(rim.node[i]), middle));
  const auto across = [&](std::size_t i) {
    return mean(log_of(leaf.corners[i]), log_of(leaf.corners[i + 2]));
  };
  const double defect = std::max(difference(across(0), middle), difference(across(1), middle));
  if (defect <= largest_defect && variation <= largest_variation) return true;
  const point d = grid_.diagonal(leaf), other{d.x, -d.y};
  double longest = 0;
  for (const std::uint32_t n : leaf.corners) {
    const metric_tensor& m = by_given ? nodes_[n].given : nodes_[n].now;
    longest = std::max({longest, plain_length(m, d), plain_length(m, other)});
  }
  return longest <= longest_diagonal;
}

std::vector<bool> gradation_sweep::kept() const {
  std::vector<bool> keep(nodes_.size());
  for (std::size_t n = 0; n < nodes_.size(); ++n) keep[n] = !nodes_[n].altered;
  const std::vector<bool> unaltered = keep;
  for (const gradation_grid::cell& c : grid_.cells()) {
    if (!c.leaf()) continue;
    bool altered = !unaltered[c.middle], varies = false;
    for (const std::uint32_t n : c.corners) {
      altered |= !unaltered[n];
      varies |= difference(nodes_[n].given_log, nodes_[c.middle].given_log) > largest_mixed;
    }
    if (!altered || !varies) continue;
    keep[c.middle] = false;
    for (const std::uint32_t n : c.corners) keep[n] = false;
  }
  return keep;
}

// Splits the leaves that are not fine enough. Tests the present leaves alone; new ones are tested
// the next time.
std::size_t gradation_sweep::refine(bool by_given) {
  const auto count = static_cast<std::uint32_t>(grid_.cells().size());
  std::size_t splits = 0;
  for (std::uint32_t c = 0; c < count; ++c) {
    const gradation_grid::cell cell = grid_.cells()[c];
    if (!cell.leaf() || is_resolved(cell, by_given)) continue;
    if (grid_.nodes() >= options_.max_nodes || !grid_.split(c)) {
      report_.resolved = false;
      continue;
    }
    ++splits;
  }
  return splits;
}

std::optional<error> gradation_sweep::refine_given() {
  if (auto failure = sample()) return failure;
  for (int level = 0; level <= gradation_grid::deepest && refine(true) > 0; ++level)
    if (auto failure = sample()) return failure;
  return std::nullopt;
}

void gradation_sweep::connect() {
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (const gradation_grid::cell& c : grid_.cells()) {
    if (!c.leaf()) continue;
    const gradation_grid::rim rim = grid_.rim_of(c);
    for (std::size_t i = 0; i < rim.size; ++i) {
      const std::uint32_t a = rim.node[i], b = rim.node[(i + 1) % rim.size];
      for (const auto& e : {std::array{a, b}, std::array{a, c.middle}}) {
        edges.push_back(e);
        edges.push_back({e[1], e[0]});
      }
    }
  }
  sort_unique(edges);
  first_neighbour_.assign(nodes_.size() + 1, 0);
  neighbours_.clear();
  for (const auto& e : edges) {
    ++first_neighbour_[e[0] + 1];
    neighbours_.push_back(e[1]);
  }
  std::partial_sum(first_neighbour_.begin(), first_neighbour_.end(), first_neighbour_.begin());
}

bool gradation_sweep::take(std::uint32_t n, const metric_tensor& other, const point& from,
                           double slack) {
  node& own = nodes_[n];
  const point& q = grid_.position(n);
  const double growth = 1 + sigma_ * plain_length(other, {q.x - from.x, q.y - from.y});
  const double f = 1 / (growth * growth);
  const metric_tensor allowed{f * other.m11, f * other.m12, f * other.m22};
  if (!exceeds(allowed, own.now, slack)) return false;
  own.now = intersection(own.now, allowed);
  return true;
}

bool gradation_sweep::take_from_neighbours(std::uint32_t n) {
  bool taken = false;
  for (std::uint32_t i = first_neighbour_[n]; i < first_neighbour_[n + 1]; ++i) {
    const std::uint32_t p = neighbours_[i];
    if (nodes_[p].changed > nodes_[n].visited)
      taken |= take(n, nodes_[p].now, grid_.position(p), slack_at_nodes);
  }
  return taken;
}

bool gradation_sweep::take_from_circle(std::uint32_t n) {
  const node own = nodes_[n];
  const bool moved = own.changed > own.visited;
  const point& q = grid_.position(n);
  const unit_displacements unit = unit_circle(own.now);
  bool taken = false;
  for (const point& u : eight_directions) {
    const point d{circle_radius * (u.x * unit.first.x + u.y * unit.second.x),
                  circle_radius * (u.x * unit.first.y + u.y * unit.second.y)};
    const double t = part_inside(q, d, box_);
    if (t < 0.5) continue;  // so near, the growth allowed is less than the error of interpolation
    const point x{q.x + t * d.x, q.y + t * d.y};
    const gradation_grid::place place = grid_.locate(x);
    bool news = moved;
    tensor_logarithm l{};
    for (std::size_t i = 0; i < 3; ++i) {
      const node& near = nodes_[place.node[i]];
      news |= near.changed > own.visited;
      l.l11 += place.weight[i] * near.now_log.l11;
      l.l12 += place.weight[i] * near.now_log.l12;
      l.l22 += place.weight[i] * near.now_log.l22;
    }
    if (news) taken |= take(n, exponential(l), x, slack_between_nodes);
  }
  return taken;
}

bool gradation_sweep::visit(std::uint32_t n) {
  const std::uint64_t started = time_;
  const bool from_neighbours = take_from_neighbours(n);
  const bool taken = take_from_circle(n) || from_neighbours;
  nodes_[n].visited = started;
  if (!taken) return false;
  nodes_[n].now_log = logarithm(nodes_[n].now);
  nodes_[n].changed = ++time_;
  nodes_[n].altered = true;
  return true;
}

// Sweeps over the nodes from small lengths to large ones: small lengths spread, so that one sweep
// carries them far.
void gradation_sweep::sweep_until_settled() {
  std::vector<std::uint32_t> order(nodes_.size());
  std::iota(order.begin(), order.end(), 0U);
  report_.settled = false;
  while (!report_.settled && report_.sweeps < options_.max_sweeps) {
    ++report_.sweeps;
    std::vector<double> strength;
    strength.reserve(nodes_.size());
    for (const node& n : nodes_) strength.push_back(n.now.m11 + n.now.m22);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return strength[a] != strength[b] ? strength[a] > strength[b] : a < b;
    });
    report_.settled = true;
    for (const std::uint32_t n : order) {
      if (is_ended()) return;
      if (visit(n)) report_.settled = false;
    }
  }
}

std::optional<error> gradation_sweep::run() {
  if (auto failure = refine_given()) return failure;
  for (int level = 0; level <= gradation_grid::deepest; ++level) {
    connect();
    sweep_until_settled();
    if (ended_) return ended_early();
    report_.resolved = true;
    if (!report_.settled || refine(false) == 0) break;
    if (auto failure = sample()) return failure;
  }
  return std::nullopt;
}

}  // namespace asterism::internal
