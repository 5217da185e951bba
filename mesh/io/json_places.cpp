// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/json_places.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <system_error>
#include <utility>

namespace asterism::internal {
namespace {

constexpr int deepest = 32;

class place_finder {
 public:
  explicit place_finder(std::string_view text) : text_(text) {}

  json_places run() {
    read_value("", 0);
    return std::move(places_);
  }

 private:
  // True if reading can go on behind the value.
  bool read_value(const std::string& name, int depth) {
    skip_space();
    if (at_ >= text_.size()) return false;
    if (!name.empty()) places_.lines.try_emplace(name, line_);
    if (depth > deepest) {
      places_.too_deep = json_place{name, line_};
      return false;
    }
    switch (text_[at_]) {
      case '{':
        return read_members(name, depth);
      case '[':
        return read_elements(name, depth);
      case '"':
        return read_string().has_value();
      default:
        return read_word(name);
    }
  }

  bool read_members(const std::string& name, int depth) {
    ++at_;
    std::set<std::string> seen;
    if (next_is('}')) return true;
    do {
      skip_space();
      const auto key = read_string();
      if (!key) return false;
      const std::string member = name.empty() ? *key : name + "." + *key;
      if (!seen.insert(*key).second && !places_.repeated)
        places_.repeated = json_place{member, line_};
      if (!next_is(':') || !read_value(member, depth + 1)) return false;
    } while (next_is(','));
    return next_is('}');
  }

  bool read_elements(const std::string& name, int depth) {
    ++at_;
    if (next_is(']')) return true;
    do {
      if (!read_value(name, depth + 1)) return false;
    } while (next_is(','));
    return next_is(']');
  }

  // Escapes stay as they are written.
  std::optional<std::string> read_string() {
    if (at_ >= text_.size() || text_[at_] != '"') return std::nullopt;
    const std::size_t begin = ++at_;
    while (at_ < text_.size() && text_[at_] != '"') at_ += text_[at_] == '\\' ? 2 : 1;
    if (at_ >= text_.size()) return std::nullopt;
    return std::string(text_.substr(begin, at_++ - begin));
  }

  bool read_word(const std::string& name) {
    const std::size_t begin = at_;
    constexpr std::string_view ends = ",]} \t\r\n";
    while (at_ < text_.size() && ends.find(text_[at_]) == std::string_view::npos) ++at_;
    double value = 0;
    const auto read = std::from_chars(text_.data() + begin, text_.data() + at_, value);
    if (read.ec == std::errc::result_out_of_range && is_large(text_.substr(begin, at_ - begin)) &&
        !places_.beyond_doubles)
      places_.beyond_doubles = json_place{name, line_};
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

}  // namespace

json_places find_json_places(std::string_view text) { return place_finder(text).run(); }

std::size_t line_of_byte(std::string_view text, std::size_t byte) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
  return 1 + static_cast<std::size_t>(std::count(text.begin(), end, '\n'));
}

}  // namespace asterism::internal
