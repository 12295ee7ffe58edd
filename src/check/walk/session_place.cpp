// SPDX-License-Identifier: GPL-3.0-or-later
// What is said around a step: its sentence, the relations in lines of prose, laws above it, and `use`.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "base/among.h"
#include "base/ascii.h"
#include "check/doubt/digits.h"
#include "check/prose/denial.h"
#include "check/question/unread.h"
#include "check/scope/local_kinds.h"
#include "check/walk/session.h"
#include "check/word/prose_words.h"

namespace rigor {
namespace {

constexpr std::size_t most_laws = 12;  // the last ones are looked at

/// The letters that stand in these expressions themselves, not in subscripts.
std::set<std::string> letters_in(const SyntaxTree& syntax, std::vector<SyntaxId> pending) {
  std::set<std::string> letters;
  while (!pending.empty()) {
    const SyntaxId id = pending.back();
    pending.pop_back();
    if (syntax[id].kind == SyntaxKind::symbol) letters.insert(syntax.symbol(id).letter);
    for (const SyntaxChild& child : syntax.children(id)) pending.push_back(child.id);
  }
  return letters;
}

/// `a > 0`, `i \ne j`, `x \le y`: letters and numbers in order, and nothing else.
bool orders_letters(const SyntaxTree& syntax, const ParsedChain& chain) {
  const auto is_plain = [&](SyntaxId id) {
    return syntax[id].kind == SyntaxKind::symbol || syntax[id].kind == SyntaxKind::number;
  };
  const bool letter = std::any_of(chain.sides.begin(), chain.sides.end(),
                                  [&](SyntaxId id) { return syntax[id].kind == SyntaxKind::symbol; });
  return letter && !chain.written.relations.empty() &&
         std::all_of(chain.sides.begin(), chain.sides.end(), is_plain) &&
         std::all_of(chain.written.relations.begin(), chain.written.relations.end(),
                     [](const WrittenRelation& relation) { return is_order(relation.kind); });
}

bool share_a_letter(const SyntaxTree& syntax, const ParsedChain& one, const ParsedChain& other) {
  const std::set<std::string> letters = letters_in(syntax, one.sides);
  const std::set<std::string> others = letters_in(syntax, other.sides);
  return std::any_of(letters.begin(), letters.end(),
                     [&](const std::string& letter) { return others.contains(letter); });
}

bool is_law(const Judgement& judgement) {
  return std::any_of(
      judgement.diagnostics.begin(), judgement.diagnostics.end(),
      [](const Diagnostic& diagnostic) { return diagnostic.kind == DiagnosticKind::undeclared_symbol; });
}

/// `\approx` and rounded decimals: numbers agree to the digits shown, and nothing else fails where nothing is
/// small.
void heed_digits(ExprTree& tree, Names& names, const Claim& claim, Judgement& judgement,
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
    withdraw("it depends on how many of the digits shown are meant", "write as many digits as are meant");
  } else if (!agreement && judgement.verdict == Verdict::refuted &&
             compares_decimals(tree, names, claim.equation)) {
    withdraw("decimals are rounded, and nothing shows to how many digits the other side is meant",
             "write it as a decimal, or `\\approx`");
  } else if (!agreement && claim.nearly && names.small().empty() && judgement.verdict == Verdict::refuted) {
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

bool speaks_of_units(const ExprTree& tree, ExprId side) {
  const std::vector<SymbolId> symbols = symbols_in(tree, side);
  return std::any_of(symbols.begin(), symbols.end(),
                     [&](SymbolId symbol) { return tree.symbols[symbol].unit_of_measure.has_value(); });
}

}  // namespace

void Session::declare_use(const Directive& directive) {
  UseDirective use{directive.number, notes_.prose.beside[event_].place, {}, directive.places};
  for (const SyntaxId id : directive.symbols)
    use.letters.push_back(take_apart(notes_.syntax.symbol(id), Letters{}, names_).base);
  // A label or a line names the equation by its tag, as its definition does.
  for (const Event& event : notes_.events) {
    const auto* display = std::get_if<ParsedDisplay>(&event);
    if (display == nullptr) continue;
    for (const ParsedChain& chain : display->chains) {
      const Span span = chain.written.span;
      const std::string line = fmt::format("line {}", sources_.line_column(span.file, span.begin).line);
      const bool named =
          std::any_of(directive.places.begin(), directive.places.end(), [&](const std::string& place) {
            return place == line || (!chain.written.label.empty() && place == chain.written.label);
          });
      if (named) use.places.push_back(place_name(chain));
    }
  }
  uses_.push_back(std::move(use));
}

/// "or" stands beside it, on its line or in the prose between two displays.
bool Session::is_alternative(const ParsedChain& parsed) const {
  if (parsed.written.alternative) return true;
  const ProseBeside& beside = notes_.prose.beside[event_];
  const auto before = beside.lead.rfind('\n');
  const auto is_or = [](std::string words) {
    std::erase_if(words, [](char c) { return c == ' ' || c == ','; });
    return words == "or" || words == "orelse";
  };
  return (before != std::string::npos && is_or(beside.lead.substr(before + 1))) || is_or(beside.tail);
}

/// `a > 0, \quad \sqrt{a^2} = a`: orders of letters on the line of an equation say when it holds.
std::vector<const ParsedChain*> Session::conditions_beside(const ParsedChain& parsed) const {
  std::vector<const ParsedChain*> conditions;
  const auto* display = std::get_if<ParsedDisplay>(&notes_.events[event_]);
  if (display == nullptr || orders_letters(notes_.syntax, parsed)) return conditions;
  for (const ParsedChain& chain : display->chains) {
    const bool beside = &chain != &parsed && chain.written.statement == parsed.written.statement;
    if (beside && orders_letters(notes_.syntax, chain)) conditions.push_back(&chain);
  }
  return conditions;
}

bool Session::is_condition_beside(const ParsedChain& parsed) const {
  const auto* display = std::get_if<ParsedDisplay>(&notes_.events[event_]);
  if (display == nullptr || !orders_letters(notes_.syntax, parsed)) return false;
  return std::any_of(display->chains.begin(), display->chains.end(), [&](const ParsedChain& chain) {
    return chain.written.statement == parsed.written.statement && !chain.written.relations.empty() &&
           !is_order(chain.written.relations[0].kind);
  });
}

Standpoint Session::standpoint(const ParsedChain& parsed) {
  Standpoint at{.prose = notes_.prose,
                .event = event_,
                .uses = uses_,
                .facts = {},
                .heading = lowered(section_),
                .unread = {}};
  for (const SaidInLine& said : notes_.prose.said) {
    for (const ParsedChain& chain : said.chains) {
      if (!chain.written.relations.empty() && share_a_letter(notes_.syntax, chain, parsed)) {
        add_said(said, parsed, at);
        break;
      }
      const bool reaches = said.cue == Cue::definition && said.before <= event_;
      if (reaches && !chain.written.relations.empty()) {
        add_said(said, parsed, at);
        break;
      }
    }
  }
  for (const ParsedChain* chain : conditions_beside(parsed)) {
    SaidInLine said{.span = chain->written.span, .cue = Cue::condition, .sentence = at.beside().sentence};
    said.place = at.beside().place;
    said.chains.push_back(*chain);
    add_said(said, parsed, at);
  }
  for (const ParsedChain& chain : parsed.assumed) {
    SaidInLine said{.span = chain.written.span, .cue = Cue::condition, .sentence = at.beside().sentence};
    said.words = text_of(chain.written);
    said.place = at.beside().place;
    said.chains.push_back(chain);
    add_said(said, parsed, at);
  }
  const std::set<std::string> own = letters_of(text_of(parsed.written));
  for (const auto& [place, span] : unread_rows_) {
    if (!at.unread.empty() || !notes_.prose.sections.reaches(place, at.beside().place)) continue;
    const std::string text = written(span);
    const std::set<std::string> letters = letters_of(text);
    const bool shares = std::any_of(letters.begin(), letters.end(),
                                    [&](const std::string& letter) { return own.contains(letter); });
    if (shares) at.unread = text;
  }
  const std::size_t first = laws_.size() - std::min(laws_.size(), most_laws);
  for (std::size_t k = first; k < laws_.size(); ++k) {
    at.facts.push_back(laws_[k]);
    Fact& law = at.facts.back();
    law.elsewhere = !notes_.prose.sections.reaches(law.place, at.beside().place);
    law.proves = law.proves && !law.elsewhere;
  }
  return at;
}

/// A relation in a line is a definition where it brings in a fresh letter, and a condition of its own
/// sentence.
void Session::add_said(const SaidInLine& said, const ParsedChain& parsed, Standpoint& at) {
  const bool same_sentence = said.sentence == at.beside().sentence;
  const bool in_reach = notes_.prose.sections.reaches(said.place, at.beside().place);
  // "We know that $ab = 0$." holds from there on.
  const bool stated_above =
      said.alone && in_reach && said.before <= event_ && said.sentence < at.beside().sentence;
  if (!same_sentence && !stated_above && !(said.cue == Cue::definition && in_reach && said.before <= event_))
    return;
  for (const ParsedChain& chain : said.chains) {
    bool understood = !chain.written.relations.empty() && !chain.written.condition && !chain.written.doubt;
    std::vector<Fact> facts;
    const auto reading = read_chain(notes_.syntax, tree_, names_, chain);
    for (std::size_t k = 0; k < chain.written.relations.size() && understood; ++k) {
      Diagnostics ignored;
      const bool typed = reading->sides[k].typed && reading->sides[k + 1].typed &&
                         can_be_assumed(chain.written.relations[k].kind) && !reading->elaborator().guess();
      const auto claim = typed ? reading->claim(chain, k, false, ignored) : std::nullopt;
      understood = claim.has_value();
      if (!understood) break;
      const ExprNode& left = tree_[claim->equation.left];
      const bool fresh = left.op == Op::symbol && !names_.seen_in_equation(left.symbol) &&
                         names_.definition_of(left.symbol) == nullptr &&
                         claim->equation.relation == Relation::equal &&
                         !symbols_in(tree_, claim->equation.right).empty();
      if (!same_sentence && !fresh && !stated_above) continue;
      const bool brings_in = same_sentence || (fresh && said.cue == Cue::definition);
      Fact fact{claim->equation,
                {},
                said.cue != Cue::none && said.cue != Cue::apart && brings_in,
                said.place,
                said.span};
      const bool meaning = fresh && is_meaning(tree_, claim->equation);
      fact.at_instant = said.cue == Cue::condition || said.at_place || !meaning;
      fact.proves = fact.proves && (meaning || !said.named);
      fact.text = fmt::format("{} (line {})", said.words.empty() ? written(said.span) : said.words,
                              sources_.line_column(said.span.file, said.span.begin).line);
      facts.push_back(std::move(fact));
    }
    at.facts.insert(at.facts.end(), facts.begin(), facts.end());
    const bool shares = share_a_letter(notes_.syntax, chain, parsed);
    if (!understood && (same_sentence || stated_above) && shares && at.unread.empty())
      at.unread = written(said.span);
  }
}

/// `S_{ij} = \tfrac12(T_{ij} + T_{ji})` below `T_{ij} = S_{ij} + A_{ij}`: it may say what S is.
bool Session::is_late_definition(const Typed& left, const Typed& right) const {
  const ExprNode& node = tree_[left.id];
  if (node.op != Op::symbol || tree_.symbols[node.symbol].derivation || tree_.symbols[node.symbol].declared ||
      names_.definition_of(node.symbol) != nullptr)
    return false;
  const std::vector<SymbolId> direct = symbols_in(tree_, right.id);
  return !is_one_of(node.symbol, direct) && is_circular(left, right);
}

/// The letter by which it fails, and would not if it were read by what its own section says.
std::optional<std::string> Session::letter_borrowed_for(const ParsedChain& parsed, std::size_t which,
                                                        const Claim& claim) {
  const LocalKinds local(notes_, names_, event_);
  const auto letter = local.borrowed_letter(notes_.syntax, parsed);
  if (!letter) return std::nullopt;
  for (const UseDirective& use : uses_) {
    const bool here = notes_.prose.sections.reaches(use.place, notes_.prose.beside[event_].place);
    if (!here || !is_one_of(*letter, use.letters)) continue;
    names_.mark_used(use.directive);
    return std::nullopt;
  }
  const auto reading = read_chain(notes_.syntax, tree_, names_, parsed);
  if (!reading->sides[which].typed || !reading->sides[which + 1].typed) return letter;
  Diagnostics ignored;
  const auto other = reading->claim(parsed, which, claim.nearly, ignored);
  if (!other || judge(tree_, names_, *other, {}, options_.cache).verdict != Verdict::refuted) return letter;
  return std::nullopt;
}

/// A refutation that rests on what is not said for this place is taken back; laws are kept for later.
void Session::heed(const ParsedChain& parsed, std::size_t which, const Claim& claim, const Side& left,
                   const Side& right, const Context& context, Judgement& judgement) {
  if (context.role != Role::display || !decides() || options_.recorded != nullptr) return;
  const bool expected = !expectations_.empty() || (parsed.image > 0 && !in_force_.empty());
  if (expected) return;
  if (judgement.verdict == Verdict::proved) return heed_proof(parsed, claim, judgement);
  heed_digits(tree_, names_, claim, judgement, options_.cache);
  if (judgement.verdict == Verdict::proved) return;
  Standpoint at = standpoint(parsed);
  at.denied = denial_of(notes_.prose, event_);
  if (judgement.verdict == Verdict::refuted)
    at.around = said_around(notes_.prose, event_, sources_, parsed.written.span, parsed.written.tag);
  const bool late = which == 0 && judgement.verdict == Verdict::refuted && !claim.nearly &&
                    claim.equation.relation == Relation::equal && !announces_a_conclusion(at.beside().lead) &&
                    is_late_definition(*left.typed, *right.typed);
  judgement = heed_place(tree_, names_, claim, std::move(judgement), at, options_.cache);
  const auto withdraw = [&](DiagnosticKind kind, std::string message, std::vector<std::string> help) {
    judgement.verdict = Verdict::undecided;
    judgement.counterexample.reset();
    judgement.sample.reset();
    judgement.diagnostics = {{kind, claim.relation, std::move(message), {}, std::move(help)}};
  };
  const bool zeros = claim.equation.relation == Relation::unequal && tree_.is_zero_literal(left.typed->id) &&
                     tree_.is_zero_literal(right.typed->id) && written(claim.left) != written(claim.right);
  const bool left_units = speaks_of_units(tree_, left.typed->id);
  const bool right_units = speaks_of_units(tree_, right.typed->id);
  const ExprId bare = left_units ? right.typed->id : left.typed->id;
  if (judgement.verdict == Verdict::refuted && left_units != right_units && symbols_in(tree_, bare).empty())
    withdraw(DiagnosticKind::restricted, "one side has a unit, and the other is a number without one", {});
  if (judgement.verdict == Verdict::refuted && zeros)
    withdraw(DiagnosticKind::restricted, "of two zeros this may remark how they are written", {});
  if (judgement.verdict == Verdict::refuted && is_alternative(parsed))
    withdraw(DiagnosticKind::restricted, "it is one of several alternatives", {});
  if (judgement.verdict == Verdict::refuted) {
    if (const auto letter = letter_borrowed_for(parsed, which, claim))
      withdraw(DiagnosticKind::borrowed,
               fmt::format("it fails only where `{}` is read as in another section", *letter),
               {fmt::format("`rigor: use {}` says that it is meant so here, too", *letter)});
  }
  if (judgement.verdict == Verdict::refuted && !is_meant_for_all(tree_, names_, claim)) {
    if (auto doubt = doubt_left(parsed, which, claim, context))
      withdraw(DiagnosticKind::restricted, std::move(doubt->first), {std::move(doubt->second)});
  }
  refute_by_digits(parsed, claim, judgement);
  const bool stays_late = late && judgement.verdict == Verdict::refuted;
  const bool chooses_axes = judgement.verdict == Verdict::refuted && which == 0 &&
                            is_vector_by_components(tree_, claim.equation) &&
                            !is_meant_for_all(tree_, names_, claim);
  if (chooses_axes)
    withdraw(DiagnosticKind::restricted,
             fmt::format("it may say along which axes `{}` is", written(claim.left)),
             {"`rigor: given …` says so, `rigor: claim …` states it"});
  const auto remember = [&](bool proves) {
    const std::string text =
        fmt::format("{} (line {})", written(cover(claim.left, claim.right)),
                    sources_.line_column(claim.relation.file, claim.relation.begin).line);
    laws_.push_back({claim.equation, text, proves, at.beside().place, claim.relation});
  };
  if (stays_late) {
    judgement.verdict = Verdict::undecided;
    judgement.counterexample.reset();
    judgement.sample.reset();
    judgement.diagnostics = {{DiagnosticKind::borrowed,
                              claim.relation,
                              fmt::format("it may say what `{}` is, by which others are defined above",
                                          written(tree_[left.typed->id].span)),
                              {},
                              {"`therefore` or `hence` in its sentence announces a conclusion"}}};
    remember(true);
  } else if (chooses_axes) {
    remember(true);
  } else if (judgement.verdict != Verdict::refuted && is_law(judgement) && !claim.nearly && !at.denied) {
    remember(false);
  }
}

}  // namespace rigor
