// SPDX-License-Identifier: GPL-3.0-or-later
// What follows from the laws above a row, or would with one slip of the pen taken back.
#include "check/row/row.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "base/among.h"
#include "base/ascii.h"
#include "check/doubt/equation_of_letters.h"
#include "check/law/from_laws.h"
#include "check/law/observables.h"
#include "check/place/place.h"
#include "check/prose/restrictions.h"
#include "check/prose/said_around.h"
#include "check/question/base_letters.h"
#include "check/repair/sides_near.h"
#include "check/repair/suspicion.h"
#include "check/verdict/law_diagnostic.h"
#include "check/word/prose_words.h"

namespace rigor {
namespace {

bool is_open(const PageLaw& law) { return law.standing == Standing::conclusion; }

void leave(RowPlace& place, const StepReading& row, const Claim& claim, Standing standing) {
  if (!claim.nearly) leave_to_rows_below(place, row.parsed, claim.equation, claim.relation, standing);
}

/// Laws of this section and those around it, but no conclusion that follows from nothing: that may be wrong
/// itself. What another section states makes nothing suspect: "The other end is now held by
/// a hinge."
Laws grounds_for_suspicion(const RowPlace& place, Laws laws) {
  const ProseBeside& here = beside(place);
  std::erase_if(laws, [&](const PageLaw* law) {
    return is_open(*law) || law->at_instant || !place.notes.prose.sections.reaches(law->place, here.place);
  });
  return laws;
}

Laws without_cases(Laws laws) {
  std::erase_if(laws, [](const PageLaw* law) { return law->of_a_case; });
  return laws;
}

/// "In an incompressible fluid, this reduces to", "For the second wire": a sentence that begins by saying of
/// what it speaks. "For this", "In general" and "With (3)" say nothing of the kind.
bool begins_with_a_case(std::string_view lead) {
  static constexpr auto openings = std::to_array<std::string_view>({"in", "for", "at", "on", "as", "near"});
  static constexpr auto neutral = std::to_array<std::string_view>(
      {"this", "that",    "the",  "these", "general",    "fact",   "particular", "all",
       "any",  "every",   "each", "terms", "components", "index",  "other",      "words",
       "both", "numbers", "our",  "its",   "which",      "before", "above"});
  const std::string text = lowered(lead);
  const std::vector<std::string_view> words = words_of(text);
  for (std::size_t k = 0; k + 1 < words.size() && k < 3; ++k) {
    if (!is_one_of(words[k], openings)) continue;
    if (!is_one_of(words[k + 1], neutral)) return true;
  }
  return false;
}

/// Does it rest on definitions that are said for this place only, and not on one of its own chain?
bool rests_on_what_is_said_here(RowPlace& place, const StepReading& row,
                                const std::vector<std::string>& uses) {
  const Standpoint at = standpoint(place, row.parsed);
  const Span chain = row.parsed.written.span;
  return std::ranges::all_of(*place.names.scope.definitions, [&](const NamedDefinition& named) {
    const bool used = std::ranges::find(uses, named.origin.text) != uses.end();
    if (!used || named.origin.directive) return true;
    const ExprNode& body = place.tree[named.definition.body];
    const bool own =
        body.span.file == chain.file && body.span.begin >= chain.begin && body.span.end <= chain.end;
    const bool condition = body.op == Op::symbol;  // `P_i = P_f`
    return !own && !condition && is_said_for(at, named.origin);
  });
}

/// The names without definitions that are said for other places.
Names as_said_here(RowPlace& place, const StepReading& row) {
  const Standpoint at = standpoint(place, row.parsed);
  Names here = place.names;
  for (const NamedDefinition& named : *place.names.scope.definitions) {
    if (!named.origin.directive && !is_said_for(at, named.origin))
      forget_definition(here.scope, named.definition.symbol);
  }
  return here;
}

/// It would follow from a conclusion that follows from nothing itself.
Judgement follows_from_open(const Laws& available, const Claim& claim, Judgement judgement) {
  const auto open = std::ranges::find_if(available, [&](const PageLaw* law) {
    return is_open(*law) && std::ranges::find(judgement.uses, law->name) != judgement.uses.end();
  });
  if (open == available.end()) return judgement;
  Judgement undecided;
  undecided.verdict = Verdict::undecided;
  undecided.uses = std::move(judgement.uses);
  undecided.used = std::move(judgement.used);
  undecided.diagnostics = {
      {DiagnosticKind::follows_from_nothing,
       claim.relation,
       fmt::format("it follows from `{}`, of which no proof was found", (*open)->name),
       {{(*open)->span, "not proved here"}},
       {"what that follows from can stand above it, as an equation or as `rigor: given …`"}}};
  return undecided;
}

/// As a conclusion: by its words, behind an arrow, or as a later link of a chain.
bool is_announced(const RowPlace& place, const StepReading& row) {
  return row.which > 0 || row.parsed.written.inference != Inference::none ||
         says_that_it_follows(beside(place).lead);
}

/// "They are not Hermitian": then no commutator makes an operator of the section self-adjoint.
bool denies_self_adjoint_operators(const RowPlace& place) {
  return std::ranges::any_of(place.notes.prose.sentences, [&](const ProseSentence& sentence) {
    if (!place.notes.prose.sections.reaches(sentence.place, beside(place).place)) return false;
    const std::string text = lowered(sentence.text);
    if (text.find("complex scalar field") != std::string::npos ||
        text.find("complex field") != std::string::npos)
      return true;
    const std::vector<std::string_view> words = words_of(text);
    const auto has = [&](std::initializer_list<std::string_view> these) {
      return std::ranges::any_of(words, [&](std::string_view word) { return is_one_of(word, these); });
    };
    if (has({"non-hermitian", "nonhermitian", "non-self-adjoint", "anti-hermitian", "skew-hermitian"}))
      return true;
    return has({"hermitian", "self-adjoint", "observable", "observables"}) &&
           has({"not", "no", "never", "neither", "if", "any", "general", "whether"});
  });
}

/// `D^\dagger = D + i`
bool says_an_adjoint(const ExprTree& tree, const Equation& law, SymbolId letter) {
  return std::ranges::any_of(nodes_below(tree, {law.left, law.right}), [&](ExprId id) {
    if (tree[id].op != Op::conjugate) return false;
    const ExprNode& of = tree[tree.children(id)[0]];
    return of.op == Op::symbol && of.symbol == letter;
  });
}

/// That the operators of the row are self-adjoint, as far as the words or the commutators of the page say so.
std::vector<PageLaw> self_adjoint_letters(RowPlace& place, const Claim& claim, const Laws& available) {
  const auto writes = [&](const Equation& each) {
    return writes_adjoints(place.tree, place.names.scope, each);
  };
  const bool operators =
      has_operators(place.tree, claim.equation.left) || has_operators(place.tree, claim.equation.right);
  if (!operators) return {};
  const auto is_written_by = [&](const PageLaw* law) { return writes(law->equation); };
  if (!writes(claim.equation) && std::ranges::none_of(available, is_written_by)) return {};
  std::map<SymbolId, std::string> names;
  const bool denied = denies_self_adjoint_operators(place);
  if (!denied) {
    for (const SymbolId letter : observables_of(place.tree, available))
      names[letter] = "convention: `{}` is self-adjoint, as an observable is";
  }
  const ProseBeside& here = beside(place);
  for (const LetterInLine& said : place.notes.prose.self_adjoint) {
    if (denied || !place.notes.prose.sections.reaches(said.place, here.place)) continue;
    const auto reading = read_here(place, said.chain);
    if (reading->sides.size() != 2 || !reading->sides[1].typed) continue;
    const ExprNode& letter = place.tree[reading->sides[1].typed->id];
    if (letter.op == Op::symbol && letter.slot_count == 0)
      names[letter.symbol] = "`{}` is said to be self-adjoint";
  }
  // "For Hermitian operators $X$ and any $Z$" names those that are.
  const bool of_all = here.lead.find('$') == std::string::npos && speaks_of_self_adjoint_operators(here.lead);
  std::vector<PageLaw> laws;
  for (const SymbolId letter : base_letters(place.tree, place.names.scope, claim.equation)) {
    const Symbol& symbol = place.tree.symbols[letter];
    if (!symbol.noncommuting || symbol.rank > 0 || definition_of(place.names.scope, letter) != nullptr)
      continue;
    // What the page says of its adjoint goes before a convention.
    const bool told = std::ranges::any_of(
        available, [&](const PageLaw* law) { return says_an_adjoint(place.tree, law->equation, letter); });
    if (told) continue;
    const auto said = names.find(letter);
    if (said == names.end() && !of_all) continue;
    const std::string text = said != names.end() ? said->second : "`{}` is said to be self-adjoint";
    laws.push_back(
        self_adjoint_law(place.tree, letter, claim.relation, fmt::format(fmt::runtime(text), symbol.name)));
  }
  return laws;
}

/// "With $b = d$ we get", "for $\theta_1 + \theta_2 = \pi/2$": what its own sentence says goes with the laws.
std::vector<PageLaw> said_in_its_sentence(RowPlace& place, const StepReading& row) {
  const ProseBeside& here = beside(place);
  std::set<std::uint32_t> own;  // where its relations begin
  for (const SaidInLine& said : place.notes.prose.said) {
    if (said.sentence == here.sentence && !said.chains.empty()) own.insert(said.span.begin);
  }
  std::vector<PageLaw> laws;
  if (own.empty()) return laws;
  for (const Fact& fact : standpoint(place, row.parsed).facts) {
    const bool is_own = own.contains(fact.span.begin) && !fact.elsewhere;
    if (!fact.proves || !is_own || fact.equation.relation != Relation::equal) continue;
    laws.push_back({.equation = fact.equation,
                    .name = fact.text,
                    .span = fact.span,
                    .place = fact.place,
                    .paragraph = here.paragraph,
                    .at_instant = fact.at_instant,
                    .of_a_case = true});
  }
  return laws;
}

}  // namespace

bool may_be_of_a_case(const RowPlace& place, const ParsedChain& parsed) {
  const ProseBeside& here = beside(place);
  const std::string heading = lowered(place.section);
  const auto around =
      said_around(place.notes.prose, place.event, place.sources, parsed.written.span, parsed.written.tag);
  return is_conditional(place) || is_of_a_moment(place) || is_an_example(place) || is_of_a_case(place) ||
         begins_with_a_case(here.lead) || restriction_in_heading(heading) || (around && !around->of_notes);
}

bool follows_from_page(RowPlace& place, const StepReading& row, const Claim& claim, Judgement& judgement) {
  if (row.role != Role::display || row.unsettled || is_meant_for_all(place.tree, place.names, claim))
    return false;
  Laws available = available_to(place, row.parsed);
  const std::vector<PageLaw> self_adjoint = self_adjoint_letters(place, claim, available);
  for (const PageLaw& each : self_adjoint) available.push_back(&each);
  const std::vector<PageLaw> said = said_in_its_sentence(place, row);
  for (const PageLaw& each : said) available.push_back(&each);
  const auto named_in = [&](const Laws& laws) {
    Laws named = named_beside(place, laws);
    for (const PageLaw& each : said) named.push_back(&each);
    return named;
  };
  Laws founded = available;
  std::erase_if(founded, [](const PageLaw* law) { return is_open(*law); });
  DecisionCache& cache = *place.options.cache;
  const bool inferred = row.parsed.written.inference != Inference::none;
  auto found =
      follow_from_laws(place.tree, place.names, claim, {founded, named_in(founded)}, inferred, cache);
  const bool rests_on_open = !found && is_announced(place, row) && founded.size() < available.size();
  if (rests_on_open)
    found =
        follow_from_laws(place.tree, place.names, claim, {available, named_in(available)}, inferred, cache);
  if (!found) return false;
  add_used(place, judgement.used);
  judgement = *std::move(found);
  add_used(place, judgement.used);
  if (rests_on_open) {
    judgement = follows_from_open(available, claim, std::move(judgement));
    leave(place, row, claim, Standing::conclusion);
    return true;
  }
  if (judgement.restates) return true;
  heed_proof(place, row.parsed, claim, judgement);
  const bool both_ways = row.parsed.written.inference == Inference::equivalence;
  // What holds where its own sentence does need not hold below.
  const bool of_its_sentence =
      std::ranges::any_of(said, [&](const PageLaw& law) { return is_one_of(law.name, judgement.uses); });
  if (judgement.verdict == Verdict::proved && !both_ways && !of_its_sentence)
    leave(place, row, claim, Standing::result);
  return true;
}

bool is_suspect(RowPlace& place, const StepReading& row, const Claim& claim, Judgement& judgement) {
  const bool asks = place.options.repairs != Repairs::none && !place.is_stated && row.role == Role::display &&
                    !row.unsettled && claim.recorded == nullptr && !is_alternative(place, row.parsed);
  if (!asks) return false;
  // "Solve `\ln x^2 = \ln x`": it says which values are meant.
  if (row.which == 0 && may_be_an_equation_of_letters(place.tree, claim.equation) &&
      asks_for_values(beside(place).lead))
    return false;
  // What is also the right side of the link before it is less likely to hold the slip.
  const WrongStep wrong{.parsed = row.parsed,
                        .which = row.which,
                        .left = row.which > 0 ? Trust::supported : Trust::unknown,
                        .near = sides_near(place.notes, row.parsed)};
  const bool of_a_case = may_be_of_a_case(place, row.parsed);
  const bool restricted = judgement.verdict == Verdict::undecided || (of_a_case && row.which == 0);
  const Laws available = available_to(place, row.parsed);
  const Laws here = grounds_for_suspicion(place, available);
  const Laws to_be_solved = judgement.verdict == Verdict::undecided ? Laws{} : here;
  const Laws grounds = restricted ? Laws{} : without_cases(here);
  const bool may_lack_a_term = is_announced(place, row) && !of_a_case;
  Names names = as_said_here(place, row);
  for (const PageLaw& law : self_adjoint_letters(place, claim, available))
    assume(names.scope, {law.equation, Origin{law.name, {}, std::nullopt}, 0});
  for (const NamedAssumption& each : sizes_that_matter(place, row, claim)) assume(names.scope, each);
  auto found =
      suspicion(place.tree, names, {wrong, claim, grounds, to_be_solved, may_lack_a_term, restricted},
                *place.options.cache);
  if (!found || !rests_on_what_is_said_here(place, row, found->uses)) return false;
  judgement.verdict = Verdict::suspect;
  judgement.route = "one slip of the pen away from what follows";
  judgement.uses = std::move(found->uses);
  judgement.counterexample.reset();
  judgement.sample.reset();
  judgement.diagnostics = {{DiagnosticKind::suspect,
                            claim.relation,
                            judgement.uses.empty()
                                ? fmt::format("it does not follow, but `{}` holds", found->repair.statement)
                                : fmt::format("it does not follow, but `{}` follows from {}",
                                              found->repair.statement, fmt::join(judgement.uses, ", ")),
                            {},
                            {"`rigor: law next` says that it is meant as it stands"}}};
  judgement.repairs = {std::move(found->repair)};
  return true;
}

void state_law(RowPlace& place, const StepReading& row, const Claim& claim, Judgement& judgement) {
  if (is_suspect(place, row, claim, judgement)) return;
  if (is_denied_by_laws(place.tree, place.names, claim, available_to(place, row.parsed),
                        *place.options.cache)) {
    judgement.verdict = Verdict::undecided;
    judgement.diagnostics.push_back(without_ground(place.tree, place.names, claim, judgement));
    return;
  }
  // Who assumes something about its letters means it to follow from that.
  if (place.is_stated || (!judgement.despite_given && !is_announced(place, row))) {
    judgement.route = "stated; it follows from nothing above it";
    return leave(place, row, claim, Standing::law);
  }
  judgement.verdict = Verdict::undecided;
  judgement.diagnostics.push_back(without_ground(place.tree, place.names, claim, judgement));
  leave(place, row, claim, Standing::conclusion);
}

}  // namespace rigor
