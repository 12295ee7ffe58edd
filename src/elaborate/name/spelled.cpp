// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/name/spelled.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "base/among.h"
#include "base/ascii.h"
#include "elaborate/name/letters.h"

namespace rigor {
namespace {

/// What acts on all that is after it, with or without a bracket.
constexpr std::array<std::string_view, 22> acting{
    "det", "div", "rot", "grad", "curl", "rank", "sin",  "cos", "tan", "cot",    "log",
    "exp", "lim", "sgn", "arg",  "ker",  "cov",  "sinh", "erf", "Div", "arctan", "tanh"};
/// Words that are products as often, `W = max`: with something after them.
constexpr std::array<std::string_view, 21> words{"Tr",  "tr",   "Re",   "Im",  "ln",  "lg",  "Pr",
                                                 "max", "min",  "sup",  "inf", "Var", "var", "Cov",
                                                 "dim", "span", "diag", "mod", "Res", "gcd", "cosh"};

SyntaxId base_of(const SyntaxTree& syntax, SyntaxId id) {
  return syntax[id].kind == SyntaxKind::power ? syntax.child(id, 0) : id;
}

/// A plain Latin letter; scripts may be on it.
const WrittenSymbol* plain_letter(const SyntaxTree& syntax, SyntaxId id) {
  const SyntaxId base = base_of(syntax, id);
  if (syntax[base].kind != SyntaxKind::symbol) return nullptr;
  const WrittenSymbol& symbol = syntax.symbol(base);
  const bool letter = symbol.letter.size() == 1 && is_undecorated(symbol);
  return letter ? &symbol : nullptr;
}

bool is_declared(const Names& names, const std::string& letter) {
  return is_declared(names.symbols, {letter, 0, false}) || is_declared(names.symbols, {letter, 1, false}) ||
         is_declared(names.symbols, {letter, 2, false});
}

/// Letters side by side without a blank.
struct Run {
  std::string word;
  std::size_t end;  // the factor after it
  bool declared;    // each of its letters is
  bool scripts;     // on its last letter
};

Run run_at(const SyntaxTree& syntax, std::span<const SyntaxChild> factors, std::size_t at,
           const Names& names) {
  Run run{{}, at, true, false};
  while (run.end < factors.size() && !run.scripts) {
    const SyntaxId id = factors[run.end].id;
    const WrittenSymbol* symbol = plain_letter(syntax, id);
    if (symbol == nullptr) break;
    if (run.end > at) {
      const Span before = syntax[factors[run.end - 1].id].span;
      const bool beside = factors[run.end].joint == Joint::juxtaposed && before.end == syntax[id].span.begin;
      if (!beside || before.file != syntax[id].span.file) break;
    }
    run.word += symbol->letter;
    run.declared = run.declared && is_declared(names, symbol->letter);
    run.scripts = !symbol->lower.empty() || syntax[id].kind == SyntaxKind::power;
    ++run.end;
  }
  return run;
}

Span span_between(const SyntaxTree& syntax, std::span<const SyntaxChild> factors, std::size_t begin,
                  std::size_t end) {
  return cover(syntax[factors[begin].id].span, syntax[factors[end - 1].id].span);
}

/// The word that a run is, ends with before a bracket, or begins with before a letter or two: `Tr`, `zIm(w)`,
/// `rotA`.
std::string word_in(const Run& run, bool something_behind, bool bracket_behind) {
  if (run.word == "KE") return run.word;
  if (something_behind && (is_one_of(run.word, acting) || is_one_of(run.word, words))) return run.word;
  for (std::size_t length = 2; length < run.word.size(); ++length) {
    const std::string last = run.word.substr(run.word.size() - length);
    if (bracket_behind && (is_one_of(last, acting) || is_one_of(last, words))) return last;
    const std::string first = run.word.substr(0, length);
    if (length + 2 >= run.word.size() && is_one_of(first, acting)) return first;
  }
  return {};
}

/// `AB` where a triangle `ABC` is spoken of, or one whose corners have the usual names.
bool is_segment(const std::string& word, const Evidence& evidence) {
  if (!evidence.speaks_of_segments) return false;
  static constexpr std::string_view usual = "ABCDEFGHOPQRS";
  return std::ranges::all_of(word, [&](char c) {
    return evidence.points.empty() ? usual.find(c) != std::string_view::npos
                                   : evidence.points.contains(std::string(1, c));
  });
}

/// `f`, `g\psi`, `f + g`: letters that usually are functions, and nothing else.
bool holds_functions(const SyntaxTree& syntax, SyntaxId group) {
  static constexpr std::array<std::string_view, 8> functions{"f",        "g",     "h",     "\\psi",
                                                             "\\varphi", "\\phi", "\\chi", "\\Psi"};
  for (const SyntaxId id : nodes_below(syntax, {group})) {
    const SyntaxKind kind = syntax[id].kind;
    if (kind == SyntaxKind::symbol && !is_one_of(syntax.symbol(id).letter, functions)) return false;
    if (kind == SyntaxKind::function || kind == SyntaxKind::number) return false;
  }
  return true;
}

/// A letter that may act on the bracket after it.
bool may_act(const SyntaxTree& syntax, const WrittenSymbol& symbol, SyntaxId bracket, const Names& names) {
  if (symbol.face != Face::plain || is_declared(names, symbol.letter)) return false;
  const bool script = symbol.letter.starts_with("\\mathcal{") || symbol.letter.starts_with("\\mathscr{") ||
                      symbol.letter.starts_with("\\mathbb{");
  if (script || names.symbols.evidence->functionals.contains(symbol.letter)) return true;
  return is_capital_letter(symbol.letter) && symbol.lower.empty() && holds_functions(syntax, bracket);
}

}  // namespace

std::optional<SpelledPart> spelled_part(const SyntaxTree& syntax, std::span<const SyntaxChild> factors,
                                        const Names& names) {
  for (std::size_t k = 0; k < factors.size();) {
    const Run run = run_at(syntax, factors, k, names);
    const bool behind = run.end < factors.size() && factors[run.end].joint == Joint::juxtaposed;
    const bool bracket = behind && syntax[base_of(syntax, factors[run.end].id)].kind == SyntaxKind::group;
    const bool several = run.end > k + 1;
    const std::string word = several && !run.declared ? word_in(run, behind, bracket) : std::string{};
    if (!word.empty()) {
      return SpelledPart{span_between(syntax, factors, k, run.end),
                         fmt::format("`{}` can be a word or a product of letters", word),
                         {"`\\operatorname{…}` makes it a word, and `rigor: scalar …` its letters factors"}};
    }
    const bool segment = several && !run.declared && is_segment(run.word, *names.symbols.evidence);
    if (segment) {
      return SpelledPart{span_between(syntax, factors, k, run.end),
                         fmt::format("`{}` can be the name of a segment or a product of letters", run.word),
                         {"`rigor: scalar …` makes its letters factors"}};
    }
    const SyntaxId last = factors[std::max(run.end, k + 1) - 1].id;
    const std::size_t next = std::max(run.end, k + 1);
    if (next < factors.size() && factors[next].joint == Joint::juxtaposed &&
        syntax[last].kind == SyntaxKind::symbol) {
      const SyntaxId bracket_id = base_of(syntax, factors[next].id);
      const bool is_group = syntax[bracket_id].kind == SyntaxKind::group;
      if (is_group && may_act(syntax, syntax.symbol(last), bracket_id, names)) {
        return SpelledPart{
            cover(syntax[last].span, syntax[factors[next].id].span),
            fmt::format("`{}` can act on the bracket after it, or be a factor", syntax.symbol(last).letter),
            {fmt::format("`rigor: scalar {}` makes it a factor", syntax.symbol(last).letter)}};
      }
    }
    k = next;
  }
  return std::nullopt;
}

}  // namespace rigor
