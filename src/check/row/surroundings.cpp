// SPDX-License-Identifier: GPL-3.0-or-later
// What is said around a step: its sentence, the relations in lines of prose, laws above it, and `use`.
#include "check/row/row.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/among.h"
#include "base/ascii.h"
#include "check/constant/natural_units.h"
#include "check/doubt/approximate_value.h"
#include "check/doubt/digits.h"
#include "check/place/place.h"
#include "check/prose/denial.h"
#include "check/question/unread.h"
#include "check/scope/definition.h"
#include "check/scope/local_kinds.h"
#include "check/word/prose_words.h"

namespace rigor {
namespace {

constexpr std::size_t most_laws = 12;  // the last ones are looked at

/// The letters that are in these expressions themselves, not in subscripts.
std::set<std::string> letters_in(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides) {
  std::set<std::string> letters;
  for (const SyntaxId id : nodes_below(syntax, sides)) {
    if (syntax[id].kind == SyntaxKind::symbol) letters.insert(syntax.symbol(id).letter);
  }
  return letters;
}

/// `a > 0`, `i \ne j`, `x \le y`: letters and numbers in order, and nothing else.
bool orders_letters(const SyntaxTree& syntax, const ParsedChain& chain) {
  const auto is_plain = [&](SyntaxId id) {
    return syntax[id].kind == SyntaxKind::symbol || syntax[id].kind == SyntaxKind::number;
  };
  const bool letter =
      std::ranges::any_of(chain.sides, [&](SyntaxId id) { return syntax[id].kind == SyntaxKind::symbol; });
  return letter && !chain.written.relations.empty() && std::ranges::all_of(chain.sides, is_plain) &&
         std::ranges::all_of(chain.written.relations,
                             [](const WrittenRelation& relation) { return is_order(relation.kind); });
}

bool share_a_letter(const SyntaxTree& syntax, const ParsedChain& one, const ParsedChain& other) {
  const std::set<std::string> others = letters_in(syntax, other.sides);
  return std::ranges::any_of(letters_in(syntax, one.sides),
                             [&](const std::string& letter) { return others.contains(letter); });
}

/// `\frac{(6.7)^2(9.8)}{4\pi^2} \approx 11\,\mathrm m`
bool lacks_units(const ExprTree& tree, const Equation& equation) {
  const auto is_pure = [&](ExprId side) {
    return std::ranges::all_of(symbols_in(tree, side),
                               [&](SymbolId each) { return tree.symbols[each].circle_number; });
  };
  const auto has_unit = [&](ExprId side) {
    return std::ranges::any_of(symbols_in(tree, side),
                               [&](SymbolId each) { return tree.symbols[each].unit_of_measure.has_value(); });
  };
  return (has_unit(equation.left) && is_pure(equation.right)) ||
         (is_pure(equation.left) && has_unit(equation.right));
}

/// `\approx` and rounded decimals: numbers agree to the digits shown, and nothing else fails where nothing is
/// small.
void heed_digits(ExprTree& tree, const Names& names, const Claim& claim, Judgement& judgement,
                 DecisionCache* cache) {
  const auto withdraw = [&](std::string message, std::string help) {
    judgement.verdict = Verdict::undecided;
    judgement.counterexample.reset();
    judgement.sample.reset();
    judgement.diagnostics = {
        {DiagnosticKind::undecided, claim.relation, std::move(message), {}, {std::move(help)}}};
  };
  const auto compared = agreement_of_digits(tree, names, claim, cache);
  const std::optional<Agreement> agreement = compared ? std::optional(compared->agreement) : std::nullopt;
  if (agreement == Agreement::rounds) {
    judgement.verdict = Verdict::proved;
    judgement.route = "to the digits shown";
    judgement.of_another_question = true;
    judgement.counterexample.reset();
    judgement.sample.reset();
    judgement.diagnostics.clear();
  } else if (agreement == Agreement::unclear && judgement.verdict == Verdict::refuted) {
    withdraw("whether it holds depends on how many of the digits are meant",
             "write only the digits that are meant");
  } else if (compared && judgement.verdict == Verdict::refuted &&
             may_be_rounded_on_the_way(tree, names, claim, *compared)) {
    withdraw("it holds if the decimals that it is computed from are rounded themselves",
             "more digits of them show whether it holds");
  } else if (claim.nearly && judgement.verdict == Verdict::refuted && lacks_units(tree, claim.equation)) {
    withdraw("one side has a unit, and the other is a number without one", "write the units on both sides");
  } else if (!agreement && judgement.verdict == Verdict::refuted &&
             compares_decimals(tree, names, claim.equation)) {
    withdraw("decimals are rounded, and nothing shows to how many digits the other side is meant",
             "write it as a decimal, or `\\approx`");
  } else if (!agreement && claim.nearly && names.scope.small->empty() &&
             judgement.verdict == Verdict::refuted) {
    withdraw("nothing says what is small here", "`rigor: small …` says so");
  }
}

bool can_be_assumed(RelationKind kind) {
  return kind == RelationKind::equal || kind == RelationKind::defines || is_order(kind);
}

/// `c`, `-c`, `2c`, `c/2`
bool is_one_letter(const ExprTree& tree, ExprId id) {
  const ExprNode& node = tree[id];
  if (node.op == Op::symbol) return !tree.symbols[node.symbol].derivation;
  if (node.op != Op::negate && node.op != Op::multiply && node.op != Op::divide) return false;
  std::vector<ExprId> children(tree.children(id).begin(), tree.children(id).end());
  std::erase_if(children, [&](ExprId child) { return symbols_in(tree, child).empty(); });
  return children.size() == 1 && is_one_letter(tree, children[0]);
}

/// `v = gt`, `\kappa = a/b`, not `\psi = c`, `x = 2a`: it says at all times and places what its left side is.
bool is_meaning(const ExprTree& tree, const Equation& equation) {
  return !tree.symbols[tree[equation.left].symbol].derivation && !is_one_letter(tree, equation.right);
}

/// `\mathbf B = (0, 0, B)`
bool is_vector_by_components(const ExprTree& tree, const Equation& equation) {
  const ExprNode& left = tree[equation.left];
  return equation.relation == Relation::equal && left.op == Op::symbol && left.rank == 1 &&
         tree[equation.right].op == Op::tuple;
}

/// "Set `U = 0` … Thus `U = \begin{pmatrix} 2 & 3 …`": a calculation gives its letter one value after the
/// other.
bool takes_another_value(const RowPlace& place, const Typed& left, const Typed& right) {
  const auto is_value = [&](ExprId id) { return symbols_in(place.tree, id).empty(); };
  const ExprNode& node = place.tree[left.id];
  if (node.op != Op::symbol || node.slot_count > 0 || !is_value(right.id)) return false;
  const NamedDefinition* named = definition_of(place.names.scope, node.symbol);
  if (named == nullptr || named->origin.directive || !is_value(named->definition.body)) return false;
  const std::string lead = lowered(place.notes.prose.beside[named->origin.event].lead);
  return std::ranges::any_of(words_of(lead), [](std::string_view word) {
    return is_one_of(word, {"set", "start", "starting", "begin", "initialize", "initialise", "initially",
                            "initial", "guess"});
  });
}

/// `\begin{pmatrix} … \end{pmatrix} = 3`: a multiple of the unit matrix, or something made of the matrix.
bool is_matrix_against_number(const ExprTree& tree, const Typed& left, const Typed& right) {
  const auto is_written_out = [&](const Typed& side) {
    return side.rank == 2 && tree[side.id].op == Op::tuple;
  };
  return (is_written_out(left) && right.rank == 0 && !tree.is_zero_literal(right.id)) ||
         (is_written_out(right) && left.rank == 0 && !tree.is_zero_literal(left.id));
}

bool speaks_of_units(const ExprTree& tree, ExprId side) {
  const std::vector<SymbolId> symbols = symbols_in(tree, side);
  return std::ranges::any_of(
      symbols, [&](SymbolId symbol) { return tree.symbols[symbol].unit_of_measure.has_value(); });
}

/// A relation in a line is a definition where it brings in a fresh letter, and a condition of its own
/// sentence.
void add_said(RowPlace& place, const SaidInLine& said, const ParsedChain& parsed, Standpoint& at) {
  const bool same_sentence = said.sentence == at.beside().sentence;
  const bool in_reach = place.notes.prose.sections.reaches(said.place, at.beside().place);
  // "We know that $ab = 0$." holds from there on.
  const bool stated_above =
      said.alone && in_reach && said.before <= place.event && said.sentence < at.beside().sentence;
  if (!same_sentence && !stated_above &&
      !(said.cue == Cue::definition && in_reach && said.before <= place.event))
    return;
  for (const ParsedChain& chain : said.chains) {
    bool understood = !chain.written.relations.empty() && !chain.written.condition && !chain.written.doubt;
    std::vector<Fact> facts;
    const auto reading = read_here(place, chain);
    for (std::size_t k = 0; k < chain.written.relations.size() && understood; ++k) {
      Diagnostics ignored;
      const bool typed = reading->sides[k].typed && reading->sides[k + 1].typed &&
                         can_be_assumed(chain.written.relations[k].kind) && !guess_of(reading->reading());
      const auto claim = typed ? reading->claim(chain, k, false, ignored) : std::nullopt;
      understood = claim.has_value();
      if (!understood) break;
      const ExprNode& left = place.tree[claim->equation.left];
      const bool fresh = left.op == Op::symbol && !seen_in_equation(place.names.scope, left.symbol) &&
                         definition_of(place.names.scope, left.symbol) == nullptr &&
                         claim->equation.relation == Relation::equal &&
                         !symbols_in(place.tree, claim->equation.right).empty();
      if (!same_sentence && !fresh && !stated_above) continue;
      const bool brings_in = same_sentence || (fresh && said.cue == Cue::definition &&
                                               is_said_for_good(place, said, left.symbol));
      Fact fact{claim->equation,
                {},
                said.cue != Cue::none && said.cue != Cue::apart && brings_in,
                said.place,
                said.span};
      const bool meaning = fresh && is_meaning(place.tree, claim->equation);
      fact.at_instant = said.cue == Cue::condition || said.at_place || !meaning;
      fact.proves = fact.proves && (meaning || !said.named);
      fact.text = fmt::format("{} (line {})", said.words.empty() ? written_at(place, said.span) : said.words,
                              place.sources.line_column(said.span.file, said.span.begin).line);
      facts.push_back(std::move(fact));
    }
    at.facts.insert(at.facts.end(), facts.begin(), facts.end());
    const bool shares = share_a_letter(place.notes.syntax, chain, parsed);
    if (!understood && (same_sentence || stated_above) && shares && at.unread.empty())
      at.unread = written_at(place, said.span);
  }
}

/// `S_{ij} = \tfrac12(T_{ij} + T_{ji})` below `T_{ij} = S_{ij} + A_{ij}`: it may say what S is.
bool is_late_definition(const RowPlace& place, const Typed& left, const Typed& right) {
  const ExprNode& node = place.tree[left.id];
  if (node.op != Op::symbol || place.tree.symbols[node.symbol].derivation ||
      place.tree.symbols[node.symbol].declared || definition_of(place.names.scope, node.symbol) != nullptr)
    return false;
  const std::vector<SymbolId> direct = symbols_in(place.tree, right.id);
  return !is_one_of(node.symbol, direct) && is_circular(place.tree, place.names.scope, left, right);
}

/// The letter by which it fails, and would not if it were read by what its own section says.
std::optional<std::string> letter_borrowed_for(RowPlace& place, const StepReading& row, const Claim& claim) {
  const LocalKinds local(place.notes, place.names, place.event);
  add_used(place, local.used());
  const auto letter = local.borrowed_letter(place.notes.syntax, row.parsed);
  if (!letter) return std::nullopt;
  for (const UseDirective& use : place.above.uses) {
    const bool here =
        place.notes.prose.sections.reaches(use.place, place.notes.prose.beside[place.event].place);
    if (!here || !is_one_of(*letter, use.letters)) continue;
    place.found.used.insert(use.directive);
    return std::nullopt;
  }
  const auto reading = read_here(place, row.parsed);
  if (!reading->sides[row.which].typed || !reading->sides[row.which + 1].typed) return letter;
  Diagnostics ignored;
  const auto other = reading->claim(row.parsed, row.which, claim.nearly, ignored);
  if (!other || judge_here(place, *other).verdict != Verdict::refuted) return letter;
  return std::nullopt;
}

}  // namespace

bool is_alternative(const RowPlace& place, const ParsedChain& parsed) {
  if (parsed.written.alternative) return true;
  const ProseBeside& beside = place.notes.prose.beside[place.event];
  const auto before = beside.lead.rfind('\n');
  const auto is_or = [](std::string words) {
    std::erase_if(words, [](char c) { return c == ' ' || c == ','; });
    return words == "or" || words == "orelse";
  };
  return (before != std::string::npos && is_or(beside.lead.substr(before + 1))) || is_or(beside.tail);
}

std::vector<const ParsedChain*> conditions_beside(const RowPlace& place, const ParsedChain& parsed) {
  std::vector<const ParsedChain*> conditions;
  const auto* display = std::get_if<ParsedDisplay>(&place.notes.events[place.event]);
  if (display == nullptr || orders_letters(place.notes.syntax, parsed)) return conditions;
  for (const ParsedChain& chain : display->chains) {
    const bool beside = &chain != &parsed && chain.written.statement == parsed.written.statement &&
                        chain.written.inference == Inference::none && !chain.written.alternative;
    if (beside && orders_letters(place.notes.syntax, chain)) conditions.push_back(&chain);
  }
  return conditions;
}

bool is_condition_beside(const RowPlace& place, const ParsedChain& parsed) {
  const auto* display = std::get_if<ParsedDisplay>(&place.notes.events[place.event]);
  if (display == nullptr || !orders_letters(place.notes.syntax, parsed)) return false;
  if (parsed.written.inference != Inference::none || parsed.written.alternative) return false;
  return std::ranges::any_of(display->chains, [&](const ParsedChain& chain) {
    return chain.written.statement == parsed.written.statement && !chain.written.relations.empty() &&
           !is_order(chain.written.relations[0].kind);
  });
}

Standpoint standpoint(RowPlace& place, const ParsedChain& parsed) {
  Standpoint at{.prose = place.notes.prose,
                .event = place.event,
                .uses = place.above.uses,
                .facts = {},
                .heading = lowered(place.section),
                .unread = {}};
  for (const SaidInLine& said : place.notes.prose.said) {
    for (const ParsedChain& chain : said.chains) {
      if (!chain.written.relations.empty() && share_a_letter(place.notes.syntax, chain, parsed)) {
        add_said(place, said, parsed, at);
        break;
      }
      const bool reaches = said.cue == Cue::definition && said.before <= place.event;
      if (reaches && !chain.written.relations.empty()) {
        add_said(place, said, parsed, at);
        break;
      }
    }
  }
  for (const ParsedChain* chain : conditions_beside(place, parsed)) {
    SaidInLine said{.span = chain->written.span, .cue = Cue::condition, .sentence = at.beside().sentence};
    said.place = at.beside().place;
    said.chains.push_back(*chain);
    add_said(place, said, parsed, at);
  }
  for (const ParsedChain* chain : definitions_behind(place, parsed)) {
    SaidInLine said{.span = chain->written.span, .cue = Cue::definition, .sentence = at.beside().sentence};
    said.place = at.beside().place;
    said.chains.push_back(*chain);
    add_said(place, said, parsed, at);
  }
  if (at.unread.empty()) at.unread = unread_premise(place, parsed);
  for (const ParsedChain& chain : parsed.assumed) {
    SaidInLine said{.span = chain.written.span, .cue = Cue::condition, .sentence = at.beside().sentence};
    said.words = text_of(chain.written);
    said.place = at.beside().place;
    said.chains.push_back(chain);
    add_said(place, said, parsed, at);
  }
  const std::set<std::string> own = letters_of(text_of(parsed.written));
  for (const auto& [where, span] : place.above.unread_rows) {
    if (!at.unread.empty() || !place.notes.prose.sections.reaches(where, at.beside().place)) continue;
    const std::string text = written_at(place, span);
    const bool shares = std::ranges::any_of(letters_of(text),
                                            [&](const std::string& letter) { return own.contains(letter); });
    if (shares) at.unread = text;
  }
  const std::vector<Fact>& laws = place.above.laws;
  const std::size_t first = laws.size() - std::min(laws.size(), most_laws);
  for (std::size_t k = first; k < laws.size(); ++k) {
    at.facts.push_back(laws[k]);
    Fact& law = at.facts.back();
    law.elsewhere = !place.notes.prose.sections.reaches(law.place, at.beside().place);
    law.proves = law.proves && !law.elsewhere;
  }
  return at;
}

void heed_surroundings(RowPlace& place, const StepReading& row, const Claim& claim, Judgement& judgement) {
  if (row.role != Role::display || !place.heeds_words) return;
  const ParsedChain& parsed = row.parsed;
  const Typed& left = *row.left().typed;
  const Typed& right = *row.right().typed;
  if (judgement.verdict == Verdict::proved) return heed_proof(place, parsed, claim, judgement);
  heed_digits(place.tree, place.names, claim, judgement, place.options.cache);
  if (judgement.verdict == Verdict::proved) return;
  Standpoint at = standpoint(place, parsed);
  at.denied = denial_of(place.notes.prose, place.event);
  if (!at.denied && agrees_with_values(place, row, claim, judgement)) return;
  if (!at.denied && agrees_with_constants(place, row, claim, judgement)) return;
  const Judgement by_itself = judgement;
  if (!at.denied && follows_from_page(place, row, claim, judgement)) {
    if (judgement.verdict != Verdict::undecided) return;
    // What follows from another case's definition may follow from what is said here.
    Judgement said = heed_place(place.tree, place.names, claim, by_itself, at, place.options.cache);
    if (said.verdict != Verdict::proved) return;
    add_used(place, said.used);
    judgement = std::move(said);
    return;
  }
  if (!at.denied && follows_for_sizes(place, row, claim, judgement)) return;
  if (judgement.verdict == Verdict::refuted)
    at.around =
        said_around(place.notes.prose, place.event, place.sources, parsed.written.span, parsed.written.tag);
  const bool late = row.which == 0 && judgement.verdict == Verdict::refuted && !claim.nearly &&
                    claim.equation.relation == Relation::equal && !announces_a_conclusion(at.beside().lead) &&
                    is_late_definition(place, left, right);
  judgement = heed_place(place.tree, place.names, claim, std::move(judgement), at, place.options.cache);
  add_used(place, judgement.used);
  const auto withdraw = [&](DiagnosticKind kind, std::string message, std::vector<std::string> help) {
    judgement.verdict = Verdict::undecided;
    judgement.counterexample.reset();
    judgement.sample.reset();
    judgement.diagnostics = {{kind, claim.relation, std::move(message), {}, std::move(help)}};
  };
  const bool zeros = claim.equation.relation == Relation::unequal && place.tree.is_zero_literal(left.id) &&
                     place.tree.is_zero_literal(right.id) &&
                     written_at(place, claim.left) != written_at(place, claim.right);
  const bool left_units = speaks_of_units(place.tree, left.id);
  const bool right_units = speaks_of_units(place.tree, right.id);
  const ExprId bare = left_units ? right.id : left.id;
  const bool is_number = std::ranges::all_of(
      symbols_in(place.tree, bare), [&](SymbolId each) { return place.tree.symbols[each].circle_number; });
  if (judgement.verdict == Verdict::refuted && left_units != right_units && is_number)
    withdraw(DiagnosticKind::restricted, "one side has a unit, and the other is a number without one", {});
  if (judgement.verdict == Verdict::refuted &&
      may_have_natural_units(place.tree, place.names, claim.equation))
    withdraw(DiagnosticKind::restricted,
             "an energy in electronvolts may stand for a mass, a time or a temperature, which has another "
             "dimension",
             {});
  if (judgement.verdict == Verdict::refuted && zeros)
    withdraw(DiagnosticKind::restricted, "it may be about how two zeros are written", {});
  if (judgement.verdict == Verdict::refuted && is_matrix_against_number(place.tree, left, right)) {
    withdraw(
        DiagnosticKind::ambiguous_reading,
        "one side is a matrix, and the number on the other can be a multiple of the unit matrix, or belong "
        "to the matrix in another way",
        {"write the unit matrix, or `\\det`, `\\operatorname{tr}` or what else is meant"});
    judgement.verdict = Verdict::not_understood;
  }
  if (judgement.verdict == Verdict::refuted && takes_another_value(place, left, right))
    withdraw(DiagnosticKind::restricted,
             "its letter had another value before, with which a calculation began", {});
  if (judgement.verdict == Verdict::refuted && is_alternative(place, parsed))
    withdraw(DiagnosticKind::restricted, "it is only one of several alternatives", {});
  if (judgement.verdict == Verdict::refuted) {
    if (const auto letter = letter_borrowed_for(place, row, claim))
      withdraw(DiagnosticKind::borrowed,
               fmt::format("it fails only where `{}` is read as in another section", *letter),
               {fmt::format("`rigor: use {}` says that it is meant so here, too", *letter)});
  }
  if (judgement.verdict == Verdict::refuted && !is_meant_for_all(place.tree, place.names, claim)) {
    if (auto doubt = doubt_left(place, row, claim))
      withdraw(DiagnosticKind::restricted, std::move(doubt->first), {std::move(doubt->second)});
  }
  const bool restricted = judgement.verdict == Verdict::undecided && !at.denied &&
                          std::ranges::any_of(judgement.diagnostics, [](const Diagnostic& each) {
                            return each.kind == DiagnosticKind::restricted;
                          });
  if (restricted && is_suspect(place, row, claim, judgement)) return;
  refute_by_digits(place, parsed, claim, judgement);
  const bool stays_late = late && judgement.verdict == Verdict::refuted;
  const bool chooses_axes = judgement.verdict == Verdict::refuted && row.which == 0 &&
                            is_vector_by_components(place.tree, claim.equation) &&
                            !is_meant_for_all(place.tree, place.names, claim);
  if (chooses_axes)
    withdraw(
        DiagnosticKind::restricted,
        fmt::format("it may choose the axes by the direction of `{}`", written_at(place, claim.left)),
        {"`rigor: given …` makes it an assumption; `rigor: claim …` asks whether it holds for all values"});
  const auto remember = [&](bool proves) {
    const std::string text =
        fmt::format("{} (line {})", written_at(place, cover(claim.left, claim.right)),
                    place.sources.line_column(claim.relation.file, claim.relation.begin).line);
    place.found.laws.push_back({claim.equation, text, proves, at.beside().place, claim.relation});
  };
  if (stays_late) {
    judgement.verdict = Verdict::undecided;
    judgement.counterexample.reset();
    judgement.sample.reset();
    judgement.diagnostics = {{DiagnosticKind::borrowed,
                              claim.relation,
                              fmt::format("it may say what `{}` is, and definitions above use that",
                                          written_at(place, place.tree[left.id].span)),
                              {},
                              {"`therefore` or `hence` in its sentence announces a conclusion"}}};
    remember(true);
  } else if (chooses_axes) {
    remember(true);
  } else if (judgement.verdict == Verdict::law && at.denied) {
    withdraw(DiagnosticKind::restricted,
             fmt::format("`{}` next to it may say that it does not hold", *at.denied), {});
  } else if (judgement.verdict == Verdict::law) {
    state_law(place, row, claim, judgement);
    if (!claim.nearly && judgement.verdict != Verdict::suspect) remember(false);
  }
}

}  // namespace rigor
