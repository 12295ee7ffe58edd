// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/shown_notes.h"

#include <algorithm>
#include <array>

#include "latex/document.h"

namespace rigor {
namespace {

bool lies_in(Span inner, Span outer) {
  return inner.file == outer.file && inner.begin >= outer.begin && inner.end <= outer.end;
}

/// Steps by their place in the report: which of them displays have taken, and those of directives.
class StepQueue {
 public:
  explicit StepQueue(const std::vector<Step>& steps) : steps_(steps), taken_(steps.size(), false) {}

  /// Steps whose place is in the display; the earliest decides what else has come by then.
  std::vector<const Step*> take(Span display) {
    std::vector<const Step*> found;
    for (std::size_t k = first_left_; k < steps_.size(); ++k) {
      if (taken_[k] || !lies_in(steps_[k].span, display)) continue;
      if (found.empty()) first_ = k;
      taken_[k] = true;
      found.push_back(&steps_[k]);
    }
    while (first_left_ < steps_.size() && taken_[first_left_]) ++first_left_;
    return found;
  }

  /// Those that no display has, before the first step that `take` found last.
  std::vector<const Step*> take_before() { return take_until(first_); }
  std::vector<const Step*> take_rest() { return take_until(steps_.size()); }

 private:
  std::vector<const Step*> take_until(std::size_t end) {
    std::vector<const Step*> found;
    for (std::size_t k = first_left_; k < end; ++k) {
      if (taken_[k]) continue;
      taken_[k] = true;
      found.push_back(&steps_[k]);
    }
    return found;
  }

  const std::vector<Step>& steps_;
  std::vector<bool> taken_;
  std::size_t first_left_ = 0;  // all steps before it are taken
  std::size_t first_ = 0;
};

void add_stated(ShownNotes& notes, const std::vector<const Step*>& steps) {
  for (const Step* step : steps) {
    ShownEquation stated;
    stated.span = step->span;
    stated.displayed = false;
    stated.steps.push_back(step);
    notes.items.emplace_back(std::move(stated));
  }
}

}  // namespace

ShownNotes show_notes(SourceMap& sources, const FileReport& report) {
  ShownNotes notes;
  notes.report = &report;
  if (report.unreadable) return notes;
  Diagnostics unheard;  // check has reported them
  StepQueue queue(report.steps);
  for (const Item& item : read_document(sources, report.file, unheard).items) {
    if (const auto* heading = std::get_if<Heading>(&item)) {
      notes.items.emplace_back(ShownHeading{heading->level, heading->title});
    } else if (const auto* macro = std::get_if<MacroText>(&item)) {
      static_cast<void>(expand(lex(sources, macro->span), notes.macros, unheard));
    } else if (const auto* display = std::get_if<Display>(&item)) {
      ShownEquation equation;
      equation.span = display->span;
      equation.source = std::string(sources.text(display->body));
      const auto tokens = expand(lex(sources, display->body, display->quotes), notes.macros, unheard);
      if (tokens) equation.shown = layout_of_display(*tokens, display->environment);
      equation.steps = queue.take(display->span);
      if (!equation.steps.empty()) add_stated(notes, queue.take_before());
      notes.items.emplace_back(std::move(equation));
    }
  }
  add_stated(notes, queue.take_rest());
  return notes;
}

bool needs_attention(const Step& step) {
  const bool malformed =
      std::any_of(step.diagnostics.begin(), step.diagnostics.end(),
                  [](const Diagnostic& each) { return each.severity() == Severity::error; });
  if (malformed) return true;
  switch (step.verdict) {
    case Verdict::proved:
      return step.expected_refuted;
    case Verdict::refuted:
      return !step.expected_refuted;
    case Verdict::undecided:
    case Verdict::not_understood:
      return true;
    case Verdict::given:
    case Verdict::definition:
    case Verdict::skipped:
      break;
  }
  return false;
}

std::string_view sign_of(Verdict verdict) {
  static constexpr std::array<std::string_view, verdict_count> signs{"✓", "✗", "◆", "≔", "?", "⊘", "–"};
  return signs.at(static_cast<std::size_t>(verdict));
}

std::string verdict_words(const Step& step) {
  std::string words(name_of(step.verdict));
  std::replace(words.begin(), words.end(), '-', ' ');
  if (!step.expected_refuted) return words;
  return words + (step.verdict == Verdict::refuted ? ", as expected" : ", expected to be refuted");
}

Use use_of(const std::string& text) {
  const std::size_t colon = text.find(": ");
  const std::size_t blank = text.find(' ');
  if (colon != std::string::npos && colon < blank) return {text.substr(0, colon), {}, text.substr(colon + 2)};
  if (blank == std::string::npos) return {text, {}, {}};
  Use use{text.substr(0, blank), text.substr(blank + 1), {}};
  if (use.word == "frame") return {use.word, {}, use.latex};
  if (const std::size_t line = use.latex.rfind(" in line "); line != std::string::npos) {
    use.place = use.latex.substr(line + 4);
    use.latex.resize(line);
  } else if (const std::size_t tag = use.latex.rfind(" (");
             tag != std::string::npos && use.latex.ends_with(')') && use.word == "definition") {
    use.place = use.latex.substr(tag + 1);
    use.latex.resize(tag);
  }
  return use;
}

}  // namespace rigor
