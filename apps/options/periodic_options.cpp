// SPDX-License-Identifier: MIT
#include "asterism/apps/options/periodic_options.hpp"

#include <charconv>
#include <ostream>
#include <string>

namespace asterism::apps {
namespace {

// Reads "4,2": two whole numbers, and nothing more.
periodic_pair pair_of(const std::string& text) {
  periodic_pair pair;
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, pair.first);
  if (first.ec == std::errc() && first.ptr != end && *first.ptr == ',') {
    const auto second = std::from_chars(first.ptr + 1, end, pair.second);
    if (second.ec == std::errc() && second.ptr == end) return pair;
  }
  throw CLI::ValidationError("--periodic",
                             "two markers are wanted, as 4,2, and not '" + text + "'");
}

}  // namespace

CLI::Option* add_periodic_option(CLI::App& app, std::vector<periodic_pair>& pairs) {
  return app
      .add_option_function<std::vector<std::string>>(
          "--periodic",
          [&pairs](const std::vector<std::string>& all) {
            for (const std::string& one : all) pairs.push_back(pair_of(one));
          },
          "Two sides, by their markers, that get the same points: the one is the other shifted or "
          "turned; may be given several times")
      ->type_name("A,B")
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void write_periodic(std::ostream& out, const certificate& claim) {
  for (const periodic_match& one : claim.periodic) out << "periodic: " << text_of(one) << '\n';
}

}  // namespace asterism::apps
