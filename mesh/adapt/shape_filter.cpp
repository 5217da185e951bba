// SPDX-License-Identifier: MIT
#include "asterism/mesh/adapt/shape_filter.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "asterism/mesh/adapt/editable_mesh.hpp"
#include "asterism/mesh/numerics/metric_algebra.hpp"
#include "asterism/mesh/support/work_weights.hpp"

namespace asterism::internal::adapting {
namespace {

// The logarithm of a tensor in three numbers: (trace + x, y; y, trace - x).
struct shape {
  double trace = 0, x = 0, y = 0;
};

double distance(const shape& a, const shape& b) {
  const double x = a.x - b.x, y = a.y - b.y;
  return std::sqrt(x * x + y * y);
}

std::vector<shape> shapes_of(const std::vector<metric_tensor>& tensors) {
  std::vector<shape> made;
  made.reserve(tensors.size());
  for (const metric_tensor& t : tensors) {
    const tensor_logarithm l = logarithm(t);
    made.push_back({(l.l11 + l.l22) / 2, (l.l11 - l.l22) / 2, l.l12});
  }
  return made;
}

// Lists the neighbours of all nodes; those of node v begin at first[v].
struct neighbour_lists {
  neighbour_lists(std::size_t nodes, const std::vector<graph_edge>& edges) : first(nodes + 1, 0) {
    for (const graph_edge& e : edges) {
      ++first[e.a + 1];
      ++first[e.b + 1];
    }
    for (std::size_t v = 0; v < nodes; ++v) first[v + 1] += first[v];
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    all.resize(2 * edges.size());
    for (const graph_edge& e : edges) {
      all[next[e.a]++] = e.b;
      all[next[e.b]++] = e.a;
    }
  }
  std::size_t count(vertex_index v) const { return first[v + 1] - first[v]; }

  std::vector<std::size_t> first;
  std::vector<vertex_index> all;
};

// Compares the shapes of nodes with their neighbours' shapes.
class noise_finder {
 public:
  noise_finder(const std::vector<shape>& shapes, const neighbour_lists& lists)
      : shapes_(shapes), lists_(lists) {}

  // True if at least half of the neighbours are as dense as the node.
  bool is_no_peak(vertex_index v) const {
    const auto* const first = lists_.all.data() + lists_.first[v];
    const auto denser =
        static_cast<std::size_t>(std::count_if(first, first + lists_.count(v), [&](auto w) {
          return shapes_[w].trace >= shapes_[v].trace;
        }));
    return 2 * denser >= lists_.count(v);
  }

  // Returns the neighbour whose shape is nearest to the other neighbours' shapes, if the node's
  // shape is farther from it than most of theirs are; otherwise the node itself.
  vertex_index better_shape(vertex_index v) {
    const auto* const first = lists_.all.data() + lists_.first[v];
    const std::size_t count = lists_.count(v);
    double least = std::numeric_limits<double>::infinity();
    vertex_index best = v;
    for (std::size_t i = 0; i < count; ++i) {
      double sum = 0;
      for (std::size_t k = 0; k < count; ++k) sum += distance(shapes_[first[i]], shapes_[first[k]]);
      if (!(sum < least)) continue;
      least = sum;
      best = first[i];
    }
    distances_.clear();
    for (std::size_t k = 0; k < count; ++k)
      distances_.push_back(distance(shapes_[best], shapes_[first[k]]));
    const auto middle = distances_.begin() + static_cast<std::ptrdiff_t>(count / 2);
    std::nth_element(distances_.begin(), middle, distances_.end());
    // Least distance of shapes, as a logarithm of an eigenvalue: a factor of 1.5 in lengths. Exact
    // Hessians of resolved features differ by less, and their errors grow with 0.3
    // (docs/results/constants.md).
    constexpr double least_distance = 0.8;
    return distance(shapes_[v], shapes_[best]) > std::max(least_distance, *middle) ? best : v;
  }

 private:
  const std::vector<shape>& shapes_;
  const neighbour_lists& lists_;
  std::vector<double> distances_;
};

}  // namespace

std::vector<metric_tensor> without_noise(const background_metric& field, const cancellation& stop) {
  // Range of the number of neighbours: fewer do not show noise, and more cost their square.
  constexpr std::size_t least_neighbours = 3, most_neighbours = 64;
  std::vector<metric_tensor> tensors = field.tensors();
  stop.charge(work_weights::node_without_noise * static_cast<double>(tensors.size()));
  const std::vector<shape> shapes = shapes_of(tensors);
  const neighbour_lists lists(tensors.size(), field.edges());
  noise_finder finder(shapes, lists);
  for (vertex_index v = 0; v < tensors.size(); ++v) {
    if (lists.count(v) < least_neighbours || lists.count(v) > most_neighbours) continue;
    if (!finder.is_no_peak(v)) continue;
    const vertex_index w = finder.better_shape(v);
    if (w == v) continue;
    const double trace = shapes[v].trace, x = shapes[w].x;
    const metric_tensor made = exponential({trace + x, shapes[w].y, trace - x});
    if (std::isfinite(made.m11) && std::isfinite(made.m22) && plain_root_of_determinant(made) > 0)
      tensors[v] = made;
  }
  return tensors;
}

}  // namespace asterism::internal::adapting
