// SPDX-License-Identifier: GPL-3.0-or-later
// What stands one slip of the pen away from a row that does not follow.
#include "check/meaning/any_matrix.h"
#include "check/row/row.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "base/among.h"
#include "base/ascii.h"
#include "check/average/average_value.h"
#include "check/doubt/digits.h"
#include "check/doubt/equation_of_letters.h"
#include "check/doubt/special_definitions.h"
#include "check/law/from_laws.h"
#include "check/law/from_set.h"
#include "check/place/place.h"
#include "check/prose/other_case.h"
#include "check/prose/restrictions.h"
#include "check/prose/said_around.h"
#include "check/prose/subjects.h"
#include "check/question/decision_cache.h"
#include "check/repair/sides_near.h"
#include "check/repair/suspicion.h"
#include "check/row/given_values.h"
#include "check/scope/section_evidence.h"
#include "check/word/prose_words.h"
#include "elaborate/name/family.h"
#include "expr/tree/path.h"
#include "expr/tree/state.h"
#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

/// Laws of this section and those around it, but no conclusion that follows from nothing: that may be wrong
/// itself. What another section states makes nothing suspect: "The other end is now held by
/// a hinge."
Laws grounds_for_suspicion(const RowPlace& place, Laws laws) {
  const ProseBeside& here = beside(place);
  std::erase_if(laws, [&](const PageLaw* law) {
    return is_open(*law) || law->at_instant || law->proves_only ||
           !place.notes.prose.sections.reaches(law->place, here.place);
  });
  return laws;
}

Laws without_cases(Laws laws) {
  std::erase_if(laws, [](const PageLaw* law) { return law->of_a_case; });
  return laws;
}

/// "For a disc", "On the way down it is", "Then it runs": a sentence that may speak of something else than
/// the one before, and concludes nothing.
bool begins_with_a_subject(const RowPlace& place, const StepReading& row) {
  const std::string& lead = beside(place).lead;
  const std::string clause = lowered(lead.substr(lead.rfind('\n') + 1));
  if (row.which > 0 || is_announced(place, row)) return false;
  const std::vector<std::string_view> words = words_of(clause);
  const bool goes_on_in_time = words.size() > 2 &&
                               is_one_of(words[0], {"then", "now", "afterwards", "later"}) &&
                               is_one_of(words[1], {"it", "he", "she", "they", "the"});
  if (goes_on_in_time) return true;
  return !announces_a_conclusion(clause) && (begins_with_a_case(lead) || begins_a_case(clause));
}

/// Does it rest on definitions that are said for this place only, and not on one of its own chain?
bool rests_on_what_is_said_here(RowPlace& place, const StepReading& row,
                                const std::vector<std::string>& uses) {
  const Standpoint at = standpoint(place, row.parsed);
  const Span chain = row.parsed.written.span;
  const bool new_subject = begins_with_a_subject(place, row);
  return std::ranges::all_of(place.names.scope.definitions, [&](const NamedDefinition& named) {
    const bool used = std::ranges::find(uses, named.origin.text) != uses.end();
    if (!used || named.origin.directive) return true;
    const ExprNode& body = place.tree[named.definition.body];
    const bool own =
        body.span.file == chain.file && body.span.begin >= chain.begin && body.span.end <= chain.end;
    const bool condition = body.op == Op::symbol;  // `P_i = P_f`
    if (own || condition || !is_said_for(at, named.origin)) return false;
    return !new_subject || at.prose.beside[named.origin.event].argument == at.beside().argument;
  });
}

/// The names without definitions that are said for other places.
Names as_said_here(RowPlace& place, const StepReading& row) {
  const Standpoint at = standpoint(place, row.parsed);
  Names here = place.names;
  here.scope.definitions.erase_if([&](const NamedDefinition& named) {
    return !named.origin.directive &&
           (!is_said_for(at, named.origin) || is_case_of_another_paragraph(place.tree, at, named));
  });
  return here;
}

/// Of the law above, and not of another system or for a trial: "Its solution is", "so", or no words of its
/// own.
bool goes_on_to_a_solution(const RowPlace& place, const StepReading& row) {
  static constexpr auto trials =
      std::to_array<std::string_view>({"trial", "try", "ansatz", "guess", "look for", "form", "suppose",
                                       "wrong", "unphysical", "confuse", "other", "another", "which"});
  static constexpr auto solutions = std::to_array<std::string_view>({"solution", "solve", "integra"});
  const std::string& lead = beside(place).lead;
  const std::string clause = lowered(lead.substr(lead.rfind('\n') + 1));
  const auto says = [&](std::string_view words) { return clause.find(words) != std::string::npos; };
  if (std::ranges::any_of(trials, says)) return false;
  return row.which > 0 || says_that_it_follows(lead) || !has_own_words(clause) ||
         std::ranges::any_of(solutions, says);
}

/// What is also the right side of the link before it is less likely to hold the slip.
WrongStep as_wrong(const RowPlace& place, const StepReading& row) {
  return {.parsed = row.parsed,
          .which = row.which,
          .first_order = row.first_order,
          .left = row.which > 0 ? Trust::supported : Trust::unknown,
          .rules = rules_for_like(row.reading.how()),
          .near = sides_near(place.notes, row.parsed)};
}

bool speaks_of_averages(const ExprTree& tree, const Equation& claim) {
  return std::ranges::any_of(std::array{claim.left, claim.right}, [&](ExprId side) {
    return std::ranges::any_of(symbols_in(tree, side), [&](SymbolId each) { return is_average(tree, each); });
  });
}

/// `\sin x = A \; \csc x = B`: what stands between two equality signs can be the end of one equation and the
/// beginning of another.
bool may_be_two_equations(const StepReading& row) {
  const auto& sides = row.parsed.written.sides;
  for (std::size_t k = 1; k + 1 < sides.size(); ++k) {
    const bool spaced = std::ranges::any_of(sides[k].tokens, [](const Token& token) {
      return is_control_of(token, {";", " ", "quad", "qquad", "hspace"});
    });
    if (spaced && (k == row.which || k == row.which + 1)) return true;
  }
  return false;
}

/// `D(x - y) = D(y - x)` can say that the function D is even, and needs no sign then: not as a product.
bool may_hold_a_slip(const RowPlace& place, const StepReading& row) {
  return place.options.repairs != Repairs::none && !place.is_stated && row.role == Role::display &&
         !row.unsettled && row.recorded == nullptr && !is_alternative(place, row.parsed) &&
         !may_be_two_equations(row) && row.reading.how().open != OpenBracket::factor;
}

bool may_be_offered(const RowPlace& place, const StepReading& row) {
  const Span chain = row.parsed.written.span;
  const auto at = place.options.near_at;
  const bool elsewhere = at && (*at < chain.begin || chain.end <= *at);
  return !elsewhere && may_hold_a_slip(place, row);
}

/// The same place, with a tree that has grown.
RowPlace seen_in(const RowPlace& place, ExprTree& tree, Names names) {
  return {place.sources,    place.notes,   place.options, place.above,       tree,
          std::move(names), place.section, place.event,   place.heeds_words, place.is_stated};
}

/// In the row itself.
bool shows_digits(const ExprTree& tree, const Names& names, const Claim& claim) {
  if (const auto shown = number_shown(tree, names, claim)) return shown->digits > 1;
  return std::ranges::any_of(nodes_below(tree, {claim.equation.left, claim.equation.right}), [&](ExprId id) {
    return tree[id].op == Op::number && tree.digits(id).find('.') != std::string_view::npos;
  });
}

/// A row that shows a number, with what is rounded: its neighbours are asked for the digits as it was.
std::vector<TrueNeighbour> numbers_near(RowPlace& place, const StepReading& row) {
  constexpr std::uint64_t most_work = 1'000'000;
  DecisionCache& cache = *place.options.cache;
  const ShareOfWork share(cache, most_work);
  const Standpoint here = standpoint_of_proofs(place, row.parsed);
  const NeighbourProof agrees = [&](ExprTree& tree, const Names& names, const Claim& near,
                                    Slip) -> std::optional<std::vector<std::string>> {
    RowPlace there = seen_in(place, tree, names);
    Judgement judgement;
    judgement.verdict = Verdict::undecided;
    heed_digits(there, near, judgement);
    if (judgement.verdict == Verdict::proved) {
      judgement.uses = uses_of(tree, names, near);
    } else if (!agrees_with_values(there, row, near, judgement) &&
               !agrees_with_constants(there, row, near, judgement)) {
      return std::nullopt;
    }
    if (judgement.verdict != Verdict::proved) return std::nullopt;
    judgement = heed_cases(tree, names, near, std::move(judgement), here, &cache);
    if (judgement.verdict != Verdict::proved) return std::nullopt;
    return std::move(judgement.uses);
  };
  return true_neighbours(place.tree, place.names, as_wrong(place, row), agrees, &cache, {},
                         NotCompared::all_asked);
}

/// `unread`: the claim is that of a neighbour. `marks_only`: only what takes a dot, a prime or
/// the letter below one back counts.
std::vector<TrueNeighbour> near_as_read(RowPlace& place, const StepReading& row, const Claim& claim,
                                        bool unread, bool marks_only) {
  if (!marks_only && shows_digits(place.tree, place.names, claim)) {
    std::vector<TrueNeighbour> near = numbers_near(place, row);
    if (!near.empty()) return near;
  }
  DecisionCache& cache = *place.options.cache;
  const Grounds grounds = grounds_of(place, row, claim);
  Names names = place.names;
  for (const NamedAssumption& each : sizes_that_matter(place, row, claim)) assume(names.scope, each);
  const bool inferred = row.parsed.written.inference != Inference::none;
  const Standpoint here = standpoint_of_proofs(place, row.parsed);
  const NeighbourProof follows = [&](ExprTree& tree, const Names& read, const Claim& near,
                                     Slip slip) -> std::optional<std::vector<std::string>> {
    const bool of_a_letter = slip == Slip::rate || slip == Slip::prime || slip == Slip::letter;
    if (marks_only && !of_a_letter) return std::nullopt;
    Judgement found = judge(tree, read, near, limits_of_candidates, &cache);
    if (found.verdict != Verdict::proved || !found.diagnostics.empty()) {
      auto from_laws = follow_from_laws(tree, read, near, grounds.founded, inferred, cache);
      if (!from_laws || from_laws->verdict != Verdict::proved) return std::nullopt;
      found = *std::move(from_laws);
    }
    found = heed_cases(tree, read, near, std::move(found), here, &cache);
    if (found.verdict != Verdict::proved || differentiates_a_constant(tree, near.equation, found.uses))
      return std::nullopt;
    return std::move(found.uses);
  };
  const WrongStep wrong = as_wrong(place, row);
  const OpenRow open{.wrong = wrong,
                     .claim = claim,
                     .available = grounds.founded.all,
                     .to_be_solved = grounds.founded.all,
                     .unread = unread};
  return statements_near(place.tree, names, open, follows, cache);
}

bool has_marks(const ParsedChain& parsed) {
  return std::ranges::any_of(parsed.written.sides, [](const WrittenSide& side) {
    return std::ranges::any_of(side.tokens,
                               [](const Token& token) { return dots_of(token) > 0 || is_sign(token, "'"); });
  });
}

/// What the section shows without this row: a dot too many shows that a letter changes.
std::optional<Evidence> evidence_beside(const RowPlace& place, const ParsedChain& parsed) {
  const Evidence& all = *place.names.symbols.evidence;
  std::optional<std::size_t> heading;
  for (std::size_t k = place.event; k > 0 && !heading; --k) {
    if (std::holds_alternative<Heading>(place.notes.events[k - 1])) heading = k - 1;
  }
  Evidence others = evidence_of_section(place.sources, place.notes, heading, parsed.written.span);
  const bool same =
      others.changing == all.changing && others.may_change == all.may_change && others.primed == all.primed;
  return same ? std::nullopt : std::optional(std::move(others));
}

std::vector<TrueNeighbour> what_is_near(RowPlace& place, const StepReading& row, const Claim& claim,
                                        bool unread) {
  std::vector<TrueNeighbour> near = near_as_read(place, row, claim, unread, false);
  if (!near.empty() || !has_marks(row.parsed)) return near;
  if (auto others = evidence_beside(place, row.parsed)) {
    ExprTree tree = place.tree;
    RowPlace there = seen_in(place, tree, place.names);
    there.names.symbols.evidence = Shared(*std::move(others));
    near = near_as_read(there, row, claim, unread, true);
  }
  return near;
}

bool negates(const Repair& repair) {
  return repair.replacement == "-" + repair.replaced || repair.replaced == "-" + repair.replacement;
}

/// A suspect names what it is suspected to be first. Where that has another sign on one side, the same on the
/// other side says nothing new.
void add_others(std::vector<Repair>& repairs, std::vector<Repair> near) {
  for (Repair& each : near) {
    const bool known = std::ranges::find(repairs, each.statement, &Repair::statement) != repairs.end() ||
                       (negates(each) && negates(repairs.front()));
    if (!known && repairs.size() < most_repairs) repairs.push_back(std::move(each));
  }
}

/// The last of what is said of the row helps with it.
void name_nearest(const std::vector<Repair>& near, Diagnostics& said) {
  const auto shows_them = [](const Diagnostic& each) { return shows_repairs(each.kind); };
  if (near.empty() || said.empty() || std::ranges::any_of(said, shows_them)) return;
  const Repair& nearest = near.front();
  said.back().help.insert(
      said.back().help.begin(),
      fmt::format("one slip away, `{}` {}", nearest.statement,
                  nearest.uses.empty() ? std::string("holds")
                                       : fmt::format("follows from {}", fmt::join(nearest.uses, ", "))));
}

/// `- T\dot c` of `pV = cT`: nothing differentiates c, so nobody has left that out.
bool adds_a_new_rate(const RowPlace& place, const Repair& repair) {
  constexpr std::string_view dot = "\\dot";
  if (!repair.adds_a_term) return false;
  const std::string& text = repair.replacement;
  for (auto at = text.find(dot); at != std::string::npos; at = text.find(dot, at + 1)) {
    auto begin = text.find_first_not_of(" {", at + dot.size());
    if (begin == std::string::npos) break;
    std::size_t end = begin + 1;
    if (text[begin] == '\\') {
      while (end < text.size() && is_letter(text[end])) ++end;
    }
    const std::string letter = text.substr(begin, end - begin);
    const bool plain = is_letter(text[begin]) || letter.size() > 2;
    const bool face = letter == "\\mathbf" || letter == "\\vec" || letter == "\\hat" || letter == "\\bar" ||
                      letter == "\\boldsymbol" || letter == "\\bm" || letter == "\\mathrm";
    if (plain && !face && !is_changing(*place.names.symbols.evidence, letter)) return true;
  }
  return false;
}

/// `\nabla\cdot\mathbf r = 2` of "In the plane", in its sentence, its heading or a sentence above
bool counts_in_the_plane(const RowPlace& place, const StepReading& row) {
  const std::string text = written_at(place, row.parsed.written.span);
  const auto writes = [&](std::string_view sign) { return text.find(sign) != std::string::npos; };
  if (!writes("\\nabla") && !writes("\\delta") && !writes("\\partial") && !writes("\\operatorname"))
    return false;
  const auto speaks = [](std::string_view words) {
    const std::vector<std::string_view> all = words_of(words);
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (is_one_of(all[k], {"plane", "planar", "two-dimensional", "plane's"})) return true;
      if (k > 0 && all[k - 1] == "two" && is_one_of(all[k], {"dimensions", "dimension"})) return true;
    }
    return false;
  };
  const ProseBeside& here = beside(place);
  return speaks(lowered(place.section)) || speaks(here.lead) || speaks(here.tail) ||
         std::ranges::any_of(place.notes.prose.sentences, [&](const ProseSentence& each) {
           return each.number < here.sentence && place.notes.prose.sections.reaches(each.place, here.place) &&
                  speaks(each.text);
         });
}

/// "Here $\dot{\mathbf r}\times\mathbf p = 0$." above it may be what it follows from.
bool holds_with_lines(RowPlace& place, const StepReading& row, const Claim& claim) {
  Names names = place.names;
  bool any = false;
  for (const Fact& fact : standpoint(place, row.parsed).facts) {
    const bool line = std::ranges::any_of(place.notes.prose.said, [&](const SaidInLine& said) {
      return said.span.file == fact.span.file && said.span.begin == fact.span.begin && said.cue != Cue::apart;
    });
    if (!line || fact.elsewhere) continue;
    assume(names.scope, {fact.equation, Origin{fact.text, {}, std::nullopt}, 0, fact.at_instant});
    any = true;
  }
  return any && judge(place.tree, names, claim, limits_of_candidates, place.options.cache).verdict ==
                    Verdict::proved;
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

namespace {

/// "With a wall at $x = 0$ only odd states survive, so" `E_{n+1} - E_n = …`: members of another family.
bool may_be_of_another_family(const RowPlace& place, const Claim& claim) {
  static constexpr std::array<std::string_view, 14> another{"with", "for",  "in",      "if",  "when",
                                                            "a",    "an",   "only",    "but", "without",
                                                            "on",   "here", "instead", "even"};
  const std::string lead = lowered(beside(place).lead);
  const std::vector<std::string_view> words = words_of(std::string_view(lead).substr(lead.rfind('\n') + 1));
  if (words.empty() || !is_one_of(words.front(), another)) return false;
  return std::ranges::any_of(std::array{claim.equation.left, claim.equation.right}, [&](ExprId side) {
    return std::ranges::any_of(symbols_in(place.tree, side), [&](SymbolId each) {
      return membership_of(place.names, base_of(place.tree.symbols, each)).has_value();
    });
  });
}

/// "The hyperbolas have `dy/dx = x/y`" below `x^2 + y^2 = c^2`: who leads into a derivative by a letter with
/// words of its own may speak of another relation.
bool speaks_of_another_curve(const RowPlace& place, const StepReading& row, const Claim& claim) {
  const std::string& lead = beside(place).lead;
  if (is_announced(place, row) || !has_own_words(lead.substr(lead.rfind('\n') + 1))) return false;
  const std::array sides{claim.equation.left, claim.equation.right};
  return std::ranges::any_of(sides, [&](ExprId side) {
    return std::ranges::any_of(symbols_in(place.tree, side), [&](SymbolId each) {
      const auto& derivation = place.tree.symbols[each].derivation;
      return derivation && std::ranges::any_of(derivation->by, [&](const Variable& by) {
               return by.by == By::letter && !by.partial && !by.held &&
                      !is_along_path(place.tree.symbols, by);
             });
    });
  });
}

}  // namespace

namespace {

/// "Moving down, `N = mg - ma`" below `N = mg + ma` of one that moves up.
bool repeats_a_row(const RowPlace& place, const StepReading& row, const Repair& repair) {
  const std::string said = bare_formula(repair.statement);
  const auto is_it = [&](ExprId left, ExprId right) {
    const auto text = [&](ExprId side) { return bare_formula(written_at(place, place.tree[side].span)); };
    return said == text(left) + "=" + text(right) || said == text(right) + "=" + text(left);
  };
  return std::ranges::any_of(
             available_to(place, row.parsed),
             [&](const PageLaw* law) { return is_it(law->equation.left, law->equation.right); }) ||
         std::ranges::any_of(place.names.scope.definitions, [&](const NamedDefinition& named) {
           return said.ends_with("=" +
                                 bare_formula(written_at(place, place.tree[named.definition.body].span)));
         });
}

/// "It moves the other way. Hence": in its sentence or in the one before.
bool speaks_of_an_opposite(const RowPlace& place) {
  const std::size_t sentence = beside(place).sentence;
  return names_an_opposite_since(place.notes.prose, place.event, sentence > 1 ? sentence - 2 : 0);
}

/// A case can make `\frac{a - b}{a + b}` equal to -1, and `\frac{-a - b}{a + b}` always is.
bool simplifies_a_fraction(const ExprTree& tree, const Equation& claim) {
  const auto is_simple = [&](ExprId side) {
    return std::ranges::none_of(nodes_below(tree, {side}),
                                [&](ExprId id) { return tree[id].op == Op::divide; });
  };
  const auto divides_by_a_sum = [&](ExprId side) {
    return std::ranges::any_of(nodes_below(tree, {side}), [&](ExprId id) {
      return tree[id].op == Op::divide && tree[tree.children(id)[1]].op == Op::add;
    });
  };
  return (is_simple(claim.left) && divides_by_a_sum(claim.right)) ||
         (is_simple(claim.right) && divides_by_a_sum(claim.left));
}

/// Of states much is not said: only what their laws deny is taken for a slip.
bool is_open_row_of_states(RowPlace& place, const StepReading& row, const Claim& claim) {
  const bool states =
      holds_states(place.tree, claim.equation.left) || holds_states(place.tree, claim.equation.right);
  return states && !is_denied_by_laws(place.tree, place.names, claim, available_to(place, row.parsed),
                                      *place.options.cache);
}

void suspect(const Claim& claim, Repair repair, std::vector<std::string> uses, Judgement& judgement) {
  judgement.verdict = Verdict::suspect;
  judgement.route = "one slip of the pen away from what follows";
  judgement.uses = std::move(uses);
  judgement.counterexample.reset();
  judgement.sample.reset();
  judgement.diagnostics = {{DiagnosticKind::suspect,
                            claim.relation,
                            judgement.uses.empty()
                                ? fmt::format("it does not follow, but `{}` holds", repair.statement)
                                : fmt::format("it does not follow, but `{}` follows from {}",
                                              repair.statement, fmt::join(judgement.uses, ", ")),
                            {},
                            {"`rigor: law next` says that it is meant as it stands"}}};
  repair.uses = judgement.uses;
  judgement.repairs = {std::move(repair)};
}

/// Why no slip of the pen is suspected although what is near holds. `limited`: the row may be of a case.
bool is_explained_otherwise(RowPlace& place, const StepReading& row, const Claim& claim,
                            const Suspicion& found, bool limited) {
  if (!rests_on_what_is_said_here(place, row, found.uses)) return true;
  const bool identity = found.uses.empty();
  if (!identity && limited && repeats_a_row(place, row, found.repair)) return true;
  if (identity && simplifies_a_fraction(place.tree, claim.equation)) return true;
  if (found.slip == Slip::order && has_operators(place.tree, claim.equation.left) &&
      speaks_of_any_order(place.notes.prose, place.event, place.section))
    return true;
  return adds_a_new_rate(place, found.repair) || counts_in_the_plane(place, row) ||
         holds_with_lines(place, row, claim);
}

}  // namespace

bool is_suspect(RowPlace& place, const StepReading& row, const Claim& claim, Judgement& judgement) {
  if (is_open_row_of_states(place, row, claim)) return false;
  if (may_be_of_another_family(place, claim) || !may_hold_a_slip(place, row)) return false;
  const bool some_matrices = why_not_all_matrices(place.tree, place.names, claim.equation).has_value();
  if (some_matrices && !has_operators(place.tree, claim.equation.left)) return false;
  // "Solve `\ln x^2 = \ln x`": it says which values are meant.
  if (row.which == 0 && may_be_an_equation_of_letters(place.tree, claim.equation) &&
      asks_for_values(beside(place).lead))
    return false;
  if (speaks_of_another_curve(place, row, claim)) return false;
  const WrongStep wrong = as_wrong(place, row);
  const bool of_a_case = may_be_of_a_case(place, row.parsed);
  const bool limited = of_a_case && row.which == 0;
  const bool new_subject =
      begins_with_a_subject(place, row) || brings_in_a_subject(beside(place).lead) || is_an_example(place);
  const bool turns_around = row.which == 0 && speaks_of_an_opposite(place);
  const bool restricted =
      judgement.verdict == Verdict::undecided || some_matrices || turns_around || (limited && new_subject);
  const Laws here = grounds_for_suspicion(place, available_to(place, row.parsed));
  const bool solves = judgement.verdict != Verdict::undecided && goes_on_to_a_solution(place, row);
  const Laws to_be_solved = solves ? here : Laws{};
  const Laws grounds = restricted ? Laws{} : without_cases(here);
  const bool may_lack_a_term = is_announced(place, row) && !of_a_case;
  Names names = as_said_here(place, row);
  const Grounds above = grounds_of(place, row, claim);
  for (const PageLaw& law : *above.own) {
    if (law.by_convention && !law.proves_only)
      assume(names.scope, {law.equation, Origin{law.name, {}, std::nullopt}, 0});
  }
  for (const NamedAssumption& each : sizes_that_matter(place, row, claim)) assume(names.scope, each);
  auto found = suspicion(place.tree, names,
                         {wrong, claim, grounds, to_be_solved, may_lack_a_term, restricted, limited},
                         *place.options.cache);
  if (!found || is_explained_otherwise(place, row, claim, *found, limited)) return false;
  suspect(claim, std::move(found->repair), std::move(found->uses), judgement);
  return true;
}

namespace {

/// Where no word speaks of a case: of symmetric and commuting things both are true.
bool excludes_the_other_in_general(Slip slip) {
  static constexpr std::array slips{Slip::order, Slip::product, Slip::indices_swapped,
                                    Slip::letters_exchanged};
  return excludes_the_other(slip) || std::ranges::find(slips, slip) != slips.end();
}

bool rests_on_laws(const RowPlace& place, const StepReading& row, const std::vector<std::string>& uses) {
  return std::ranges::any_of(available_to(place, row.parsed),
                             [&](const PageLaw* law) { return is_one_of(law->name, uses); });
}

/// Does it rest on what another section says, on a conclusion of which no proof was found, or on what is said
/// of a case or a moment in another argument?
bool rests_on_other_ground(const RowPlace& place, const StepReading& row,
                           const std::vector<std::string>& uses) {
  const ProseBeside& here = beside(place);
  return std::ranges::any_of(available_to(place, row.parsed), [&](const PageLaw* law) {
    if (!is_one_of(law->name, uses)) return false;
    const bool of_another = (law->of_a_case || law->at_instant) && law->argument != here.argument;
    return of_another || is_open(*law) || law->proves_only ||
           !place.notes.prose.sections.reaches(law->place, here.place);
  });
}

/// "Hence `\tan\varphi = A/B`", where `\tan\varphi = B/A` follows from what stands above: a row that is
/// announced as a conclusion rests on the same ground. Or a row that holds for some values only, which words
/// may name: both hold only where something vanishes, and nobody writes it then.
bool is_meant_to_follow(RowPlace& place, const StepReading& row, const Claim& claim,
                        const Judgement& judgement, const TrueNeighbour& near) {
  if (judgement.verdict != Verdict::undecided || judgement.diagnostics.empty() || claim.nearly ||
      claim.equation.relation != Relation::equal || shows_digits(place.tree, place.names, claim))
    return false;
  if (chooses_a_root(near.slip, near.uses)) return false;
  const DiagnosticKind kind = judgement.diagnostics.back().kind;
  const bool excludes = excludes_the_other(near.slip);
  const bool concludes =
      kind == DiagnosticKind::follows_from_nothing && is_announced(place, row) &&
      (excludes || (excludes_the_other_in_general(near.slip) && !may_be_of_a_case(place, row.parsed)));
  const auto has_letters = [&](ExprId side) { return !symbols_in(place.tree, side).empty(); };
  const bool restricted = (kind == DiagnosticKind::restricted || kind == DiagnosticKind::borrowed) &&
                          has_letters(claim.equation.left) && has_letters(claim.equation.right);
  const bool of_operators =
      kind == DiagnosticKind::undecided && has_operators(place.tree, claim.equation.left);
  if (!concludes && !((restricted || of_operators) && excludes)) return false;
  if (may_be_of_another_family(place, claim) || speaks_of_another_curve(place, row, claim) ||
      (row.which == 0 && speaks_of_an_opposite(place)) || repeats_a_row(place, row, near.repair))
    return false;
  const bool says_what_it_is = place.tree[claim.equation.left].op == Op::symbol;
  if ((says_what_it_is || rests_on_laws(place, row, near.uses)) && !near.uses.empty() &&
      (begins_with_a_case(beside(place).lead) || brings_in_a_subject(beside(place).lead)))
    return false;
  if (near.uses.empty() &&
      (speaks_of_averages(place.tree, claim.equation) || simplifies_a_fraction(place.tree, claim.equation)))
    return false;
  return !rests_on_other_ground(place, row, near.uses) && rests_on_what_is_said_here(place, row, near.uses) &&
         !adds_a_new_rate(place, near.repair) && !counts_in_the_plane(place, row) &&
         !holds_with_lines(place, row, claim);
}

}  // namespace

bool is_told_what_is_near(const RowPlace& place, const StepReading& row, Verdict verdict) {
  const bool asks = verdict == Verdict::undecided || verdict == Verdict::suspect ||
                    (verdict == Verdict::law && place.options.repairs == Repairs::and_of_laws);
  return asks && may_be_offered(place, row);
}

void offer_what_is_near(RowPlace& place, const StepReading& row, const Claim& claim, Judgement& judgement) {
  if (judgement.restates || !is_told_what_is_near(place, row, judgement.verdict) ||
      is_open_row_of_states(place, row, claim))
    return;
  std::vector<TrueNeighbour> near = what_is_near(place, row, claim, false);
  const bool meant = !near.empty() && is_meant_to_follow(place, row, claim, judgement, near.front());
  if (meant) suspect(claim, near.front().repair, near.front().uses, judgement);
  std::vector<Repair> repairs = repairs_of(std::move(near));
  if (judgement.verdict == Verdict::suspect) return add_others(judgement.repairs, std::move(repairs));
  judgement.repairs = std::move(repairs);
  name_nearest(judgement.repairs, judgement.diagnostics);
}

void offer_what_is_near_unread(const RowPlace& place, const StepReading& row, Step& step) {
  const auto asks_something = [](const Diagnostic& each) { return each.kind == DiagnosticKind::hole; };
  if (!place.heeds_words || !may_be_offered(place, row) || place.options.cache->budget().exhausted() ||
      std::ranges::any_of(step.diagnostics, asks_something))
    return;
  ExprTree tree = place.tree;
  RowPlace there = seen_in(place, tree, place.names);
  auto claim = nearest_claim(tree, there.names, as_wrong(place, row));
  if (!claim) return;
  claim->reading = &row.reading.reading();
  step.repairs = repairs_of(what_is_near(there, row, *claim, true));
  name_nearest(step.repairs, step.diagnostics);
}

}  // namespace rigor
