// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface/surface_mesher.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/support/parallel_for.hpp"
#include "asterism/mesh/surface/face_meshing.hpp"
#include "asterism/mesh/surface/surface_sides.hpp"
#include "asterism/mesh/surface_audit/shell_audit.hpp"

namespace asterism::internal {
namespace {

// Places on curves are multiples of this, so that a place and 1 less it are both exact.
constexpr double place_unit = 0x1p-30;
constexpr int side_samples = 256;  // of the length of a curve

double rounded_place(double x) {
  return std::clamp(std::round(x / place_unit) * place_unit, place_unit, 1 - place_unit);
}

class surface_meshing {
 public:
  surface_meshing(const surface& s, const surface_mesh_options& options, side_graph graph,
                  std::vector<bezier_piece> pieces)
      : surface_(s),
        options_(options),
        graph_(std::move(graph)),
        pieces_(std::move(pieces)),
        spans_(spans_of(pieces_, s.patches.size())) {
    prepare();
  }

  result<surface_mesh> run();

 private:
  void prepare();
  double length_of(const side_curve& curve, std::vector<double>& sums) const;
  void divide_curves();
  std::optional<error> make_stale_faces();
  bool take_splits();
  std::optional<error> agree_on_sides();
  surface_shell shell() const;
  std::optional<error> measure();
  bool adjust(std::size_t round);
  bool scale_to_count(std::size_t round);
  void keep_if_better();

  point at_place(const patch_side& side, double place) const;
  double own_place(const patch_side& side, double place) const {
    return side.backward ? 1 - place : place;
  }

  const surface& surface_;
  const surface_mesh_options& options_;
  side_graph graph_;
  std::vector<bezier_piece> pieces_;
  std::vector<patch_spans> spans_;
  std::vector<surface_chart> charts_;
  std::vector<face_meshing> faces_;
  std::vector<std::vector<double>> places_;  // on each curve, from its start, ascending
  std::vector<unsigned char> is_stale_;
  std::vector<std::string> reasons_;
  bool sides_agree_ = true;
  std::vector<double> distances_;  // of all plane triangles, face by face
  std::optional<surface_mesh> best_;
  double best_distance_ = 0;
};

void surface_meshing::prepare() {
  surface_sizes sizes;
  sizes.chord = options_.chord;
  if (options_.normal) sizes.turn = *options_.normal * std::numbers::pi / 180;
  sizes.longest = options_.longest;
  sizes.aspect = options_.aspect;
  const std::size_t patches = surface_.patches.size();
  const int cells = patches == 1 ? 80 : patches <= 8 ? 48 : 24;
  charts_.reserve(patches);
  faces_.reserve(patches);
  for (std::size_t p = 0; p < patches; ++p) {
    charts_.emplace_back(pieces_, spans_[p]);
    faces_.emplace_back(charts_[p], sizes, cells);
  }
  is_stale_.assign(patches, 1);
  reasons_.resize(patches);
  places_.resize(graph_.curves.size());
}

point surface_meshing::at_place(const patch_side& side, double place) const {
  const surface_chart& chart = charts_[side.patch];
  const point low = chart.low(), high = chart.high();
  const double own = own_place(side, place);
  const double x = low.x + own * (high.x - low.x), y = low.y + own * (high.y - low.y);
  return side.side == 0   ? point{x, low.y}
         : side.side == 1 ? point{high.x, y}
         : side.side == 2 ? point{x, high.y}
                          : point{low.x, y};
}

// The metric length of a curve, the greater of what its two patches say at each place.
double surface_meshing::length_of(const side_curve& curve, std::vector<double>& sums) const {
  sums.assign(1, 0);
  for (int k = 0; k < side_samples; ++k) {
    const double place = (k + 0.5) / side_samples;
    double density = 0;
    for (const patch_side& side : curve.sides) {
      const surface_chart& chart = charts_[side.patch];
      const metric_tensor m = faces_[side.patch].metric_at(at_place(side, place));
      const double width = chart.high().x - chart.low().x, height = chart.high().y - chart.low().y;
      density =
          std::max(density, side.side % 2 == 0 ? m.m11 * width * width : m.m22 * height * height);
    }
    sums.push_back(sums.back() + std::sqrt(density) / side_samples);
  }
  return sums.back();
}

// Divides the curves of two patches in parts of about equal length.
void surface_meshing::divide_curves() {
  constexpr double longest_part = 0.95;
  std::vector<double> sums;
  for (std::size_t c = 0; c < graph_.curves.size(); ++c) {
    const side_curve& curve = graph_.curves[c];
    if (curve.is_point || curve.sides.size() < 2) continue;
    const double length = length_of(curve, sums);
    const auto parts = static_cast<int>(std::max(1.0, std::ceil(length / longest_part)));
    std::vector<double> places;
    std::size_t k = 0;
    for (int part = 1; part < parts; ++part) {
      const double wanted = length * part / parts;
      while (sums[k + 1] < wanted) ++k;
      const double share = (wanted - sums[k]) / (sums[k + 1] - sums[k]);
      const double place = rounded_place((static_cast<double>(k) + share) / side_samples);
      if (places.empty() || place > places.back()) places.push_back(place);
    }
    if (places == places_[c]) continue;
    places_[c] = std::move(places);
    for (const patch_side& side : curve.sides) is_stale_[side.patch] = 1;
  }
}

std::optional<error> surface_meshing::make_stale_faces() {
  std::vector<std::optional<error>> failed(faces_.size());
  parallel_for(faces_.size(), [&](std::size_t p) {
    if (is_stale_[p] == 0) return;
    side_places own;
    for (std::size_t side = 0; side < 4; ++side) {
      const std::size_t c = graph_.curve_of[p][side];
      for (const patch_side& at : graph_.curves[c].sides) {
        if (at.patch != p || at.side != static_cast<int>(side)) continue;
        for (const double place : places_[c]) own[side].push_back(own_place(at, place));
        if (at.backward) std::reverse(own[side].begin(), own[side].end());
      }
    }
    auto made = faces_[p].make(own, options_);
    if (!made)
      failed[p] = made.failure();
    else
      reasons_[p] = made.value();
  });
  std::fill(is_stale_.begin(), is_stale_.end(), 0);
  for (std::size_t p = 0; p < failed.size(); ++p)
    if (failed[p]) return failed[p]->at(fmt::format("patch {}", p + 1));
  return {};
}

// Takes the places at which a patch's mesh has divided a curve of two patches to that curve, for
// both. True if there were any.
bool surface_meshing::take_splits() {
  bool any = false;
  for (std::size_t p = 0; p < faces_.size(); ++p) {
    const mesh& m = faces_[p].plane();
    for (vertex_index v = m.given; v < m.sites.size(); ++v) {
      const auto on = faces_[p].side_of(v);
      if (!on) continue;
      const std::size_t c = graph_.curve_of[p][static_cast<std::size_t>(on->side)];
      const side_curve& curve = graph_.curves[c];
      if (curve.is_point || curve.sides.size() < 2) continue;
      const patch_side& mine = curve.sides[0].patch == p && curve.sides[0].side == on->side
                                   ? curve.sides[0]
                                   : curve.sides[1];
      const double place = rounded_place(own_place(mine, on->place));
      std::vector<double>& places = places_[c];
      const auto after = std::lower_bound(places.begin(), places.end(), place);
      any = true;
      if (after == places.end() || *after != place) places.insert(after, place);
      for (const patch_side& side : curve.sides) is_stale_[side.patch] = 1;
    }
  }
  return any;
}

std::optional<error> surface_meshing::agree_on_sides() {
  constexpr int most_exchanges = 12;
  for (int k = 0; k < most_exchanges; ++k) {
    if (auto failed = make_stale_faces()) return failed;
    sides_agree_ = !take_splits();
    if (sides_agree_) return {};
  }
  return {};
}

surface_shell surface_meshing::shell() const {
  constexpr std::uint32_t none = ~0U;
  surface_shell made;
  std::vector<std::uint32_t> corner(graph_.corners, none);
  std::map<std::pair<std::size_t, double>, std::uint32_t> on_curve;
  const auto add = [&](const space_point& p) {
    // -0 is 0, so that equal places are equal bits.
    made.points.push_back({p.x + 0.0, p.y + 0.0, p.z + 0.0});
    return static_cast<std::uint32_t>(made.points.size() - 1);
  };
  for (std::size_t p = 0; p < faces_.size(); ++p) {
    const surface_patch& patch = surface_.patches[p];
    const std::array<space_point, 4> corners = {
        patch.at(0, 0).at, patch.at(patch.count_u - 1, 0).at,
        patch.at(patch.count_u - 1, patch.count_v - 1).at, patch.at(0, patch.count_v - 1).at};
    shell_face face;
    face.patch = static_cast<std::uint32_t>(p);
    face.scale_u = charts_[p].scale_u(), face.scale_v = charts_[p].scale_v();
    face.reversed = graph_.reversed[p];
    face.plane = faces_[p].plane();
    for (vertex_index v = 0; v < face.plane.sites.size(); ++v) {
      if (v < 4) {
        std::uint32_t& known = corner[graph_.corner_of[p][v]];
        if (known == none) known = add(corners[v]);
        face.vertex.push_back(known);
        continue;
      }
      const auto on = faces_[p].side_of(v);
      const std::size_t c = on ? graph_.curve_of[p][static_cast<std::size_t>(on->side)] : 0;
      if (on && graph_.curves[c].is_point) {
        face.vertex.push_back(corner[graph_.corner_of[p][static_cast<std::size_t>(on->side)]]);
      } else if (on && graph_.curves[c].sides.size() == 2) {
        const auto& sides = graph_.curves[c].sides;
        const patch_side& mine =
            sides[0].patch == p && sides[0].side == on->side ? sides[0] : sides[1];
        const double place = own_place(mine, on->place);
        const auto [known, is_new] = on_curve.emplace(std::pair{c, place}, 0);
        if (is_new) known->second = add(charts_[sides[0].patch].lift(at_place(sides[0], place)));
        face.vertex.push_back(known->second);
      } else {
        face.vertex.push_back(add(charts_[p].lift(face.plane.sites[v].position)));
      }
    }
    made.faces.push_back(std::move(face));
  }
  return made;
}

std::optional<error> surface_meshing::measure() {
  const surface_shell now = shell();
  constexpr double enough = 0.5;  // of the chord: what is nearer need not be known better
  // A triangle over which the surface may be folded is much too large, whatever its distance.
  constexpr double much = 2;
  const auto measures = shell_measures(surface_, now, enough * options_.chord);
  if (!measures) return measures.failure();
  distances_.clear();
  for (const shell_measure& m : measures.value())
    distances_.push_back(m.is_unfolded ? m.distance : std::max(m.distance, much * options_.chord));
  return {};
}

// Keeps the first mesh, then one within the chord, then the one with the fewest vertices.
void surface_meshing::keep_if_better() {
  surface_mesh now;
  now.shell = shell();
  const double most = *std::max_element(distances_.begin(), distances_.end());
  now.complete = sides_agree_;
  if (!sides_agree_)
    now.reason = "patches with a common side did not come to agree how to divide it";
  for (std::size_t p = 0; p < reasons_.size() && now.complete; ++p)
    if (!reasons_[p].empty()) {
      now.complete = false;
      now.reason = fmt::format("the plane mesh of patch {}: {}", p + 1, reasons_[p]);
    }
  if (now.complete && most > options_.chord) {
    now.complete = false;
    now.reason = fmt::format("a triangle is {:.6g} from its part of the surface", most);
  }
  const auto better = [&] {
    if (!best_) return true;
    if (best_->complete != now.complete) return now.complete;
    if (now.complete) return now.shell.points.size() < best_->shell.points.size();
    return most < best_distance_;
  };
  if (!better()) return;
  best_ = std::move(now);
  best_distance_ = most;
}

// Changes the factors of the metrics by the distances found. False if nothing is to be changed.
bool surface_meshing::adjust(std::size_t round) {
  constexpr std::size_t coarse_rounds = 4;
  constexpr double aim = 0.92;  // of the chord: triangles vary
  bool any = false;
  std::size_t at = 0;
  for (std::size_t p = 0; p < faces_.size(); ++p) {
    const mesh& m = faces_[p].plane();
    const std::size_t first = at;
    at += m.triangles.size();
    std::vector<double> sorted(distances_.begin() + static_cast<std::ptrdiff_t>(first),
                               distances_.begin() + static_cast<std::ptrdiff_t>(at));
    std::sort(sorted.begin(), sorted.end());
    const double greatest = sorted.back();
    if (round == 0) {
      // Nearly all triangles of a metric that follows the curvature have about the same distance.
      const double most = sorted[(sorted.size() - 1) * 95 / 100];
      faces_[p].add_everywhere(
          std::clamp(elementary::log(std::max(most, 1e-300) / (aim * options_.chord)), -1.5, 3.0));
      is_stale_[p] = 1;
      any = true;
      continue;
    }
    if (greatest <= options_.chord && round >= coarse_rounds) continue;
    bool changed = false;
    for (std::size_t t = first; t < at; ++t) {
      const double ratio = distances_[t] / (aim * options_.chord);
      const auto& c = m.triangles[t - first];
      const std::array<point, 3> corners = {m.sites[c[0]].position, m.sites[c[1]].position,
                                            m.sites[c[2]].position};
      const double off = elementary::log(std::max(ratio, 0.4));
      if (distances_[t] > options_.chord) {
        faces_[p].want(corners, std::min(1.1 * off + 0.02, 2.0));
        changed = true;
      } else if (round < coarse_rounds) {
        faces_[p].want(corners, off < 0 ? 0.3 * off : 0);
        changed = true;
      }
    }
    faces_[p].apply();
    if (changed) is_stale_[p] = 1, any = true;
  }
  return any;
}

// The same density everywhere, for a number of vertices.
bool surface_meshing::scale_to_count(std::size_t round) {
  constexpr std::size_t most_rounds = 6;
  constexpr double near = 0.02;
  const auto wanted = static_cast<double>(*options_.vertices);
  double now = 0;
  if (round == 0)
    for (const face_meshing& face : faces_) now += face.expected_vertices();
  else
    now = static_cast<double>(shell().points.size());
  const double off = elementary::log(wanted / std::max(now, 1.0));
  if (round > 0 && (std::abs(off) < near || round >= most_rounds)) return false;
  for (face_meshing& face : faces_) face.add_everywhere(std::clamp(off, -20.0, 20.0));
  std::fill(is_stale_.begin(), is_stale_.end(), 1);
  return true;
}

result<surface_mesh> surface_meshing::run() {
  std::size_t round = 0;
  if (options_.vertices) scale_to_count(round);
  for (; round < options_.most_rounds; ++round) {
    // Later on curves only get more places, so that rounds end.
    if (round < 4 || options_.vertices) divide_curves();
    if (auto failed = agree_on_sides()) return *failed;
    if (auto failed = measure()) return *failed;
    if (options_.vertices) best_.reset();
    keep_if_better();
    if (options_.stop.is_requested()) {
      best_->complete = false;
      best_->reason = "the run was stopped";
      break;
    }
    if (options_.vertices ? !scale_to_count(round + 1) : !adjust(round)) break;
  }
  best_->rounds = std::min(round + 1, options_.most_rounds);
  return std::move(*best_);
}

}  // namespace

result<surface_mesh> make_surface_mesh(const surface& s, const surface_mesh_options& options) {
  auto pieces = bezier_pieces(s);
  if (!pieces) return pieces.failure();
  auto graph = graph_of_sides(s);
  if (!graph) return graph.failure();
  surface_meshing meshing(s, options, std::move(graph).value(), std::move(pieces).value());
  return meshing.run();
}

}  // namespace asterism::internal
