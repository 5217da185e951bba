// SPDX-License-Identifier: MIT
//
// Names rationals, and whole numbers of any size that share their arithmetic: GMP's, or those of
// Boost's headers where the predicates use these too (ASTERISM_EXACT=cpp_int). The values are the
// same; Boost's take longer.
#pragma once

#ifdef ASTERISM_EXACT_CPP_INT
#include <boost/multiprecision/cpp_int.hpp>
#else
#include <boost/multiprecision/gmp.hpp>
#endif

namespace asterism::internal {

#ifdef ASTERISM_EXACT_CPP_INT
using rational = boost::multiprecision::number<boost::multiprecision::cpp_rational_backend,
                                               boost::multiprecision::et_off>;
using whole_number = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
                                                   boost::multiprecision::et_off>;
#else
using rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                               boost::multiprecision::et_off>;
using whole_number =
    boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
#endif

}  // namespace asterism::internal
