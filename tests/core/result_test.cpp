// SPDX-License-Identifier: MIT
#include "asterism/core/result.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <csignal>
#include <memory>
#include <string>

using asterism::error;
using asterism::result;

namespace {

struct ending {
  int status = 0;
  std::string said;
};

// Runs `fault` in a process of its own, and returns the text that it writes to standard error.
template <class Fault>
ending end_of(const Fault& fault) {
  std::array<int, 2> ends{};
  REQUIRE(pipe(ends.data()) == 0);
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGABRT, SIG_DFL);  // Catch would report it
    dup2(ends[1], STDERR_FILENO);
    fault();
    _exit(0);
  }
  close(ends[1]);
  ending found;
  std::array<char, 256> part{};
  for (ssize_t n = 0; (n = read(ends[0], part.data(), part.size())) > 0;)
    found.said.append(part.data(), static_cast<std::size_t>(n));
  close(ends[0]);
  REQUIRE(waitpid(child, &found.status, 0) == child);
  return found;
}

const result<std::string> refused = error{"swrl:3: unknown metric; there are swirl, sink"};

}  // namespace

TEST_CASE("the value of a failure ends the program with the failure's message") {
  const auto check = [](const ending& found) {
    CHECK(WIFSIGNALED(found.status));
    CHECK(WTERMSIG(found.status) == SIGABRT);
    CHECK(found.said == "asterism: value() of a failure: " + refused.failure().message + "\n");
  };
  check(end_of([] { (void)refused.value(); }));
  check(end_of([] { (void)result<std::string>(refused).value(); }));
  check(end_of([] {
    result<std::string> changeable = refused;
    changeable.value() += "more";
  }));
}

TEST_CASE("a value is held, changed and moved out") {
  result<std::unique_ptr<int>> one = std::make_unique<int>(3);
  REQUIRE(one);
  *one.value() += 4;
  const std::unique_ptr<int> taken = std::move(one).value();
  CHECK(*taken == 7);
}
