// SPDX-License-Identifier: MIT
//
// Provides elementary functions whose results are the same bits on every machine with IEEE doubles:
// made of additions, multiplications, divisions and square roots of doubles alone, in a fixed
// order. Results of C libraries differ in the last place between libraries, and decisions of the
// mesher depend on it.
//
// Errors, in units in the last place of the result, rounding to nearest: log, log10, atan2, hypot
// 0.6; exp, exp2 0.65; sin, cos 0.85; log2 1; tan 1.6; tanh 6; pow 1.5 where the result is between
// 2^-64 and 2^64 or the power an integer, else 20; results that are subnormal one unit more.
// Compared with MPFR by tests/core/elementary_test.cpp. In another rounding mode some units more,
// and other bits. Special arguments have the results of the C library.
#pragma once

namespace asterism::internal::elementary {

double log(double x);
double log2(double x);  // of a power of two its exponent, exactly
double log10(double x);
double exp(double x);
double exp2(double x);  // of an integer a power of two, exactly
double sin(double x);   // any finite argument, however large
double cos(double x);
double tan(double x);
double atan2(double y, double x);
double tanh(double x);
double hypot(double x, double y);
double pow(double x, double y);  // exact where y is an integer and the result a double

}  // namespace asterism::internal::elementary
