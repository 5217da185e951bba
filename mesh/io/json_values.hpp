// SPDX-License-Identifier: MIT
//
// Writes and reads the values that several kinds of JSON files hold: points, digests, domains.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/io/certificate_json.hpp"

namespace asterism::internal {

// Exception of the readers below. The reader of a whole file catches it.
struct malformed : std::runtime_error {
  malformed(std::string field, const std::string& what)
      : std::runtime_error(what), name(std::move(field)) {}
  std::string name;  // of the field
};

// Return a text from a file, or the text of a value, for messages: shortened, since it may have any
// length.
std::string shortened(std::string text);
std::string shown(const certificate_json& value);

// Returns a member of an object; errors name its key, as in every reader below.
const certificate_json& member(const certificate_json& object, const std::string& key);

template <class T>
T value_of(const certificate_json& object, const std::string& key) {
  try {
    return member(object, key).get<T>();
  } catch (const certificate_json::exception&) {
    throw malformed(key, "\"" + key + "\" is not what it should be");
  }
}

std::size_t count_of(const certificate_json& object, const std::string& key);
// Returns a number that counts from 1 as an index.
vertex_index index_of(const certificate_json& number, const std::string& key);
const certificate_json& array_of(const certificate_json& object, const std::string& key);
std::vector<vertex_index> indices_of(const certificate_json& object, const std::string& key);
std::vector<point> points_of(const certificate_json& object, const std::string& key);
// Returns the number that sixteen hexadecimal digits are.
std::uint64_t digest_in(const certificate_json& object, const std::string& key);
// Reads a domain. Checks of its curves only that their vertices are vertices of the domain.
domain domain_of(const certificate_json& object);

// Returns the indices as numbers from 1.
std::vector<std::size_t> from_one(const std::vector<vertex_index>& numbers);
certificate_json points_json(const std::vector<point>& points);
std::string digest_text(std::uint64_t digest);

// True if a segment is internal, or beside a region other than 1.
bool needs_sides(const segment& s);

// Ways to write a domain's lists of vertices and segments. A segment has six numbers (with_sides),
// or three if needs_sides() is false (as_needed). Lists that are left_out, as they may be very
// long, are empty.
enum class domain_rows : std::uint8_t { left_out, as_needed, with_sides };

// Writes curves only if there are any.
certificate_json domain_json(const domain& d, domain_rows rows);

}  // namespace asterism::internal
