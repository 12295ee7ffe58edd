// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/macro/macros.h"

#include <fmt/format.h>

#include <utility>

#include "latex/macro/faces.h"
#include "latex/macro/macro_conditional.h"
#include "latex/macro/macro_definition.h"
#include "latex/macro/macro_output.h"
#include "latex/macro/macro_stream.h"
#include "latex/macro/package_macros.h"
#include "latex/macro/plain_names.h"

namespace rigor {
namespace {

constexpr std::size_t deepest_macro = 200;
constexpr std::size_t most_expansions = 20'000;
constexpr std::size_t most_tokens = 200'000;

class Expander {
 public:
  Expander(TokenView tokens, MacroTable& macros, Diagnostics& diagnostics, MacroScope scope)
      : stream_(tokens), macros_(macros), diagnostics_(diagnostics), scope_(scope) {}

  std::optional<Tokens> all() {
    bool whole = true;
    open_group();
    while (whole) {
      const auto token = stream_.take();
      if (!token) break;
      whole = expand_token(*token);
    }
    while (!before_.empty()) close_group();
    return whole ? std::optional(with_faces_spread(output_.take())) : std::nullopt;
  }

 private:
  bool expand_token(const Token& token) {
    if (token.kind == TokenKind::begin_group) open_group();
    if (token.kind == TokenKind::end_group && before_.size() > 1) close_group();
    if (token.kind != TokenKind::control) return add(token);
    const auto macro = macros_.find(token.text);
    if (macro == macros_.end()) return pass(token);
    switch (macro->second.use) {
      case MacroUse::expands:
      case MacroUse::delimiters:
        return call(token, macro->second);
      case MacroUse::stands_for: {
        const Token& meaning = macro->second.body.front();
        return pass({meaning.kind, meaning.text, token.span});
      }
      case MacroUse::unreadable:
        return fail(token, "has a definition that is not read");
      case MacroUse::unseen:
        return fail(token, "has a definition in a package that is not read", DiagnosticKind::unsupported);
    }
    return false;
  }

  /// A control that is no macro defines one, or goes to the output.
  bool pass(const Token& token) {
    if (token.kind == TokenKind::control) {
      if (const auto form = definition_form(token.text)) {
        return define(token, *form);
      }
      if (token.text == "global" && next_defines()) return true;
      if (const auto test = macro_test(token.text)) return choose(token, *test);
      if (token.text == "mathchoice") return choose_display_style(token);
      if (is_spacing_class(token.text)) return unwrap(token);
      if (const auto sign = sign_named(token.text)) return add({sign->kind, sign->text, token.span});
      if (const auto package = package_call(token.text, stream_))
        return replace(token, package->body, package->arguments);
    }
    return add(token);
  }

  bool add(const Token& token) {
    output_.add(token);
    return true;
  }

  /// The first of four: mathematics of a display in its own line.
  bool choose_display_style(const Token& control) {
    std::optional<Tokens> first;
    for (int k = 0; k < 4; ++k) {
      auto argument = stream_.take_argument();
      if (!argument) return fail(control, "takes 4 arguments, and has fewer here");
      if (!first) first = std::move(argument->tokens);
    }
    stream_.push(std::move(*first));
    return true;
  }

  /// `\mathop{}\!\mathrm d`: a class around nothing, or around a differential, only sets spaces.
  bool unwrap(const Token& control) {
    auto argument = stream_.take_argument();
    if (!argument) return add(control);
    const bool bare = holds_no_more_than_differential(argument->tokens);
    if (!bare) {
      output_.add(control);
      argument->tokens.insert(argument->tokens.begin(), {TokenKind::begin_group, "{", argument->span});
      argument->tokens.push_back({TokenKind::end_group, "}", argument->span});
    }
    stream_.push(std::move(argument->tokens));
    return true;
  }

  void open_group() {
    if (scope_ == MacroScope::group) before_.emplace_back();
  }

  void close_group() {
    if (before_.empty()) return;
    if (before_.back()) macros_ = std::move(*before_.back());
    before_.pop_back();
  }

  /// What is not global ends with the group in which it stands.
  bool define(const Token& control, DefinitionForm form) {
    const bool global = control.text == "gdef" || control.text == "xdef" || std::exchange(global_, false);
    if (!global && !before_.empty() && !before_.back()) before_.back() = macros_;
    if (!global) return read_definition(control, form, stream_, macros_, diagnostics_);
    const MacroStream behind = stream_;
    const bool read = read_definition(control, form, stream_, macros_, diagnostics_);
    for (auto& table : before_) {
      if (!table) continue;
      MacroStream again = behind;
      Diagnostics said_already;
      read_definition(control, form, again, *table, said_already);
    }
    return read;
  }

  /// After `\global`.
  bool next_defines() {
    stream_.skip_spaces();
    const auto next = stream_.peek();
    global_ = next && next->kind == TokenKind::control && definition_form(next->text);
    return global_;
  }

  bool call(const Token& control, const Macro& macro) {
    if (stream_.depth() >= deepest_macro) return fail_endless(control);
    std::vector<TakenArgument> arguments;
    return take_arguments(control, macro, arguments) && replace(control, macro.body, arguments);
  }

  bool replace(const Token& control, TokenView replacement, const std::vector<TakenArgument>& arguments) {
    if (stream_.depth() >= deepest_macro || ++expansions_ > most_expansions) return fail_endless(control);
    Span written = control.span;
    for (const TakenArgument& argument : arguments) {
      if (argument.span.file == written.file && !argument.span.empty())
        written = cover(written, argument.span);
    }
    auto body = substitute(replacement, arguments, written);
    if (!body) return fail_endless(control);
    if (body->size() > 1 && output_.awaits_argument()) {
      body->insert(body->begin(), {TokenKind::begin_group, "{", written});
      body->push_back({TokenKind::end_group, "}", written});
    }
    stream_.push(std::move(*body));
    return true;
  }

  bool take_arguments(const Token& control, const Macro& macro, std::vector<TakenArgument>& arguments) {
    if (macro.use == MacroUse::delimiters) {
      stream_.skip_spaces();
      stream_.take_sign("*");
      if (next_is_bracket() && !stream_.take_optional())
        return fail(control, "has an argument that is not closed");
    }
    for (const MacroParameter& parameter : macro.parameters) {
      auto argument = take(parameter);
      if (!argument && parameter.kind == MacroParameter::Kind::optional)
        return fail(control, "has an argument that is not closed");
      if (!argument) {
        const std::size_t count = macro.parameters.size();
        return fail(control, fmt::format("takes {} argument{}, and has {} here", count, count == 1 ? "" : "s",
                                         arguments.size()));
      }
      arguments.push_back(std::move(*argument));
    }
    return true;
  }

  std::optional<TakenArgument> take(const MacroParameter& parameter) {
    if (parameter.kind == MacroParameter::Kind::plain) return stream_.take_argument();
    stream_.skip_spaces();
    if (parameter.kind == MacroParameter::Kind::star)
      return TakenArgument{{truth_value(stream_.take_sign("*"))}, {}};
    return next_is_bracket() ? stream_.take_optional() : TakenArgument{parameter.value, {}};
  }

  /// `\IfNoValueTF{#1}{…}{…}`: the branch takes the place of the whole.
  bool choose(const Token& control, const MacroTest& test) {
    if (++expansions_ > most_expansions) return fail_endless(control);
    auto branch = chosen_branch(stream_, test);
    if (!branch) return fail(control, "asks what is not known here", DiagnosticKind::unsupported);
    stream_.push(std::move(*branch));
    return true;
  }

  [[nodiscard]] bool next_is_bracket() {
    const auto token = stream_.peek();
    return token && is_sign(*token, "[");
  }

  /// The body with its arguments in place; nothing where it would be too long. `##` is the `#` of a
  /// definition inside.
  std::optional<Tokens> substitute(TokenView body, const std::vector<TakenArgument>& arguments,
                                   Span written) {
    Tokens result;
    for (std::size_t i = 0; i < body.size(); ++i) {
      const bool doubled = body[i].kind == TokenKind::parameter && body[i].text.empty();
      if (doubled && i + 1 < body.size() && body[i + 1].kind == TokenKind::parameter) ++i;
      if (body[i].kind == TokenKind::parameter && !doubled) {
        const TakenArgument& argument = arguments.at(static_cast<std::size_t>(body[i].text[0] - '1'));
        if (produced_ + argument.tokens.size() > most_tokens) return std::nullopt;
        produced_ += argument.tokens.size();
        const std::size_t before = result.size();
        result.insert(result.end(), argument.tokens.begin(), argument.tokens.end());
        if (argument.span.empty()) place(result, before, written);
      } else {
        if (++produced_ > most_tokens) return std::nullopt;
        result.push_back({body[i].kind, body[i].text, written});
      }
    }
    return result;
  }

  /// A default value was written in the definition: to the reader it is at the call.
  static void place(Tokens& tokens, std::size_t from, Span written) {
    for (std::size_t i = from; i < tokens.size(); ++i) tokens[i].span = written;
  }

  bool fail(const Token& control, std::string_view what, DiagnosticKind kind = DiagnosticKind::bad_macro) {
    diagnostics_.push_back({kind, control.span, fmt::format("`\\{}` {}", control.text, what)});
    return false;
  }

  bool fail_endless(const Token& control) {
    diagnostics_.push_back(
        {DiagnosticKind::macro_recursion,
         control.span,
         fmt::format("the macro `\\{}` expands for ever, or to more than is read", control.text),
         {},
         {"does its definition, or one that it uses, contain the macro itself?"}});
    return false;
  }

  MacroStream stream_;
  MacroTable& macros_;
  Diagnostics& diagnostics_;
  MacroScope scope_;
  std::vector<std::optional<MacroTable>> before_;  // before the first definition in each group
  bool global_ = false;                            // of the definition that follows
  MacroOutput output_;
  std::size_t expansions_ = 0;
  std::size_t produced_ = 0;  // tokens out of bodies
};

}  // namespace

std::optional<Tokens> expand(TokenView tokens, MacroTable& macros, Diagnostics& diagnostics,
                             MacroScope scope) {
  return Expander(tokens, macros, diagnostics, scope).all();
}

}  // namespace rigor
