// SPDX-License-Identifier: MIT
//
// Splits the markup of a VTK file into tags, with line numbers: the part of XML that such files
// use. Comments and declarations are skipped; entities in attributes stay as they are written.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "asterism/core/result.hpp"

namespace asterism::internal {

struct xml_tag {
  std::string_view name;  // empty at the end of the text
  std::vector<std::pair<std::string_view, std::string_view>> attributes;
  bool closes = false;         // </name>
  bool closes_itself = false;  // <name ... />
  std::size_t line = 0;        // from 1

  // Returns the value of an attribute; empty where there is none.
  std::string_view operator[](std::string_view attribute) const;
};

// Splits a text, which must outlive the scanner and its tags.
class xml_scanner {
 public:
  xml_scanner(std::string file, std::string_view text) : file_(std::move(file)), text_(text) {}

  // Returns the next tag; one without a name at the end of the text. Fails, naming the line, for a
  // tag that does not end or is malformed.
  result<xml_tag> next();
  // Returns the text from the present place to the next tag.
  std::string_view content() const;
  // Returns the text from the present place on.
  std::string_view rest() const { return text_.substr(position_); }
  std::size_t line() const { return line_; }
  error failure(std::size_t line, const std::string& what) const;

 private:
  void advance(std::size_t to);
  result<xml_tag> parse(std::string_view inside) const;

  std::string file_;
  std::string_view text_;
  std::size_t position_ = 0, line_ = 1;
};

}  // namespace asterism::internal
