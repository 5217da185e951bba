// SPDX-License-Identifier: MIT
//
// GeoJSON, RFC 7946. nlohmann's library reports by exceptions; none leaves this file.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "asterism/mesh/io/json_places.hpp"
#include "asterism/mesh/io/polygon_domain.hpp"
#include "asterism/mesh/io/polygons.hpp"
#include "asterism/mesh/io/text_scanner.hpp"

namespace asterism::internal {
namespace {

using nlohmann::json;

// Thrown by the readers below, inside read_geojson alone.
struct malformed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

[[noreturn]] void refuse(const std::string& place, const std::string& what) {
  throw malformed((place.empty() ? "the root" : place) + ": " + what);
}

const json& member(const json& object, const char* key, const std::string& place) {
  if (!object.is_object() || !object.contains(key))
    refuse(place, std::string("there is no \"") + key + "\"");
  return object[key];
}

const json& list(const json& value, const std::string& place) {
  if (!value.is_array()) refuse(place, "a list is wanted");
  return value;
}

std::string item(const std::string& place, std::size_t i) {
  return place + "[" + std::to_string(i) + "]";
}

point point_of(const json& value, const std::string& place) {
  const bool usable = value.is_array() && value.size() >= 2 && value[0].is_number() &&
                      value[1].is_number() && std::isfinite(value[0].get<double>()) &&
                      std::isfinite(value[1].get<double>());
  if (!usable) refuse(place, "two finite numbers are wanted");
  return {value[0].get<double>(), value[1].get<double>()};
}

ring ring_of(const json& value, const std::string& place) {
  ring corners;
  std::size_t i = 0;
  for (const json& p : list(value, place)) corners.push_back(point_of(p, item(place, i++)));
  open_ring(corners);
  if (corners.size() < 3) refuse(place, "a ring of fewer than three corners");
  return corners;
}

void add_polygon(const json& value, const std::string& place, int region,
                 std::vector<polygon>& polygons) {
  polygon made;
  made.region = region;
  std::size_t i = 0;
  for (const json& r : list(value, place)) made.rings.push_back(ring_of(r, item(place, i++)));
  if (made.rings.empty()) refuse(place, "an empty polygon");
  polygons.push_back(std::move(made));
}

class geojson_reader {
 public:
  std::vector<polygon> polygons;
  int features = 0;

  // Collections within collections are followed this deep.
  void add(const json& object, const std::string& place, int depth = 0) {
    constexpr int deepest = 16;
    if (depth > deepest) refuse(place, "collections are nested too deeply");
    const json& kind = member(object, "type", place);
    const std::string inner = place.empty() ? "" : place + ".";
    const int region = std::max(1, features);
    if (kind == "FeatureCollection") {
      each(object, "features", inner, depth);
    } else if (kind == "GeometryCollection") {
      each(object, "geometries", inner, depth);
    } else if (kind == "Feature") {
      ++features;
      const json& geometry = member(object, "geometry", place);
      if (!geometry.is_null()) add(geometry, inner + "geometry", depth + 1);
    } else if (kind == "Polygon") {
      add_polygon(member(object, "coordinates", place), inner + "coordinates", region, polygons);
    } else if (kind == "MultiPolygon") {
      std::size_t i = 0;
      const std::string there = inner + "coordinates";
      for (const json& p : list(member(object, "coordinates", place), there))
        add_polygon(p, item(there, i++), region, polygons);
    } else {
      refuse(place, "the type is " + kind.dump() + ", and polygons alone bound a domain");
    }
  }

 private:
  void each(const json& object, const char* key, const std::string& inner, int depth) {
    std::size_t i = 0;
    for (const json& one : list(member(object, key, inner), inner + key))
      add(one, item(inner + key, i++), depth + 1);
  }
};

}  // namespace

result<domain> read_geojson(const std::filesystem::path& path) {
  const auto text = read_text_file(path);
  if (!text.ok()) return text.failure();
  const auto failure = [&](const std::string& what) {
    return error{path.string() + ": " + what, error_code::malformed_file};
  };
  try {
    geojson_reader reader;
    reader.add(json::parse(text.value()), "");
    if (reader.polygons.empty()) return failure("there is no polygon");
    auto made = domain_of_polygons(reader.polygons, reader.features > 1);
    if (!made.ok()) return made.failure().at(path.string());
    made.value().name = path.string();
    return made;
  } catch (const malformed& e) {
    return failure(e.what());
  } catch (const json::parse_error& e) {
    return error{path.string() + ":" + std::to_string(line_of_byte(text.value(), e.byte)) +
                     ": this is not JSON",
                 error_code::malformed_file};
  } catch (const json::exception&) {
    return failure("this is not GeoJSON");
  }
}

}  // namespace asterism::internal
