// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface/surface_mesher.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/support/parallel_for.hpp"
#include "asterism/mesh/surface/curve_division.hpp"
#include "asterism/mesh/surface/face_meshing.hpp"
#include "asterism/mesh/surface/few_bits.hpp"
#include "asterism/mesh/surface/shell_of_faces.hpp"
#include "asterism/mesh/surface/size_limits.hpp"
#include "asterism/mesh/surface/surface_sides.hpp"
#include "asterism/mesh/surface/trim_gaps.hpp"
#include "asterism/mesh/surface_audit/shell_audit.hpp"

namespace asterism::internal {
namespace {

// Number of rounds in which whole patches are made anew, finer or coarser. Later rounds only refine
// triangles beyond the chord.
constexpr std::size_t coarse_rounds = 4;
constexpr double aim = 0.92;  // of the chord: triangles vary
// Largest turn of normals over a triangle in radians, unless less is asked for: over a bend sharper
// than the chord height a triangle could be within the chord, and folded.
constexpr double greatest_turn = 1.2;

std::array<point, 3> corners_of(const mesh& m, std::size_t t) {
  const triangle& c = m.triangles[t];
  return {m.sites[c[0]].position, m.sites[c[1]].position, m.sites[c[2]].position};
}

// Returns by how much to increase the logarithm of the density at a triangle that is at most
// `distance` from the surface.
double finer_by(double distance, double chord) {
  return std::min(1.1 * elementary::log(distance / (aim * chord)) + 0.02, 2.0);
}

// Plane meshes of the patches. Charts and borders refer to the members declared before them.
struct patch_planes {
  patch_planes(const surface& s, std::vector<bezier_piece> of)
      : pieces(std::move(of)), spans(spans_of(pieces, s.patches.size())) {
    charts.reserve(s.patches.size());
    for (std::size_t p = 0; p < s.patches.size(); ++p) {
      charts.emplace_back(s.patches[p], pieces, spans[p]);
      borders.emplace_back(s.patches[p], charts[p]);
    }
  }
  patch_planes(const patch_planes&) = delete;
  patch_planes& operator=(const patch_planes&) = delete;

  std::vector<bezier_piece> pieces;
  std::vector<patch_spans> spans;
  std::vector<surface_chart> charts;
  std::vector<face_border> borders;
};

class surface_meshing {
 public:
  surface_meshing(const surface& s, const surface_mesh_options& options, side_graph graph,
                  const patch_planes& planes)
      : surface_(s),
        options_(options),
        graph_(std::move(graph)),
        planes_(planes),
        curves_(graph_.curves.size(), options.chord) {
    prepare();
  }

  result<surface_mesh> run();
  result<surface_mesh> run_to_count();

 private:
  surface_mesh ended(std::size_t rounds);
  void prepare();
  patch_faces patches() { return {graph_, planes_.charts, planes_.borders, faces_}; }
  void make_borders_simple();
  std::optional<error> make_stale_faces();
  void ask_at_first();
  std::optional<error> agree_on_sides();
  std::optional<error> measure();
  std::string fold_text(std::size_t triangle, const std::array<double, 2>& at) const;
  surface_mesh of_planes() const;
  void keep_if_better();
  bool has_grown_much() const;
  bool adjust(std::size_t round);
  void scale_at_first(std::size_t p, std::span<const double> distances);
  bool make_coarser_or_finer(std::size_t p, std::span<const double> distances);
  bool make_finer(std::size_t p, std::span<const double> distances);
  double expected_vertices() const;
  bool scale_to_count(std::size_t round);

  const surface& surface_;
  const surface_mesh_options& options_;
  side_graph graph_;
  const patch_planes& planes_;
  std::vector<face_meshing> faces_;
  curve_division curves_;
  std::vector<unsigned char> is_stale_;
  std::vector<std::string> reasons_;
  bool sides_agree_ = true;
  surface_shell shell_;
  using triangle_key = std::array<double, 7>;  // face and corners
  std::map<triangle_key, double> known_;       // distances in the round before
  std::vector<double> distances_;              // of all plane triangles, face by face
  std::size_t vertices_then_ = 0;              // when the coarse rounds ended
  std::optional<surface_mesh> best_;
  double best_distance_ = 0;
  std::optional<std::string> fold_;  // where the surface itself is folded
};

void surface_meshing::prepare() {
  surface_sizes sizes;
  sizes.chord = options_.chord;
  sizes.turn = options_.normal ? *options_.normal * std::numbers::pi / 180 : greatest_turn;
  sizes.longest = options_.longest;
  sizes.aspect = options_.aspect;
  const std::size_t patches = surface_.patches.size();
  const int cells = patches == 1 ? 80 : patches <= 8 ? 48 : 24;
  faces_.reserve(patches);
  for (std::size_t p = 0; p < patches; ++p)
    faces_.emplace_back(planes_.charts[p], planes_.borders[p], sizes, cells);
  is_stale_.assign(patches, 1);
  reasons_.resize(patches);
}

std::optional<error> surface_meshing::make_stale_faces() {
  std::vector<std::optional<error>> failed(faces_.size());
  const patch_faces of = patches();
  parallel_for(faces_.size(), [&](std::size_t p) {
    if (is_stale_[p] == 0) return;
    auto made = faces_[p].make(curves_.on_sides_of(of, p), options_);
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

// Divides the curves of patches whose polygons meet more finely, a few times; if that does not
// help, the plane mesh is refused.
void surface_meshing::make_borders_simple() {
  constexpr int most_divisions = 6;
  for (int k = 0; k < most_divisions; ++k) {
    const patch_faces of = patches();
    std::vector<unsigned char> meets(faces_.size(), 0);
    parallel_for(faces_.size(), [&](std::size_t p) {
      meets[p] = is_stale_[p] != 0 && !faces_[p].is_simple(curves_.on_sides_of(of, p)) ? 1 : 0;
    });
    bool any = false;
    for (std::size_t p = 0; p < meets.size(); ++p)
      if (meets[p] != 0) curves_.divide_border(of, p, is_stale_), any = true;
    if (!any) return;
  }
}

// Sets the first demands on the plane meshes: all, or sizes alone for a face whose vertices are
// kept from a mesh without the angle bound. Mending angles between such vertices doubled the mesh.
void surface_meshing::ask_at_first() {
  for (face_meshing& face : faces_) {
    const bool keeps = face.keeps_vertices() && face.made_with() != plane_demand::angles;
    face.ask_for(keeps ? plane_demand::sizes : plane_demand::angles);
  }
}

std::optional<error> surface_meshing::agree_on_sides() {
  constexpr int most_exchanges = 12;
  // Number of exchanges of side points in which faces must meet all demands; later exchanges demand
  // agreeing stars alone. Chosen by experiment: on a box with all edges rounded, 26 trimmed faces
  // in rings, twelve do not suffice, three take minutes and one takes seconds. Whole patches agree
  // within three.
  const bool trimmed = std::any_of(planes_.borders.begin(), planes_.borders.end(),
                                   [](const face_border& b) { return b.is_trimmed(); });
  const int full_exchanges = trimmed ? 1 : 3;
  ask_at_first();
  for (int k = 0; k < most_exchanges; ++k) {
    if (k >= full_exchanges && !options_.keeps_angle_bound)
      for (face_meshing& face : faces_) face.ask_for(plane_demand::stars);
    make_borders_simple();
    if (auto failed = make_stale_faces()) return failed;
    sides_agree_ = !curves_.take_splits(patches(), is_stale_);
    if (sides_agree_) return {};
  }
  return {};
}

// Measures the triangles that the round before did not have.
std::optional<error> surface_meshing::measure() {
  constexpr double enough = 0.5;  // of the chord: what is nearer need not be known better
  // Marks a triangle over which the surface may be folded as much too large, whatever its distance.
  constexpr double much = 1.4;
  shell_ = shell_of_faces(surface_, patches());
  std::vector<triangle_key> keys;
  std::vector<unsigned char> is_new;
  distances_.clear();
  for (std::size_t p = 0; p < faces_.size(); ++p) {
    const mesh& m = faces_[p].plane();
    for (const triangle& t : m.triangles) {
      const point &a = m.sites[t[0]].position, &b = m.sites[t[1]].position,
                  &c = m.sites[t[2]].position;
      keys.push_back({static_cast<double>(p), a.x, a.y, b.x, b.y, c.x, c.y});
      const auto before = known_.find(keys.back());
      is_new.push_back(before == known_.end() ? 1 : 0);
      distances_.push_back(before == known_.end() ? 0 : before->second);
    }
  }
  const auto measures = shell_measures(surface_, shell_, enough * options_.chord, is_new);
  if (!measures) return measures.failure();
  known_.clear();
  for (std::size_t t = 0; t < keys.size(); ++t) {
    const shell_measure& m = measures.value()[t];
    if (is_new[t] != 0)
      distances_[t] = in_few_bits(
          m.is_unfolded || m.fold ? m.distance : std::max(m.distance, much * options_.chord));
    if (m.fold && !fold_) fold_ = fold_text(t, *m.fold);
    known_.emplace(keys[t], distances_[t]);
  }
  return {};
}

std::string surface_meshing::fold_text(std::size_t triangle,
                                       const std::array<double, 2>& at) const {
  std::size_t p = 0;
  for (; triangle >= faces_[p].plane().triangles.size(); ++p)
    triangle -= faces_[p].plane().triangles.size();
  return fmt::format(
      "the surface itself turns round at u = {:.9g}, v = {:.9g} of patch {}: no mesh there is "
      "unfolded",
      at[0], at[1], p + 1);
}

// Returns the shell of the present plane meshes, before distances are measured.
surface_mesh surface_meshing::of_planes() const {
  surface_mesh now;
  now.complete = sides_agree_;
  now.angle_bound = options_.angle_bound;
  for (const face_meshing& face : faces_)
    if (face.made_with() != plane_demand::angles) now.angle_bound = 0;
  if (!sides_agree_)
    now.reason = "patches with a common side did not come to agree how to divide it";
  for (std::size_t p = 0; p < reasons_.size() && now.complete; ++p)
    if (!reasons_[p].empty()) {
      now.complete = false;
      now.reason = fmt::format("the plane mesh of patch {}: {}", p + 1, reasons_[p]);
    }
  return now;
}

// Keeps the present mesh if none is kept yet, or if it is better: complete, so within the chord,
// rather than not; of two complete meshes that with fewer vertices, of others the nearer to the
// surface.
void surface_meshing::keep_if_better() {
  surface_mesh now = of_planes();
  const double most = *std::max_element(distances_.begin(), distances_.end());
  if (now.complete && most > options_.chord) {
    now.complete = false;
    now.reason = fmt::format("a triangle is {:.6g} from its part of the surface", most);
  }
  const auto better = [&] {
    if (!best_) return true;
    if (best_->complete != now.complete) return now.complete;
    if (now.complete) return shell_.points.size() < best_->shell.points.size();
    return most < best_distance_;
  };
  if (!better()) return;
  now.shell = shell_;
  best_ = std::move(now);
  best_distance_ = most;
}

// Scales the metric of a patch as a whole: nearly all triangles of a metric that follows the
// curvature have about the same distance.
void surface_meshing::scale_at_first(std::size_t p, std::span<const double> distances) {
  std::vector<double> sorted(distances.begin(), distances.end());
  std::sort(sorted.begin(), sorted.end());
  const double most = sorted[(sorted.size() - 1) * 95 / 100];
  faces_[p].add_everywhere(
      std::clamp(elementary::log(std::max(most, 1e-300) / (aim * options_.chord)), -1.5, 3.0));
}

bool surface_meshing::make_coarser_or_finer(std::size_t p, std::span<const double> distances) {
  constexpr double least_ratio = 0.4, coarser_share = 0.3;
  const mesh& m = faces_[p].plane();
  for (std::size_t t = 0; t < distances.size(); ++t) {
    const double off =
        elementary::log(std::max(distances[t] / (aim * options_.chord), least_ratio));
    faces_[p].want(corners_of(m, t), distances[t] > options_.chord
                                         ? finer_by(distances[t], options_.chord)
                                         : std::min(coarser_share * off, 0.0));
  }
  faces_[p].apply();
  return true;
}

// Refines where a triangle is beyond the chord. If only few are, vertices elsewhere are kept: in a
// mesh made anew other triangles would be beyond the chord.
bool surface_meshing::make_finer(std::size_t p, std::span<const double> distances) {
  constexpr std::size_t few = 8;  // one in this number
  const mesh& m = faces_[p].plane();
  std::vector<unsigned char> beyond(distances.size(), 0);
  std::size_t count = 0;
  for (std::size_t t = 0; t < distances.size(); ++t) {
    if (!(distances[t] > options_.chord)) continue;
    beyond[t] = 1, ++count;
    faces_[p].want(corners_of(m, t), finer_by(distances[t], options_.chord));
  }
  faces_[p].apply();
  const bool incomplete = !reasons_[p].empty();
  faces_[p].keep_vertices(!incomplete && count * few <= distances.size());
  faces_[p].free_around(beyond);
  return count > 0 || incomplete;
}

// Changes the factors of the metrics by the measured distances. Returns false if nothing is to be
// changed.
bool surface_meshing::adjust(std::size_t round) {
  bool any = false;
  std::size_t first = 0;
  for (std::size_t p = 0; p < faces_.size(); ++p) {
    const std::size_t count = faces_[p].plane().triangles.size();
    const std::span<const double> own(distances_.data() + first, count);
    first += count;
    bool changed = true;
    if (round == 0)
      scale_at_first(p, own);
    else
      changed = round < coarse_rounds ? make_coarser_or_finer(p, own) : make_finer(p, own);
    if (changed) is_stale_[p] = 1, any = true;
  }
  return any;
}

// Sums from the least number on, so that the order of the patches makes no difference.
double surface_meshing::expected_vertices() const {
  std::vector<double> all;
  for (const face_meshing& face : faces_) all.push_back(face.expected_vertices());
  std::sort(all.begin(), all.end());
  return std::accumulate(all.begin(), all.end(), 0.0);
}

// Changes the density by the same factor everywhere, to meet a number of vertices.
bool surface_meshing::scale_to_count(std::size_t round) {
  constexpr std::size_t most_rounds = 6;
  constexpr double near = 0.02;
  const auto wanted = static_cast<double>(*options_.vertices);
  double now = 0;
  if (round == 0)
    now = expected_vertices();
  else
    now = static_cast<double>(shell_.points.size());
  const double off = elementary::log(wanted / std::max(now, 1.0));
  if (round > 0 && (std::abs(off) < near || round >= most_rounds)) return false;
  for (face_meshing& face : faces_) face.add_everywhere(std::clamp(off, -20.0, 20.0));
  std::fill(is_stale_.begin(), is_stale_.end(), 1);
  return true;
}

// True if further rounds are useless: there is a mesh with fewer vertices within the chord, or
// refining does not help.
bool surface_meshing::has_grown_much() const {
  constexpr std::size_t much = 4;
  if (best_->complete && shell_.points.size() > best_->shell.points.size()) return true;
  return vertices_then_ > 0 && shell_.points.size() > much * vertices_then_ + 1000;
}

surface_mesh surface_meshing::ended(std::size_t rounds) {
  best_->rounds = rounds;
  if (best_->angle_bound < options_.angle_bound)
    best_->notes.push_back(fmt::format(
        "faces did not come to agree how to divide their common sides with plane angles of {:g} "
        "degrees, and were made without a bound of them",
        options_.angle_bound));
  if (fold_) best_->complete = false, best_->reason = *fold_;
  if (options_.stop.is_requested()) {
    best_->complete = false;
    best_->reason = "the run was stopped";
  }
  return std::move(*best_);
}

result<surface_mesh> surface_meshing::run() {
  if (auto wrong = fault_of_count(expected_vertices(), options_.most_sites, options_.chord))
    return *wrong;
  std::size_t round = 0;
  for (; round < options_.most_rounds; ++round) {
    // Divides the curves from the beginning in the first rounds alone. Later rounds only add points
    // to the divisions, so that the loop ends.
    if (round < coarse_rounds) curves_.divide(patches(), is_stale_);
    if (auto failed = agree_on_sides()) return *failed;
    if (auto failed = measure()) return *failed;
    keep_if_better();
    if (options_.stop.is_requested()) break;
    if (round == coarse_rounds) vertices_then_ = shell_.points.size();
    if ((round >= coarse_rounds && has_grown_much()) || !adjust(round)) break;
  }
  return ended(std::min(round + 1, options_.most_rounds));
}

// Makes meshes until one has about the number of vertices wanted. Measures no distances: those of
// the final mesh are proved later.
result<surface_mesh> surface_meshing::run_to_count() {
  std::size_t round = 0;
  scale_to_count(round);
  do {
    curves_.divide(patches(), is_stale_);
    if (auto failed = agree_on_sides()) return *failed;
    shell_ = shell_of_faces(surface_, patches());
    ++round;
  } while (!options_.stop.is_requested() && scale_to_count(round));
  best_ = of_planes();
  best_->shell = std::move(shell_);
  return ended(round);
}

}  // namespace

result<surface_mesh> make_surface_mesh(const surface& s, const surface_mesh_options& options) {
  auto pieces = bezier_pieces(s);
  if (!pieces) return pieces.failure();
  if (auto wrong = fault_of_chord(s, options.chord)) return *wrong;
  const patch_planes planes(s, std::move(pieces).value());
  auto graph = graph_of_sides(s, planes.borders);
  if (!graph) return graph.failure();
  if (auto wrong =
          fault_of_gaps(graph.value(), planes.borders, planes.pieces, planes.spans, options.chord))
    return *wrong;
  surface_meshing meshing(s, options, std::move(graph).value(), planes);
  return options.vertices ? meshing.run_to_count() : meshing.run();
}

}  // namespace asterism::internal
