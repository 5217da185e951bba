// SPDX-License-Identifier: MIT
//
// Writes what came of a challenge as text, Markdown or a page of HTML. All have the same
// tables: by class, by predicate, both, and the first record of each kind of failure.
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

// Rows of cells, and a head.
struct report_table {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
};

// A row a class, with a sum; columns of verdicts that no record got are left out, but for "wrong".
report_table table_by_class(const challenge_outcome& outcome);
// A row a predicate.
report_table table_by_predicate(const challenge_outcome& outcome);
// Rows are classes, columns predicates: records that were not answered rightly, of how many.
report_table table_of_both(const challenge_outcome& outcome);

// Sentences on the whole: what was not asked, and why.
std::vector<std::string> remarks(const challenge_outcome& outcome);

// "wrong", "crashed", "slow": what a witness is of.
std::string_view kind_of(const witness& w);

std::string text_report(const challenge_outcome& outcome);
std::string markdown_report(const challenge_outcome& outcome, const report_heading& heading);
// report_html.cpp.
std::string html_report(const challenge_outcome& outcome, const report_heading& heading);

}  // namespace asterism::challenge
