// SPDX-License-Identifier: MIT
#include "asterism/apps/verify/verify_subject.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "asterism/apps/options/second_order_text.hpp"
#include "asterism/core/number_text.hpp"
#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/mesh/pipeline/chain_segments.hpp"
#include "asterism/mesh/pipeline/frozen_regions.hpp"

namespace asterism::apps {
using namespace internal;
namespace {

bool is_medit(const verify_options& options) {
  const std::string name = options.mesh.string();
  return !is_mesh_file(name) || has_ending(name, ".mesh") || has_ending(name, ".meshb");
}

std::string claimed_text(const second_order_report& r) {
  return fmt::format("{} triangles, {} curved sides, {} on curves, a Jacobian of at least {}",
                     r.triangles, r.curved_sides, r.on_curves, format_number(r.least_jacobian));
}

}  // namespace

std::optional<error> take_frozen(const std::optional<certificate>& claim, judged_mesh& subject,
                                 std::vector<std::string>& contradictions) {
  if (!claim || claim->options.count("frozen") == 0) return std::nullopt;
  const std::string& list = claim->options.at("frozen");
  const auto word = [&claim](const char* name) {
    const auto at = claim->options.find(name);
    return at == claim->options.end() ? std::string("none") : at->second;
  };
  std::vector<int> regions;
  for (std::size_t at = 0; at < list.size();) {
    const std::size_t comma = std::min(list.find(',', at), list.size());
    const auto number = parse_number(list.substr(at, comma - at));
    if (!number) return error{"certificate: \"frozen\": " + number.failure().message};
    regions.push_back(static_cast<int>(number.value()));
    at = list.find_first_not_of(" ,", comma);
  }
  auto rest = rest_of(subject.content, regions);
  if (!rest) return rest.failure();
  const std::size_t frozen = subject.content.triangles.size() - rest.value().triangles.size();
  const std::string before_name = word("adapt-mesh");
  auto before = read_mesh_file(before_name, {.without_solution = true});
  if (!before) return before.failure();
  const std::string difference =
      difference_of_frozen(subject.content, before.value().content, regions);
  if (!difference.empty())
    contradictions.push_back("frozen triangles are not those of " + before_name + ": " +
                             difference);
  if (std::to_string(frozen) != word("frozen-triangles"))
    contradictions.push_back(fmt::format("it says {} frozen triangles, and there are {}",
                                         word("frozen-triangles"), frozen));
  subject.together = std::exchange(subject.content, std::move(rest).value());
  subject.frozen = fmt::format("frozen, not judged: {} triangles of the regions {}{}", frozen, list,
                               difference.empty() ? ", as in " + before_name : "");
  return std::nullopt;
}

void number_segments(const verify_options& options, const domain& shape, judged_mesh& m) {
  if (is_medit(options)) return;
  number_segments_by_chains(m.content, shape);
  if (m.together) number_segments_by_chains(*m.together, shape);
}

std::optional<second_order_report> judge_second_order(const judged_mesh& subject,
                                                      const std::optional<certificate>& claim,
                                                      const domain* shape,
                                                      std::vector<std::string>& contradictions) {
  if (subject.second_order == 0) return std::nullopt;
  second_order_report found = prove_second_order(subject.whole(), subject.curved, shape);
  if (!found.proved()) contradictions.push_back(text_of(found));
  if (!claim) return found;
  if (!claim->second_order) {
    contradictions.emplace_back(
        "it says nothing of triangles of second order, and the file holds them");
    return found;
  }
  const std::string said = claimed_text(*claim->second_order), is = claimed_text(found);
  if (said != is)
    contradictions.push_back("second order: it says " + said + ", and there are " + is);
  found.kept_straight = claim->second_order->kept_straight;
  return found;
}

}  // namespace asterism::apps
