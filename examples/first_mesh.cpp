// SPDX-License-Identifier: MIT
//
// A domain and a metric of one's own: an L-shape, with triangles flat along its long sides.
#include <asterism/mesh/mesher.hpp>
#include <cmath>
#include <iostream>

namespace {

// Four times finer across than along: near the left side in x, near the bottom in y.
class layers : public asterism::metric_field {
 public:
  asterism::result<asterism::metric_tensor> at(const asterism::point& q) const override {
    const double across_x = 1 + 15 * std::exp(-4 * q.x), across_y = 1 + 15 * std::exp(-4 * q.y);
    return asterism::metric_tensor{across_x, 0, across_y};
  }
};

int complain(const asterism::error& failure) {
  std::cerr << failure.message << '\n';
  return 1;
}

}  // namespace

int main() {
  asterism::domain shape;
  shape.vertices = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  for (asterism::vertex_index i = 0; i < 6; ++i) shape.segments.push_back({i, (i + 1) % 6, 1});
  const auto checked = asterism::check_domain(shape);
  if (!checked) return complain(checked.failure());

  asterism::mesh_options wanted;
  wanted.angle_bound = 20;
  const auto made = asterism::make_certified_mesh(checked.value(), layers(), wanted);
  if (!made) return complain(made.failure());
  const asterism::mesh_outcome& outcome = made.value().outcome;
  std::cout << outcome.sites << " sites, " << outcome.triangles
            << " triangles: " << asterism::ending_text(outcome) << '\n';
  const asterism::audit_report& report = made.value().report;
  for (const auto& finding : report.findings) std::cout << finding.witness << '\n';
  std::cout << (made.value().certified() ? "certified" : "not certified") << ", worst angle "
            << report.worst().degrees << " degrees\n";

  const auto files = asterism::write_mesh("l_shape.svg", outcome.result);
  if (!files) return complain(files.failure());
  return made.value().certified() ? 0 : 1;
}
