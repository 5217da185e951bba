// SPDX-License-Identifier: MIT
//
// Runs the semi-static tier over columns: the same bounds as kernels/semi_static_filter.hpp,
// written without branches so that compilers turn the loops into vector code. On x86-64 each loop
// is compiled for AVX-512, AVX2 and plain SSE2, and chosen when called.
//
// Every column has at least `rows` numbers; answers[k] becomes the answer of row k, or `undecided`.
// Every row is evaluated whatever is in it: an infinity or NaN is undecided.
#pragma once

#include <cstddef>

#include "asterism/kernels/batch_columns.hpp"

namespace asterism::internal::batch {

inline constexpr signed char undecided = 2;

void orientation(const point_columns& p, const point_columns& q, const point_columns& r,
                 std::size_t rows, signed char* answers);
void in_circle(const metric_columns& m, const point_columns& a, const point_columns& b,
               const point_columns& c, const point_columns& p, std::size_t rows,
               signed char* answers);
void compare_distance(const site_columns& v, const site_columns& w, const point_columns& q,
                      std::size_t rows, signed char* answers);
void in_wedge(const site_columns& v, const site_columns& w, const point_columns& q,
              std::size_t rows, signed char* answers);
void dominates(const site_columns& v, const site_columns& w, const point_columns& p,
               std::size_t rows, signed char* answers);
// Decides edge tests of four equal metrics. Rows whose metrics differ are undecided.
void edge_test(const site_columns& v, const site_columns& w, const site_columns& x,
               const site_columns& y, std::size_t rows, signed char* answers);

}  // namespace asterism::internal::batch
