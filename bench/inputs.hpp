// SPDX-License-Identifier: MIT
//
// Generates the questions of the benchmarks, every input class, the same on every machine and in
// every run (a seed names a list for ever).
//
// Classes. uniform: random in [-1,1]^2, metrics of a smooth field. one ulp: a question whose answer
// changes, moved there as well as doubles can. degenerate: exactly on the border between two
// answers, with numbers of 20 bits. grid: small integers. 2^400, 2^-400: uniform with all
// coordinates scaled. offset 1e8: spacing 1e-6 about (1e8, 1e8). condition 1e12: metrics with
// eigenvalues 1 and 1e12.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "asterism/core/site.hpp"

namespace asterism::bench {

enum class input_class { uniform, one_ulp, degenerate, grid, up, down, offset, condition };
struct named_class {
  input_class which;
  std::string_view name;
};
inline constexpr std::array<named_class, 8> input_classes = {{
    {input_class::uniform, "uniform"},
    {input_class::one_ulp, "one ulp"},
    {input_class::degenerate, "degenerate"},
    {input_class::grid, "grid"},
    {input_class::up, "2^400"},
    {input_class::down, "2^-400"},
    {input_class::offset, "offset 1e8"},
    {input_class::condition, "condition 1e12"},
}};

struct point_question {
  site v, w;
  point q;
};
using edge_question = std::array<site, 4>;  // v, w, and w's neighbours x and y in v's star
using line_question = std::array<point, 3>;

// The border to which a point question is moved: f_v = f_w inside the wedge, or the wedge's side.
enum class border { bisector, wedge };

std::vector<point_question> point_questions(input_class which, border near, std::size_t count,
                                            std::uint64_t seed = 1);
// Draws questions like a mesher's: v's neighbours at about one edge length, 60 degrees from each
// other in v's metric. Every site has the metric of its place.
std::vector<edge_question> edge_questions(input_class which, std::size_t count,
                                          std::uint64_t seed = 1);
// Draws four sites with the identity as metric: in-circle questions.
std::vector<edge_question> circle_questions(input_class which, std::size_t count,
                                            std::uint64_t seed = 1);
std::vector<line_question> line_questions(input_class which, std::size_t count,
                                          std::uint64_t seed = 1);

// Draws questions at a relative distance `closeness` from a change of the answer. 0: as near as
// rounding allows.
std::vector<point_question> point_questions_near(border near, double closeness, std::size_t count,
                                                 std::uint64_t seed = 1);
std::vector<edge_question> edge_questions_near(double closeness, std::size_t count,
                                               std::uint64_t seed = 1);
std::vector<edge_question> circle_questions_near(double closeness, std::size_t count,
                                                 std::uint64_t seed = 1);

}  // namespace asterism::bench
