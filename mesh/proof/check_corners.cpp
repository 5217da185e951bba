// SPDX-License-Identifier: MIT
//
// Point 3 of docs/math/proof-format.md: no angle is below the bound, in the metric of any vertex of
// its triangle, except at corners of the domain that are sharper than the bound themselves.
#include "asterism/mesh/proof/check_corners.hpp"

#include <mpfr.h>

#include <algorithm>
#include <atomic>
#include <vector>

#include "asterism/mesh/proof/number.hpp"
#include "asterism/mesh/proof/proof_words.hpp"
#include "asterism/mesh/support/parallel.hpp"

namespace asterism::internal::proof_detail {
namespace {

// Bounds of the square of a cotangent, and a double with an error bound whose interval contains
// both.
struct cotangent_bounds {
  rational low, high;
  bounded between;
};

rational squared_cotangent(double degrees, mpfr_rnd_t away, mpfr_rnd_t towards) {
  constexpr int bits = 192;
  mpfr_t angle, pi;
  mpfr_inits2(bits, angle, pi, static_cast<mpfr_ptr>(nullptr));
  mpfr_const_pi(pi, away);
  mpfr_mul_d(angle, pi, degrees, away);
  mpfr_div_ui(angle, angle, 180, away);
  mpfr_tan(angle, angle, away);
  mpfr_sqr(angle, angle, away);
  mpfr_ui_div(angle, 1, angle, towards);
  rational value;
  mpfr_get_q(value.backend().data(), angle);
  mpfr_clears(angle, pi, static_cast<mpfr_ptr>(nullptr));
  return value;
}

// Returns the bounds for an angle in degrees; they are equal where the square is rational.
cotangent_bounds bounds_of(double degrees) {
  cotangent_bounds bounds;
  bounds.low = squared_cotangent(degrees, MPFR_RNDU, MPFR_RNDD);
  bounds.high = squared_cotangent(degrees, MPFR_RNDD, MPFR_RNDU);
  const std::pair<double, rational> known[] = {{30, 3}, {45, 1}, {60, rational(1) / 3}};
  for (const auto& [angle, value] : known)
    if (degrees == angle) bounds.low = bounds.high = value;
  const double near = bounds.low.convert_to<double>();
  bounds.between = bounded::within(near, near * 0x1p-50);
  return bounds;
}

bounded in_arithmetic(const cotangent_bounds& c, const rational&, const bounded&) {
  return c.between;
}
rational in_arithmetic(const cotangent_bounds&, const rational& exact, const rational&) {
  return exact;
}

class corner_check {
 public:
  corner_check(const plane& all, const proof_question& asked)
      : all_(all),
        given_(asked.shape == nullptr ? all.subject.sites.size() : all.subject.given),
        is_own_(asked.shape == nullptr),
        bound_(bounds_of(asked.angle_bound)),
        exempt_(all.inner_count(), 0) {}

  std::optional<error> run() {
    constexpr std::size_t chunk = 1024;
    const std::size_t count = all_.inner_count();
    std::vector<std::size_t> failed(chunk_count(count, chunk), count);
    parallel_chunks(count, chunk, [&](std::size_t nth, std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end && failed[nth] == count; ++t)
        if (!is_wide(static_cast<std::uint32_t>(t))) failed[nth] = t;
    });
    const std::size_t first = *std::min_element(failed.begin(), failed.end());
    if (first != count)
      return not_shown("triangle " + std::to_string(first + 1) + " has an angle below the bound");
    if (2 * enclosed() > count || (is_own_ && is_nothing_free()))
      return not_shown("next to nothing of the mesh is judged");
    return std::nullopt;
  }

 private:
  // True if each angle of the triangle is at least the bound, in each of the three metrics, or
  // exempt.
  bool is_wide(std::uint32_t t) {
    for (const vertex_index p : all_.triangles[t])
      for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t e = 3 * t + i;
        const vertex_index v = all_.corner(e), a = all_.corner(e, 1), b = all_.corner(e, 2);
        if (!is_angle_wide(v, a, b, p) && !is_exempt(e, p)) return false;
      }
    return true;
  }

  template <class Number>
  std::array<Number, 2> terms(vertex_index v, vertex_index a, vertex_index b,
                              vertex_index p) const {
    const auto to_a = way<Number>(all_.position(v), all_.position(a)),
               to_b = way<Number>(all_.position(v), all_.position(b));
    const tensor<Number> metric(all_.subject.sites[p].metric);
    const Number area = cross(to_a, to_b);
    return {dot(to_a, metric * to_b), metric.determinant() * area * area};
  }

  bool is_angle_wide(vertex_index v, vertex_index a, vertex_index b, vertex_index p) const {
    return decide([&](auto zero) {
      using number = decltype(zero);
      const auto [along, square] = terms<number>(v, a, b, p);
      const number c = in_arithmetic(bound_, bound_.low, zero);
      return reaches_zero(zero - along) | reaches_zero(c * square - along * along);
    });
  }
  bool is_angle_narrow(vertex_index v, vertex_index a, vertex_index b, vertex_index p) const {
    return decide([&](auto zero) {
      using number = decltype(zero);
      const auto [along, square] = terms<number>(v, a, b, p);
      const auto to_a = way<number>(all_.position(v), all_.position(a)),
                 to_b = way<number>(all_.position(v), all_.position(b));
      const number c = in_arithmetic(bound_, bound_.high, zero);
      return exceeds_zero(cross(to_a, to_b)) & exceeds_zero(along) &
             exceeds_zero(along * along - c * square);
    });
  }

  // True if the angle is at a vertex of the domain, between two successive segments whose angle is
  // below the bound, both in the metric of that vertex and in the metric of p.
  bool is_exempt(std::uint32_t e, vertex_index p) {
    const vertex_index v = all_.corner(e);
    if (v >= given_) return false;
    std::uint32_t first = e, last = plane::previous(e);
    for (std::size_t steps = 0; !all_.is_segment[first]; first = plane::next(all_.across[first]))
      if (++steps > all_.inner_count()) return false;
    for (std::size_t steps = 0; !all_.is_segment[last]; last = plane::previous(all_.across[last]))
      if (++steps > all_.inner_count()) return false;
    const vertex_index a = all_.corner(first, 1), b = all_.corner(last);
    if (!is_angle_narrow(v, a, b, v) || !is_angle_narrow(v, a, b, p)) return false;
    exempt_[e / 3] = 1;
    return true;
  }

  // True if any angle is exempt and every inner edge is a segment: then no vertex can be free.
  bool is_nothing_free() const {
    if (std::find(exempt_.begin(), exempt_.end(), 1) == exempt_.end()) return false;
    const std::size_t inner = 3 * all_.inner_count();
    for (std::size_t e = 0; e < inner; ++e)
      if (all_.across[e] < inner && !all_.is_segment[e]) return false;
    return true;
  }

  // Returns the number of exempt triangles all of whose sides are segments, at least one of them
  // inside the domain.
  std::size_t enclosed() const {
    std::size_t count = 0;
    const std::size_t inner = 3 * all_.inner_count();
    for (std::size_t e = 0; e < inner; e += 3) {
      const bool all_three = all_.is_segment[e] && all_.is_segment[e + 1] && all_.is_segment[e + 2];
      const bool is_inside =
          all_.across[e] < inner || all_.across[e + 1] < inner || all_.across[e + 2] < inner;
      count += exempt_[e / 3] && all_three && is_inside ? 1 : 0;
    }
    return count;
  }

  const plane& all_;
  std::size_t given_;
  bool is_own_;  // the mesh is its own domain
  cotangent_bounds bound_;
  std::vector<char> exempt_;  // by triangle; each is written by one thread
};

}  // namespace

std::optional<error> check_corners(const plane& all, const proof_question& asked) {
  if (asked.angle_bound == 0) return std::nullopt;
  return corner_check(all, asked).run();
}

}  // namespace asterism::internal::proof_detail
