// SPDX-License-Identifier: MIT
#include "asterism/apps/text/transfer_text.hpp"

#include <fmt/format.h>

#include <map>

#include "asterism/apps/base/other_names.hpp"
#include "asterism/mesh/support/one_line.hpp"

namespace asterism::apps {
namespace {

const std::map<std::string, transfer_method> transfer_methods = {
    {"interpolate", transfer_method::interpolate},
    {"project", transfer_method::project},
    {"bounded", transfer_method::bounded}};

// Returns a clause on the difference of integrals that are equal in nine digits.
std::string difference_text(const transferred_component& c) {
  const double difference = c.integral_after - c.integral_before;
  if (difference == 0) return ", the same";
  const bool looks_alike =
      fmt::format("{:.9g}", c.integral_before) == fmt::format("{:.9g}", c.integral_after);
  return looks_alike ? fmt::format(", differing by {:.2g}", difference) : "";
}

}  // namespace

void add_transfer_option(CLI::App& app, transfer_method& how) {
  app.add_option_function<std::string>(
         "--transfer", [&how](const std::string& name) { how = transfer_methods.at(name); },
         "interpolate (default): values at the new vertices; project: the nearest field in the "
         "mean "
         "square, which keeps integrals; bounded: that, without new extrema")
      ->transform(also("conservative", "project"))
      ->check(CLI::IsMember(transfer_methods))
      ->type_name("HOW");
}

std::string text_of(const transfer_report& r) {
  std::string text =
      fmt::format("transfer: area {:.10g} before, {:.10g} after", r.area_before, r.area_after);
  if (r.pieces > 0) text += fmt::format(", {:.10g} in common, {} pieces", r.area_common, r.pieces);
  if (r.partly_covered > 0)
    text += fmt::format("; {} triangles reach out of the old mesh", r.partly_covered);
  if (r.outside > 0)
    text +=
        fmt::format("; {} vertices are outside, {:.3g} at most", r.outside, r.greatest_distance);
  text += '\n';
  for (const transferred_component& c : r.components)
    text += fmt::format(
        "field {}: integral {:.9g} before, {:.9g} after{}; from {:.6g} to {:.6g} "
        "before, {:.6g} to {:.6g} after\n",
        internal::one_line(c.name), c.integral_before, c.integral_after, difference_text(c),
        c.least_before, c.greatest_before, c.least_after, c.greatest_after);
  return text;
}

}  // namespace asterism::apps
