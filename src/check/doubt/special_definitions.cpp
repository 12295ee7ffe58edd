// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/doubt/special_definitions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "base/among.h"
#include "base/ascii.h"
#include "check/prose/other_case.h"
#include "check/question/decision_cache.h"
#include "check/word/contrary_words.h"
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
  const bool lists = first[0] == "with" && std::ranges::any_of(first, [](std::string_view word) {
                       return is_one_of(word, {"root", "roots", "solutions", "zeros", "eigenvalues"});
                     });
  // A bare "with" names no case, nor does "with the two roots".
  const bool opens = first.size() > 1 && is_one_of(first[0], opening) && !lists;
  const bool brings_in = second[0] == "with" && second.size() > 1 && second[1] == "$";  // "with $k = …$"
  return contrasts || (opens && is_one_of(second[0], opening) && !brings_in);
}

/// A number, or another letter; not a component or an integral, which only get a name.
bool is_plain_value(const ExprTree& tree, ExprId id) {
  while (tree[id].op == Op::negate) id = tree.children(id)[0];
  const ExprNode& node = tree[id];
  if (node.rank > 0) return false;
  if (node.op != Op::symbol) return symbols_in(tree, id).empty();
  const Symbol& symbol = tree.symbols[node.symbol];
  return node.slot_count == 0 && !symbol.derivation && !symbol.integral && !symbol.is_fixed();
}

/// Those behind the first place, up to that of the second; they have increasing numbers.
std::span<const ProseSentence> sentences_between(const Prose& prose, const ProseBeside& earlier,
                                                 const ProseBeside& here) {
  const auto behind = [&](std::size_t number) {
    return std::ranges::upper_bound(prose.sentences, number, {}, &ProseSentence::number);
  };
  if (here.sentence <= earlier.sentence) return {};
  return {behind(earlier.sentence), behind(here.sentence)};
}

/// Does a paragraph with words of its own begin in between? "A ball is dropped, so that $v_0 = 0$. / A ball
/// that is thrown has".
bool begins_anew(const Prose& prose, const ProseBeside& earlier, const ProseBeside& here) {
  return here.argument > earlier.argument &&
         std::ranges::any_of(sentences_between(prose, earlier, here),
                             [](const ProseSentence& sentence) { return has_own_words(sentence.text); });
}

/// "while a thrown ball has": a clause between the two displays, or before the second.
bool turns_to_another_thing(const ProseBeside& said, const ProseBeside& here) {
  std::string_view rest = here.lead;
  if (said.sentence == here.sentence) rest.remove_prefix(std::min(said.lead.size(), rest.size()));
  for (; !rest.empty(); rest.remove_suffix(rest.size() - rest.rfind('\n'))) {
    if (names_another_thing(rest)) return true;
    if (rest.rfind('\n') == std::string_view::npos) break;
  }
  return false;
}

/// "We choose units in which", "from now on": a value that holds on, and is no case.
bool is_said_for_all_below(std::string_view lead) {
  static constexpr auto words = std::to_array<std::string_view>(
      {"unit", "units", "choose", "chosen", "convention", "throughout", "everywhere", "always", "now",
       "denote", "write", "abbreviate", "constant", "constants"});
  return std::ranges::any_of(words_of_clause(lead),
                             [](std::string_view word) { return is_one_of(word, words); });
}

bool is_said_as_example(std::string_view lead) {
  return std::ranges::any_of(words_of_clause(lead), [](std::string_view word) {
    return is_one_of(word, {"example", "instance", "eg"});
  });
}

/// "In ordinary units", "restoring $c$" below "we choose units with $c = 1$".
bool names_other_units(const Prose& prose, const ProseBeside& said, const ProseBeside& here) {
  const auto speaks_of = [](std::string_view text, std::initializer_list<std::string_view> these) {
    return std::ranges::any_of(words_of(text), [&](std::string_view word) { return is_one_of(word, these); });
  };
  if (!speaks_of(said.lead, {"units"})) return false;
  return std::ranges::any_of(sentences_between(prose, said, here), [&](const ProseSentence& sentence) {
    return speaks_of(lowered(sentence.text),
                     {"units", "si", "restoring", "restore", "restored", "reinstating"});
  });
}

}  // namespace

bool is_case_of_another_paragraph(const ExprTree& tree, const Standpoint& at, const NamedDefinition& named) {
  const ProseBeside& said = at.prose.beside[named.origin.event];
  const ProseBeside& here = at.beside();
  if (named.origin.directive || named.origin.event == at.event) return false;
  const bool value = is_plain_value(tree, named.definition.body);  // few are, and words are dear to read
  if (value && names_other_units(at.prose, said, here)) return true;
  const bool as_case = value && !is_said_for_all_below(said.lead);
  const bool ends = (as_case && turns_to_another_thing(said, here)) ||
                    (begins_anew(at.prose, said, here) && (as_case || is_said_as_example(said.lead)));
  return ends && !names_the_same_owner(lowered(said.lead), lowered(here.lead));
}

bool is_of_another_case(const ExprTree& tree, const Standpoint& at, const NamedDefinition& named) {
  const Origin& origin = named.origin;
  if (origin.event == at.event) return false;
  const bool anew = is_one_of(named.definition.symbol, at.said_anew);
  if ((origin.on_its_line && !origin.only_counts) || anew) return true;
  const Prose& prose = at.prose;
  const ProseBeside& said = prose.beside[origin.event];
  const CaseSaid of_case = case_said_at(prose, origin.event, lowered(origin.section));
  if (CasesNamed(prose, at.event, at.heading).names_another_since(of_case, true)) return true;
  if (!prose.sections.reaches(origin.place, at.beside().place))
    return origin.conditional || origin.of_a_case || is_value(tree, named.definition.body) ||
           prose.sections.leaves_an_example(origin.place, at.beside().place);
  if (is_case_of_another_paragraph(tree, at, named)) return true;
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
