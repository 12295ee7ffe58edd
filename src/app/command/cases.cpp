// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/host/outputs.h"
#include "base/utf8.h"
#include "check/entry/check.h"
#include "report/data/ctest_listing.h"
#include "report/data/test_cases.h"
#include "source/read_file.h"
#include "source/render.h"
#include "source/write_file.h"

namespace rigor {
namespace {

/// Readers at the same time see the old file or the new one.
ExitCode put(const std::string& path, const std::string& text, const SourceMap& sources, std::ostream& err) {
  if (const auto lost = overwritten_by(path, sources)) {
    err << fmt::format("rigor: `{}` would overwrite `{}`, which is read\n", printable(path),
                       printable(*lost));
    return ExitCode::usage;
  }
  const auto written = replace_file(path, text);
  if (written) return ExitCode::ok;
  err << fmt::format("rigor: {}: cannot be written: {}\n", printable(path), written.error().reason);
  return ExitCode::no_input;
}

std::size_t count(const std::vector<TestCase>& cases, CaseOutcome outcome) {
  return static_cast<std::size_t>(std::ranges::count(cases, outcome, &TestCase::outcome));
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
  ExitCode code = put(command.results, test_cases_json(cases), sources, err);
  if (code == ExitCode::ok && command.ctest)
    code = put(*command.ctest, ctest_listing(cases, file, sources), sources, err);
  if (code != ExitCode::ok) return code;
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
  const auto found =
      std::ranges::find_if(*cases, [&](const TestCase& each) { return each.name == command.name; });
  if (found == cases->end()) {
    err << "rigor: " << printable(command.results) << ": there is no case `" << printable(command.name)
        << "` any more\n";
    return ExitCode::wrong;
  }
  out << found->text;
  return code_of(found->outcome);
}

}  // namespace rigor
