// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/data/test_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>

#include "base/utf8.h"
#include "report/data/json_value.h"
#include "report/text/terminal.h"

namespace rigor {
namespace {

constexpr std::array<std::string_view, 3> outcome_names{"passed", "failed", "open"};

/// The notes' name, with the path of the file that the step is in if that is another one.
std::string name_of_file(const FileReport& file, FileId where, const SourceMap& sources,
                         const std::string& name) {
  if (where == file.file || sources.path(where) == file.path) return name;
  const std::filesystem::path folder = std::filesystem::path(file.path).parent_path();
  const std::filesystem::path other(sources.path(where));
  const std::filesystem::path near = other.lexically_relative(folder);
  return name + ": " + (near.empty() ? other : near).string();
}

/// `notes (6)` and `notes line 57`: what several steps may have in common.
std::string place_name(const FileReport& file, const Step& step, const SourceMap& sources,
                       const std::string& name) {
  const std::string notes = name_of_file(file, step.span.file, sources, name);
  const std::string text =
      step.tag.empty()
          ? fmt::format("{} line {}", notes, sources.line_column(step.span.file, step.span.begin).line)
          : fmt::format("{} {}", notes, step.tag.starts_with('(') ? step.tag : "(" + step.tag + ")");
  return printable(text);
}

/// A report of nothing but this, which is judged and printed as any other.
CaseOutcome outcome_of(const FileReport& part, bool strict) {
  Report report;
  report.files.push_back(part);
  const Tally found = tally(report, strict);
  if (found.wrong || found.unreadable) return CaseOutcome::failed;
  return found.open ? CaseOutcome::open : CaseOutcome::passed;
}

TestCase case_of(const FileReport& file, const Step& step, const SourceMap& sources, bool strict) {
  FileReport part;
  part.path = file.path;
  part.file = file.file;
  part.steps.push_back(step);
  const LineColumn at = sources.line_column(step.span.file, step.span.begin);
  TestCase result;
  result.outcome = outcome_of(part, strict);
  result.text = fmt::format("{}:{}:{}: {}{}: {}\n", printable(sources.path(step.span.file)), at.line,
                            at.column, name_of(step.verdict),
                            step.expected_refuted ? ", expected refuted" : "", printable(step.source));
  if (result.outcome != CaseOutcome::passed) result.text += print_diagnostics(part, sources);
  return result;
}

TestCase case_of_rest(const FileReport& file, const SourceMap& sources, const TestCaseOptions& options) {
  FileReport rest = file;
  rest.steps.clear();
  TestCase result;
  result.name = printable(options.name + " (whole file)");
  result.outcome = outcome_of(rest, options.strict);
  result.text = result.outcome == CaseOutcome::passed
                    ? fmt::format("{}: nothing is wrong apart from its steps\n", printable(file.path))
                    : print_diagnostics(rest, sources);
  return result;
}

}  // namespace

std::vector<TestCase> test_cases(const FileReport& file, const SourceMap& sources,
                                 const TestCaseOptions& options) {
  std::vector<TestCase> cases;
  std::map<std::string, std::size_t> steps_at;
  std::set<std::string> names;
  for (const Step& step : file.steps) {
    TestCase& added = cases.emplace_back(case_of(file, step, sources, options.strict));
    const std::string place = place_name(file, step, sources, options.name);
    // A name may come out the same where an odd tag reads like another name: then the next number is taken.
    do {
      const std::size_t number = ++steps_at[place];
      added.name = step.tag.empty() && number == 1 ? place : fmt::format("{} step {}", place, number);
    } while (!names.insert(added.name).second);
  }
  TestCase rest = case_of_rest(file, sources, options);
  while (!names.insert(rest.name).second) rest.name += "*";
  cases.push_back(std::move(rest));
  return cases;
}

std::string test_cases_json(const std::vector<TestCase>& cases) {
  const auto json_of_case = [](const TestCase& each) {
    return Json{{"name", each.name},
                {"outcome", outcome_names[static_cast<std::size_t>(each.outcome)]},
                {"text", each.text}};
  };
  return to_text({{"format", 1}, {"cases", array_of(cases, json_of_case)}}, 1);
}

Result<std::vector<TestCase>> read_test_cases(std::string_view json) {
  const auto malformed = [] { return tl::make_unexpected(Error{"not what `rigor cases` writes"}); };
  try {
    const Json object = Json::parse(json);
    if (object.at("format") != 1) return malformed();
    std::vector<TestCase> cases;
    for (const Json& entry : object.at("cases")) {
      const auto word = entry.at("outcome").get<std::string>();
      const auto* const name = std::ranges::find(outcome_names, word);
      if (name == outcome_names.end()) return malformed();
      cases.push_back({entry.at("name").get<std::string>(),
                       static_cast<CaseOutcome>(name - outcome_names.begin()),
                       entry.at("text").get<std::string>()});
    }
    return cases;
  } catch (const Json::exception&) {
    return malformed();
  }
}

}  // namespace rigor
