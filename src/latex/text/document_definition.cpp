// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/text/document_definition.h"

#include <algorithm>

#include "base/ascii.h"
#include "base/utf8.h"
#include "latex/token/words.h"

namespace rigor {
namespace {

/// Moves over arguments, one after the other. A move is false where the argument is not there.
class ArgumentWalk {
 public:
  ArgumentWalk(NotesText& text, std::size_t at) : text_(text) { extent_.end = at; }

  /// One sign, if it stands here.
  void sign(char sign) {
    const std::size_t at = next();
    if (text_[at] == sign) extent_.end = at + 1;
  }

  /// `\x` or `{\x}`.
  bool name() {
    std::size_t at = next();
    if (text_[at] == '{') at = text_.skip_gap(at + 1);
    if (text_[at] != '\\') return false;
    const std::string_view word = text_.control_word(at);
    extent_.name = word.empty() ? text_.between(at + 1, std::min(at + 2, text_.size())) : word;
    return argument();
  }

  bool brackets(int most) {
    for (; most > 0; --most) {
      const std::size_t at = next();
      if (text_[at] != '[') return true;
      if (!move_to(text_.bracket_end(at), at)) return false;
      count_parameters(text_.between(at + 1, extent_.end - 1));
    }
    return true;
  }

  /// `m m` or `O{default} m`: what else there is has no number of parameters that is known.
  bool argument_types() {
    if (!argument()) return false;
    const std::string_view types = last_group_;
    const bool plain = types.find_first_not_of("m \n") == std::string_view::npos;
    extent_.bodies.parameters = plain ? static_cast<int>(std::ranges::count(types, 'm')) : -1;
    return true;
  }

  /// A brace group, a control or one character.
  bool argument() {
    const std::size_t at = next();
    if (at >= text_.size() || is_white(text_[at]) || text_[at] == '}') return false;
    if (text_[at] == '{') {
      if (!move_to(text_.group_end(at), at)) return false;
      last_group_ = text_.between(at + 1, extent_.end - 1);
      return true;
    }
    return token();
  }

  /// A control or one character, be it a brace.
  bool token() {
    const std::size_t at = next();
    const std::size_t word = text_[at] == '\\' ? text_.control_word(at).size() : 0;
    const bool symbol = text_[at] == '\\' && word == 0;
    extent_.end = std::min(at + 1 + word + (symbol ? 1 : 0), text_.size());
    while (is_continuation(text_[extent_.end])) ++extent_.end;
    return true;
  }

  bool arguments(int count) {
    for (; count > 0; --count) {
      if (!argument()) return false;
    }
    return true;
  }

  /// `#1#2` and whatever else comes before the brace of a \def.
  bool parameter_text() {
    std::size_t at = next();
    for (; at < text_.size() && text_[at] != '{'; at = text_.skip_gap(at)) {
      if (is_white(text_[at])) return false;
      if (text_[at] == '#') ++extent_.bodies.parameters;
      at += text_[at] == '\\' ? 2 : 1;
      extent_.end = std::min(at, text_.size());
    }
    return true;
  }

  [[nodiscard]] std::string_view last_group() const { return last_group_; }

  DefinitionExtent extent(bool body_counts) {
    if (body_counts) extent_.bodies.opening = last_group_;
    return extent_;
  }

 private:
  /// The first bracket says how many there are, the second what the first of them is by default.
  void count_parameters(std::string_view bracket) {
    extent_.bodies.optional_first = extent_.bodies.parameters > 0;
    const std::string_view count = without_blanks_around(bracket);
    if (count.size() == 1 && is_digit(count[0]) && extent_.bodies.parameters == 0)
      extent_.bodies.parameters = count[0] - '0';
  }

  [[nodiscard]] std::size_t next() const { return text_.skip_gap(extent_.end); }

  bool move_to(std::optional<std::size_t> end, std::size_t open) {
    if (end) {
      extent_.end = *end;
    } else {
      extent_.open = open;
    }
    return end.has_value();
  }

  NotesText& text_;
  DefinitionExtent extent_;
  std::string_view last_group_;
};

}  // namespace

DefinitionExtent definition_extent(NotesText& text, DefinitionForm form, std::size_t at) {
  using enum DefinitionForm;
  ArgumentWalk walk(text, at);
  if (form != primitive && form != synonym) walk.sign('*');
  if (!walk.name()) return walk.extent(false);
  bool whole = false;
  switch (form) {
    case command:
    case provided_command:
      whole = walk.brackets(2) && walk.argument();
      break;
    case primitive:
      whole = walk.parameter_text() && walk.argument();
      break;
    case synonym:
      walk.sign('=');
      walk.token();
      break;
    case math_operator:
      walk.argument();
      break;
    case document_command:
    case delimiters:
      walk.arguments(2);
      break;
    case delimiters_around:
      if (walk.brackets(1)) walk.arguments(3);
      break;
  }
  return walk.extent(whole);
}

std::optional<EnvironmentForm> environment_form(std::string_view control) {
  using enum EnvironmentForm;
  static const WordMap<EnvironmentForm> forms{
      {"newenvironment renewenvironment provideenvironment", bodies},
      {"NewDocumentEnvironment RenewDocumentEnvironment DeclareDocumentEnvironment "
       "ProvideDocumentEnvironment",
       arguments},
      {"NewEnviron RenewEnviron", one_body}};
  return forms.find(control);
}

DefinitionExtent environment_definition_extent(NotesText& text, EnvironmentForm form, std::size_t at) {
  ArgumentWalk walk(text, at);
  walk.sign('*');
  if (!walk.argument()) return walk.extent(false);
  const std::string_view name = walk.last_group();
  const bool arguments = form == EnvironmentForm::arguments ? walk.argument_types() : walk.brackets(2);
  if (!arguments || !walk.argument()) return walk.extent(false);
  std::string_view opening = walk.last_group();
  std::string_view closing;
  if (form == EnvironmentForm::one_body) {
    constexpr std::string_view body = "\\BODY";
    const std::size_t split = opening.find(body);
    if (split != std::string_view::npos) {
      closing = opening.substr(split + body.size());
      opening = opening.substr(0, split);
    }
  } else if (walk.argument()) {
    closing = walk.last_group();
  }
  DefinitionExtent extent = walk.extent(false);
  extent.name = name;
  extent.bodies.opening = opening;
  extent.bodies.closing = closing;
  return extent;
}

}  // namespace rigor
