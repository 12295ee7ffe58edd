// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/step/report.h"

#include "catch.h"

namespace {

using namespace rigor;

/// What a report of one step with this verdict and diagnostic amounts to: `wrong`, `open`, both or nothing.
std::string amounts_to(Verdict verdict, std::vector<DiagnosticKind> kinds = {}, bool expected = false,
                       bool strict = false) {
  Step step;
  step.verdict = verdict;
  step.expected_refuted = expected;
  for (const DiagnosticKind kind : kinds) step.diagnostics.push_back({kind, {}, "", {}, {}});
  FileReport file;
  file.steps.push_back(step);
  Report report;
  report.files.push_back(file);
  const Tally total = tally(report, strict);
  return std::string(total.unreadable ? "unreadable " : "") + (total.wrong ? "wrong " : "") +
         (total.open ? "open" : "");
}

}  // namespace

TEST_CASE("each verdict has a name of its own") {
  CHECK(name_of(Verdict::proved) == "proved");
  CHECK(name_of(Verdict::not_understood) == "not-understood");
  CHECK(name_of(Verdict::skipped) == "skipped");
}

TEST_CASE("proved, given, defined and skipped steps leave nothing to do") {
  for (const Verdict verdict : {Verdict::proved, Verdict::given, Verdict::definition, Verdict::skipped}) {
    CHECK(amounts_to(verdict) == "");
  }
}

TEST_CASE("a refuted step is wrong unless it was expected") {
  CHECK(amounts_to(Verdict::refuted, {DiagnosticKind::refuted}) == "wrong ");
  CHECK(amounts_to(Verdict::refuted, {DiagnosticKind::refuted}, true) == "");
}

TEST_CASE("an undecided step and one not understood are open") {
  CHECK(amounts_to(Verdict::undecided, {DiagnosticKind::undecided}) == "open");
  CHECK(amounts_to(Verdict::not_understood, {DiagnosticKind::unsupported}) == "open");
}

TEST_CASE("a malformed step is wrong and open") {
  CHECK(amounts_to(Verdict::not_understood, {DiagnosticKind::rank_mismatch}) == "wrong open");
}

TEST_CASE("a warning is wrong under strict only") {
  CHECK(amounts_to(Verdict::proved, {DiagnosticKind::zero_equals_zero}) == "");
  CHECK(amounts_to(Verdict::proved, {DiagnosticKind::zero_equals_zero}, false, true) == "wrong ");
}

TEST_CASE("a diagnostic of no step counts as well") {
  Report report;
  report.files.emplace_back();
  report.files[0].diagnostics.push_back({DiagnosticKind::unused_directive, {}, "", {}, {}});
  CHECK(tally(report, false).wrong);
  report.files[0].diagnostics[0].kind = DiagnosticKind::no_equations;
  CHECK_FALSE(tally(report, false).wrong);
  CHECK(tally(report, true).wrong);
}

TEST_CASE("a file that could not be read is told from a wrong one") {
  Report report;
  report.files.emplace_back();
  report.files[0].unreadable = true;
  CHECK(tally(report, false).unreadable);
  CHECK_FALSE(tally(report, false).wrong);
  CHECK_FALSE(tally({}, true).wrong);
}
