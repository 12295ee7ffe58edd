// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/data/junit.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

#include "base/utf8.h"
#include "base/xml.h"
#include "report/wording/finding.h"

namespace rigor {
namespace {

/// What is inside a test case; at most one failure, since most readers show only one.
struct JunitCase {
  std::string class_name;
  std::string name;
  Span span;
  double milliseconds = 0.0;
  std::string outcome = {};  // `failure`, `error`, `skipped`; empty: it passes
  std::string type = {};
  std::string message = {};
  std::string text = {};    // of the outcome
  std::string output = {};  // what does not count
};

struct JunitSuite {
  std::string path;
  double milliseconds = 0.0;
  std::vector<JunitCase> cases;

  [[nodiscard]] std::size_t count(std::string_view outcome) const {
    return static_cast<std::size_t>(std::ranges::count(cases, outcome, &JunitCase::outcome));
  }
};

std::string seconds(double milliseconds) { return fmt::format("{:.6f}", milliseconds / 1000.0); }

std::string attribute(std::string_view name, std::string_view value) {
  return fmt::format(" {}=\"{}\"", name, xml_escaped(value));
}

std::string words_of(Verdict verdict) {
  std::string text(name_of(verdict));
  std::ranges::replace(text, '-', ' ');
  return text;
}

class JunitSuites {
 public:
  JunitSuites(const SourceMap& sources, const CheckFormat& options) : sources_(sources), options_(options) {}

  JunitSuite suite_of(const FileReport& file) {
    JunitSuite suite{path_from(file.path, options_.folder), 0.0, {}};
    for (const Step& step : file.steps) {
      suite.cases.push_back(case_of(step));
      suite.milliseconds += step.milliseconds;
    }
    for (const Diagnostic& diagnostic : file.diagnostics) suite.cases.push_back(case_of(diagnostic, file));
    if (!file.failure.empty()) {
      JunitCase& broken =
          suite.cases.emplace_back(JunitCase{suite.path, "the check of this file", {file.file, 0, 0}});
      broken.outcome = "error";
      broken.type = "internal";
      broken.message = broken.text = file.failure;
    }
    name_apart(suite.cases);
    return suite;
  }

 private:
  [[nodiscard]] std::string class_of(Span span, const std::string& section) const {
    const std::string path = path_from(sources_.path(span.file), options_.folder);
    return section.empty() ? path : path + ": " + section;
  }

  /// The first of the worst decides; all are told.
  void tell(JunitCase& test, const PlacedDiagnostic& placed, Weight& worst) const {
    const Weight weight = weight_of(placed, options_.rule);
    const Diagnostic& diagnostic = *placed.diagnostic;
    const std::string text = fmt::format("{}: {}: {} [{}]\n{}", place_text(diagnostic.span, sources_),
                                         name_of(diagnostic.severity()), printable(diagnostic.message),
                                         info(diagnostic.kind).name, details_of(placed, sources_));
    const bool fails = weight == Weight::wrong || weight == Weight::open;
    if (fails && weight < worst) {
      worst = weight;
      test.outcome = diagnostic.kind == DiagnosticKind::unreadable_file ? "error" : "failure";
      test.type = info(diagnostic.kind).name;
      test.message = diagnostic.message;
    }
    (fails ? test.text : test.output) += text;
  }

  [[nodiscard]] bool fails(const Step& step) const {
    const auto severity = severity_of(step);
    const FailureRule& rule = options_.rule;
    return severity && !rule.known.has(step) &&
           (rule.wrong.contains(*severity) || rule.open.contains(*severity));
  }

  [[nodiscard]] JunitCase case_of(const Step& step) const {
    const std::string tag = step.tag.empty() || step.tag.starts_with('(') ? step.tag : "(" + step.tag + ")";
    JunitCase test{class_of(step.span, step.section), tag.empty() ? step.source : tag + " " + step.source,
                   step.span, step.milliseconds};
    Weight worst = Weight::warning;
    for (const Diagnostic& diagnostic : step.diagnostics) tell(test, {&diagnostic, &step}, worst);
    if (test.outcome.empty() && fails(step)) {
      test.outcome = "failure";
      test.type = name_of(step.verdict);
      test.message = words_of(step.verdict);
    }
    if (test.outcome.empty() && step.verdict == Verdict::skipped) {
      test.outcome = "skipped";
      test.message = "as a directive of the notes says";
    }
    if (test.outcome.empty()) {
      std::string verdict = words_of(step.verdict);
      if (step.expected_refuted) verdict += ", as expected";
      if (!step.route.empty() && step.route != verdict) verdict += ": " + step.route;
      test.output = verdict + "\n" + test.output;
    }
    return test;
  }

  [[nodiscard]] JunitCase case_of(const Diagnostic& diagnostic, const FileReport& file) const {
    const LineColumn place = sources_.line_column(diagnostic.span.file, diagnostic.span.begin);
    const FileId where = diagnostic.span.file;
    JunitCase test{class_of({where, 0, 0}, ""),
                   fmt::format("{} in line {}", info(diagnostic.kind).name, place.line), diagnostic.span};
    if (file.unreadable) test.name = "the file can be read";
    Weight worst = Weight::warning;
    tell(test, {&diagnostic, nullptr}, worst);
    return test;
  }

  /// Readers that follow a test through time know it by its names.
  static void name_apart(std::vector<JunitCase>& cases) {
    std::map<std::pair<std::string, std::string>, int> seen;
    for (JunitCase& test : cases) {
      const int count = ++seen[{test.class_name, test.name}];
      if (count > 1) test.name += fmt::format(" #{}", count);
    }
  }

  const SourceMap& sources_;
  const CheckFormat& options_;
};

std::string print(const JunitCase& test, const SourceMap& sources, const std::string& folder) {
  const LineColumn place = sources.line_column(test.span.file, test.span.begin);
  std::string text =
      "    <testcase" + attribute("classname", test.class_name) + attribute("name", test.name) +
      attribute("file", path_from(sources.path(test.span.file), folder)) +
      attribute("line", fmt::format("{}", place.line)) + attribute("time", seconds(test.milliseconds));
  if (test.outcome.empty() && test.output.empty()) return text + "/>\n";
  text += ">\n";
  if (test.outcome == "skipped") {
    text += "      <skipped" + attribute("message", test.message) + "/>\n";
  } else if (!test.outcome.empty()) {
    text += "      <" + test.outcome + attribute("message", test.message) + attribute("type", test.type) +
            ">" + xml_escaped(test.text) + "</" + test.outcome + ">\n";
  }
  if (!test.output.empty()) text += "      <system-out>" + xml_escaped(test.output) + "</system-out>\n";
  return text + "    </testcase>\n";
}

/// The attributes that suites and their sum have in common.
std::string counts_of(std::string_view name, const std::vector<JunitSuite>& suites, bool with_skipped) {
  std::size_t tests = 0;
  std::size_t failures = 0;
  std::size_t errors = 0;
  std::size_t skipped = 0;
  double milliseconds = 0.0;
  for (const JunitSuite& suite : suites) {
    tests += suite.cases.size();
    failures += suite.count("failure");
    errors += suite.count("error");
    skipped += suite.count("skipped");
    milliseconds += suite.milliseconds;
  }
  std::string text = attribute("name", name) +
                     fmt::format(" tests=\"{}\" failures=\"{}\" errors=\"{}\"", tests, failures, errors);
  if (with_skipped) text += fmt::format(" skipped=\"{}\"", skipped);
  return text + attribute("time", seconds(milliseconds));
}

}  // namespace

std::string to_junit(const Report& report, const SourceMap& sources, const CheckFormat& options) {
  std::vector<JunitSuite> suites;
  for (const FileReport& file : report.files) suites.push_back(JunitSuites(sources, options).suite_of(file));
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + counts_of("rigor", suites, false) + ">\n";
  for (const JunitSuite& suite : suites) {
    text += "  <testsuite" + counts_of(suite.path, {suite}, true) + ">\n";
    for (const JunitCase& test : suite.cases) text += print(test, sources, options.folder);
    text += "  </testsuite>\n";
  }
  return text + "</testsuites>\n";
}

}  // namespace rigor
