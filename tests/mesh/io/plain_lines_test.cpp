// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/plain_lines.hpp"

#include <catch2/catch.hpp>
#include <cstddef>
#include <string>
#include <vector>

#include "asterism/mesh/support/thread_limit.hpp"
#include "asterism/tests/mesh/fixtures/thread_arena.hpp"

using namespace asterism::internal;

namespace {

struct row {
  double x = 0;
  long long n = 0;
  bool operator==(const row&) const = default;
};

// Reads rows of a double and an integer; returns whether all were plain.
bool take_rows(text_scanner& source, std::vector<row>& rows) {
  return take_plain_lines(source, rows.size(), [&rows](std::size_t i, number_line& line) {
    return line.take(rows[i].x) && line.take(rows[i].n);
  });
}

bool is_plain(const std::string& line) {
  const std::string text = "2\n0.5 1\n" + line;
  text_scanner source("f", text);
  source.next();
  std::vector<row> rows(2);
  return take_rows(source, rows);
}

}  // namespace

TEST_CASE("lines of plain numbers are taken, and the scanner continues after them", "[io]") {
  const std::string text = "Rows 3 \r\n 1.5 7\r\n-2e-3\t-8 \n.25 009\n\nEnd # remark\n";
  text_scanner source("f", text);
  source.next();
  source.next();
  std::vector<row> rows(3);
  REQUIRE(take_rows(source, rows));
  CHECK(rows == std::vector<row>{{1.5, 7}, {-2e-3, -8}, {0.25, 9}});
  const word after = source.next();
  CHECK(after.text == "End");
  CHECK(after.line == 6);
}

TEST_CASE("a text may end with the last line", "[io]") {
  text_scanner source("f", "1\n2.5 3");
  source.next();
  std::vector<row> rows(1);
  REQUIRE(take_rows(source, rows));
  CHECK(rows[0] == row{2.5, 3});
  CHECK(source.next().empty());
  CHECK(source.line() == 2);
}

TEST_CASE("lines of another form are left to the scanner", "[io]") {
  CHECK(is_plain("1 2"));
  for (const char* other :
       {"", "1", "1 2 3", "+1 2", "1 +2", "1d0 2", "0x1 2", "inf 2", "nan 2", "1e999 2", "1 2.5",
        "1 2 # remark", "# remark\n1 2", "\n1 2", "1\n2", "1 1234567890123456789", "- 2", "1 -"})
    CHECK_FALSE(is_plain(other));
  text_scanner source("f", "1 2 3\n");
  source.next();
  std::vector<row> rows(1);
  CHECK_FALSE(take_rows(source, rows));  // records begin on the line of the number of rows
  CHECK(source.next().text == "2");
}

TEST_CASE("lines are the same for any number of threads", "[io][threads]") {
  constexpr std::size_t count = 30'000;
  std::string text = std::to_string(count) + "\n";
  for (std::size_t i = 0; i < count; ++i) {
    // A line that is longer than a part of the text that one thread reads.
    if (i == count / 2) text += std::string(200'000, ' ');
    text += std::to_string(i) + ".125 " + std::to_string(i) + "\n";
  }
  text += "End\n" + std::string(300'000, '\n');
  for (const int threads : {1, 2, 3, 7})
    with_threads(threads, [&] {
      text_scanner source("f", text);
      source.next();
      std::vector<row> rows(count);
      REQUIRE(take_rows(source, rows));
      bool is_right = true;
      for (std::size_t i = 0; i < count; ++i)
        is_right =
            is_right && rows[i] == row{static_cast<double>(i) + 0.125, static_cast<long long>(i)};
      CHECK(is_right);
      const word after = source.next();
      CHECK(after.text == "End");
      CHECK(after.line == count + 2);
    });
}
