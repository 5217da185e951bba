// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/curve_separation.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "asterism/mesh/domain/hull_contact.hpp"
#include "asterism/mesh/domain/message_names.hpp"
#include "asterism/mesh/search/box_index.hpp"

namespace asterism::internal {
namespace {

enum class item_kind { piece, segment, vertex };

// An obstacle for a curve's piece: a piece of another curve, a straight segment, or a vertex on
// none.
struct item {
  item_kind kind = item_kind::piece;
  std::size_t number = 0;  // of the curve, segment or vertex
  double t0 = 0, t1 = 1;   // of a piece
  std::vector<point> hull;
  bounding_box box;
  bool is_gone = false;
};

bounding_box box_around(const domain& d, const std::vector<curve_path>& paths) {
  constexpr int samples = 8;
  bounding_box box = d.box();
  for (const curve_path& path : paths)
    for (int i = 0; i <= samples; ++i) box.include(path.at(static_cast<double>(i) / samples));
  return box;
}

class separation {
 public:
  separation(const domain& d, const std::vector<curve_path>& paths, double finest_part)
      : domain_(d), paths_(paths), finest_part_(finest_part), index_(box_around(d, paths)) {}

  void add_straight() {
    std::vector<char> is_curved(domain_.segments.size(), 0);
    for (const domain_curve& c : domain_.curves) is_curved[c.segment] = 1;
    std::vector<char> on_segment(domain_.vertices.size(), 0);
    for (std::size_t s = 0; s < domain_.segments.size(); ++s) {
      const segment& one = domain_.segments[s];
      on_segment[one.a] = on_segment[one.b] = 1;
      const point &a = domain_.vertices[one.a], &b = domain_.vertices[one.b];
      if (is_curved[s] == 0 && a != b) add({item_kind::segment, s, 0, 1, {a, b}, {}});
    }
    for (std::size_t v = 0; v < domain_.vertices.size(); ++v)
      if (on_segment[v] == 0) add({item_kind::vertex, v, 0, 1, {domain_.vertices[v]}, {}});
  }

  void add_piece(std::size_t curve, double t0, double t1) {
    waiting_.push_back(items_.size());
    add({item_kind::piece, curve, t0, t1, convex_hull(paths_[curve].control_points(t0, t1)), {}});
  }

  // Tests the last waiting piece. Returns an error if the curves cannot be separated.
  std::optional<error> step() {
    const std::size_t now = waiting_.back();
    waiting_.pop_back();
    if (items_[now].is_gone) return std::nullopt;
    const auto other = find_contact(now);
    if (!other) return std::nullopt;
    // Halves the longer of two pieces first, so that neither is divided without need.
    const bool halve_other =
        items_[*other].kind == item_kind::piece && diameter(items_[*other]) > diameter(items_[now]);
    const std::size_t halved = halve_other ? *other : now;
    if (items_[halved].t1 - items_[halved].t0 < finest_part_)
      return refusal(items_[halved], items_[halve_other ? now : *other]);
    if (halve_other) waiting_.push_back(now);
    halve(halved);
    return std::nullopt;
  }

  bool is_done() const { return waiting_.empty(); }

  // Returns a flag for each curve: whether a waiting piece of it touches another item.
  std::vector<char> in_contact() const {
    std::vector<char> found(paths_.size(), 0);
    for (const std::size_t piece : waiting_)
      if (find_contact(piece)) found[items_[piece].number] = 1;
    return found;
  }

  std::vector<std::vector<double>> parameters() const {
    std::vector<std::vector<double>> found(paths_.size(), std::vector<double>{0});
    for (const item& i : items_)
      if (i.kind == item_kind::piece && !i.is_gone) found[i.number].push_back(i.t1);
    for (std::vector<double>& of_one : found) std::sort(of_one.begin(), of_one.end());
    return found;
  }

 private:
  void add(item one) {
    one.box = {one.hull[0], one.hull[0]};
    for (const point& p : one.hull) one.box.include(p);
    index_.insert(static_cast<std::uint32_t>(items_.size()), one.box);
    items_.push_back(std::move(one));
  }

  static double diameter(const item& i) {
    return std::max(i.box.high.x - i.box.low.x, i.box.high.y - i.box.low.y);
  }

  void halve(std::size_t at) {
    items_[at].is_gone = true;
    index_.remove(static_cast<std::uint32_t>(at), items_[at].box);
    const std::size_t curve = items_[at].number;
    const double t0 = items_[at].t0, t1 = items_[at].t1, t = (t0 + t1) / 2;
    add_piece(curve, t0, t);
    add_piece(curve, t, t1);
  }

  // Returns the first item that the piece touches.
  std::optional<std::size_t> find_contact(std::size_t at) const {
    std::optional<std::size_t> first;
    index_.visit(items_[at].box, [&](std::uint32_t i) {
      if (i != at && (!first || i < *first) && hulls_meet(items_[at].hull, items_[i].hull))
        first = i;
      return true;
    });
    return first;
  }

  error refusal(const item& piece, const item& other) const {
    const domain_names names(domain_);
    const std::string near = " near " + coordinates(paths_[piece.number].at(piece.t0));
    const std::string start = names.at_curve(piece.number) + names.curve(piece.number);
    if (other.kind == item_kind::vertex)
      return {start + " passes through " + names.vertex(other.number) + ", which is no end of it"};
    if (other.kind == item_kind::segment)
      return {start + " crosses or touches " + names.segment(other.number) +
              names.line_of_segment(other.number) + near};
    if (other.number == piece.number) return {start + " crosses or touches itself" + near};
    return {start + " crosses or touches " + names.curve(other.number) + near};
  }

  const domain& domain_;
  const std::vector<curve_path>& paths_;
  double finest_part_;
  box_index index_;
  std::vector<item> items_;
  std::vector<std::size_t> waiting_;  // pieces to look at
};

}  // namespace

result<std::vector<std::vector<double>>> separate_curves(
    const domain& d, const std::vector<curve_path>& paths,
    std::vector<std::vector<double>> parameters, double finest_part) {
  separation pieces(d, paths, finest_part);
  pieces.add_straight();
  for (std::size_t c = 0; c < parameters.size(); ++c)
    for (std::size_t i = 0; i + 1 < parameters[c].size(); ++i)
      pieces.add_piece(c, parameters[c][i], parameters[c][i + 1]);
  while (!pieces.is_done())
    if (auto refused = pieces.step()) return std::move(*refused);
  return pieces.parameters();
}

std::vector<char> curves_in_contact(const domain& d, const std::vector<curve_path>& paths) {
  separation pieces(d, paths, 1);
  pieces.add_straight();
  for (std::size_t c = 0; c < paths.size(); ++c) pieces.add_piece(c, 0, 1);
  return pieces.in_contact();
}

}  // namespace asterism::internal
