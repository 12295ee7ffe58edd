// SPDX-License-Identifier: GPL-3.0-or-later
// `rigor_step_test FILE LINE COLUMN` passes if every step reported at that place holds or is refuted as
// expected; otherwise it prints the verdict and why. tests/CMakeLists.txt makes one test of each step in
// derivations/.
#include <charconv>
#include <cstring>
#include <iostream>

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

void print(const Step& step, const SourceMap& sources) {
  const LineColumn at = sources.line_column(step.span.file, step.span.begin);
  std::cout << sources.path(step.span.file) << ":" << at.line << ":" << at.column << ": "
            << name_of(step.verdict) << (step.expected_refuted ? ", expected refuted: " : ": ") << step.source
            << "\n";
  for (const Diagnostic& diagnostic : step.diagnostics) std::cout << render(diagnostic, sources);
  if (step.counterexample) std::cout << print_sample(*step.counterexample);
}

int test_steps_at(const std::string& path, LineColumn place) {
  SourceMap sources;
  const FileReport report = check_file(sources, path);
  int found = 0;
  int failed = 0;
  for (const Step& step : report.steps) {
    if (sources.line_column(step.span.file, step.span.begin) != place) continue;
    ++found;
    if (holds(step)) continue;
    ++failed;
    print(step, sources);
  }
  if (found > 0) return failed == 0 ? 0 : 1;
  std::cout << path << ":" << place.line << ":" << place.column << ": no step begins here\n";
  for (const Diagnostic& diagnostic : report.diagnostics) std::cout << render(diagnostic, sources);
  return 1;
}

bool read_number(const char* text, std::uint32_t& number) {
  const char* end = text + std::strlen(text);
  const auto [rest, error] = std::from_chars(text, end, number);
  return error == std::errc() && rest == end;
}

}  // namespace
}  // namespace rigor

int main(int argc, char** argv) {
  rigor::LineColumn place;
  if (argc != 4 || !rigor::read_number(argv[2], place.line) || !rigor::read_number(argv[3], place.column)) {
    std::cerr << "usage: rigor_step_test FILE LINE COLUMN\n";
    return 64;
  }
  return rigor::test_steps_at(argv[1], place);
}
