// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/page/shown_notes.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/among.h"
#include "latex/document/document.h"
#include "latex/macro/macro_definition.h"
#include "latex/text/scoped_macros.h"

namespace rigor {
namespace {

/// The notes were read a second time, so that only its path names an included file.
bool lies_in(const SourceMap& sources, Span inner, Span outer) {
  return inner.begin >= outer.begin && inner.end <= outer.end &&
         (inner.file == outer.file || sources.path(inner.file) == sources.path(outer.file));
}

/// Steps by their place in the report: which of them displays have taken, and those of directives.
class StepQueue {
 public:
  StepQueue(const SourceMap& sources, const std::vector<Step>& steps)
      : sources_(sources), steps_(steps), taken_(steps.size(), false) {}

  /// Steps whose place is in the display; the earliest decides what else has come by then.
  std::vector<const Step*> take(Span display) {
    std::vector<const Step*> found;
    for (std::size_t k = first_left_; k < steps_.size(); ++k) {
      if (taken_[k] || !lies_in(sources_, steps_[k].span, display)) continue;
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

  const SourceMap& sources_;
  const std::vector<Step>& steps_;
  std::vector<bool> taken_;
  std::size_t first_left_ = 0;  // all steps before it are taken
  std::size_t first_ = 0;
};

/// Items of the notes one after another, each with the macros in force there.
class ShownNotesReader {
 public:
  ShownNotesReader(SourceMap& sources, const FileReport& report)
      : sources_(sources), queue_(sources, report.steps) {
    notes_.report = &report;
  }

  void take(const Heading& heading) {
    notes_.items.emplace_back(ShownHeading{heading.level, heading.title, in_force()});
  }
  void take(const DirectiveLine& directive) { directives_.emplace_back(directive.span, in_force()); }
  void take(const MacroText& macro) {
    macros_.define(sources_, macro, unheard_);
    changed_ = true;
  }
  void take(const MacroGroup& group) {
    macros_.pass(group);
    changed_ = changed_ || !group.opens;
  }
  void take(const Display& display) {
    ShownEquation equation;
    equation.span = display.span;
    equation.source = std::string(sources_.text(display.body));
    equation.steps = queue_.take(display.span);
    if (!equation.steps.empty()) add_stated(queue_.take_before());
    const std::vector<Token> lexed = lex(sources_, display.body, display.quotes);
    const bool defines = std::ranges::any_of(lexed, [](const Token& token) {
      return token.kind == TokenKind::control && definition_form(token.text);
    });
    if (defines) changed_ = true;
    // What the display defines for itself is in force for its own steps.
    MacroTable own;
    if (defines) own = macros_.table();
    const auto tokens = expand(lexed, defines ? own : macros_.table(), unheard_);
    if (tokens) equation.shown = layout_of_display(*tokens, display.environment);
    if (defines) {
      notes_.macros.push_back(std::move(own));
      equation.macros = notes_.macros.size() - 1;
      static_cast<void>(macros_.expand_display(sources_, display, unheard_));
    } else {
      equation.macros = in_force();
    }
    notes_.items.emplace_back(std::move(equation));
  }

  [[nodiscard]] ShownNotes finish() {
    add_stated(queue_.take_rest());
    return std::move(notes_);
  }

 private:
  /// The number of the macros as they are now.
  std::size_t in_force() {
    if (changed_) notes_.macros.push_back(macros_.table());
    changed_ = false;
    return notes_.macros.size() - 1;
  }

  void add_stated(const std::vector<const Step*>& steps) {
    for (const Step* step : steps) {
      const auto said = std::ranges::find_if(
          directives_, [&](const auto& directive) { return lies_in(sources_, step->span, directive.first); });
      ShownEquation stated;
      stated.span = step->span;
      stated.displayed = false;
      stated.steps.push_back(step);
      stated.macros = said == directives_.end() ? in_force() : said->second;
      notes_.items.emplace_back(std::move(stated));
    }
  }

  SourceMap& sources_;
  StepQueue queue_;
  ShownNotes notes_;
  ScopedMacros macros_;
  bool changed_ = true;                                        // since the last of `notes_.macros`
  std::vector<std::pair<Span, std::size_t>> directives_ = {};  // with the macros there
  Diagnostics unheard_;                                        // check has reported them
};

}  // namespace

ShownNotes show_notes(SourceMap& sources, const FileReport& report) {
  ShownNotesReader reader(sources, report);
  if (!report.unreadable) {
    Diagnostics unheard;  // check has reported them
    for (const Item& item : read_document(sources, report.file, unheard).items)
      std::visit([&](const auto& each) { reader.take(each); }, item);
  }
  return reader.finish();
}

bool needs_attention(const Step& step) {
  const bool malformed = std::ranges::any_of(
      step.diagnostics, [](const Diagnostic& each) { return each.severity() == Severity::error; });
  if (malformed) return true;
  switch (step.verdict) {
    case Verdict::proved:
      return step.expected_refuted;
    case Verdict::refuted:
      return !step.expected_refuted;
    case Verdict::undecided:
    case Verdict::not_understood:
    case Verdict::suspect:
      return true;
    case Verdict::given:
    case Verdict::definition:
    case Verdict::law:
    case Verdict::skipped:
      break;
  }
  return false;
}

std::string_view sign_of(Verdict verdict) {
  static constexpr std::array<std::string_view, verdict_count> signs{"✓", "✗", "◆", "≔", "?",
                                                                     "⊘", "–", "§", "!"};
  return signs.at(static_cast<std::size_t>(verdict));
}

std::string verdict_words(const Step& step) {
  std::string words(name_of(step.verdict));
  std::ranges::replace(words, '-', ' ');
  if (!step.expected_refuted) return words;
  return words + (step.verdict == Verdict::refuted ? ", as expected" : ", expected to be refuted");
}

Use use_of(const std::string& text) {
  const std::size_t colon = text.find(": ");
  const std::size_t blank = text.find(' ');
  if (colon != std::string::npos && colon < blank) return {text.substr(0, colon), {}, text.substr(colon + 2)};
  if (blank == std::string::npos) return {text, {}, {}};
  Use use{text.substr(0, blank), text.substr(blank + 1), {}};
  if (use.word == "frame" || is_one_of(use.word, {"law", "result", "conclusion"}))
    return {use.word, {}, use.latex};
  if (const std::size_t line = use.latex.rfind(" in line "); line != std::string::npos) {
    use.place = use.latex.substr(line + 4);
    use.latex.resize(line);
  } else if (const std::size_t said = use.latex.rfind(" (line "); said != std::string::npos) {
    use.place = use.latex.substr(said + 1);
    use.latex.resize(said);
  } else if (const std::size_t tag = use.latex.rfind(" (");
             tag != std::string::npos && use.latex.ends_with(')') && use.word == "definition") {
    use.place = use.latex.substr(tag + 1);
    use.latex.resize(tag);
  }
  return use;
}

}  // namespace rigor
