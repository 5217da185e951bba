// SPDX-License-Identifier: MIT
#include "asterism/core/similar_name.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

namespace asterism::internal {
namespace {

TEST_CASE("the name that a word begins is found, unless there are several") {
  const std::vector<std::string> names = {"--size", "--size-at", "--hmin", "--hmax", "part.poly"};
  CHECK(similar_name("--siz", names) == "--size");
  CHECK(similar_name("part", names) == "part.poly");
  CHECK(similar_name("--hm", names).empty());
  CHECK(similar_name("--", names).empty());
}

TEST_CASE("the nearest name is found by its letters") {
  const std::vector<std::string> names = {"orientation", "in_circle", "Part.poly", "is_spd"};
  CHECK(similar_name("orientaton", names) == "orientation");
  CHECK(similar_name("oreintation", names) == "orientation");
  CHECK(similar_name("ORIENTATION", names) == "orientation");
  CHECK(similar_name("part.ploy", names) == "Part.poly");
  CHECK(similar_name("incircle", names) == "in_circle");
  CHECK(similar_name("insphere", names).empty());
  CHECK(similar_name("spd", {"spx"}) == "spx");
  CHECK(similar_name("s", {"t"}).empty());
  CHECK(similar_name("", names).empty());
  CHECK(similar_name("word", {}).empty());
  CHECK(similar_name(std::string(100000, 'x'), {std::string(100000, 'y')}).empty());
  CHECK(did_you_mean("orientaton", names) == "; did you mean orientation?");
  CHECK(did_you_mean("nothing", names).empty());
}

}  // namespace
}  // namespace asterism::internal
