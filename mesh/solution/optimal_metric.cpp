// SPDX-License-Identifier: MIT
#include "asterism/mesh/solution/optimal_metric.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/numerics/nodal_sums.hpp"
#include "asterism/mesh/numerics/symmetric_eigen.hpp"
#include "asterism/mesh/numerics/target_search.hpp"

namespace asterism::internal {
namespace {

double power(double x, double exponent) {
  return x > 0 ? elementary::exp(exponent * elementary::log(x)) : 0;
}

double determinant_of(const metric_tensor& m) {
  const double product = m.m12 * m.m12;
  return std::fma(m.m11, m.m22, -product) + std::fma(-m.m12, m.m12, product);
}

// Returns the power of two by which a tensor is divided before its determinant is taken; 0 for
// ordinary ones.
int power_of(const metric_tensor& m) {
  constexpr int ordinary = 900;
  if (!(m.m11 > 0 && m.m22 > 0)) return 0;
  const int powers = std::ilogb(m.m11) + std::ilogb(m.m22);
  return std::abs(powers) > ordinary ? powers / 2 : 0;
}

metric_tensor divided(const metric_tensor& m, int power) {
  if (power == 0) return m;
  return {std::scalbn(m.m11, -power), std::scalbn(m.m12, -power), std::scalbn(m.m22, -power)};
}

double root_of(const metric_tensor& m) {
  const int power = power_of(m);
  const double root = std::sqrt(std::max(0.0, determinant_of(divided(m, power))));
  return power == 0 ? root : std::scalbn(root, power);
}

// Computes the optimum with logarithms of all numbers, so that no power overflows: the moduli
// divided by the greatest of all, D, the least density and the least eigenvalues allowed.
//
// At each place the density is the greatest of three: that without bounds, that with the weaker
// eigenvalue at its bound, and the least. With r = (2p+2) / (2p+1), moduli a >= b, the bound w and
// the least density q they are D (a b)^(p/(2p+2)), (D^r (a w)^(2-r))^(1/2), and q. The second is
// what makes the error least where one size is given: across, sizes follow a^(-p/(2p+1)), as along
// a line.
class optimum_search {
 public:
  optimum_search(const std::vector<symmetric_eigen>& moduli, const std::vector<double>& areas,
                 double exponent, const optimum_bounds& bounds)
      : areas_(areas), exponent_(exponent), power_(1 / (1 - exponent)), logs_(moduli.size()) {
    double greatest = 0;
    for (const symmetric_eigen& e : moduli) greatest = std::max({greatest, e.first, e.second});
    const double area = ordered_sum(areas.size(), [&](std::size_t v) { return areas[v]; });
    bound_ = elementary::log(bounds.floor_share / area);
    const double edge_bound = elementary::log(bounds.eigenvalue);
    for_each_node(moduli.size(), [&](std::size_t v) {
      const symmetric_eigen& e = moduli[v];
      const bool is_turned = e.first < e.second;
      const double longest =
          is_turned ? longest_in(bounds.sides, e.c, e.s) : longest_in(bounds.sides, e.s, e.c);
      logs_[v] = {log_of(std::max(e.first, e.second) / greatest),
                  log_of(std::min(e.first, e.second) / greatest),
                  edge_bound - 2 * elementary::log(longest), is_turned};
    });
    is_flat_ = !(greatest > 0) || !find_factor();
    if (is_flat_) bound_ = -elementary::log(area);
  }

  // True if no place has second derivatives: then the metric is the same everywhere.
  bool is_flat() const { return is_flat_; }

  // Returns the eigenvalues of the metric at a place, in the order of its moduli.
  std::array<double, 2> eigenvalues(std::size_t v) const {
    if (is_flat_) return {elementary::exp(bound_), elementary::exp(bound_)};
    const place& at = logs_[v];
    double strong = factor_ + (1 - exponent_) * at.strong - exponent_ * at.weak,
           weak = factor_ + (1 - exponent_) * at.weak - exponent_ * at.strong;
    if (!(weak >= at.edge_bound)) {
      strong = power_ * (factor_ - at.edge_bound) + (2 - power_) * at.strong + at.edge_bound;
      weak = at.edge_bound;
      // Makes edges equally long where they would be longer across than along.
      if (strong < weak) strong = weak = (strong + weak) / 2;
    }
    if (!(strong + weak >= 2 * bound_)) {
      strong = std::max(strong, bound_);
      weak = 2 * bound_ - strong;
    }
    strong = elementary::exp(strong);
    weak = elementary::exp(weak);
    return at.is_turned ? std::array{weak, strong} : std::array{strong, weak};
  }

  // Counts the places at a bound, and enters their shares of the complexity.
  void report(optimal_metric& made) const {
    if (is_flat_) return;
    for (std::size_t v = 0; v < logs_.size(); ++v) {
      const double free = factor_ + free_density(logs_[v]),
                   line = power_ / 2 * factor_ + line_density(logs_[v]);
      const bool is_flat = !(std::max(free, line) > bound_), is_ridge = !is_flat && line > free;
      if (is_flat) made.flat_part += areas_[v] * elementary::exp(bound_);
      if (is_ridge) made.ridge_part += areas_[v] * elementary::exp(line);
      if (is_flat || is_ridge) ++made.floored;
    }
  }

 private:
  struct place {
    double strong, weak;  // strong >= weak, at most 0, -infinity for none
    double edge_bound;    // of the weaker eigenvalue
    bool is_turned;       // the second of the moduli is the stronger
  };

  // Returns the length of the longest edge in this direction in a box with these sides; at most 1.
  static double longest_in(const std::array<double, 2>& sides, double x, double y) {
    return std::min({1.0, sides[0] / std::abs(x), sides[1] / std::abs(y)});
  }

  static double log_of(double x) {
    return x > 0 ? elementary::log(x) : -std::numeric_limits<double>::infinity();
  }

  double free_density(const place& p) const {
    return (0.5 - exponent_) * (p.strong + p.weak);  // less the logarithm of D
  }
  double line_density(const place& p) const {
    return (2 - power_) / 2 * (p.strong + p.edge_bound);  // less that of the root of D^r
  }

  // Finds D such that the complexity is 1. The logarithm of the complexity is a convex increasing
  // function of that of D, as for each place it is the greatest of three linear functions. So
  // Newton's method decreases to the solution from a D with which one of the sums alone is 1.
  // Returns false if there is none.
  bool find_factor() {
    const auto log_sum = [&](const auto& density) {
      return log_of(ordered_sum(logs_.size(), [&](std::size_t v) {
        return areas_[v] * elementary::exp(density(logs_[v]));
      }));
    };
    factor_ = std::min(-log_sum([&](const place& p) { return free_density(p); }),
                       -2 / power_ * log_sum([&](const place& p) { return line_density(p); }));
    if (!std::isfinite(factor_)) return false;
    constexpr int most_steps = 60;
    constexpr double close = 1e-13;
    target_search search(0, factor_);
    for (int step = 0; step < most_steps; ++step) {
      double slope = 0;
      const double off = log_complexity(slope);
      if (!(off > close)) break;
      search.take(off, slope);
      factor_ = search.at();
    }
    return true;
  }

  // Returns the logarithm of the complexity, and sets its derivative.
  double log_complexity(double& slope) const {
    const auto sum = [&](bool is_derivative) {
      return ordered_sum(logs_.size(), [&](std::size_t v) {
        const double free = factor_ + free_density(logs_[v]),
                     line = power_ / 2 * factor_ + line_density(logs_[v]);
        if (!(std::max(free, line) > bound_))
          return is_derivative ? 0 : areas_[v] * elementary::exp(bound_);
        const double density = areas_[v] * elementary::exp(std::max(free, line));
        return is_derivative ? density * (free >= line ? 1 : power_ / 2) : density;
      });
    };
    const double all = sum(false);
    slope = sum(true) / all;
    return elementary::log(all);
  }

  const std::vector<double>& areas_;
  double exponent_, power_;
  std::vector<place> logs_;
  double bound_ = 0, factor_ = 0;  // of density, D
  bool is_flat_ = false;
};

// Returns the L^p mean, over an equilateral triangle of side 1, of the error of interpolating (x^2
// + y^2) / 2: half of 1/3 less the squared distance from the middle. Integrates by the midpoints of
// 4096 parts.
double unit_error(double p) {
  constexpr int n = 64;
  const double height = std::sqrt(3.0) / 2;
  double sum = 0;
  const auto add = [&](double a, double b) {  // barycentric, of the corners (1,0) and (1/2, height)
    const double x = a + b / 2 - 0.5, y = height * b - height / 3;
    sum += power(std::max(0.0, 1.0 / 3 - x * x - y * y) / 2, p);
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) {
      add((i + 1.0 / 3) / n, (j + 1.0 / 3) / n);
      if (i + j + 1 < n) add((i + 2.0 / 3) / n, (j + 2.0 / 3) / n);
    }
  return power(sum / (n * n), 1 / p);
}

double error_constant(std::optional<double> norm) {
  if (!norm) return 1.0 / 6;
  return *norm == 1 ? 1.0 / 8 : unit_error(*norm);
}

// Moduli of half the sum and of half the difference of second derivatives a and b, which are along
// the axes of triangles that are equilateral in the metric.
struct equilateral_moduli {
  double mean, difference;
  // Returns half of |a| + |b|.
  double greater() const { return std::max(mean, difference); }
};

}  // namespace

double complexity_of(const std::vector<metric_tensor>& tensors, const std::vector<double>& areas) {
  return ordered_sum(tensors.size(), [&](std::size_t v) { return areas[v] * root_of(tensors[v]); });
}

optimal_metric make_optimal_metric(const std::vector<metric_tensor>& hessian,
                                   const std::vector<double>& areas, std::optional<double> norm,
                                   bool round, const optimum_bounds& bounds) {
  optimal_metric made;
  std::vector<symmetric_eigen> axes(hessian.size());
  for_each_node(hessian.size(), [&](std::size_t v) {
    symmetric_eigen& e = axes[v] = eigen_of(hessian[v]);
    e.first = std::abs(e.first);
    e.second = std::abs(e.second);
    if (round) e.first = e.second = std::max(e.first, e.second);
  });
  const optimum_search search(axes, areas, norm ? 1 / (2 * *norm + 2) : 0, bounds);
  made.is_flat = search.is_flat();
  made.tensors.resize(hessian.size());
  for_each_node(hessian.size(), [&](std::size_t v) {
    const auto [first, second] = search.eigenvalues(v);
    made.tensors[v] = with_eigenvalues(axes[v], first, second);
  });
  search.report(made);
  return made;
}

double predicted_error(const std::vector<metric_tensor>& tensors,
                       const std::vector<metric_tensor>& hessian, const std::vector<double>& areas,
                       std::optional<double> norm) {
  const auto moduli = [&](std::size_t v) {
    const int of_metric = power_of(tensors[v]);
    const metric_tensor m = divided(tensors[v], of_metric), &h = hessian[v];
    const double root = root_of(m);
    if (!(root > 0)) return equilateral_moduli{0, 0};
    // Computes half the trace and the determinant of M^-1 H, whose eigenvalues are a and b.
    const double mean = (m.m22 * h.m11 - 2 * m.m12 * h.m12 + m.m11 * h.m22) / (root * root) / 2,
                 product = determinant_of(h) / (root * root);
    const double difference = std::sqrt(std::max(0.0, mean * mean - product));
    return equilateral_moduli{std::scalbn(std::abs(mean), -of_metric),
                              std::scalbn(difference, -of_metric)};
  };
  if (!norm) {
    double error = 0;
    for (std::size_t v = 0; v < tensors.size(); ++v) error = std::max(error, moduli(v).greater());
    return error_constant(norm) * error;
  }
  // Scales by a power of two and back: squares of very large errors exceed the doubles.
  double greatest = 0;
  for (std::size_t v = 0; v < tensors.size(); ++v)
    greatest = std::max(greatest, moduli(v).greater());
  constexpr int ordinary = 200;
  const int beyond = greatest > 0 && std::isfinite(greatest) ? std::ilogb(greatest) : 0;
  const int out = std::abs(beyond) > ordinary ? beyond : 0;
  if (*norm == 2)
    return std::scalbn(std::sqrt(ordered_sum(tensors.size(),
                                             [&](std::size_t v) {
                                               const auto [mean, difference] = moduli(v);
                                               const double m = std::scalbn(mean, -out),
                                                            d = std::scalbn(difference, -out);
                                               return areas[v] * (m * m / 60 + d * d / 480);
                                             })),
                       out);
  const double sum = ordered_sum(tensors.size(), [&](std::size_t v) {
    const double e = std::scalbn(moduli(v).greater(), -out);
    return areas[v] * (*norm == 1 ? e : power(e, *norm));
  });
  return std::scalbn(error_constant(norm) * power(sum, 1 / *norm), out);
}

}  // namespace asterism::internal
