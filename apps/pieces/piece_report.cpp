// SPDX-License-Identifier: MIT
#include "asterism/apps/pieces/piece_report.hpp"

#include <nlohmann/json.hpp>

namespace asterism::apps {
using namespace internal;
namespace {

using report_json = nlohmann::json;  // not the ordered kind of other files

report_json json_of(const piece_report& r) {
  report_json asked = report_json::array();
  for (const seam_in_mesh& seam : r.asked) {
    report_json points = report_json::array();
    for (const point& q : seam.points) points.push_back({q.x, q.y});
    asked.push_back({seam.edge, std::move(points)});
  }
  return {{"piece", r.piece},
          {"mesh", r.entry.mesh},
          {"certificate", r.entry.certificate},
          {"fingerprint", r.entry.fingerprint},
          {"digest", r.entry.digest},
          {"sites", r.entry.sites},
          {"triangles", r.entry.triangles},
          {"worst", r.entry.worst_angle},
          {"certified", r.entry.certified},
          {"reason", r.entry.reason},
          {"asked", std::move(asked)},
          {"digests", r.digests},
          {"failure", r.failure}};
}

piece_report report_of(const report_json& object) {
  piece_report r;
  r.piece = object.at("piece").get<piece_index>();
  r.entry.mesh = object.at("mesh").get<std::string>();
  r.entry.certificate = object.at("certificate").get<std::string>();
  r.entry.fingerprint = object.at("fingerprint").get<std::uint64_t>();
  r.entry.digest = object.at("digest").get<std::uint64_t>();
  r.entry.sites = object.at("sites").get<std::size_t>();
  r.entry.triangles = object.at("triangles").get<std::size_t>();
  r.entry.worst_angle = object.at("worst").get<double>();
  r.entry.certified = object.at("certified").get<bool>();
  r.entry.reason = object.at("reason").get<std::string>();
  for (const report_json& seam : object.at("asked")) {
    seam_in_mesh one{seam.at(0).get<std::size_t>(), {}};
    for (const report_json& q : seam.at(1))
      one.points.push_back({q.at(0).get<double>(), q.at(1).get<double>()});
    r.asked.push_back(std::move(one));
  }
  r.digests = object.at("digests").get<std::vector<std::pair<std::size_t, std::uint64_t>>>();
  r.failure = object.at("failure").get<std::string>();
  return r;
}

}  // namespace

std::string text_of(const std::vector<piece_report>& reports) {
  report_json all = report_json::array();
  for (const piece_report& r : reports) all.push_back(json_of(r));
  return all.dump(-1, ' ', false, report_json::error_handler_t::replace);
}

std::vector<piece_report> reports_of(const std::string& text) {
  std::vector<piece_report> reports;
  for (const report_json& object : report_json::parse(text)) reports.push_back(report_of(object));
  return reports;
}

}  // namespace asterism::apps
