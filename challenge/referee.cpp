// SPDX-License-Identifier: MIT
#include "asterism/challenge/referee.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <numeric>

#include "asterism/challenge/isolation.hpp"
#include "asterism/core/number_text.hpp"

namespace asterism::challenge {
namespace {

std::string_view without_blanks(std::string_view line) {
  constexpr std::string_view blanks = " \t\r\v\f";
  const std::size_t first = line.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return line.substr(first, line.find_last_not_of(blanks) - first + 1);
}

verdict judge_answer(std::string_view line, int exact) {
  line = without_blanks(line);
  if (line == "?") return verdict::undecided;
  if (line.starts_with("error")) return verdict::refused;
  if (line.size() > 1 && line.front() == '+' && line[1] != '-') line.remove_prefix(1);
  int value = 0;
  const auto [end, failure] = std::from_chars(line.data(), line.data() + line.size(), value);
  if (failure != std::errc() || end != line.data() + line.size()) return verdict::garbage;
  return value == exact ? verdict::right : verdict::wrong;
}

verdict judge(const reply& r, int exact) {
  if (r.answer) return judge_answer(*r.answer, exact);
  if (!r.failure) return verdict::not_asked;
  switch (*r.failure) {
    case run_end::too_few:
      return verdict::too_few;
    case run_end::too_many:
      return verdict::too_many;
    case run_end::crashed:
      return verdict::crashed;
    case run_end::hung:
      return verdict::hung;
    case run_end::endless:
    case run_end::out_of_time:
    case run_end::answered:
      break;
  }
  return verdict::garbage;
}

// A question of each kind, far from every border.
std::string simple_record(const question& asked) {
  const metric_tensor m = {1, 0, 1};
  const scene s = {
      {site{{0, 0}, m}, site{{2, 0}, m}, site{{1, -1.5}, m}, site{{1, 1.5}, m}}, {0.5, 3}, m};
  return record_text(asked, cut_record(asked.asked, s), true);
}

class referee {
 public:
  explicit referee(const challenge_plan& plan) : plan_(plan), limits_(plan.limits) {
    using clock = std::chrono::steady_clock;
    constexpr double longest = 1e9;  // thirty years, which the clock can count
    const std::chrono::duration<double> whole(std::min(limits_.whole, longest));
    limits_.until = clock::now() + std::chrono::duration_cast<clock::duration>(whole);
  }

  // Asks each question alone, in a run of its own: a program may end at a name that it does not
  // know.
  std::optional<error> find_questions() {
    for (const question& asked : plan_.questions) {
      if (plan_.find_out) {
        const std::vector<std::string> simple = {simple_record(asked)};
        const auto run = run_program(plan_.command, simple, limits_);
        if (!run) return run.failure();
        outcome_.left_behind = outcome_.left_behind || run.value().left_behind;
        outcome_.out_of_time = run.value().how == run_end::out_of_time;
        if (outcome_.out_of_time) return std::nullopt;
        note_lingering(run.value().lingered);
        if (!knows(run.value())) {
          note_unknown(asked, run.value());
          continue;
        }
      }
      outcome_.questions.push_back(asked);
    }
    return std::nullopt;
  }

  std::optional<error> ask_all() {
    for (const record_source& source : plan_.sources) {
      outcome_.class_names.push_back(source.name);
      outcome_.class_texts.push_back(source.text);
      auto& row = outcome_.counts.emplace_back();
      for (const question& asked : outcome_.questions) {
        const auto records = records_of(source, asked, plan_.records);
        auto cell = ask(source.name, records);
        if (!cell) return cell.failure();
        row.push_back(cell.value());
      }
    }
    return std::nullopt;
  }

  challenge_outcome outcome() && { return std::move(outcome_); }

 private:
  // Accepts any number or '?' as an answer: it is judged later.
  static bool knows(const program_run& run) {
    if (run.answers.empty()) return false;
    const verdict v = judge_answer(run.answers.front(), 0);
    return v == verdict::right || v == verdict::wrong || v == verdict::undecided;
  }

  void note_unknown(const question& asked, const program_run& run) {
    if (outcome_.unknown.empty())
      outcome_.unknown_told =
          run.answers.empty() ? said_at_end(run) : internal::quoted_token(run.answers.front());
    outcome_.unknown.push_back(asked);
  }

  void note_lingering(bool lingered) {
    outcome_.lingered = outcome_.lingered || lingered;
    if (lingered) limits_.patience = std::min(limits_.patience, 0.1);
  }

  result<tally> ask(const std::string& class_name, const std::vector<asked_record>& records) {
    tally counted;
    batch_replies all;
    all.replies.resize(records.size());
    if (!outcome_.gave_up && !outcome_.out_of_time && !records.empty()) {
      std::vector<std::string> lines;
      lines.reserve(records.size());
      for (const asked_record& r : records) lines.push_back(r.text);
      auto asked = ask_in_turn(plan_.command, lines, limits_);
      if (!asked) return asked.failure();
      all = std::move(asked.value());
      hangs_ += all.hung;
      outcome_.gave_up = hangs_ >= most_hangs;
      note_lingering(all.lingered);
      outcome_.left_behind = outcome_.left_behind || all.left_behind;
      outcome_.out_of_time = all.out_of_time;
    }
    counted.seconds = all.seconds;
    for (std::size_t i = 0; i < records.size(); ++i) {
      const verdict v = judge(all.replies[i], records[i].answer);
      ++counted.of[static_cast<std::size_t>(v)];
      if (v != verdict::right && v != verdict::not_asked)
        note_witness(class_name, v, false, records[i], all.replies[i]);
      if (!all.replies[i].late) continue;
      ++counted.slow;
      note_witness(class_name, v, true, records[i], all.replies[i]);
    }
    return counted;
  }

  void note_witness(const std::string& class_name, verdict what, bool slow,
                    const asked_record& record, const reply& given) {
    auto& all = outcome_.witnesses;
    const bool known = std::any_of(all.begin(), all.end(), [&](const witness& w) {
      return w.class_name == class_name && w.slow == slow && (slow || w.what == what);
    });
    if (known) return;
    const std::string said = given.answer ? internal::quoted_token(*given.answer) : given.told;
    all.push_back({class_name, what, slow, record.text, record.answer, said});
  }

  const challenge_plan& plan_;
  run_limits limits_;
  std::size_t hangs_ = 0;
  challenge_outcome outcome_;
};

}  // namespace

std::size_t tally::records() const { return std::accumulate(of.begin(), of.end(), std::size_t{0}); }

tally& tally::operator+=(const tally& other) {
  for (std::size_t i = 0; i < verdict_count; ++i) of[i] += other.of[i];
  slow += other.slow;
  seconds += other.seconds;
  return *this;
}

bool challenge_outcome::all_right(bool undecided_passes) const {
  std::size_t good = 0, records = 0;
  for (const auto& row : counts)
    for (const tally& t : row) {
      good += t.at(verdict::right) + (undecided_passes ? t.at(verdict::undecided) : 0);
      records += t.records();
    }
  return good == records && records > 0 && !lingered && !left_behind && !out_of_time;
}

tally challenge_outcome::of_class(std::size_t which) const {
  tally sum;
  for (const tally& t : counts[which]) sum += t;
  return sum;
}

tally challenge_outcome::of_question(std::size_t which) const {
  tally sum;
  for (const auto& row : counts) sum += row[which];
  return sum;
}

result<challenge_outcome> challenge_program(const challenge_plan& plan) {
  referee judge(plan);
  if (auto failure = judge.find_questions()) return *failure;
  if (auto failure = judge.ask_all()) return *failure;
  return std::move(judge).outcome();
}

}  // namespace asterism::challenge
