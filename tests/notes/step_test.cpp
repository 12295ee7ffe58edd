// SPDX-License-Identifier: GPL-3.0-or-later
// One test of each step in derivations/ (tests/CMakeLists.txt), while each file is checked once:
//
//   rigor_step_test check FILE RESULTS        checks the notes and writes what became of each step
//   rigor_step_test step RESULTS LINE COLUMN  passes if every step reported at that place holds or is refuted
//   as
//                                             expected; otherwise it prints the verdict and why
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "check/check.h"
#include "report/sample.h"
#include "source/render.h"

namespace rigor {
namespace {

bool holds(const Step& step) {
  switch (step.verdict) {
    case Verdict::proved:
    case Verdict::definition:
    case Verdict::given:
    case Verdict::skipped:
      return !step.expected_refuted;
    case Verdict::refuted:
      return step.expected_refuted;
    case Verdict::undecided:
    case Verdict::not_understood:
      return false;
  }
  return false;
}

[[nodiscard]] std::string verdict_and_why(const Step& step, const SourceMap& sources) {
  const LineColumn at = sources.line_column(step.span.file, step.span.begin);
  std::ostringstream text;
  text << sources.path(step.span.file) << ":" << at.line << ":" << at.column << ": " << name_of(step.verdict)
       << (step.expected_refuted ? ", expected refuted: " : ": ") << step.source << "\n";
  for (const Diagnostic& diagnostic : step.diagnostics) text << render(diagnostic, sources);
  if (step.counterexample) text << print_sample(*step.counterexample);
  return text.str();
}

int check(const std::string& path, const std::string& results_path) {
  SourceMap sources;
  const FileReport report = check_file(sources, path);
  auto results = nlohmann::json::array();
  for (const Step& step : report.steps) {
    const LineColumn at = sources.line_column(step.span.file, step.span.begin);
    results.push_back({{"line", std::to_string(at.line)},
                       {"column", std::to_string(at.column)},
                       {"holds", holds(step)},
                       {"why", verdict_and_why(step, sources)}});
  }
  std::ofstream file(results_path);
  file << results.dump(1) << "\n";
  file.close();
  if (!file) std::cerr << results_path << ": cannot be written\n";
  for (const Diagnostic& diagnostic : report.diagnostics) std::cout << render(diagnostic, sources);
  return file ? 0 : 1;
}

int test_steps_at(const std::string& results_path, const std::string& line, const std::string& column) {
  std::ifstream file(results_path);
  if (!file) {
    std::cout << results_path << ": not there; the test before this one writes it\n";
    return 1;
  }
  int found = 0;
  int failed = 0;
  for (const auto& step : nlohmann::json::parse(file)) {
    if (step.at("line") != line || step.at("column") != column) continue;
    ++found;
    if (step.at("holds")) continue;
    ++failed;
    std::cout << step.at("why").get<std::string>();
  }
  if (found == 0) std::cout << results_path << ": no step begins at " << line << ":" << column << "\n";
  return found > 0 && failed == 0 ? 0 : 1;
}

}  // namespace
}  // namespace rigor

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() == 3 && words[0] == "check") return rigor::check(words[1], words[2]);
  if (words.size() == 4 && words[0] == "step") return rigor::test_steps_at(words[1], words[2], words[3]);
  std::cerr << "usage: rigor_step_test check FILE RESULTS | step RESULTS LINE COLUMN\n";
  return 64;
}
