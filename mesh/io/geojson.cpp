// SPDX-License-Identifier: MIT
//
// Reads GeoJSON, RFC 7946. Catches the exceptions by which nlohmann's library reports errors.
#include "asterism/mesh/io/geojson.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/io/json_places.hpp"
#include "asterism/mesh/io/polygon_domain.hpp"
#include "asterism/mesh/io/text_scanner.hpp"

namespace asterism::internal {
namespace {

// Exception of the readers below, which parse_geojson catches.
struct malformed_geojson : std::runtime_error {
  using std::runtime_error::runtime_error;
};

std::string shown(const std::string& place) { return place.empty() ? "the root" : place; }

[[noreturn]] void refuse(const std::string& place, const std::string& what) {
  throw malformed_geojson(shown(place) + ": " + what);
}

const nlohmann::json& member(const nlohmann::json& object, const char* key,
                             const std::string& place) {
  if (!object.is_object() || !object.contains(key))
    refuse(place, std::string("there is no \"") + key + "\"");
  return object[key];
}

const nlohmann::json& list(const nlohmann::json& value, const std::string& place) {
  if (!value.is_array()) refuse(place, "a list is wanted");
  return value;
}

std::string item(const std::string& place, std::size_t i) {
  return place + "[" + std::to_string(i) + "]";
}

class geojson_reader {
 public:
  polygons_read made;
  int features = 0;

  // Adds an object; follows collections within collections to a limited depth.
  void add(const nlohmann::json& object, const std::string& place, int depth = 0) {
    constexpr int deepest = 16;
    if (depth > deepest) refuse(place, "collections are nested too deeply");
    const nlohmann::json& type = member(object, "type", place);
    if (!type.is_string()) refuse(place, "the type is no string");
    const std::string& kind = type.get_ref<const std::string&>();
    const std::string inner = place.empty() ? "" : place + ".";
    if (kind == "FeatureCollection") return each(object, "features", inner, depth);
    if (kind == "GeometryCollection") return each(object, "geometries", inner, depth);
    if (kind == "Feature") return add_feature(object, place, depth);
    constexpr std::array<std::string_view, 4> others = {"Point", "MultiPoint", "LineString",
                                                        "MultiLineString"};
    if (std::find(others.begin(), others.end(), kind) != others.end())
      return made.others.add([&] { return shown(place) + ", a " + kind; });
    if (kind != "Polygon" && kind != "MultiPolygon")
      refuse(place, "the type is " + quoted_token(kind) + ", which GeoJSON does not have");
    add_polygons(list(member(object, "coordinates", place), inner + "coordinates"),
                 inner + "coordinates", kind == "MultiPolygon");
  }

 private:
  void each(const nlohmann::json& object, const char* key, const std::string& inner, int depth) {
    std::size_t i = 0;
    const nlohmann::json& all = list(member(object, key, inner), inner + key);
    if (all.empty()) add_empty(inner + key);
    for (const nlohmann::json& one : all) add(one, item(inner + key, i++), depth + 1);
  }

  void add_empty(const std::string& place) {
    made.empty.add([&] { return place; });
  }

  void add_feature(const nlohmann::json& object, const std::string& place, int depth) {
    ++features;
    const nlohmann::json& geometry = member(object, "geometry", place);
    const std::string there = (place.empty() ? "" : place + ".") + "geometry";
    if (geometry.is_null()) return add_empty(there);
    add(geometry, there, depth + 1);
  }

  void add_polygons(const nlohmann::json& coordinates, const std::string& place, bool several) {
    if (coordinates.empty()) return add_empty(place);
    if (!several) return add_polygon(coordinates, place);
    std::size_t i = 0;
    for (const nlohmann::json& p : coordinates) {
      const std::string there = item(place, i++);
      if (list(p, there).empty())
        add_empty(there);
      else
        add_polygon(p, there);
    }
  }

  void add_polygon(const nlohmann::json& rings, const std::string& place) {
    polygon& p = made.polygons.emplace_back();
    p.region = std::max(1, features);
    std::size_t i = 0;
    for (const nlohmann::json& r : rings) {
      const std::string there = item(place, i++);
      ring& corners = p.rings.emplace_back();
      corners.reserve(list(r, there).size());
      for (const nlohmann::json& q : r) corners.push_back(point_of(q, there, corners.size()));
    }
  }

  // Reads a point; `ring` and `i` name its place in messages.
  point point_of(const nlohmann::json& value, const std::string& ring, std::size_t i) {
    const auto is_usable = [](const nlohmann::json& x) {
      return x.is_number() && std::isfinite(x.get<double>());
    };
    if (!value.is_array() || value.size() < 2 || !is_usable(value[0]) || !is_usable(value[1]))
      refuse(item(ring, i), "two finite numbers are wanted");
    if (value.size() > 3 || (value.size() == 3 && value[2] != 0))
      made.heights.add([&] { return item(ring, i); });
    return {value[0].get<double>(), value[1].get<double>()};
  }
};

}  // namespace

result<domain> parse_geojson(std::string_view text, const std::string& name) {
  const auto at_line = [&](std::size_t line, const std::string& what) {
    return error{name + ":" + std::to_string(line) + ": " + what, error_code::malformed_file};
  };
  constexpr std::size_t deepest = 500;
  if (const auto line = line_nested_beyond(text, deepest))
    return at_line(*line, "lists and objects are nested too deeply");
  try {
    geojson_reader reader;
    reader.add(nlohmann::json::parse(text), "");
    if (reader.features < 2)
      for (polygon& p : reader.made.polygons) p.region.reset();
    return domain_of_polygons(reader.made, name);
  } catch (const malformed_geojson& e) {
    return error{name + ": " + without_controls(e.what()), error_code::malformed_file};
  } catch (const nlohmann::json::parse_error& e) {
    return at_line(line_of_byte(text, e.byte), "this is not JSON");
  } catch (const nlohmann::json::out_of_range&) {
    return error{name + ": a number is beyond the range of doubles", error_code::malformed_file};
  } catch (const nlohmann::json::exception&) {
    return error{name + ": this is not GeoJSON", error_code::malformed_file};
  }
}

result<domain> read_geojson(const std::filesystem::path& path) {
  const auto text = read_text_file(path);
  if (!text.ok()) return text.failure();
  return parse_geojson(text.value(), path.string());
}

}  // namespace asterism::internal
