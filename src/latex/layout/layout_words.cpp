// SPDX-License-Identifier: GPL-3.0-or-later
// Words inside mathematics, and numbers with units as siunitx writes them.
#include "base/ascii.h"
#include "latex/layout/layout_reader.h"
#include "latex/token/vocabulary.h"
#include "latex/token/words.h"

namespace rigor {
namespace {

/// What a token of words prints.
std::string printed_word(const Token& token) {
  if (is_blank(token) || is_sign(token, "~")) return " ";
  switch (token.kind) {
    case TokenKind::begin_group:
    case TokenKind::end_group:
      return {};
    case TokenKind::superscript:
      return "^";
    case TokenKind::subscript:
      return "_";
    case TokenKind::control:
      break;
    default:
      return is_sign_of(token, "'`") ? "’" : std::string(token.text);
  }
  if (const auto printed = sign_of_control(token.text)) return std::string(printed->text);
  if (const auto width = space_of(token.text)) return *width > 0 ? " " : "";
  if (is_words(token) || typeface_of(token.text)) return {};
  return "\\" + std::string(token.text);
}

struct UnitWord {
  std::string_view sign;
  bool prefix = false;
};

std::optional<UnitWord> unit_word(std::string_view name) {
  static const WordTable units(R"(
      gram g  metre m  meter m  second s  ampere A  kelvin K  mole mol  candela cd  newton N  joule J
      watt W  pascal Pa  hertz Hz  coulomb C  volt V  farad F  ohm Ω  siemens S  weber Wb  tesla T  henry H
      minute min  hour h  day d  litre L  liter L  tonne t  bar bar  radian rad  steradian sr  degree °
      percent %  electronvolt eV  kilogram kg  celsius °C)");
  static const WordTable prefixes(R"(
      deca da  hecto h  kilo k  mega M  giga G  tera T  peta P  deci d  centi c  milli m  micro µ  nano n
      pico p  femto f)");
  if (const std::string_view sign = units.find(name); !sign.empty()) return UnitWord{sign, false};
  const std::string_view sign = prefixes.find(name);
  return sign.empty() ? std::nullopt : std::optional(UnitWord{sign, true});
}

/// `\kilo\metre\per\second\squared` or `kg.m/s^2` as a row.
class UnitPrinter {
 public:
  explicit UnitPrinter(TokenView tokens) : tokens_(tokens) {}

  Box read() {
    for (at_ = 0; at_ < tokens_.size(); ++at_) step();
    flush();
    return row_box(std::move(parts_));
  }

 private:
  void step() {
    const Token& token = tokens_[at_];
    if (token.kind == TokenKind::control) return word(token.text);
    if (token.kind == TokenKind::superscript) {
      power_ = text_of(argument_at(tokens_, at_ + 1).content);
      at_ = argument_at(tokens_, at_ + 1).next - 1;
      return flush();
    }
    const bool parts_units = is_blank(token) || is_sign_of(token, ".~");
    if (parts_units) return flush();
    if (is_sign(token, "/")) {
      flush();
      parts_.push_back(sign_box("/", SignRole::ordinary));
      apart_ = false;
      return;
    }
    if (token.kind == TokenKind::letter || token.kind == TokenKind::digit || is_sign(token, "-"))
      sign_ += token.text;
  }

  void word(std::string_view name) {
    if (name == "per") {
      flush();
      inverse_ = true;
    } else if (name == "squared" || name == "cubed") {
      power_ = name == "squared" ? "2" : "3";
      flush();
    } else if (name == "square" || name == "cubic") {
      flush();
      power_ = name == "square" ? "2" : "3";
    } else if (const auto unit = unit_word(name)) {
      if (!prefixed_) flush_sign();
      sign_ += unit->sign;
      prefixed_ = unit->prefix;
    } else if (const auto printed = sign_of_control(name); printed && printed->role == SignRole::ordinary) {
      sign_ += printed->text;  // \mu, \Omega
    } else if (name == "cdot" || space_of(name)) {
      flush();
    } else if (name != "mathrm" && name != "text") {
      sign_ += "\\" + std::string(name);
    }
  }

  void flush_sign() {
    if (!sign_.empty()) flush();
  }

  void flush() {
    if (sign_.empty()) return;
    if (apart_) parts_.push_back(space_box(0.1667));
    if (inverse_) power_ = "−" + (power_.empty() ? "1" : power_);
    Box unit = letter_box(sign_, Typeface::upright);
    parts_.push_back(power_.empty()
                         ? std::move(unit)
                         : scripts_box(std::move(unit), Box{}, Box{.kind = BoxKind::number, .text = power_}));
    sign_.clear();
    power_.clear();
    inverse_ = prefixed_ = false;
    apart_ = true;
  }

  TokenView tokens_;
  std::size_t at_ = 0;
  std::vector<Box> parts_;
  std::string sign_;
  std::string power_;
  bool inverse_ = false;
  bool prefixed_ = false;
  bool apart_ = false;  // the next unit is after another
};

/// `1.5e-3`: with × 10 to a power.
Box number_box(const std::string& text) {
  const std::size_t exponent = text.find_first_of("eE");
  Box mantissa{.kind = BoxKind::number, .text = text.substr(0, exponent)};
  if (exponent == std::string::npos) return mantissa;
  std::string power = text.substr(exponent + 1);
  if (power.starts_with('-')) power.replace(0, 1, "−");
  std::vector<Box> parts;
  if (!mantissa.text.empty()) {
    parts.push_back(std::move(mantissa));
    parts.push_back(sign_box("×", SignRole::binary));
  }
  parts.push_back(
      scripts_box({.kind = BoxKind::number, .text = "10"}, Box{}, {.kind = BoxKind::number, .text = power}));
  return row_box(std::move(parts));
}

}  // namespace

std::string text_line(TokenView tokens) {
  std::string line;
  for (const Token& token : tokens) {
    if (!is_sign(token, "$")) line += printed_word(token);
  }
  return line;
}

Box text_box(TokenView tokens, LayoutContext context) {
  std::vector<Box> parts;
  std::string words;
  const auto flush = [&] {
    if (!words.empty()) parts.push_back(words_box(words));
    words.clear();
  };
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    if (!is_sign(tokens[at], "$")) {
      words += printed_word(tokens[at]);
      continue;
    }
    std::size_t end = at + 1;
    while (end < tokens.size() && !is_sign(tokens[end], "$")) ++end;
    flush();
    parts.push_back(
        LayoutReader(tokens.subspan(at + 1, end - at - 1), {context.depth + 1, Typeface::italic}).read());
    at = end;
  }
  flush();
  return row_box(std::move(parts));
}

bool LayoutReader::words(std::string_view name) {
  const Token token{TokenKind::control, name, {}};
  if (name == "operatorname" || name == "DeclareMathOperator") {
    const bool limits = next_is("*");
    skip_star();
    Box word = letter_box(text_line(take_argument()), Typeface::upright);
    word.limits = limits;
    function_word(std::move(word));
    return true;
  }
  if (name == "ref" || name == "eqref" || name == "cite") {
    push(words_box("(" + text_line(take_argument()) + ")"));
    return true;
  }
  if (!is_words(token)) return false;
  skip_star();
  const TokenView content = take_argument();
  if (name == "qq") push(space_box(1));
  Box box = text_box(content, context_);
  if (name == "fbox") {
    Box framed{.kind = BoxKind::framed};
    framed.parts.push_back(std::move(box));
    box = std::move(framed);
  }
  push(std::move(box));
  if (name == "qq") push(space_box(1));
  return true;
}

bool LayoutReader::quantity(std::string_view name) {
  const bool braced = is_kind_at(tokens_, at_, TokenKind::begin_group);
  if (name == "num" || name == "ang") {
    static_cast<void>(take_optional());
    push(number_box(text_of(take_argument())));
    if (name == "ang") push(sign_box("°", SignRole::ordinary));
    return true;
  }
  if (name == "si" || name == "unit") {
    static_cast<void>(take_optional());
    push(UnitPrinter(take_argument()).read());
    return true;
  }
  if (name != "SI" && name != "qty") return false;
  const std::size_t begin = at_;
  static_cast<void>(take_optional());
  const TokenView value = take_argument();
  const bool two = is_kind_at(tokens_, at_, TokenKind::begin_group);
  if (name == "qty" && !(braced && two)) {  // that of the physics package
    at_ = begin;
    return false;
  }
  push(number_box(text_of(value)));
  push(space_box(0.1667));
  push(UnitPrinter(take_argument()).read());
  return true;
}

}  // namespace rigor
