// SPDX-License-Identifier: GPL-3.0-or-later
// Rows that hang on others: `a = b \Rightarrow c = d`, `H = T + V, \text{ where } T = …`.
#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string>

#include "base/among.h"
#include "check/place/place.h"
#include "check/row/row.h"
#include "check/word/prose_words.h"
#include "check/word/words_behind.h"

namespace rigor {
namespace {

/// "where", "with the abbreviation", "with the reduced mass" after the display: what comes next says what its
/// letters are. "With the solution" says something else.
bool explains_display_above(const ProseBeside& beside) {
  static constexpr std::array<std::string_view, 3> openings{"where", "with", "here"};
  static constexpr std::array<std::string_view, 10> fillers{
      "and",           "as",       "before",     "again",      "the", "abbreviation",
      "abbreviations", "notation", "definition", "definitions"};
  const auto above = beside.lead.rfind('\n');
  if (above == std::string::npos) return false;
  const std::vector<std::string_view> words = words_of(std::string_view(beside.lead).substr(above + 1));
  if (words.empty() || !is_one_of(words.front(), openings)) return false;
  constexpr std::size_t longest = 4;
  if (words.size() <= longest && (is_named_quantity(words.back()) || is_measure(words.back()))) return true;
  return std::ranges::all_of(words.begin() + 1, words.end(), [](std::string_view word) {
    return is_one_of(word, fillers) || is_one_of(word, openings);
  });
}

/// K of `K`, `K^2` and `K(v)`: what a row says of its left side.
std::optional<SyntaxId> name_on_left(const SyntaxTree& syntax, SyntaxId side) {
  const auto is_symbol = [&](SyntaxId id) { return syntax[id].kind == SyntaxKind::symbol; };
  if (is_symbol(side)) return side;
  const auto children = syntax.children(side);
  const bool power = syntax[side].kind == SyntaxKind::power;
  const bool applied = syntax[side].kind == SyntaxKind::term && children.size() == 2 &&
                       children[1].joint == Joint::juxtaposed &&
                       syntax[children[1].id].kind == SyntaxKind::group;
  if ((!power && !applied) || !is_symbol(children[0].id)) return std::nullopt;
  return children[0].id;
}

}  // namespace

bool is_said_to_explain(const RowPlace& place, const ParsedChain& parsed) {
  const ProseBeside& beside = place.notes.prose.beside[place.event];
  return parsed.written.explains || explains_display_above(beside);
}

std::vector<DefinitionBehind> definitions_behind(const RowPlace& place, const ParsedChain& parsed) {
  std::vector<DefinitionBehind> behind;
  const SyntaxTree& syntax = place.notes.syntax;
  const std::set<std::string> letters = letters_written_in(syntax, parsed.sides);
  // "Hence $2E = Mc^2$, $E = \frac12Mc^2$": a conclusion does not follow from what stands behind it.
  const bool concludes = says_that_it_follows(place.notes.prose.beside[place.event].lead);
  const auto uses = [&](const ParsedChain& chain) {
    return !concludes && syntax[chain.sides[0]].kind != SyntaxKind::term &&
           std::ranges::includes(letters, letters_written_in(syntax, {chain.sides[0]}));
  };
  const auto take = [&](const ParsedDisplay& display, bool all, bool own) {
    for (const ParsedChain& chain : display.chains) {
      const bool later = chain.written.span.begin > parsed.written.span.begin;
      const bool names = !chain.written.relations.empty() && is_equality(chain.written.relations[0].kind) &&
                         name_on_left(syntax, chain.sides[0]);
      const bool said = all || chain.written.explains;
      if (later && names && (said || (own && uses(chain)))) behind.push_back({&chain, said});
    }
  };
  const std::vector<ProseBeside>& sentences = place.notes.prose.beside;
  for (std::size_t k = place.event; k < sentences.size(); ++k) {
    const auto* display = std::get_if<ParsedDisplay>(&place.notes.events[k]);
    if (display == nullptr) continue;
    if (sentences[k].sentence != sentences[place.event].sentence) break;
    const bool explains = k > place.event && explains_display_above(sentences[k]);
    if (k > place.event && !explains) break;
    take(*display, explains, k == place.event);
  }
  return behind;
}

std::string unread_premise(RowPlace& place, const ParsedChain& parsed) {
  const auto* display = std::get_if<ParsedDisplay>(&place.notes.events[place.event]);
  if (display == nullptr || parsed.written.inference == Inference::none) return {};
  for (const ParsedChain& chain : display->chains) {
    const bool before = chain.written.statement == parsed.written.statement &&
                        chain.written.span.begin < parsed.written.span.begin;
    if (!before) continue;
    const auto reading = read_here(place, chain);
    const bool read =
        std::ranges::all_of(reading->sides, [](const Side& side) { return side.typed.has_value(); }) &&
        std::ranges::all_of(chain.written.relations, [](const WrittenRelation& relation) {
          return is_equality(relation.kind) || is_order(relation.kind);
        });
    if (!read || chain.written.relations.empty()) return written_at(place, chain.written.span);
  }
  return {};
}

}  // namespace rigor
