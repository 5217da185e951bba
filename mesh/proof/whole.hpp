// SPDX-License-Identifier: MIT
//
// Names the whole numbers that weights of a proof are given in.
#pragma once

#include <boost/multiprecision/gmp.hpp>

namespace asterism::internal::proof_detail {

using whole =
    boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

}  // namespace asterism::internal::proof_detail
