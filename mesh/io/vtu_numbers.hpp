// SPDX-License-Identifier: MIT
//
// Decodes the numbers of a VTK data array that is written as bytes behind their count: in base64,
// or as they are.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "asterism/core/result.hpp"

namespace asterism::internal {

// Encoding of bytes in a file.
struct vtu_encoding {
  bool big_endian = false;
  bool wide_header = false;  // counts of bytes have 64 bits, else 32
  bool zlib = false;         // the bytes are in blocks, each compressed
};

// Returns the number of bytes of a type of number; none for an unknown type.
std::optional<std::size_t> vtu_bytes_of(std::string_view type);

// Returns the bytes of a base64 text, blanks ignored; stops at the first other character. Padding
// may occur where one block ends and another begins.
std::string decode_base64(std::string_view text, std::size_t most_bytes);

// Returns `count` numbers of a type from text that begins with them, in base64 or, if `raw`, as
// bytes: a header with the number of bytes, then the bytes. Compressed ones have another header:
// the number of blocks, the bytes of a block, those of the last one if it is shorter, else 0, and
// for each block how many bytes it has when it is compressed. An error is half a sentence. Values
// may be any doubles, infinities and NaN included.
result<std::vector<double>> vtu_binary_numbers(std::string_view text, std::string_view type,
                                               std::size_t count, const vtu_encoding& how,
                                               bool raw = false);

}  // namespace asterism::internal
