// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric/background_metric.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "asterism/mesh/data/site_box.hpp"
#include "asterism/mesh/numerics/metric_length.hpp"
#include "asterism/mesh/support/parallel.hpp"

namespace asterism::internal {
namespace {

// Number of tensors that one thread converts at a time; it affects speed alone.
constexpr std::size_t nodes_at_once = 4096;

}  // namespace

background_metric::background_metric(const mesh& background)
    : background_metric(background, box_of_sites(background.sites)) {}

background_metric::background_metric(const mesh& background, const bounding_box& box)
    : locator_(std::make_shared<const triangle_locator>(background, box)) {
  std::vector<metric_tensor> tensors;
  tensors.reserve(background.sites.size());
  for (const site& s : background.sites) tensors.push_back(s.metric);
  set_tensors(std::move(tensors));
}

background_metric::background_metric(std::shared_ptr<const triangle_locator> locator,
                                     std::vector<metric_tensor> tensors)
    : locator_(std::move(locator)) {
  set_tensors(std::move(tensors));
}

void background_metric::set_tensors(std::vector<metric_tensor> tensors) {
  const auto before = tensors_ ? std::span(*tensors_) : std::span<const metric_tensor>();
  if (tensors_ &&
      std::equal(tensors.begin(), tensors.end(), before.begin(), before.end(), identical))
    return;
  std::vector<tensor_logarithm> logarithms(tensors.size());
  parallel_chunks(tensors.size(), nodes_at_once,
                  [&](std::size_t, std::size_t begin, std::size_t end) {
                    for (std::size_t v = begin; v < end; ++v)
                      logarithms[v] = v < before.size() && identical(tensors[v], before[v])
                                          ? (*logarithms_)[v]
                                          : logarithm(tensors[v]);
                  });
  tensors_ = std::make_shared<const std::vector<metric_tensor>>(std::move(tensors));
  logarithms_ = std::make_shared<const std::vector<tensor_logarithm>>(std::move(logarithms));
}

tensor_logarithm background_metric::mean_logarithm(const triangle_locator::located& where) const {
  const triangle& t = locator_->triangles()[where.triangle];
  const auto& w = where.weights;
  double sum = 0;
  for (const double x : w) sum += x;
  tensor_logarithm l;
  for (std::size_t i = 0; i < 3; ++i) add_weighted(w[i] / sum, (*logarithms_)[t[i]], l);
  return l;
}

metric_tensor background_metric::at(const point& q) const { return at_place(q, locator_->find(q)); }

std::optional<metric_tensor> background_metric::at_within(const point& q, double reach) const {
  const triangle_locator::located where = locator_->find(q);
  if (where.reach > reach) return std::nullopt;
  return at_place(q, where);
}

metric_tensor background_metric::at_place(const point& q,
                                          const triangle_locator::located& where) const {
  for (const vertex_index v : locator_->triangles()[where.triangle])
    if (places()[v] == q) return tensors()[v];
  return mean(where);
}

triangle_locator::located background_metric::nearby(const point& q, vertex_index hint,
                                                    std::size_t& looked_at) const {
  const triangle_locator::located where = locator_->nearby(q, hint);
  looked_at += where.looked_at;
  return where;
}

metric_tensor background_metric::at(const point& q, vertex_index& hint,
                                    std::size_t& looked_at) const {
  const triangle_locator::located where = nearby(q, hint, looked_at);
  hint = where.triangle;
  return quick_exponential(mean_logarithm(where));
}

triangle background_metric::nodes_around(const point& q, vertex_index& hint) const {
  hint = locator_->nearby(q, hint).triangle;
  return locator_->triangles()[hint];
}

std::optional<metric_tensor> background_metric::where_other(const background_metric& than,
                                                            const point& q, vertex_index hint,
                                                            std::size_t& looked_at) const {
  const triangle_locator::located where = nearby(q, hint, looked_at);
  const triangle& t = locator_->triangles()[where.triangle];
  const auto is_same = [&](vertex_index v) { return identical(tensors()[v], than.tensors()[v]); };
  if (std::all_of(t.begin(), t.end(), is_same)) return std::nullopt;
  const metric_tensor own = mean(where);
  return identical(own, than.mean(where)) ? std::nullopt : std::optional(own);
}

double background_metric::complexity() const {
  std::vector<double> roots(tensors().size());
  parallel_chunks(roots.size(), nodes_at_once,
                  [&](std::size_t, std::size_t begin, std::size_t end) {
                    for (std::size_t v = begin; v < end; ++v)
                      roots[v] = plain_root_of_determinant(tensors()[v]);
                  });
  double sum = 0;
  for (const triangle& t : locator_->triangles()) {
    const point &a = places()[t[0]], &b = places()[t[1]], &c = places()[t[2]];
    const double area = ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
    for (const vertex_index v : t) sum += area / 3 * roots[v];
  }
  return sum;
}

}  // namespace asterism::internal
