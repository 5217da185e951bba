// SPDX-License-Identifier: MIT
//
// Inserts the first nodes of a unit mesh, in blocks where there are many of them.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "asterism/mesh/adapt/mesh_blocks.hpp"
#include "asterism/mesh/adapt/unit_mesh.hpp"
#include "asterism/mesh/support/parallel.hpp"

namespace asterism::internal::adapting {
namespace {

using seed_list = std::vector<point>;

// Returns the seeds that each block inserts.
std::vector<seed_list> by_blocks(const mesh_blocks& blocks, const seed_list& seeds) {
  constexpr std::size_t seeds_at_once = 4096;
  std::vector<std::uint32_t> block_of(seeds.size());
  parallel_chunks(seeds.size(), seeds_at_once,
                  [&](std::size_t, std::size_t begin, std::size_t end) {
                    for (std::size_t i = begin; i < end; ++i)
                      block_of[i] = static_cast<std::uint32_t>(blocks.block_near(seeds[i]));
                  });
  std::vector<seed_list> lists(blocks.count());
  for (std::size_t i = 0; i < seeds.size(); ++i) lists[block_of[i]].push_back(seeds[i]);
  return lists;
}

seed_list joined(const std::vector<seed_list>& lists) {
  seed_list all;
  for (const seed_list& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

// Returns every step-th seed whose number is not a multiple of `coarser`, which may be 0.
seed_list level_of(const seed_list& seeds, std::size_t step, std::size_t coarser) {
  seed_list some;
  for (std::size_t i = 0; i < seeds.size(); i += step)
    if (coarser == 0 || i % coarser != 0) some.push_back(seeds[i]);
  return some;
}

}  // namespace

// Metrics at seeds, looked up by several threads before the seeds are inserted one after the other.
// Each look-up begins where the one before has ended, so these depend on each other: the first one
// of each piece of the list begins elsewhere, and where its end differs it is made again, with
// those that depend on it. Which look-ups are made does not depend on the number of threads.
class unit_mesh_remesher::metrics_ahead {
 public:
  // The list and the field must outlive the object.
  metrics_ahead(std::span<const point> seeds, const metric_at& field)
      : seeds_(seeds), field_(field), found_(seeds.size()) {
    constexpr std::size_t seeds_at_once = 256;
    parallel_chunks(seeds.size(), seeds_at_once,
                    [this](std::size_t, std::size_t begin, std::size_t end) {
                      vertex_index hint = 0;
                      for (std::size_t i = begin; i < end; ++i) found_[i] = look_up(i, hint);
                    });
  }

  // Returns the metric at a seed, and sets the hint as the field would.
  metric_tensor at(std::size_t i, vertex_index& hint) {
    if (found_[i].from != hint) return look_up(i, hint).metric;
    hint = found_[i].to;
    return found_[i].metric;
  }

 private:
  struct looked_up {
    metric_tensor metric;
    vertex_index from = none, to = none;  // the hint before and after
  };

  looked_up look_up(std::size_t i, vertex_index& hint) const {
    const vertex_index from = hint;
    const metric_tensor there = field_(seeds_[i], hint);
    return {there, from, hint};
  }

  std::span<const point> seeds_;
  const metric_at& field_;
  std::vector<looked_up> found_;
};

// Splits a subsegment at a seed that is on it, up to rounding, or beside a curve that it is a chord
// of. Returns no node where the seed is elsewhere, or has no room.
std::optional<vertex_index> unit_mesh_remesher::insert_on_side(vertex_index t, std::size_t edge,
                                                               node& there) {
  const face& f = m_.faces()[t];
  if (f.segment[edge] == none || is_of_frame(f.segment[edge])) return std::nullopt;
  const point &a = m_.at(f.v[after(edge)]).position, &b = m_.at(f.v[before(edge)]).position;
  const double x = b.x - a.x, y = b.y - a.y;
  const double along =
      ((there.position.x - a.x) * x + (there.position.y - a.y) * y) / (x * x + y * y);
  const auto place = m_.place_on_edge(t, edge, {a.x + along * x, a.y + along * y});
  if (!place) return std::nullopt;
  // Greatest distance of a seed from its place on the subsegment, in units: the metric at the seed
  // is about that at the place.
  constexpr double most = 0.1;
  const double to_x = place->x - there.position.x, to_y = place->y - there.position.y;
  if (!(squared(there.metric, to_x, to_y) < most * most * unit_ * unit_)) return std::nullopt;
  there.position = *place;
  there.metric = field_(*place, there.hint);
  return is_crowded(t, there) ? std::nullopt : m_.split(t, edge, *place);
}

// Inserts a node at a seed. Seeds on the sides split these: a split of a long edge is decided by
// the metric at its ends, and would miss a front that ends between them.
std::optional<vertex_index> unit_mesh_remesher::insert_seed(const located_place& at, node& there) {
  if (at.beyond) return insert_on_side(at.face, *at.beyond, there);
  if (is_crowded(at.face, there)) return std::nullopt;
  if (const auto made = m_.insert(at.face, there.position)) return made;
  const face f = m_.faces()[at.face];
  for (std::size_t i = 0; i < 3; ++i)
    if (!turns_left(m_.at(f.v[after(i)]).position, m_.at(f.v[before(i)]).position, there.position))
      return insert_on_side(at.face, i, there);
  return std::nullopt;
}

// Inserts nodes at the seeds that have room, with their metrics where these are known. Returns the
// seeds that were not reached by a walk from the face of an earlier seed, or lie beyond an edge and
// got no node.
std::vector<point> unit_mesh_remesher::insert_seeds(std::span<const point> seeds,
                                                    metrics_ahead* known) {
  std::vector<point> left;
  vertex_index from = 0, hint = 0;
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    const point& q = seeds[i];
    if (m_.nodes().size() >= options_.most_nodes) return left;
    const located_place at = m_.locate(q, from, walls::boundary);
    if (at.face == none) {
      left.push_back(q);
      continue;
    }
    node there;
    there.position = q;
    there.metric = known != nullptr ? known->at(i, hint) : field_(q, hint);
    there.hint = hint;
    const auto made = insert_seed(at, there);
    if (!at.beyond)
      from = at.face;
    else if (!made)
      left.push_back(q);
    if (!made) continue;
    m_.at(*made).hint = there.hint;
    m_.set_metric(*made, there.metric);
    settle_around(*made);
    from = m_.at(*made).face;
  }
  return left;
}

// Inserts the seeds, in the blocks of one cut. Returns those left over near the frame: their faces
// are in other blocks than their places on the curve.
std::vector<point> unit_mesh_remesher::insert_in_blocks(const std::vector<point>& seeds) {
  std::vector<seed_list> lists, left;
  const auto insert = [&](unit_mesh_remesher& part, std::size_t b) {
    left[b] = part.insert_seeds(lists[b]);
    part.flip_all();  // also what was the frame of the cut before
    return lists[b].size() - left[b].size();
  };
  in_blocks(insert, [&](const mesh_blocks& blocks) {
    lists = by_blocks(blocks, seeds);
    left.resize(lists.size());
    std::vector<std::size_t> seeds_of_blocks;
    for (const seed_list& list : lists) seeds_of_blocks.push_back(list.size());
    return seeds_of_blocks;
  });
  return joined(left);
}

// Inserts the seeds. Of many seeds every 16th is inserted before the rest, and so on: the few at
// the beginning make the mesh that is cut into blocks for the next ones. All parts are ordered so
// that near seeds follow each other. Where few nodes are wanted most seeds find no room, and all
// are inserted at once.
void unit_mesh_remesher::seed(const std::vector<point>& seeds) {
  constexpr std::size_t few = 16384, finer = 16;
  const std::size_t expected =
      options_.count == 0 ? seeds.size() : std::min(seeds.size(), options_.count);
  std::size_t step = 1;
  while (expected / step > few) step *= finer;
  const auto insert = [this](const seed_list& some) {
    metrics_ahead known(some, field_);
    insert_seeds(some, &known);
  };
  insert(level_of(seeds, step, 0));
  while (step > 1 && !is_stopped()) {
    const std::size_t coarser = std::exchange(step, step / finer);
    seed_list level = level_of(seeds, step, coarser);
    for (int cut = 0; cut < 2 && mesh_blocks::are_worth_it(m_); ++cut)
      level = insert_in_blocks(level);
    insert(level);
  }
  is_inside_.clear();
}

}  // namespace asterism::internal::adapting
