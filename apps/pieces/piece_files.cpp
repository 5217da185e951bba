// SPDX-License-Identifier: MIT
#include "asterism/apps/pieces/piece_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include "asterism/apps/job/job_words.hpp"
#include "asterism/apps/run/held_signals.hpp"
#include "asterism/apps/text/summary.hpp"
#include "asterism/apps/text/verdict_text.hpp"
#include "asterism/mesh/io/file_kinds.hpp"
#include "asterism/mesh/io/file_output.hpp"
#include "asterism/mesh/io/medit.hpp"
#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/mesh/io/render_mesh.hpp"
#include "asterism/mesh/pieces/partitioned_gmsh.hpp"
#include "asterism/mesh/pieces/pvtu.hpp"

namespace asterism::apps {
using namespace internal;
namespace fs = std::filesystem;
namespace {

std::string ending_of(const std::string& format) {
  return format.starts_with(".") ? format : fmt::format(".{}", format);
}

std::optional<std::string> bytes_in(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  return std::string((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
}

std::optional<error> written(const output_file& file) {
  pending_files files;
  if (auto failed = files.add(file)) return failed;
  const auto put = files.put_in_place();
  if (!put) return put.failure();
  return std::nullopt;
}

fs::path rounds_in(const fs::path& folder) { return folder / "rounds.json"; }

}  // namespace

fs::path index_in(const fs::path& folder) { return folder / "index.json"; }

std::optional<error> check_piece_formats(const std::vector<std::string>& endings) {
  for (const std::string& ending : endings) {
    const auto format = mesh_format_of("piece" + ending_of(ending));
    if (!format) return format.failure().at("--piece-format " + ending);
    if (format.value() == mesh_format::html)
      return error{"--piece-format html: a page is about a whole mesh", error_code::bad_option};
  }
  return std::nullopt;
}

std::optional<error> check_piece_places(const mesh_job& job) {
  const fs::path& folder = job.outputs[0];
  std::error_code ignored;
  if (fs::is_directory(folder, ignored)) return std::nullopt;
  if (folder.has_filename() && kind_of_file(folder.string()) != nullptr)
    return error{folder.string() +
                     ": with --pieces a folder is wanted, which a name like this would "
                     "hide; " +
                     fs::path(folder).replace_extension().string() + "/ is one",
                 error_code::bad_option};
  if (fs::exists(folder, ignored))
    return error{folder.string() + ": with --pieces a folder is wanted, and this is none",
                 error_code::unwritable_file};
  const fs::path whole = fs::absolute(folder / ".", ignored).lexically_normal();
  const fs::path parent = whole.parent_path().parent_path();
  if (fs::is_directory(parent, ignored)) return std::nullopt;
  return error{folder.string() + ": the folder " + parent.string() + " does not exist",
               error_code::unwritable_file};
}

std::string text_of_pieces(const pieces_index& index) {
  double worst = 180;
  for (const piece_entry& p : index.pieces) worst = std::min(worst, p.worst_angle);
  const std::size_t again = index.made - index.pieces.size();
  return fmt::format("{} pieces, {} sites, {} triangles, {}, {} made again for their seams: {}",
                     index.pieces.size(), index.sites, index.triangles, worst_angle_text(worst),
                     again, index.certified ? "certified" : "NOT certified");
}

piece_files::piece_files(const mesh_job& job, const prepared_input& input)
    : folder_(job.outputs[0]), pieces_(job.pieces), endings_{".mesh"} {
  for (const std::string& format : job.piece_formats)
    if (std::find(endings_.begin(), endings_.end(), ending_of(format)) == endings_.end())
      endings_.push_back(ending_of(format));
  names_ = names_in(job.domain);
  for (const repair_place& place : input.repairs.places) picture_.marks.push_back(place.at);
  picture_.ellipses = job.ellipses;
  picture_.angle_bound = job.refinement.angle_bound;
}

fs::path piece_files::file_of(piece_index p, const std::string& ending) const {
  return folder_ / name_of_piece(p, pieces_, ending);
}

std::optional<error> piece_files::prepare_folder() const {
  std::error_code failed;
  fs::create_directory(folder_, failed);
  if (failed) return error{folder_.string() + ": " + failed.message(), error_code::unwritable_file};
  const auto place = check_writable(index_path());
  if (!place) return place.failure();
  fs::remove(index_path(), failed);
  if (failed)
    return error{index_path().string() + ": " + failed.message(), error_code::unwritable_file};
  return std::nullopt;
}

result<std::uint64_t> piece_files::write_piece(piece_index p, const certified_mesh& made) const {
  write_options options;
  options.names = names_;
  options.picture = picture_;
  options.note = file_note_of(made.claim);
  const std::string certificate = certificate_text(made.claim);
  const held_signals held;
  pending_files files;
  for (const std::string& ending : endings_) {
    const auto rendered = render_mesh(file_of(p, ending), made.outcome.result, options);
    if (!rendered) return rendered.failure();
    for (const output_file& file : rendered.value())
      if (auto failed = files.add(file)) return *failed;
  }
  if (auto failed = files.add({file_of(p, ".certificate.json"), certificate})) return *failed;
  const auto put = files.put_in_place();
  if (!put) return put.failure();
  return digest_of(certificate);
}

std::optional<stored_piece> piece_files::read_piece(piece_index p,
                                                    const std::string& question) const {
  std::error_code ignored;
  for (const std::string& ending : endings_)
    for (const fs::path& file : files_of_output(file_of(p, ending)))
      if (!fs::is_regular_file(file, ignored)) return std::nullopt;
  const auto text = bytes_in(file_of(p, ".certificate.json"));
  if (!text) return std::nullopt;
  auto claim = parse_certificate(*text, "");
  if (!claim) return std::nullopt;
  const auto asked = claim.value().options.find("piece-question");
  if (asked == claim.value().options.end() || asked->second != question) return std::nullopt;
  auto subject = read_medit(file_of(p, ".mesh"));
  if (!subject || mesh_fingerprint(subject.value()) != claim.value().fingerprint)
    return std::nullopt;
  return stored_piece{std::move(subject).value(), std::move(claim).value(), digest_of(*text)};
}

std::optional<error> piece_files::write_rounds(const rounds_done& done) const {
  return written({rounds_in(folder_), rounds_text(done)});
}

std::optional<rounds_done> piece_files::read_rounds(std::size_t edges, std::size_t pieces) const {
  const auto text = bytes_in(rounds_in(folder_));
  if (!text) return std::nullopt;
  return parse_rounds(*text, edges, pieces);
}

std::optional<error> piece_files::write_metric(piece_index p, const metric_part& part) const {
  return written({file_of(p, ".metric"), bytes_of(part)});
}

result<std::unique_ptr<metric_field>> piece_files::read_metric(piece_index p) const {
  const fs::path path = file_of(p, ".metric");
  const auto bytes = bytes_in(path);
  if (!bytes) return error{path.string() + ": it cannot be read", error_code::unreadable_file};
  const auto part = metric_part_in(*bytes, path.string());
  if (!part) return part.failure();
  return make_field_of_part(part.value());
}

std::optional<error> piece_files::write_partitioned(const pieces_index& index) const {
  if (std::find(endings_.begin(), endings_.end(), ".msh") == endings_.end()) return std::nullopt;
  const auto piece = [&](piece_index p) {
    medit_read_options alone;
    alone.without_solution = true;
    return read_medit(file_of(p, ".mesh"), alone);
  };
  std::optional<error> failed;
  const auto write = [&](const byte_sink& put) {
    failed = write_partitioned_gmsh(index, names_, piece, put);
  };
  pending_files files;
  if (auto unwritten = files.add({folder_ / "pieces.msh", "", write})) return unwritten;
  if (failed) return failed;
  const auto put = files.put_in_place();
  return put ? std::nullopt : std::optional<error>(put.failure());
}

std::optional<error> piece_files::write_index(const pieces_index& index) const {
  if (std::find(endings_.begin(), endings_.end(), ".vtu") != endings_.end()) {
    std::vector<std::string> names;
    for (piece_index p = 0; p < pieces_; ++p) names.push_back(name_of_piece(p, pieces_, ".vtu"));
    if (auto failed = written({folder_ / "pieces.pvtu", pvtu_text(names)})) return failed;
  }
  if (auto failed = write_partitioned(index)) return failed;
  if (auto failed = written({index_path(), index_text(index)})) return failed;
  std::error_code ignored;
  fs::remove(rounds_in(folder_), ignored);
  for (piece_index p = 0; p < pieces_; ++p) fs::remove(file_of(p, ".metric"), ignored);
  return std::nullopt;
}

}  // namespace asterism::apps
