// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/vtu_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>

#include "asterism/core/number_text.hpp"

namespace asterism::internal {
namespace {

constexpr std::array<std::pair<std::string_view, std::size_t>, 10> types = {{{"Float64", 8},
                                                                             {"Float32", 4},
                                                                             {"Int64", 8},
                                                                             {"UInt64", 8},
                                                                             {"Int32", 4},
                                                                             {"UInt32", 4},
                                                                             {"Int16", 2},
                                                                             {"UInt16", 2},
                                                                             {"Int8", 1},
                                                                             {"UInt8", 1}}};

// Returns 0 to 63, or none.
std::optional<std::uint32_t> sextet_of(char c) {
  if (c >= 'A' && c <= 'Z') return static_cast<std::uint32_t>(c - 'A');
  if (c >= 'a' && c <= 'z') return static_cast<std::uint32_t>(c - 'a' + 26);
  if (c >= '0' && c <= '9') return static_cast<std::uint32_t>(c - '0' + 52);
  if (c == '+') return 62;
  if (c == '/') return 63;
  return std::nullopt;
}

std::uint64_t word_at(std::string_view bytes, std::size_t at, std::size_t size, bool big_endian) {
  std::uint64_t word = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t k = big_endian ? i : size - 1 - i;
    word = word << 8 | static_cast<unsigned char>(bytes[at + k]);
  }
  return word;
}

double number_of(std::uint64_t word, std::string_view type, std::size_t size) {
  if (type == "Float64") return std::bit_cast<double>(word);
  if (type == "Float32") return std::bit_cast<float>(static_cast<std::uint32_t>(word));
  if (type.starts_with('U')) return static_cast<double>(word);
  const std::size_t shift = 64 - 8 * size;  // brings the sign to the top and back
  return static_cast<double>(static_cast<std::int64_t>(word << shift) >>
                             static_cast<std::int64_t>(shift));
}

}  // namespace

std::optional<std::size_t> vtu_bytes_of(std::string_view type) {
  for (const auto& [name, bytes] : types)
    if (name == type) return bytes;
  return std::nullopt;
}

std::string decode_base64(std::string_view text, std::size_t most_bytes) {
  std::string bytes;
  std::uint32_t group = 0;
  int held = 0;
  for (const char c : text) {
    if (bytes.size() >= most_bytes) break;
    if (c == ' ' || c == '\t' || c == '\r' || c == '\n') continue;
    if (c == '=') {  // the group has one or two bytes
      if (held >= 2) bytes += static_cast<char>(group >> (6 * held - 8) & 0xff);
      if (held == 3) bytes += static_cast<char>(group >> 2 & 0xff);
      group = 0;
      held = 0;
      continue;
    }
    const auto sextet = sextet_of(c);
    if (!sextet) break;
    group = group << 6 | *sextet;
    if (++held < 4) continue;
    for (const int shift : {16, 8, 0}) bytes += static_cast<char>(group >> shift & 0xff);
    group = 0;
    held = 0;
  }
  return bytes;
}

result<std::vector<double>> vtu_binary_numbers(std::string_view text, std::string_view type,
                                               std::size_t count, const vtu_encoding& how,
                                               bool raw) {
  const auto size = vtu_bytes_of(type);
  if (!size) return error{quoted_token(type) + " is no known type of number"};
  const std::size_t header = how.wide_header ? 8 : 4;
  const std::string decoded = raw ? "" : decode_base64(text, header + count * *size + 3);
  const std::string_view bytes = raw ? text : std::string_view(decoded);
  if (bytes.size() < header) return error{"there is no count of bytes before them"};
  const std::uint64_t said = word_at(bytes, 0, header, how.big_endian);
  if (said != count * *size)
    return error{fmt::format("{} bytes, and {} numbers of type {} take {}", said, count, type,
                             count * *size)};
  if (bytes.size() < header + count * *size)
    return error{
        fmt::format("{} bytes wanted, and there are {}", count * *size, bytes.size() - header)};
  std::vector<double> numbers;
  numbers.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    numbers.push_back(
        number_of(word_at(bytes, header + i * *size, *size, how.big_endian), type, *size));
  return numbers;
}

}  // namespace asterism::internal
