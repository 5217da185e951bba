// SPDX-License-Identifier: MIT
//
// Stops runs at any moment. Only the mesh of a run that was not stopped counts as complete.
#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <optional>
#include <string>

#include "asterism/mesh/domain/built_in_domains.hpp"
#include "asterism/mesh/mesher.hpp"
#include "fixtures/star_fixture.hpp"

namespace asterism::testing {
namespace {

// Makes the mesh of a run that is stopped at the poll with this number, and at all later ones.
certified_mesh made_until(long polls, std::atomic<long>& polled) {
  mesh_options options;
  options.limit_size = true;
  polled = 0;
  options.stop = [&polled, polls]() -> std::optional<std::string> {
    if (polled++ < polls) return std::nullopt;
    return "enough";
  };
  const formula_field field([](const point& q) {
    const double wide = 4 + 3 * q.x;
    return metric_tensor{wide * wide, 0, 16};
  });
  auto made = make_certified_mesh(square(), field, options);
  REQUIRE(made);
  return std::move(made).value();
}

}  // namespace

TEST_CASE("a mesh whose improvement was cut short had passed for that of the whole run") {
  std::atomic<long> polled = 0;
  const certified_mesh whole = made_until(1L << 40, polled);
  REQUIRE(whole.certified());
  const long polls = polled;
  REQUIRE(polls > 20);
  int improving = 0;
  const long step = std::max(1L, polls / 60);
  for (long until = 0; until < polls; until += step) {
    INFO("stopped at poll " << until << " of " << polls);
    const certified_mesh made = made_until(until, polled);
    CHECK_FALSE(made.certified());
    if (made.outcome.complete) {  // stopped during the audit of the finished mesh
      CHECK(made.report.found[static_cast<std::size_t>(finding_kind::stopped)] > 0);
      continue;
    }
    CHECK(made.claim.reason.starts_with("stopped: enough"));
    if (made.claim.reason.find("being improved") == std::string::npos) continue;
    ++improving;
    CHECK(made.report.certified);  // the auditor judges that mesh
  }
  CHECK(improving > 0);
}

}  // namespace asterism::testing
