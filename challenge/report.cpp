// SPDX-License-Identifier: MIT
#include "asterism/challenge/report.hpp"

#include <algorithm>
#include <cmath>

namespace asterism::challenge {
namespace {

// The verdicts that have a column in tables.
std::vector<verdict> columns(const std::vector<tally>& rows) {
  std::vector<verdict> shown = {verdict::right, verdict::wrong};
  for (std::size_t i = 2; i < verdict_count; ++i) {
    const auto v = static_cast<verdict>(i);
    if (std::any_of(rows.begin(), rows.end(), [v](const tally& t) { return t.at(v) > 0; }))
      shown.push_back(v);
  }
  return shown;
}

std::string microseconds_each(const tally& t) {
  const std::size_t answered = t.records() - t.at(verdict::not_asked);
  if (answered == 0) return "-";
  return std::to_string(std::llround(1e6 * t.seconds / static_cast<double>(answered)));
}

report_table tallies_table(std::string first, const std::vector<std::string>& names,
                           std::vector<tally> rows) {
  tally sum;
  for (const tally& t : rows) sum += t;
  rows.push_back(sum);
  const auto shown = columns(rows);
  report_table table;
  table.head = {std::move(first), "records"};
  for (const verdict v : shown) table.head.emplace_back(verdict_names[static_cast<std::size_t>(v)]);
  table.head.insert(table.head.end(), {"slow", "us each"});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const tally& t = rows[i];
    std::vector<std::string> cells = {i < names.size() ? names[i] : "all",
                                      std::to_string(t.records())};
    for (const verdict v : shown) cells.push_back(std::to_string(t.at(v)));
    cells.insert(cells.end(), {std::to_string(t.slow), microseconds_each(t)});
    table.rows.push_back(std::move(cells));
  }
  return table;
}

std::string aligned(const report_table& table) {
  std::vector<std::size_t> widths(table.head.size());
  const auto measure = [&](const std::vector<std::string>& row) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  };
  measure(table.head);
  for (const auto& row : table.rows) measure(row);
  std::string text;
  const auto add = [&](const std::vector<std::string>& row) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string fill(widths[i] - row[i].size() + (i == 0 ? 0 : 2), ' ');
      text += i == 0 ? row[i] + fill : fill + row[i];
    }
    text += '\n';
  };
  add(table.head);
  for (const auto& row : table.rows) add(row);
  return text;
}

std::string markdown_row(const std::vector<std::string>& cells) {
  std::string text = "|";
  for (const std::string& cell : cells) {
    text += ' ';
    for (const char c : cell) text += c == '|' ? std::string("\\|") : std::string(1, c);
    text += " |";
  }
  return text + '\n';
}

std::string in_markdown(const report_table& table) {
  std::string text = markdown_row(table.head) + "|---|";
  for (std::size_t i = 1; i < table.head.size(); ++i) text += "--:|";
  text += '\n';
  for (const auto& row : table.rows) text += markdown_row(row);
  return text;
}

std::string joined(const std::vector<question>& all) {
  std::string text;
  for (const question& q : all) text += (text.empty() ? "" : ", ") + std::string(q.name);
  return text;
}

std::vector<std::string> names_of(const std::vector<question>& all) {
  std::vector<std::string> names;
  names.reserve(all.size());
  for (const question& q : all) names.emplace_back(q.name);
  return names;
}

}  // namespace

report_table table_by_class(const challenge_outcome& outcome) {
  std::vector<tally> rows;
  for (std::size_t i = 0; i < outcome.counts.size(); ++i) rows.push_back(outcome.of_class(i));
  return tallies_table("class", outcome.class_names, std::move(rows));
}

report_table table_by_predicate(const challenge_outcome& outcome) {
  std::vector<tally> rows;
  for (std::size_t i = 0; i < outcome.questions.size(); ++i) rows.push_back(outcome.of_question(i));
  return tallies_table("predicate", names_of(outcome.questions), std::move(rows));
}

report_table table_of_both(const challenge_outcome& outcome) {
  report_table table;
  table.head = names_of(outcome.questions);
  table.head.insert(table.head.begin(), "class");
  for (std::size_t i = 0; i < outcome.counts.size(); ++i) {
    std::vector<std::string> row = {outcome.class_names[i]};
    for (const tally& t : outcome.counts[i])
      row.push_back(t.records() == 0 ? "-"
                                     : std::to_string(t.records() - t.at(verdict::right)) + "/" +
                                           std::to_string(t.records()));
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::vector<std::string> remarks(const challenge_outcome& outcome) {
  std::vector<std::string> all;
  if (!outcome.unknown.empty())
    all.push_back("Not asked, since a simple question got no answer: " + joined(outcome.unknown) +
                  " (" + std::string(outcome.unknown.front().name) + ": " + outcome.unknown_told +
                  ").");
  if (outcome.questions.empty() && !outcome.out_of_time)
    all.emplace_back("The program answered none of them.");
  if (outcome.lingered)
    all.emplace_back("The program did not end after its last answer, and was killed.");
  if (outcome.gave_up)
    all.push_back("Given up after " + std::to_string(most_hangs) +
                  " questions that got no answer in time: the rest was not asked.");
  if (outcome.out_of_time)
    all.emplace_back("The time for the whole run is over: the rest was not asked.");
  if (outcome.left_behind)
    all.emplace_back("Something that the program started could not be ended, and goes on.");
  return all;
}

std::string_view kind_of(const witness& w) {
  return w.slow ? "slow" : verdict_names[static_cast<std::size_t>(w.what)];
}

std::string text_report(const challenge_outcome& outcome) {
  std::string text = aligned(table_by_class(outcome));
  if (outcome.questions.size() > 1) text += '\n' + aligned(table_by_predicate(outcome));
  for (const std::string& remark : remarks(outcome)) text += '\n' + remark + '\n';
  if (!outcome.witnesses.empty())
    text += "\nThe first of each kind (replay: echo 'RECORD' | COMMAND):\n";
  for (const witness& w : outcome.witnesses) {
    text += w.class_name + ", " + std::string(kind_of(w)) + ": " + w.given + ", exactly " +
            std::to_string(w.exact) + "\n  " + w.record + '\n';
  }
  return text;
}

std::string markdown_report(const challenge_outcome& outcome, const report_heading& heading) {
  std::string text = "# Challenge of `" + heading.command + "`\n\nAsked by asterism " +
                     heading.version + ", seed " + std::to_string(heading.records.seed) + ", " +
                     std::to_string(heading.records.count) +
                     " records of each class and predicate.\n";
  for (const std::string& remark : remarks(outcome)) text += '\n' + remark + '\n';
  text += "\n## By class\n\n" + in_markdown(table_by_class(outcome));
  text += "\n## By predicate\n\n" + in_markdown(table_by_predicate(outcome));
  text += "\n## Not right, by class and predicate\n\n" + in_markdown(table_of_both(outcome));
  text += "\n## The classes\n\n";
  for (std::size_t i = 0; i < outcome.class_names.size(); ++i)
    text += "- " + outcome.class_names[i] + ": " + outcome.class_texts[i] + "\n";
  text += "\n## The first of each kind\n\nEach line can be fed to the program.\n";
  for (const witness& w : outcome.witnesses)
    text += "\n" + w.class_name + ", " + std::string(kind_of(w)) + ": " + w.given + ", exactly " +
            std::to_string(w.exact) + "\n\n    " + w.record + "\n";
  return text;
}

}  // namespace asterism::challenge
