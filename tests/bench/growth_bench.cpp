// SPDX-License-Identifier: GPL-3.0-or-later
// How much longer notes take when there is four times as much of them: about 4 where the time is linear, 16
// where it is quadratic. Both are measured in one run, so that the machine does not matter.
//
// Fails where something grows by more than between the two.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <limits>
#include <string>

#include "check/entry/check.h"
#include "check/event/notes.h"
#include "check/lint/lint_scopes.h"

namespace rigor::bench {
namespace {

constexpr int runs = 3;
constexpr double most_growth = 8;

struct Growing {
  const char* what;
  int count;
  std::function<void(int)> work;
};

/// Each display asks where the warning that is silenced for all of them is silenced.
void look_up_scopes(int count) {
  Notes notes;
  Directive allow;
  allow.warnings = {DiagnosticKind::bold_index};
  notes.events.emplace_back(PlacedDirective{allow, {}});
  for (int k = 1; k <= count; ++k) {
    const auto begin = static_cast<std::uint32_t>(10 * k);
    ParsedDisplay display;
    display.span = {0, begin, begin + 5};
    notes.events.emplace_back(std::move(display));
  }
  const LintScopes scopes(notes);
  for (int k = 1; k <= count; ++k) {
    const auto begin = static_cast<std::uint32_t>(10 * k + 1);
    if (scopes.said_of(DiagnosticKind::bold_index, {0, begin, begin + 1}) == nullptr) std::abort();
  }
}

/// Lines of other sections bear on no row.
void check_sections(int sections) {
  std::string text = "<!-- rigor: let E = ab -->\n";
  for (int k = 0; k < sections; ++k)
    text += fmt::format("## S{}\n\nAn elastic body with $a > 0$ is isotropic.\n\n$$E = ba$$\n\n", k);
  SourceMap sources;
  const FileReport report = check_text(sources, "book.md", text);
  if (report.counts[static_cast<std::size_t>(Verdict::proved)] != static_cast<std::uint32_t>(sections))
    std::abort();
}

/// A macro that is written many times gives one term of many braces.
void read_braces(int groups) {
  std::string text = "$$";
  for (int k = 0; k < groups; ++k) text += "\\beta{a b}";
  SourceMap sources;
  static_cast<void>(check_text(sources, "braces.md", text + " = 0$$\n"));
}

/// Processor time of `work(4 * count)` over that of `work(count)`.
double growth_by_four(const Growing& growing) {
  const auto least = [&](int size) {
    double seconds = std::numeric_limits<double>::infinity();
    for (int run = 0; run < runs; ++run) {
      const std::clock_t start = std::clock();
      growing.work(size);
      seconds = std::min(seconds, static_cast<double>(std::clock() - start));
    }
    return std::max(seconds, 1.0);
  };
  return least(4 * growing.count) / least(growing.count);
}

}  // namespace
}  // namespace rigor::bench

int main() {
  using namespace rigor::bench;
  const Growing all[] = {
      {"where a warning is silenced, for each of 50,000 displays", 50'000, look_up_scopes},
      {"rows and lines of 250 sections", 250, check_sections},
      {"one term of 1,000 groups in braces", 1'000, read_braces},
  };
  int failed = 0;
  for (const Growing& each : all) {
    const double growth = growth_by_four(each);
    const bool holds = growth < most_growth;
    std::printf("%-60s four times as many: %5.1f times as long (at most %.0f)%s\n", each.what, growth,
                most_growth, holds ? "" : "  FAILED");
    failed += holds ? 0 : 1;
  }
  return failed;
}
