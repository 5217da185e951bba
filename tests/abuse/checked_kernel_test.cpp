// SPDX-License-Identifier: MIT
//
// Tests the kernel checker: it finds the errors of plain doubles and no others, returns the first
// kernel's answer, and its reports are tests that reproduce the difference.
#include "asterism/kernels/checked_kernel.hpp"

#include <catch2/catch.hpp>
#include <sstream>
#include <vector>

#include "asterism/challenge/input_classes.hpp"
#include "asterism/kernels/batch_protocol.hpp"
#include "asterism/kernels/double_kernel.hpp"
#include "asterism/kernels/exact_kernel.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/kernels/interval_kernel.hpp"

namespace asterism::abuse {
using namespace challenge;
namespace {

template <class Kernel>
void ask_everything(const Kernel& kernel, int records) {
  for (const input_class& from : input_classes()) {
    random_source random(7);
    for (std::size_t p = 0; p < predicate_count; ++p)
      for (int i = 0; i < records; ++i)
        (void)ask(kernel, draw_record(from, static_cast<predicate>(p), random));
  }
}

TEST_CASE("the checker finds nothing between filtered and exact", "[checker]") {
  std::ostringstream tests;
  const checked_kernel<filtered_kernel, exact_kernel> kernel(
      tests_written_to(tests, "asterism::filtered_kernel"));
  ask_everything(kernel, 5);
  CHECK(tests.str().empty());
}

TEST_CASE("an undecided answer agrees with every answer", "[checker]") {
  std::ostringstream tests;
  const checked_kernel<interval_kernel, exact_kernel> kernel(
      tests_written_to(tests, "asterism::interval_kernel"));
  ask_everything(kernel, 5);
  CHECK(tests.str().empty());
  CHECK_FALSE(kernel.orientation({0, 0}, {0.1, 0.1}, {0.3, 0.3}).certainly(sign::positive));
}

TEST_CASE("the checker finds what doubles get wrong, and each report replays it", "[checker]") {
  std::vector<kernel_difference> found;
  const checked_kernel<double_kernel, exact_kernel> kernel(
      [&](const kernel_difference& difference) { found.push_back(difference); });
  ask_everything(kernel, 40);
  REQUIRE(found.size() > 10);
  for (const kernel_difference& difference : found) {
    CHECK(ask(double_kernel(), difference.record).value() == difference.first_answer);
    CHECK(ask(exact_kernel(), difference.record).value() == difference.second_answer);
    const auto read = parse_record(record_line(difference.record));
    REQUIRE(read.ok());
    CHECK(read.value()->question == difference.record.question);
    CHECK(read.value()->numbers == difference.record.numbers);
  }
}

TEST_CASE("the first kernel answers", "[checker]") {
  // Asks for (0.5, 0.5) moved by two units in the last place, and the line through (12, 12) and
  // (24, 24).
  const point p{0.5 + 0x1p-52, 0.5}, q{12, 12}, r{24, 24};
  int differences = 0;
  const auto count = [&](const kernel_difference&) { ++differences; };
  const checked_kernel<double_kernel, exact_kernel> by_double(count);
  const checked_kernel<exact_kernel, double_kernel> by_exact(count);
  const bool doubles_are_right =
      double_kernel().orientation(p, q, r) == exact_kernel().orientation(p, q, r);
  CHECK(by_double.orientation(p, q, r) == double_kernel().orientation(p, q, r));
  CHECK(by_exact.orientation(p, q, r) == exact_kernel().orientation(p, q, r));
  CHECK(differences == (doubles_are_right ? 0 : 2));
}

TEST_CASE("the text of a report", "[checker]") {
  batch_record record{predicate::in_wedge, {}};
  const double numbers[] = {0, 0, 1, 0, 1, 1, 0, 1, 0, 1, 0.5, 0.25};
  std::copy(std::begin(numbers), std::end(numbers), record.numbers.begin());
  const std::string text = kernel_difference{record, 0, 1}.test("asterism::filtered_kernel");
  CHECK(text.find("// in_wedge 0x0p+0 0x0p+0 0x1p+0") == 0);
  CHECK(text.find("TEST_CASE(\"in_wedge, case ") != std::string::npos);
  CHECK(text.find("const asterism::filtered_kernel kernel;") != std::string::npos);
  CHECK(text.find("{{0x0p+0, 0x0p+0}, {0x1p+0, 0x0p+0, 0x1p+0}}") != std::string::npos);
  CHECK(text.find("CHECK(answer.value() == 1);") != std::string::npos);
}

}  // namespace
}  // namespace asterism::abuse
