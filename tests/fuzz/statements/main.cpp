// SPDX-License-Identifier: GPL-3.0-or-later
// rigor_fuzz: statements at random, each decided by the checker and by numbers of our own; see README.md.
//
//   rigor_fuzz --seed 1 --count 20000 [--kind vectors] [--show]   a run; exit code 1: something disagrees
//   rigor_fuzz --spoil derivations --spoil tests/notes --count 3000   notes with slips of bytes and tokens
//   rigor_fuzz --cases tests/fuzz/cases                           the failures of earlier runs
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "compare.h"
#include "generate.h"
#include "spoil.h"

namespace fuzz {
namespace {

constexpr double most_seconds =
    20.0;  // of processor time, for a page; the sanitizers' builds are ten times slower

struct Options {
  std::uint64_t seed = 1;
  std::size_t count = 1000;
  std::string kind = {};
  std::string cases = {};
  std::string only_said = {};           // with --show: `undecided`
  std::vector<std::string> spoil = {};  // folders
  bool show = false;
};

using Row = std::array<std::array<std::size_t, said_count>, 4>;  // by truth and answer

struct Run {
  std::map<std::string, Row> tally = {};
  std::size_t wrong = 0;
  std::map<std::string, int> shown = {};  // by class
  std::vector<Statement> page = {};       // what will be asked once more, together
};

/// Every fifth statement stands on a page with four others, too.
constexpr int most_shown = 8;
constexpr std::size_t every = 5;
constexpr std::size_t on_a_page = 5;

void print_tally(const Run& run) {
  static const std::array truths{"true", "false", "unclear", "twofold"};
  fmt::print("{:<13}{:<9}{:>8}{:>9}{:>11}{:>16}{:>7}\n", "class", "is", "proved", "refuted", "undecided",
             "not understood", "other");
  Row all{};
  const auto print_row = [&](const std::string& kind, const Row& row) {
    for (std::size_t truth = 0; truth < row.size(); ++truth) {
      const auto& r = row[truth];
      if (std::all_of(r.begin(), r.end(), [](std::size_t n) { return n == 0; })) continue;
      fmt::print("{:<13}{:<9}{:>8}{:>9}{:>11}{:>16}{:>7}\n", kind, truths[truth], r[0], r[1], r[2], r[3],
                 r[4]);
    }
  };
  for (const auto& [kind, row] : run.tally) {
    print_row(kind, row);
    for (std::size_t truth = 0; truth < row.size(); ++truth)
      for (std::size_t said = 0; said < said_count; ++said) all[truth][said] += row[truth][said];
  }
  print_row("all", all);
}

void print(const Disagreement& disagreement, const std::string& title) {
  fmt::print("--- {}: {}\n{}\n", title, disagreement.what, disagreement.notes);
  std::fflush(stdout);
}

void show(const Compared& compared, const Statement& statement, const Style& style, const Options& options) {
  for (std::size_t k = 0; k < compared.answer.steps.size(); ++k) {
    if (!options.only_said.empty() && name_of(compared.answer.steps[k]) != options.only_said) continue;
    fmt::print("{} {} {} {}\n{}\n", statement.kind, name_of(compared.answer.steps[k]),
               compared.truths[std::min(k, compared.truths.size() - 1)] == Truth::holds ? "true" : "false",
               compared.answer.notices[k], notes(statement, style));
  }
}

void with_others(const Statement& statement, const Style& style, std::uint64_t seed, Run& run) {
  run.page.push_back(statement);
  if (run.page.size() < on_a_page) return;
  const auto found = compare_page(run.page, style, seed);
  run.page.clear();
  if (!found) return;
  ++run.wrong;
  if (++run.shown["page"] <= most_shown) print(*found, "page");
}

void one(std::size_t number, const Options& options, Run& run) {
  Random random(options.seed * 0x100000001b3U + number);
  const std::string& kind = options.kind.empty() ? kinds()[number % kinds().size()] : options.kind;
  const Statement statement = statement_of(kind, random);
  const Style style{Random(random.next())};
  const std::uint64_t seed = random.next();
  const Compared compared = compare(statement, style, seed, number % 10 == 0);
  for (std::size_t k = 0; k < std::min(compared.answer.steps.size(), compared.truths.size()); ++k)
    ++run.tally[kind][static_cast<std::size_t>(compared.truths[k])]
               [static_cast<std::size_t>(compared.answer.steps[k])];
  if (options.show) show(compared, statement, style, options);
  if (!compared.wrong && number % every == number / kinds().size() % every)
    with_others(statement, style, seed, run);
  if (!compared.wrong) return;
  ++run.wrong;
  if (++run.shown[kind] <= most_shown)
    print(shrunk(statement, style, seed, *compared.wrong), fmt::format("{} {}", kind, number));
}

/// `true-….md`: nothing in it is refuted or an error; `false-….md`: nothing is proved or an error.
int run_cases(const std::string& folder) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::size_t wrong = 0;
  std::size_t cases = 0;
  for (const auto& path : paths) {
    const std::string name = path.filename().string();
    const bool is_true = name.rfind("true-", 0) == 0;
    if (!is_true && name.rfind("false-", 0) != 0) continue;
    ++cases;
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    const Answer answer = ask(name, text.str(), true);
    const Said forbidden = is_true ? Said::refuted : Said::proved;
    const bool bad = answer.steps.empty() || !answer.error.empty() || !answer.failure.empty() ||
                     std::find(answer.steps.begin(), answer.steps.end(), forbidden) != answer.steps.end();
    if (!bad) continue;
    ++wrong;
    fmt::print("{}: {}{}{}\n", path.string(), answer.error, answer.failure,
               answer.error.empty() && answer.failure.empty() ? name_of(forbidden) : "");
  }
  fmt::print("{} cases, {} wrong\n", cases, wrong);
  return wrong == 0 && cases > 0 ? 0 : 1;
}

/// What no notes may do, whatever stands in them: nothing, or what they did.
std::string misbehaviour(const Notes& notes) {
  const std::clock_t start = std::clock();
  const Answer answer = ask(notes.path, notes.text, true);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  if (!answer.failure.empty()) return answer.failure;
  return seconds > most_seconds ? fmt::format("takes more than {} s", most_seconds) : std::string();
}

int run_spoilt(const Options& options) {
  const std::vector<Notes> all = notes_below(options.spoil);
  std::size_t wrong = 0;
  std::size_t shown = 0;
  for (std::size_t number = 0; number < options.count && !all.empty(); ++number) {
    Random random(options.seed * 0x100000001b3U + number);
    const Notes notes = spoilt(all, random);
    const std::string what = misbehaviour(notes);
    if (what.empty()) continue;
    ++wrong;
    if (++shown > 20) continue;
    const std::string kind = what.substr(0, what.find('`'));
    const Notes fewer =
        fewer_lines(notes, [&](const Notes& next) { return misbehaviour(next).rfind(kind, 0) == 0; });
    print({what, fewer.text, fewer.path}, fmt::format("{} {}", fewer.path, number));
  }
  fmt::print("seed {}, {} spoilt notes, {} misbehave\n", options.seed, options.count, wrong);
  return wrong == 0 && !all.empty() ? 0 : 1;
}

int run_all(const Options& options) {
  Run run;
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t number = 0; number < options.count; ++number) one(number, options, run);
  print_tally(run);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  fmt::print("seed {}, {} statements, {} disagree; {:.1f} s\n", options.seed, options.count, run.wrong,
             taken.count());
  return run.wrong == 0 ? 0 : 1;
}

/// 20260131
std::uint64_t today() {
  const std::chrono::year_month_day date(
      std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now()));
  return static_cast<std::uint64_t>(static_cast<int>(date.year()) * 10000) +
         static_cast<unsigned>(date.month()) * 100 + static_cast<unsigned>(date.day());
}

int main_of(const std::vector<std::string>& words) {
  Options options;
  for (std::size_t k = 0; k < words.size(); ++k) {
    const auto value = [&] { return k + 1 < words.size() ? words[++k] : std::string(); };
    if (words[k] == "--seed") {
      const std::string seed = value();
      options.seed = seed == "today" ? today() : std::strtoull(seed.c_str(), nullptr, 10);
    } else if (words[k] == "--count") {
      options.count = std::strtoull(value().c_str(), nullptr, 10);
    } else if (words[k] == "--kind") {
      options.kind = value();
    } else if (words[k] == "--cases") {
      options.cases = value();
    } else if (words[k] == "--spoil") {
      options.spoil.push_back(value());
    } else if (words[k] == "--show") {
      options.show = true;
    } else if (words[k] == "--said") {
      options.only_said = value();
    } else {
      fmt::print(stderr, "rigor_fuzz: unknown option `{}`\n", words[k]);
      return 64;
    }
  }
  if (!options.spoil.empty()) return run_spoilt(options);
  return options.cases.empty() ? run_all(options) : run_cases(options.cases);
}

}  // namespace
}  // namespace fuzz

int main(int argc, char** argv) { return fuzz::main_of({argv + 1, argv + argc}); }
