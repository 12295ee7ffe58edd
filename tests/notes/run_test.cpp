// SPDX-License-Identifier: GPL-3.0-or-later
// run/cases.txt through the program itself, so that a crash, a hang or a full stack fails one case and no
// other. CMake makes each case a test of its own, with a watchdog.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "catch.h"
#include "made_files.h"
#include "program.h"

namespace rigor {
namespace {

struct RunCase {
  int line = 0;
  std::string name;
  int code = 0;
  std::vector<std::string> arguments;
  std::string text;
};

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(' ');
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
}

/// `NAME | EXIT CODE | ARGUMENTS | TEXT`; no value for an empty line or a remark.
std::optional<RunCase> read_case(const std::string& line, int number) {
  if (line.empty() || line[0] == '#') return std::nullopt;
  std::istringstream stream(line);
  std::string name;
  std::string code;
  std::string arguments;
  std::string text;
  std::getline(stream, name, '|');
  std::getline(stream, code, '|');
  std::getline(stream, arguments, '|');
  std::getline(stream, text);
  RunCase result{number, trimmed(name), std::stoi(code), {}, trimmed(text)};
  std::istringstream words(arguments);
  for (std::string word; words >> word;) result.arguments.push_back(word);
  return result;
}

std::vector<RunCase> run_cases() {
  std::istringstream lines(text_of("run/cases.txt"));
  std::vector<RunCase> cases;
  int number = 0;
  for (std::string line; std::getline(lines, line);)
    if (auto one = read_case(line, ++number)) cases.push_back(std::move(*one));
  return cases;
}

/// The last lines of what was printed: all that a person needs to see of a large report.
std::string tail(const std::string& text) {
  constexpr std::size_t most = 2000;
  return text.size() <= most ? text : "…" + text.substr(text.size() - most);
}

bool asks_for_json(const RunCase& one) {
  return std::find(one.arguments.begin(), one.arguments.end(), "--json") != one.arguments.end();
}

void check_case(const RunCase& one) {
  const TemporaryFolder folder;
  std::vector<std::string> arguments;
  for (const std::string& word : one.arguments)
    arguments.push_back(word[0] == '@' ? make_file(word.substr(1), folder) : word);
  const Outcome outcome = run_program(arguments);
  INFO(fmt::format("run/cases.txt:{}: expected exit code {} and `{}`, got {} and\n{}", one.line, one.code,
                   one.text, outcome.code, tail(outcome.text)));
  CHECK(outcome.code == one.code);
  CHECK((outcome.text.find(one.text) != std::string::npos));
  CHECK_FALSE(outcome.text.empty());
  if (asks_for_json(one) && outcome.code != 64) CHECK(nlohmann::json::accept(outcome.text));
}

TEST_CASE("the program ends as run/cases.txt says", "[each]") {
  for (const RunCase& one : run_cases()) {
    DYNAMIC_SECTION(one.name) {
      const bool root_reads_it = one.name == "an unreadable file" && geteuid() == 0;
      if (root_reads_it)
        SUCCEED("no file is unreadable for root");
      else
        check_case(one);
    }
  }
}

TEST_CASE("the program prints what the function prints") {
  CHECK(run_program({"--help"}).text == run_inside({"--help"}).text);
  CHECK(run_program({"check", "--json"}).text == run_inside({"check", "--json"}).text);
}

}  // namespace
}  // namespace rigor
