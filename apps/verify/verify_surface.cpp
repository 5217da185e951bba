// SPDX-License-Identifier: MIT
#include "asterism/apps/verify/verify_surface.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <system_error>
#include <vector>

#include "asterism/apps/base/complain.hpp"
#include "asterism/apps/text/surface_summary.hpp"
#include "asterism/apps/text/verify_question.hpp"
#include "asterism/apps/verify/surface_input.hpp"
#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/text_scanner.hpp"
#include "asterism/mesh/support/one_line.hpp"
#include "asterism/mesh/surface/unit_patches.hpp"
#include "asterism/mesh/surface_audit/shell_numbers.hpp"
#include "asterism/mesh/surface_audit/shell_triangles.hpp"
#include "asterism/mesh/surface_io/shell_certificate.hpp"
#include "asterism/mesh/surface_io/space_mesh_reader.hpp"

namespace asterism::apps {
using namespace internal;
namespace fs = std::filesystem;
namespace {

bool same_patch(const surface_patch& a, const surface_patch& b) {
  return a.degree_u == b.degree_u && a.degree_v == b.degree_v && a.count_u == b.count_u &&
         a.count_v == b.count_v && a.knots_u == b.knots_u && a.knots_v == b.knots_v &&
         a.control == b.control && a.loops == b.loops;
}

bool same_surface(const surface& a, const surface& b) {
  bool same = a.patches.size() == b.patches.size();
  for (std::size_t k = 0; same && k < a.patches.size(); ++k)
    same = same_patch(a.patches[k], b.patches[k]);
  return same;
}

// Compares the triangles of the file with those of the certificate.
std::vector<std::string> differences(const space_mesh& file, const space_mesh& claimed) {
  if (file.triangles.size() != claimed.triangles.size())
    return {fmt::format("the mesh has {} triangles, the certificate {}", file.triangles.size(),
                        claimed.triangles.size())};
  for (std::size_t t = 0; t < file.triangles.size(); ++t) {
    if (file.triangles[t] != claimed.triangles[t])
      return {fmt::format("triangle {} has other vertices than the certificate says", t + 1)};
    // Compares no numbers of faces where the format has no place for them.
    if (!file.faces.empty() && file.faces[t] != claimed.faces[t] + 1)
      return {fmt::format("triangle {} is of another face than the certificate says", t + 1)};
  }
  return {};
}

// Compares the results of the proof with those that the certificate states.
std::vector<std::string> contradictions(const shell_report& now, const shell_certificate& c) {
  std::vector<std::string> all;
  const auto hold = [&](const char* what, auto found, auto claimed) {
    if (found != claimed)
      all.push_back(fmt::format("{}: {} is claimed, {} was found", what, claimed, found));
  };
  const shell_report& said = c.report;
  hold("certified", now.certified, said.certified);
  const auto hold_number = [&](const char* /*in files*/, const char* what, auto member) {
    hold(what, now.*member, said.*member);
  };
  visit_numbers(hold_number);
  visit_trim_numbers(hold_number);
  return all;
}

int tell(const verify_options& options, const shell_certificate& c, const shell_report& found,
         const std::vector<std::string>& against) {
  const bool verified = found.certified && against.empty();
  const int status = verified ? done : not_reached;
  if (options.json) {
    shell_report all = found;
    all.findings.insert(all.findings.end(), against.begin(), against.end());
    all.certified = verified;
    std::cout << json_of(all, c.asked, c.complete, c.reason, status);
    return status;
  }
  for (const std::string& sentence : against)
    std::cout << "certificate: " << one_line(sentence) << '\n';
  for (const std::string& sentence : found.findings) std::cout << one_line(sentence) << '\n';
  std::cout << (verified ? in_colour("certified", ink::green, 1) + ": "
                         : in_colour("REFUSED", ink::red, 1) + ": ")
            << text_of(found, c.asked) << '\n';
  return status;
}

int judge(const verify_options& options, const std::string& text, const fs::path& path) {
  if (!options.metric.empty() || options.repair_distance || options.number_regions ||
      options.prove_voronoi || !options.periodic.empty())
    return complain({options.mesh.string() + ": this is a mesh of a surface: of its question "
                                             "--domain and --angle-bound can be named",
                     error_code::bad_option},
                    refused);
  if (has_ending(options.mesh.string(), ".stl"))
    return complain(
        {options.mesh.string() +
             ": .stl has corners of triangles and no vertices, which the certificate "
             "numbers; `asterism surface` writes .mesh, .obj, .ply, .msh and .vtu, too, and "
             "`asterism deviation` judges this file",
         error_code::bad_option},
        refused);
  auto read = parse_shell_certificate(text, path.string());
  if (!read) return complain(read.failure(), refused);
  shell_certificate& c = read.value();
  auto mesh = read_space_mesh(options.mesh);
  if (!mesh) return complain(mesh.failure(), refused);
  std::vector<std::string> against;
  if (!options.domain.empty()) {
    const auto wanted = find_surface(options.domain);
    if (!wanted) return complain(wanted.failure(), refused);
    if (!same_surface(with_unit_patches(wanted.value()), with_unit_patches(c.of)))
      against.emplace_back("its surface is not the one named by --domain");
  }
  if (options.angle_bound) c.asked.angle_bound = *options.angle_bound;
  c.shell.points = mesh.value().points;
  const auto found = audit_shell(c.of, c.shell, c.asked);
  if (!found) return complain(found.failure().at(path.string()), refused);
  for (std::string& sentence : differences(mesh.value(), mesh_of(c.shell, triangles_of(c.shell))))
    against.push_back(std::move(sentence));
  for (std::string& sentence : contradictions(found.value(), c))
    against.push_back(std::move(sentence));
  return tell(options, c, found.value(), against);
}

// True for .obj and .ply, which contain no plane meshes; .stl and others may.
bool is_mesh_in_space(const fs::path& file) {
  return has_ending(file.string(), ".obj") || has_ending(file.string(), ".ply");
}

}  // namespace

std::optional<int> verify_surface(const verify_options& options) {
  fs::path path = options.certificate;
  if (path.empty()) path = fs::path(options.mesh).replace_extension(".certificate.json");
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) {
    if (!is_mesh_in_space(options.mesh)) return std::nullopt;
    return complain(
        {options.mesh.string() +
             ": a mesh in space, without a certificate: `asterism surface` writes one beside "
             "a .mesh, and where --certificate says; `asterism deviation` judges this file",
         error_code::bad_option},
        refused);
  }
  const auto text = read_text_file(path);
  if (!text || !is_shell_certificate(text.value())) return std::nullopt;
  return judge(options, text.value(), path);
}

}  // namespace asterism::apps
