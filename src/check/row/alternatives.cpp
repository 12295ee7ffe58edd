// SPDX-License-Identifier: GPL-3.0-or-later
// `a = 0 or b = 0`: one of the equations holds wherever the product of their differences is 0. Each row by
// itself is neither proved nor refuted.

#include "check/row/row.h"

#include <algorithm>

#include "base/ascii.h"
#include "check/place/place.h"

namespace rigor {
namespace {

/// Does "or" occur there, and no other word?
bool says_or_alone(std::string_view text) {
  bool found = false;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == '\\') {  // a control is no word
      ++at;
      while (at < text.size() && is_letter(text[at])) ++at;
      continue;
    }
    std::size_t end = at;
    while (end < text.size() && is_letter(text[end])) ++end;
    const std::string_view word = text.substr(at, end - at);
    if (!word.empty() && word != "or" && word != "else") return false;
    found = found || word == "or";
    at = std::max(end, at + 1);
  }
  return found;
}

/// The alternatives that the chain is one of, in order; empty if something else is between them, or one
/// of them is a chain of several steps or not an equation.
std::vector<const ParsedChain*> alternatives_with(const RowPlace& place, const ParsedChain& parsed) {
  std::vector<const ParsedChain*> all;
  const auto* display = std::get_if<ParsedDisplay>(&place.notes.events[place.event]);
  if (display == nullptr) return all;
  bool own = false;
  for (const ParsedChain& chain : display->chains) {
    if (chain.written.statement != parsed.written.statement || chain.image != parsed.image) continue;
    const bool equation = chain.written.relations.size() == 1 && chain.others.empty() &&
                          chain.written.relations[0].kind == RelationKind::equal && !chain.written.condition;
    if (!equation) return {};
    if (!all.empty()) {
      const Span before = all.back()->written.span;
      const Span here = chain.written.span;
      const bool apart = before.file == here.file && before.end < here.begin;
      if (!apart || !says_or_alone(place.sources.text({here.file, before.end, here.begin}))) return {};
    }
    own = own || chain.written.span == parsed.written.span;
    all.push_back(&chain);
  }
  if (!own || all.size() < 2) all.clear();
  return all;
}

}  // namespace

bool proves_alternatives(RowPlace& place, const ParsedChain& parsed, Step& step) {
  if (!is_alternative(place, parsed)) return false;
  std::vector<std::unique_ptr<ChainReading>> readings;
  std::vector<ExprId> differences;
  const Span span = parsed.written.span;
  for (const ParsedChain* chain : alternatives_with(place, parsed)) {
    readings.push_back(read_here(place, *chain));
    ChainReading& reading = *readings.back();
    if (!reading.sides[0].typed || !reading.sides[1].typed) return false;
    Diagnostics ignored;
    const auto claim = reading.claim(*chain, 0, false, ignored);
    if (!claim || place.tree[claim->equation.left].rank > 0 || !claim->equation.indices.empty() ||
        !claim->equation.particles.empty() || has_operators(place.tree, claim->equation.left) ||
        has_operators(place.tree, claim->equation.right))
      return false;  // a product of operators can vanish without its factors
    const ExprId right = claim->equation.right;
    const ExprId terms[] = {claim->equation.left,
                            place.tree.add({.op = Op::negate, .span = span}, std::span(&right, 1))};
    differences.push_back(place.tree.is_zero_literal(right)
                              ? claim->equation.left
                              : place.tree.add({.op = Op::add, .span = span}, terms));
  }
  if (differences.empty()) return false;
  Claim product;
  product.equation.left = place.tree.add({.op = Op::multiply, .span = span}, differences);
  product.equation.right = place.tree.add_number(span, "0");
  product.relation = step.relation_span;
  product.left = product.right = span;
  product.reading = &readings.front()->reading();
  Judgement judgement = judge_here(place, product);
  if (judgement.verdict != Verdict::proved) return false;
  judgement.route = "one of the alternatives holds: the product of their differences is 0";
  judgement.diagnostics.clear();
  accept(std::move(judgement), step);
  return true;
}

}  // namespace rigor
