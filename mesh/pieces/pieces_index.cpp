// SPDX-License-Identifier: MIT
#include "asterism/mesh/pieces/pieces_index.hpp"

#include <fmt/format.h>

#include <exception>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "asterism/mesh/io/certificate_json.hpp"
#include "asterism/mesh/io/certificate_writer.hpp"
#include "asterism/mesh/io/json_places.hpp"
#include "asterism/mesh/io/json_values.hpp"
#include "asterism/mesh/io/text_scanner.hpp"

namespace asterism::internal {
namespace {

using json = nlohmann::ordered_json;

constexpr const char* index_format = "asterism pieces 1";
constexpr std::size_t deepest = 8;  // lists and objects in each other

std::size_t from_one(std::uint32_t number, std::uint32_t none) {
  return number == none ? 0 : std::size_t{number} + 1;
}

json cut_json(const domain_cut& cut) {
  json edges = json::array(), loose = json::array();
  for (const cut_edge& e : cut.edges)
    edges.push_back({std::size_t{e.a} + 1, std::size_t{e.b} + 1, e.marker,
                     from_one(e.segment, no_segment), e.left_region, e.right_region,
                     from_one(e.left, no_piece), from_one(e.right, no_piece)});
  for (vertex_index v = 0; v < cut.piece_of_loose.size(); ++v)
    if (cut.piece_of_loose[v] != no_piece)
      loose.push_back({std::size_t{v} + 1, std::size_t{cut.piece_of_loose[v]} + 1});
  return {{"marker", cut.marker},
          {"vertices", points_json({cut.vertices.begin() + cut.given, cut.vertices.end()})},
          {"edges", std::move(edges)},
          {"loose_vertices", std::move(loose)}};
}

json seams_json(const seam_points& points, const seam_digests* digests) {
  json all = json::array();
  for (std::size_t e = 0; e < points.size(); ++e) {
    const bool is_digested = digests != nullptr && (*digests)[e] != 0;
    if (points[e].empty() && !is_digested) continue;
    json one = {{"edge", e + 1}, {"points", points_json(points[e])}};
    if (is_digested) one["digest"] = digest_text((*digests)[e]);
    all.push_back(std::move(one));
  }
  return all;
}

json entry_json(const piece_entry& p) {
  return {{"mesh", p.mesh},
          {"certificate", p.certificate},
          {"fingerprint", digest_text(p.fingerprint)},
          {"certificate_digest", digest_text(p.digest)},
          {"vertices", p.sites},
          {"triangles", p.triangles},
          {"worst_angle", p.worst_angle < 180 ? json(p.worst_angle) : json(nullptr)},
          {"certified", p.certified},
          {"reason", p.reason}};
}

json index_json(const pieces_index& index) {
  json pieces = json::array();
  for (const piece_entry& p : index.pieces) pieces.push_back(entry_json(p));
  return {
      {"format", index_format},
      {"version", index.version},
      {"asked",
       {{"metric", index.metric}, {"angle_bound", index.angle_bound}, {"options", index.options}}},
      {"outcome",
       {{"certified", index.certified},
        {"rounds", index.rounds},
        {"pieces_made", index.made},
        {"vertices", index.sites},
        {"triangles", index.triangles}}},
      {"domain", domain_json(index.original, domain_rows::with_sides)},
      {"cut", cut_json(index.cut)},
      {"seams", seams_json(index.points, &index.digests)},
      {"pieces", std::move(pieces)}};
}

std::uint32_t index_of(const json& number, std::size_t count, const char* what, bool may_be_none) {
  const std::uint32_t none = no_piece;
  if (number.is_number_unsigned()) {
    const auto value = number.get<std::uint64_t>();
    if (value == 0 && may_be_none) return none;
    if (value >= 1 && value <= count) return static_cast<std::uint32_t>(value - 1);
  }
  throw malformed(what, std::string("\"") + what + "\" names one that is not there");
}

domain_cut cut_of(const json& object, const domain& d, std::size_t pieces) {
  domain_cut cut;
  cut.pieces = pieces;
  cut.given = static_cast<vertex_index>(d.vertices.size());
  cut.vertices = d.vertices;
  for (const point& q : points_of(object, "vertices")) cut.vertices.push_back(q);
  cut.marker = object.at("marker").get<int>();
  for (const json& e : object.at("edges")) {
    if (!e.is_array() || e.size() != 8)
      throw malformed("edges", "an edge is no list of eight numbers");
    cut_edge made;
    made.a = index_of(e[0], cut.vertices.size(), "edges", false);
    made.b = index_of(e[1], cut.vertices.size(), "edges", false);
    made.marker = e[2].get<int>();
    made.segment = index_of(e[3], d.segments.size(), "edges", true);
    made.left_region = e[4].get<int>();
    made.right_region = e[5].get<int>();
    made.left = index_of(e[6], pieces, "edges", true);
    made.right = index_of(e[7], pieces, "edges", true);
    cut.edges.push_back(made);
  }
  cut.piece_of_loose.assign(cut.given, no_piece);
  for (const json& l : object.at("loose_vertices"))
    cut.piece_of_loose[index_of(l.at(0), cut.given, "loose_vertices", false)] =
        index_of(l.at(1), pieces, "loose_vertices", false);
  return cut;
}

void read_seams(const json& list, std::size_t edges, seam_points& points, seam_digests* digests) {
  points.assign(edges, {});
  if (digests != nullptr) digests->assign(edges, 0);
  for (const json& one : list) {
    const std::uint32_t e = index_of(one.at("edge"), edges, "seams", false);
    points[e] = points_of(one, "points");
    if (digests != nullptr && one.contains("digest")) (*digests)[e] = digest_in(one, "digest");
  }
}

piece_entry entry_of(const json& object) {
  piece_entry p;
  p.mesh = object.at("mesh").get<std::string>();
  p.certificate = object.at("certificate").get<std::string>();
  p.fingerprint = digest_in(object, "fingerprint");
  p.digest = digest_in(object, "certificate_digest");
  p.sites = object.at("vertices").get<std::size_t>();
  p.triangles = object.at("triangles").get<std::size_t>();
  if (!object.at("worst_angle").is_null()) p.worst_angle = object.at("worst_angle").get<double>();
  p.certified = object.at("certified").get<bool>();
  p.reason = object.at("reason").get<std::string>();
  return p;
}

pieces_index index_of(const json& root) {
  if (!root.is_object() || !root.contains("format") || root.at("format") != index_format)
    throw malformed("format", std::string("this is not an \"") + index_format + "\"");
  pieces_index index;
  index.version = root.at("version").get<std::string>();
  const json &asked = root.at("asked"), &outcome = root.at("outcome");
  index.metric = asked.at("metric").get<std::string>();
  index.angle_bound = asked.at("angle_bound").get<double>();
  index.options = asked.at("options").get<std::map<std::string, std::string>>();
  index.certified = outcome.at("certified").get<bool>();
  index.rounds = outcome.at("rounds").get<std::size_t>();
  index.made = outcome.at("pieces_made").get<std::size_t>();
  index.sites = outcome.at("vertices").get<std::size_t>();
  index.triangles = outcome.at("triangles").get<std::size_t>();
  for (const json& p : root.at("pieces")) index.pieces.push_back(entry_of(p));
  index.original = domain_of(root.at("domain"));
  for (const domain_curve& c : index.original.curves)
    if (c.vertices.size() < 2 || c.vertices.size() != c.parameters.size())
      throw malformed("curves", "a curve has not as many parameters as vertices");
  index.cut = cut_of(root.at("cut"), index.original, index.pieces.size());
  read_seams(root.at("seams"), index.cut.edges.size(), index.points, &index.digests);
  return index;
}

// Writes lists of numbers on one line each, so that the file can be read by people.
std::string text_of(const json& root) {
  std::string text = "{\n";
  for (auto item = root.begin(); item != root.end(); ++item) {
    text += fmt::format(" {}: ", json(item.key()).dump());
    if (item->is_array() && !item->empty()) {
      text += "[\n";
      for (std::size_t i = 0; i < item->size(); ++i)
        text += fmt::format("  {}{}\n", (*item)[i].dump(), i + 1 < item->size() ? "," : "");
      text += " ]";
    } else {
      text += item->dump();
    }
    text += std::next(item) != root.end() ? ",\n" : "\n";
  }
  return text + "}\n";
}

json with_digest(json root) {
  root["digest"] = digest_text(digest_of(root.dump()));
  return root;
}

}  // namespace

std::uint64_t digest_of(const std::string& bytes) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return hash;
}

std::string index_text(const pieces_index& index) {
  return text_of(with_digest(index_json(index)));
}

result<pieces_index> parse_index(const std::string& text, const std::string& name) {
  if (line_nested_beyond(text, deepest))
    return error{name + ": lists and objects are too deep in each other"};
  if (const auto places = find_json_places(text); places.repeated || places.beyond_doubles)
    return error{name + (places.repeated ? ": \"" + places.repeated->name + "\" is there twice"
                                         : ": a number is no double")};
  try {
    const json root = json::parse(text);
    pieces_index index = index_of(root);
    // Compares the index read with its text: a difference means an invalid text.
    const json written = with_digest(index_json(index));
    if (root.value("digest", std::string()) != written.at("digest").get<std::string>())
      return error{name + ": it was edited: it is not what its digest was made of"};
    if (root != written) return error{name + ": it holds something that no index holds"};
    return index;
  } catch (const malformed& what) {
    return error{name + ": " + what.what()};
  } catch (const json::parse_error& what) {
    return error{fmt::format("{}:{}: this is not JSON", name, line_of_byte(text, what.byte))};
  } catch (const json::exception& what) {
    return error{name + ": this is no index of pieces: " + what.what()};
  }
}

result<pieces_index> read_index(const std::filesystem::path& path) {
  const auto text = read_text_file(path);
  if (!text) return text.failure();
  return parse_index(text.value(), path.string());
}

std::string name_of_piece(piece_index piece, std::size_t pieces, const std::string& ending) {
  const std::string number = std::to_string(std::size_t{piece} + 1);
  const std::size_t width = std::to_string(pieces).size();
  return fmt::format("piece_{:0>{}}{}", number, width, ending);
}

std::string rounds_text(const rounds_done& done) {
  json next = json::array();
  for (const piece_index p : done.next) next.push_back(std::size_t{p} + 1);
  return text_of(with_digest({{"format", "asterism rounds 1"},
                              {"question", done.question},
                              {"rounds", done.rounds},
                              {"pieces_made", done.made},
                              {"next", std::move(next)},
                              {"seams", seams_json(done.points, nullptr)}}));
}

std::optional<rounds_done> parse_rounds(const std::string& text, std::size_t edges,
                                        std::size_t pieces) {
  try {
    json root = json::parse(text);
    json bare = root;
    bare.erase("digest");
    if (with_digest(bare) != root) return std::nullopt;
    rounds_done done;
    done.question = root.at("question").get<std::string>();
    done.rounds = root.at("rounds").get<std::size_t>();
    done.made = root.at("pieces_made").get<std::size_t>();
    for (const json& p : root.at("next")) done.next.push_back(index_of(p, pieces, "next", false));
    read_seams(root.at("seams"), edges, done.points, nullptr);
    return done;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace asterism::internal
