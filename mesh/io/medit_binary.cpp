// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/medit_binary.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/text_lines.hpp"
#include "asterism/mesh/io/text_scanner.hpp"

namespace asterism::internal {
namespace {

// Shape of a section's records: `dimension` reals, if any, then a number of integers.
struct section_kind {
  std::string_view keyword;
  int code;
  bool has_place;
  int integers;
};
constexpr std::array<section_kind, 8> sections = {{{"Vertices", 4, true, 1},
                                                   {"Edges", 5, false, 3},
                                                   {"Triangles", 6, false, 4},
                                                   {"Quadrilaterals", 7, false, 5},
                                                   {"Corners", 13, false, 1},
                                                   {"RequiredVertices", 15, false, 1},
                                                   {"RequiredEdges", 16, false, 1},
                                                   {"SolAtVertices", 62, false, 0}}};
constexpr int dimension_code = 3, end_code = 54, solution_code = 62;

template <class Kind>
const section_kind* find_section(const Kind& wanted, Kind section_kind::*member) {
  const auto at = std::find_if(sections.begin(), sections.end(),
                               [&](const section_kind& s) { return s.*member == wanted; });
  return at == sections.end() ? nullptr : &*at;
}

class decoder {
 public:
  decoder(const std::string& file, std::string_view bytes) : file_(file), bytes_(bytes) {}

  result<std::string> text();

 private:
  using failure = std::optional<error>;
  failure fail(const std::string& what) const {
    return error{file_ + ": byte " + std::to_string(at_) + ": " + what, error_code::malformed_file};
  }
  // Reads an unsigned number of `size` bytes. Requires that the data has these.
  std::uint64_t raw(std::size_t size) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const auto byte = static_cast<unsigned char>(bytes_[at_ + (swapped_ ? size - 1 - i : i)]);
      value |= std::uint64_t{byte} << (8 * i);
    }
    at_ += size;
    return value;
  }
  std::int64_t integer(std::size_t size) {
    const std::uint64_t value = raw(size);
    return size == 4 ? static_cast<std::int32_t>(static_cast<std::uint32_t>(value))
                     : static_cast<std::int64_t>(value);
  }
  double real() {
    if (version_ > 1) return std::bit_cast<double>(raw(8));
    return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(raw(4))));
  }
  bool has(std::size_t size) const { return bytes_.size() - at_ >= size; }
  std::size_t real_size() const { return version_ > 1 ? 8 : 4; }
  std::size_t integer_size() const { return version_ > 3 ? 8 : 4; }
  std::size_t place_size() const { return version_ > 2 ? 8 : 4; }

  failure read_header();
  failure read_section(bool& ended);
  failure read_records(const section_kind& kind);
  failure read_types(std::size_t& reals);

  const std::string& file_;
  std::string_view bytes_;
  std::size_t at_ = 0;
  bool swapped_ = false;
  int version_ = 2, dimension_ = 0;
  std::string text_;
};

result<std::string> decoder::text() {
  if (auto failed = read_header()) return std::move(*failed);
  for (bool ended = false; !ended;)
    if (auto failed = read_section(ended)) return std::move(*failed);
  if (dimension_ == 0) return *fail("there is no section Dimension");
  text_ += "End\n";
  return std::move(text_);
}

std::optional<error> decoder::read_header() {
  if (!has(8)) return fail("too short for a Medit file");
  const std::uint64_t mark = raw(4);
  swapped_ = mark == 0x01000000;
  if (mark != 1 && !swapped_) return fail("a binary Medit file begins with the number 1");
  const std::int64_t version = integer(4);
  if (version < 1 || version > 4)
    return fail("version " + std::to_string(version) + " is none of 1 to 4");
  version_ = static_cast<int>(version);
  text_ = "MeshVersionFormatted 2\n";
  return {};
}

std::optional<error> decoder::read_section(bool& ended) {
  if (at_ == bytes_.size() && dimension_ != 0) {  // some programs leave out the end
    ended = true;
    return {};
  }
  if (!has(4 + place_size())) return fail("the file ends within a section's head");
  const auto code = static_cast<int>(integer(4));
  const std::int64_t next = integer(place_size());
  if (code == end_code) {
    ended = true;
    return {};
  }
  if (code == dimension_code) {
    if (!has(4)) return fail("the file ends within Dimension");
    const std::int64_t dimension = integer(4);
    if (dimension_ != 0) return fail("a second section Dimension");
    if (dimension != 2 && dimension != 3)
      return fail("Dimension: " + std::to_string(dimension) + " is not 2");
    dimension_ = static_cast<int>(dimension);
    text_ += "Dimension " + std::to_string(dimension) + "\n";
  } else if (const section_kind* const kind = find_section(code, &section_kind::code)) {
    if (dimension_ == 0) return fail("a section before Dimension");
    if (auto failed = read_records(*kind)) return failed;
  }
  if (next == 0) {
    ended = true;
    return {};
  }
  if (next < static_cast<std::int64_t>(at_) || next > static_cast<std::int64_t>(bytes_.size()))
    return fail("the next section should begin at byte " + std::to_string(next) +
                ", outside of the rest of the file");
  at_ = static_cast<std::size_t>(next);
  return {};
}

// Reads the types of a solution's fields, which follow the count.
std::optional<error> decoder::read_types(std::size_t& reals) {
  if (!has(4)) return fail("the file ends within SolAtVertices");
  const std::int64_t types = integer(4);
  if (types < 1 || types > 1000 || !has(4 * static_cast<std::size_t>(types)))
    return fail("SolAtVertices: " + std::to_string(types) + " types");
  text_ += std::to_string(types);
  const auto d = static_cast<std::size_t>(dimension_);
  for (std::int64_t i = 0; i < types; ++i) {
    const std::int64_t type = integer(4);
    if (type < 1 || type > 3) return fail("SolAtVertices: type " + std::to_string(type));
    reals += type == 1 ? 1 : type == 2 ? d : d * (d + 1) / 2;
    text_ += ' ';
    text_ += std::to_string(type);
  }
  text_ += "\n";
  return {};
}

std::optional<error> decoder::read_records(const section_kind& kind) {
  if (!has(integer_size())) return fail("the file ends within " + std::string(kind.keyword));
  const std::int64_t count = integer(integer_size());
  text_ += std::string(kind.keyword) + "\n" + std::to_string(count) + "\n";
  std::size_t reals = kind.has_place ? static_cast<std::size_t>(dimension_) : 0;
  if (kind.code == solution_code)
    if (auto failed = read_types(reals)) return failed;
  const std::size_t size =
      reals * real_size() + static_cast<std::size_t>(kind.integers) * integer_size();
  if (count < 0 || static_cast<std::uint64_t>(count) > (bytes_.size() - at_) / size)
    return fail(std::string(kind.keyword) + ": the file does not hold " + std::to_string(count) +
                " of them");
  for (std::int64_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < reals; ++k) {
      append_number(text_, real());
      text_ += ' ';
    }
    for (int k = 0; k < kind.integers; ++k) {
      append_integer(text_, integer(integer_size()));
      text_ += ' ';
    }
    text_.back() = '\n';
  }
  return {};
}

class encoder {
 public:
  encoder(const std::string& text, bool long_places) : source_("", text), long_(long_places) {}

  std::string bytes(const std::vector<std::size_t>& required_edges);

 private:
  void put(std::uint64_t value, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) bytes_ += static_cast<char>(value >> (8 * i));
  }
  void put_integer(std::int64_t value) {
    put(static_cast<std::uint32_t>(static_cast<std::int32_t>(value)), 4);
  }
  std::int64_t next_integer() { return to_integer(source_, source_.next(), "").value(); }
  std::size_t place_size() const { return long_ ? 8 : 4; }
  // Begins a section and leaves room for the position of the next one, which end_section fills in.
  void begin_section(int code) {
    put_integer(code);
    place_ = bytes_.size();
    put(0, place_size());
  }
  void end_section() {
    const std::uint64_t here = bytes_.size();
    for (std::size_t i = 0; i < place_size(); ++i)
      bytes_[place_ + i] = static_cast<char>(here >> (8 * i));
  }
  void put_records(const section_kind& kind);

  text_scanner source_;
  bool long_;
  std::int64_t dimension_ = 2;
  std::size_t place_ = 0;
  std::string bytes_;
};

void encoder::put_records(const section_kind& kind) {
  const std::int64_t count = next_integer();
  begin_section(kind.code);
  put_integer(count);
  std::int64_t reals = kind.has_place ? dimension_ : 0;
  if (kind.code == solution_code) {
    const std::int64_t types = next_integer();
    put_integer(types);
    for (std::int64_t i = 0; i < types; ++i) {
      const std::int64_t type = next_integer();
      put_integer(type);
      reals += type;  // 1, 2 or 3: the number of reals of each kind in two dimensions
    }
  }
  for (std::int64_t i = 0; i < count; ++i) {
    for (std::int64_t k = 0; k < reals; ++k)
      put(std::bit_cast<std::uint64_t>(to_number(source_, source_.next(), "").value()), 8);
    for (int k = 0; k < kind.integers; ++k) put_integer(next_integer());
  }
  end_section();
}

std::string encoder::bytes(const std::vector<std::size_t>& required_edges) {
  put_integer(1);
  put_integer(long_ ? 3 : 2);
  for (word w = source_.next(); !w.empty() && w.text != "End"; w = source_.next()) {
    if (w.text == "MeshVersionFormatted") {
      source_.next();
    } else if (w.text == "Dimension") {
      dimension_ = next_integer();
      begin_section(dimension_code);
      put_integer(dimension_);
      end_section();
    } else if (const section_kind* const kind = find_section(w.text, &section_kind::keyword)) {
      put_records(*kind);
    }
  }
  if (!required_edges.empty()) {
    begin_section(find_section(std::string_view("RequiredEdges"), &section_kind::keyword)->code);
    put_integer(static_cast<std::int64_t>(required_edges.size()));
    for (const std::size_t e : required_edges) put_integer(static_cast<std::int64_t>(e));
    end_section();
  }
  put_integer(end_code);
  put(0, place_size());
  return std::move(bytes_);
}

}  // namespace

bool is_medit_binary(const std::filesystem::path& path) {
  return has_ending(path.string(), ".meshb") || has_ending(path.string(), ".solb");
}

result<std::string> text_of_medit_binary(const std::string& file, std::string_view bytes) {
  return decoder(file, bytes).text();
}

result<std::string> read_medit_text(const std::filesystem::path& path) {
  auto read = read_text_file(path);
  if (!read || !is_medit_binary(path)) return read;
  return text_of_medit_binary(path.string(), read.value());
}

std::string medit_binary_of_text(const std::string& text,
                                 const std::vector<std::size_t>& required_edges) {
  // Chooses the version: binary is no longer than text, since two digits and a blank become four
  // bytes at most.
  const bool is_long = text.size() > std::numeric_limits<std::int32_t>::max() / 4;
  return encoder(text, is_long).bytes(required_edges);
}

}  // namespace asterism::internal
