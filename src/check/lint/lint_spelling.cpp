// SPDX-License-Identifier: GPL-3.0-or-later
// One symbol with two spellings: `\varepsilon_{ijk}` here and `\epsilon_{ijk}` there. Where the two signs
// carry different subscripts they are different symbols.
#include <fmt/format.h>

#include <array>
#include <map>
#include <set>

#include "check/event/written_statements.h"
#include "check/lint/lint.h"
#include "elaborate/name/letters.h"

namespace rigor {
namespace {

/// The ε as it is written, and the other one; nothing where a macro stands for it.
std::string_view look_of(std::string_view written) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 4> looks{
      {{"\\epsilon", "\\epsilon"},
       {"ϵ", "\\epsilon"},
       {"\\varepsilon", "\\varepsilon"},
       {"ε", "\\varepsilon"}}};
  for (const auto& [text, look] : looks) {
    if (written == text) return look;
  }
  return {};
}

/// What tells one ε from another.
std::string spelling_of(const WrittenSymbol& symbol) {
  if (is_levi_civita(symbol)) return "symbol of three indices";
  return with_labels(fmt::format("{}{}{}", static_cast<int>(symbol.face), static_cast<int>(symbol.accent),
                                 std::string(symbol.primes, '\'')),
                     symbol.lower);
}

struct Spelling {
  std::string_view look;
  Span place;
};

}  // namespace

Findings lint_spelling(const LintInput& input) {
  const SyntaxTree& syntax = input.notes.syntax;
  std::map<std::string, Spelling> first;
  std::set<std::string> said;
  Findings findings;
  for (const WrittenStatement& statement : statements_in(input.notes)) {
    if (!statement.displayed) continue;
    for (const SyntaxId id : nodes_below(syntax, statement.chain->sides)) {
      if (syntax[id].kind != SyntaxKind::symbol || syntax.symbol(id).letter != "\\epsilon") continue;
      const WrittenSymbol& symbol = syntax.symbol(id);
      const std::string_view look = look_of(input.sources.text(symbol.letter_span));
      if (look.empty()) continue;
      const std::string name = spelling_of(symbol);
      const auto [known, fresh] = first.try_emplace(name, Spelling{look, symbol.letter_span});
      if (fresh || known->second.look == look || !said.insert(name).second) continue;
      findings.push_back({{DiagnosticKind::mixed_spelling,
                           symbol.letter_span,
                           fmt::format("`{}` is read as the same symbol as `{}`", look, known->second.look),
                           {{known->second.place, fmt::format("`{}` is written here", known->second.look)}},
                           {"write one of them throughout"}}});
    }
  }
  return findings;
}

}  // namespace rigor
