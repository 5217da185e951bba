// SPDX-License-Identifier: MIT
#include "asterism/apps/verify/verify_metric.hpp"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/core/number_text.hpp"
#include "asterism/mesh/claims/field_claims.hpp"
#include "asterism/mesh/data/site_box.hpp"
#include "asterism/mesh/delivery/tolerated_metric.hpp"

namespace asterism::apps {
using namespace internal;
namespace {

// Returns the tolerance that was asked for, by the certificate; none if there was none.
std::optional<double> tolerance_in(const certificate& claim) {
  const auto found = claim.options.find("metric-tolerance");
  if (found == claim.options.end()) return std::nullopt;
  const auto number = parse_number(found->second);
  return number ? std::optional(number.value()) : std::nullopt;
}

// Returns the box of the sites as a domain, for a metric that is placed in it.
domain around(const mesh& subject) {
  domain d;
  for (const site& s : subject.sites) d.vertices.push_back(s.position);
  return d;
}

result<metric_wording> wording_asked(const verify_options& options,
                                     const std::optional<certificate>& claim,
                                     metric_answer& answer) {
  metric_wording asked;
  asked.name = options.metric;
  asked.domain = options.domain;
  if (claim) {
    const auto claimed = wording_in(*claim);
    if (!claimed) return error{"certificate: " + claimed.failure().message};
    asked.size = claimed.value().size;
    asked.gradation = claimed.value().gradation;
    asked.sizes = claimed.value().sizes;
    asked.domain = claimed.value().domain;
  }
  if (!options.size && asked.size != 1) answer.filled_in = "size " + format_number(asked.size);
  if (!options.gradation && asked.gradation)
    answer.filled_in += (answer.filled_in.empty() ? "gradation " : ", gradation ") +
                        format_number(*asked.gradation);
  if (asked.sizes != "none")
    answer.filled_in += (answer.filled_in.empty() ? "sizes " : ", sizes ") + asked.sizes;
  if (options.size) asked.size = *options.size;
  if (options.gradation) asked.gradation = options.gradation;
  return asked;
}

void take(field_check check, metric_answer& answer) {
  answer.made = check.made;
  answer.why_not = std::move(check.why_not);
  answer.apart = std::move(check.apart);
  for (std::string& said : check.contradictions) answer.contradictions.push_back(std::move(said));
}

// Compares the mesh with the metric of --metric. The certificate's tolerance applies only to the
// metric that it names; any other must be met exactly.
std::optional<error> judge_named(const verify_options& options, const mesh& subject,
                                 const std::optional<certificate>& claim, const domain* shape,
                                 metric_answer& answer) {
  const auto asked = wording_asked(options, claim, answer);
  if (!asked) return asked.failure();
  const auto field = field_of(asked.value(), shape != nullptr ? *shape : around(subject));
  if (!field) return field.failure().at("--metric");
  std::optional<double> bound = options.angle_bound;
  if (!bound && claim) bound = claim->angle_bound;
  take(check_against(subject, *field.value(), bound), answer);
  const auto claimed = claim ? wording_in(*claim) : result<metric_wording>(error{});
  const bool is_claimed = claimed && claimed.value() == asked.value() && claim->delivered;
  answer.tolerance_by = is_claimed ? asked_by::certificate : asked_by::nobody;
  answer.tolerance = is_claimed ? tolerance_in(*claim) : 0;
  return std::nullopt;
}

// Refuses a distance beyond the tolerance if an option gave the metric or the tolerance. verify()
// judges the certificate's own.
void judge_distance(metric_answer& answer) {
  const bool is_asked = answer.by == asked_by::option || answer.tolerance_by == asked_by::option;
  if (!is_asked || !answer.apart) return;
  const auto excess = excess_in(*answer.apart, answer.tolerance);
  if (!excess) return;
  const std::string than = answer.tolerance && *answer.tolerance > 0
                               ? ", where " + number_text(*answer.tolerance) + " is tolerated"
                               : "";
  answer.refusals.push_back(
      fmt::format("the metric of the mesh is {} from {}{}: a metric tolerance of {} is kept",
                  format_number(answer.apart->greatest), answer.name, than,
                  number_text(answer.apart->greatest)));
}

}  // namespace

result<std::unique_ptr<metric_field>> field_named(const verify_options& options,
                                                  const mesh& subject,
                                                  const std::optional<certificate>& claim,
                                                  const domain* shape) {
  metric_answer unused;
  const auto asked = wording_asked(options, claim, unused);
  if (!asked) return asked.failure();
  auto field = field_of(asked.value(), shape != nullptr ? *shape : around(subject));
  if (!field) return field.failure().at("--metric");
  return field;
}

result<metric_answer> judge_metric(const verify_options& options, const mesh& subject,
                                   const std::optional<certificate>& claim, const domain* shape) {
  metric_answer answer;
  if (claim) {
    answer.by = asked_by::certificate;
    answer.name = claim->metric;
    if (claim->delivered) answer.tolerance_by = asked_by::certificate;
    answer.tolerance = tolerance_in(*claim);
    take(check_field(subject, *claim), answer);
    if (!answer.made) answer.apart = claim->delivered;
  } else if (options.metric_tolerance && options.metric.empty()) {
    return error{"--metric-tolerance: no metric is asked for; --metric names one"};
  }
  if (!options.metric.empty()) {
    answer.by = asked_by::option;
    answer.name = options.metric;
    if (const auto failed = judge_named(options, subject, claim, shape, answer)) return *failed;
  }
  if (options.metric_tolerance) {
    answer.tolerance_by = asked_by::option;
    answer.tolerance = *options.metric_tolerance;
    if (!answer.made)
      answer.refusals.push_back(
          "how far the metric of the mesh is from the one asked for "
          "is not known: " +
          answer.why_not);
  }
  judge_distance(answer);
  return answer;
}

namespace {

std::string tolerance_text(const metric_answer& answer) {
  if (answer.tolerance_by == asked_by::nobody) return "";
  const std::string tolerance = answer.tolerance
                                    ? "metric tolerance " + format_number(*answer.tolerance)
                                    : std::string("no metric tolerance");
  return "; " + tolerance + by_text(answer.tolerance_by);
}

std::string apart_text(const delivered_report& apart) {
  const auto times = [](double distance) { return elementary::exp(distance); };
  return fmt::format(
      "lengths up to {:.4g} times as long or as short ({}), {:.4g} times at half of the sites; {} "
      "triangles below the bound in the metric asked for{}",
      times(apart.greatest), format_number(apart.greatest), times(apart.median),
      apart.low_wanted.size(),
      apart.low_wanted.empty() ? "" : fmt::format(", the worst {:.2f}", apart.worst_angle_wanted));
}

}  // namespace

std::string text_of(const metric_answer& answer) {
  if (answer.by == asked_by::nobody) return "the file's, field not checked";
  std::string name = answer.name.empty() ? "unnamed" : answer.name;
  if (!answer.filled_in.empty()) name += " (" + answer.filled_in + " by the certificate)";
  name += by_text(answer.by);
  const std::string unchecked = "field not checked, " + answer.why_not;
  if (answer.is_refused()) return name + ": REFUSED";
  if (answer.is_taken) return name + ", in which the mesh is judged, as its file has none";
  if (answer.apart)
    return "another than asked for, " + name + ": " +
           (answer.made ? "" : unchecked + "; it says ") + apart_text(*answer.apart) +
           tolerance_text(answer);
  return name + (answer.made ? ", compared at every vertex" : ": " + unchecked);
}

}  // namespace asterism::apps
