// SPDX-License-Identifier: MIT
#include "asterism/apps/options/size_options.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "asterism/apps/options/option_values.hpp"
#include "asterism/core/number_text.hpp"
#include "asterism/mesh/io/read_mesh.hpp"

namespace asterism::apps {
using namespace internal;
namespace {

constexpr real_range aspects = {1, 1e6, true, true, "from 1 to 1e6"};

struct described_size {
  const char *option, *kind, *values, *description;
};

constexpr described_size described[] = {
    {"--size-at", "at", "X,Y,R:H[,G]",
     "Edges no longer than H within R of a point, and growing by the factor G (1.3) from edge to "
     "edge around it; this and the next four: several times, the finest size counts"},
    {"--size-box", "box", "X0,Y0,X1,Y1:H[,G]", "The same in a box"},
    {"--size-in", "in", "REGION:H[,G]", "The same in a region, by its number or its name"},
    {"--size-near", "near", "MARKER:H0[,G]",
     "The same at the segments with a marker, by its number or its name"},
    {"--layers", "layers", "MARKER:H0,G[,N]",
     "Layers along the segments with a marker: the first cells are H0 high, each layer G times as "
     "high as the one before, N of them (default: until they are as high as long)"}};

// Returns the number that has this name, of a region or marker; none if there is none.
std::optional<int> number_of(const std::map<int, std::string>& names, const std::string& name) {
  const auto at =
      std::find_if(names.begin(), names.end(), [&](const auto& one) { return one.second == name; });
  return at == names.end() ? std::nullopt : std::optional(at->first);
}

std::string list_of(const std::map<int, std::string>& names) {
  std::string text;
  for (const auto& [number, name] : names) text += (text.empty() ? "" : ", ") + quoted_token(name);
  return text;
}

bool is_number(const std::string& text) {
  const std::size_t first = !text.empty() && text[0] == '-' ? 1 : 0;
  return text.size() > first &&
         std::all_of(text.begin() + static_cast<std::ptrdiff_t>(first), text.end(),
                     [](char c) { return '0' <= c && c <= '9'; });
}

// Returns the text with the name of a region or marker replaced by its number.
std::string with_number(const worded_size& worded, const std::string& domain) {
  if (worded.kind != "in" && worded.kind != "near" && worded.kind != "layers") return worded.text;
  const std::size_t colon = worded.text.rfind(':');
  const std::string name = worded.text.substr(0, colon);
  if (colon == std::string::npos || is_number(name)) return worded.text;
  const physical_names names = names_in(domain);
  const auto& those = worded.kind == "in" ? names.regions : names.markers;
  const auto number = number_of(those, name);
  if (number) return std::to_string(*number) + worded.text.substr(colon);
  const std::string what = worded.kind == "in" ? "region" : "marker";
  throw CLI::ValidationError(worded.option,
                             domain + " names no " + what + " " + quoted_token(name) +
                                 (those.empty() ? "" : "; there are " + list_of(those)));
}

}  // namespace

void add_size_bounds(CLI::App& app, double& least, double& greatest, double& aspect,
                     const std::string& on_least) {
  add_real(
      app, "--hmin", sizes, [&least](double x) { least = x; }, on_least)
      ->type_name("H");
  add_real(
      app, "--hmax", sizes, [&greatest](double x) { greatest = x; }, "Greatest length of an edge")
      ->type_name("H");
  add_real(
      app, "--aspect", aspects, [&aspect](double x) { aspect = x; },
      "How many times as long as wide a triangle may be (default 1e6)")
      ->type_name("A");
}

void add_size_options(CLI::App& app, mesh_job& job, std::vector<worded_size>& worded) {
  for (const described_size& one : described) {
    const auto keep = [&worded, one](const std::vector<std::string>& texts) {
      for (const std::string& text : texts) worded.push_back({one.option, one.kind, text});
    };
    app.add_option_function<std::vector<std::string>>(one.option, keep, one.description)
        ->type_name(one.values)
        ->allow_extra_args(false);
  }
  app.add_flag("--sizes-of-file", job.sizes_of_file,
               "The areas that DOMAIN wants of the triangles in its regions are sizes there");
  add_size_bounds(app, job.sizes.least, job.sizes.greatest, job.sizes.aspect,
                  "Least length of an edge, also where other options want less");
}

void take_sizes(mesh_job& job, const std::vector<worded_size>& worded) {
  for (const worded_size& one : worded) {
    auto made = with_wish(std::move(job.sizes), one.kind, with_number(one, job.domain));
    if (!made)
      throw CLI::ValidationError(one.option,
                                 quoted_token(one.text) + ": " + made.failure().message);
    job.sizes = std::move(made).value();
  }
}

}  // namespace asterism::apps
