// SPDX-License-Identifier: MIT
//
// Writes the results of a challenge as text, Markdown or a page of HTML. All have the same tables:
// by class, by predicate, both, and the first record of each kind of failure.
#pragma once

#include <string>
#include <vector>

#include "asterism/challenge/referee.hpp"

namespace asterism::challenge {

// Facts of a report besides the counts.
struct report_heading {
  std::string command;  // as it was typed
  record_choice records;
  run_limits limits;
  std::string version;
};

// A table: its head and its rows of cells.
struct report_table {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
};

// Returns a table with a row for each class, and a sum; columns of verdicts that no record got are
// left out, except for "wrong".
report_table table_by_class(const challenge_outcome& outcome);
// Returns a table with a row for each predicate.
report_table table_by_predicate(const challenge_outcome& outcome);
// Returns a table of classes by predicates: the number of records that were not answered correctly,
// and the number of all.
report_table table_of_both(const challenge_outcome& outcome);

// Returns sentences on the whole: what was not asked, and why.
std::vector<std::string> remarks(const challenge_outcome& outcome);

// Returns the kind of failure of a witness: "wrong", "crashed", "slow".
std::string_view kind_of(const witness& w);

std::string text_report(const challenge_outcome& outcome);
std::string markdown_report(const challenge_outcome& outcome, const report_heading& heading);
// Returns the report as a page (report_html.cpp).
std::string html_report(const challenge_outcome& outcome, const report_heading& heading);

}  // namespace asterism::challenge
