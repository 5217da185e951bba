// SPDX-License-Identifier: MIT
#include "asterism/apps/verify/verify_pieces_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "asterism/apps/base/complain.hpp"
#include "asterism/apps/base/terminal.hpp"
#include "asterism/apps/pieces/piece_files.hpp"
#include "asterism/apps/run/run_limits.hpp"
#include "asterism/apps/text/verdict_text.hpp"
#include "asterism/apps/verify/verify_domain.hpp"
#include "asterism/core/number_text.hpp"
#include "asterism/mesh/audit/same_domain.hpp"
#include "asterism/mesh/audit/verify.hpp"
#include "asterism/mesh/claims/field_claims.hpp"
#include "asterism/mesh/claims/measured_claims.hpp"
#include "asterism/mesh/io/medit.hpp"
#include "asterism/mesh/pieces/verify_pieces.hpp"
#include "asterism/mesh/pipeline/outcome_claims.hpp"
#include "asterism/mesh/support/one_line.hpp"

namespace asterism::apps {
using namespace internal;
namespace fs = std::filesystem;
namespace {

using sentences = std::vector<std::string>;

// The angle bound and the metric by which all pieces are judged.
struct pieces_question {
  double bound = 0;                     // degrees
  std::unique_ptr<metric_field> field;  // null where it could not be made again
  std::string metric_words;             // which metric, and who asked, for people
};

std::string read_bytes(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return std::string((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
}

// Returns the domain with segments and curves in an order that depends on their values alone:
// dividing curves may change their order.
domain in_order(domain d) {
  std::sort(d.segments.begin(), d.segments.end(), [](const segment& s, const segment& t) {
    return std::pair(s.a, s.b) < std::pair(t.a, t.b);
  });
  std::sort(d.curves.begin(), d.curves.end(),
            [](const domain_curve& c, const domain_curve& e) { return c.vertices < e.vertices; });
  return d;
}

// Compares the domain of the index with the one that is named, if one is.
std::optional<error> compare_domain(const verify_options& options, const pieces_index& index,
                                    sentences& faults) {
  if (options.domain.empty()) return std::nullopt;
  mesh given;  // its first sites, random points among them, are the domain's vertices
  for (const point& q : index.original.vertices) given.sites.push_back({q, {1, 0, 1}});
  given.given = static_cast<vertex_index>(given.sites.size());
  certificate claim;  // says how curves were divided, and what was repaired
  claim.original = index.original;
  claim.options = index.options;
  const auto asked = find_domain(options, given, claim);
  if (!asked) return asked.failure();
  for (const std::string& said : asked.value().contradictions) faults.push_back(said);
  if (!is_same_domain(in_order(*asked.value().shape), in_order(index.original)))
    faults.push_back("the index is of another domain than " + options.domain);
  return std::nullopt;
}

// Makes the metric that --metric names, or else the one that the index names.
std::optional<error> ask_metric(const verify_options& options, const pieces_index& index,
                                pieces_question& asked) {
  certificate words;  // of the question alone
  words.metric = options.metric.empty() ? index.metric : options.metric;
  words.options = index.options;
  auto wording = wording_in(words);
  if (!wording) return wording.failure().at("index");
  if (options.size) wording.value().size = *options.size;
  if (options.gradation) wording.value().gradation = *options.gradation;
  auto field = field_of(wording.value(), index.original);
  if (field) {
    asked.field = std::move(field).value();
    asked.metric_words = words.metric + (options.metric.empty() ? ", by the index" : "") +
                         ", compared at every vertex";
    return std::nullopt;
  }
  if (!options.metric.empty()) return field.failure().at("--metric");
  asked.metric_words = words.metric + ", by the index, not made again: " + field.failure().message;
  return std::nullopt;
}

// Returns the contradictions in the results of one piece.
sentences judge_piece(const verify_options& options, const pieces_index& index, piece_index p,
                      const pieces_question& asked, const mesh& subject, const certificate& claim,
                      const cancellation& stop) {
  audit_options questions;
  questions.angle_bound = asked.bound;
  questions.stop = stop;
  questions.findings_kept = options.all_findings ? std::size_t(-1) : 10;
  const verify_report verdict = verify(subject, claim, questions);
  sentences faults = verdict.contradictions;
  for (const audit_finding& f : verdict.audit.findings) faults.push_back(f.witness);
  if (!verdict.verified && faults.empty()) faults.emplace_back("its audit does not certify it");
  for (auto& all : {contradictions_in_measured(subject, claim), contradictions_in_outcome(claim)})
    faults.insert(faults.end(), all.begin(), all.end());
  if (asked.field) {
    const field_check check = check_against(subject, *asked.field, asked.bound);
    faults.insert(faults.end(), check.contradictions.begin(), check.contradictions.end());
    if (check.apart)
      faults.push_back(fmt::format("its metric is {} from {}", format_number(check.apart->greatest),
                                   asked.metric_words));
  }
  for (std::string& fault : faults_of_piece(index, p, subject, claim))
    faults.push_back(std::move(fault));
  return faults;
}

sentences check_piece(const verify_options& options, const pieces_index& index, piece_index p,
                      const pieces_question& asked, const cancellation& stop) {
  const piece_entry& entry = index.pieces[p];
  const fs::path folder = options.mesh;
  std::error_code ignored;
  for (const std::string& name : {entry.mesh, entry.certificate})
    if (!fs::is_regular_file(folder / name, ignored)) return {name + " is missing"};
  auto subject = read_medit(folder / entry.mesh);
  if (!subject) return {subject.failure().message};
  const std::string text = read_bytes(folder / entry.certificate);
  if (digest_of(text) != entry.digest)
    return {entry.certificate + " is not the one of the index: the digests differ"};
  const auto claim = parse_certificate(text, entry.certificate);
  if (!claim) return {claim.failure().message};
  return judge_piece(options, index, p, asked, subject.value(), claim.value(), stop);
}

// Judges this member's pieces, and returns the contradictions of all pieces, in their order.
sentences check_pieces(const verify_options& options, const pieces_index& index,
                       const pieces_question& asked, piece_team& team, const run_limits& limits) {
  const cancellation stop = [&limits] { return limits.reason(); };
  nlohmann::json mine = nlohmann::json::array();
  for (std::size_t p = team.rank(); p < index.pieces.size(); p += team.size()) {
    const auto why = limits.reason();
    const sentences found =
        why ? sentences{"it was not looked at: " + *why}
            : check_piece(options, index, static_cast<piece_index>(p), asked, stop);
    if (!found.empty()) mine.push_back({p, found});
  }
  std::vector<std::pair<std::size_t, sentences>> all;
  const auto replace = nlohmann::json::error_handler_t::replace;
  for (const std::string& text : team.gather(mine.dump(-1, ' ', false, replace)))
    for (const auto& one : nlohmann::json::parse(text))
      all.emplace_back(one.at(0).get<std::size_t>(), one.at(1).get<sentences>());
  std::sort(all.begin(), all.end());
  sentences faults;
  for (const auto& [p, found] : all)
    for (const std::string& fault : found)
      faults.push_back(fmt::format("piece {}: {}", p + 1, fault));
  return faults;
}

int tell(const verify_options& options, const pieces_index& index, const pieces_question& asked,
         const sentences& faults) {
  const bool verified = faults.empty();
  const int status = verified ? done : not_reached;
  const std::string scope =
      fmt::format("bound {} degrees{}; {}; metric: {}; each piece, and all seams", asked.bound,
                  options.angle_bound ? "" : ", by the index",
                  options.domain.empty() ? "the index's domain" : "domain " + options.domain,
                  asked.metric_words);
  if (options.json) {
    const nlohmann::ordered_json object = {
        {"status", status},        {"certified", verified},        {"pieces", index.pieces.size()},
        {"vertices", index.sites}, {"triangles", index.triangles}, {"scope", scope},
        {"refusals", faults}};
    std::cout << object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace)
              << '\n';
    return status;
  }
  for (const std::string& fault : faults) std::cout << one_line(fault) << '\n';
  std::cout << (verified ? in_colour("certified", ink::green, 1)
                         : in_colour("REFUSED", ink::red, 1))
            << ": " << text_of_pieces(index) << "; " << one_line(scope) << '\n';
  return status;
}

// Adds the contradictions between the pieces and the numbers of the whole.
void compare_totals(const pieces_index& index, sentences& faults) {
  std::size_t triangles = 0;
  bool certified = true;
  for (const piece_entry& p : index.pieces) {
    triangles += p.triangles;
    certified = certified && p.certified;
  }
  if (triangles != index.triangles)
    faults.emplace_back("the index's number of triangles is not that of its pieces");
  if (!certified || !index.certified)
    faults.emplace_back("the index itself says that its mesh was not certified");
}

}  // namespace

bool is_of_pieces(const verify_options& options) {
  std::error_code ignored;
  return fs::is_directory(options.mesh, ignored);
}

int run_verify_pieces(const verify_options& options, piece_team* given_team) {
  piece_team alone;
  piece_team& team = given_team != nullptr ? *given_team : alone;
  run_limits limits(options.max_seconds, std::nullopt);
  const auto complain_once = [&team](const error& failure) {
    return team.is_first() ? complain(failure, refused) : static_cast<int>(refused);
  };
  if (!is_of_pieces(options))
    return complain_once({options.mesh.string() + ": asterism-mpi verifies folders of pieces"});
  if (!options.certificate.empty() || options.prove_voronoi || options.metric_tolerance ||
      !options.periodic.empty())
    return complain_once({options.mesh.string() +
                          ": a folder of pieces is verified without --certificate, --voronoi, "
                          "--metric-tolerance and --periodic"});
  const auto index = read_index(index_in(options.mesh));
  if (!index) return complain_once(index.failure());
  pieces_question asked;
  asked.bound = options.angle_bound.value_or(index.value().angle_bound);
  sentences faults = faults_of_index(index.value());
  compare_totals(index.value(), faults);
  if (const auto failed = compare_domain(options, index.value(), faults))
    return complain_once(*failed);
  if (const auto failed = ask_metric(options, index.value(), asked)) return complain_once(*failed);
  for (std::string& fault : check_pieces(options, index.value(), asked, team, limits))
    faults.push_back(std::move(fault));
  limits.conclude();
  if (!team.is_first()) return faults.empty() ? done : not_reached;
  return tell(options, index.value(), asked, faults);
}

}  // namespace asterism::apps
