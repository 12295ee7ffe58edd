// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/document_definition.h"

#include <algorithm>

#include "base/utf8.h"
#include "latex/ascii.h"

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
      bare_ = false;
      if (!move_to(text_.bracket_end(at), at)) return false;
    }
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

  /// `#1#2` and whatever else stands before the brace of a \def.
  bool parameter_text() {
    std::size_t at = next();
    for (; at < text_.size() && text_[at] != '{'; at = text_.skip_gap(at)) {
      if (is_white(text_[at])) return false;
      bare_ = false;
      at += text_[at] == '\\' ? 2 : 1;
      extent_.end = std::min(at, text_.size());
    }
    return true;
  }

  [[nodiscard]] std::string_view last_group() const { return last_group_; }

  DefinitionExtent extent(bool body_counts) {
    if (body_counts && bare_) extent_.body = last_group_;
    if (body_counts) extent_.opening = last_group_;
    return extent_;
  }

 private:
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
  bool bare_ = true;  // no parameters so far
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

DefinitionExtent environment_definition_extent(NotesText& text, std::size_t at) {
  ArgumentWalk walk(text, at);
  walk.sign('*');
  if (!walk.argument()) return walk.extent(false);
  const std::string_view name = walk.last_group();
  if (!walk.brackets(2) || !walk.argument()) return walk.extent(false);
  const std::string_view opening = walk.last_group();
  walk.argument();
  DefinitionExtent extent = walk.extent(false);
  extent.name = name;
  extent.opening = opening;
  return extent;
}

}  // namespace rigor
