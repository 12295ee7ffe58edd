// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/data/ctest_listing.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace rigor {
namespace {

bool misses_input(const Diagnostics& diagnostics) {
  return std::ranges::any_of(
      diagnostics, [](const Diagnostic& each) { return each.kind == DiagnosticKind::missing_input; });
}

/// When the listing is no longer true, as a condition of CMake.
std::string stale_condition(const FileReport& file, const SourceMap& sources) {
  std::string condition = "\"${rigor_program}\" IS_NEWER_THAN \"${rigor_listing}\"";
  std::set<std::string> paths;
  for (FileId id = 0; id < sources.size(); ++id) paths.insert(sources.path(id));
  std::error_code error;
  for (const std::string& path : paths) {
    if (path != file.path && !std::filesystem::exists(path, error)) continue;  // made here, not read
    condition += fmt::format("\n    OR {} IS_NEWER_THAN \"${{rigor_listing}}\"",
                             cmake_argument(std::filesystem::absolute(path, error).string()));
  }
  if (file.sidecar.empty()) {
    const std::filesystem::path beside = std::filesystem::path(file.path).replace_extension(".rigor");
    condition +=
        fmt::format("\n    OR EXISTS {}", cmake_argument(std::filesystem::absolute(beside, error).string()));
  }
  if (misses_input(file.diagnostics)) condition += "\n    OR TRUE";  // it may be there next time
  return condition;
}

}  // namespace

std::string cmake_argument(const std::string& text) {
  std::string equals;
  while (text.find("]" + equals) != std::string::npos) equals += "=";
  const std::string break_first = text.starts_with('\n') ? "\n" : "";  // CMake drops the first line break
  return fmt::format("[{0}[{1}{2}]{0}]", equals, break_first, text);
}

std::string ctest_listing(const std::vector<TestCase>& cases, const FileReport& file,
                          const SourceMap& sources) {
  std::string text =
      fmt::format("if(NOT rigor_listed AND ({}))\n  set(rigor_stale ON)\n  return()\nendif()\n",
                  stale_condition(file, sources));
  for (const TestCase& each : cases) {
    const std::string name = cmake_argument(each.name);
    text += fmt::format("add_test({0} \"${{rigor_program}}\" case \"${{rigor_results}}\" -- {0})\n", name);
    text += fmt::format(
        "set_tests_properties({} PROPERTIES FIXTURES_REQUIRED \"${{rigor_fixture}}\" LABELS "
        "\"${{rigor_labels}}\" SKIP_RETURN_CODE \"${{rigor_skip_code}}\")\n",
        name);
  }
  return text;
}

}  // namespace rigor
