// SPDX-License-Identifier: GPL-3.0-or-later
// Integrals over a body: `\int f\,dm`, `\int_V dV\,\rho`.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "latex/parse/parser.h"
#include "latex/split/differential.h"

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

SyntaxId Parser::integral(Cursor& cursor) {
  const Token token = cursor.token();
  ++cursor.at;
  std::string region;
  bool whole_body = true;
  bool limits = false;
  bool bounded = false;  // has a subscript
  bool again = false;    // has two
  while (true) {
    cursor.skip_spacing();
    if (cursor.done()) break;
    const TokenKind kind = cursor.token().kind;
    if (kind != TokenKind::subscript && kind != TokenKind::superscript) break;
    const Argument argument = script_argument_at(cursor.tokens, cursor.at + 1);
    read(cursor.tokens.subspan(cursor.at, argument.next - cursor.at));
    again = again || (kind == TokenKind::subscript && bounded);
    bounded = bounded || kind == TokenKind::subscript;
    limits = limits || kind == TokenKind::superscript;
    const auto known = std::ranges::find_if(
        regions,
        [written = text_of(argument.content)](const Region& each) { return each.written == written; });
    whole_body = known != std::end(regions);
    if (whole_body) region = known->name;
    cursor.at = argument.next;
  }
  if (cursor.done()) return opaque(token.span, "the integral has no integrand", DiagnosticKind::bad_syntax);
  Measure measure;
  Measure* const outer = std::exchange(measure_, &measure);
  const SyntaxId body = term(cursor);
  measure_ = outer;
  Span span = cover(token.span, tree_[body].span);
  if (measure.span) span = cover(span, *measure.span);
  if (again) return opaque(span, "the integral has two subscripts", DiagnosticKind::bad_syntax);
  if (limits) return opaque(span, "an integral between limits is not read");
  if (!whole_body) return opaque(span, "an integral over a part, a surface or a curve is not read");
  if (measure.count == 0)
    return opaque(span, "the integral does not say over what; `dm`, `dV` and `d^3r` are read");
  if (measure.count > 1) return opaque(span, "two differentials in one integral are not read");
  if (measure.name.empty())
    return opaque(span, fmt::format("an integral over `{}` is not read", measure.text));
  return tree_.add_integral(span, measure.name, body, region);
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
  measure_->name = measure_name(inner(written, place), mark->order);
  read(whole);
  cursor.at = end;
  return true;
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
