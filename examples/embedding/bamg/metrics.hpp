// SPDX-License-Identifier: MIT
//
// The ten metrics of the comparison, on [-1,1]^2.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <string>

using metric = std::array<double, 3>;  // m11 m12 m22
using metric_function = std::function<metric(double, double)>;

// Returns the tensor with size `along` in the direction of the angle, and `across` at a right angle
// to it.
inline metric of_sizes(double angle, double along, double across) {
  const double c = std::cos(angle), s = std::sin(angle);
  const double a = 1 / (along * along), b = 1 / (across * across);
  return {a * c * c + b * s * s, (a - b) * c * s, a * s * s + b * c * c};
}

// Stretched along circles about the origin, by the radius times the square root of the strength.
inline metric_function swirl(double strength, double size) {
  return [=](double x, double y) -> metric {
    const double k = 1 / (size * size);
    return {k * (1 + strength * x * x), k * strength * x * y, k * (1 + strength * y * y)};
  };
}

// Returns the metric of least L2 error of linear interpolation at a density (Loseille and Alauzet
// 2011): the Hessian with absolute eigenvalues, times density times its determinant to the power
// -1/6.
inline metric of_hessian(double h11, double h12, double h22, double density) {
  const double mean = (h11 + h22) / 2, half = (h11 - h22) / 2;
  const double root = std::sqrt(half * half + h12 * h12);
  const double angle = std::atan2(h12, half) / 2;
  const double floor = 1e-3 * (std::fabs(mean) + root) + 1e-2;
  const double l1 = std::fmax(std::fabs(mean + root), floor);
  const double l2 = std::fmax(std::fabs(mean - root), floor);
  const double scale = density * std::pow(l1 * l2, -1.0 / 6);
  return of_sizes(angle, 1 / std::sqrt(scale * l1), 1 / std::sqrt(scale * l2));
}

// tanh 20 (r^2 - 1/2).
inline metric circle_shock(double x, double y) {
  const double t = std::tanh(20 * (x * x + y * y - 0.5)), d = 1 - t * t;
  const double second = -2 * t * d * 400, first = d * 20;
  return of_hessian(second * 4 * x * x + first * 2, second * 4 * x * y,
                    second * 4 * y * y + first * 2, 120);
}

// tanh 5 (2 x - sin 5 y).
inline metric curved_shock(double x, double y) {
  const double t = std::tanh(5 * (2 * x - std::sin(5 * y))), d = 1 - t * t;
  const double second = -2 * t * d * 25, first = d * 5;
  const double u = 2, v = -5 * std::cos(5 * y);
  return of_hessian(second * u * u, second * u * v, second * v * v + first * 25 * std::sin(5 * y),
                    120);
}

inline metric_function metric_named(const std::string& name) {
  constexpr double tilt = 0.5235987755982988;  // 30 degrees
  if (name == "uniform") return [](double, double) { return of_sizes(0, 0.05, 0.05); };
  if (name == "swirl-12") return swirl(12, 0.1);
  if (name == "swirl-60") return swirl(60, 0.1);
  if (name == "swirl-400") return swirl(400, 0.15);
  if (name == "layer")
    return [](double, double y) { return of_sizes(0, 0.1, 0.002 + 0.1 * std::fabs(y)); };
  if (name == "rays")
    return [](double x, double y) {
      return of_sizes(std::atan2(y, x), 0.15, 0.02 + 0.1 * std::sqrt(x * x + y * y));
    };
  if (name == "tilted-100") return [](double, double) { return of_sizes(tilt, 0.5, 0.005); };
  if (name == "tilted-10000") return [](double, double) { return of_sizes(tilt, 5, 0.0005); };
  if (name == "circle-shock") return circle_shock;
  if (name == "curved-shock") return curved_shock;
  return nullptr;
}
