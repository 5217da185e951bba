// SPDX-License-Identifier: MIT
//
// Tests the work limit of an audit: chunks that need more than their share of it.
#include "asterism/mesh/audit/audit_work.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "asterism/mesh/audit/audit.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::internal::audit_detail;

namespace {

struct outcome {
  bool ended;
  double units;              // charged to the account
  std::vector<int> checked;  // how often each item was checked to its end
};

// Checks items of one unit each, except item 5, which takes more.
outcome check_items(std::size_t count, double units_of_fifth, double units_there_are) {
  const mesh subject;
  audit_options options;
  options.stop = cancellation().with_work(units_there_are);
  audit_report report;
  audit_context context(subject, options, report);
  outcome done{false, 0, std::vector<int>(count, 0)};
  const auto check = [&](audit_tally& tally, std::size_t begin, std::size_t end) {
    audit_work_guard patience(context, tally);
    for (std::size_t i = begin; i < end; ++i) {
      const double units = i == 5 ? units_of_fifth : 1;
      for (double spent = 0; spent < units && !patience.is_over(); spent += 0.01)
        patience.count(0.01);
      if (patience.is_over()) return;
      ++done.checked[i];
    }
  };
  done.ended = check_in_parts(context, count, check, [] { return false; });
  done.units = context.looked_units;
  return done;
}

}  // namespace

TEST_CASE("a part that takes more than its share of the work has what the others leave") {
  // A chunk has a sixteenth of the work, about 60 units.
  const outcome done = check_items(100, 300, 1000);
  CHECK(done.ended);
  for (const int times : done.checked) CHECK(times == 1);
  CHECK(done.units > 399);
  CHECK(done.units < 470);
}

TEST_CASE("a part that takes more work than there is ends the check") {
  const outcome done = check_items(100, 5000, 1000);
  CHECK_FALSE(done.ended);
  CHECK(done.checked[5] == 0);
  CHECK(done.units < 1010);
}
