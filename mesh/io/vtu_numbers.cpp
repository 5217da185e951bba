// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/vtu_numbers.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>

#include "asterism/core/number_text.hpp"

namespace asterism::internal {
namespace {

constexpr std::array<std::pair<std::string_view, std::size_t>, 10> array_types = {{{"Float64", 8},
                                                                                   {"Float32", 4},
                                                                                   {"Int64", 8},
                                                                                   {"UInt64", 8},
                                                                                   {"Int32", 4},
                                                                                   {"UInt32", 4},
                                                                                   {"Int16", 2},
                                                                                   {"UInt16", 2},
                                                                                   {"Int8", 1},
                                                                                   {"UInt8", 1}}};

// Returns the value of a base64 digit, 0 to 63, or none.
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
  for (const auto& [name, bytes] : array_types)
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

namespace {

struct block_sizes {
  std::size_t header = 0;  // bytes of all of the header
  std::vector<std::size_t> whole, compressed;
};

// Returns the first bytes that the text encodes, at most `most`.
std::string first_bytes(std::string_view text, std::size_t most, bool raw) {
  if (raw) return std::string(text.substr(0, most));
  std::string bytes = decode_base64(text, most);
  bytes.resize(std::min(bytes.size(), most));
  return bytes;
}

// Reads the header of blocks with `total` bytes together, and no more blocks than the text may
// hold.
result<block_sizes> read_block_sizes(std::string_view text, std::size_t total,
                                     const vtu_encoding& how, bool raw) {
  const std::size_t word = how.wide_header ? 8 : 4;
  const std::string three = first_bytes(text, 3 * word, raw);
  if (three.size() < 3 * word) return error{"there is no header of compressed blocks before them"};
  const std::uint64_t count = word_at(three, 0, word, how.big_endian);
  const std::uint64_t block = word_at(three, word, word, how.big_endian);
  const std::uint64_t last = word_at(three, 2 * word, word, how.big_endian);
  // Checks the case of no blocks, or of blocks without bytes: they hold nothing.
  const bool fits = block == 0 ? count == 0 && total == 0
                               : count == total / block + (total % block != 0 ? 1 : 0) &&
                                     (count == 0 || last == total % block);
  if (!fits)
    return error{
        fmt::format("{} compressed blocks of {} bytes, the last of {}, do not have {} bytes", count,
                    block, last, total)};
  if (count > text.size()) return error{"the header of compressed blocks ends here"};
  block_sizes sizes;
  sizes.header = (3 + count) * word;
  const std::string header = first_bytes(text, sizes.header, raw);
  if (header.size() < sizes.header) return error{"the header of compressed blocks ends here"};
  for (std::size_t i = 0; i < count; ++i) {
    sizes.whole.push_back(i + 1 < count || last == 0 ? block : last);
    sizes.compressed.push_back(word_at(header, (3 + i) * word, word, how.big_endian));
    if (sizes.compressed.back() > text.size())
      return error{fmt::format("compressed block {} is longer than the file", i + 1)};
  }
  return sizes;
}

// Returns the `total` bytes of compressed blocks.
result<std::string> inflated(std::string_view text, std::size_t total, const vtu_encoding& how,
                             bool raw) {
  const auto sizes = read_block_sizes(text, total, how, raw);
  if (!sizes) return sizes.failure();
  std::size_t end = sizes.value().header;
  for (const std::size_t size : sizes.value().compressed) end += size;
  const std::string bytes = first_bytes(text, end, raw);
  if (bytes.size() < end)
    return error{fmt::format("{} compressed bytes wanted, and there are {}", end, bytes.size())};
  std::string whole(total, '\0');
  std::size_t from = sizes.value().header, to = 0;
  for (std::size_t i = 0; i < sizes.value().whole.size(); ++i) {
    const std::size_t wanted = sizes.value().whole[i], given = sizes.value().compressed[i];
    uLongf made = static_cast<uLongf>(wanted);
    const int state =
        uncompress(reinterpret_cast<Bytef*>(whole.data() + to), &made,
                   reinterpret_cast<const Bytef*>(bytes.data() + from), static_cast<uLong>(given));
    if (state != Z_OK || made != wanted)
      return error{fmt::format("compressed block {} is damaged", i + 1)};
    from += given;
    to += wanted;
  }
  return whole;
}

// Returns the `total` bytes of an array that is not compressed.
result<std::string> plain_bytes(std::string_view text, std::string_view type, std::size_t count,
                                std::size_t total, const vtu_encoding& how, bool raw) {
  const std::size_t header = how.wide_header ? 8 : 4;
  const std::string bytes = first_bytes(text, header + total, raw);
  if (bytes.size() < header) return error{"there is no count of bytes before them"};
  const std::uint64_t said = word_at(bytes, 0, header, how.big_endian);
  if (said != total)
    return error{
        fmt::format("{} bytes, and {} numbers of type {} take {}", said, count, type, total)};
  if (bytes.size() < header + total)
    return error{fmt::format("{} bytes wanted, and there are {}", total, bytes.size() - header)};
  return bytes.substr(header);
}

}  // namespace

result<std::vector<double>> vtu_binary_numbers(std::string_view text, std::string_view type,
                                               std::size_t count, const vtu_encoding& how,
                                               bool raw) {
  const auto size = vtu_bytes_of(type);
  if (!size) return error{quoted_token(type) + " is no known type of number"};
  const std::size_t total = count * *size;
  const auto bytes =
      how.zlib ? inflated(text, total, how, raw) : plain_bytes(text, type, count, total, how, raw);
  if (!bytes) return bytes.failure();
  std::vector<double> numbers;
  numbers.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    numbers.push_back(
        number_of(word_at(bytes.value(), i * *size, *size, how.big_endian), type, *size));
  return numbers;
}

}  // namespace asterism::internal
