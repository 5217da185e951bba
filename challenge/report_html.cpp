// SPDX-License-Identifier: MIT
//
// Writes the report as one page of HTML that needs no other file.
#include "asterism/challenge/report.hpp"

namespace asterism::challenge {
namespace {

constexpr std::string_view style =
    "body{font:15px/1.45 sans-serif;max-width:70em;margin:2em auto;padding:0 1em;color:#222}"
    "table{border-collapse:collapse;margin:1em 0}"
    "th,td{padding:.25em .7em;text-align:right;border-bottom:1px solid #ddd}"
    "th:first-child,td:first-child{text-align:left}"
    "td.bad{background:#fbe0dc}td.good{color:#2c7a3f}"
    "pre{background:#f4f4f4;padding:.6em;overflow-x:auto}";

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

// True for columns that count failures: all but the name, the records, the right answers and the
// time.
bool counts_failures(const std::string& head) {
  return head != "class" && head != "predicate" && head != "records" && head != "right" &&
         head != "us each";
}

bool is_none(const std::string& cell) { return cell == "-" || cell.front() == '0'; }

std::string in_html(const report_table& table) {
  std::string text = "<table><tr>";
  for (const std::string& cell : table.head) text += "<th>" + escaped(cell) + "</th>";
  text += "</tr>\n";
  for (const auto& row : table.rows) {
    text += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string kind = !counts_failures(table.head[i]) ? ""
                               : is_none(row[i])               ? " class=\"good\""
                                                               : " class=\"bad\"";
      text += "<td" + kind + ">" + escaped(row[i]) + "</td>";
    }
    text += "</tr>\n";
  }
  return text + "</table>\n";
}

std::string heading_text(const report_heading& heading) {
  return "<p>Asked by asterism " + escaped(heading.version) + ", seed " +
         std::to_string(heading.records.seed) + ", " + std::to_string(heading.records.count) +
         " records of each class and predicate.</p>\n";
}

std::string witnesses_text(const challenge_outcome& outcome) {
  if (outcome.witnesses.empty()) return "<p>There is none.</p>\n";
  std::string text = "<p>Each record can be fed to the program.</p>\n";
  for (const witness& w : outcome.witnesses)
    text += "<p>" + escaped(w.class_name) + ", " + escaped(kind_of(w)) + ": " + escaped(w.given) +
            ", exactly " + std::to_string(w.exact) + "</p><pre>" + escaped(w.record) + "</pre>\n";
  return text;
}

}  // namespace

std::string html_report(const challenge_outcome& outcome, const report_heading& heading) {
  std::string text =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Challenge of " +
      escaped(heading.command) + "</title><style>" + std::string(style) +
      "</style></head><body>\n<h1>Challenge of <code>" + escaped(heading.command) +
      "</code></h1>\n" + heading_text(heading);
  for (const std::string& remark : remarks(outcome)) text += "<p>" + escaped(remark) + "</p>\n";
  text += "<h2>By class</h2>\n" + in_html(table_by_class(outcome));
  text += "<h2>By predicate</h2>\n" + in_html(table_by_predicate(outcome));
  text += "<h2>Not right, by class and predicate</h2>\n" + in_html(table_of_both(outcome));
  text += "<h2>The classes</h2>\n<ul>\n";
  for (std::size_t i = 0; i < outcome.class_names.size(); ++i)
    text += "<li>" + escaped(outcome.class_names[i]) + ": " + escaped(outcome.class_texts[i]) +
            "</li>\n";
  text += "</ul>\n<h2>The first of each kind</h2>\n" + witnesses_text(outcome);
  return text + "</body></html>\n";
}

}  // namespace asterism::challenge
