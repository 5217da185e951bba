// SPDX-License-Identifier: MIT
#include "asterism/apps/pieces/pieces_job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "asterism/apps/base/complain.hpp"
#include "asterism/apps/job/job_input.hpp"
#include "asterism/apps/job/job_words.hpp"
#include "asterism/apps/options/thread_limit.hpp"
#include "asterism/apps/pieces/piece_files.hpp"
#include "asterism/apps/pieces/piece_report.hpp"
#include "asterism/apps/run/progress_line.hpp"
#include "asterism/apps/run/run_limits.hpp"
#include "asterism/apps/text/summary.hpp"
#include "asterism/core/number_text.hpp"
#include "asterism/core/version.h"
#include "asterism/mesh/io/file_output.hpp"
#include "asterism/mesh/io/json_values.hpp"
#include "asterism/mesh/metric/metric_part.hpp"
#include "asterism/mesh/pieces/piece_mesh.hpp"
#include "asterism/mesh/pieces/verify_pieces.hpp"
#include "asterism/mesh/pipeline/read_triangulation.hpp"

namespace asterism::apps {
using namespace internal;
namespace fs = std::filesystem;
namespace {

// Largest number of rounds in which pieces add points on their seams. Each round adds a site, so
// that they end (docs/math/pieces.md); no job that was tried took more than five.
constexpr std::size_t most_rounds = 100;

// Names of options in certificates that are results of a run, and not part of its question.
constexpr std::array answers = {"size-delivered", "tol-at-end", "improve-done"};

std::optional<error> refuse(const std::string& why) { return error{why, error_code::bad_option}; }

// Refuses options that meshes in pieces do not support.
std::optional<error> check_job(const mesh_job& job) {
  const mesh_options& asked = job.refinement;
  if (job.pieces == 0) return refuse("--pieces is wanted: asterism-mpi makes meshes in pieces");
  if (job.outputs.size() != 1)
    return refuse("--pieces: one folder is wanted for -o, and there are several");
  if (!job.periodic.empty())
    return refuse("--periodic: both sides want the whole domain, which no piece has");
  if (!job.certificate.empty())
    return refuse("--certificate: each piece has its own beside it, with --pieces");
  if (!job.sizes.near.empty() || !job.sizes.layers.empty() || !job.sizes.regions.empty() ||
      job.sizes_of_file)
    return refuse(
        "--pieces: sizes at segments and in regions want the whole domain, which no piece has; "
        "--size-at and --size-box can be asked for");
  if (!job.proof.empty())
    return refuse("--proof: it is of a whole mesh, which --pieces does not make");
  if (!asked.limit_size)
    return refuse("--pieces: a size is wanted: --size, --vertices or --complexity");
  if (asked.strategy != refinement_strategy::fill)
    return refuse("--refine: with --pieces it can only be fill");
  if (asked.improve_passes > 0)
    return refuse("--improve: it moves sites over a whole mesh, which --pieces does not make");
  if (asked.prove_voronoi)
    return refuse("--voronoi: it is proved of whole meshes, which --pieces does not make");
  if (asked.metric_tolerance.value_or(0) > 0)
    return refuse("--metric-tolerance: with --pieces the metric is as given, a tolerance of 0");
  if (job.max_megabytes) return refuse("--max-memory: a mesh in pieces takes the memory of one");
  return check_piece_formats(job.piece_formats);
}

// Returns to all members the first failure of any of them.
std::optional<error> agreed(piece_team& team, const std::optional<error>& failure) {
  for (const std::string& told : team.gather(failure ? "!" + failure->message : ""))
    if (!told.empty()) return error{told.substr(1)};
  return std::nullopt;
}

// Returns the names of the options asked for, without those that are results.
std::map<std::string, std::string> question_of(const mesh_job& job, const prepared_input& input) {
  std::map<std::string, std::string> words = options_of(job, input, mesh_outcome());
  for (const char* answer : answers) words.erase(answer);
  return words;
}

std::string box_text(const bounding_box& box) {
  return fmt::format("{} {} {} {}", number_text(box.low.x), number_text(box.low.y),
                     number_text(box.high.x), number_text(box.high.y));
}

// True if one member alone reads the metric, and gives each piece its part of it.
bool has_metric_in_parts(const mesh_job& job) {
  return !job.field && is_metric_on_mesh(job.metric) && job.sizes.is_empty();
}

// Returns the job without its metric, for members that do not read it.
mesh_job without_metric(mesh_job job) {
  job.metric = "identity";
  job.size = 1;
  job.gradation.reset();
  job.complexity.reset();
  job.refinement.vertices.reset();
  job.refinement.limit_size = false;
  return job;
}

class pieces_run {
 public:
  pieces_run(mesh_job job, prepared_input input, piece_team& team, run_limits& limits)
      : in_parts_(has_metric_in_parts(job)),
        job_(std::move(job)),
        input_(std::move(input)),
        team_(team),
        limits_(limits),
        files_(job_, input_) {}

  int run() {
    const bool cuts = !in_parts_ || team_.is_first();
    if (const auto failed = agree(cuts ? cut() : std::nullopt))
      return complain_once(*failed, refused);
    if (const auto failed = agree(team_.is_first() ? files_.prepare_folder() : std::nullopt))
      return complain_once(*failed, refused);
    if (const auto failed = in_parts_ ? take_parts() : std::nullopt)
      return complain_once(*failed, not_reached);
    begin();
    resume_rounds();
    while (!next_.empty())
      if (const auto failed = round()) return complain_once(*failed, not_reached);
    limits_.conclude();
    finish_index();
    if (const auto failed = agree(team_.is_first() ? files_.write_index(index_) : std::nullopt))
      return complain_once(*failed, not_reached);
    return conclude();
  }

 private:
  std::optional<error> cut() {
    cut_wishes wishes;
    wishes.pieces = job_.pieces;
    wishes.angle_bound = job_.refinement.angle_bound;
    wishes.stop = [this] { return limits_.reason(); };
    auto made = cut_domain(input_.shape, *input_.metric.field, wishes);
    if (!made) return made.failure();
    index_.cut = std::move(made).value();
    auto points = divide_seams(input_.shape, index_.cut, *input_.metric.field);
    if (!points) return points.failure();
    index_.points = std::move(points).value();
    index_.version = ASTERISM_VERSION_TEXT;
    index_.metric = job_.metric;
    index_.options = question_of(job_, input_);
    index_.angle_bound = job_.refinement.angle_bound;
    index_.original = input_.shape;
    index_.digests.assign(index_.cut.edges.size(), 0);
    return std::nullopt;
  }

  // Makes the first member write each piece's part of the metric, after which it frees the metric;
  // all members read the partition from it and never hold the whole metric.
  std::optional<error> take_parts() {
    std::optional<error> failed;
    for (piece_index p = 0; team_.is_first() && !failed && p < job_.pieces; ++p) {
      const piece_shape shape = shape_of_piece(index_.original, index_.cut, index_.points, p);
      failed = files_.write_metric(p, *part_of(*input_.metric.field, shape.shape.box()));
    }
    if (auto told = agree(failed)) return told;
    index_.pieces.resize(job_.pieces);
    const std::string mine = team_.is_first() ? index_text(index_) : "";
    auto taken = parse_index(team_.gather(mine).front(), "the cut");
    if (!taken) return taken.failure();
    index_ = std::move(taken).value();
    index_.pieces.clear();
    input_.metric.field.reset();
    if (const auto size = parse_number(index_.options.at("size"))) job_.size = size.value();
    return std::nullopt;
  }

  void begin() {
    entries_.resize(job_.pieces);
    for (piece_index p = 0; p < job_.pieces; ++p) next_.push_back(p);
    question_ = digest_text(digest_of(index_text(index_)));
  }

  // Continues with the rounds of an interrupted run.
  void resume_rounds() {
    if (!job_.resume) return;
    const auto done = files_.read_rounds(index_.cut.edges.size(), job_.pieces);
    if (!done || done->question != question_) return;
    index_.points = done->points;
    index_.rounds = done->rounds;
    index_.made = done->made;
    next_ = done->next;
  }

  // Makes this member's pieces of one round, and exchanges the results of all members.
  std::optional<error> round() {
    if (++index_.rounds > most_rounds)
      return error{
          fmt::format("not reached: after {} rounds pieces still ask for more on their "
                      "seams, piece {} the first",
                      most_rounds, next_.front() + 1)};
    index_.made += next_.size();
    std::vector<piece_report> mine;
    const std::vector<piece_index> wanted = pieces_wanted();
    for (std::size_t i = team_.rank(); i < wanted.size(); i += team_.size()) {
      mine.push_back(make(wanted[i]));
      if (!mine.back().failure.empty()) break;
    }
    std::vector<piece_report> all;
    for (const std::string& text : team_.gather(text_of(mine)))
      for (piece_report& one : reports_of(text)) all.push_back(std::move(one));
    std::sort(all.begin(), all.end(),
              [](const piece_report& a, const piece_report& b) { return a.piece < b.piece; });
    return take(all);
  }

  // Returns the pieces of the round and, in a continued run, those whose files are to be read.
  std::vector<piece_index> pieces_wanted() const {
    std::set<piece_index> wanted(next_.begin(), next_.end());
    for (piece_index p = 0; p < entries_.size(); ++p)
      if (!entries_[p]) wanted.insert(p);
    return {wanted.begin(), wanted.end()};
  }

  std::optional<error> take(std::vector<piece_report>& all) {
    std::vector<seam_in_mesh> asked;
    for (piece_report& one : all) {
      if (!one.failure.empty()) return error{one.failure};
      entries_[one.piece] = std::move(one.entry);
      for (const auto& [edge, digest] : one.digests) index_.digests[edge] = digest;
      for (seam_in_mesh& seam : one.asked) asked.push_back(std::move(seam));
    }
    next_.clear();
    std::set<piece_index> beside;
    for (const std::size_t e : unite_seams(asked, index_.points)) {
      beside.insert(index_.cut.edges[e].left);
      beside.insert(index_.cut.edges[e].right);
    }
    next_.assign(beside.begin(), beside.end());
    const bool goes_on = !next_.empty() && team_.is_first();
    return agree(
        goes_on ? files_.write_rounds({question_, index_.rounds, index_.made, next_, index_.points})
                : std::nullopt);
  }

  piece_report make(piece_index p) {
    const piece_shape shape = shape_of_piece(index_.original, index_.cut, index_.points, p);
    const std::string question = question_of_piece(p, shape);
    if (job_.resume)
      if (const auto kept = files_.read_piece(p, question))
        return report(p, shape, kept->subject, kept->claim, kept->digest);
    std::unique_ptr<metric_field> part;
    if (in_parts_) {
      auto read = files_.read_metric(p);
      if (!read) return failed(p, read.failure().message);
      part = std::move(read).value();
    }
    mesh_options options = job_.refinement;
    options.metric_tolerance = 0;
    options.stop = [this] { return limits_.reason(); };
    progress_line line(!job_.quiet && team_.is_first());
    auto made = make_piece_mesh(shape, part ? *part : *input_.metric.field, options,
                                [&](const mesh_progress& progress) {
                                  limits_.expect(progress.sites);
                                  line.show(progress);
                                });
    line.clear();
    if (!made) return failed(p, made.failure().message);
    if (const auto why = limits_.reason())
      return failed(p, *why + "; pieces that are finished are whole, and --resume goes on");
    describe(p, question, made.value());
    const auto digest = files_.write_piece(p, made.value());
    if (!digest) return failed(p, digest.failure().message);
    return report(p, shape, made.value().outcome.result, made.value().claim, digest.value());
  }

  // Enters the options of the piece into its certificate; `question` distinguishes it from the same
  // piece of another run.
  void describe(piece_index p, const std::string& question, certified_mesh& made) const {
    made.claim.metric = job_.metric;
    made.claim.options = index_.options;
    const auto words = options_of(job_, input_, made.outcome);
    for (const char* answer : answers) made.claim.options[answer] = words.at(answer);
    made.claim.options["piece"] = fmt::format("{} of {}", std::size_t{p} + 1, job_.pieces);
    made.claim.options["piece-question"] = question;
    made.claim.options["metric-box"] = box_text(index_.original.box());
  }

  std::string question_of_piece(piece_index p, const piece_shape& shape) const {
    std::string text = fmt::format("{} {}", question_, p);
    for (std::size_t s = 0; s < shape.divisions.size(); ++s)
      if (shape.divisions[s])
        for (const point& q : *shape.divisions[s]) text += fmt::format(" {} {}", q.x, q.y);
    return digest_text(digest_of(text));
  }

  static piece_report failed(piece_index p, const std::string& why) {
    piece_report none;
    none.piece = p;
    none.failure = fmt::format("not reached: piece {}: {}", std::size_t{p} + 1, why);
    return none;
  }

  piece_report report(piece_index p, const piece_shape& shape, const mesh& subject,
                      const certificate& claim, std::uint64_t digest) const {
    piece_report made;
    made.piece = p;
    made.entry = {name_of_piece(p, job_.pieces, ".mesh"),
                  name_of_piece(p, job_.pieces, ".certificate.json"),
                  claim.fingerprint,
                  digest,
                  claim.sites,
                  claim.triangles,
                  claim.worst_angle,
                  claim.certified && claim.complete,
                  claim.reason};
    auto asked = seams_asked_for(index_.cut, shape, p, subject);
    if (!asked) return failed(p, asked.failure().message);
    made.asked = std::move(asked).value();
    const seam_digests digests = digests_of(index_, p, subject);
    for (std::size_t e = 0; e < digests.size(); ++e)
      if (digests[e] != 0) made.digests.emplace_back(e, digests[e]);
    return made;
  }

  // Counts vertices and triangles of the whole mesh: sites on seams belong to several pieces.
  void finish_index() {
    std::set<std::pair<vertex_index, piece_index>> at_ends;
    std::set<vertex_index> ends;
    index_.certified = true;
    for (const auto& entry : entries_) {
      index_.pieces.push_back(*entry);
      index_.certified = index_.certified && entry->certified;
      index_.sites += entry->sites;
      index_.triangles += entry->triangles;
    }
    for (std::size_t e = 0; e < index_.cut.edges.size(); ++e) {
      const cut_edge& edge = index_.cut.edges[e];
      index_.sites -= index_.points[e].size();
      for (const vertex_index v : {edge.a, edge.b}) {
        ends.insert(v);
        for (const piece_index p : {edge.left, edge.right})
          if (p != no_piece) at_ends.emplace(v, p);
      }
    }
    index_.sites -= at_ends.size() - ends.size();
  }

  int conclude() const {
    const int status = index_.certified ? done : not_reached;
    if (!team_.is_first()) return status;
    if (job_.json) std::cout << summary(status);
    if (job_.tells()) std::cout << text_of_pieces(index_) << '\n';
    for (std::size_t p = 0; p < index_.pieces.size(); ++p)
      if (!index_.pieces[p].certified)
        return complain({fmt::format("not reached: piece {}: {}", p + 1, index_.pieces[p].reason)},
                        not_reached);
    return status;
  }

  std::string summary(int status) const {
    double worst = 180;
    for (const piece_entry& p : index_.pieces) worst = std::min(worst, p.worst_angle);
    const nlohmann::ordered_json object = {{"status", status},
                                           {"certified", index_.certified},
                                           {"pieces", index_.pieces.size()},
                                           {"vertices", index_.sites},
                                           {"triangles", index_.triangles},
                                           {"worst_angle", worst},
                                           {"rounds", index_.rounds},
                                           {"pieces_made", index_.made},
                                           {"index", files_.index_path().string()}};
    return object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
  }

  std::optional<error> agree(const std::optional<error>& failure) { return agreed(team_, failure); }

  int complain_once(const error& failure, exit_status status) const {
    return team_.is_first() ? complain(failure, status) : status;
  }

  const bool in_parts_;  // what is given of the metric
  mesh_job job_;
  prepared_input input_;  // without the metric, once its parts are written
  piece_team& team_;
  run_limits& limits_;
  const piece_files files_;
  pieces_index index_;
  std::vector<std::optional<piece_entry>> entries_;
  std::vector<piece_index> next_;  // pieces of the next round, ascending
  std::string question_;           // digest of what the whole run was asked
};

}  // namespace

int run_pieces_job(const mesh_job& asked, piece_team* given_team) {
  piece_team alone;
  piece_team& team = given_team != nullptr ? *given_team : alone;
  mesh_job job = asked;
  job.quiet = job.quiet || !team.is_first();
  const auto complain_once = [&team](const error& failure) {
    return team.is_first() ? complain(failure, refused) : static_cast<int>(refused);
  };
  if (const auto failure = check_job(job)) return complain_once(*failure);
  if (job.threads == 0 && team.size() > 1) job.threads = 1;  // a rank is a processor's
  const thread_limit threads(job.threads);
  run_limits limits(job.max_seconds, std::nullopt);
  const bool has_part = has_metric_in_parts(job) && !team.is_first();
  auto input = prepare(has_part ? without_metric(job) : job);
  if (const auto failure = agreed(team, input ? std::nullopt : std::optional(input.failure())))
    return complain_once(*failure);
  if (input.value().metric.complexity || !input.value().sizes.is_empty())
    job.size = input.value().metric.size;
  if (const auto failure = check_piece_places(job)) return complain_once(*failure);
  return pieces_run(std::move(job), std::move(input).value(), team, limits).run();
}

}  // namespace asterism::apps
