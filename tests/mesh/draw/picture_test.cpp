// SPDX-License-Identifier: MIT
#include "asterism/mesh/draw/picture.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "asterism/mesh/draw/fine_triangles.hpp"
#include "asterism/mesh/draw/outline.hpp"
#include "asterism/tests/mesh/io/sample_mesh.hpp"

using namespace asterism;
using tests::sample_mesh;

namespace {

std::string drawn(const mesh& m, picture_format format, const picture_options& options = {}) {
  const auto picture = draw_picture(m, format, options);
  INFO((picture.ok() ? "" : picture.failure().message));
  REQUIRE(picture.ok());
  return picture.value();
}

// Reads a big-endian number, as PNG has it.
unsigned number_at(const std::string& bytes, std::size_t at) {
  unsigned value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value = value * 256 + static_cast<unsigned char>(bytes[at + i]);
  return value;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

}  // namespace

TEST_CASE("each format has its signature and is as large as asked") {
  const mesh m = sample_mesh(6);
  const std::string png = drawn(m, picture_format::png, {640});
  REQUIRE(png.substr(0, 8) == "\x89PNG\r\n\x1a\n");
  REQUIRE(number_at(png, 16) == 640);
  REQUIRE(number_at(png, 20) == 640);
  REQUIRE(drawn(m, picture_format::pdf).substr(0, 5) == "%PDF-");
  const std::string svg = drawn(m, picture_format::svg, {500});
  REQUIRE_THAT(svg, Catch::Contains("<svg") && Catch::Contains("viewBox=\"0 0 500 500\""));
}

TEST_CASE("the height follows the mesh") {
  mesh m = sample_mesh(3);
  for (site& s : m.sites) s.position.y /= 4;
  const std::string png = drawn(m, picture_format::png, {1000});
  REQUIRE(number_at(png, 20) == 30 + 235 + 30);
}

TEST_CASE("the same picture twice has the same bytes") {
  for (const auto format : {picture_format::svg, picture_format::pdf, picture_format::png})
    REQUIRE(drawn(sample_mesh(5), format, {300, true, true, 20}) ==
            drawn(sample_mesh(5), format, {300, true, true, 20}));
}

TEST_CASE("a mesh of more than 300 sites has no dots, a domain does") {
  const auto dots = [](const mesh& m) {
    return count(drawn(m, picture_format::svg, {800, true, false, 0}), "<path") -
           count(drawn(m, picture_format::svg, {800, false, false, 0}), "<path");
  };
  REQUIRE(dots(sample_mesh(16)) >= 17 * 17);
  REQUIRE(dots(sample_mesh(17)) == 0);
  mesh outline = sample_mesh(17);
  outline.triangles.clear();
  REQUIRE(dots(outline) >= 18 * 18);
}

TEST_CASE("options and the state of the mesh show in the picture") {
  mesh m = sample_mesh(5);
  const auto svg = [&](const picture_options& options) {
    return drawn(m, picture_format::svg, options);
  };
  const std::string bare = svg({800, false, false, 0});
  const std::string with_sites = svg({800, true, false, 0});
  REQUIRE(count(with_sites, "<path") >= count(bare, "<path") + m.sites.size());
  REQUIRE(count(svg({800, false, true, 0}), "<path") > count(bare, "<path") + 20);
  REQUIRE(svg({800, false, false, 60}) != bare);
  m.disagreeing.push_back(m.triangles.back());
  m.triangles.pop_back();
  REQUIRE(count(svg({800, false, false, 0}), "rgb(84%,15%,16%)") == 1);
}

TEST_CASE("tinted triangles are triangles") {
  mesh m = sample_mesh(3);
  const std::string svg = drawn(m, picture_format::svg, {800, false, false, 60});
  const std::size_t begin = svg.find("fill:rgb(98%,80%,38%)");
  REQUIRE(begin != std::string::npos);
  const std::string path = svg.substr(begin, svg.find("/>", begin) - begin);
  // Only a triangle that is equilateral in all three metrics has no angle below 60 degrees. So all
  // triangles are drawn.
  REQUIRE(count(path, "Z") == m.triangles.size());
  REQUIRE(count(path, " L ") == 2 * m.triangles.size());
}

TEST_CASE("what cannot be drawn is refused") {
  REQUIRE_FALSE(draw_picture(mesh{}, picture_format::png).ok());
  REQUIRE_FALSE(draw_picture(sample_mesh(2), picture_format::png, {0}).ok());
  REQUIRE_FALSE(draw_picture(sample_mesh(2), picture_format::png, {100000}).ok());
  mesh m = sample_mesh(2);
  for (site& s : m.sites) s.position.x = 1;
  REQUIRE_FALSE(draw_picture(m, picture_format::svg).ok());
  m = sample_mesh(2);
  for (site& s : m.sites) s.position.x *= 1e-6;
  REQUIRE_THAT(draw_picture(m, picture_format::png).failure().message,
               Catch::Contains("more than 20000 high"));
}

TEST_CASE("metrics of any size and shape are drawn") {
  mesh m = sample_mesh(6);
  m.sites[10].metric = {1e300, 0, 1e-300};
  m.sites[11].metric = {1e-200, 0, 1e-200};
  m.sites[12].metric = {1, 2, 1};
  for (const auto format : {picture_format::svg, picture_format::pdf, picture_format::png})
    REQUIRE(drawn(m, format, {400, true, true, 10}).size() > 1000);
}

TEST_CASE("colours fill every triangle, and a legend stands below") {
  mesh m = sample_mesh(5);
  for (std::size_t t = 0; t < m.triangles.size(); ++t) m.regions.push_back(t % 2 == 0 ? 3 : 8);
  const auto svg = [&](picture_by colours, double bound = 0) {
    picture_options options{800, false, false, bound};
    options.colours = colours;
    options.field = {"u", field_kind::scalar, std::vector<double>(m.sites.size(), 2)};
    options.field.values[4] = 5;
    return drawn(m, picture_format::svg, options);
  };
  const std::string plain = svg(picture_by::nothing);
  const auto height = [](const std::string& text) {
    const std::size_t at = text.find("height=\"") + 8;
    return std::stod(text.substr(at));
  };
  std::set<std::string> all = {plain};
  for (const auto by : {picture_by::angle, picture_by::aspect, picture_by::size, picture_by::region,
                        picture_by::marker, picture_by::field}) {
    const std::string coloured = svg(by);
    CHECK(height(coloured) > height(plain) + 20);
    if (by != picture_by::marker)
      CHECK(count(coloured, "<path") >= count(plain, "<path") + m.triangles.size());
    all.insert(coloured);
  }
  CHECK(all.size() == 7);
  CHECK(svg(picture_by::angle, 20) != svg(picture_by::angle));
  // There is a colour for each region. One of them has at least two triangles and a box of the
  // legend.
  std::map<std::string, int> fills;
  const std::string regions = svg(picture_by::region);
  for (std::size_t at = regions.find("rgb("); at != std::string::npos;
       at = regions.find("rgb(", at + 1))
    ++fills[regions.substr(at, regions.find(')', at) - at)];
  CHECK(std::count_if(fills.begin(), fills.end(), [](const auto& f) { return f.second > 3; }) >= 2);
}

TEST_CASE("lines hide triangles whose inscribed circle is less than two lines across") {
  mesh m;
  // Sides of 3, 4 and 5: the inscribed circle has radius 1.
  for (const point p : {point{0, 0}, point{4, 0}, point{0, 3}, point{-400, 0}})
    m.sites.push_back({p, {1, 0, 1}});
  m.triangles = {{0, 1, 2}, {0, 2, 3}};
  CHECK(internal::hidden_by_lines(m, 0.99) == std::vector<bool>{false, false});
  CHECK(internal::hidden_by_lines(m, 1.01) == std::vector<bool>{true, false});
  CHECK(internal::hidden_by_lines(m, 1.6) == std::vector<bool>{true, true});
  // The first set of triangles has a hundredth of the area, the second the other 99 hundredths.
  CHECK_FALSE(internal::are_most(m, {true, false}));
  CHECK(internal::are_most(m, {false, true}));
  CHECK_FALSE(internal::are_most(m, {}));
}

TEST_CASE("a mesh finer than lines is coloured by what tells most, and has no lines") {
  const auto shown = [](const mesh& m, picture_by colours) {
    picture_options options{200};
    options.colours = colours;
    return drawn(m, picture_format::png, options);
  };
  // Triangles are 0.94 and 9.4 lines wide in the picture.
  mesh m = sample_mesh(350);
  CHECK((shown(m, picture_by::nothing) == shown(m, picture_by::angle)));
  CHECK(
      (shown(sample_mesh(100), picture_by::nothing) != shown(sample_mesh(100), picture_by::angle)));
  mesh flat = m;
  for (site& s : flat.sites) s.position.y /= 5;
  CHECK((shown(flat, picture_by::nothing) == shown(flat, picture_by::aspect)));
  mesh graded = sample_mesh(420);  // an angle-preserving map
  for (site& s : graded.sites) {
    const auto [x, y] = s.position;
    s.position = {std::exp(0.7 * x) * std::cos(0.7 * y), std::exp(0.7 * x) * std::sin(0.7 * y)};
  }
  CHECK((shown(graded, picture_by::nothing) == shown(graded, picture_by::size)));
}

TEST_CASE("colours of what is not there are refused") {
  mesh m = sample_mesh(2);
  picture_options options;
  options.colours = picture_by::field;
  options.field = {"u", field_kind::scalar, {1}};
  REQUIRE_THAT(draw_picture(m, picture_format::svg, options).failure().message,
               Catch::Contains("u"));
  options.colours = picture_by::marker;
  m.boundary.clear();
  REQUIRE_FALSE(draw_picture(m, picture_format::svg, options).ok());
  options.colours = picture_by::angle;
  m.triangles.clear();
  REQUIRE_FALSE(draw_picture(m, picture_format::svg, options).ok());
}

TEST_CASE("the outline of a domain is drawn, whatever is wrong with it") {
  domain d;
  d.vertices = {{0, 0}, {2, 0}, {2, 1}, {0, 1}};
  d.segments = {{0, 1, 4}, {1, 3, 5}, {2, 9}};
  const mesh shown = internal::outline_of(d);
  REQUIRE(shown.boundary.size() == 2);
  REQUIRE(shown.boundary[1].marker == 5);
  REQUIRE(drawn(shown, picture_format::png, {400}).size() > 500);
}
