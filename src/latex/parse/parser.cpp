// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/parse/parser.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "base/among.h"
#include "base/ascii.h"
#include "latex/parse/box_operator.h"
#include "latex/parse/parse.h"
#include "latex/parse/parse_indices.h"
#include "latex/parse/unseen_braces.h"
#include "latex/token/cover_tokens.h"
#include "latex/token/differential.h"

namespace rigor {
namespace {

std::optional<Joint> sign_joint(const Token& token) {
  if (is_sign(token, "+")) return Joint::plus;
  if (is_sign(token, "-") || (token.kind == TokenKind::letter && token.text == "−")) return Joint::minus;
  return std::nullopt;
}

/// `^T`, `^{\mathrm T}`, `^\top`.
bool is_transpose(TokenView content) {
  static constexpr std::array<std::string_view, 10> marks{
      "T",           "\\top",      "\\intercal", "\\mathrm{T}", "\\mathrm T",
      "\\mathsf{T}", "\\mathsf T", "\\text{T}",  "\\textsf{T}", "\\textrm{T}"};
  return is_one_of(text_of(content), marks);
}

bool starts_three_dots(TokenView tokens, std::size_t at) {
  return is_sign_at(tokens, at, ".") && is_sign_at(tokens, at + 1, ".") && is_sign_at(tokens, at + 2, ".");
}

std::string_view again_name(TokenKind script) {
  return script == TokenKind::subscript ? "subscripts" : "superscripts";
}

/// `v_x{}^2`: an empty group between a symbol and its script means nothing.
void skip_group_before_script(Parser::Cursor& cursor) {
  if (cursor.done() || cursor.token().kind != TokenKind::begin_group) return;
  const Argument group = argument_at(cursor.tokens, cursor.at);
  const std::size_t behind = skip_blank(cursor.tokens, group.next);
  if (trim(group.content).empty() && is_script_at(cursor.tokens, behind)) cursor.at = behind;
}

/// `^{\ \nu}`, `^{\phantom{\mu}\nu}`: the space of an index below.
bool begins_apart(TokenView content) {
  return !content.empty() && content.size() > 1 &&
         (is_spacing(content[0]) || is_control_of(content[0], {"phantom", "hphantom"}));
}

/// `[uv]_a^b`: behind the other limit of a bracket that ends before `behind` and has one at `script`. A
/// square of a component, `[\mathbf A\times\mathbf B]_i^2`, has none.
std::optional<std::size_t> second_limit(TokenView tokens, std::size_t behind, std::size_t script,
                                        std::size_t next) {
  if (behind == 0 || !is_sign(tokens[behind - 1], "]")) return std::nullopt;
  const std::size_t other = skip_blank(tokens, next);
  if (!is_script_at(tokens, other) || is_sign(tokens[other], "'") ||
      tokens[other].kind == tokens[script].kind)
    return std::nullopt;
  const Argument limit = script_argument_at(tokens, other + 1);
  const TokenView above = tokens[other].kind == TokenKind::superscript
                              ? limit.content
                              : script_argument_at(tokens, script + 1).content;
  return text_of(above) == "2" ? std::nullopt : std::optional(limit.next);
}

/// `\delta_{m,n-1}`: between the indices of δ a comma is no derivative.
IndexReading indices_of_delta(TokenView content) {
  const auto comma = std::ranges::find_if(content, [](const Token& token) { return is_sign(token, ","); });
  if (comma == content.end()) return read_indices(content);
  const auto at = static_cast<std::size_t>(comma - content.begin());
  IndexReading first = read_indices(trim(content.first(at)));
  IndexReading second = read_indices(trim(content.subspan(at + 1)));
  if (first.obstacle || second.obstacle || first.indices.size() != 1 || second.indices.size() != 1)
    return read_indices(content);
  first.indices.push_back(second.indices.front());
  return first;
}

}  // namespace

void Parser::Cursor::skip_spacing() {
  while (!done()) {
    const std::size_t behind = skip_empty_group(tokens, at);
    if (behind != at) {
      at = behind;
    } else if (token().text.starts_with("math") && is_transparent(token()) &&
               trim(argument_at(tokens, at + 1).content).empty() &&
               argument_at(tokens, at + 1).next < tokens.size()) {
      at = argument_at(tokens, at + 1).next;  // `\mathop{}\!\mathrm d`
    } else if (is_blank(token()) || is_spacing(token()) || is_wide_space(token())) {
      ++at;
    } else {
      return;
    }
  }
}

bool Parser::starts_sign(const Cursor& cursor) { return sign_joint(cursor.token()).has_value(); }

SyntaxId Parser::opaque(Span span, std::string message, DiagnosticKind kind, std::vector<std::string> help) {
  return tree_.add_opaque(span, {kind, std::move(message), std::move(help)});
}

SyntaxId Parser::inner(TokenView tokens, Span place) {
  if (depth_ >= max_nesting) {
    return opaque(place, fmt::format("brackets nest deeper than {} levels", max_nesting),
                  DiagnosticKind::nesting_too_deep);
  }
  return Parser(tree_, account_, depth_ + 1, choices_, side_).expression(tokens, place);
}

SyntaxId Parser::expression(TokenView tokens, Span place) {
  Cursor cursor{tokens};
  cursor.skip_spacing();
  if (cursor.done()) return opaque(place, "an expression is missing here", DiagnosticKind::bad_syntax);
  std::vector<SyntaxChild> terms;
  Span span = cursor.token().span;
  while (!cursor.done()) {
    while (lifts_braces(cursor)) cursor.skip_spacing();
    Joint joint = Joint::plus;
    Span joint_span = cursor.token().span;
    bool signed_term = false;
    while (!cursor.done()) {
      const auto sign = sign_joint(cursor.token());
      if (!sign) break;
      joint_span = cursor.token().span;
      if (signed_term && *sign == Joint::minus) joint = joint == Joint::plus ? Joint::minus : Joint::plus;
      if (!signed_term) joint = *sign;
      signed_term = true;
      read_sign(cursor);
      ++cursor.at;
      cursor.skip_spacing();
      while (lifts_braces(cursor)) cursor.skip_spacing();
    }
    if (cursor.done()) {
      terms.push_back({opaque(joint_span, "an operand is missing after the sign", DiagnosticKind::bad_syntax),
                       joint, joint_span});
      break;
    }
    const std::size_t begin = cursor.at;
    SyntaxId node = term(cursor);
    if (cursor.at == begin) {  // at a differential that may be of an integral around this one
      const TokenView rest = cursor.tokens.subspan(begin);
      read(rest);
      node = opaque(span_of(rest), "two differentials in one integral are not read");
      cursor.at = cursor.tokens.size();
    }
    span = cover(span, tree_[node].span);
    if (!terms.empty() && ends_at_bar(node))
      node = opaque(tree_[node].span, "the bar can be about this term or about all terms before it",
                    DiagnosticKind::ambiguous_reading, {"`\\left[…\\right]_a^b` shows where it begins"});
    terms.push_back({node, joint, joint_span});
    cursor.skip_spacing();
  }
  if (terms.size() == 1 && terms[0].joint == Joint::plus) return terms[0].id;
  return tree_.add(SyntaxKind::sum, span, terms);
}

SyntaxId Parser::term(Cursor& cursor) {
  std::vector<SyntaxChild> factors;
  Joint joint = Joint::none;
  Span joint_span = cursor.token().span;
  bool measured = false;
  bool behind_product = false;  // of the integrand, and behind its differential
  while (true) {
    const std::size_t before = cursor.at;
    cursor.skip_spacing();
    if (!factors.empty()) {
      const TokenView skipped = cursor.tokens.subspan(before, cursor.at - before);
      const bool spaced = std::ranges::any_of(skipped, is_spacing);
      if (const auto unit = unit_behind(cursor, factors.back().id, spaced)) {
        factors.push_back({*unit, joint, joint_span});
        joint = Joint::juxtaposed;
        continue;
      }
    }
    if (!cursor.done() && starts_outer_measure(cursor)) break;
    if (!cursor.done() && read_measure(cursor)) {
      measured = true;
      behind_product = !factors.empty();
      cursor.skip_spacing();
      if (!cursor.done() && factor_joint(cursor.token()) == Joint::slash && measure_->name.empty()) {
        measure_->divides = !factors.empty();
        if (factors.empty())  // \int dx/x
          factors.push_back({tree_.add_text(SyntaxKind::number, joint_span, "1"), joint, joint_span});
        joint = Joint::juxtaposed;
        continue;
      }
      // `\int\mathbf r\,dm\times\mathbf g`: before a product sign the integral ends.
      if (!cursor.done() && factor_joint(cursor.token()) != Joint::none) break;
      continue;
    }
    const bool ends = cursor.done() || sign_joint(cursor.token()).has_value();
    // A sign after `\cdot` or `\times` belongs to the factor: `\mathbf{A}\times-\mathbf{B}`.
    if (ends && (joint == Joint::none || joint == Joint::juxtaposed || cursor.done())) break;
    if (const Joint sign = factor_joint(cursor.token()); sign != Joint::none) {
      if (joint == Joint::dot || joint == Joint::cross || joint == Joint::slash || factors.empty()) {
        factors.push_back({opaque(cursor.token().span, "an operand is missing before this sign",
                                  DiagnosticKind::bad_syntax),
                           joint});
      }
      joint = sign;
      joint_span = cursor.token().span;
      read_sign(cursor);
      ++cursor.at;
      continue;
    }
    if (lifts_braces(cursor)) continue;
    const std::size_t begin = cursor.at;
    SyntaxId node = factor(cursor);
    if (is_box_operator(cursor.tokens, begin, cursor.at))
      node = box_operator(cursor, node, cursor.tokens[begin].span);
    if (behind_product) measure_->behind.push_back(node);
    factors.push_back({node, joint, joint_span});
    joint = Joint::juxtaposed;
    if (!cursor.done()) joint_span = cursor.token().span;
  }
  if (measured && factors.empty()) return tree_.add_text(SyntaxKind::number, joint_span, "1");
  if (joint == Joint::dot || joint == Joint::cross || joint == Joint::slash || factors.empty()) {
    factors.push_back({missing_operand(joint, joint_span, factors), joint, joint_span});
  }
  divide_by_all_behind(cursor.tokens, factors);
  put_product_before_bar(factors);
  if (factors.size() == 1) return factors[0].id;
  Span span = tree_[factors.front().id].span;
  for (const SyntaxChild& child : factors) span = cover(span, tree_[child.id].span);
  return tree_.add(SyntaxKind::term, span, factors);
}

/// `1/2r`: one half of r, or one by 2r. A blank after the 2 sets it apart: `1/2 r`.
void Parser::divide_by_all_behind(TokenView tokens, std::vector<SyntaxChild>& factors) {
  const auto is_number = [&](std::size_t k) { return tree_[factors[k].id].kind == SyntaxKind::number; };
  for (std::size_t k = 1; k + 1 < factors.size(); ++k) {
    const bool halves = factors[k].joint == Joint::slash && is_number(k - 1) && is_number(k) &&
                        factors[k + 1].joint == Joint::juxtaposed;
    const Span divisor = tree_[factors[k].id].span;
    if (!halves || divisor.end != tree_[factors[k + 1].id].span.begin) continue;
    const Span whole = cover(tree_[factors[k - 1].id].span, tree_[factors.back().id].span);
    const auto written = [&](Span span) {
      const auto inside = [&](const Token& token) {
        return token.span.begin >= span.begin && token.span.end <= span.end;
      };
      const auto first = std::ranges::find_if(tokens, inside);
      return text_of(TokenView(first, std::find_if_not(first, tokens.end(), inside)));
    };
    const std::string above = written(tree_[factors[k - 1].id].span);
    const std::string below = written(divisor);
    const std::string behind = written(cover(tree_[factors[k + 1].id].span, tree_[factors.back().id].span));
    if (!takes_second({whole, fmt::format("\\frac{{{}}}{{{}}} {}", above, below, behind),
                       fmt::format("\\frac{{{}}}{{{} {}}}", above, below, behind)}))
      return;
    std::vector<SyntaxChild> below_factors(factors.begin() + static_cast<std::ptrdiff_t>(k), factors.end());
    below_factors[0].joint = Joint::none;
    const Span span = cover(divisor, tree_[factors.back().id].span);
    const SyntaxChild product{tree_.add(SyntaxKind::term, span, below_factors)};
    const SyntaxChild group{tree_.add(SyntaxKind::group, span, {&product, 1}), Joint::slash,
                            factors[k].joint_span};
    factors.resize(k);
    factors.push_back(group);
    return;
  }
}

SyntaxId Parser::factor(Cursor& cursor) {
  if (depth_ >= max_nesting) {
    const Span place = cursor.token().span;
    cursor.at = cursor.tokens.size();
    return opaque(place, fmt::format("this nests deeper than {} levels", max_nesting),
                  DiagnosticKind::nesting_too_deep);
  }
  ++depth_;
  const SyntaxId node = sign_joint(cursor.token()) ? signed_factor(cursor) : scripts(cursor, primary(cursor));
  --depth_;
  return node;
}

SyntaxId Parser::signed_factor(Cursor& cursor) {
  const Span place = cursor.token().span;
  const Joint sign = *sign_joint(cursor.token());
  read_sign(cursor);
  ++cursor.at;
  cursor.skip_spacing();
  if (cursor.done()) return opaque(place, "an operand is missing after the sign", DiagnosticKind::bad_syntax);
  const SyntaxChild child{factor(cursor), sign, place};
  return tree_.add(SyntaxKind::sum, cover(place, tree_[child.id].span), {&child, 1});
}

SyntaxId Parser::primary(Cursor& cursor) {
  const Token& token = cursor.token();
  if (is_partial(token)) return partial(cursor);
  if (const auto slash = slash_derivative(cursor)) return *slash;
  if (const auto acting = acts(cursor)) return *acting;
  switch (token.kind) {
    case TokenKind::digit:
      return number(cursor);
    case TokenKind::letter:
      return letter(cursor);
    case TokenKind::control:
      return control(cursor);
    case TokenKind::begin_group: {
      const Argument group = argument_at(cursor.tokens, cursor.at);
      if (stacks_powers(cursor.tokens, std::exchange(cursor.at, group.next)))
        return stacked_powers(token.span);
      // `{}-A`: an empty group holds the place of an operand; before an operand it means nothing.
      const std::size_t behind = skip_blank(cursor.tokens, group.next);
      if (trim(group.content).empty() && is_script_at(cursor.tokens, behind)) {
        cursor.at = script_argument_at(cursor.tokens, behind + 1).next;
        return opaque(token.span, "a subscript or superscript before its symbol is not read");
      }
      return inner(group.content, token.span);
    }
    default:
      break;
  }
  if (is_asking_mark(cursor.tokens, cursor.at)) return asked(cursor);
  if (is_sign_of(token, "([")) return bracketed(cursor);
  if (is_sign(token, "|")) return bars(cursor);
  if (is_sign(token, ".") && cursor.at + 1 < cursor.tokens.size() &&
      cursor.tokens[cursor.at + 1].kind == TokenKind::digit) {
    return number(cursor);
  }
  if (is_sign(token, ".") && starts_three_dots(cursor.tokens, cursor.at)) {
    cursor.at += 3;
    return opaque(cover(token.span, cursor.tokens[cursor.at - 1].span),
                  fmt::format("`...`: {}", unread_reason("dots")));
  }
  if (const auto interval = reversed_interval(cursor)) return *interval;
  ++cursor.at;
  if (is_sign_of(token, ")]") || token.kind == TokenKind::end_group) {
    return opaque(token.span, fmt::format("`{}` closes nothing", token.text), DiagnosticKind::unbalanced);
  }
  if (is_script(token)) {
    if (!cursor.done()) cursor.at = argument_at(cursor.tokens, cursor.at).next;
    return opaque(token.span, "a subscript or superscript without a symbol before it is not read");
  }
  return opaque(token.span, fmt::format("the sign `{}` is not read here", text_of({&token, 1})));
}

SyntaxId Parser::scripts(Cursor& cursor, SyntaxId base) {
  bool below = false;  // a subscript is there already
  bool above = false;
  const std::size_t before = cursor.at;
  bool staggered = tree_[base].kind == SyntaxKind::symbol;  // `{F_\mu}^\nu`
  if (const std::size_t end = degree_end(cursor); end != cursor.at && tree_[base].kind == SyntaxKind::number)
    base = in_degrees(cursor, base, end);
  while (true) {
    if (auto bar = evaluation_bar(cursor)) {
      const bool field = tree_[base].kind == SyntaxKind::derivative && tree_.derivative(base).partial;
      base = in_frame(base, field, std::move(*bar));
      continue;
    }
    Cursor ahead = cursor;
    while (!ahead.done() && (is_blank(ahead.token()) || is_control(ahead.token(), "limits"))) ++ahead.at;
    const std::size_t apart = ahead.at;
    skip_group_before_script(ahead);
    if (ahead.at != apart) below = above = false;  // `T_i{}_j`
    staggered = staggered || ahead.at != apart;
    if (ahead.done() || !is_script(ahead.token())) return base;
    const Token script = ahead.token();
    read_sign(ahead);
    cursor.at = ahead.at + 1;
    if (is_sign(script, "'")) {
      base = add_primes(base, 1, script.span);
      continue;
    }
    const Argument argument = script_argument_at(cursor.tokens, cursor.at);
    if (const auto end = second_limit(cursor.tokens, before, ahead.at, argument.next)) {
      const std::size_t other = skip_blank(cursor.tokens, argument.next);
      const TokenView second = script_argument_at(cursor.tokens, other + 1).content;
      const bool lower_first = script.kind == TokenKind::subscript;
      read(cursor.tokens.subspan(other, 1));
      cursor.at = *end;
      base = between(base, lower_first ? argument.content : second, lower_first ? second : argument.content,
                     tree_[base].span);
      continue;
    }
    const Span place = cover(script.span, cursor.tokens.subspan(cursor.at, argument.next - cursor.at));
    cursor.at = argument.next;
    bool& again = script.kind == TokenKind::subscript ? below : above;
    if (std::exchange(again, true)) {
      base = opaque(place, fmt::format("two {} on one base", again_name(script.kind)),
                    DiagnosticKind::bad_syntax,
                    {"`{}` between them says that the second comes after the first"});
      continue;
    }
    if (script.kind == TokenKind::subscript) {
      base = add_indices(base, argument.content, place);
    } else {
      const auto labelled = is_sign_at(cursor.tokens, skip_blank(cursor.tokens, cursor.at), "(")
                                ? std::nullopt  // `f^{(2)}(x)`
                                : add_upper_label(base, argument.content, place);
      if (!labelled && (staggered || begins_apart(argument.content))) base = raised_behind(base);
      base = labelled ? *labelled : exponent(base, argument.content, place);
    }
    staggered = false;
  }
}

/// What stands above comes after all that stands below so far: `F_\mu{}^\nu`, `F_\mu^{\ \nu}`.
SyntaxId Parser::raised_behind(SyntaxId base) {
  if (tree_[base].kind != SyntaxKind::symbol || tree_.symbol(base).lower.empty()) return base;
  WrittenSymbol symbol = tree_.symbol(base);
  symbol.raised_at = static_cast<std::uint8_t>(symbol.lower.size());
  return tree_.add_symbol(tree_[base].span, std::move(symbol));
}

SyntaxId Parser::add_primes(SyntaxId base, std::uint8_t primes, Span place) {
  const Span span = cover(tree_[base].span, place);
  if (tree_[base].kind != SyntaxKind::symbol)
    return opaque(span, "a prime after this expression is not read");
  WrittenSymbol symbol = tree_.symbol(base);
  symbol.primes = static_cast<std::uint8_t>(symbol.primes + primes);
  return tree_.add_symbol(span, std::move(symbol));
}

/// `z^*`, `A^\dagger`
bool Parser::is_conjugate(SyntaxId node) const {
  return tree_[node].kind == SyntaxKind::function &&
         (tree_.text(node) == "conjugate" || tree_.text(node) == "adjoint");
}

/// `\langle x\rangle`, also to a power
bool Parser::is_average(SyntaxId node) const {
  if (tree_[node].kind == SyntaxKind::power) node = tree_.child(node, 0);
  return tree_[node].kind == SyntaxKind::function && tree_.text(node) == "average";
}

SyntaxId Parser::add_indices(SyntaxId base, TokenView content, Span place) {
  const Span span = cover(tree_[base].span, place);
  if (tree_[base].kind == SyntaxKind::opaque) return base;
  if (is_conjugate(base) && tree_[tree_.child(base, 0)].kind == SyntaxKind::symbol)  // \psi^*_n
    return tree_.add_named(SyntaxKind::function, span, std::string(tree_.text(base)),
                           add_indices(tree_.child(base, 0), content, place));
  if (tree_[base].kind == SyntaxKind::power &&
      tree_[tree_.child(base, 0)].kind == SyntaxKind::symbol) {  // v^2_x
    const SyntaxChild children[] = {{add_indices(tree_.child(base, 0), content, place)},
                                    {tree_.child(base, 1)}};
    return tree_.add(SyntaxKind::power, span, children);
  }
  if (is_average(base)) return opaque(place, "an average with a subscript is not read");
  const bool delta = tree_[base].kind == SyntaxKind::symbol && tree_.symbol(base).letter == "\\delta";
  IndexReading reading = delta ? indices_of_delta(content) : read_indices(content);
  if (reading.obstacle) return tree_.add_opaque(place, *reading.obstacle);
  if (reading.indices.empty()) return opaque(place, "the subscript is empty", DiagnosticKind::bad_syntax);
  if (tree_[base].kind == SyntaxKind::symbol && tree_.symbol(base).letter == "\\epsilon") {
    const WrittenIndex& first = reading.indices.front();
    const bool is_plain = trim(content).front().kind == TokenKind::letter;
    if (is_plain && first.form == IndexForm::word && (first.text == "kin" || first.text == "min"))
      return opaque(place,
                    fmt::format("`{}` can be a word or three indices; write `\\text{{{}}}` or `{{{}}}{}`",
                                first.text, first.text, first.text[0], first.text.substr(1)));
  }
  read(content);
  if (tree_[base].kind == SyntaxKind::symbol) {
    WrittenSymbol symbol = tree_.symbol(base);
    symbol.lower.insert(symbol.lower.end(), reading.indices.begin(), reading.indices.end());
    return tree_.add_symbol(span, std::move(symbol));
  }
  return tree_.add_component(span, base, std::move(reading.indices));
}

/// `E^{(1)}_n`: the label comes before the indices, wherever it stands.
std::optional<SyntaxId> Parser::add_upper_label(SyntaxId base, TokenView content, Span place) {
  if (tree_[base].kind != SyntaxKind::symbol) return std::nullopt;
  WrittenSymbol symbol = tree_.symbol(base);
  static const WordSet others("\\delta \\epsilon \\pi \\nabla e d i j \\mathrm{e} \\mathrm{d} \\mathrm{i}");
  const bool plain = symbol.face == Face::plain && symbol.accent == Accent::none && symbol.primes == 0 &&
                     symbol.dots == 0 && symbol.change.empty() && !others.contains(symbol.letter) &&
                     symbol.letter != hole_letter;
  const bool raised = !symbol.lower.empty() && symbol.lower.front().text.starts_with('^');
  auto label = plain && !raised ? read_upper_label(content) : std::nullopt;
  if (!label) return std::nullopt;
  read(content);
  symbol.lower.insert(symbol.lower.begin(), std::move(*label));
  return tree_.add_symbol(cover(tree_[base].span, place), std::move(symbol));
}

SyntaxId Parser::exponent(SyntaxId base, TokenView content, Span place) {
  content = trim(content);
  const auto is_prime = [](const Token& token) { return is_control(token, "prime") || is_sign(token, "'"); };
  if (!content.empty() && std::ranges::all_of(content, is_prime)) {
    read(content);
    return add_primes(base, static_cast<std::uint8_t>(content.size()), place);
  }
  const Span span = cover(tree_[base].span, place);
  if (tree_[base].kind == SyntaxKind::opaque) return base;
  if (content.size() == 1) {
    if (is_sign(content[0], "*") || is_control_of(content[0], {"ast", "star"})) {
      read(content);
      return tree_.add_named(SyntaxKind::function, span, "conjugate", base);
    }
    if (is_sign(content[0], "+")) return opaque(place, "an adjoint is not read yet");
    if (is_sign(content[0], "-") || is_control(content[0], "pm") || is_control(content[0], "mp"))
      return opaque(place, "a sign above a letter is a label, which is not read yet");
  }
  const bool adjoint =
      !content.empty() && (is_control_of(content[0], {"dagger", "dag"}) || content[0].text == "†");
  if (adjoint) {  // also `a^{\dagger 2}`
    read(content.first(1));
    const SyntaxId marked = tree_.add_named(SyntaxKind::function, span, "adjoint", base);
    return content.size() == 1 ? marked : exponent(marked, content.subspan(1), place);
  }
  if (is_transpose(content)) {
    read(content);
    return tree_.add_named(SyntaxKind::function, span, "transpose", base);
  }
  const SyntaxChild children[] = {{base}, {inner(content, place)}};
  return tree_.add(SyntaxKind::power, span, children);
}

}  // namespace rigor
