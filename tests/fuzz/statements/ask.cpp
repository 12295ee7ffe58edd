// SPDX-License-Identifier: GPL-3.0-or-later
#include "ask.h"

#include <fmt/format.h>

#include <cstdlib>
#include <exception>
#include <optional>

#include "check/entry/check.h"

namespace fuzz {
namespace {

using rigor::DiagnosticKind;

Said said_of(rigor::Verdict verdict) {
  switch (verdict) {
    case rigor::Verdict::proved:
      return Said::proved;
    case rigor::Verdict::refuted:
      return Said::refuted;
    case rigor::Verdict::undecided:
      return Said::undecided;
    case rigor::Verdict::not_understood:
      return Said::not_understood;
    default:
      return Said::other;
  }
}

/// A letter that a slip has removed may leave its directive without use.
bool is_error(const rigor::Diagnostic& diagnostic) {
  return diagnostic.severity() == rigor::Severity::error &&
         diagnostic.kind != DiagnosticKind::unused_directive && diagnostic.kind != DiagnosticKind::no_sample;
}

void look_at(const rigor::Diagnostics& diagnostics, const rigor::SourceMap& sources, Answer& answer,
             std::string* notices) {
  for (const rigor::Diagnostic& diagnostic : diagnostics) {
    const std::string text = fmt::format("{}: {}", rigor::info(diagnostic.kind).name, diagnostic.message);
    if (notices != nullptr) *notices += (notices->empty() ? "" : "; ") + text;
    if (is_error(diagnostic) && answer.error.empty()) answer.error = text;
    const rigor::Span span = diagnostic.span;
    if (span.begin > span.end || span.end > sources.text(span.file).size())
      answer.failure = "a span outside of the notes: " + text;
  }
}

/// `-3/2`; nothing: it is no rational number
std::optional<double> rational(const std::string& text) {
  if (text.empty() || text.find_first_not_of("-0123456789/") != std::string::npos) return std::nullopt;
  const std::size_t slash = text.find('/');
  const double above = std::strtod(text.c_str(), nullptr);
  return slash == std::string::npos ? above : above / std::strtod(text.c_str() + slash + 1, nullptr);
}

std::vector<Sampled> sample_of(const rigor::Step& step) {
  std::vector<Sampled> sample;
  if (!step.counterexample) return {};
  for (const rigor::Counterexample::Value& value : step.counterexample->values) {
    Sampled sampled{value.symbol, static_cast<int>(value.particle), {}};
    for (const std::string& component : value.components) {
      const auto number = rational(component);
      if (!number) return {};
      sampled.components.push_back(*number);
    }
    sample.push_back(sampled);
  }
  return sample;
}

/// Is it what a directive says, and not a display?
bool is_directive(const rigor::Step& step, const rigor::SourceMap& sources) {
  const std::string_view before = sources.text(step.span.file).substr(0, step.span.begin);
  const std::size_t line = before.rfind('\n');
  return before.substr(line == std::string_view::npos ? 0 : line).find("rigor: ") != std::string_view::npos;
}

rigor::RecordedSteps recorded(const rigor::FileReport& report, const rigor::SourceMap& sources) {
  rigor::RecordedSteps steps;
  for (const rigor::Step& step : report.steps) {
    if (step.verdict != rigor::Verdict::refuted || !step.counterexample) continue;
    rigor::RecordedStep record;
    record.file = report.path;
    const auto place = sources.line_column(step.span.file, step.span.begin);
    record.line = static_cast<std::uint32_t>(place.line);
    record.column = static_cast<std::uint32_t>(place.column);
    record.source = step.source;
    for (const rigor::RecordedStep& before : steps)
      if (before.line == record.line && before.column == record.column && before.source == record.source)
        ++record.earlier;
    record.example = *step.counterexample;
    steps.push_back(record);
  }
  return steps;
}

void replayed(const std::string& name, const std::string& notes, rigor::RecordedSteps steps, Answer& answer) {
  if (steps.empty()) return;
  rigor::SourceMap sources;
  rigor::CheckOptions options;
  options.repairs = rigor::Repairs::none;
  options.recorded = &steps;
  static_cast<void>(rigor::check_text(sources, name, notes, options));
  for (const rigor::RecordedStep& step : steps) {
    if (step.step && step.replayed && step.fault.empty()) continue;
    answer.failure = fmt::format("replay does not confirm `{}`: {}", step.source,
                                 !step.step       ? "the step is not found"
                                 : !step.replayed ? "the sample was not put in"
                                                  : step.fault);
  }
}

Answer asked(const std::string& file_name, const std::string& notes, bool replay) {
  Answer answer;
  rigor::SourceMap sources;
  rigor::CheckOptions options;
  options.repairs = rigor::Repairs::none;
  const rigor::FileReport report = rigor::check_text(sources, file_name, notes, options);
  answer.failure = report.failure;
  look_at(report.diagnostics, sources, answer, nullptr);
  for (const rigor::Step& step : report.steps) {
    std::string notices;
    look_at(step.diagnostics, sources, answer, &notices);
    if (step.span.begin > step.span.end || step.span.end > sources.text(step.span.file).size())
      answer.failure = "a step outside of the notes";
    if (step.verdict == rigor::Verdict::given || is_directive(step, sources)) {
      ++answer.given;
      continue;
    }
    answer.steps.push_back(said_of(step.verdict));
    answer.notices.push_back(notices);
    answer.samples.push_back(sample_of(step));
    if (step.verdict == rigor::Verdict::refuted && !step.counterexample)
      answer.failure = "a refutation without a sample";
  }
  if (replay && answer.failure.empty()) replayed(file_name, notes, recorded(report, sources), answer);
  return answer;
}

}  // namespace

std::string name_of(Said said) {
  static const std::vector<std::string> names{"proved", "refuted", "undecided", "not understood", "other"};
  return names[static_cast<std::size_t>(said)];
}

Answer ask(const std::string& file_name, const std::string& notes, bool replay) {
  try {
    return asked(file_name, notes, replay);
  } catch (const std::exception& exception) {
    Answer answer;
    answer.failure = fmt::format("an exception: {}", exception.what());
    return answer;
  }
}

}  // namespace fuzz
