// SPDX-License-Identifier: MIT
//
// Decodes the bytes that a fuzzer makes to records of the batch protocol. Most records have
// coincidences of numbers, because raw doubles from raw bytes almost never have any.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "asterism/kernels/batch_question.hpp"

namespace asterism::fuzz {

// The first byte chooses the predicate. Each coordinate is a byte that says how, then its operands:
// a small integer, a dyadic fraction, an earlier number, its neighbour by one unit in the last
// place, its negative, a power of two, a raw double; each metric likewise: one before, that one
// scaled by a power of two or with one number moved by a unit, small integers, L L^T, the one that
// gives a point of the plane a chosen distance, raw doubles. Missing bytes are zero.
// Empty when the record is none a kernel accepts: not finite, not positive definite, equal sites;
// and for most of the records that take exact arithmetic seconds.
std::optional<batch_record> decode_record(std::span<const std::uint8_t> bytes);

}  // namespace asterism::fuzz
