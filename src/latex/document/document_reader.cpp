// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/document/document_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/ascii.h"

namespace rigor {
namespace {

using Outcome = DisplayEnd::Outcome;

constexpr std::size_t most_reports = 1000;    // of what is unbalanced
constexpr std::size_t longest_options = 500;  // of an environment

std::string closing_of(DisplayDelimiter delimiter, std::string_view environment) {
  switch (delimiter) {
    case DisplayDelimiter::dollars:
      return "$$";
    case DisplayDelimiter::bracket:
      return "\\]";
    case DisplayDelimiter::double_bracket:
      return "\\\\]";
    case DisplayDelimiter::environment:
      return fmt::format("\\end{{{}}}", environment);
  }
  return {};
}

}  // namespace

void NotesReader::read_display(const Opening& opening) {
  const DisplayEnd end = read_closed_display(opening);
  if (end.outcome == Outcome::open) report_open(opening, end);
  if (end.outcome == Outcome::wrong) report_wrong(opening, end);
}

DisplayEnd NotesReader::read_closed_display(const Opening& opening) {
  Display display{{}, {}, opening.environment, opening.quotes};
  if (opening.own != nullptr) display.environment = opening.own->meaning;
  const std::size_t body = opening.own != nullptr ? skip_own_arguments(*opening.own, opening.behind)
                                                  : skip_environment_arguments(display, opening.behind);
  const DisplayEnd end =
      find_display_end(text_, reading_.aliases, opening.delimiter, opening.environment, body, opening.limit);
  if (end.outcome != Outcome::closed) return end;
  display.span = text_.span(opening.begin, end.end);
  display.body = text_.span(body, end.begin);
  display.cyclic = text_.goes_on_cyclically(end.end);
  add_directives(body, end.begin);
  if (end.passed)
    reading_.diagnostics.push_back({DiagnosticKind::unsupported,
                                    text_.span(*end.passed, *end.passed + 2),
                                    "a display in the words of `\\intertext` is not read",
                                    {},
                                    {"close the display around it before these words"}});
  if (!text_.trimmed(body, end.begin).empty()) add(std::move(display));
  at_ = end.end;
  return end;
}

std::size_t NotesReader::skip_environment_arguments(Display& display, std::size_t at) const {
  if (takes_options(display.environment) && text_[at] == '[') {
    const auto length = text_.between(at, std::min(at + longest_options, text_.size())).find(']');
    if (length != std::string_view::npos) at += length + 1;
  }
  if (!takes_argument(display.environment)) return at;
  const auto argument = text_.environment_mark(at);
  if (!argument) return at;
  if (is_display_environment(argument->name)) display.environment = argument->name;  // empheq
  return argument->end;
}

std::size_t NotesReader::skip_own_arguments(const OwnDisplay& own, std::size_t at) {
  for (int k = 0; k < own.parameters; ++k) {
    const std::size_t next = text_.skip_gap(at);
    const bool optional = k == 0 && own.optional_first;
    const char bracket = optional ? '[' : '{';
    if (text_[next] != bracket) {
      if (optional) continue;
      return at;
    }
    const auto end = optional ? text_.bracket_end(next) : text_.group_end(next, true);
    if (!end) return at;
    at = *end;
  }
  return at;
}

void NotesReader::report_open(const Opening& opening, const DisplayEnd& end) {
  const std::string closing = closing_of(opening.delimiter, opening.environment);
  const bool at_blank_line = text_.is_blank_line(end.begin);
  std::vector<Label> labels;
  if (!at_blank_line) {
    const std::size_t word = std::max<std::size_t>(text_.control_word(end.begin).size(), 1) + 1;
    labels.push_back(
        {text_.span(end.begin, std::min(end.begin + word, text_.size())), "not closed before this"});
  }
  const bool blank_line_ends = at_blank_line && end.begin < text_.size();
  report(opening.begin, opening.behind,
         fmt::format("`{}` is not closed", text_.between(opening.begin, opening.behind)),
         fmt::format("close it with `{}`{}", closing, blank_line_ends ? " before the blank line" : ""),
         std::move(labels));
  at_ = text_.after_blank_line(opening.begin);
}

/// After the end of another display that display is over; any other environment goes on around this one.
void NotesReader::report_wrong(const Opening& opening, const DisplayEnd& end) {
  const std::string_view written = text_.between(end.begin, end.end);
  report(opening.begin, opening.behind,
         fmt::format("`{}` is not closed before `{}`", text_.between(opening.begin, opening.behind), written),
         fmt::format("close it with `{}`", closing_of(opening.delimiter, opening.environment)),
         {{text_.span(end.begin, end.end), "this closes something else"}});
  const auto brace = written.find('{');
  const auto mark =
      brace == std::string_view::npos ? std::nullopt : text_.environment_mark(end.begin + brace);
  at_ = !mark || is_display_environment(mark->name)
            ? end.end
            : std::min(end.begin, text_.after_blank_line(opening.begin));
}

bool NotesReader::read_environment(std::string_view word, std::uint32_t quotes, std::size_t limit) {
  const std::size_t begin = at_;
  std::size_t behind = at_ + 1 + word.size();
  std::string name;
  const OwnDisplay* own = nullptr;
  bool opens = word == "begin";
  if (opens || word == "end") {
    const auto mark = text_.environment_mark(behind);
    if (!mark) return false;
    name = mark->name;
    behind = mark->end;
    const auto named = reading_.aliases.environments.find(name);
    if (named != reading_.aliases.environments.end()) own = &named->second;
  } else if (const auto alias = reading_.aliases.begins.find(word); alias != reading_.aliases.begins.end()) {
    own = &alias->second;
    name = own->environment;
    opens = true;
  } else if (const auto closing = reading_.aliases.ends.find(word); closing != reading_.aliases.ends.end()) {
    name = closing->second;
  }
  if (report_if_unread(word, name, behind)) return true;
  if (own == nullptr && !is_display_environment(name)) return false;
  if (opens) {
    read_display({DisplayDelimiter::environment, begin, behind, name, quotes, own, limit});
  } else {
    report(begin, behind, fmt::format("`{}` closes nothing", text_.between(begin, behind)),
           fmt::format("`\\begin{{{}}}` is missing before it", name));
    at_ = behind;
  }
  return true;
}

/// A display whose form is not known: the author's own, or that of a package.
bool NotesReader::report_if_unread(std::string_view word, std::string_view name, std::size_t behind) {
  const EnvironmentAliases& aliases = reading_.aliases;
  const bool own =
      word == "begin" ? aliases.unread_environments.contains(name) : aliases.unread_controls.contains(word);
  if (!own && (word != "begin" || !is_unread_display(name))) return false;
  const std::string_view written = text_.between(at_, behind);
  if (own) {
    report_unread(text_.span(at_, behind),
                  fmt::format("the definition of `{}` opens a display, which is not read", written),
                  "write the display itself here, or a short name that stands for its `\\begin{…}` alone");
  } else {
    report_unread(text_.span(at_, behind),
                  fmt::format("`{}` opens a display of a form that is not read", written),
                  "`align` and the other environments of `amsmath` are read");
  }
  at_ = behind;
  return true;
}

bool NotesReader::read_definition(std::string_view word) {
  const std::size_t begin = at_;
  const std::size_t behind = at_ + 1 + word.size();
  const auto form = definition_form(word);
  const auto environment = environment_form(word);
  if (!form && !environment) return false;
  const DefinitionExtent extent = form ? definition_extent(text_, *form, behind)
                                       : environment_definition_extent(text_, *environment, behind);
  if (extent.open) {
    report(begin, behind, "a definition is not closed", "close its braces and brackets",
           {{text_.span(*extent.open, *extent.open + 1), "opened here"}});
    at_ = text_.after_blank_line(begin);
    return true;
  }
  at_ = extent.end;
  if (extent.name.empty()) return true;
  if (text_.format() == Format::latex) {
    for (std::size_t k = reading_.groups.define(reading_.aliases); k > 0; --k)
      add(MacroGroup{text_.span(begin, begin), true});
  }
  if (form) {
    add(MacroText{text_.span(begin, extent.end), is_global(begin, word)});
    reading_.aliases.define(extent.name, extent.bodies);
  } else {
    reading_.aliases.define_environment(extent.name, extent.bodies);
  }
  return true;
}

/// `\gdef`, `\global\def`.
bool NotesReader::is_global(std::size_t definition, std::string_view word) const {
  if (word == "gdef" || word == "xdef") return true;
  std::size_t end = definition;
  while (end > 0 && is_white(text_[end - 1])) --end;
  constexpr std::string_view global = "\\global";
  return end >= global.size() && text_.has(global, end - global.size());
}

void NotesReader::add_directive(std::size_t percent) {
  std::size_t at = percent;
  while (text_[at] == '%' || is_blank(text_[at])) ++at;
  constexpr std::string_view word = "rigor:";
  if (!text_.has(word, at)) return;
  const Span line = text_.trimmed(at + word.size(), text_.line_end(at));
  if (!line.empty()) add(DirectiveLine{line});
}

void NotesReader::add_directives(std::size_t begin, std::size_t end) {
  for (std::size_t at = begin; at < end; ++at) {
    if (text_[at] == '\\') {
      ++at;
    } else if (text_[at] == '%') {
      add_directive(at);
      at = text_.line_end(at);
    }
  }
}

void NotesReader::report_unread(Span place, std::string message, std::string help) {
  if (++reading_.unread > most_reports) return;
  reading_.diagnostics.push_back(
      {DiagnosticKind::unsupported, place, std::move(message), {}, {std::move(help)}});
}

void NotesReader::report(std::size_t begin, std::size_t end, std::string message, std::string help,
                         std::vector<Label> labels) {
  std::vector<std::string> helps{std::move(help)};
  reading_.stopped = ++reading_.unbalanced == most_reports;
  if (reading_.stopped)
    helps.emplace_back("the notes are not read any further, since so much in them is unbalanced");
  reading_.diagnostics.push_back({DiagnosticKind::unbalanced, text_.span(begin, end), std::move(message),
                                  std::move(labels), std::move(helps)});
}

}  // namespace rigor
