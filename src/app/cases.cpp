// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cases.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "base/utf8.h"
#include "check/check.h"
#include "report/ctest_listing.h"
#include "report/test_cases.h"
#include "source/read_file.h"
#include "source/render.h"

namespace rigor {
namespace {

/// All or nothing: readers at the same time see the old file or the new one.
bool write_file(const std::string& path, const std::string& text, std::ostream& err) {
  const std::string part = fmt::format("{}.{}.part", path, getpid());
  std::ofstream file(part, std::ios::binary);
  file << text;
  file.close();
  std::error_code error;
  if (file) std::filesystem::rename(part, path, error);
  if (file && !error) return true;
  std::error_code ignored;
  std::filesystem::remove(part, ignored);
  err << "rigor: " << printable(path) << ": cannot be written\n";
  return false;
}

std::size_t count(const std::vector<TestCase>& cases, CaseOutcome outcome) {
  return static_cast<std::size_t>(std::count_if(
      cases.begin(), cases.end(), [&](const TestCase& each) { return each.outcome == outcome; }));
}

ExitCode code_of(CaseOutcome outcome) {
  switch (outcome) {
    case CaseOutcome::passed:
      return ExitCode::ok;
    case CaseOutcome::failed:
      return ExitCode::wrong;
    case CaseOutcome::open:
      return ExitCode::open;
  }
  return ExitCode::internal;
}

}  // namespace

ExitCode write_cases(const CasesCommand& command, std::ostream& out, std::ostream& err) {
  SourceMap sources;
  CheckOptions check_options;
  check_options.sidecar = command.sidecar;
  const FileReport file = check_file(sources, command.file, check_options);
  if (file.unreadable) {
    for (const Diagnostic& diagnostic : file.diagnostics) err << render(diagnostic, sources);
    return ExitCode::no_input;
  }
  const std::string name =
      command.name.value_or(std::filesystem::path(command.file).replace_extension().string());
  const std::vector<TestCase> cases = test_cases(file, sources, {.name = name, .strict = command.strict});
  if (!write_file(command.results, test_cases_json(cases), err)) return ExitCode::no_input;
  if (command.ctest && !write_file(*command.ctest, ctest_listing(cases, file, sources), err))
    return ExitCode::no_input;
  out << fmt::format("{}: {} cases: {} passed, {} failed, {} open\n", printable(command.file), cases.size(),
                     count(cases, CaseOutcome::passed), count(cases, CaseOutcome::failed),
                     count(cases, CaseOutcome::open));
  return ExitCode::ok;
}

ExitCode tell_case(const CaseCommand& command, std::ostream& out, std::ostream& err) {
  const auto text = read_file(command.results);
  if (!text) {
    err << "rigor: " << printable(command.results) << ": " << text.error().reason << "\n";
    return ExitCode::no_input;
  }
  const auto cases = read_test_cases(*text);
  if (!cases) {
    err << "rigor: " << printable(command.results) << ": " << cases.error().reason << "\n";
    return ExitCode::wrong;
  }
  const auto found = std::find_if(cases->begin(), cases->end(),
                                  [&](const TestCase& each) { return each.name == command.name; });
  if (found == cases->end()) {
    err << "rigor: " << printable(command.results) << ": there is no case `" << printable(command.name)
        << "` any more\n";
    return ExitCode::wrong;
  }
  out << found->text;
  return code_of(found->outcome);
}

}  // namespace rigor
