// SPDX-License-Identifier: GPL-3.0-or-later
// Integrals over a body, `\int f\,dm`, `\int_V dV\,\rho`, and over one variable, `\int_a^b f\,dx`.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "latex/parse/parser.h"
#include "latex/token/differential.h"

namespace rigor {
namespace {

struct Region {
  std::string_view written;
  std::string_view name;
};

/// Names that all of the body can have. Two of them in one statement could be different regions.
constexpr Region regions[] = {{"V", "V"},
                              {"B", "B"},
                              {"\\mathcal V", "\\mathcal{V}"},
                              {"\\mathcal{V}", "\\mathcal{V}"},
                              {"\\mathcal B", "\\mathcal{B}"},
                              {"\\mathcal{B}", "\\mathcal{B}"},
                              {"\\text{body}", "\\text{body}"},
                              {"\\text{volume}", "\\text{volume}"},
                              {"\\mathrm{body}", "\\text{body}"},
                              {"\\rm body", "\\text{body}"}};

}  // namespace

/// The sub- and superscript of the sign. What names a region is read; a limit is left to `limit`.
Parser::Bounds Parser::bounds(Cursor& cursor) {
  Bounds bounds;
  while (true) {
    cursor.skip_spacing();
    if (cursor.done()) return bounds;
    const TokenKind kind = cursor.token().kind;
    if (kind != TokenKind::subscript && kind != TokenKind::superscript) return bounds;
    const Argument argument = script_argument_at(cursor.tokens, cursor.at + 1);
    read_sign(cursor);
    std::optional<TokenView>& bound = kind == TokenKind::subscript ? bounds.lower : bounds.upper;
    bounds.again = bounds.again || bound.has_value();
    bound = argument.content;
    const auto known = std::ranges::find_if(
        regions,
        [written = text_of(argument.content)](const Region& each) { return each.written == written; });
    bounds.whole_body = known != std::end(regions);
    if (bounds.whole_body) bounds.region = known->name;
    cursor.at = argument.next;
  }
}

SyntaxId Parser::integral(Cursor& cursor) {
  const Token token = cursor.token();
  ++cursor.at;
  const Bounds bounds = this->bounds(cursor);
  if (cursor.done()) return opaque(token.span, "the integral has no integrand", DiagnosticKind::bad_syntax);
  Measure measure;
  measure.outer = std::exchange(measure_, &measure);
  const SyntaxId body = term(cursor);
  measure_ = measure.outer;
  Span span = cover(token.span, tree_[body].span);
  if (measure.span) span = cover(span, *measure.span);
  const bool limits = bounds.lower && bounds.upper;
  if (!limits || bounds.again) {
    for (const auto& bound : {bounds.lower, bounds.upper}) {
      if (bound) read(*bound);
    }
  }
  if (bounds.again) return opaque(span, "the integral has two subscripts", DiagnosticKind::bad_syntax);
  if (bounds.upper && !bounds.lower) return opaque(span, "an integral with one limit is not read");
  if (!limits && !bounds.whole_body)
    return opaque(span, "an integral over a part, a surface or a curve is not read");
  if (measure.count == 0)
    return opaque(span, "the integral does not say over what; `dx`, `dm`, `dV` and `d^3r` are read");
  if (measure.count > 1) return opaque(span, "two differentials in one integral are not read");
  if (!limits && !measure.name.empty()) return tree_.add_integral(span, measure.name, body, bounds.region);
  if (limits && measure.name == "m")
    return opaque(span, "an integral over masses between limits is not read");
  if (!measure.variable || (!limits && !bounds.region.empty()) || token.text != "int")
    return opaque(span, fmt::format("an integral over `{}` is not read", measure.text));
  if (measure.divides)
    return opaque(span, "the slash behind the differential can divide the integral or what is integrated",
                  DiagnosticKind::ambiguous_reading);
  if (has_letter(measure.behind, tree_.symbol(*measure.variable)))
    return opaque(span, "what is behind the differential can belong to the integral or not",
                  DiagnosticKind::ambiguous_reading, {"the differential ends the integral"});
  std::vector<SyntaxChild> children{{body}, {*measure.variable}};
  if (limits) {
    children.push_back({limit(*bounds.lower, span)});
    children.push_back({limit(*bounds.upper, span)});
  }
  return tree_.add(SyntaxKind::line_integral, span, children);
}

bool Parser::has_letter(const std::vector<SyntaxId>& nodes, const WrittenSymbol& symbol) const {
  return std::ranges::any_of(nodes_below(tree_, nodes), [&](SyntaxId id) {
    return tree_[id].kind == SyntaxKind::symbol && tree_.symbol(id).letter == symbol.letter &&
           tree_.symbol(id).primes == symbol.primes;
  });
}

/// One end of an interval; an infinity is a symbol, with a sign or without.
SyntaxId Parser::limit(TokenView tokens, Span place) {
  tokens = trim(tokens);
  const bool sign = !tokens.empty() && is_sign_of(tokens[0], "+-");
  const TokenView bare = trim(tokens.subspan(sign ? 1 : 0));
  if (bare.size() != 1 || !is_control(bare[0], "infty"))
    return inner(tokens, tokens.empty() ? place : span_of(tokens));
  read(tokens);
  const SyntaxId infinity = tree_.add_symbol(bare[0].span, {.letter = "\\infty"});
  if (!sign || is_sign(tokens[0], "+")) return infinity;
  const SyntaxChild child{infinity, Joint::minus, tokens[0].span};
  return tree_.add(SyntaxKind::sum, span_of(tokens), {&child, 1});
}

/// `[F]_a^b`, `F\Big|_{x=a}^{x=b}`
SyntaxId Parser::between(SyntaxId value, TokenView lower, TokenView upper, Span span) {
  std::vector<SyntaxChild> children{{value}};
  std::optional<TokenView> variable;
  for (const TokenView bound : {lower, upper}) {
    const auto equals = std::ranges::find_if(bound, [](const Token& token) { return is_sign(token, "="); });
    if (equals == bound.end()) {
      children.push_back({limit(bound, span)});
      continue;
    }
    const TokenView name = trim(TokenView(bound.begin(), equals));
    if (name.empty() || (variable && text_of(*variable) != text_of(name)))
      return opaque(span, "these limits are not read");
    if (variable) read(name);
    if (!variable) variable = name;
    read(TokenView(equals, equals + 1));
    children.push_back({limit(TokenView(equals + 1, bound.end()), span)});
  }
  if (variable) children.push_back({inner(*variable, span)});
  return tree_.add(SyntaxKind::between, span, children);
}

/// `x^2\Big|_a^b`, where nothing but the page shows how far to the left the bar reaches?
bool Parser::ends_at_bar(SyntaxId node) const {
  if (tree_[node].kind == SyntaxKind::between) return tree_[tree_.child(node, 0)].kind != SyntaxKind::group;
  return tree_[node].kind == SyntaxKind::term &&
         std::ranges::any_of(tree_.children(node),
                             [&](const SyntaxChild& child) { return ends_at_bar(child.id); });
}

/// The bar behind a product is about the whole of it.
void Parser::put_product_before_bar(std::vector<SyntaxChild>& factors) {
  const auto bar =
      std::ranges::find_if(factors, [&](const SyntaxChild& child) { return ends_at_bar(child.id); });
  if (bar == factors.end() || bar == factors.begin()) return;
  std::vector<SyntaxChild> parts(tree_.children(bar->id).begin(), tree_.children(bar->id).end());
  std::vector<SyntaxChild> product(factors.begin(), bar + 1);
  product.back().id = parts[0].id;
  const Span span = cover(tree_[product.front().id].span, tree_[parts[0].id].span);
  parts[0].id = tree_.add(SyntaxKind::term, span, product);
  const SyntaxChild whole{tree_.add(SyntaxKind::between, cover(span, tree_[bar->id].span), parts)};
  factors.erase(factors.begin(), bar + 1);
  factors.insert(factors.begin(), whole);
}

/// `\frac{dx}{x}`: a numerator belongs to what is integrated.
SyntaxId Parser::with_measure(TokenView tokens, Span place) {
  if (measure_ == nullptr || depth_ >= max_nesting) return inner(tokens, place);
  Parser above(tree_, account_, depth_ + 1, choices_, side_);
  above.measure_ = measure_;
  return above.expression(tokens, place);
}

/// At the differential of the integral that is being read: takes it out.
bool Parser::read_measure(Cursor& cursor) {
  if (measure_ == nullptr) return false;
  const TokenView tokens = cursor.tokens;
  const auto mark = differential_at(tokens, cursor.at);
  if (!mark || mark->partial) return false;
  const std::size_t begin = skip_narrow(tokens, mark->next);
  TokenView written;
  std::size_t end = symbol_end(tokens, begin);
  if (end != begin) {
    written = tokens.subspan(begin, end - begin);
  } else {  // \dd{m}
    const Argument group = argument_at(tokens, begin);
    if (!is_kind_at(tokens, begin, TokenKind::begin_group)) return false;
    if (symbol_end(group.content, 0) != group.content.size() || group.content.empty()) return false;
    written = group.content;
    end = group.next;
  }
  const TokenView whole = tokens.subspan(cursor.at, end - cursor.at);
  ++measure_->count;
  measure_->text = text_of(whole);
  const Span place = span_of(whole);
  measure_->span = place;
  const SyntaxId over = inner(written, place);
  measure_->name = measure_name(over, mark->order);
  measure_->variable = variable_of_measure(over, mark->order);
  read(whole);
  cursor.at = end;
  return true;
}

/// In `\int\int f\,dx\,dy` the second differential belongs to the first sign.
bool Parser::starts_outer_measure(const Cursor& cursor) const {
  if (measure_ == nullptr || measure_->count == 0 || measure_->outer == nullptr) return false;
  const auto mark = differential_at(cursor.tokens, cursor.at);
  return mark && !mark->partial &&
         symbol_end(cursor.tokens, skip_narrow(cursor.tokens, mark->next)) != mark->next;
}

/// A plain number, `x`, `t'`, `x_0`.
std::optional<SyntaxId> Parser::variable_of_measure(SyntaxId node, int order) const {
  if (tree_[node].kind != SyntaxKind::symbol || order != 1) return std::nullopt;
  const WrittenSymbol& symbol = tree_.symbol(node);
  const bool plain = symbol.face == Face::plain && symbol.dots == 0 && symbol.accent == Accent::none &&
                     symbol.change.empty() &&
                     std::ranges::none_of(symbol.lower, [](const WrittenIndex& index) {
                       return index.form == IndexForm::letter || index.form == IndexForm::greek;
                     });
  return plain ? std::optional(node) : std::nullopt;
}

std::string Parser::measure_name(SyntaxId node, int order) const {
  if (tree_[node].kind != SyntaxKind::symbol) return {};
  const WrittenSymbol& symbol = tree_.symbol(node);
  if (!symbol.lower.empty() || symbol.primes > 0 || symbol.dots > 0 || symbol.accent != Accent::none ||
      !symbol.change.empty())
    return {};
  const bool plain = symbol.face == Face::plain;
  if (order == 1 && plain && (symbol.letter == "m" || symbol.letter == "V")) return symbol.letter;
  if (order == 3 && symbol.face != Face::tensor && (symbol.letter == "r" || symbol.letter == "x")) return "V";
  return {};
}

}  // namespace rigor
