// SPDX-License-Identifier: MIT
#include "asterism/mesh/delivery/fitting_goal.hpp"

#include <algorithm>
#include <numbers>
#include <tuple>

#include "asterism/mesh/adapt/editable_mesh.hpp"
#include "asterism/mesh/adapt/shape_filter.hpp"
#include "asterism/mesh/delivery/short_chords.hpp"
#include "asterism/mesh/gradation/nodal_gradation.hpp"

namespace asterism::internal {
namespace {

// Number of vertices of a mesh whose edges have length 1, for each unit of its area.
constexpr double vertices_for_area = 2 / std::numbers::sqrt3;
// Shares, of the number of vertices that full room for short segments needs, with which meshes
// failed and succeeded: with less than the first no attempt led to a mesh, whatever its work; the
// second sufficed on the coasts tried.
constexpr double too_small_a_part = 0.57, part_that_does = 0.75;
// Ratio of the complexities with and without room at short segments from which that room is made
// before the first mesh. On the coasts tried, with 1.75 and 4.2, the first mesh showed that it was
// needed, and its work was lost; with 1.1, where chords of curves are short, it was not.
constexpr double good_part = 1.25;

}  // namespace

bool fitting_goal::wants_few() const {
  constexpr std::size_t few = 1000;
  return count_ < few;
}

bool fitting_goal::domain_has_many_vertices() const {
  constexpr std::size_t part = 10;
  return part * domain_.vertices.size() > count_;
}

bool fitting_goal::may_want_room() const {
  if (!domain_has_many_vertices()) return false;
  const std::vector<double> factors = room_factors();
  return std::any_of(factors.begin(), factors.end(), [](double f) { return f > 1; });
}

void fitting_goal::leave_out_noise(const cancellation& stop) {
  fitted_.set_tensors(adapting::without_noise(fitted_, stop));
  is_other_ = true;
}

void fitting_goal::make_room_where_needed(const cancellation& stop) {
  if (!factors_at_short_chords(domain_, fitted_).empty()) {
    without_room_.emplace(fitted_, is_other_);
    return make_room_for_segments(0, stop);
  }
  constexpr std::size_t many = 100;  // a few vertices are no coast
  if (domain_.vertices.size() < many || !may_want_room()) return;
  background_metric finer = fitted_;
  finer.set_tensors(with_room(stop));
  const double with_all = finer.complexity();
  if (static_cast<double>(count_) < too_small_a_part * vertices_for_area * with_all)
    make_room_for_segments(part_that_does, stop);
  else if (with_all > good_part * fitted_.complexity())
    make_room_for_segments(0, stop);
}

void fitting_goal::make_room_for_segments(double part, const cancellation& stop) {
  fitted_.set_tensors(with_room(stop));
  is_other_ = has_room_ = true;
  raise_count(part, stop);
}

bool fitting_goal::give_up_room_at_chords() {
  if (!without_room_) return false;
  std::tie(fitted_, is_other_) = *std::exchange(without_room_, std::nullopt);
  has_room_ = false;
  return true;
}

// Raises the number of vertices to the number that the metric with room at short segments needs,
// times `part`. Returns false if that number is not greater or exceeds the limit.
bool fitting_goal::raise_count(double part, const cancellation& stop) {
  const auto all = static_cast<std::size_t>(part * vertices_for_area * fitted_.complexity());
  if (!(count_ < all && all < most_)) return false;
  count_ = all;
  stop.expect(count_);
  return true;
}

// Returns, for each node of the background, the factor of its tensor that makes room: above 1
// where vertices of the domain are less than one unit apart in it, and at chords much shorter than
// that.
std::vector<double> fitting_goal::room_factors() const {
  const std::vector<point>& places = fitted_.places();
  const std::vector<metric_tensor>& tensors = fitted_.tensors();
  const std::vector<char> is_given = at_vertices_of_domain(places);
  std::vector<double> factor;
  if (without_room_) factor = factors_at_short_chords(domain_, fitted_);
  factor.resize(places.size(), 1);
  for (const graph_edge& e : fitted_.edges()) {
    if (is_given[e.a] == 0 || is_given[e.b] == 0) continue;
    const double x = places[e.b].x - places[e.a].x, y = places[e.b].y - places[e.a].y;
    for (const vertex_index v : {e.a, e.b})
      factor[v] = std::max(factor[v], 1 / adapting::squared(tensors[v], x, y));
  }
  return factor;
}

// Returns the metric that the mesh is fitted to, refined by equal factors in all directions where
// segments are short, and beside them.
std::vector<metric_tensor> fitting_goal::with_room(const cancellation& stop) const {
  const std::vector<double> factor = room_factors();
  std::vector<metric_tensor> tensors = fitted_.tensors();
  for (std::size_t v = 0; v < factor.size(); ++v)
    tensors[v] = {tensors[v].m11 * factor[v], tensors[v].m12 * factor[v],
                  tensors[v].m22 * factor[v]};
  adapting::gradation_limit limit;
  limit.distortion = 1.5;  // 1.3 to 2 do as well; with 2 and more some angles are low again
  adapting::grade(fitted_.places(), fitted_.edges(), limit, tensors, stop);
  return tensors;
}

// Returns a flag for each place: whether it is a vertex of the domain, to the last bit. A mesh that
// is its own domain has such places.
std::vector<char> fitting_goal::at_vertices_of_domain(const std::vector<point>& places) const {
  std::vector<point> given = domain_.vertices;
  std::sort(given.begin(), given.end(), lexicographically_less);
  std::vector<char> found;
  found.reserve(places.size());
  for (const point& q : places)
    found.push_back(static_cast<char>(
        std::binary_search(given.begin(), given.end(), q, lexicographically_less)));
  return found;
}

background_metric fitting_goal::graded(double distortion, const cancellation& stop) const {
  background_metric made = fitted_;
  std::vector<metric_tensor> tensors = fitted_.tensors();
  adapting::gradation_limit limit;
  limit.distortion = distortion;
  limit.longest = 20;
  // Grades less where sites are few and do not resolve the metric: its peaks are at single nodes,
  // and large areas beside them would be refined (docs/design/adaptation.md).
  if (wants_few()) limit.coarser_part = 0.6;
  adapting::grade(made.places(), made.edges(), limit, tensors, stop);
  made.set_tensors(std::move(tensors));
  return made;
}

}  // namespace asterism::internal
