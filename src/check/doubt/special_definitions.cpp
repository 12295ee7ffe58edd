// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/doubt/special_definitions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "base/among.h"
#include "base/ascii.h"
#include "check/prose/other_case.h"
#include "check/question/decision_cache.h"
#include "check/word/prose_words.h"

namespace rigor {
namespace {

/// `0`, `-1`, `b`: which value is meant, and not what the letter is.
bool is_value(const ExprTree& tree, ExprId id) {
  while (tree[id].op == Op::negate) id = tree.children(id)[0];
  if (tree[id].op == Op::symbol) return !tree.symbols[tree[id].symbol].derivation;
  return symbols_in(tree, id).empty();
}

/// The words since the last display.
std::vector<std::string_view> words_of_clause(std::string_view lead) {
  const auto display = lead.rfind('\n');
  return words_of(display == std::string_view::npos ? lead : lead.substr(display + 1));
}

/// "If it is thick" below "If the rod is thin", "in electrodynamics" below "in electrostatics", "otherwise".
bool is_another_case(std::string_view earlier, std::string_view lead) {
  static constexpr std::array<std::string_view, 15> opening{"if",    "when", "for",     "in",      "at",
                                                            "near",  "on",   "inside",  "outside", "before",
                                                            "after", "with", "without", "under",   "during"};
  static constexpr std::array<std::string_view, 10> contrasting{
      "otherwise", "else",    "however",   "exactly",   "exact",
      "whereas",   "instead", "generally", "including", "unlike"};
  const std::vector<std::string_view> first = words_of_clause(earlier);
  const std::vector<std::string_view> second = words_of_clause(lead);
  if (first.empty() || second.empty()) return false;
  const bool contrasts =
      std::ranges::any_of(second, [](std::string_view word) { return is_one_of(word, contrasting); });
  const bool opens = first.size() > 1 && is_one_of(first[0], opening);  // a bare "with" names no case
  const bool brings_in = second[0] == "with" && second.size() > 1 && second[1] == "$";  // "with $k = …$"
  return contrasts || (opens && is_one_of(second[0], opening) && !brings_in);
}

}  // namespace

bool is_of_another_case(const ExprTree& tree, const Standpoint& at, const NamedDefinition& named) {
  const Origin& origin = named.origin;
  if (origin.event == at.event) return false;
  const bool anew = is_one_of(named.definition.symbol, at.said_anew);
  if (origin.on_its_line || anew) return true;
  const Prose& prose = at.prose;
  const ProseBeside& said = prose.beside[origin.event];
  const CaseSaid of_case = case_said_at(prose, origin.event, lowered(origin.section));
  if (CasesNamed(prose, at.event, at.heading).names_another_since(of_case, true)) return true;
  if (!prose.sections.reaches(origin.place, at.beside().place))
    return origin.conditional || origin.of_a_case || is_value(tree, named.definition.body) ||
           prose.sections.leaves_an_example(origin.place, at.beside().place);
  return said.sentence != at.beside().sentence && is_another_case(said.lead, at.beside().lead);
}

Judgement heed_cases(ExprTree& tree, const Names& names, const Claim& claim, Judgement judgement,
                     const Standpoint& at, DecisionCache* cache) {
  if (judgement.verdict != Verdict::proved) return judgement;
  std::vector<NamedDefinition> of_others;
  for (const NamedDefinition& named : names.scope.definitions) {
    const bool used = is_one_of(named.origin.text, judgement.uses);
    if (!used || named.origin.directive) continue;
    if (!at.denied && !is_of_another_case(tree, at, named)) continue;
    if (!is_used_here(at, names, named.origin, named.definition.symbol, judgement.used))
      of_others.push_back(named);
  }
  if (of_others.empty()) return judgement;
  Names others = names;
  forget_definitions(others.scope, symbols_of(of_others));
  Judgement without = judge(tree, others, claim, {}, cache);
  judgement.used.insert(without.used.begin(), without.used.end());
  if (without.verdict == Verdict::proved) {
    without.used = std::move(judgement.used);
    return without;
  }
  const NamedDefinition& first = of_others.front();
  judgement.verdict = Verdict::undecided;
  judgement.route.clear();
  judgement.uses.clear();
  judgement.diagnostics = {
      {DiagnosticKind::borrowed,
       claim.relation,
       at.denied
           ? fmt::format("it follows from `{}`, but `{}` in its sentence says that it does not hold",
                         first.origin.text, *at.denied)
           : fmt::format(
                 "it follows from `{}`, which may be meant for another case, or may have been replaced since",
                 first.origin.text),
       {{tree[first.definition.body].span, "said here"}},
       {fmt::format("`rigor: use {}` says that it holds here, too",
                    use_of(names, tree, first.definition.symbol))}}};
  return judgement;
}

}  // namespace rigor
