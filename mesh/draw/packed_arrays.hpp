// SPDX-License-Identifier: MIT
//
// Packs arrays of numbers into text for a page: little-endian, compressed, in base64.
#pragma once

#include <bit>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "asterism/core/result.hpp"

namespace asterism::internal {

static_assert(std::endian::native == std::endian::little, "arrays are copied as they lie");

// Arrays one after the other. Each is stored as planes: the first bytes of all its numbers, then
// the second bytes, and so on, which compresses better by a third than numbers in a row.
class packed_arrays {
 public:
  // Description of one array: `type` is f64, f32, u32, i32 or u8.
  struct entry {
    std::string name, type;
    std::size_t length = 0;  // numbers
  };

  template <class Number>
  void add(std::string name, std::string type, const std::vector<Number>& numbers) {
    entries_.push_back({std::move(name), std::move(type), numbers.size()});
    const std::size_t start = planes_.size();
    planes_.resize(start + numbers.size() * sizeof(Number));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      char bytes[sizeof(Number)];
      std::memcpy(bytes, &numbers[i], sizeof(Number));
      for (std::size_t k = 0; k < sizeof(Number); ++k)
        planes_[start + k * numbers.size() + i] = bytes[k];
    }
  }

  const std::vector<entry>& entries() const { return entries_; }
  std::size_t bytes() const { return planes_.size(); }
  // Returns all arrays as a zlib stream (RFC 1950) in base64. Fails when zlib does.
  result<std::string> text() const;

 private:
  std::vector<entry> entries_;
  std::string planes_;
};

// Returns bytes as base64 (RFC 4648), in one line.
std::string base64(std::string_view bytes);

}  // namespace asterism::internal
