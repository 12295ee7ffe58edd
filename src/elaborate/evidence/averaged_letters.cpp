// SPDX-License-Identifier: GPL-3.0-or-later
// What is averaged changes from outcome to outcome, and nothing in `\langle ax\rangle` says whether a does. A
// letter that is averaged alone somewhere does, and one that the words call random. Any other letter that
// stands outside of all brackets beside an average does not: nobody writes an outcome there.
#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "base/among.h"
#include "base/ascii.h"
#include "elaborate/evidence/evidence.h"

namespace rigor {
namespace {

bool is_function_called(const SyntaxTree& syntax, SyntaxId id, std::string_view name) {
  return syntax[id].kind == SyntaxKind::function && syntax.text(id) == name;
}

/// A bar over an expression can be one.
bool is_written_average(const SyntaxTree& syntax, SyntaxId id) {
  return is_function_called(syntax, id, "average") || is_function_called(syntax, id, "bar");
}

/// Their letters may be bound, or belong to a distribution.
bool hides_letters(SyntaxKind kind) {
  return kind == SyntaxKind::line_integral || kind == SyntaxKind::integral || kind == SyntaxKind::between ||
         kind == SyntaxKind::big_sum || kind == SyntaxKind::derivative;
}

/// `\hat A`: no unit vector is called so.
bool is_hatted_capital(const SyntaxTree& syntax, SyntaxId id) {
  return syntax[id].kind == SyntaxKind::symbol && syntax.symbol(id).accent == Accent::hat &&
         is_capital_letter(syntax.symbol(id).letter);
}

/// Without what stands in (further) averages. Recursion: as deep as the tree.
void collect_letters(const SyntaxTree& syntax, SyntaxId id, bool all, std::set<std::string>& letters) {
  if (is_written_average(syntax, id) || (!all && hides_letters(syntax[id].kind))) return;
  if (syntax[id].kind == SyntaxKind::symbol) {
    const WrittenSymbol& symbol = syntax.symbol(id);
    if (!is_same_for_all_outcomes(complex_name(symbol))) letters.insert(complex_name(symbol));
    return;
  }
  for (const SyntaxChild& child : syntax.children(id)) collect_letters(syntax, child.id, all, letters);
}

/// The letters of the formulas in a stretch of prose: `$X$`, `$X_i, Y$`.
void add_formulas(std::string_view text, std::set<std::string>& letters) {
  for (std::size_t open = text.find('$'); open != std::string_view::npos;) {
    const std::size_t close = text.find('$', open + 1);
    if (close == std::string_view::npos) return;
    const std::string_view formula = text.substr(open + 1, close - open - 1);
    for (std::size_t at = 0; at < formula.size(); ++at) {
      std::size_t end = at + 1;
      if (formula[at] == '_' || formula[at] == '^' || formula[at] == '(') break;
      if (formula[at] == '\\') {
        while (end < formula.size() && is_letter(formula[end])) ++end;
      } else if (!is_letter(formula[at])) {
        continue;
      }
      letters.insert(std::string(formula.substr(at, end - at)));
      at = end - 1;
    }
    open = text.find('$', close + 1);
  }
}

bool has_any(std::string_view text, std::span<const std::string_view> words) {
  return std::ranges::any_of(
      words, [&](std::string_view word) { return text.find(word) != std::string_view::npos; });
}

}  // namespace

bool is_same_for_all_outcomes(std::string_view name) {
  static constexpr auto constants = std::to_array<std::string_view>(
      {"\\pi", "\\hbar", "\\hslash", "e", "i", "\\mathrm{i}", "\\mathrm{e}", "k_{B}", "k_{\\text{B}}"});
  return is_one_of(name, constants);
}

void see_averages(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Evidence& evidence) {
  bool any = false;
  for (const SyntaxId id : nodes_below(syntax, sides)) {
    if (is_function_called(syntax, id, "adjoint")) {
      for (const SyntaxId inside : nodes_below(syntax, {syntax.child(id, 0)})) {
        if (syntax[inside].kind == SyntaxKind::symbol)
          evidence.daggered.insert(letter_with_marks(syntax.symbol(inside)));
      }
    }
    if (!is_written_average(syntax, id)) continue;
    any = true;
    for (const SyntaxId each : nodes_below(syntax, {id}))
      evidence.operators = evidence.operators || is_hatted_capital(syntax, each);
    std::set<std::string> inside;
    collect_letters(syntax, syntax.child(id, 0), true, inside);
    if (inside.size() == 1) evidence.averaged.insert(*inside.begin());
  }
  if (!any) return;
  for (const SyntaxId side : sides) collect_letters(syntax, side, false, evidence.beside_averages);
}

void see_said_averages(std::string_view text, Evidence& evidence) {
  static constexpr auto means = std::to_array<std::string_view>(
      {"average", "averaging", "mean value", "the mean", "expectation", "expected value"});
  static constexpr auto generated = std::to_array<std::string_view>(
      {"ideal generated", "group generated", "subgroup", "cyclic group", "principal ideal"});
  const std::string lower = lowered(text);
  evidence.speaks_of_means |= has_any(lower, means);
  evidence.angles_generate |= has_any(lower, generated);
  for (const std::string_view word : {"random", "stochastic", "fluctuating"}) {
    for (std::size_t at = lower.find(word); at != std::string::npos; at = lower.find(word, at + 1)) {
      const std::size_t end = std::min({lower.find(". ", at), lower.find(".\n", at), lower.find(" with ", at),
                                        lower.find(" of ", at), lower.find(" whose", at), lower.size()});
      add_formulas(text.substr(at, end - at), evidence.averaged);
    }
  }
}

}  // namespace rigor
