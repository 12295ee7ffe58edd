// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/grammar/exit_code.h"

#include "catch.h"

namespace rigor {
namespace {

Step step_with(Verdict verdict) {
  Step step;
  step.verdict = verdict;
  return step;
}

Report report_with(std::vector<Step> steps) {
  Report report;
  report.files.resize(1);
  report.files[0].steps = std::move(steps);
  return report;
}

TEST_CASE("every code is in the table once, in ascending order") {
  const auto table = exit_code_table();
  REQUIRE(table.size() == 6);
  for (std::size_t i = 1; i < table.size(); ++i) CHECK(table[i - 1].code < table[i].code);
  CHECK(number_of(table.back().code) == 70);
}

TEST_CASE("what is proved, given, defined or skipped ends with 0") {
  CHECK(exit_code({}, usual_rule(true)) == ExitCode::ok);
  CHECK(exit_code(report_with({step_with(Verdict::proved), step_with(Verdict::given),
                               step_with(Verdict::definition), step_with(Verdict::skipped)}),
                  usual_rule(true)) == ExitCode::ok);
}

TEST_CASE("a refutation ends with 1, unless it is expected") {
  Report report = report_with({step_with(Verdict::refuted)});
  CHECK(exit_code(report, usual_rule(false)) == ExitCode::wrong);
  report.files[0].steps[0].expected_refuted = true;
  CHECK(exit_code(report, usual_rule(false)) == ExitCode::ok);
}

TEST_CASE("an expectation that is not met ends with 1") {
  Report report = report_with({step_with(Verdict::proved)});
  report.files[0].diagnostics.push_back({DiagnosticKind::unexpected_verdict, {}, "", {}, {}});
  CHECK(exit_code(report, usual_rule(false)) == ExitCode::wrong);
}

TEST_CASE("what is open ends with 2, unless something is wrong") {
  CHECK(exit_code(report_with({step_with(Verdict::undecided)}), usual_rule(false)) == ExitCode::open);
  CHECK(exit_code(report_with({step_with(Verdict::not_understood)}), usual_rule(false)) == ExitCode::open);
  CHECK(exit_code(report_with({step_with(Verdict::undecided), step_with(Verdict::refuted)}),
                  usual_rule(false)) == ExitCode::wrong);
}

TEST_CASE("an unreadable file comes before everything else") {
  Report report = report_with({step_with(Verdict::refuted), step_with(Verdict::undecided)});
  report.files.emplace_back().unreadable = true;
  CHECK(exit_code(report, usual_rule(false)) == ExitCode::no_input);
}

TEST_CASE("a replay ends with 0 only if all is confirmed") {
  CHECK(exit_code(ReplayTally{}) == ExitCode::ok);
  CHECK(exit_code(ReplayTally{.confirmed = 3}) == ExitCode::ok);
  CHECK(exit_code(ReplayTally{.confirmed = 3, .not_confirmed = 1}) == ExitCode::wrong);
  CHECK(exit_code(ReplayTally{.malformed = true}) == ExitCode::wrong);
  CHECK(exit_code(ReplayTally{.not_confirmed = 1, .unreadable = true}) == ExitCode::no_input);
}

TEST_CASE("a warning ends with 1 only where it is asked for") {
  Report report = report_with({step_with(Verdict::proved)});
  report.files[0].diagnostics.push_back({DiagnosticKind::no_equations, {}, "", {}, {}});
  CHECK(exit_code(report, usual_rule(false)) == ExitCode::ok);
  CHECK(exit_code(report, usual_rule(true)) == ExitCode::wrong);
}

}  // namespace
}  // namespace rigor
