// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/macro/macro_conditional.h"

#include <array>

#include "latex/token/words.h"

namespace rigor {
namespace {

// As in xparse; nobody types them.
constexpr std::string_view absent = "-NoValue-";
constexpr std::string_view true_name = "BooleanTrue";
constexpr std::string_view false_name = "BooleanFalse";

bool is_alone(TokenView tokens, std::string_view name) {
  return tokens.size() == 1 && is_control(tokens[0], name);
}

/// `\equal{…}{…}`, compared as written.
std::optional<bool> are_equal(TokenView condition) {
  condition = trim(condition);
  if (condition.empty() || !is_control(condition[0], "equal")) return std::nullopt;
  const Argument left = argument_at(condition, 1);
  const Argument right = argument_at(condition, left.next);
  if (right.next != condition.size()) return std::nullopt;
  return text_of(left.content) == text_of(right.content);
}

std::optional<bool> answer(MacroTest::Kind kind, TokenView argument) {
  using enum MacroTest::Kind;
  argument = trim(argument);
  switch (kind) {
    case truth:
      if (is_alone(argument, true_name)) return true;
      return is_alone(argument, false_name) ? std::optional(false) : std::nullopt;
    case no_value:
      return is_alone(argument, absent);
    case value:
      return !is_alone(argument, absent);
    case blank:
      return argument.empty();
    case equal:
      return are_equal(argument);
  }
  return std::nullopt;
}

}  // namespace

std::optional<MacroTest> macro_test(std::string_view control) {
  using enum MacroTest::Kind;
  static const WordMap<MacroTest> tests{{"IfBooleanTF", {truth}},
                                        {"IfBooleanT", {truth, true, false}},
                                        {"IfBooleanF", {truth, false, true}},
                                        {"IfNoValueTF", {no_value}},
                                        {"IfNoValueT", {no_value, true, false}},
                                        {"IfNoValueF", {no_value, false, true}},
                                        {"IfValueTF", {value}},
                                        {"IfValueT", {value, true, false}},
                                        {"IfValueF", {value, false, true}},
                                        {"IfBlankTF ifblank ifstrempty", {blank}},
                                        {"IfBlankT", {blank, true, false}},
                                        {"IfBlankF", {blank, false, true}},
                                        {"ifthenelse", {equal}}};
  return tests.find(control);
}

std::optional<Tokens> chosen_branch(MacroStream& stream, const MacroTest& test) {
  const auto argument = stream.take_argument();
  const auto holds = argument ? answer(test.kind, argument->tokens) : std::nullopt;
  if (!holds) return std::nullopt;
  Tokens chosen;
  for (const bool branch : {true, false}) {
    if (!(branch ? test.then : test.otherwise)) continue;
    auto tokens = stream.take_argument();
    if (!tokens) return std::nullopt;
    if (branch == *holds) chosen = std::move(tokens->tokens);
  }
  return chosen;
}

Token no_value() { return {TokenKind::control, absent, {}}; }

Token truth_value(bool value) { return {TokenKind::control, value ? true_name : false_name, {}}; }

}  // namespace rigor
