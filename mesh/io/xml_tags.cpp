// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/xml_tags.hpp"

#include <algorithm>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/io/text_scanner.hpp"

namespace asterism::internal {
namespace {

constexpr std::string_view blanks = " \t\r\n";

std::string_view after_blanks(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(blanks);
  return begin == std::string_view::npos ? std::string_view() : text.substr(begin);
}

}  // namespace

std::string_view xml_tag::operator[](std::string_view attribute) const {
  for (const auto& [key, value] : attributes)
    if (key == attribute) return value;
  return {};
}

error xml_scanner::failure(std::size_t line, const std::string& what) const {
  return {file_ + ":" + std::to_string(line) + ": " + without_controls(what),
          error_code::malformed_file};
}

void xml_scanner::advance(std::size_t to) {
  line_ +=
      static_cast<std::size_t>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(position_),
                                          text_.begin() + static_cast<std::ptrdiff_t>(to), '\n'));
  position_ = to;
}

std::string_view xml_scanner::content() const {
  return text_.substr(position_, text_.find('<', position_) - position_);
}

result<xml_tag> xml_scanner::next() {
  while (true) {
    const std::size_t open = text_.find('<', position_);
    if (open == std::string_view::npos) {
      advance(text_.size());
      return xml_tag{{}, {}, false, false, line_};
    }
    advance(open);
    const bool is_comment = text_.substr(open).starts_with("<!--");
    const std::string_view ending = is_comment ? "-->" : ">";
    const std::size_t close = text_.find(ending, open);
    if (close == std::string_view::npos)
      return failure(line_, "a tag begins here and does not end");
    const std::string_view inside = text_.substr(open + 1, close - open - 1);
    const bool is_skipped = is_comment || inside.starts_with('?') || inside.starts_with('!');
    if (!is_skipped) {
      auto tag = parse(inside);
      advance(close + 1);
      return tag;
    }
    advance(close + ending.size());
  }
}

// Reads `/name`, or `name attribute="value" ...` with or without a slash at the end.
result<xml_tag> xml_scanner::parse(std::string_view inside) const {
  xml_tag tag;
  tag.line = line_;
  if (inside.starts_with('/')) {
    tag.closes = true;
    inside.remove_prefix(1);
  } else if (inside.ends_with('/')) {
    tag.closes_itself = true;
    inside.remove_suffix(1);
  }
  tag.name = inside.substr(0, inside.find_first_of(blanks));
  if (tag.name.empty()) return failure(line_, "a tag has no name");
  inside = after_blanks(inside.substr(tag.name.size()));
  while (!inside.empty()) {
    const std::size_t equals = inside.find('=');
    const std::string_view name = inside.substr(0, inside.find_first_of(" \t\r\n="));
    const std::string_view value =
        equals == std::string_view::npos ? "" : after_blanks(inside.substr(equals + 1));
    const std::size_t close = value.size() < 2 ? std::string_view::npos : value.find(value[0], 1);
    if (close == std::string_view::npos || (value[0] != '"' && value[0] != '\''))
      return failure(line_, quoted_token(inside) + " is no attribute with a value in quotes");
    tag.attributes.emplace_back(name, value.substr(1, close - 1));
    inside = after_blanks(value.substr(close + 1));
  }
  return tag;
}

}  // namespace asterism::internal
