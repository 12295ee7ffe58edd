// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/macro/macro_definition.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "latex/macro/macro_conditional.h"
#include "latex/token/words.h"

namespace rigor {
namespace {

using enum DefinitionForm;

constexpr std::string_view not_closed = "is not closed or has no body";

/// Parameters that the body asks for; `##1` belongs to a definition inside it.
int highest_parameter(TokenView body) {
  int highest = 0;
  for (std::size_t i = 0; i < body.size(); ++i) {
    if (body[i].kind != TokenKind::parameter) continue;
    if (body[i].text.empty()) {
      ++i;
    } else {
      highest = std::max(highest, body[i].text[0] - '0');
    }
  }
  return highest;
}

Token made_token(TokenKind kind, std::string_view text) { return {kind, text, {}}; }

void append_tokens(Tokens& tokens, TokenView more) { tokens.insert(tokens.end(), more.begin(), more.end()); }

class DefinitionReader {
 public:
  DefinitionReader(const Token& control, MacroStream& stream, MacroTable& macros, Diagnostics& diagnostics)
      : control_(control), stream_(stream), macros_(macros), diagnostics_(diagnostics) {}

  bool read(DefinitionForm form) {
    if (form != primitive && form != synonym) take_star();
    if (!read_name()) return false;
    if (!read_rest(form)) return false;
    const auto parameters = static_cast<int>(macro_.parameters.size());
    if (macro_.use != MacroUse::unreadable && highest_parameter(macro_.body) > parameters) {
      reject(fmt::format("uses `#{}` and has {} parameter{}", highest_parameter(macro_.body), parameters,
                         parameters == 1 ? "" : "s"));
    }
    if (form != provided_command || !macros_.contains(name_))
      macros_.insert_or_assign(name_, std::move(macro_));
    return true;
  }

 private:
  bool read_rest(DefinitionForm form) {
    switch (form) {
      case command:
      case provided_command:
        return read_count() && read_default() && read_body();
      case document_command:
        return read_argument_types() && read_body();
      case primitive:
        return read_parameter_text() && read_body();
      case synonym:
        return read_synonym();
      case math_operator:
        return read_operator();
      case DefinitionForm::delimiters:
        macro_.parameters.resize(1);
        return read_delimiters(true);
      case delimiters_around:
        return read_count() && read_delimiters(false);
    }
    return false;
  }

  void take_star() {
    stream_.skip_spaces();
    starred_ = stream_.take_sign("*");
  }

  /// `{\x}` or `\x`.
  bool read_name() {
    const auto argument = stream_.take_argument();
    const TokenView name = argument ? trim(argument->tokens) : TokenView();
    if (name.size() != 1 || name[0].kind != TokenKind::control) {
      diagnostics_.push_back({DiagnosticKind::bad_macro, control_.span,
                              fmt::format("`\\{}` is not followed by the name of a macro", control_.text)});
      return false;
    }
    name_ = name[0].text;
    name_span_ = name[0].span;
    return true;
  }

  /// `[n]`; without it there are no parameters.
  bool read_count() {
    stream_.skip_spaces();
    if (!next_is_bracket()) return true;
    const auto count = stream_.take_optional();
    if (!count) return stop();
    const TokenView digits = trim(count->tokens);
    if (digits.size() == 1 && digits[0].kind == TokenKind::digit) {
      macro_.parameters.resize(static_cast<std::size_t>(digits[0].text[0] - '0'));
    } else {
      reject(fmt::format("is defined with `[{}]`, which is not a number of arguments", text_of(digits)));
    }
    return true;
  }

  bool read_default() {
    stream_.skip_spaces();
    if (!next_is_bracket()) return true;
    auto value = stream_.take_optional();
    if (!value) return stop();
    if (macro_.parameters.empty()) {
      reject("has a default for an argument that it does not take");
    } else {
      macro_.parameters[0] = {MacroParameter::Kind::optional, std::move(value->tokens)};
    }
    return true;
  }

  bool read_body() {
    auto body = stream_.take_argument();
    if (!body) return stop();
    if (macro_.use != MacroUse::unreadable) macro_.body = std::move(body->tokens);
    return true;
  }

  /// `#1#2` up to the brace of the body.
  bool read_parameter_text() {
    bool delimited = false;
    for (auto token = stream_.peek(); token; token = stream_.peek()) {
      if (token->kind == TokenKind::begin_group) {
        if (delimited) reject("is defined with delimited parameters, which are not read");
        return true;
      }
      const bool next = token->kind == TokenKind::parameter && !token->text.empty() &&
                        token->text[0] - '1' == static_cast<int>(macro_.parameters.size());
      if (next) macro_.parameters.emplace_back();
      delimited = delimited || !next;
      stream_.take();
    }
    return stop();
  }

  /// The meaning of now: a later change of the other macro does not show.
  bool read_synonym() {
    stream_.skip_spaces();
    if (stream_.take_sign("=")) stream_.skip_spaces();
    const auto target = stream_.take();
    if (!target) return stop();
    const auto other = target->kind == TokenKind::control ? macros_.find(target->text) : macros_.end();
    macro_ = other != macros_.end() ? other->second : Macro{.body = {*target}, .use = MacroUse::stands_for};
    return true;
  }

  bool read_operator() {
    const auto name = stream_.take_argument();
    if (!name) return stop();
    macro_.body = {made_token(TokenKind::control, "operatorname")};
    if (starred_) macro_.body.push_back(made_token(TokenKind::other, "*"));
    macro_.body.push_back(made_token(TokenKind::begin_group, "{"));
    append_tokens(macro_.body, name->tokens);
    macro_.body.push_back(made_token(TokenKind::end_group, "}"));
    return true;
  }

  bool read_delimiters(bool around_argument) {
    const auto left = stream_.take_argument();
    const auto right = left ? stream_.take_argument() : std::nullopt;
    const auto inside = around_argument ? TakenArgument{{made_token(TokenKind::parameter, "1")}, {}}
                                        : (right ? stream_.take_argument() : std::nullopt);
    if (!right || !inside) return stop();
    if (macro_.use == MacroUse::unreadable) return true;
    macro_.use = MacroUse::delimiters;
    macro_.body = {made_token(TokenKind::control, "left")};
    append_tokens(macro_.body,
                  left->tokens.empty() ? Tokens{made_token(TokenKind::other, ".")} : left->tokens);
    append_tokens(macro_.body, inside->tokens);
    macro_.body.push_back(made_token(TokenKind::control, "right"));
    append_tokens(macro_.body,
                  right->tokens.empty() ? Tokens{made_token(TokenKind::other, ".")} : right->tokens);
    return true;
  }

  /// `m m`, `O{default} m`, `s o m`: no other types of xparse are read. `+` says that an argument may be
  /// long.
  bool read_argument_types() {
    using enum MacroParameter::Kind;
    const auto types = stream_.take_argument();
    if (!types) return stop();
    MacroStream rest(types->tokens);
    for (rest.skip_spaces(); const auto type = rest.take(); rest.skip_spaces()) {
      if (is_sign(*type, "+")) continue;
      auto value = type->text == "O" ? rest.take_argument() : std::nullopt;
      MacroParameter parameter;
      if (value) {
        parameter = {optional, std::move(value->tokens)};
      } else if (type->text == "o") {
        parameter = {optional, {no_value()}};
      } else if (type->text == "s") {
        parameter.kind = star;
      } else if (type->text != "m") {
        reject(fmt::format("has an argument of type `{}`, which is not read", type->text));
        return true;
      }
      if (macro_.parameters.size() == 9) {
        reject("has more than 9 arguments");
        return true;
      }
      macro_.parameters.push_back(std::move(parameter));
    }
    return true;
  }

  [[nodiscard]] bool next_is_bracket() const {
    const auto token = stream_.peek();
    return token && is_sign(*token, "[");
  }

  /// The definition is understood as far as its end, not its meaning.
  void reject(std::string_view why) {
    if (macro_.use != MacroUse::unreadable) {
      diagnostics_.push_back({DiagnosticKind::bad_macro, name_span_, fmt::format("`\\{}` {}", name_, why)});
    }
    macro_ = Macro{.use = MacroUse::unreadable};
  }

  bool stop() {
    reject(not_closed);
    macros_.insert_or_assign(name_, std::move(macro_));
    return false;
  }

  const Token& control_;
  MacroStream& stream_;
  MacroTable& macros_;
  Diagnostics& diagnostics_;
  bool starred_ = false;
  std::string name_;
  Span name_span_;
  Macro macro_;
};

}  // namespace

std::optional<DefinitionForm> definition_form(std::string_view control) {
  static const WordMap<DefinitionForm> forms{
      {"newcommand renewcommand DeclareRobustCommand", command},
      {"providecommand", provided_command},
      {"NewDocumentCommand RenewDocumentCommand DeclareDocumentCommand", document_command},
      {"def gdef edef xdef", primitive},
      {"let", synonym},
      {"DeclareMathOperator", math_operator},
      {"DeclarePairedDelimiter", delimiters},
      {"DeclarePairedDelimiterX", delimiters_around}};
  return forms.find(control);
}

bool read_definition(const Token& control, DefinitionForm form, MacroStream& stream, MacroTable& macros,
                     Diagnostics& diagnostics) {
  return DefinitionReader(control, stream, macros, diagnostics).read(form);
}

}  // namespace rigor
