// SPDX-License-Identifier: MIT
#include "asterism/apps/verify/verify_domain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "asterism/apps/base/notes.hpp"
#include "asterism/core/number_text.hpp"
#include "asterism/mesh/audit/same_domain.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/domain/convex_hull.hpp"
#include "asterism/mesh/domain/divide_curves.hpp"
#include "asterism/mesh/domain/point_in_domain.hpp"
#include "asterism/mesh/domain/repair_domain.hpp"
#include "asterism/mesh/io/edges_domain.hpp"
#include "asterism/mesh/io/load_domain.hpp"
#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/mesh/pipeline/read_triangulation.hpp"

namespace asterism::apps {
using namespace internal;
namespace {

// Returns the distance within which the domain was repaired, by the certificate; none if it was
// not.
result<std::optional<double>> repair_claimed(const std::optional<certificate>& claim) {
  if (!claim) return std::optional<double>();
  const auto found = claim->options.find("repair-distance");
  if (found == claim->options.end() || found->second == "none") return std::optional<double>();
  const auto distance = parse_number(found->second);
  if (!distance) return distance.failure().at("certificate: repair-distance");
  return std::optional(distance.value());
}

// Divides the curves of the domain as the certificate states.
result<domain> divided_as_claimed(const domain& d, const std::optional<certificate>& claim) {
  if (!claim || !claim->original || d.curves.empty()) return divide_curves(d);
  std::vector<std::vector<double>> parameters;
  for (const domain_curve& c : claim->original->curves) parameters.push_back(c.parameters);
  return divide_curves_at(d, parameters);
}

// Takes the domain repaired within the distance.
std::optional<error> take_repaired(const domain& d, double distance, asked_by who,
                                   asked_domain& asked) {
  domain_repairs repairs;
  auto repaired = repair_domain(d, distance, &repairs);
  if (!repaired) return repaired.failure();
  asked.shape = std::move(repaired).value();
  asked.repaired_by = who;
  asked.distance = distance;
  asked.greatest_move = repairs.greatest_move;
  return std::nullopt;
}

// Contradicts a certificate of a repaired domain, if the domain is valid without the repair and the
// repair changes it.
void contradict_repair(const domain& d, double distance, asked_domain& asked) {
  domain_repairs repairs;
  const auto repaired = repair_domain(d, distance, &repairs);
  if (repaired && is_same_domain(repaired.value(), *asked.shape)) return;
  const std::string moved =
      repaired ? fmt::format(", which moves it by up to {}", format_number(repairs.greatest_move))
               : "";
  asked.contradictions.push_back(
      fmt::format("the certificate is of {} as repaired within {}{}, and {} is a domain as it "
                  "stands; --repair-distance {} asks for the repaired one",
                  asked.name, format_number(distance), moved, asked.name, number_text(distance)));
}

std::optional<error> put_in_order(const domain& d, const verify_options& options,
                                  const std::optional<certificate>& claim, asked_domain& asked) {
  // Repairs no domain with curves, as `mesh` does not either.
  if (options.repair_distance && d.curves.empty())
    return take_repaired(d, *options.repair_distance, asked_by::option, asked);
  const auto claimed = repair_claimed(claim);
  if (!claimed) return claimed.failure();
  const auto divided = divided_as_claimed(d, claim);
  if (!divided) return divided.failure();
  auto checked = check_domain(divided.value());
  if (checked) {
    asked.shape = std::move(checked).value();
    if (claimed.value()) contradict_repair(d, *claimed.value(), asked);
    return std::nullopt;
  }
  if (!claimed.value()) return checked.failure();
  return take_repaired(d, *claimed.value(), asked_by::certificate, asked);
}

result<domain> load(const verify_options& options) {
  auto loaded = load_domain(options.domain);
  if (!loaded) return loaded;
  if (options.convex_hull) loaded = with_convex_hull(std::move(loaded).value());
  if (!loaded) return loaded;
  if (auto refused = say_notes(loaded.value().origin.notes, {})) return *refused;
  if (options.number_regions) loaded.value().number_all_regions = true;
  return loaded;
}

std::optional<error> read_domain(const verify_options& options,
                                 const std::optional<certificate>& claim, asked_domain& asked) {
  const bool is_mesh_name = is_mesh_file(options.domain);
  auto read = is_mesh_name ? read_mesh_file(options.domain, {.without_solution = true})
                           : result<mesh_file>(mesh_file{});
  if (!read) return read.failure();
  if (!is_mesh_name || has_edges_alone(read.value())) {
    const auto loaded = load(options);
    if (!loaded) return loaded.failure();
    return put_in_order(loaded.value(), options, claim, asked);
  }
  if (options.repair_distance)
    return error{"--repair-distance: " + options.domain +
                 " is a mesh, whose edges are kept as they are"};
  auto adopted =
      checked_triangulation(std::move(read.value().content), options.domain, slit_rule::joined);
  if (!adopted) return adopted.failure();
  if (auto refused = say_notes(adopted.value().subject.notes, {})) return refused;
  asked.shape = std::move(adopted.value().shape);
  return std::nullopt;
}

}  // namespace

result<asked_domain> find_domain(const verify_options& options, const mesh& subject,
                                 const std::optional<certificate>& claim) {
  asked_domain asked;
  if (options.domain.empty()) {
    if (claim && claim->original) asked.by = asked_by::certificate;
    return asked;
  }
  asked.by = asked_by::option;
  asked.name = options.domain;
  if (auto failed = read_domain(options, claim, asked)) return *failed;
  const domain bare = *asked.shape;
  const std::size_t given = std::min<std::size_t>(subject.given, subject.sites.size());
  for (std::size_t v = bare.vertices.size(); v < given; ++v)
    if (contains(bare, subject.sites[v].position))
      asked.shape->vertices.push_back(subject.sites[v].position);
  return asked;
}

std::string text_of(const asked_domain& asked, const std::optional<certificate>& claim) {
  if (asked.by == asked_by::nobody)
    return "no domain to compare with but what the boundary encloses";
  if (asked.by == asked_by::certificate) {
    const auto claimed = repair_claimed(claim);
    return claimed && claimed.value()
               ? fmt::format("the certificate's domain, which it says was repaired within {}",
                             format_number(*claimed.value()))
               : "the certificate's domain";
  }
  if (asked.repaired_by == asked_by::nobody) return "domain " + asked.name;
  return fmt::format("domain {} as repaired by up to {} (within {}{})", asked.name,
                     format_number(asked.greatest_move), format_number(asked.distance),
                     by_text(asked.repaired_by));
}

}  // namespace asterism::apps
