// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/json_places.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <system_error>
#include <utility>

namespace asterism::internal {

static constexpr int deepest = 32;

class place_finder {
 public:
  explicit place_finder(std::string_view text) : text_(text) {}

  json_places run() {
    read_value(json_places::root, 0);
    return std::move(places_);
  }

 private:
  // Reads a member's value, or a value without a name; returns true if reading can continue behind
  // it.
  bool read_value(std::size_t owner, int depth) {
    skip_space();
    if (at_ >= text_.size()) return false;
    if (depth > deepest) {
      places_.too_deep = place_of(owner);
      return false;
    }
    switch (text_[at_]) {
      case '{':
        return read_members(owner, depth);
      case '[':
        return read_elements(owner, depth);
      case '"':
        return read_string().has_value();
      default:
        return read_word(owner);
    }
  }

  json_place place_of(std::size_t owner) const { return {places_.name_of(owner), line_}; }

  bool read_members(std::size_t owner, int depth) {
    ++at_;
    std::set<std::string_view> seen;
    if (next_is('}')) return true;
    do {
      skip_space();
      const auto key = read_string();
      if (!key) return false;
      const std::size_t member = places_.members_.size();
      places_.members_.push_back({owner, *key, line_});
      if (!seen.insert(*key).second && !places_.repeated) places_.repeated = place_of(member);
      if (!next_is(':')) return false;
      skip_space();
      places_.members_[member].line = line_;
      if (!read_value(member, depth + 1)) return false;
    } while (next_is(','));
    return next_is('}');
  }

  bool read_elements(std::size_t owner, int depth) {
    ++at_;
    if (next_is(']')) return true;
    do {
      if (!read_value(owner, depth + 1)) return false;
    } while (next_is(','));
    return next_is(']');
  }

  // Keeps escapes as they are written.
  std::optional<std::string_view> read_string() {
    if (at_ >= text_.size() || text_[at_] != '"') return std::nullopt;
    const std::size_t begin = ++at_;
    while (at_ < text_.size() && text_[at_] != '"') at_ += text_[at_] == '\\' ? 2 : 1;
    if (at_ >= text_.size()) return std::nullopt;
    return text_.substr(begin, at_++ - begin);
  }

  bool read_word(std::size_t owner) {
    const std::size_t begin = at_;
    constexpr std::string_view ends = ",]} \t\r\n";
    while (at_ < text_.size() && ends.find(text_[at_]) == std::string_view::npos) ++at_;
    double value = 0;
    const auto read = std::from_chars(text_.data() + begin, text_.data() + at_, value);
    if (read.ec == std::errc::result_out_of_range && is_large(text_.substr(begin, at_ - begin)) &&
        !places_.beyond_doubles)
      places_.beyond_doubles = place_of(owner);
    return at_ > begin;
  }

  // True if a number that is out of range is too large, not too small.
  static bool is_large(std::string_view number) {
    const auto exponent = number.find_first_of("eE");
    return exponent == std::string_view::npos || number.substr(exponent + 1, 1) != "-";
  }

  void skip_space() {
    for (; at_ < text_.size(); ++at_) {
      if (text_[at_] == '\n')
        ++line_;
      else if (text_[at_] != ' ' && text_[at_] != '\t' && text_[at_] != '\r')
        return;
    }
  }

  bool next_is(char wanted) {
    skip_space();
    if (at_ >= text_.size() || text_[at_] != wanted) return false;
    ++at_;
    return true;
  }

  std::string_view text_;
  std::size_t at_ = 0, line_ = 1;
  json_places places_;
};

std::string json_places::name_of(std::size_t m) const {
  std::vector<std::string_view> keys;  // the last first
  for (; m != root; m = members_[m].parent) keys.push_back(members_[m].key);
  std::string name;
  for (auto key = keys.rbegin(); key != keys.rend(); ++key) {
    if (!name.empty()) name += '.';
    name += *key;
  }
  return name;
}

// True if the member's name is this one or, unless the whole name is required, ends in it.
bool json_places::is_named(std::size_t m, std::string_view name, bool whole) const {
  for (; m != root; m = members_[m].parent) {
    const std::string_view key = members_[m].key;
    if (!name.ends_with(key)) return false;
    name.remove_suffix(key.size());
    if (name.empty()) return !whole || members_[m].parent == root;
    if (!name.ends_with('.')) return false;
    name.remove_suffix(1);
  }
  return false;
}

std::size_t json_places::line_of(std::string_view name) const {
  for (const bool whole : {true, false})
    for (std::size_t m = 0; m < members_.size(); ++m)
      if (is_named(m, name, whole)) return members_[m].line;
  return 0;
}

json_places find_json_places(std::string_view text) { return place_finder(text).run(); }

std::optional<std::size_t> line_nested_beyond(std::string_view text, std::size_t most) {
  std::size_t depth = 0;
  bool in_string = false;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (in_string && c == '\\')
      ++at;
    else if (c == '"')
      in_string = !in_string;
    else if (!in_string && (c == '{' || c == '['))
      ++depth;
    else if (!in_string && (c == '}' || c == ']') && depth > 0)
      --depth;
    if (depth > most) return line_of_byte(text, at);
  }
  return std::nullopt;
}

std::size_t line_of_byte(std::string_view text, std::size_t byte) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
  return 1 + static_cast<std::size_t>(std::count(text.begin(), end, '\n'));
}

}  // namespace asterism::internal
