// SPDX-License-Identifier: GPL-3.0-or-later
// Differentials by themselves, `dU = T\,dS - p\,dV`: where a `d` can be the sign of one, and where it is a
// letter.
#include <algorithm>
#include <set>

#include "elaborate/evidence/evidence.h"
#include "expr/tree/path.h"

namespace rigor {
namespace {

bool is_unmarked_sign(const WrittenSymbol& symbol) {
  return symbol.face == Face::plain && symbol.accent == Accent::none && symbol.primes == 0 &&
         symbol.dots == 0 && symbol.lower.empty() && symbol.change.empty();
}

bool is_sign(const SyntaxTree& syntax, SyntaxId id, std::string_view letter) {
  return syntax[id].kind == SyntaxKind::symbol && syntax.symbol(id).letter == letter &&
         is_unmarked_sign(syntax.symbol(id));
}

/// A letter, a bracket, a logarithm: what stands behind a `d`.
bool can_be_differentiated(const SyntaxTree& syntax, SyntaxId id) {
  const SyntaxKind kind = syntax[id].kind;
  const bool logarithm =
      kind == SyntaxKind::function && (syntax.text(id) == "ln" || syntax.text(id) == "log");
  return kind == SyntaxKind::symbol || kind == SyntaxKind::group || logarithm;
}

/// How many differentials are factors of it; nothing where one stands in another place.
std::optional<int> count_in(const SyntaxTree& syntax, SyntaxId id);

/// The same for all terms; a written 0 says nothing.
std::optional<int> count_in_sum(const SyntaxTree& syntax, SyntaxId sum) {
  std::optional<int> all;
  for (const SyntaxChild& term : syntax.children(sum)) {
    const auto own = count_in(syntax, term.id);
    if (!own || (all && *all != *own)) return std::nullopt;
    all = own;
  }
  return all;
}

std::optional<int> count_in_term(const SyntaxTree& syntax, SyntaxId term) {
  const std::span<const SyntaxChild> factors = syntax.children(term);
  int all = 0;
  for (std::size_t k = 0; k < factors.size(); ++k) {
    const bool sign = is_sign_of_differential(syntax, factors, k) || is_sign_of_form(syntax, factors, k);
    const auto own = sign ? std::optional(1) : count_in(syntax, factors[k].id);
    if (!own || (*own > 0 && factors[k].joint == Joint::slash)) return std::nullopt;
    all += *own;
    if (sign) ++k;
  }
  return all;
}

std::optional<int> count_in(const SyntaxTree& syntax, SyntaxId id) {
  switch (syntax[id].kind) {
    case SyntaxKind::sum:
      return count_in_sum(syntax, id);
    case SyntaxKind::term:
      return count_in_term(syntax, id);
    case SyntaxKind::group:
      return syntax[id].count == 1 ? count_in(syntax, syntax.child(id, 0)) : std::nullopt;
    case SyntaxKind::fraction: {
      const auto below = count_in(syntax, syntax.child(id, 1));
      return below == 0 ? count_in(syntax, syntax.child(id, 0)) : std::nullopt;
    }
    case SyntaxKind::symbol:
      return syntax.symbol(id).change == "\\delta" ? 1 : 0;
    default:
      break;
  }
  if (is_lone_differential(syntax, id)) return 1;
  const auto is_one = [&](SyntaxId each) { return is_lone_differential(syntax, each); };
  if (std::ranges::any_of(nodes_below(syntax, {id}), is_one)) return std::nullopt;
  return 0;
}

bool is_written_zero(const SyntaxTree& syntax, SyntaxId id) {
  return syntax[id].kind == SyntaxKind::number && syntax.text(id) == "0";
}

}  // namespace

bool is_lone_differential(const SyntaxTree& syntax, SyntaxId id) {
  return syntax[id].kind == SyntaxKind::derivative && syntax.derivative(id).by.empty();
}

bool is_sign_of_differential(const SyntaxTree& syntax, std::span<const SyntaxChild> factors, std::size_t at) {
  return at + 1 < factors.size() && is_sign(syntax, factors[at].id, "d") &&
         factors[at + 1].joint == Joint::juxtaposed && can_be_differentiated(syntax, factors[at + 1].id);
}

bool is_sign_of_form(const SyntaxTree& syntax, std::span<const SyntaxChild> factors, std::size_t at) {
  return at + 1 < factors.size() && is_sign(syntax, factors[at].id, "\\delta") &&
         factors[at + 1].joint == Joint::juxtaposed && syntax[factors[at + 1].id].kind == SyntaxKind::symbol;
}

bool relates_differentials(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides) {
  bool any = false;
  for (const SyntaxId side : sides) {
    if (is_written_zero(syntax, side)) continue;
    if (count_in(syntax, side) != 1) return false;
    any = true;
  }
  return any && sides.size() > 1;
}

void see_differentials(const SyntaxTree& syntax, SyntaxId root, Evidence& evidence) {
  std::set<SyntaxId> signs;
  const auto see_below = [&](SyntaxId operand) {
    for (const SyntaxId id : nodes_below(syntax, {operand})) {
      if (syntax[id].kind != SyntaxKind::symbol) continue;
      const std::string name = changing_name(syntax.symbol(id));
      evidence.by[std::string(path_parameter)].insert(name);
      evidence.changing.insert(name);
    }
  };
  for (const SyntaxId id : nodes_below(syntax, {root})) {
    if (is_lone_differential(syntax, id)) see_below(syntax.child(id, 0));
    if (syntax[id].kind == SyntaxKind::term) {
      const std::span<const SyntaxChild> factors = syntax.children(id);
      for (std::size_t k = 0; k + 1 < factors.size(); ++k) {
        const bool power = syntax[factors[k + 1].id].kind == SyntaxKind::power;  // `ds^2`
        if (power && factors[k + 1].joint == Joint::juxtaposed) signs.insert(factors[k].id);
        if (!is_sign_of_differential(syntax, factors, k)) continue;
        signs.insert(factors[k].id);
        see_below(factors[k + 1].id);
      }
    }
    if (is_sign(syntax, id, "d") && !signs.contains(id)) evidence.d_is_a_letter = true;
  }
}

}  // namespace rigor
