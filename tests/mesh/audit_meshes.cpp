// SPDX-License-Identifier: MIT
#include "audit_meshes.hpp"

#include <algorithm>

namespace asterism::test {
namespace {

void number_points(patch& p, double jitter, const metric_tensor& metric) {
  const int n = p.n;
  p.number.assign(static_cast<std::size_t>((n + 1) * (n + 1)), 0);
  small_generator random(7);
  const auto add = [&](int i, int j) {
    point q = {i + 0.5 * j, 0.875 * j};
    if (i > 0 && i < n && j > 0 && j < n)
      q = {q.x + random.between(-jitter, jitter), q.y + random.between(-jitter, jitter)};
    p.number[static_cast<std::size_t>(i + j * (n + 1))] = static_cast<index>(p.m.sites.size());
    p.m.sites.push_back({q, metric});
  };
  for (const auto& [i, j] : {std::pair{0, 0}, {n, 0}, {n, n}, {0, n}}) add(i, j);
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      if ((i != 0 && i != n) || (j != 0 && j != n)) add(i, j);
}

}  // namespace

patch make_patch(int n, double jitter, const metric_tensor& metric) {
  patch p;
  p.n = n;
  number_points(p, jitter, metric);
  p.m.given = 4;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      p.m.triangles.push_back({p.at(i, j), p.at(i + 1, j), p.at(i, j + 1)});
      p.m.triangles.push_back({p.at(i + 1, j), p.at(i + 1, j + 1), p.at(i, j + 1)});
    }
  for (int i = 0; i < n; ++i) {
    p.m.boundary.push_back({p.at(i, 0), p.at(i + 1, 0), 0, 10});
    p.m.boundary.push_back({p.at(n, i), p.at(n, i + 1), 1, 11});
    p.m.boundary.push_back({p.at(n - i, n), p.at(n - i - 1, n), 2, 12});
    p.m.boundary.push_back({p.at(0, n - i), p.at(0, n - i - 1), 3, 13});
  }
  p.d.name = "parallelogram";
  for (index v = 0; v < 4; ++v) {
    p.d.vertices.push_back(p.m.sites[v].position);
    p.d.segments.push_back({v, (v + 1) % 4, 10 + static_cast<int>(v)});
  }
  return p;
}

patch stretched(patch p, double stretch) {
  for (site& s : p.m.sites) {
    s.position.y *= stretch;
    s.metric.m22 = s.metric.m11 / (stretch * stretch);
  }
  for (point& q : p.d.vertices) q.y *= stretch;
  return p;
}

mesh make_mesh_of(const std::vector<point>& points, const std::vector<triangle>& triangles) {
  mesh m;
  for (const point& q : points) m.sites.push_back({q, round_metric});
  m.given = static_cast<index>(points.size());
  m.triangles = triangles;
  const auto has_edge = [&](index a, index b) {
    return std::any_of(triangles.begin(), triangles.end(), [&](const triangle& t) {
      return (t[0] == a && t[1] == b) || (t[1] == a && t[2] == b) || (t[2] == a && t[0] == b);
    });
  };
  for (const triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i)
      if (!has_edge(t[(i + 1) % 3], t[i])) m.boundary.push_back({t[i], t[(i + 1) % 3], 0, 0});
  return m;
}

bool found(const audit_report& report, finding_kind kind) {
  return report.found[static_cast<std::size_t>(kind)] != 0;
}

std::string witnesses(const audit_report& report, finding_kind kind) {
  std::string text;
  for (const audit_finding& f : report.findings)
    if (f.kind == kind) text += f.witness + "\n";
  return text;
}

std::string kinds(const audit_report& report) {
  std::string text;
  for (const audit_finding& f : report.findings)
    text +=
        std::string(finding_kind_names[static_cast<std::size_t>(f.kind)]) + ": " + f.witness + "\n";
  return text;
}

}  // namespace asterism::test
