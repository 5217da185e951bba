// SPDX-License-Identifier: MIT
#include "asterism/mesh/proof/proof_bytes.hpp"

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

namespace asterism::internal {
namespace {

// Collects numbers as bytes, least byte first, and passes them on in blocks.
class byte_stream {
 public:
  explicit byte_stream(const std::function<void(std::string_view)>& put) : put_(put) {}

  template <class Unsigned>
  void add(Unsigned number) {
    for (std::size_t i = 0; i < sizeof(Unsigned); ++i)
      bytes_ += static_cast<char>(static_cast<unsigned char>(number >> (8 * i)));
    constexpr std::size_t piece = 65536;
    if (bytes_.size() >= piece) flush();
  }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
  void add(const proof_point& p) {
    for (const std::int32_t part : p) add(static_cast<std::uint32_t>(part));
  }
  void add_count(std::size_t count) { add(static_cast<std::uint32_t>(count)); }
  void flush() {
    put_(bytes_);
    bytes_.clear();
  }

 private:
  const std::function<void(std::string_view)>& put_;
  std::string bytes_;
};

// Adds the number of bytes, negative for a negative number, then the bytes of its absolute value,
// least first.
void add_whole(byte_stream& to, const proof_detail::whole& number) {
  const mpz_t& digits = number.backend().data();
  std::vector<std::uint8_t> bytes((mpz_sizeinbase(digits, 2) + 7) / 8);
  std::size_t count = 0;
  mpz_export(bytes.data(), &count, -1, 1, 0, 0, digits);
  bytes.resize(count);
  const auto size = static_cast<std::uint16_t>(bytes.size());
  to.add(static_cast<std::uint16_t>(number < 0 ? -size : size));
  for (const std::uint8_t byte : bytes) to.add(byte);
}

// Returns the number of the exception's kind in the format. Meetings with weights of degree 1 and 2
// have the next two numbers after meetings with weights of degree 0.
std::uint8_t kind_of(const proof_exception& e) {
  const auto kind = static_cast<std::uint8_t>(e.why);
  return static_cast<std::uint8_t>(kind + (e.weights.size() > 9   ? 2
                                           : e.weights.size() > 3 ? 1
                                                                  : 0));
}

void add_exception(byte_stream& to, const proof_exception& e) {
  to.add(e.gap);
  to.add(e.site);
  to.add(kind_of(e));
  to.add(e.turn);
  to.add(static_cast<std::uint16_t>(e.points.size()));
  for (const proof_point& p : e.points) to.add(p);
  for (const proof_detail::whole& weight : e.weights) add_whole(to, weight);
}

}  // namespace

void write_proof(const mesh& subject, const mesh_proof& proof,
                 const std::function<void(std::string_view)>& put) {
  put("ASTPROOF");
  byte_stream to(put);
  constexpr std::uint32_t version = 2;
  to.add(version);
  to.add_count(subject.sites.size());
  to.add_count(subject.triangles.size());
  to.add_count(proof.outside.size());
  to.add_count(proof.places.size());
  to.add_count(proof.edges.size());
  to.add_count(proof.gaps.size());
  to.add_count(proof.exceptions.size());
  for (const double bound :
       {proof.low.x, proof.low.y, proof.high.x, proof.high.y, proof.squared_radius})
    to.add(bound);
  for (const triangle& t : proof.outside)
    for (const vertex_index v : t) to.add(v);
  for (const std::uint32_t t : proof.places) to.add(t);
  for (const proof_point& p : proof.edges) to.add(p);
  for (const proof_gap& gap : proof.gaps) {
    to.add(static_cast<std::uint32_t>(gap.on_x));
    to.add(gap.between);
    to.add(static_cast<std::uint32_t>(gap.on_y));
  }
  for (const proof_exception& e : proof.exceptions) add_exception(to, e);
  to.flush();
}

}  // namespace asterism::internal
