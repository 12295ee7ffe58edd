// SPDX-License-Identifier: GPL-3.0-or-later
// Which classes of statement are decided: each example of classes.txt gets the verdict that stands there, and
// the table in docs/trust.md is made of them.
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "catch.h"
#include "check/entry/check.h"
#include "program.h"

namespace rigor {
namespace {

constexpr const char* page_path = "../../docs/trust.md";
constexpr std::string_view table_begin = "<!-- made of tests/notes/classes.txt -->\n";
constexpr std::string_view table_end = "<!-- end -->\n";

struct Example {
  std::string verdict;
  std::string statement;
};

struct Class {
  std::string how;  // complete, sound, none
  std::string name;
  std::vector<std::string> directives;
  std::vector<Example> examples;
};

std::vector<Class> read_classes() {
  std::istringstream lines(text_of("classes.txt"));
  std::vector<Class> classes;
  bool begins = true;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    const std::size_t colon = line.find(": ");
    if (colon == std::string::npos) {
      begins = true;
      continue;
    }
    const std::string word = line.substr(0, colon);
    const std::string rest = line.substr(colon + 2);
    if (begins) {
      classes.push_back({word, rest, {}, {}});
    } else if (word == "rigor") {
      classes.back().directives.push_back(rest);
    } else {
      classes.back().examples.push_back({word, rest});
    }
    begins = false;
  }
  return classes;
}

bool has(const Class& of, std::initializer_list<std::string_view> verdicts) {
  return std::any_of(of.examples.begin(), of.examples.end(), [&](const Example& example) {
    return std::find(verdicts.begin(), verdicts.end(), example.verdict) != verdicts.end();
  });
}

/// The verdicts of the displays; those of the directives are left out.
std::vector<std::string> verdicts_of(const Class& of) {
  std::string text = "# A class\n\n";
  for (const std::string& directive : of.directives) text += fmt::format("<!-- rigor: {} -->\n\n", directive);
  const std::size_t displays = text.size();
  for (const Example& example : of.examples) text += fmt::format("$${}$$\n\n", example.statement);
  SourceMap sources;
  std::vector<std::string> verdicts;
  for (const Step& step : check_text(sources, "class.md", text).steps)
    if (step.span.begin >= displays) verdicts.emplace_back(name_of(step.verdict));
  return verdicts;
}

std::string cell(const std::string& text) {
  std::string cell;
  for (const char c : text) cell += c == '|' ? "\\|" : std::string(1, c);
  return cell;
}

/// ", given `…` and `…`"
std::string assumptions_of(const Class& of) {
  constexpr std::string_view word = "given ";
  std::string text;
  for (const std::string& directive : of.directives) {
    if (!directive.starts_with(word)) continue;
    text += fmt::format("{} `{}`", text.empty() ? ", given" : " and", directive.substr(word.size()));
  }
  return text;
}

std::string table_of(const std::vector<Class>& classes) {
  std::string table = "| decided | class | example | verdict |\n|---|---|---|---|\n";
  for (const Class& row : classes) {
    const std::string_view how = row.how == "complete" ? "completely"
                                 : row.how == "sound"  ? "soundly, not completely"
                                                       : "not at all";
    bool first = true;
    for (const Example& example : row.examples) {
      table += fmt::format("| {} | {} | `{}`{} | {} |\n", first ? how : "", first ? cell(row.name) : "",
                           cell(example.statement), cell(assumptions_of(row)), example.verdict);
      first = false;
    }
  }
  return table;
}

/// The page with the table between its two marks.
std::string page_with(const std::string& table) {
  const std::string page = text_of(page_path);
  const std::size_t begin = page.find(table_begin);
  const std::size_t end = page.find(table_end);
  REQUIRE(begin != std::string::npos);
  REQUIRE(end != std::string::npos);
  return page.substr(0, begin + table_begin.size()) + table + page.substr(end);
}

TEST_CASE("every class of statement has the examples that it needs") {
  for (const Class& one : read_classes()) {
    INFO(one.name);
    const bool decided = has(one, {"proved", "refuted"});
    if (one.how == "complete") {
      CHECK(has(one, {"proved"}));
      CHECK(has(one, {"refuted"}));
      CHECK_FALSE(has(one, {"undecided", "not-understood"}));
    } else if (one.how == "none") {
      CHECK_FALSE(decided);
      CHECK(has(one, {"undecided", "not-understood"}));
    } else {
      CHECK(one.how == "sound");
      CHECK_FALSE(one.examples.empty());
    }
  }
}

TEST_CASE("every example of a class of statement gets its verdict") {
  for (const Class& one : read_classes()) {
    INFO(one.name);
    std::vector<std::string> expected;
    for (const Example& example : one.examples) expected.push_back(example.verdict);
    CHECK(verdicts_of(one) == expected);
  }
}

TEST_CASE("the table of classes in docs/trust.md is that of classes.txt") {
  CHECK(page_with(table_of(read_classes())) == text_of(page_path));
}

TEST_CASE("rewrites the table of classes in docs/trust.md", "[.rewrite]") {
  const std::string page = page_with(table_of(read_classes()));
  std::ofstream(page_path) << page;
}

}  // namespace
}  // namespace rigor
