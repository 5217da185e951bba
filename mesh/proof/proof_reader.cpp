// SPDX-License-Identifier: MIT
#include "asterism/mesh/proof/proof_reader.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <utility>

namespace asterism::internal {
namespace {

// Reads numbers from bytes, least byte first. Beyond the end it returns 0, and is_short() is true.
class byte_reader {
 public:
  explicit byte_reader(std::string_view bytes) : bytes_(bytes) {}

  template <class Unsigned>
  Unsigned take() {
    if (bytes_.size() - at_ < sizeof(Unsigned)) {
      is_short_ = true;
      at_ = bytes_.size();
      return 0;
    }
    Unsigned number = 0;
    for (std::size_t i = 0; i < sizeof(Unsigned); ++i)
      number = static_cast<Unsigned>(
          number |
          static_cast<Unsigned>(Unsigned{static_cast<unsigned char>(bytes_[at_ + i])} << (8 * i)));
    at_ += sizeof(Unsigned);
    return number;
  }
  std::uint32_t number() { return take<std::uint32_t>(); }
  std::int32_t signed_number() { return static_cast<std::int32_t>(number()); }
  double real() { return std::bit_cast<double>(take<std::uint64_t>()); }
  proof_point point_of_grid() {
    const std::int32_t a = signed_number();
    return {a, signed_number()};
  }
  // Reads a number of bytes, negative for a negative number, then the bytes of its absolute value,
  // least first.
  proof_detail::whole whole_number() {
    const auto size = static_cast<std::int16_t>(take<std::uint16_t>());
    std::vector<std::uint8_t> bytes;
    for (int i = 0; i < std::abs(int{size}) && !is_short_; ++i)
      bytes.push_back(take<std::uint8_t>());
    proof_detail::whole number = 0;
    mpz_import(number.backend().data(), bytes.size(), -1, 1, 0, 0, bytes.data());
    return size < 0 ? proof_detail::whole(-number) : number;
  }
  // True if `rows` rows of `size` bytes each are left.
  bool holds(std::size_t rows, std::size_t size) const {
    return rows <= (bytes_.size() - at_) / size;
  }
  bool is_short() const { return is_short_; }
  bool is_at_end() const { return at_ == bytes_.size() && !is_short_; }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
  bool is_short_ = false;
};

error not_a_proof(const char* what) { return {what, error_code::malformed_file}; }

proof_exception take_exception(byte_reader& from) {
  proof_exception e;
  e.gap = from.number();
  e.site = from.number();
  const auto kind = from.take<std::uint8_t>();
  e.why = static_cast<proof_exception::reason>(kind < 4 ? kind : kind < 7 ? 4 : 5);
  e.turn = from.take<std::uint8_t>();
  const std::size_t points = from.take<std::uint16_t>();
  for (std::size_t i = 0; i < points && !from.is_short(); ++i)
    e.points.push_back(from.point_of_grid());
  if (e.why == proof_exception::reason::meeting) {
    constexpr std::array<std::size_t, 3> sizes = {3, 9, 18};
    for (std::size_t i = 0; i < sizes[kind - 4u] && !from.is_short(); ++i)
      e.weights.push_back(from.whole_number());
  }
  return e;
}

struct section_sizes {
  std::size_t outside = 0, places = 0, edges = 0, gaps = 0, exceptions = 0;
};

bool take_sections(byte_reader& from, const section_sizes& sizes, mesh_proof& proof) {
  if (!from.holds(sizes.outside, 12)) return false;
  for (std::size_t i = 0; i < sizes.outside; ++i) {
    triangle& t = proof.outside.emplace_back();
    for (vertex_index& v : t) v = from.number();
  }
  if (!from.holds(sizes.places, 4)) return false;
  for (std::size_t i = 0; i < sizes.places; ++i) proof.places.push_back(from.number());
  if (!from.holds(sizes.edges, 8)) return false;
  for (std::size_t i = 0; i < sizes.edges; ++i) proof.edges.push_back(from.point_of_grid());
  if (!from.holds(sizes.gaps, 16)) return false;
  for (std::size_t i = 0; i < sizes.gaps; ++i) {
    proof_gap gap;
    gap.on_x = from.signed_number();
    gap.between = from.point_of_grid();
    gap.on_y = from.signed_number();
    proof.gaps.push_back(gap);
  }
  if (!from.holds(sizes.exceptions, 12)) return false;
  for (std::size_t i = 0; i < sizes.exceptions; ++i)
    proof.exceptions.push_back(take_exception(from));
  return from.is_at_end();
}

}  // namespace

result<mesh_proof> read_proof(std::string_view bytes, const mesh& subject) {
  constexpr std::string_view name = "ASTPROOF";
  if (!bytes.starts_with(name)) return not_a_proof("it is no proof");
  byte_reader from(bytes.substr(name.size()));
  if (from.number() != 2) return not_a_proof("it is a proof of another version");
  if (from.number() != subject.sites.size() || from.number() != subject.triangles.size())
    return not_a_proof("it is the proof of another mesh");
  section_sizes sizes;
  for (std::size_t* size :
       {&sizes.outside, &sizes.places, &sizes.edges, &sizes.gaps, &sizes.exceptions})
    *size = from.number();
  mesh_proof proof;
  for (double* bound :
       {&proof.low.x, &proof.low.y, &proof.high.x, &proof.high.y, &proof.squared_radius})
    *bound = from.real();
  if (!take_sections(from, sizes, proof)) return not_a_proof("the proof is not as long as it says");
  std::sort(proof.exceptions.begin(), proof.exceptions.end(),
            [](const proof_exception& l, const proof_exception& r) {
              return std::pair(l.site, l.gap) < std::pair(r.site, r.gap);
            });
  return proof;
}

}  // namespace asterism::internal
